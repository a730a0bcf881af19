function results = batch(varargin)
%BATCH One row per model; columns are named like the long options of rescale, transfer, design and set.
%   RESULTS = osimcontact.batch(MANIFEST, NAME, VALUE, ...)
%
%   MANIFEST: A table (.csv, .xlsx): a column 'model', and one for each option that rows need. Takes the
%       name of a file, or a table, a struct array or a cell array.
%
%   Options, each a NAME and a VALUE (target_mass and TargetMass are the same):
%     output: Write to this file [default: NAME.scaled.osim beside it]. Takes a text.
%     geometry_output: Write the changed ContactGeometrySet of a standalone ForceSet to this file. Takes
%         a text.
%     output_dir: Write into this folder. Takes a text.
%     in_place: Change the model itself and keep the old one as NAME.osim.bak. Takes true or false.
%     no_backup: With in_place: keep no backup. Takes true or false.
%     force: Replace existing files. Takes true or false.
%     no_note: Leave no note (in the credits) in the model. Takes true or false.
%     allow_outside: Let rows name files to write outside the folder of the results, or of the table.
%         Takes true or false.
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
%       rows = {'model', 'target_mass'; 'fixtures/table1/human_62kg_smooth_sphere.osim', 500; 'fixtures/table1/emu_10_spheres_smooth_sphere.osim', 40};
%       change = osimcontact.batch(rows, 'output_dir', 'scaled');
%       {change.output}
%
%   See also osimcontact.rescale, osimcontact.transfer, osimcontact.add, osimcontact.remove,
%   osimcontact.convert, osimcontact.design, osimcontact.set, osimcontact.fit, osimcontact.note,
%   osimcontact.program.

% Made by dev/generate_matlab.py from the schemas of requests and results: change those, and run it.
    results = osimcontact.internal.run_verb('batch', varargin);
end
