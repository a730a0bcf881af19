function [request, as_table] = request_of(declared, arguments)
%REQUEST_OF The request that the arguments of a function mean: request.fields, and request.text, which is JSON.

    % One argument more than pairs can have is one that comes before them.
    names = declared.positional;
    count = declared.required;
    if count < numel(names) && mod(numel(arguments) - count, 2) == 1
        count = count + 1;
    end
    if numel(arguments) < count || mod(numel(arguments) - count, 2) == 1
        error('osimcontact:usage', 'expected osimcontact.%s(%s): see help osimcontact.%s', declared.name, ...
            strjoin([names(1:declared.required), {'NAME, VALUE, ...'}], ', '), declared.name);
    end

    fields = struct();
    as_table = false;
    for i = 1:count
        fields = with(fields, names{i}, arguments{i});
    end
    for i = count + 1:2:numel(arguments)
        name = arguments{i};
        if ~is_text(name)
            error('osimcontact:usage', 'argument %d of osimcontact.%s is not a name of an option, but of class %s', i, ...
                declared.name, class(name));
        end
        name = field_name(char(name), declared.options);
        if strcmp(name, 'as_table')
            as_table = arguments{i + 1};
        elseif any(strcmp(name, declared.left_out))
            error('osimcontact:usage', '''%s'' has no use here: results are structs. See help osimcontact.%s', ...
                char(arguments{i}), declared.name);
        else
            fields = with(fields, name, arguments{i + 1});
        end
    end

    texts = {['"verb":' osimcontact.internal.json_text(declared.verb, 'verb')]};
    if declared.gives_json
        texts{end + 1} = '"format":"json"';
    end
    for name = fieldnames(fields)'
        value = osimcontact.internal.json_text(fields.(name{1}), name{1});
        texts{end + 1} = [osimcontact.internal.json_text(name{1}, 'name') ':' value]; %#ok<AGROW>
    end
    request = struct('fields', fields, 'text', ['{' strjoin(texts, ',') '}']);
end

function fields = with(fields, name, value)
    if isfield(fields, name)
        error('osimcontact:usage', '''%s'' was given twice', name);
    end
    if is_text(value) && strcmp(value, '-')
        error('osimcontact:usage', '''%s'' is ''-'': standard input and output are not for MATLAB, name a file', name);
    end
    fields.(name) = value;
end

function name = field_name(name, options)
    % target_mass, TargetMass and targetmass are the same.
    same = strcmpi(strrep(options, '_', ''), strrep(name, '_', ''));
    if any(same)
        name = options{find(same, 1)};
        return
    end
    % The program knows what is nearest to it, and says so.
    name = lower(regexprep(name, '([a-z0-9])([A-Z])', '$1_$2'));
    if ~isvarname(name)
        error('osimcontact:usage', 'there is no option ''%s''', name);
    end
end

function is = is_text(value)
    is = (ischar(value) && isrow(value)) || (isa(value, 'string') && isscalar(value));
end
