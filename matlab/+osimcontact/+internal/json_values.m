function [values, numbers] = json_values(lines)
%JSON_VALUES The value of each line of JSON as jsondecode gives it, but with the place in NUMBERS for every number.
%   complete_fields puts the numbers in. jsondecode itself changes the last bits of every fifth number in GNU Octave; sscanf
%   reads numbers exactly.

    values = cell(0, 1);
    numbers = zeros(0, 1);
    if isempty(lines)
        return
    end
    [text, numbers] = without_numbers(strjoin(lines, sprintf('\n')));
    % jsondecode would make scaleFile of 'scale file'.
    lines = strsplit(regexprep(text, '"(\w+) (\w+)":', '"$1_$2":'), sprintf('\n'));
    values = cell(numel(lines), 1);
    for i = 1:numel(lines)
        try
            values{i} = jsondecode(lines{i});
        catch problem
            refuse(lines{i}, problem.message);
        end
    end
end

function [text, numbers] = without_numbers(text)
    % Every number is replaced by its place among the numbers, with blanks before it, which JSON ignores there.
    width = 10;
    is_quote = text == '"';
    is_quote(regexp(text, '\\.') + 1) = false;
    % From + to 9 are the signs of a number, and the comma.
    is_sign = (text >= '+' & text <= '9' & text ~= ',') | text == 'e' | text == 'E';
    begins = find(is_sign & ~[false, is_sign(1:end - 1)]);
    ends = find(is_sign & ~[is_sign(2:end), false]);
    % Not in a text, and not the last letter of true and false.
    quotes = cumsum(is_quote);
    is_number = mod(quotes(begins), 2) == 0 & text(begins) ~= 'e' & text(begins) ~= 'E';
    begins = reshape(begins(is_number), 1, []);
    ends = reshape(ends(is_number), 1, []);

    is_part = zeros(1, numel(text) + 1, 'int8');
    is_part(begins) = 1;
    is_part(ends + 1) = is_part(ends + 1) - 1;
    is_part = cumsum(is_part(1:end - 1)) == 1;
    parts = text;
    parts(~is_part) = ' ';
    numbers = sscanf(parts(is_part | [false, is_part(1:end - 1)]), '%f');
    if numel(numbers) ~= numel(begins)
        refuse(text, 'a number is not as it should be');
    end
    steps = double(~is_part);
    steps(begins) = width;
    places = cumsum(steps);
    replaced = blanks(sum(steps));
    replaced(places(~is_part)) = text(~is_part);
    replaced(bsxfun(@plus, places(begins), (1 - width:0)')) = sprintf(sprintf('%%%dd', width), 1:numel(begins));
    text = replaced;
end

function refuse(text, problem)
    error('osimcontact:programFailed', 'what the program said is not JSON: %s: %s', problem, text(1:min(end, 200)));
end
