function tests = test_predsim()
%TEST_PREDSIM osimcontact.predsim in a folder as PredSim has it. PredSim itself needs MATLAB, OpenSim and CasADi, and is not run.
    tests = {@a_new_name_has_nothing_compiled, @the_contacts_of_transfer, @spheres_that_predsim_has_moved, @a_result_that_is_there, ...
        @other_options};
end

function a_new_name_has_nothing_compiled()
    [model, generic, subject] = layout();
    before = files_of(subject);
    osim_path = osimcontact.predsim(model, generic);
    must(strcmp(osim_path, fullfile(subject, 'Child one_contacts.osim')), 'the path is %s', osim_path);
    must(is_compiled(model, subject), 'the stand-in does not find what was compiled from the old model');
    must(~is_compiled(osim_path, subject), 'PredSim would use what it compiled from another model');
    after = files_of(subject);
    must(isequal(rmfield(after, 'Child_one_contacts_osim'), before), 'a file of the subject has changed');
    must(numel(fieldnames(files_of(fileparts(generic)))) == 1, 'something lies beside the generic model');
end

function the_contacts_of_transfer()
    [model, generic] = layout();
    [osim_path, change] = osimcontact.predsim(model, generic);
    stiffness = change.changes(find(strcmp({change.changes.property}, 'stiffness'), 1));
    % By (10) with radii by mass it is (52 / 62)^(1/3).
    must(abs(stiffness.to / stiffness.from - 0.9431) < 1e-4, 'another stiffness: %g', stiffness.to);
    fall = osimcontact.drop_test(osim_path, 'compare', generic);
    must(fall.compare.height_over_radius < 1e-9, 'it falls otherwise than the generic model');
end

function spheres_that_predsim_has_moved()
    % As scaleContactSpheres and fixContactSpherePositionAfterScaling leave them: times the ratio of distances to the toes.
    [model, generic, subject] = layout();
    osimcontact.predsim(model, generic);
    moved = fullfile(subject, 'moved.osim');
    text = strrep(fileread(model), '<radius>0.032000000000000001</radius>', '<radius>0.0326</radius>');
    write(moved, text);
    must(~strcmp(text, fileread(model)), 'no radius was changed');
    again = osimcontact.inspect(osimcontact.predsim(moved, generic));
    one = osimcontact.inspect(fullfile(subject, 'Child one_contacts.osim'));
    must(isequal(again.spheres, one.spheres), 'the spheres differ');
end

function a_result_that_is_there()
    [model, generic, subject] = layout();
    osim_path = osimcontact.predsim(model, generic);
    text = fileread(osim_path);
    must_throw('osimcontact:output', @() osimcontact.predsim(model, generic));
    must(strcmp(fileread(osim_path), text), 'it was changed');
    write(fullfile(subject, 'F_Child one_contacts.so'), 'compiled');
    evalc('osimcontact.predsim(model, generic, ''Force'', true);');
    [~, identifier] = lastwarn();
    must(strcmp(identifier, 'osimcontact:compiled_model_beside'), 'no warning of a compiled model: %s', identifier);
    must(strcmp(fileread(fullfile(subject, 'F_Child one_contacts.so')), 'compiled'), 'it was deleted');
end

function other_options()
    [model, generic, subject] = layout();
    [osim_path, change] = osimcontact.predsim(model, generic, 'Level', false, 'Output', fullfile(subject, 'other.osim'), 'mass', 40);
    must(strcmp(osim_path, fullfile(subject, 'other.osim')) && change.target_mass_kg == 40, 'options are not used');
    must_throw('osimcontact:usage', @() osimcontact.predsim(model, generic, 'Levle', false));
end

function [model, generic, subject] = layout()
    % The folders of PredSim, with what it compiled from the model of this subject. initializeSettings.m, line 80, takes the folder of
    % PredSim for S.misc.main_path; getDefaultSettings.m, line 169, has S.misc.subject_path = Subjects/ and the subject's name; main.m,
    % line 36, the model in there. All lines are those of github.com/KULeuvenNeuromechanics/PredSim, commit
    % a50fb31dba271285c727efa36302f68e60fe34e1.
    lastwarn('', '');
    fixtures = fullfile(fileparts(fileparts(fileparts(mfilename('fullpath')))), 'fixtures', 'scale_tool');
    subject = fullfile(pwd(), 'PredSim', 'Subjects', 'Child one');
    mkdir(subject);
    mkdir(fullfile('PredSim', 'Subjects', 'Generic'));
    model = fullfile(subject, 'Child one.osim');
    generic = fullfile(pwd(), 'PredSim', 'Subjects', 'Generic', 'Generic.osim');
    copyfile(fullfile(fixtures, 'scaled_smooth.osim'), model);
    copyfile(fullfile(fixtures, 'generic_smooth.osim'), generic);
    for name = {'F_Child one.so', 'F_Child one.dll', 'F_Child one.casadi', 'F_Child one.lib', 'F_Child one.cpp', 'F_Child one_IO.mat'}
        write(fullfile(subject, name{1}), name{1});
    end
end

function is = is_compiled(osim_path, subject)
    % PreProcessing/osim2dll.m: line 46 takes the name of the model's file without its folder and ending, lines 47 to 57 make the names
    % of the compiled files of it, lines 63 to 68 ask whether the program of this system and _IO.mat are there. If so, line 165
    % has them used, unless S.OpenSimADOptions.always_generate is set.
    [~, name] = fileparts(osim_path);
    is = numel(dir(fullfile(subject, ['F_' name '.so']))) == 1 && numel(dir(fullfile(subject, ['F_' name '_IO.mat']))) == 1;
end

function contents = files_of(folder)
    contents = struct();
    for entry = dir(folder)'
        if ~entry.isdir
            contents.(regexprep(entry.name, '[^A-Za-z0-9]', '_')) = fileread(fullfile(folder, entry.name));
        end
    end
end

function write(path, text)
    file = fopen(path, 'w');
    fwrite(file, text);
    fclose(file);
end
