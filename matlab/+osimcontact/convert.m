function results = convert(varargin)
%CONVERT Makes forces of one class from those of the other, one for each sphere, or connects sockets.
%   RESULTS = osimcontact.convert(MODELS, NAME, VALUE, ...)
%   Stiffness, dissipation, friction and transition velocity stay as they are.
%
%   MODELS: Models (.osim), folders. Takes a text or a cell array of texts.
%
%   Options, each a NAME and a VALUE (target_mass and TargetMass are the same):
%     to: The class that forces get. Takes 'smooth' or 'hunt-crossley'.
%     sockets: Write the paths of sockets that lead nowhere, where only one component has the name in
%         them. Takes true or false.
%     constant_contact_force: OpenSim's constant_contact_force of forces that had none [default: Falisse
%         et al. (2022) at each radius (C.2)]. Takes a number.
%     hertz_smoothing: hertz_smoothing of forces that had none, 1/m [default: Falisse et al. (2022) at
%         each radius (C.5)]. Takes a number.
%     hunt_crossley_smoothing: hunt_crossley_smoothing of forces that had none, s/m [default: Falisse et
%         al. (2022) at each radius (C.10)]. Takes a number.
%     strict: Refuse where sphere and half-space have parameters of their own that differ. Takes true or
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
%     AsTable: true gives a table with a row for each result; the name of a list in the results, such as
%         'changes', one with a row for each of its entries. Columns without any value are left out. In
%         GNU Octave, which has no tables, a struct of columns.
%
%   RESULTS: an array of structs with the fields model, output, geometry_output, contacts_mass_kg,
%   target_mass_kg, objects, changes, fit_errors, floor_up_m, findings, remarks, credits.
%   docs/reference/json.md and schemas/ say what each holds; what is missing is NaN, '' or empty.
%
%   Example, in the folder of the program's archive:
%       change = osimcontact.convert('fixtures/table1/human_62kg_smooth_sphere.osim', 'to', 'hunt-crossley', 'output', 'converted.osim');
%
%   See also osimcontact.rescale, osimcontact.transfer, osimcontact.add, osimcontact.remove,
%   osimcontact.design, osimcontact.set, osimcontact.fit, osimcontact.note, osimcontact.batch,
%   osimcontact.program.

% Made by dev/generate_matlab.py from the schemas of requests and results: change those, and run it.
    results = osimcontact.internal.run_verb('convert', varargin);
end
