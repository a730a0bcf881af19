function columns = read_table(file, varargin)
%READ_TABLE Read a table (CSV) that the program wrote, as a struct of columns.
%   COLUMNS = osimcontact.read_table(FILE) has a field for each column of the file: a column of numbers, with NaN where a cell
%   is empty, or, where one cell is not a number, a cell array of texts. A decimal comma makes no number. For the tables of
%   'inspect --format csv', the numbers of a figure ('data'), summaries and the tables of sweeps.
%   MATLAB's readtable reads these files, too; GNU Octave has none.
%
%   osimcontact.read_table(FILE, 'AsTable', true) gives a table; in GNU Octave, which has no tables, the struct of columns.
%
%   Example:
%       result = osimcontact.plot('force', 'fixtures/table1/human_62kg_smooth_sphere.osim', 'output', 'force.svg', 'data', 'force.csv');
%       columns = osimcontact.read_table('force.csv');
%       fieldnames(columns)
%
%   See also osimcontact.inspect, osimcontact.plot, osimcontact.sweep.

    stream = fopen(char(file), 'r');
    if stream < 0
        error('osimcontact:unreadable', 'cannot open %s', char(file));
    end
    closer = onCleanup(@() fclose(stream));
    text = native2unicode(fread(stream, Inf, '*uint8')', 'UTF-8');
    rows = split_rows(text);
    widths = cellfun(@numel, rows);
    if isempty(rows) || any(widths ~= widths(1))
        error('osimcontact:unreadable', '%s is not a table: line %d has %d cells, the first has %d', char(file), ...
            [find(widths ~= widths(1), 1), widths(find(widths ~= widths(1), 1)), widths(1:min(end, 1))]);
    end
    cells = vertcat(rows{:});
    names = matlab_names(cells(1, :));
    columns = struct();
    for i = 1:numel(names)
        texts = cells(2:end, i);
        if all(cellfun(@is_number, texts))
            columns.(names{i}) = str2double(texts);
        else
            columns.(names{i}) = texts;
        end
    end
    if is_table_wanted(varargin)
        columns = osimcontact.internal.to_table(columns);
    end
end

function is = is_table_wanted(arguments)
    is = false;
    if isempty(arguments)
        return
    end
    is_pair = numel(arguments) == 2 && (ischar(arguments{1}) || isa(arguments{1}, 'string'));
    if ~is_pair || ~strcmpi(strrep(char(arguments{1}), '_', ''), 'astable') || ~islogical(arguments{2}) || ~isscalar(arguments{2})
        error('osimcontact:usage', 'expected osimcontact.read_table(FILE) or osimcontact.read_table(FILE, ''AsTable'', true)');
    end
    is = arguments{2};
end

function is = is_number(text)
    % str2double also takes commas, which it leaves out, and imaginary numbers.
    is = isempty(text) || ~isempty(regexp(text, '^[-+]?((\d+\.?\d*|\.\d+)([eE][-+]?\d+)?|inf|nan)$', 'once', 'ignorecase'));
end

function rows = split_rows(text)
    % A comma or a line end between quotation marks is part of a cell: both are looked for outside of them.
    text = strrep(text, sprintf('\r\n'), sprintf('\n'));
    if ~isempty(text) && text(end) ~= sprintf('\n')
        text(end + 1) = sprintf('\n');
    end
    is_outside = mod(cumsum(text == '"'), 2) == 0;
    line_ends = find(is_outside & text == sprintf('\n'));
    rows = cell(numel(line_ends), 1);
    begin = 1;
    for i = 1:numel(line_ends)
        line = begin:line_ends(i) - 1;
        commas = line(is_outside(line) & text(line) == ',');
        bounds = [begin - 1, commas, line_ends(i)];
        cells = cell(1, numel(bounds) - 1);
        for j = 1:numel(cells)
            cells{j} = text(bounds(j) + 1:bounds(j + 1) - 1);
        end
        cells = regexprep(cells, '^"(.*)"$', '$1');
        rows{i} = strrep(cells, '""', '"');
        begin = line_ends(i) + 1;
    end
end

function names = matlab_names(names)
    names = regexprep(names, '[^A-Za-z0-9_]', '_');
    % The names of MATLAB begin with a letter; those of Octave need not.
    names = regexprep(names, '^([^A-Za-z])', 'x$1');
    for i = find(~cellfun(@isvarname, names))
        names{i} = ['x' names{i}];
    end
end
