function results = reproduce(varargin)
%REPRODUCE Compares Table 1 of the paper with what its equations give, and draws its figures 4 and C.5.
%   RESULTS = osimcontact.reproduce(NAME, VALUE, ...)
%
%   Options, each a NAME and a VALUE (target_mass and TargetMass are the same):
%     output_dir: Write table1.csv, fig4.svg and fig-c5.svg into this folder. Takes a text.
%     force: Replace existing files. Takes true or false.
%     AsTable: true gives a table with a row for each result; the name of a list in the results, such as
%         'table1.values', one with a row for each of its entries. Columns without any value are left
%         out. In GNU Octave, which has no tables, a struct of columns.
%
%   RESULTS: an array of structs with the fields table1, numbers, within_last_digit, fig1.
%   docs/reference/json.md and schemas/ say what each holds; what is missing is NaN, '' or empty.
%
%   Example, in the folder of the program's archive:
%       paper = osimcontact.reproduce();
%       fprintf('%d of %d numbers agree\n', paper.within_last_digit, paper.numbers)
%
%   See also osimcontact.sweep, osimcontact.inspect, osimcontact.check, osimcontact.drop_test,
%   osimcontact.motion, osimcontact.plot, osimcontact.presets, osimcontact.explain, osimcontact.program.

% Made by dev/generate_matlab.py from the schemas of requests and results: change those, and run it.
    results = osimcontact.internal.run_verb('reproduce', varargin);
end
