function text = table_text(value, name)
%TABLE_TEXT A table as CSV, for the program. NAME is what the argument is called in errors.
%   VALUE is a table of MATLAB, a struct array with an element for each row, a struct of columns, or a cell array whose first
%   row has the names. Names of columns stay as they are. Names of rows are the column 'model' where there is none.
%   What is missing is an empty cell: whether one may be empty, the program knows, and says the row and the column.

    [names, cells] = table_cells(value, name);
    lines = cell(1, size(cells, 1) + 1);
    lines{1} = csv_line(names);
    for i = 1:size(cells, 1)
        texts = cell(1, numel(names));
        for j = 1:numel(names)
            [texts{j}, problem] = cell_text(cells{i, j});
            if ~isempty(problem)
                error('osimcontact:usage', '''%s'', row %d, column ''%s'' %s', name, i, names{j}, problem);
            end
        end
        lines{i + 1} = csv_line(texts);
    end
    text = strjoin(lines, '');
end

function [names, cells] = table_cells(value, name)
    if isa(value, 'table')
        names = reshape(value.Properties.VariableNames, 1, []);
        columns = cellfun(@(column) value.(column), names, 'UniformOutput', false);
        if ~isempty(value.Properties.RowNames) && ~any(strcmp(names, 'model'))
            names = [{'model'}, names];
            columns = [{value.Properties.RowNames}, columns];
        end
        cells = side_by_side(columns, names, name);
    elseif isstruct(value) && isscalar(value)
        names = fieldnames(value)';
        cells = side_by_side(struct2cell(value)', names, name);
    elseif isstruct(value)
        names = fieldnames(value)';
        cells = struct2cell(value(:))';
    else
        names = value(1, :);
        cells = value(2:end, :);
        for j = 1:numel(names)
            [names{j}, problem] = cell_text(names{j});
            if ~isempty(problem) || isempty(names{j})
                error('osimcontact:usage', ['''%s'' has no name for column %d: the first row of a cell array has the names ' ...
                    'of the columns'], name, j);
            end
        end
    end
end

function cells = side_by_side(columns, names, name)
    columns = cellfun(@(column) entries(column), columns, 'UniformOutput', false);
    counts = cellfun(@(column) size(column, 1), columns);
    widths = cellfun(@(column) size(column, 2), columns);
    odd = find(widths ~= 1 | counts ~= counts(1), 1);
    if ~isempty(odd)
        error('osimcontact:usage', '''%s'': column ''%s'' is %d x %d, expected %d x 1', name, names{odd}, counts(odd), widths(odd), ...
            counts(1));
    end
    cells = [columns{:}];
end

function list = entries(column)
    % num2cell knows numbers and texts only, in some releases.
    if ischar(column)
        list = cellstr(column);
    elseif iscell(column)
        list = column;
    else
        list = cell(size(column));
        for i = 1:numel(column)
            list{i} = column(i);
        end
    end
end

function [text, problem] = cell_text(value)
    text = '';
    problem = '';
    if isequal(size(value), [0 0]) || osimcontact.internal.is_missing(value)
        return
    end
    [value, problem] = osimcontact.internal.plain_value(value);
    if ~isempty(problem)
        return
    end
    if ischar(value) && isrow(value)
        text = value;
    elseif (isnumeric(value) || islogical(value)) && isscalar(value) && isreal(value)
        if islogical(value) || isfinite(value)
            text = osimcontact.internal.json_text(value, '');
        else
            text = num2str(value);
        end
    else
        problem = ['is a ' class(value) ' of ' osimcontact.internal.size_text(value) ', expected one number or one text'];
    end
end

function line = csv_line(texts)
    line = ['"' strjoin(strrep(texts, '"', '""'), '","') '"' sprintf('\n')];
end
