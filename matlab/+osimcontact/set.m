function results = set(varargin)
%SET Sets properties to a value, or multiplies them by a factor.
%   RESULTS = osimcontact.set(MODELS, NAME, VALUE, ...)
%
%   MODELS: Models (.osim), a ForceSet (.xml) with geometry, folders. Takes a text or a cell array of
%       texts.
%
%   Options, each a NAME and a VALUE (target_mass and TargetMass are the same):
%     set: Properties by OpenSim's names, each with its value, or with a factor such as "x2". Takes a
%         struct or containers.Map or a text.
%     level: Move spheres down until all spheres of a foot are as low as its lowest one, at the default
%         pose. Takes true or false.
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
%       factors = struct('stiffness', 'x2', 'dissipation', 1.5);
%       change = osimcontact.set('fixtures/table1/human_62kg_smooth_sphere.osim', 'set', factors, 'output', 'stiffer.osim');
%
%   See also osimcontact.rescale, osimcontact.transfer, osimcontact.add, osimcontact.remove,
%   osimcontact.convert, osimcontact.design, osimcontact.fit, osimcontact.note, osimcontact.batch,
%   osimcontact.program.

% Made by dev/generate_matlab.py from the schemas of requests and results: change those, and run it.
    results = osimcontact.internal.run_verb('set', varargin);
end
