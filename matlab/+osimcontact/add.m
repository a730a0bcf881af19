function results = add(varargin)
%ADD Gives a model that has no foot contacts those of another model or of a preset, of a table, or spheres under its bones.
%   RESULTS = osimcontact.add(MODELS, NAME, VALUE, ...)
%
%   MODELS: Models (.osim), folders. Takes a text or a cell array of texts.
%
%   Options, each a NAME and a VALUE (target_mass and TargetMass are the same):
%     from: Where the contacts come from: a model, or a preset with places: falisse2022, dhondt2024,
%         moco-2d-gait. Takes a text.
%     contacts: Where the spheres are: a table with name, body, x, y, z [m, in the body's frame] and
%         perhaps radius, or MuSkeMo's export. Takes the name of a file, or a table, a struct array or a
%         cell array.
%     default_pose: Take places that the table has in ground only as those of the default pose. Takes
%         true or false.
%     feet: Lay spheres under the meshes of these bodies, which touch the ground, separated by commas.
%         Takes a text or a cell array of texts.
%     count: Spheres under each foot. Takes a whole number.
%     pad: How far below the lowest bone point the sole is, m: bones have no skin. Takes a number.
%     geometry_dir: A folder with the bones' meshes, beside that of the model and its Geometry. Takes a
%         text.
%     mirror: If the reference has one side only: make the other side, too, mirrored in this axis. Takes
%         'z'.
%     class: Class of the new forces [default: the reference's]. Takes 'smooth' or 'hunt-crossley'.
%     friction: Scale transition_velocity and viscous_friction of the reference too (an extension of the
%         paper). Takes true or false.
%     radius: Radii: isometric (R ~ M^1/3), follow (with the factors of the bodies), or a radius in
%         metres [default: 'isometric']. Takes a number or a text.
%     body_scale: Factors of a body against the reference's. Takes a struct or containers.Map, a text or
%         a cell array of these.
%     body_map: A body of the reference, and the one that takes its spheres here. Takes a text or a cell
%         array of texts.
%     level: Move spheres down until all spheres of a foot are as low as its lowest one, at the default
%         pose. Takes true or false.
%     replace: Take the model's own foot contacts out first. Takes true or false.
%     select: Only forces with such a name. Takes a text or a cell array of texts.
%     exclude: No forces with such a name. Takes a text or a cell array of texts.
%     skip_disabled: Leave out forces that are switched off. Takes true or false.
%     indentation: Relative indentation x/R under the load, 0 to 1 (11). Takes a number.
%     young: Young's modulus, N/m2 (A.1, A.5). Takes a number.
%     poisson: Poisson's ratio. Takes a number.
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
%     static_friction: Static friction of the new forces [default: the reference's, else OpenSim's].
%         Takes a number.
%     dynamic_friction: Their dynamic friction [default: the reference's, else OpenSim's]. Takes a
%         number.
%     viscous_friction: Their viscous friction, s/m [default: the reference's, else OpenSim's]. Takes a
%         number.
%     transition_velocity: Their transition velocity, m/s [default: the reference's, else OpenSim's].
%         Takes a number.
%     load: Total load on all spheres, N. Takes a number.
%     body_weights: The load in body weights [default: 1 where a mass is known]. Takes a number.
%     gravity: Gravity, m/s2 [default: the model's, else 9.80665]. Takes a number.
%     spheres: Spheres that share the body weight, all stance limbs together [default: as found per
%         limb]. Takes a whole number.
%     stance_limbs: Limbs that share the body weight [default: as the note in the model says, else 1].
%         Takes a whole number.
%     reference_mass: Mass its contacts are made for, kg [default: its note, else its bodies]. Takes a
%         number.
%     reference_spheres: Its spheres that share the body weight [default: as found per limb]. Takes a
%         whole number.
%     reference_gravity: Its gravity, m/s2 [default: its note's, else its own]: if given, contacts are
%         scaled from it to target_gravity. Takes a number.
%     reference_select: Only its forces with such a name. Takes a text or a cell array of texts.
%     reference_sphere: Take contact and isometric radius of this sphere for all. Takes a text.
%     contacts_mass: Mass the contacts are made for now, kg [default: the note, else mass]. Takes a
%         number.
%     mass: Mass of this model, kg [default: the sum of its bodies]. Takes a number.
%     exclude_body: Leave these bodies out of the sum (props, platforms). Takes a text or a cell array
%         of texts.
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
%     AsTable: true gives a table with a row for each result; the name of a list in the results, such as
%         'changes', one with a row for each of its entries. Columns without any value are left out. In
%         GNU Octave, which has no tables, a struct of columns.
%
%   RESULTS: an array of structs with the fields model, output, geometry_output, contacts_mass_kg,
%   target_mass_kg, objects, changes, fit_errors, floor_up_m, findings, remarks, credits.
%   docs/reference/json.md and schemas/ say what each holds; what is missing is NaN, '' or empty.
%
%   Example, in the folder of the program's archive:
%       change = osimcontact.add('fixtures/feet/human_40000.osim', 'from', 'fixtures/table1/human_62kg_smooth_sphere.osim', 'output', 'with contacts.osim');
%       {change.objects.name}
%
%   See also osimcontact.rescale, osimcontact.transfer, osimcontact.remove, osimcontact.convert,
%   osimcontact.design, osimcontact.set, osimcontact.fit, osimcontact.note, osimcontact.batch,
%   osimcontact.program.

% Made by dev/generate_matlab.py from the schemas of requests and results: change those, and run it.
    results = osimcontact.internal.run_verb('add', varargin);
end
