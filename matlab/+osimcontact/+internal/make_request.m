function [request, as_table] = make_request(declaration, arguments)
%MAKE_REQUEST The request that the arguments of a function mean: request.fields, and request.text, which is JSON.
%   request.typed has the names of options as they were typed.
%   A table among the arguments is request.input, as CSV: the program reads it from its standard input.

    % One argument more than pairs can have is one that comes before them.
    names = declaration.positional;
    count = declaration.required;
    if count < numel(names) && mod(numel(arguments) - count, 2) == 1
        count = count + 1;
    end
    if numel(arguments) < count || mod(numel(arguments) - count, 2) == 1
        error('osimcontact:usage', 'expected osimcontact.%s(%s): see help osimcontact.%s', declaration.name, ...
            strjoin([names(1:declaration.required), {'NAME, VALUE, ...'}], ', '), declaration.name);
    end

    fields = struct();
    input = '';
    as_table = false;
    typed = struct();
    for i = 1:count
        fields = add_field(fields, names{i}, arguments{i});
    end
    for i = count + 1:2:numel(arguments)
        name = arguments{i};
        if ~is_text(name)
            error('osimcontact:usage', 'argument %d of osimcontact.%s must be the name of an option, as text, but is of class %s', ...
                i, declaration.name, class(name));
        end
        name = field_name(char(name), declaration.options);
        if strcmp(name, 'as_table')
            if ~is_not_given(arguments{i + 1})
                as_table = arguments{i + 1};
            end
        elseif any(strcmp(name, declaration.left_out))
            error('osimcontact:usage', ['leave out ''%s'': it says how a terminal shows results, and here results are structs. ' ...
                'See help osimcontact.%s'], char(arguments{i}), declaration.name);
        else
            value = arguments{i + 1};
            if any(strcmp(name, declaration.flags))
                value = flag(value, char(arguments{i}));
            elseif strcmp(name, 'target_mass') && is_many(value)
                error('osimcontact:usage', ['''%s'' is one mass, not %d: osimcontact.batch takes a table with a model and a mass ' ...
                    'in each row'], char(arguments{i}), numel(value));
            end
            fields = add_field(fields, name, value);
            typed.(name) = char(arguments{i});
        end
    end

    if isfield(fields, declaration.table) && is_table(fields.(declaration.table))
        input = osimcontact.internal.table_text(fields.(declaration.table), declaration.table);
        fields.(declaration.table) = '-';
    end
    texts = {['"verb":' osimcontact.internal.json_text(declaration.verb, 'verb')]};
    if declaration.gives_json
        texts{end + 1} = '"format":"json"';
    end
    for name = fieldnames(fields)'
        spelled = name{1};
        if isfield(typed, spelled)
            spelled = typed.(spelled);
        end
        value = osimcontact.internal.json_text(fields.(name{1}), spelled);
        texts{end + 1} = [osimcontact.internal.json_text(name{1}, 'name') ':' value]; %#ok<AGROW>
    end
    request = struct('fields', fields, 'text', ['{' strjoin(texts, ',') '}'], 'input', input, 'typed', typed);
end

function value = flag(value, name)
    % 0 and 1, 'off' and 'on' are taken as by MATLAB's own functions.
    if (isnumeric(value) && isscalar(value) && any(value == [0 1])) || isa(value, 'matlab.lang.OnOffSwitchState')
        value = logical(value);
    elseif is_text(value) && any(strcmpi(char(value), {'on', 'off'}))
        value = strcmpi(char(value), 'on');
    elseif (isnumeric(value) && ~isempty(value)) || is_text(value)
        error('osimcontact:usage', '''%s'' is true or false', name);
    end
end

function fields = add_field(fields, name, value)
    if is_not_given(value)
        return
    end
    if isfield(fields, name)
        error('osimcontact:usage', '''%s'' was given twice', name);
    end
    if is_text(value) && strcmp(value, '-')
        error('osimcontact:usage', '''%s'' is ''-'', which means standard input or output: name a file instead', name);
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

function is = is_not_given(value)
    % [] and missing say that there is no value. A column or a row without entries is what a look-up gives that found nothing, and
    % NaN a calculation that failed: to pass over these would be to take another value.
    is = (isa(value, 'double') && isequal(size(value), [0 0])) ...
        || ((isa(value, 'missing') || isa(value, 'string')) && osimcontact.internal.is_missing(value));
end

function is = is_many(value)
    % A vector with NaN is refused for that.
    is = numel(value) > 1 && (iscell(value) || isa(value, 'string') || (isnumeric(value) && isvector(value) && all(isfinite(value))));
end

function is = is_table(value)
    % A cell with one text is the name of a file.
    is = isa(value, 'table') || isstruct(value) || (iscell(value) && size(value, 1) > 1);
end

function is = is_text(value)
    is = (ischar(value) && isrow(value)) || (isa(value, 'string') && isscalar(value));
end
