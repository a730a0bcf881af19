function models = read_models(file)
%READ_MODELS Read the table that 'osim-contact-scale inspect FOLDER --format csv > models.csv' writes.
%   models = READ_MODELS('models.csv') has a row for each contact sphere of each model. models.mass_kg is a column of
%   numbers (NaN where a value is not known), models.model_file a cell array of texts. docs/json.md says what each column is.
%
%   MATLAB's readtable does the same, and is what MATLAB takes. For GNU Octave 7 and later, which has none.

    if exist('readtable', 'file') == 2
        models = readtable(file, 'Delimiter', ',');
        return
    end
    lines = strsplit(fileread(file), sprintf('\n'));
    lines = lines(~cellfun(@isempty, lines));
    rows = cellfun(@cells_of, lines(2:end), 'UniformOutput', false);
    rows = vertcat(rows{:});
    names = cells_of(lines{1});
    models = struct();
    for i = 1:numel(names)
        texts = rows(:, i);
        numbers = str2double(texts);
        if any(isnan(numbers) & ~cellfun(@isempty, texts))
            models.(names{i}) = texts;
        else
            models.(names{i}) = numbers;
        end
    end
end

function cells = cells_of(line)
    % A comma between quotation marks is part of a name.
    cells = {};
    is_open = false;
    parts = strsplit(line, ',', 'CollapseDelimiters', false);
    for i = 1:numel(parts)
        if is_open
            cells{end} = [cells{end} ',' parts{i}];
        else
            cells{end + 1} = parts{i}; %#ok<AGROW>
        end
        is_open = mod(sum(cells{end} == '"'), 2) == 1;
    end
    cells = regexprep(cells, '^"(.*)"$', '$1');
    cells = strrep(cells, '""', '"');
end
