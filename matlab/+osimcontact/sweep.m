function results = sweep(varargin)
%SWEEP One file per point of a grid, or per step of a ladder, and a table that says what is in which.
%   RESULTS = osimcontact.sweep(MODEL, NAME, VALUE, ...)
%
%   MODEL: The model (.osim) whose variants are made. Takes a text.
%
%   Options, each a NAME and a VALUE (target_mass and TargetMass are the same):
%     grid: Values of a property (stiffness=1e5,1e6), factors (stiffness=x0.1,x1,x10), a logarithmic
%         range (stiffness=x0.1..x10/9), or values of indentation, restitution or target_mass. Takes a
%         struct or containers.Map, a text or a cell array of these.
%     ladder: N steps from a soft contact to indentation and restitution, to search for a gait step by
%         step. Takes a whole number.
%     soft: With ladder: dimensionless stiffness of the first step [default: 1.2]. Takes a number.
%     point: Only point N of the grid, or step N of the ladder, counted from 1, for job arrays. Takes a
%         whole number.
%     shard: Only share I of N of the points, for job arrays. Takes a text.
%     output_dir: Write the models into this folder [default: NAME.sweep beside the model]. Takes a
%         text.
%     force: Replace existing files. Takes true or false.
%     resume: Continue a sweep that was stopped or changed: make the models that are missing or out of
%         date, and leave edited ones. Takes true or false.
%     no_note: Leave no note (in the credits) in the models. Takes true or false.
%     dry_run: Write nothing, only show what would be made. Takes true or false.
%     jobs: Models to make at once [default: one per processor]. Takes a whole number.
%     radius: Sphere radius in metres (with models also keep or a factor like x1.5). Takes a number or a
%         text.
%     indentation: Relative indentation x/R under the load, 0 to 1 (11). Takes a number.
%     contact_stiffness: Stiffness of one sphere at that load, N/m (11 with B.2). Takes a number.
%     young: Young's modulus, N/m2 (A.1, A.5). Takes a number.
%     poisson: Poisson's ratio. Takes a number.
%     stiffness: OpenSim's stiffness (plane strain modulus of one surface), N/m2. Takes a number.
%     restitution: Coefficient of restitution, 0 to 1 (13). Takes a number.
%     impact_speed: Impact speed, m/s [default: sqrt(gR/2), a fall from a quarter of the radius]. Takes
%         a number.
%     constant_indentation: Constant indentation over radius, for constant_contact_force (C.2). Takes a
%         number.
%     state_width: Width of the contact transition over radius, for hertz_smoothing (C.8). Takes a
%         number.
%     speed_width: Width of the transition in speed, m/s, for hunt_crossley_smoothing (C.10). Takes a
%         number.
%     threshold: Threshold t that the widths refer to: from t to 1 - t [default: 0.05]. Takes a number.
%     load: Total load on all spheres, N. Takes a number.
%     body_weights: The load in body weights [default: 1 where a mass is known]. Takes a number.
%     gravity: Gravity, m/s2 [default: the model's, else 9.80665]. Takes a number.
%     contacts_mass: Mass the contacts are made for now, kg [default: the note, else mass]. Takes a
%         number.
%     mass: Mass of this model, kg [default: the sum of its bodies]. Takes a number.
%     exclude_body: Leave these bodies out of the sum (props, platforms). Takes a text or a cell array
%         of texts.
%     spheres: Spheres that share the body weight, all stance limbs together [default: as found per
%         limb]. Takes a whole number.
%     stance_limbs: Limbs that share the body weight [default: as the note in the model says, else 1].
%         Takes a whole number.
%     select: Only forces with such a name. Takes a text or a cell array of texts.
%     exclude: No forces with such a name. Takes a text or a cell array of texts.
%     skip_disabled: Leave out forces that are switched off. Takes true or false.
%     yes: Confirm what looks like a mistake: the code of the error that asks. Takes 'implausible-mass'
%         or 'mass-in-pounds' or 'against-note' or 'implausible-radius' or 'implausible-place' or
%         'implausible-scale' or 'tilted-foot' or 'unequal-feet' or 'wrong-afterwards' or 'many-models'
%         or 'poor-fit' or a cell array of these.
%     AsTable: true gives a table with a row for each result; the name of a list in the results, such as
%         'error', one with a row for each of its entries. Columns without any value are left out. In
%         GNU Octave, which has no tables, a struct of columns.
%
%   RESULTS: an array of structs with the fields model, manifest, folder, points, file, models,
%   done_before, failed. docs/reference/json.md and schemas/ say what each holds; what is missing is
%   NaN, '' or empty.
%
%   Example, in the folder of the program's archive:
%       grid = struct('stiffness', 'x0.1..x10/5', 'dissipation', [0.5 1 2]);
%       variants = osimcontact.sweep('fixtures/table1/human_62kg_smooth_sphere.osim', 'grid', grid, 'output_dir', 'variants');
%       variants.models
%
%   See also osimcontact.inspect, osimcontact.check, osimcontact.drop_test, osimcontact.motion,
%   osimcontact.plot, osimcontact.reproduce, osimcontact.presets, osimcontact.explain,
%   osimcontact.program.

% Made by dev/generate_matlab.py from the schemas of requests and results: change those, and run it.
    results = osimcontact.internal.run_verb('sweep', varargin);
end
