function value = json_value(text)
%JSON_VALUE The value of a line of JSON: objects are structs, lists are cells, lists of numbers are columns, null is [].
%   jsondecode is not used: in GNU Octave it changes the last bits of every fifth number, and what it makes of a list
%   depends on what is in it. str2double and sscanf read numbers exactly.

    persistent pattern
    if isempty(pattern)
        number = '-?[0-9][-+.0-9eE]*';
        % A list of numbers alone is one token: long series are read at once. Commas and colons decide nothing.
        pattern = ['"(?:[^"\\]|\\.)*"|\[' number '(?:,' number ')*\]|' number '|true|false|null|[\[\]{}]'];
    end
    [tokens, begins] = regexp(text, pattern, 'match', 'start');
    % The end is a sign of its own, so that an answer that was cut off is seen.
    tokens{end + 1} = '.';
    [value, at] = parse(tokens, [text(begins) '.'], 1);
    if at ~= numel(tokens)
        refuse_incomplete(text);
    end
end

function [value, at] = parse(tokens, signs, at)
    token = tokens{at};
    sign = signs(at);
    at = at + 1;
    if sign == '"'
        value = unescape(token(2:end - 1));
    elseif sign == '{'
        value = struct();
        while signs(at) == '"'
            name = field_name(tokens{at}(2:end - 1));
            [value.(name), at] = parse(tokens, signs, at + 1);
        end
        if signs(at) ~= '}'
            refuse_incomplete([tokens{:}]);
        end
        at = at + 1;
    elseif sign == '['
        if numel(token) > 1
            value = sscanf(token(2:end - 1), '%f,');
            return
        end
        value = cell(0, 1);
        while signs(at) ~= ']'
            [value{end + 1, 1}, at] = parse(tokens, signs, at); %#ok<AGROW>
        end
        at = at + 1;
    elseif sign == 'n'
        value = [];
    elseif sign == 't'
        value = true;
    elseif sign == 'f'
        value = false;
    elseif any(sign == '-0123456789')
        value = sscanf(token, '%f');
    else
        refuse_incomplete([tokens{:}]);
    end
end

function refuse_incomplete(text)
    error('osimcontact:programFailed', 'what the program said is not JSON: %s', text(1:min(end, 200)));
end

function name = field_name(name)
    % Names such as 'scale file' are not names of fields.
    if isvarname(name)
        return
    end
    name = regexprep(name, '[^A-Za-z0-9_]', '_');
    if ~isvarname(name)
        name = ['x' name];
    end
end

function text = unescape(text)
    if ~any(text == '\')
        if isempty(text)
            text = '';
        end
        return
    end
    [escapes, between] = regexp(text, '(?:\\u[0-9a-fA-F]{4})+|\\.', 'match', 'split');
    plain = struct('b', 8, 'f', 12, 'n', 10, 'r', 13, 't', 9);
    for i = 1:numel(escapes)
        sign = escapes{i}(2);
        if sign == 'u'
            % Two of them are one letter beyond 16 bits, so those in a row are read together.
            codes = sscanf(strrep(escapes{i}, '\u', ' '), '%x')';
            bytes = uint8([floor(codes / 256); mod(codes, 256)]);
            escapes{i} = native2unicode(bytes(:)', 'UTF-16BE');
        elseif isfield(plain, sign)
            escapes{i} = char(plain.(sign));
        else
            escapes{i} = sign;
        end
    end
    parts = [between; [escapes, {''}]];
    text = [parts{:}];
end
