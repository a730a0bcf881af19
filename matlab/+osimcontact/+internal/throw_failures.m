function throw_failures(status, said, records, has_failed)
%THROW_FAILURES The error for a call that gave nothing; a warning where some models failed and others did not.

    said = in_matlab(said);
    failures = cellfun(@spelled, records(has_failed), 'UniformOutput', false);
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
        warning('osimcontact:someFailed', '%d of %d failed, first %s (the field error says it of each)', ...
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
