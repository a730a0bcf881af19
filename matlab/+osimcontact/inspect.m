function results = inspect(varargin)
%INSPECT Shows what contacts models have.
%   RESULTS = osimcontact.inspect(MODELS, NAME, VALUE, ...)
%
%   MODELS: Models (.osim), a ForceSet (.xml) with geometry, folders. Takes a text or a cell array of
%       texts.
%
%   Options, each a NAME and a VALUE (target_mass and TargetMass are the same):
%     from: The generic model this one was scaled from: show each body's factors. Takes a text.
%     body_scale_file: With from: the ScaleSet that the Scale Tool applied. Takes a text.
%     target_mass: List what else changes with body size, for a body of this mass, kg: muscles, springs,
%         actuators. Takes a number.
%     report: Write a page for browsers too (.html): tables, plots, findings. Takes a text.
%     force: Replace an existing report. Takes true or false.
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
%         'spheres', one with a row for each of its entries. Columns without any value are left out. In
%         GNU Octave, which has no tables, a struct of columns.
%
%   RESULTS: an array of structs with the fields model, document_version, name, mass_kg, gravity_m_s2,
%   contacts_mass_kg, note, limbs, stance_limbs, spheres_per_limb, limbs_unknown, spheres, forces,
%   findings, bodies, body_factors, known_contacts, similarity, figures, standing, why_no_standing.
%   docs/reference/json.md and schemas/ say what each holds; what is missing is NaN, '' or empty.
%
%   Example, in the folder of the program's archive:
%       models = osimcontact.inspect('fixtures/table1');
%       [models.mass_kg]
%       models(1).forces(1).parameters.stiffness
%
%   See also osimcontact.sweep, osimcontact.check, osimcontact.drop_test, osimcontact.motion,
%   osimcontact.plot, osimcontact.reproduce, osimcontact.presets, osimcontact.explain,
%   osimcontact.program.

% Made by dev/generate_matlab.py from the schemas of requests and results: change those, and run it.
    results = osimcontact.internal.run_verb('inspect', varargin);
end
