function list = unify_fields(values)
%UNIFY_FIELDS A cell of structs as one struct array, in which all have the fields of all.
%   A field that a struct lacks is NaN, where the others have a number, '' for a text, and empty otherwise.

    values = values(:);
    names = cellfun(@fieldnames, values, 'UniformOutput', false);
    if isequal(names{1}, names{:})
        list = vertcat(values{:});
        return
    end
    names = unique(vertcat(names{:}), 'stable');
    for i = 1:numel(names)
        name = names{i};
        has_field = cellfun(@(value) isfield(value, name), values);
        example = values{find(has_field, 1)}.(name);
        if ischar(example)
            missing = '';
        elseif (isnumeric(example) || islogical(example)) && isscalar(example)
            missing = NaN;
        else
            missing = example([]);
        end
        for j = find(~has_field)'
            values{j}.(name) = missing;
        end
    end
    values = cellfun(@(value) orderfields(value, names), values, 'UniformOutput', false);
    list = vertcat(values{:});
end
