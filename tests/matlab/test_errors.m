function tests = test_errors()
%TEST_ERRORS Errors have identifiers, and messages that say what to do.
    tests = {@a_model_that_fails, @wrong_usage, @what_is_left_out, @wrong_rows_of_a_table, @some_fail_with_a_warning, ...
        @an_answer_that_is_needed, @existing_files_are_kept};
end

function a_model_that_fails()
    message = must_throw('osimcontact:not_a_number', @() osimcontact.rescale('decimal comma.osim', 'target_mass', 500));
    must(strncmp(message, 'decimal comma.osim:30:17: ', 26), 'the place is not said: %s', message);
    message = must_throw('osimcontact:no_contacts', @() osimcontact.rescale('no contacts.osim', 'target_mass', 500));
    must(strncmp(message, 'no contacts.osim: ', 18), 'the model is not named: %s', message);
    must_throw('osimcontact:unreadable', @() osimcontact.check('gone.osim'));
    must_throw('osimcontact:failed', @() osimcontact.plot('force', 'gone.osim', 'output', 'a.svg'));
end

function wrong_usage()
    message = must_throw('osimcontact:usage', @() osimcontact.rescale('human.osim', 'TargetMas', 500));
    must(~isempty(strfind(message, '''TargetMass''')), 'the nearest option is not named: %s', message);
    must(isempty(strfind(message, '.request.json')), 'it names a file that nobody knows: %s', message);
    message = must_throw('osimcontact:usage', @() osimcontact.rescale('human.osim', 'target_mass', 0));
    must(~isempty(strfind(message, 'above 0')), 'it does not say what is expected: %s', message);
    must_throw('osimcontact:usage', @() osimcontact.rescale('human.osim', 5, 500));
    must_throw('osimcontact:usage', @() osimcontact.rescale('human.osim', 'TargetMass', 500, 'target_mass', 62));
    must_throw('osimcontact:usage', @() osimcontact.rescale('human.osim', 'a b', 500));
    must_throw('osimcontact:usage', @() osimcontact.rescale('human.osim', 'level', 2, 'target_mass', 500));
end

function what_is_left_out()
    must_throw('osimcontact:usage', @() osimcontact.inspect('human.osim', 'format', 'csv'));
    must_throw('osimcontact:usage', @() osimcontact.inspect('-'));
    must_throw('osimcontact:usage', @() osimcontact.rescale('human.osim', 'target_mass', 500, 'output', '-'));
end

function wrong_rows_of_a_table()
    file = fopen('wrong.csv', 'w');
    fprintf(file, 'model,target_mass\nhuman.osim,heavy\nemu.osim,-1\n');
    fclose(file);
    message = must_throw('osimcontact:manifest', @() osimcontact.batch('wrong.csv', 'output_dir', 'out'));
    must(numel(strsplit(message, sprintf('\n'))) == 2, 'not every row is named: %s', message);
    must(isempty(dir('out')), 'something was written');
end

function some_fail_with_a_warning()
    lastwarn('', '');
    seen = [];
    evalc('seen = osimcontact.check({''human.osim'', ''gone.osim''});');
    [message, identifier] = lastwarn();
    must(strcmp(identifier, 'osimcontact:someFailed') && ~isempty(strfind(message, 'gone.osim')), 'another warning: %s', message);
    must(isempty(seen(1).error) && strcmp(seen(2).error.code, 'unreadable'), 'errors differ');
    must(isequal(seen(1).counts.error, 0) && isnan(seen(2).counts.error), 'counts differ');
end

function an_answer_that_is_needed()
    message = must_throw('osimcontact:implausible_mass', @() osimcontact.rescale('human.osim', 'target_mass', 500000, 'dry_run', true));
    must(~isempty(strfind(message, 'implausible-mass')), 'the answer is not named: %s', message);
    done = osimcontact.rescale('human.osim', 'target_mass', 500000, 'dry_run', true, 'radius', 'keep', ...
        'yes', 'implausible-mass');
    must(done.target_mass_kg == 500000, 'the answer is not heeded');
end

function existing_files_are_kept()
    osimcontact.rescale('human.osim', 'target_mass', 500, 'output', 'out.osim');
    before = fileread('out.osim');
    must_throw('osimcontact:output', @() osimcontact.rescale('human.osim', 'target_mass', 1000, 'output', 'out.osim'));
    must(strcmp(fileread('out.osim'), before), 'the file was replaced');
    osimcontact.rescale('human.osim', 'target_mass', 1000, 'output', 'out.osim', 'force', true);
    must(~strcmp(fileread('out.osim'), before), 'the file was not replaced');
end
