function path = find_program()
%FIND_PROGRAM The path of the program osim-contact-scale.
%   Looked for in this order: what osimcontact.program or the environment variable OSIM_CONTACT_SCALE says; beside this
%   package; the folders of PATH; the folders into which programs are usually put. MATLAB that was started from the Dock of
%   macOS does not know the PATH of a terminal.

    name = 'osim-contact-scale';
    if ispc
        name = [name '.exe'];
    end
    path = getenv('OSIM_CONTACT_SCALE');
    if ~isempty(path)
        if ~is_file(path)
            error('osimcontact:programNotFound', ['there is no file ''%s'', which the environment variable OSIM_CONTACT_SCALE ' ...
                'or osimcontact.program named. Say where it is: osimcontact.program(''FOLDER/%s'')'], path, name);
        end
        return
    end
    % .../matlab/+osimcontact/+internal/find_program.m
    package = fileparts(fileparts(mfilename('fullpath')));
    beside = {fileparts(package), fileparts(fileparts(package))};
    home = getenv('HOME');
    if ispc
        home = getenv('USERPROFILE');
    end
    usual = {fullfile(home, '.cargo', 'bin'), fullfile(home, '.local', 'bin'), fullfile(home, 'osim-contact-scale')};
    if ~ispc
        usual = [{'/usr/local/bin', '/opt/homebrew/bin'}, usual];
    end
    for folder = [beside, strsplit(getenv('PATH'), pathsep()), usual]
        path = fullfile(folder{1}, name);
        if ~isempty(folder{1}) && is_file(path)
            return
        end
    end
    error('osimcontact:programNotFound', ['the program %s is not found: not beside this package, in no folder of PATH, and not ' ...
        'where programs usually are. Download it (docs/install.md), and say where it is: ' ...
        'osimcontact.program(''FOLDER/%s'')'], name, name);
end

function is = is_file(path)
    % exist would also look for the name in MATLAB's own path.
    found = dir(path);
    is = isscalar(found) && ~found.isdir;
end
