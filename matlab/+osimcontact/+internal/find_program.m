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
            error('osimcontact:programNotFound', ['there is no file ''%s'', where osimcontact.program or the environment ' ...
                'variable OSIM_CONTACT_SCALE says that the program is. If it is in FOLDER, type: ' ...
                'osimcontact.program(''FOLDER/%s'')'], path, name);
        end
        return
    end
    % .../matlab/+osimcontact/+internal/find_program.m
    package = fileparts(fileparts(mfilename('fullpath')));
    package_folders = {fileparts(package), fileparts(fileparts(package))};
    home = getenv('HOME');
    if ispc
        home = getenv('USERPROFILE');
    end
    usual_folders = {fullfile(home, '.cargo', 'bin'), fullfile(home, '.local', 'bin'), fullfile(home, 'osim-contact-scale')};
    if ~ispc
        usual_folders = [{'/usr/local/bin', '/opt/homebrew/bin'}, usual_folders];
    end
    for folder = [package_folders, strsplit(getenv('PATH'), pathsep()), usual_folders]
        path = fullfile(folder{1}, name);
        if ~isempty(folder{1}) && is_file(path)
            return
        end
    end
    error('osimcontact:programNotFound', ['this package needs the program %s, and cannot find it. If you have it in FOLDER, ' ...
        'type: osimcontact.program(''FOLDER/%s''). If not, docs/install.md says how to get it. It is looked for beside this ' ...
        'package, in the folders of PATH, and where programs usually are.'], name, name);
end

function is = is_file(path)
    % exist would also look for the name in MATLAB's own path.
    entry = dir(path);
    is = isscalar(entry) && ~entry.isdir;
end
