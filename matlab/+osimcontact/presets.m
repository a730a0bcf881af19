function results = presets(varargin)
%PRESETS Lists presets, or shows one.
%   RESULTS = osimcontact.presets(NAME, NAME, VALUE, ...)
%
%   NAME: One preset (without it: list them all). Takes a text. May be left out.
%
%   Options, each a NAME and a VALUE (target_mass and TargetMass are the same):
%     presets: A file with presets of your own (TOML). Takes a text.
%     AsTable: true gives a table with a row for each result; the name of a list in the results, such as
%         'error', one with a row for each of its entries. Columns without any value are left out. In
%         GNU Octave, which has no tables, a struct of columns.
%
%   RESULTS: an array of structs with the fields name, source, mass_kg, spheres, radius_m, gravity_m_s2,
%   stiffness, dissipation, constant_contact_force, hertz_smoothing, hunt_crossley_smoothing,
%   dimensionless. docs/reference/json.md and schemas/ say what each holds; what is missing is NaN, ''
%   or empty.
%
%   Example, in the folder of the program's archive:
%       preset = osimcontact.presets('falisse2022');
%       preset.stiffness
%
%   See also osimcontact.sweep, osimcontact.inspect, osimcontact.check, osimcontact.drop_test,
%   osimcontact.motion, osimcontact.plot, osimcontact.reproduce, osimcontact.explain,
%   osimcontact.program.

% Made by dev/generate_matlab.py from the schemas of requests and results: change those, and run it.
    results = osimcontact.internal.run_verb('presets', varargin);
end
