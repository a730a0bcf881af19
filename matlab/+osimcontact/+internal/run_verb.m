function results = run_verb(verb, arguments)
%RUN_VERB Run a function of this package: make the request, call the program, return the results or throw the error.

    declaration = osimcontact.internal.verb_declaration(verb);
    [request, as_table] = osimcontact.internal.make_request(declaration, arguments);
    [status, output, errors] = osimcontact.internal.call_program(request.text, request.input);

    lines = {};
    if declaration.gives_json
        lines = strsplit(output, sprintf('\n'));
        lines = lines(strncmp(lines, '{', 1));
    end
    [records, numbers] = osimcontact.internal.json_values(lines);
    failures = records(cellfun(@(record) isfield(record, 'error'), records));
    failures = osimcontact.internal.complete_fields(failures, {osimcontact.internal.shapes('failure')}, numbers);
    osimcontact.internal.throw_failures(status, errors, failures, numel(records), request);

    if ~declaration.gives_json
        results = struct('output', char(request.fields.output), 'text', strtrim(output));
        shape = struct('output', 'text', 'text', 'text');
    else
        result = declaration.result;
        if ~isempty(declaration.without) && ~isfield(request.fields, declaration.without{1})
            result = declaration.without{2};
        end
        [results, shape] = complete_results(records, numbers, osimcontact.internal.shapes(result));
        show_findings(verb, results);
    end
    if ~isequal(as_table, false)
        results = osimcontact.internal.results_table(results, shape, as_table);
    end
end

function [results, shape] = complete_results(records, numbers, shape)
    for i = find(cellfun(@(record) isfield(record, 'errors') && isfield(shape, 'fit_errors'), records))'
        records{i}.fit_errors = {records{i}.errors};
        records{i} = rmfield(records{i}, 'errors');
    end
    if isfield(shape, 'model')
        failure = osimcontact.internal.shapes('failure');
        shape.error = {failure.error};
        for i = find(cellfun(@(record) isfield(record, 'error'), records))'
            records{i}.error = {records{i}.error};
        end
    end
    results = osimcontact.internal.complete_fields(records, {shape}, numbers);
    if isfield(shape, 'figures') && iscell(shape.figures) && isfield(shape.figures{1}, 'given') && isscalar(results)
        % The quantities of a design sheet are fields, too.
        for figure = results.figures'
            results.(figure.name) = figure.value;
            shape.(figure.name) = 'number';
        end
    end
end

function show_findings(verb, results)
    % Shows the findings of a change or a fit: once for each code, however many models have it.
    % A remark is printed; anything else is raised as a warning. Findings of inspect and check are what was asked for.
    list = 'findings';
    if isfield(results, 'warnings')
        % A fitted curve has warnings about parameters that the data do not determine.
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
            finding = results(i).(list)(j);
            codes{end + 1} = finding.code; %#ok<AGROW>
            messages{end + 1} = finding.message; %#ok<AGROW>
            is_remark(end + 1) = isfield(finding, 'severity') && strcmp(finding.severity, 'remark'); %#ok<AGROW>
            if isfield(results, 'model')
                messages{end} = [results(i).model ': ' messages{end}];
            end
        end
    end
    if isempty(codes)
        return
    end
    % As a row, because a loop takes each column, even that of an empty list.
    for code = reshape(unique(codes, 'stable'), 1, [])
        is_this = strcmp(codes, code{1});
        code_messages = messages(is_this);
        more = '';
        if numel(code_messages) > 1
            more = sprintf(' (and %d more: see the field %s)', numel(code_messages) - 1, list);
        end
        if all(is_remark(is_this))
            fprintf('remark: %s%s\n', code_messages{1}, more);
        else
            warning(osimcontact.internal.identifier(code{1}), '%s%s', code_messages{1}, more);
        end
    end
end
