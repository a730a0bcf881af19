function result = to_table(columns)
%TO_TABLE A struct of columns as a table of MATLAB. GNU Octave has no tables: there it stays a struct of columns.
%   Both give a column as result.NAME, so that a script can be the same.

    result = columns;
    if exist('struct2table', 'file') == 2
        result = struct2table(columns);
    end
end
