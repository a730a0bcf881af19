function text = json_text(value, name)
%JSON_TEXT A value as JSON, for a request. NAME is what it is called in errors.
%   Numbers are written with 17 digits, which give the same bits back; jsonencode rounds them in GNU Octave. JSON has no NaN
%   and no infinity: they are an error, osimcontact:usage, and never become null.

    refuse_missing(value, name);
    [value, problem] = osimcontact.internal.plain_value(value);
    if ~isempty(problem)
        refuse(name, problem);
    end
    if isa(value, 'containers.Map')
        text = object_text(value.keys(), value.values(), name);
    elseif isstruct(value) && isscalar(value)
        text = object_text(fieldnames(value), struct2cell(value), name);
    elseif isnumeric(value) && isempty(value)
        % What a look-up that found nothing gives: to ignore it would be to take another value.
        refuse(name, 'is empty: leave it out where nothing is known');
    elseif ischar(value) && (isrow(value) || isempty(value))
        text = quoted(value);
    elseif iscell(value)
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
        refuse(name, ['is a ' class(value) ' of ' osimcontact.internal.size_text(value) ', which no option takes']);
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
        texts{i} = osimcontact.internal.json_text(values{i}, name);
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

function refuse_missing(value, name)
    % A text that is missing would become '', and an undefined category the text <undefined>.
    if ~any(strcmp(class(value), {'missing', 'string', 'categorical', 'double', 'single'}))
        return
    end
    for i = 1:numel(value)
        if osimcontact.internal.is_missing(value(i))
            problem = 'is missing';
            if isfloat(value)
                problem = 'is NaN, which says that a value is missing';
            end
            if numel(value) > 1
                problem = sprintf('%s in entry %d', problem, i);
            end
            refuse(name, [problem ': where nothing is known, leave it out']);
        end
    end
end

function refuse(name, problem)
    error('osimcontact:usage', '''%s'' %s', name, problem);
end
