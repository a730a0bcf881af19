function results = check(varargin)
%CHECK Compares models with the limits of the paper and the traps of the format.
%   RESULTS = osimcontact.check(MODELS, NAME, VALUE, ...)
%
%   MODELS: Models (.osim), a ForceSet (.xml) with geometry, folders. Takes a text or a cell array of
%       texts.
%
%   Options, each a NAME and a VALUE (target_mass and TargetMass are the same):
%     from: The generic model this one was scaled from: whether its spheres followed, and what else
%         follows size. Takes a text.
%     body_scale_file: With from: the ScaleSet that the Scale Tool applied. Takes a text.
%     moco_setup: With from: list what else follows size in this Moco setup (.omoco), too. Takes a text.
%     from_moco_setup: With moco_setup: the Moco setup of the generic model, to compare with. Takes a
%         text.
%     motion: Say whether the contacts fit this motion (.mot, .sto), too. Takes a text.
%     plates: With motion: the ground reactions that force plates measured (.mot, .sto). Takes a text.
%     loads: With motion: OpenSim's ExternalLoads (.xml). Takes a text.
%     angles: With motion: the unit of its angles, where its header does not say it. Takes 'degrees' or
%         'radians'.
%     fix: Do what the printed commands do, and check the result: with output, output_dir or in_place.
%         Takes true or false.
%     output: Write to this file [default: NAME.scaled.osim beside it]. Takes a text.
%     output_dir: Write into this folder. Takes a text.
%     in_place: Change the model itself and keep the old one as NAME.osim.bak. Takes true or false.
%     report: Write a page for browsers too (.html): tables, plots, findings. Takes a text.
%     force: Replace existing files. Takes true or false.
%     spheres: Spheres that share the body weight, all stance limbs together [default: as found per
%         limb]. Takes a whole number.
%     stance_limbs: Limbs that share the body weight [default: as the note in the model says, else 1].
%         Takes a whole number.
%     impact_speed: Impact speed for the restitution, m/s [default: sqrt(gR/2), a fall from a quarter of
%         the radius]. Takes a number.
%     gravity: Gravity, m/s2 [default: the model's own]. Takes a number.
%     contacts_mass: Mass the contacts are made for now, kg [default: the note, else mass]. Takes a
%         number.
%     mass: Mass of this model, kg [default: the sum of its bodies]. Takes a number.
%     exclude_body: Leave these bodies out of the sum (props, platforms). Takes a text or a cell array
%         of texts.
%     select: Only forces with such a name. Takes a text or a cell array of texts.
%     exclude: No forces with such a name. Takes a text or a cell array of texts.
%     skip_disabled: Leave out forces that are switched off. Takes true or false.
%     geometry: The ContactGeometrySet (or model) that holds the spheres of a standalone ForceSet. Takes
%         a text.
%     model: The model a standalone ForceSet belongs to, for its masses and joints. Takes a text.
%     yes: Confirm what looks like a mistake: the code of the error that asks. Takes 'implausible-mass'
%         or 'mass-in-pounds' or 'against-note' or 'implausible-radius' or 'implausible-place' or
%         'implausible-scale' or 'tilted-foot' or 'unequal-feet' or 'wrong-afterwards' or 'many-models'
%         or 'poor-fit' or a cell array of these.
%     AsTable: true gives a table with a row for each result; the name of a list in the results, such as
%         'findings', one with a row for each of its entries. Columns without any value are left out. In
%         GNU Octave, which has no tables, a struct of columns.
%
%   RESULTS: an array of structs with the fields model, counts, verdicts, findings, commands,
%   similarity, consistency. docs/reference/json.md and schemas/ say what each holds; what is missing is
%   NaN, '' or empty.
%
%   Example, in the folder of the program's archive:
%       models = osimcontact.check('fixtures/table1');
%       for finding = models(1).findings', disp(finding.message), end
%
%   See also osimcontact.sweep, osimcontact.inspect, osimcontact.drop_test, osimcontact.motion,
%   osimcontact.plot, osimcontact.reproduce, osimcontact.presets, osimcontact.explain,
%   osimcontact.program.

% Made by dev/generate_matlab.py from the schemas of requests and results: change those, and run it.
    results = osimcontact.internal.run_verb('check', varargin);
end
