function results = table_of(results, shape, as_table)
%TABLE_OF Results as a table of MATLAB: a row for each, or for each entry of one of their lists, such as 'changes'.

    if exist('struct2table', 'file') ~= 2
        error('osimcontact:noTable', 'GNU Octave has no tables: without ''AsTable'' results are an array of structs');
    end
    if ischar(as_table) || isa(as_table, 'string')
        results = struct2table(osimcontact.internal.as_columns(results, shape, char(as_table)));
    elseif as_table
        results = struct2table(osimcontact.internal.as_columns(results, shape));
    end
end
