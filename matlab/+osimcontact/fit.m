function results = fit(varargin)
%FIT Finds contact parameters from a measured indentation and force, or those of a model from recordings of its gait.
%   RESULTS = osimcontact.fit(FILE, NAME, VALUE, ...)
%
%   FILE: Measured indentation and force (.csv); with motion, the model (.osim). Takes the name of a
%       file, or a table, a struct array or a cell array.
%
%   Options, each a NAME and a VALUE (target_mass and TargetMass are the same):
%     motion: Fit the model to this motion (.mot, .sto), so that its forces are the measured ones, for
%         several trials. Takes a text or a cell array of texts.
%     plates: Ground reactions that force plates measured (.mot, .sto); one for each motion. Takes a
%         text or a cell array of texts.
%     loads: OpenSim's ExternalLoads (.xml); one for each motion, or one for all. Takes a text or a cell
%         array of texts.
%     fit: What to fit [default: stiffness, dissipation and height]. Takes 'stiffness' or 'dissipation'
%         or 'height' or a cell array of these.
%     unbounded: Let spheres go deeper than their radius. Takes true or false.
%     height_in: What a fitted height moves [default: 'floor']. Takes 'floor' or 'spheres'.
%     belt: Speed of a treadmill's belt towards -x, m/s; slip is relative to it. Takes a number.
%     belt_column: Speed of a treadmill's belt from this column of each motion. Takes a text.
%     start: Leave out what the motion has before this time, s. Takes a number.
%     end: Leave out what the motion has after this time, s. Takes a number.
%     angles: The unit of the motions' angles, where their headers do not say it. Takes 'degrees' or
%         'radians'.
%     low_pass: Smooth the coordinates first: zero-lag Butterworth filter of 4th order, cutoff in Hz (6
%         is usual for walking). Takes a number.
%     plates_delay: Delay of the plates, s: their data are moved earlier by this time. Takes a number.
%     radius: Sphere radius, m. Takes a number.
%     spheres: Spheres that share the measured force [default: 1]. Takes a whole number.
%     onset: Where contact begins, in metres, or fit to find it. Takes 'fit' or a number.
%     branch: Which part of the measurement [default: 'both']. Takes 'both' or 'loading' or 'unloading'.
%     indentation_column: Column of the indentation [default: 'indentation']. Takes a text.
%     force_column: Column of the force [default: 'force']. Takes a text.
%     speed_column: Column of the speed of indentation; without it and without a time, dissipation is
%         not fitted. Takes a text.
%     time_column: Column of the time, from which the speed is taken. Takes a text.
%     indentation_unit: Unit of the indentation [default: 'm']. Takes 'm' or 'mm' or 'um'.
%     force_unit: Unit of the force [default: 'N']. Takes 'N' or 'kN' or 'mN'.
%     speed_unit: Unit of the speed [default: 'm/s']. Takes 'm/s' or 'mm/s'.
%     time_unit: Unit of the time [default: 's']. Takes 's' or 'ms'.
%     contacts_mass: Mass the contacts are made for now, kg [default: the note, else mass]. Takes a
%         number.
%     mass: Mass of this model, kg [default: the sum of its bodies]. Takes a number.
%     exclude_body: Leave these bodies out of the sum (props, platforms). Takes a text or a cell array
%         of texts.
%     select: Only forces with such a name. Takes a text or a cell array of texts.
%     exclude: No forces with such a name. Takes a text or a cell array of texts.
%     skip_disabled: Leave out forces that are switched off. Takes true or false.
%     output: Write to this file [default: NAME.scaled.osim beside it]. Takes a text.
%     geometry_output: Write the changed ContactGeometrySet of a standalone ForceSet to this file. Takes
%         a text.
%     output_dir: Write into this folder. Takes a text.
%     in_place: Change the model itself and keep the old one as NAME.osim.bak. Takes true or false.
%     no_backup: With in_place: keep no backup. Takes true or false.
%     force: Replace existing files. Takes true or false.
%     no_note: Leave no note (in the credits) in the model. Takes true or false.
%     dry_run: Write nothing, only show what would change. Takes true or false.
%     report: Write a page for browsers too (.html): tables, plots, findings. Takes a text.
%     jobs: Models to work on at once [default: one per processor]. Takes a whole number.
%     summary: Keep a line per model in this file (.csv or .ndjson). Takes a text.
%     resume: Skip models that summary says are done, if nothing has changed since. Takes true or false.
%     shard: Only share I of N of the models, for job arrays. Takes a text.
%     yes: Confirm what looks like a mistake: the code of the error that asks. Takes 'implausible-mass'
%         or 'mass-in-pounds' or 'against-note' or 'implausible-radius' or 'implausible-place' or
%         'implausible-scale' or 'tilted-foot' or 'unequal-feet' or 'wrong-afterwards' or 'many-models'
%         or 'poor-fit' or a cell array of these.
%     geometry: The ContactGeometrySet (or model) that holds the spheres of a standalone ForceSet. Takes
%         a text.
%     model: The model a standalone ForceSet belongs to, for its masses and joints. Takes a text.
%     AsTable: true gives a table with a row for each result; the name of a list in the results, such as
%         'changes', one with a row for each of its entries. Columns without any value are left out. In
%         GNU Octave, which has no tables, a struct of columns.
%
%   RESULTS: an array of structs with the fields model, output, geometry_output, contacts_mass_kg,
%   target_mass_kg, objects, changes, fit_errors, floor_up_m, findings, remarks, credits.
%   docs/reference/json.md and schemas/ say what each holds; what is missing is NaN, '' or empty.
%
%   Example, in the folder of the program's archive:
%       fitted = osimcontact.fit('fixtures/measured/heel_pad.csv', 'radius', 0.03, 'indentation_unit', 'mm');
%       fitted.stiffness.value
%
%   See also osimcontact.rescale, osimcontact.transfer, osimcontact.add, osimcontact.remove,
%   osimcontact.convert, osimcontact.design, osimcontact.set, osimcontact.note, osimcontact.batch,
%   osimcontact.program.

% Made by dev/generate_matlab.py from the schemas of requests and results: change those, and run it.
    results = osimcontact.internal.run_verb('fit', varargin);
end
