function columns = as_columns(results, shape, list)
%AS_COLUMNS A struct array as one struct of columns: struct2table makes a table of it, which can be written to a file.
%   Numbers are numbers, texts are cells. Objects inside are columns of their own: contacts_mass_kg.value is
%   contacts_mass_kg_value. A list becomes the number of its entries; a list of texts becomes one text. SHAPE is that of
%   the results: see shapes.m. With the name of a LIST, such as 'changes', the rows are its entries in all results, after a
%   column with the model of each.

    columns = struct();
    rows = results(:);
    if nargin > 2
        if ~isfield(shape, list) || ~iscell(shape.(list))
            lists = fieldnames(shape);
            lists = lists(structfun(@iscell, shape));
            error('osimcontact:usage', 'there is no list ''%s'' in these results, but: %s', list, strjoin(lists', ', '));
        end
        % In front, so that the entries have their fields also where there are none.
        parts = [{osimcontact.internal.completed({}, shape.(list))}, {results.(list)}];
        if isfield(results, 'model')
            models = arrayfun(@(result) repmat({result.model}, numel(result.(list)), 1), results(:)', 'UniformOutput', false);
            columns.model = vertcat(cell(0, 1), models{:});
        end
        rows = vertcat(parts{:});
        shape = shape.(list){1};
    end
    columns = with_columns(columns, '', rows, shape);
end

function columns = with_columns(columns, before, rows, shape)
    for name = fieldnames(rows)'
        values = reshape({rows.(name{1})}, [], 1);
        column = [before name{1}];
        kind = 'any';
        if isfield(shape, name{1})
            kind = shape.(name{1});
        end
        if iscell(kind) && strcmp(name{1}, 'error')
            % Of a model that failed there is one.
            missing = osimcontact.internal.completed([], kind{1});
            values(cellfun(@isempty, values)) = {missing};
            columns = with_columns(columns, [column '_'], vertcat(values{:}), kind{1});
        elseif iscell(kind)
            columns.(column) = cellfun(@numel, values);
        elseif isstruct(kind) && isempty(values)
            columns = with_columns(columns, [column '_'], repmat(osimcontact.internal.completed([], kind), 0, 1), kind);
        elseif strcmp(kind, 'map') && isempty(values)
            % Which columns it has, its entries say.
            continue
        elseif isstruct(kind) || strcmp(kind, 'map')
            columns = with_columns(columns, [column '_'], osimcontact.internal.same_fields(values), kind);
        else
            columns.(column) = plain_column(values);
        end
    end
end

function column = plain_column(values)
    counts = cellfun(@numel, values);
    is_number = cellfun(@(value) isnumeric(value) || islogical(value), values);
    if isempty(values)
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
