function throw_failures(status, errors, failures, count, request)
%THROW_FAILURES Throw an error if a call has no results; show a warning if only some models failed.
%   FAILURES are those of COUNT results. Options are named as they were typed. If a table was an argument, rows are counted as
%   in MATLAB.

    errors = matlab_text(strrep(errors, 'error: ', ''), request.typed);
    failures = cellfun(@(record) translate_message(record, request.typed), num2cell(failures), 'UniformOutput', false);
    if ~isempty(request.input)
        errors = matlab_rows(regexprep(errors, '^-: ', 'the table: '));
        failures = cellfun(@name_table, failures, 'UniformOutput', false);
    end
    if status == 2 || (count == 1 && ~isempty(failures))
        if isempty(failures)
            error('osimcontact:usage', '%s', errors);
        end
        messages = cellfun(@failure_text, failures, 'UniformOutput', false);
        error(osimcontact.internal.identifier(failures{1}.error.code), '%s', strjoin(messages, sprintf('\n')));
    elseif status == 1 && count == 0 && ~isempty(errors)
        error('osimcontact:failed', '%s', errors);
    elseif status ~= 0 && (status ~= 1 || count == 0)
        error('osimcontact:programFailed', 'the program ended with status %d: %s', status, errors);
    elseif ~isempty(failures)
        warning('osimcontact:someFailed', '%d of %d failed; the field error has the reason of each. The first: %s', ...
            numel(failures), count, failure_text(failures{1}));
    end
end

function text = failure_text(record)
    place = '';
    if ~isnan(record.error.line)
        place = sprintf(':%d', [record.error.line, record.error.column]);
    end
    % Control characters in a name are shown as question marks.
    text = [regexprep(record.model, '[\x00-\x1f\x7f]', '?') place ': ' record.error.message];
end

function record = translate_message(record, typed)
    record.error.message = matlab_text(record.error.message, typed);
end

function text = matlab_text(text, typed)
    % The program spells fields and values in backticks and file names that are not UTF-8 as in JSON.
    text = regexprep(text, '`([^`]*)`', '''$1''');
    text = strrep(text, ', as text or as {"bytes": [...]}', '');
    for name = fieldnames(typed)'
        % The program spells the options that it knows as 'TargetMass'.
        words = cellfun(@(word) [upper(word(1:min(1, end))) word(2:end)], strsplit(name{1}, '_'), 'UniformOutput', false);
        for spelled = {[words{:}], name{1}}
            text = strrep(text, ['''' spelled{1} ''''], ['''' typed.(name{1}) '''']);
        end
    end
end

function record = name_table(record)
    % A table has no file, and its first row is the second line of the input of the program.
    if ~strcmp(record.model, '-')
        return
    end
    record.model = 'the table';
    text = regexprep(record.error.message, '^-: ', '');
    if record.error.line > 1 && isempty(regexp(text, '^row \d', 'once'))
        text = sprintf('row %d, %s', record.error.line, text);
    end
    record.error.message = matlab_rows(text);
    record.error.line = NaN;
end

function text = matlab_rows(text)
    [rows, between] = regexp(text, '(?<=\<row )\d+', 'match', 'split');
    rows = cellfun(@(row) sprintf('%d', str2double(row) - 1), rows, 'UniformOutput', false);
    parts = [between; [rows, {''}]];
    text = [parts{:}];
end
