function [status, output, errors] = call_program(request, input)
%CALL_PROGRAM Hand a request (JSON) to the program; its exit status, and what it wrote to both of its streams.
%   INPUT is what it reads from its standard input: a table (CSV), or nothing.
%   Nothing of the request is on the command line, so no shell interprets your names of files or quotation marks. What
%   comes back goes through files, too: MATLAB mixes both streams, and on Windows takes them for text in another encoding.

    base = tempname();
    files = struct('request', [base '.request.json'], 'input', [base '.input.csv'], 'output', [base '.out.txt'], 'errors', [base '.errors.txt']);
    cleaner = onCleanup(@() delete_files(struct2cell(files)));
    write_text(files.request, request);
    write_text(files.input, input);

    command = sprintf('%s request --words matlab %s < %s > %s 2> %s', quoted(osimcontact.internal.find_program()), quoted(files.request), ...
        quoted(files.input), quoted(files.output), quoted(files.errors));
    if ispc
        % cmd.exe takes the outer quotation marks away from a line that begins with one.
        command = ['@' command];
    end
    % With two outputs MATLAB shows nothing of it.
    [status, shell] = system(command);
    output = read_text(files.output);
    % The name of the request's file is of no use to the user.
    errors = strtrim(strrep([read_text(files.errors) shell], [files.request ': '], ''));
end

function word = quoted(path)
    if ispc
        word = ['"' path '"'];
    else
        word = ['''' strrep(path, '''', '''\''''') ''''];
    end
end

function write_text(path, text)
    [file, problem] = fopen(path, 'w');
    if file < 0
        error('osimcontact:temporaryFile', 'cannot write the request to %s: %s', path, problem);
    end
    closer = onCleanup(@() fclose(file));
    fwrite(file, unicode2native(text, 'UTF-8'), 'uint8');
end

function text = read_text(path)
    file = fopen(path, 'r');
    if file < 0
        text = '';
        return
    end
    closer = onCleanup(@() fclose(file));
    text = native2unicode(fread(file, Inf, '*uint8')', 'UTF-8');
end

function delete_files(paths)
    for i = 1:numel(paths)
        if exist(paths{i}, 'file')
            delete(paths{i});
        end
    end
end
