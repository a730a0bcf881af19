function results = explain(varargin)
%EXPLAIN Explains equations, quantities, and the codes of findings and errors.
%   RESULTS = osimcontact.explain(TOPICS, NAME, VALUE, ...)
%
%   TOPICS: Number of an equation (10, C.5), a word from the column "equation", a property or figure
%       (stiffness, x/R), or a code as printed after a finding. Takes a text or a cell array of texts.
%       May be left out.
%
%   Options, each a NAME and a VALUE (target_mass and TargetMass are the same):
%     AsTable: true gives a table with a row for each result; the name of a list in the results, such as
%         'formulas', one with a row for each of its entries. Columns without any value are left out. In
%         GNU Octave, which has no tables, a struct of columns.
%
%   RESULTS: an array of structs with the fields kind, label, title, formulas, symbols, source, used,
%   name, unit, equation, limit, what, trap, code, severity, checked, why, advice, fix, why_no_fix,
%   means, way_out. docs/reference/json.md and schemas/ say what each holds; what is missing is NaN, ''
%   or empty.
%
%   Example, in the folder of the program's archive:
%       topics = osimcontact.explain({'C.2', 'stiffness'});
%       topics(1).formulas.formula
%
%   See also osimcontact.sweep, osimcontact.inspect, osimcontact.check, osimcontact.drop_test,
%   osimcontact.motion, osimcontact.plot, osimcontact.reproduce, osimcontact.presets,
%   osimcontact.program.

% Made by dev/generate_matlab.py from the schemas of requests and results: change those, and run it.
    results = osimcontact.internal.run_verb('explain', varargin);
end
