function results = run_verb(verb, arguments)
%RUN_VERB Do what a function of this package is asked for: the request, the call, its results or its error.

    declared = osimcontact.internal.declared(verb);
    [request, as_table] = osimcontact.internal.request_of(declared, arguments);
    [status, out, said] = osimcontact.internal.call_program(request.text, request.input);

    records = {};
    if declared.gives_json
        lines = strsplit(out, sprintf('\n'));
        lines = lines(strncmp(lines, '{', 1));
        records = cellfun(@osimcontact.internal.json_value, lines, 'UniformOutput', false);
    end
    has_failed = cellfun(@(record) isfield(record, 'error'), records);
    osimcontact.internal.throw_failures(status, said, records, has_failed, ~isempty(request.input));

    if ~declared.gives_json
        results = struct('output', char(request.fields.output), 'text', strtrim(out));
        shape = struct('output', 'text', 'text', 'text');
    else
        result = declared.result;
        if ~isempty(declared.without) && ~isfield(request.fields, declared.without{1})
            result = declared.without{2};
        end
        [results, shape] = results_of(records, osimcontact.internal.shapes(result));
        say_findings(verb, results);
    end
    if ~isequal(as_table, false)
        results = osimcontact.internal.table_of(results, shape, as_table);
    end
end

function [results, shape] = results_of(records, shape)
    if isfield(shape, 'model')
        failure = osimcontact.internal.shapes('failure');
        shape.error = {failure.error};
        for i = find(cellfun(@(record) isfield(record, 'error'), records))
            records{i}.error = {records{i}.error};
        end
    end
    results = osimcontact.internal.completed(records(:), {shape});
end

function say_findings(verb, results)
    % What changes a model, or finds parameters, says what is to be known of it: once for each code, however many models.
    % A remark is printed; anything else is raised as a warning. Findings of inspect and check are what was asked for.
    list = 'findings';
    if isfield(results, 'warnings')
        % Of a fitted curve: what the data do not determine, always warnings.
        list = 'warnings';
    end
    if any(strcmp(verb, {'inspect', 'check'})) || ~isfield(results, list)
        return
    end
    codes = {};
    messages = {};
    is_remark = logical([]);
    for i = 1:numel(results)
        for j = 1:numel(results(i).(list))
            found = results(i).(list)(j);
            codes{end + 1} = found.code; %#ok<AGROW>
            messages{end + 1} = found.message; %#ok<AGROW>
            is_remark(end + 1) = isfield(found, 'severity') && strcmp(found.severity, 'remark'); %#ok<AGROW>
            if isfield(results, 'model')
                messages{end} = [results(i).model ': ' messages{end}];
            end
        end
    end
    if isempty(codes)
        return
    end
    % As a row: a loop takes each column, of a list without entries too, if it is one column.
    for code = reshape(unique(codes, 'stable'), 1, [])
        is_this = strcmp(codes, code{1});
        of_code = messages(is_this);
        more = '';
        if numel(of_code) > 1
            more = sprintf(' (and %d more: see the field %s)', numel(of_code) - 1, list);
        end
        if all(is_remark(is_this))
            fprintf('remark: %s%s\n', of_code{1}, more);
        else
            warning(osimcontact.internal.identifier(code{1}), '%s%s', of_code{1}, more);
        end
    end
end
