function results = contact_scale(varargin)
%CONTACT_SCALE Run osim-contact-scale; what it says, as structs.
%   results = CONTACT_SCALE('inspect', 'my model.osim')
%   results = CONTACT_SCALE('my model.osim', '--target-mass', 1190, '-o', 'big.osim')
%
%   Arguments are texts or numbers; paths may hold spaces. results is a cell array with one struct for each model. The
%   struct of a model that failed has a field 'error', with 'code', 'message', 'line' and 'column'; the others are done.
%   Wrong usage, or a program that is not there, is an error (contact_scale:usage, contact_scale:missing).
%
%   For MATLAB R2016b and later, and GNU Octave 7 and later.

    words = cellfun(@quoted, [varargin, {'--format', 'json'}], 'UniformOutput', false);
    % Messages go to the same place as results in MATLAB, and elsewhere in Octave: 2>&1 makes them alike.
    [status, text] = system([strjoin([{'osim-contact-scale'}, words], ' ') ' 2>&1']);

    lines = strtrim(strsplit(text, sprintf('\n')));
    is_json = strncmp(lines, '{', 1);
    results = cellfun(@jsondecode, lines(is_json), 'UniformOutput', false);

    if status == 2
        error('contact_scale:usage', '%s', strtrim(text));
    elseif status > 2 || (status ~= 0 && isempty(results))
        error('contact_scale:missing', 'osim-contact-scale did not run (status %d): %s', status, strtrim(text));
    end
end

function word = quoted(argument)
    if isnumeric(argument)
        % 17 digits give the same number back.
        argument = sprintf('%.17g', argument);
    end
    if ispc
        % A backslash at the end would take the quotation mark with it.
        word = ['"' regexprep(argument, '\\$', '\\\\') '"'];
    else
        word = ['''' strrep(argument, '''', '''\''''') ''''];
    end
end
