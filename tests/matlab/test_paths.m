function tests = test_paths()
%TEST_PATHS Names of files and folders that shells, encodings and systems trip over; finding the program.
    tests = {@names_of_all_kinds, @a_path_beyond_260_characters, @folders_as_models, @a_folder_that_must_not_be_written, ...
        @a_place_where_nothing_can_be_written, @the_program_in_a_folder_with_an_odd_name, @the_program_is_looked_for, ...
        @the_program_is_not_there, @nothing_is_left_in_the_temporary_folder};
end

function names_of_all_kinds()
    letters = native2unicode(uint8([77 195 188 108 108 101 114 32 206 177 230 151 165 240 159 166 180]), 'UTF-8');
    names = {'it''s a folder', 'two  blanks', letters, 'a"b', '$(touch gone) `touch gone` %PATH% & ; | > gone', '-o', 'a[1]*?', ...
        sprintf('tab\tand\nline'), '!history^2', 'C:\no such'};
    if ispc
        names = names([1 2 3 6]);
    end
    for i = 1:numel(names)
        folder = names{i};
        mkdir(folder);
        copy_model('human.osim', fullfile(folder, 'my model.osim'));
        output = fullfile(folder, [letters '.osim']);
        done = osimcontact.rescale(fullfile(folder, 'my model.osim'), 'target_mass', 500, 'output', output);
        must(strcmp(done.model, fullfile(folder, 'my model.osim')) && strcmp(done.output, output), 'names differ: %s', done.output);
        must(~isempty(strfind(fileread(output), 'contacts made for 500 kg')), '%s is not what was written', output);
    end
    must(isempty(dir('gone')), 'a shell has read a name');
end

function a_path_beyond_260_characters()
    folder = pwd();
    while numel(folder) < 300
        folder = fullfile(folder, repmat('long ', 1, 8));
        mkdir(folder);
    end
    copy_model('human.osim', fullfile(folder, 'human.osim'));
    done = osimcontact.rescale(fullfile(folder, 'human.osim'), 'target_mass', 500);
    must(numel(done.output) > 300 && numel(dir(done.output)) == 1, 'nothing was written to %s', done.output);
end

function folders_as_models()
    mkdir('models');
    copyfile('human.osim', 'models');
    copyfile('emu.osim', 'models');
    seen = osimcontact.inspect('models');
    must(isequal(sort([seen.mass_kg]), [37.8 62]), 'masses are %s', mat2str([seen.mass_kg]));
end

function a_folder_that_must_not_be_written()
    mkdir('locked');
    if ~isunix()
        error('test:skipped', 'a folder that must not be written, on Windows: its attributes do not forbid it');
    end
    system('chmod a-w locked');
    file = fopen(fullfile('locked', 'try'), 'w');
    if file >= 0
        fclose(file);
        error('test:skipped', 'a folder that must not be written: root may write everywhere');
    end
    message = must_throw('osimcontact:output', @() osimcontact.rescale('human.osim', 'target_mass', 500, 'output_dir', 'locked'));
    system('chmod u+w locked');
    must(~isempty(strfind(message, 'locked')), 'the folder is not named: %s', message);
end

function a_place_where_nothing_can_be_written()
    % Not even by root.
    if ~isunix() || ismac()
        return
    end
    message = must_throw('osimcontact:output', @() osimcontact.rescale('human.osim', 'target_mass', 500, 'output', '/proc/a.osim'));
    must(~isempty(strfind(message, '/proc')), 'the file is not named: %s', message);
end

function the_program_in_a_folder_with_an_odd_name()
    program = osimcontact.program();
    folder = native2unicode(uint8([105 116 39 115 32 195 188 34 36 40 120 41]), 'UTF-8');
    if ispc
        folder = 'it''s there';
    end
    mkdir(folder);
    [~, name, extension] = fileparts(program);
    copy = fullfile(pwd(), folder, [name extension]);
    % With the right to run it, and then into a folder whose name Octave's own copyfile does not take.
    copyfile(program, [name extension]);
    if exist('OCTAVE_VERSION', 'builtin')
        rename([name extension], copy);
    else
        movefile([name extension], copy);
    end
    must(strcmp(osimcontact.program(copy), copy), 'it is not the one that was named');
    preset = osimcontact.presets('falisse2022');
    must(strcmp(preset.name, 'falisse2022'), 'it does not run');
end

function the_program_is_looked_for()
    [~, ~, extension] = fileparts(osimcontact.program());
    name = 'osim-contact-scale';
    folder = fullfile(pwd(), 'bin');
    mkdir(folder);
    program = fullfile(folder, [name extension]);
    copyfile(osimcontact.program(), program);
    setenv('OSIM_CONTACT_SCALE', '');
    setenv('PATH', ['/nowhere' pathsep() folder pathsep() getenv('PATH')]);
    must(strcmp(osimcontact.program(), program), 'not the one of PATH: %s', osimcontact.program());
    % Beside the package, as in the archive of a release.
    package = fileparts(which('osimcontact.program'));
    mkdir('matlab');
    copyfile(package, fullfile(pwd(), 'matlab', '+osimcontact'));
    copyfile(program, [name extension]);
    before = fileparts(package);
    rmpath(before);
    back = onCleanup(@() addpath(before));
    addpath('matlab');
    found = osimcontact.program();
    rmpath('matlab');
    must(strcmp(found, fullfile(pwd(), [name extension])), 'not the one beside the package: %s', found);
end

function the_program_is_not_there()
    home = getenv('HOME');
    setenv('OSIM_CONTACT_SCALE', '/nowhere/osim-contact-scale');
    message = must_throw('osimcontact:programNotFound', @() osimcontact.inspect('human.osim'));
    must(~isempty(strfind(message, '/nowhere/osim-contact-scale')), 'the file is not named: %s', message);
    setenv('OSIM_CONTACT_SCALE', '');
    setenv('PATH', '/nowhere');
    setenv('HOME', '/nowhere');
    back = onCleanup(@() setenv('HOME', home));
    message = must_throw('osimcontact:programNotFound', @() osimcontact.inspect('human.osim'));
    must(~isempty(strfind(message, 'osimcontact.program(')), 'it does not say what to do: %s', message);
    % What was named before stays.
    setenv('OSIM_CONTACT_SCALE', fullfile(pwd(), 'human.osim'));
    must_throw('osimcontact:programNotFound', @() with_program('/nowhere/osim-contact-scale'));
    must(strcmp(osimcontact.program(), fullfile(pwd(), 'human.osim')), 'the program named before is gone');
    % A file that is not a program.
    must_throw('osimcontact:programFailed', @() with_program(fullfile(pwd(), 'human.osim')));
end

function with_program(path)
    osimcontact.program(path);
    osimcontact.inspect('human.osim');
end

function nothing_is_left_in_the_temporary_folder()
    before = temporary_files();
    osimcontact.inspect('human.osim');
    must_throw('osimcontact:unreadable', @() osimcontact.inspect('gone.osim'));
    must_throw('osimcontact:usage', @() osimcontact.inspect('human.osim', 'target_gravity', 5));
    must(isempty(setdiff(temporary_files(), before)), 'files are left');
end

function names = temporary_files()
    all = dir(tempdir());
    names = {all.name};
    names = names(~cellfun(@isempty, regexp(names, '\.(request\.json|out\.txt|said\.txt)$')));
end

function copy_model(from, to)
    % Octave's copyfile takes some names for words of a shell.
    file = fopen(to, 'w');
    must(file >= 0, 'cannot write %s', to);
    fwrite(file, fileread(from));
    fclose(file);
end
