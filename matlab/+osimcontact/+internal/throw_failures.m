function throw_failures(status, said, records, has_failed, has_table)
%THROW_FAILURES The error for a call that gave nothing; a warning where some models failed and others did not.
%   HAS_TABLE: a table was an argument, so that rows are counted as in MATLAB.

    said = in_matlab(strrep(said, 'error: ', ''));
    failures = cellfun(@spelled, records(has_failed), 'UniformOutput', false);
    if has_table
        said = own_rows(regexprep(said, '^-: ', 'the table: '));
        failures = cellfun(@of_table, failures, 'UniformOutput', false);
    end
    if status == 2 || (numel(records) == 1 && has_failed)
        if isempty(failures)
            error('osimcontact:usage', '%s', said);
        end
        messages = cellfun(@in_words, failures, 'UniformOutput', false);
        error(osimcontact.internal.identifier(failures{1}.error.code), '%s', strjoin(messages, sprintf('\n')));
    elseif status == 1 && isempty(records) && ~isempty(said)
        error('osimcontact:failed', '%s', said);
    elseif status ~= 0 && (status ~= 1 || isempty(records))
        error('osimcontact:programFailed', 'the program ended with status %d: %s', status, said);
    elseif any(has_failed)
        warning('osimcontact:someFailed', '%d of %d failed; the field error has the reason of each. The first: %s', ...
            numel(failures), numel(records), in_words(failures{1}));
    end
end

function text = in_words(record)
    place = '';
    if ~isempty(record.error.line)
        place = sprintf(':%d', [record.error.line, record.error.column]);
    end
    % Letters in a name that would steer a terminal are shown as marks.
    text = [regexprep(record.model, '[\x00-\x1f\x7f]', '?') place ': ' record.error.message];
end

function record = spelled(record)
    record.error.message = in_matlab(record.error.message);
end

function text = in_matlab(text)
    % What the program has no words of MATLAB for: names of fields and values between backticks, and names that are not UTF-8.
    text = regexprep(text, '`([^`]*)`', '''$1''');
    text = strrep(text, ', as text or as {"bytes": [...]}', '');
end

function record = of_table(record)
    % It has no file, and its first row is the second line of what the program read.
    if ~strcmp(record.model, '-')
        return
    end
    record.model = 'the table';
    text = regexprep(record.error.message, '^-: ', '');
    if ~isempty(record.error.line) && record.error.line > 1 && isempty(regexp(text, '^row \d', 'once'))
        text = sprintf('row %d, %s', record.error.line, text);
    end
    record.error.message = own_rows(text);
    record.error.line = [];
end

function text = own_rows(text)
    [rows, between] = regexp(text, '(?<=\<row )\d+', 'match', 'split');
    rows = cellfun(@(row) sprintf('%d', str2double(row) - 1), rows, 'UniformOutput', false);
    parts = [between; [rows, {''}]];
    text = [parts{:}];
end
