function text = json_text(value, name)
%JSON_TEXT A value as JSON, for a request. NAME is what it is called in errors.
%   Numbers are written with 17 digits, which give the same bits back; jsonencode rounds them in GNU Octave. JSON has no NaN
%   and no infinity: they are an error, osimcontact:usage, and never become null.

    if isa(value, 'containers.Map')
        text = object_text(value.keys(), value.values(), name);
    elseif isstruct(value) && isscalar(value)
        text = object_text(fieldnames(value), struct2cell(value), name);
    elseif isnumeric(value) && isempty(value)
        % What a look-up that found nothing gives: to ignore it would be to take another value.
        refuse(name, 'is empty: leave it out where nothing is known');
    elseif ischar(value) && (isrow(value) || isempty(value))
        text = quoted(value);
    elseif isa(value, 'string') && isscalar(value)
        if ismissing(value)
            refuse(name, 'is missing');
        end
        text = quoted(char(value));
    elseif iscell(value) || isa(value, 'string')
        text = list_text(value, name);
    elseif islogical(value) && isscalar(value)
        if value
            text = 'true';
        else
            text = 'false';
        end
    elseif isnumeric(value) && isscalar(value)
        text = number_text(value, name);
    elseif (isnumeric(value) || islogical(value)) && isvector(value)
        text = list_text(num2cell(value), name);
    else
        refuse(name, ['is a ' class(value) ' of ' strjoin(strsplit(num2str(size(value))), ' x ') ', which no option takes']);
    end
end

function text = number_text(value, name)
    if ~isreal(value) || ~isfinite(value)
        refuse(name, ['is ' num2str(value) ', expected a number']);
    end
    if isinteger(value)
        text = sprintf('%d', value);
    else
        text = sprintf('%.17g', double(value));
    end
end

function text = list_text(values, name)
    texts = cell(1, numel(values));
    for i = 1:numel(values)
        if iscell(values)
            texts{i} = osimcontact.internal.json_text(values{i}, name);
        else
            texts{i} = osimcontact.internal.json_text(values(i), name);
        end
    end
    text = ['[' strjoin(texts, ',') ']'];
end

function text = object_text(names, values, name)
    texts = cell(1, numel(names));
    for i = 1:numel(names)
        texts{i} = [quoted(names{i}) ':' osimcontact.internal.json_text(values{i}, [name '.' names{i}])];
    end
    text = ['{' strjoin(texts, ',') '}'];
end

function text = quoted(value)
    text = strrep(strrep(value, '\', '\\'), '"', '\"');
    for code = 0:31
        text = strrep(text, char(code), sprintf('\\u%04x', code));
    end
    text = ['"' text '"'];
end

function refuse(name, problem)
    error('osimcontact:usage', '''%s'' %s', name, problem);
end
