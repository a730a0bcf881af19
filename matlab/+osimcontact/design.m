function results = design(varargin)
%DESIGN Finds parameters from what is wanted: indentation, stiffness, restitution.
%   RESULTS = osimcontact.design(MODELS, NAME, VALUE, ...)
%
%   MODELS: Models to write the design into; without one, a calculator. Takes a text or a cell array of
%       texts. May be left out.
%
%   Options, each a NAME and a VALUE (target_mass and TargetMass are the same):
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
%     dimensionless_stiffness: Dimensionless stiffness k R n/F under the load, 1.5 or more: x/R is 3/(2
%         K) (B.3). Takes a number.
%     stress: Mean stress on the contact patch under the load, N/m2: x/R is F/(n pi R^2 stress) (15).
%         Takes a number.
%     other_young: With young: Young's modulus of the other surface, N/m2 [default: rigid]. Takes a
%         number.
%     other_poisson: Poisson's ratio of the other surface. Takes a number.
%     state_smoothing: Hertz smoothing times radius, without unit, for hertz_smoothing (C.5). Takes a
%         number.
%     speed_smoothing: Hunt-Crossley smoothing times the root of the radius, s/m^(1/2), for
%         hunt_crossley_smoothing (C.10). Takes a number.
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
%       sheet = osimcontact.design('radius', 0.032, 'indentation', 0.16, 'mass', 62, 'spheres', 6);
%       for figure = sheet.figures', fprintf('%s: %g %s\n', figure.name, figure.value, figure.unit), end
%
%   See also osimcontact.rescale, osimcontact.transfer, osimcontact.add, osimcontact.remove,
%   osimcontact.convert, osimcontact.set, osimcontact.fit, osimcontact.note, osimcontact.batch,
%   osimcontact.program.

% Made by dev/generate_matlab.py from the schemas of requests and results: change those, and run it.
    results = osimcontact.internal.run_verb('design', varargin);
end
