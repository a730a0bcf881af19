function value = complete_fields(value, shape, numbers)
%COMPLETE_FIELDS A result with every field of its SHAPE: a missing value becomes NaN, '' or empty.
%   SHAPE is the name of a kind, a struct for an object, or a struct in a cell for a list of objects: see shapes.m. NUMBERS has
%   those of VALUE: see json_values.m. So [results.mass_kg] has one number for each result: an empty one would move all that
%   follow to another model.

    if nargin < 3
        numbers = [];
    end
    value = complete_values({value}, shape, numbers);
    value = value{1};
end

function values = complete_values(values, shape, numbers)
    % The same field of many objects at once: a call for each value took most of the time.
    if isstruct(shape)
        values = num2cell(objects(values, shape, numbers));
        return
    elseif iscell(shape)
        values = lists(values, shape{1}, numbers);
        return
    end
    is_missing = cellfun('isempty', values);
    switch shape
        case {'number', 'truth'}
            values = with_numbers(values, numbers);
            values(is_missing) = {NaN};
        case 'text'
            values(is_missing) = {''};
        case 'numbers'
            values = with_numbers(values, numbers);
            values(is_missing) = {zeros(0, 1)};
        case 'texts'
            values(is_missing) = {cell(0, 1)};
            for i = find(~is_missing)'
                if ~iscell(values{i})
                    % jsondecode makes numbers of null, where a list has nothing else.
                    values{i} = cell(size(values{i}));
                end
                values{i}(cellfun('isempty', values{i})) = {''};
            end
        case 'map'
            values(is_missing) = {struct()};
            names = cellfun(@fieldnames, values, 'UniformOutput', false);
            parts = cellfun(@struct2cell, values, 'UniformOutput', false);
            all_parts = with_numbers(vertcat(cell(0, 1), parts{:}), numbers);
            all_parts(cellfun('isempty', all_parts) & ~cellfun('isclass', all_parts, 'char')) = {NaN};
            parts = mat2cell(all_parts, cellfun('prodofsize', parts), 1);
            values = cellfun(@(part, name) cell2struct(part, name, 1), parts, names, 'UniformOutput', false);
        case 'any'
            % Of another kind in each result.
            values = with_numbers(values, numbers);
            values(is_missing) = {cell(0, 1)};
            for i = find(~is_missing & cellfun('isclass', values, 'cell'))'
                if all(cellfun('isclass', values{i}, 'struct'))
                    values{i} = osimcontact.internal.unify_fields(values{i});
                end
            end
        case {'rows', 'unknown'}
            values = with_numbers(values, numbers);
        otherwise
            error('osimcontact:programFailed', 'there is no kind ''%s''', shape);
    end
end

function values = with_numbers(values, numbers)
    % The numbers themselves for their places. null in a list of numbers is NaN already.
    is_number = cellfun('isclass', values, 'double');
    is_column = is_number & cellfun('size', values, 2) == 1;
    if any(is_column)
        places = vertcat(values{is_column});
        is_known = ~isnan(places);
        places(is_known) = numbers(places(is_known));
        values(is_column) = mat2cell(places, cellfun('prodofsize', values(is_column)), 1);
    end
    for i = find(~is_column & ~cellfun('isempty', values) & (is_number | cellfun('isclass', values, 'cell') | cellfun('isclass', values, 'struct')))'
        value = values{i};
        if isnumeric(value)
            column = with_numbers({value(:)}, numbers);
            values{i} = reshape(column{1}, size(value));
        elseif iscell(value)
            values{i} = with_numbers(value(:), numbers);
        else
            parts = struct2cell(value(:));
            parts(:) = with_numbers(parts(:), numbers);
            values{i} = cell2struct(parts, fieldnames(value), 1);
        end
    end
end

function values = lists(values, shape, numbers)
    % jsondecode makes a struct array of objects with the same fields, and a cell of others.
    values = cellfun(@(list) list(:), values, 'UniformOutput', false);
    parts = values(~cellfun('isempty', values));
    is_cell = cellfun('isclass', parts, 'cell');
    if any(is_cell)
        parts(~is_cell) = num2cell(parts(~is_cell));
        parts = vertcat(parts{:});
    end
    list = objects(parts, shape, numbers);
    values = mat2cell(list, cellfun('prodofsize', values), 1);
    for name = fieldnames(shape)'
        if strcmp(shape.(name{1}), 'map')
            % The parameters of a force of each class: all have the fields of all.
            for i = find(~cellfun('isempty', values))'
                list = values{i};
                maps = num2cell(osimcontact.internal.unify_fields({list.(name{1})}));
                [list.(name{1})] = maps{:};
                values{i} = list;
            end
        end
    end
end

function list = objects(parts, shape, numbers)
    % PARTS are struct arrays; an empty one is a missing object.
    is_missing = cellfun('isempty', parts);
    ends = cumsum(max(1, cellfun('prodofsize', parts)));
    is_row = true(max([0; ends]), 1);
    is_row(ends(is_missing)) = false;
    rows = find(is_row);
    parts = parts(~is_missing);
    if numel(parts) > 1
        try
            parts = {vertcat(parts{:})};
        catch
            % Not all have the same fields.
        end
    end
    own = cellfun(@fieldnames, parts, 'UniformOutput', false);
    names = fieldnames(shape);
    all_names = unique(vertcat(names, own{:}), 'stable');
    values = cell(numel(is_row), numel(all_names));
    count = 0;
    for i = 1:numel(parts)
        if i == 1 || ~isequal(own{i}, own{i - 1})
            [~, columns] = ismember(own{i}, all_names);
        end
        values(rows(count + (1:numel(parts{i}))), columns) = struct2cell(parts{i}(:))';
        count = count + numel(parts{i});
    end
    for i = 1:numel(names)
        values(:, i) = complete_values(values(:, i), shape.(names{i}), numbers);
    end
    for i = numel(names) + 1:numel(all_names)
        % A program that is newer than this package may say more.
        values(:, i) = complete_values(values(:, i), guessed_kind(values(:, i)), numbers);
    end
    list = cell2struct(values, all_names, 2);
end

function kind = guessed_kind(values)
    kind = 'unknown';
    known = values(~cellfun('isempty', values));
    if ~isempty(known) && all(cellfun('isclass', known, 'char'))
        kind = 'text';
    elseif ~isempty(known) && all(cellfun('prodofsize', known) == 1) && all(cellfun('isclass', known, 'double') | cellfun('isclass', known, 'logical'))
        kind = 'number';
    end
end
