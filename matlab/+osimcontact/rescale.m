function results = rescale(varargin)
%RESCALE Rescales a model's own contacts to another mass.
%   RESULTS = osimcontact.rescale(MODELS, NAME, VALUE, ...)
%
%   MODELS: Models (.osim), a ForceSet (.xml) with geometry, folders. Takes a text or a cell array of
%       texts.
%
%   Options, each a NAME and a VALUE (target_mass and TargetMass are the same):
%     target_mass: Mass the contacts should be made for, kg. Takes a number.
%     contacts_mass: Mass the contacts are made for now, kg [default: the note, else mass]. Takes a
%         number.
%     mass: Mass of this model, kg [default: the sum of its bodies]. Takes a number.
%     exclude_body: Leave these bodies out of the sum (props, platforms). Takes a text or a cell array
%         of texts.
%     radius: Radii: isometric (R ~ M^1/3), keep, a radius in metres, or a factor like x1.5 [default:
%         isometric with target_mass, keep otherwise]. Takes a number or a text.
%     level: Keep the soles: where a radius changes, move the centre so that the lowest point of the
%         sphere stays. Takes true or false.
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
%     body_scale_file: ScaleSet that the Scale Tool applied: spheres follow their bodies. Takes a text.
%     follow_bodies: Spheres follow bodies scaled since the model's note was written. Takes true or
%         false.
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
%       change = osimcontact.rescale('fixtures/table1/human_62kg_smooth_sphere.osim', 'TargetMass', 500, 'output', 'giant.osim');
%       [change.changes.factor]
%
%   See also osimcontact.transfer, osimcontact.add, osimcontact.remove, osimcontact.convert,
%   osimcontact.design, osimcontact.set, osimcontact.fit, osimcontact.note, osimcontact.batch,
%   osimcontact.program.

% Made by dev/generate_matlab.py from the schemas of requests and results: change those, and run it.
    results = osimcontact.internal.run_verb('rescale', varargin);
end
