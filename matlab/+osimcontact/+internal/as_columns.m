function columns = as_columns(results, shape, list)
%AS_COLUMNS A struct array as one struct of columns: struct2table makes a table of it, which can be written to a file.
%   Numbers are numbers, texts are cells. Objects inside are columns of their own: contacts_mass_kg.value is
%   contacts_mass_kg_value. A list becomes the number of its entries; a list of texts becomes one text. Columns without any
%   value are left out. SHAPE is that of the results: see shapes.m. With the name of a LIST, such as 'changes', the rows are its
%   entries in all results, after a column with the model of each. 'feet.spheres' is a list in the entries of a list: a column
%   'feet' has the names of these.

    columns = struct();
    rows = results(:);
    if nargin > 2
        if isfield(results, 'model')
            columns.model = reshape({results.model}, [], 1);
        end
        steps = strsplit(list, '.');
        whole_shape = shape;
        for i = 1:numel(steps)
            if ~isfield(shape, steps{i}) || ischar(shape.(steps{i}))
                error('osimcontact:usage', 'there is no list ''%s'' in these results, but: %s', list, strjoin(list_names(whole_shape, ''), ', '));
            end
            [columns, rows, shape] = entries(columns, rows, shape.(steps{i}), steps{i});
            if i < numel(steps) && ~isempty(first_text_field(shape)) && numel(rows) > 0
                columns.(steps{i}) = reshape({rows.(first_text_field(shape))}, [], 1);
            elseif i < numel(steps) && ~isempty(first_text_field(shape))
                columns.(steps{i}) = cell(0, 1);
            end
        end
        if is_series(shape)
            [columns, rows] = samples(columns, rows);
        end
    end
    columns = without_empty(add_columns(columns, '', rows, shape));
end

function columns = without_empty(columns)
    % A table without rows keeps its columns: which of them would have values is not known.
    for name = fieldnames(columns)'
        column = columns.(name{1});
        is_empty = iscell(column) && all(cellfun('isempty', column)) || isfloat(column) && all(isnan(column(:)));
        if is_empty && ~isempty(column) && numel(fieldnames(columns)) > 1
            columns = rmfield(columns, name{1});
        end
    end
end

function [columns, rows, shape] = entries(columns, rows, kind, name)
    % Of an object there is one in each row, of a list any number.
    if isstruct(kind)
        shape = kind;
        counts = ones(1, numel(rows));
        parts = {rows.(name)};
        parts(cellfun(@isempty, parts)) = {osimcontact.internal.complete_fields([], kind)};
    else
        shape = kind{1};
        parts = {rows.(name)};
        counts = cellfun(@numel, parts);
        parts = cellfun(@(part) part(:), parts(counts > 0), 'UniformOutput', false);
    end
    columns = repeat_rows(columns, counts);
    if isempty(parts)
        % With its fields also where there are none.
        rows = osimcontact.internal.complete_fields({}, {shape});
    elseif isstruct(kind)
        rows = osimcontact.internal.unify_fields(parts);
    else
        rows = vertcat(parts{:});
    end
end

function columns = repeat_rows(columns, counts)
    index = arrayfun(@(i) repmat(i, 1, counts(i)), 1:numel(counts), 'UniformOutput', false);
    index = [index{:}];
    for name = fieldnames(columns)'
        columns.(name{1}) = reshape(columns.(name{1})(index), [], 1);
    end
end

function is = is_series(shape)
    kinds = struct2cell(shape);
    is = ~isempty(kinds) && all(cellfun(@(kind) ischar(kind) && strcmp(kind, 'numbers'), kinds));
end

function [columns, rows] = samples(columns, rows)
    % Columns of numbers over time: a row for each time.
    names = fieldnames(rows);
    parts = cell(1, numel(rows));
    for i = 1:numel(rows)
        numbers = cellfun(@(name) num2cell(rows(i).(name)(:)), names', 'UniformOutput', false);
        parts{i} = cell2struct([numbers{:}], names, 2);
    end
    columns = repeat_rows(columns, cellfun(@numel, parts));
    rows = vertcat(parts{:});
end

function name = first_text_field(shape)
    % What an entry is called: the first text in it.
    names = fieldnames(shape);
    is_text = structfun(@(kind) ischar(kind) && strcmp(kind, 'text'), shape);
    name = '';
    if any(is_text)
        name = names{find(is_text, 1)};
    end
end

function lists = list_names(shape, prefix)
    lists = {};
    for name = fieldnames(shape)'
        kind = shape.(name{1});
        if iscell(kind)
            lists = [lists, {[prefix name{1}]}, list_names(kind{1}, [prefix name{1} '.'])]; %#ok<AGROW>
        elseif isstruct(kind)
            if is_series(kind)
                lists{end + 1} = [prefix name{1}]; %#ok<AGROW>
            end
            lists = [lists, list_names(kind, [prefix name{1} '.'])]; %#ok<AGROW>
        end
    end
end

function columns = add_columns(columns, prefix, rows, shape)
    for name = fieldnames(rows)'
        values = reshape({rows.(name{1})}, [], 1);
        column = [prefix name{1}];
        kind = 'any';
        if isfield(shape, name{1})
            kind = shape.(name{1});
        end
        if iscell(kind) && strcmp(name{1}, 'error')
            % Of a model that failed there is one.
            missing = osimcontact.internal.complete_fields([], kind{1});
            values(cellfun(@isempty, values)) = {missing};
            columns = add_columns(columns, [column '_'], vertcat(values{:}), kind{1});
        elseif iscell(kind)
            columns.(column) = cellfun(@numel, values);
        elseif isstruct(kind) && isempty(values)
            columns = add_columns(columns, [column '_'], repmat(osimcontact.internal.complete_fields([], kind), 0, 1), kind);
        elseif strcmp(kind, 'map') && isempty(values)
            % Which columns it has, its entries say.
            continue
        elseif isstruct(kind) || strcmp(kind, 'map')
            columns = add_columns(columns, [column '_'], osimcontact.internal.unify_fields(values), kind);
        else
            columns.(column) = plain_column(values, kind);
        end
    end
end

function column = plain_column(values, kind)
    counts = cellfun(@numel, values);
    is_number = cellfun(@(value) isnumeric(value) || islogical(value), values);
    if isempty(values) && any(strcmp(kind, {'number', 'truth'}))
        % A table without rows goes together with another that has some.
        column = zeros(0, 1);
    elseif isempty(values)
        column = values;
    elseif all(cellfun(@iscellstr, values))
        column = cellfun(@(texts) strjoin(texts(:)', '; '), values, 'UniformOutput', false);
    elseif all(is_number) && ~isempty(counts) && all(counts == counts(1))
        column = cellfun(@(value) reshape(double(value), 1, []), values, 'UniformOutput', false);
        column = vertcat(column{:});
    else
        column = values;
    end
end
