function results = motion(varargin)
%MOTION Shows what contacts do along a recorded motion, beside what force plates measured.
%   RESULTS = osimcontact.motion(SUBJECT, MOTION, NAME, VALUE, ...)
%
%   SUBJECT: The model (.osim), or a ForceSet (.xml) with geometry and model. Takes a text.
%
%   MOTION: Its motion: coordinates over time (.mot or .sto), from inverse kinematics or a simulation.
%       Takes a text.
%
%   Options, each a NAME and a VALUE (target_mass and TargetMass are the same):
%     plates: Ground reactions that force plates measured (.mot or .sto). Takes a text.
%     loads: OpenSim's ExternalLoads (.xml): which columns of the plates act on which body. Takes a
%         text.
%     angles: The unit of the motion's angles, where its header does not say it. Takes 'degrees' or
%         'radians'.
%     low_pass: Smooth the coordinates first: zero-lag Butterworth filter of 4th order, cutoff in Hz (6
%         is usual for walking). Takes a number.
%     plates_delay: Delay of the plates, s: their data are moved earlier by this time. Takes a number.
%     belt: Speed of a treadmill's belt towards -x, m/s; slip is relative to it. Takes a number.
%     belt_column: Speed of a treadmill's belt from this column of the motion. Takes a text.
%     start: Leave out what the motion has before this time, s. Takes a number.
%     end: Leave out what the motion has after this time, s. Takes a number.
%     correct: Write the motion to this file (.sto, .mot) after the least correction that makes the
%         contacts give the forces of the plates. Takes a text.
%     vertical: With correct: only forces along the normal of the floor and their centres count. Takes
%         true or false.
%     floor: With correct: the floor is this much higher than in the model, m [default: it is found].
%         Takes a number.
%     moco: With correct: write what Moco needs to track the corrected motion and the plates into this
%         folder. Takes a text.
%     nmsm: With correct: write what NMSM's ground contact personalisation reads into this folder, not
%         corrected. Takes a text.
%     error: With correct: usual errors of the motion's places and angles, as in 6mm,2deg [default:
%         these]. The limits of the verdict grow with the first. Takes a text.
%     output: Write the model's ground reactions to this file (.sto), with its ExternalLoads beside it
%         (.xml). Takes a text.
%     force: Replace existing files. Takes true or false.
%     contacts_mass: Mass the contacts are made for now, kg [default: the note, else mass]. Takes a
%         number.
%     mass: Mass of this model, kg [default: the sum of its bodies]. Takes a number.
%     exclude_body: Leave these bodies out of the sum (props, platforms). Takes a text or a cell array
%         of texts.
%     select: Only forces with such a name. Takes a text or a cell array of texts.
%     exclude: No forces with such a name. Takes a text or a cell array of texts.
%     skip_disabled: Leave out forces that are switched off. Takes true or false.
%     geometry: The ContactGeometrySet (or model) that holds the spheres of a standalone ForceSet. Takes
%         a text.
%     model: The model a standalone ForceSet belongs to, for its masses and joints. Takes a text.
%     AsTable: true gives a table with a row for each result; the name of a list in the results, such as
%         'feet.spheres', one with a row for each of its entries. Columns without any value are left
%         out. In GNU Octave, which has no tables, a struct of columns.
%
%   RESULTS: an array of structs with the fields model, motion, frames, from_s, to_s, mass_kg,
%   gravity_m_s2, weight_n, stride_mean_n, measured_stride_mean_n, double_support, peak_n, comparison,
%   feet, consistency, remarks. docs/reference/json.md and schemas/ say what each holds; what is missing
%   is NaN, '' or empty.
%
%   Example, in the folder of the program's archive:
%       walk = osimcontact.motion('fixtures/motion/walker.osim', 'fixtures/motion/walk.mot');
%       fprintf('%.1f body weights\n', [walk.feet.peak_n] / walk.weight_n)
%
%   See also osimcontact.sweep, osimcontact.inspect, osimcontact.check, osimcontact.drop_test,
%   osimcontact.plot, osimcontact.reproduce, osimcontact.presets, osimcontact.explain,
%   osimcontact.program.

% Made by dev/generate_matlab.py from the schemas of requests and results: change those, and run it.
    results = osimcontact.internal.run_verb('motion', varargin);
end
