function value = complete_fields(value, shape)
%COMPLETE_FIELDS A result with every field of its SHAPE: a missing value becomes NaN, '' or empty.
%   SHAPE is the name of a kind, a struct for an object, or a struct in a cell for a list of objects: see shapes.m.
%   So [results.mass_kg] has one number for each result: an empty one would move all that follow to another model.

    if isstruct(shape)
        value = object(value, shape);
    elseif iscell(shape)
        value = objects(value, shape{1});
    else
        value = plain(value, shape);
    end
end

function value = plain(value, kind)
    switch kind
        case {'number', 'truth'}
            if isempty(value)
                value = NaN;
            elseif iscell(value)
                value = numbers(value);
            end
        case 'text'
            if isempty(value)
                value = '';
            end
        case 'numbers'
            value = numbers(value);
        case 'rows'
            if ~isempty(value)
                rows = cellfun(@numbers, value, 'UniformOutput', false);
                value = [rows{:}]';
            end
        case 'texts'
            if isempty(value)
                value = cell(0, 1);
            end
            value(cellfun(@isempty, value)) = {''};
        case 'map'
            if isempty(value)
                value = struct();
            end
            for name = fieldnames(value)'
                if ~ischar(value.(name{1}))
                    value.(name{1}) = numbers(value.(name{1}));
                    if isempty(value.(name{1}))
                        value.(name{1}) = NaN;
                    end
                end
            end
        case 'any'
            % Of another kind in each result.
            if isempty(value)
                value = cell(0, 1);
            elseif iscell(value) && all(cellfun(@isstruct, value))
                value = osimcontact.internal.unify_fields(value);
            end
        otherwise
            error('osimcontact:programFailed', 'there is no kind ''%s''', kind);
    end
end

function value = numbers(value)
    if iscell(value)
        value(cellfun(@isempty, value)) = {NaN};
        value = reshape([value{:}], [], 1);
    elseif isempty(value)
        value = zeros(0, 1);
    end
end

function value = object(value, shape)
    names = fieldnames(shape);
    complete = struct();
    count = 0;
    for i = 1:numel(names)
        name = names{i};
        if isfield(value, name)
            count = count + 1;
            complete.(name) = osimcontact.internal.complete_fields(value.(name), shape.(name));
        else
            complete.(name) = osimcontact.internal.complete_fields([], shape.(name));
        end
    end
    % A program that is newer than this package may say more.
    if isstruct(value) && count < numel(fieldnames(value))
        for name = setdiff(fieldnames(value), names)'
            complete.(name{1}) = value.(name{1});
        end
    end
    value = complete;
end

function list = objects(values, shape)
    if isempty(values)
        list = repmat(object([], shape), 0, 1);
        return
    end
    values = cellfun(@(value) object(value, shape), values, 'UniformOutput', false);
    list = osimcontact.internal.unify_fields(values);
    for name = fieldnames(shape)'
        if strcmp(shape.(name{1}), 'map')
            % The parameters of a force of each class: all have the fields of all.
            maps = num2cell(osimcontact.internal.unify_fields({list.(name{1})}));
            [list.(name{1})] = maps{:};
        end
    end
end
