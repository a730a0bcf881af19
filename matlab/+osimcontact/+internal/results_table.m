function results = results_table(results, shape, as_table)
%RESULTS_TABLE Results as a table: a row for each, or for each entry of one of their lists, such as 'changes' or 'feet.spheres'.

    if ischar(as_table) || isa(as_table, 'string')
        results = osimcontact.internal.to_table(osimcontact.internal.as_columns(results, shape, char(as_table)));
    elseif ~islogical(as_table) || ~isscalar(as_table)
        error('osimcontact:usage', '''AsTable'' is of class %s, expected true, false or the name of a list', class(as_table));
    elseif as_table
        results = osimcontact.internal.to_table(osimcontact.internal.as_columns(results, shape));
    end
end
