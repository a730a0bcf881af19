function results = note(varargin)
%NOTE Writes into models which mass their contacts were made for, or how many limbs share the weight; no number changes.
%   RESULTS = osimcontact.note(MODELS, NAME, VALUE, ...)
%
%   MODELS: Models (.osim), a ForceSet (.xml) with geometry, folders. Takes a text or a cell array of
%       texts.
%
%   Options, each a NAME and a VALUE (target_mass and TargetMass are the same):
%     contacts_mass: Mass the contacts in the file were made for, kg. Takes a number.
%     contacts_gravity: Gravity the contacts in the file were made for, m/s2 [default: the model's].
%         Takes a number.
%     stance_limbs: Limbs that share the body weight [default: as the note in the model says]. Takes a
%         whole number.
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
%       change = osimcontact.note('fixtures/table1/human_62kg_smooth_sphere.osim', 'contacts_mass', 62, 'output', 'noted.osim');
%
%   See also osimcontact.rescale, osimcontact.transfer, osimcontact.add, osimcontact.remove,
%   osimcontact.convert, osimcontact.design, osimcontact.set, osimcontact.fit, osimcontact.batch,
%   osimcontact.program.

% Made by dev/generate_matlab.py from the schemas of requests and results: change those, and run it.
    results = osimcontact.internal.run_verb('note', varargin);
end
