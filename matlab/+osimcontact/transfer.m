function results = transfer(varargin)
%TRANSFER Gives a model the contacts of another model or of a preset, at its own size.
%   RESULTS = osimcontact.transfer(MODELS, NAME, VALUE, ...)
%
%   MODELS: Models (.osim), a ForceSet (.xml) with geometry, folders. Takes a text or a cell array of
%       texts.
%
%   Options, each a NAME and a VALUE (target_mass and TargetMass are the same):
%     from: Where the contacts come from: a model, or a preset such as falisse2022. Takes a text. Must
%         be given.
%     presets: A file with presets of your own (TOML). Takes a text.
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
%     follow_bodies: Spheres take place and size from their bodies, which OpenSim has scaled. Takes true
%         or false.
%     body_scale_file: The ScaleSet that the Scale Tool applied (its output_scale_file). Takes a text.
%     body_scale: Factors of a body. Takes a struct or containers.Map, a text or a cell array of these.
%     radius_axis: How the radius of a sphere follows from the three factors of its body [default:
%         geomean, where radii follow]. Takes 'x' or 'y' or 'z' or 'geomean' or 'min' or 'max'.
%     moved_spheres: Spheres that were moved or resized already: keep them, or place them again. Takes
%         'keep' or 'replace'.
%     strict: Refuse where spheres of one force follow bodies with different factors. Takes true or
%         false.
%     rule: The paper's scaling, or PredSim's (stiffness by mass/height^2, dissipation by 1/height)
%         [default: 'paper']. Takes 'paper' or 'predsim'.
%     height_ratio: Height of this model over that of the reference [default: mean of the body factors].
%         Takes a number.
%     contacts_mass: Mass the contacts are made for now, kg [default: the note, else mass]. Takes a
%         number.
%     mass: Mass of this model, kg [default: the sum of its bodies]. Takes a number.
%     exclude_body: Leave these bodies out of the sum (props, platforms). Takes a text or a cell array
%         of texts.
%     radius: Radii: keep, isometric (as the reference's, in proportion to M^(1/3)), follow (with the
%         factors of bodies, by radius_axis), a radius in metres, or a factor like x1.5 [default: keep;
%         isometric with follow_bodies]. Takes a number or a text.
%     level: Keep the soles: where a radius changes, move the centre so that the lowest point of the
%         sphere stays (with follow_bodies: on the scaled sole). Takes true or false.
%     level_axis: The axis of the spheres' frames that points up with the foot flat [default: nearest to
%         -gravity]. Takes 'x' or 'y' or 'z' or '-x' or '-y' or '-z'.
%     only: Only these properties, separated by commas (OpenSim's names, and radius). Takes a text or a
%         cell array of texts.
%     keep: Everything but these properties. Takes a text or a cell array of texts.
%     dissipation_by: What dissipation follows (14): R^-1/2 or M^-1/6 [default: 'radius']. Takes
%         'radius' or 'mass'.
%     friction: Scale transition_velocity and viscous_friction too (an extension of the paper). Takes
%         true or false.
%     contacts_gravity: Gravity the contacts are made for now, m/s2 [default: the note's, else the
%         model's]. Takes a number.
%     target_gravity: Scale to this gravity too, m/s2 (an extension of the paper) [default with
%         reference_gravity: the model's]. Takes a number.
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
%       change = osimcontact.transfer('fixtures/table1/emu_10_spheres_smooth_sphere.osim', 'from', 'falisse2022', 'output', 'emu as human.osim');
%
%   See also osimcontact.rescale, osimcontact.add, osimcontact.remove, osimcontact.convert,
%   osimcontact.design, osimcontact.set, osimcontact.fit, osimcontact.note, osimcontact.batch,
%   osimcontact.program.

% Made by dev/generate_matlab.py from the schemas of requests and results: change those, and run it.
    results = osimcontact.internal.run_verb('transfer', varargin);
end
