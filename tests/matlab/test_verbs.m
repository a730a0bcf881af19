function tests = test_verbs()
%TEST_VERBS Every verb: its function, its help, and the example in it.
    tests = {@every_verb_has_a_function, @help_is_found, @helps_name_every_option, @examples_run_as_they_stand, @names_in_every_spelling, ...
        @flags_in_every_spelling, @names_in_messages, @arguments_before_the_options, @objects_as_structs_and_maps};
end

function every_verb_has_a_function()
    schemas = dir(fullfile(root(), 'schemas', 'requests', '*.schema.json'));
    must(numel(schemas) > 15, 'there are %d schemas', numel(schemas));
    for i = 1:numel(schemas)
        verb = strrep(strrep(schemas(i).name, '.schema.json', ''), '-', '_');
        must(numel(dir(fullfile(package(), [verb '.m']))) == 1, 'there is no osimcontact.%s', verb);
    end
end

function help_is_found()
    % By its usual command, before a function was called and afterwards.
    for name = [functions_of_verbs(), {'apply', 'predsim', 'program', 'read_table'}]
        must(~isempty(strfind(help(['osimcontact.' name{1}]), upper(name{1}))), 'there is no help of %s', name{1});
    end
    osimcontact.program();
    must(~isempty(strfind(help('osimcontact.program'), 'PROGRAM')), 'there is no help of program after a call');
    % Octave looks for a text in the package itself, which has none, and then no further.
    list = 'osimcontact';
    if exist('OCTAVE_VERSION', 'builtin')
        list = 'osimcontact.Contents';
    end
    must(~isempty(strfind(help(list), 'drop_test')), 'there is no list of functions');
end

function helps_name_every_option()
    functions = functions_of_verbs();
    for i = 1:numel(functions)
        schema = jsondecode(fileread(fullfile(root(), 'schemas', 'requests', [strrep(functions{i}, '_', '-') '.schema.json'])));
        text = help_of(functions{i});
        must(strncmp(text, upper(functions{i}), numel(functions{i})), 'the help of %s begins otherwise', functions{i});
        must(~isempty(strfind(text, 'See also osimcontact.')), 'the help of %s names no other', functions{i});
        left_out = {'verb', 'format', 'quiet', 'diff', 'full', 'ascii', 'deny'};
        % jsondecode makes xEnd of end, which is a word of the language.
        for name = setdiff(strrep(fieldnames(schema.properties), 'xEnd', 'end'), left_out)'
            named = ~isempty(regexp(text, ['^ *' name{1} ': '], 'once', 'lineanchors')) || ~isempty(strfind(text, [upper(name{1}) ': ']));
            must(named, 'the help of %s does not name %s', functions{i}, name{1});
        end
        for foreign = {'standard input', 'may be repeated', '--', '`', ' or - '}
            must(isempty(strfind(text, foreign{1})), 'the help of %s is about a terminal: %s', functions{i}, foreign{1});
        end
    end
end

function examples_run_as_they_stand()
    mkdir('fixtures');
    for folder = {'table1', 'feet', 'measured', 'motion'}
        copyfile(fullfile(root(), 'fixtures', folder{1}), fullfile('fixtures', folder{1}));
    end
    functions = functions_of_verbs();
    for i = 1:numel(functions)
        example = regexp(help_of(functions{i}), 'Example[^\n]*:\n(.*?)\n *\n', 'tokens', 'once');
        must(~isempty(strfind(example{1}, ['osimcontact.' functions{i} '('])), 'the example of %s is of another one', functions{i});
        run_example(functions{i}, strrep(example{1}, 'plot(fall', 'isequal(fall'));
    end
end

function run_example(name, code)
    % In a function of its own, so that names of examples hide nothing here.
    state = warning('off', 'all');
    back = onCleanup(@() warning(state));
    try
        evalc(code);
    catch problem
        error('test:failed', 'the example of %s: %s', name, problem.message);
    end
end

function names_in_every_spelling()
    for name = {'target_mass', 'TargetMass', 'targetmass', 'TARGET_MASS', 'Target_Mass'}
        done = osimcontact.rescale('human.osim', name{1}, 500, 'DryRun', true);
        must(done.target_mass_kg == 500 && isempty(done.output), '%s is not heeded', name{1});
    end
end

function flags_in_every_spelling()
    for value = {true, 1, 'on', 'On'}
        done = osimcontact.rescale('human.osim', 'TargetMass', 500, 'DryRun', value{1}, 'Level', 'off', 'InPlace', 0, 'NoNote', false);
        must(isempty(done.output), 'it was written');
    end
    for value = {2, 'yes', [0 1]}
        message = must_throw('osimcontact:usage', @() osimcontact.rescale('human.osim', 'TargetMass', 500, 'dry_run', value{1}));
        must(strcmp(message, '''dry_run'' is true or false'), 'another message: %s', message);
    end
end

function names_in_messages()
    for name = {'target_mass', 'TargetMass', 'targetmass'}
        message = must_throw('osimcontact:usage', @() osimcontact.rescale('human.osim', name{1}, -70));
        must(~isempty(strfind(message, ['''' name{1} ''''])), 'it was typed otherwise: %s', message);
        message = must_throw('osimcontact:implausible_mass', @() osimcontact.rescale('human.osim', name{1}, 62000));
        must(~isempty(strfind(message, ['''' name{1} ''', 62000'])), 'it was typed otherwise: %s', message);
        for masses = {[50 60], {50 60}, {50; 60}, {'50', '60'}}
            message = must_throw('osimcontact:usage', @() osimcontact.rescale('human.osim', name{1}, masses{1}));
            must(~isempty(strfind(message, ['''' name{1} ''' is one mass, not 2: osimcontact.batch'])), 'it does not name batch: %s', message);
        end
    end
    if ~exist('OCTAVE_VERSION', 'builtin')
        message = must_throw('osimcontact:usage', @() osimcontact.rescale('human.osim', 'TargetMass', string({'50', '60'})));
        must(~isempty(strfind(message, 'osimcontact.batch')), 'it does not name batch: %s', message);
    end
    message = must_throw('osimcontact:usage', @() osimcontact.rescale('human.osim', 'TargetMas', 70));
    must(~isempty(strfind(message, '''TargetMas''')), 'it was typed otherwise: %s', message);
end

function arguments_before_the_options()
    one = osimcontact.presets('falisse2022');
    must(strcmp(one.name, 'falisse2022'), 'a name alone');
    all = osimcontact.presets();
    must(numel(all) >= 1, 'no argument at all');
    own = osimcontact.presets('presets', fullfile(root(), 'fixtures', 'presets', 'lab.toml'));
    must(numel(own) > numel(all), 'an option alone');
    sheet = osimcontact.design('radius', 0.032, 'indentation', 0.16, 'load', 100, 'spheres', 6);
    must(isfield(sheet, 'figures') && ~isfield(sheet, 'changes'), 'design without a model is a calculator');
    must(sheet.radius_m == 0.032 && sheet.stiffness == sheet.figures(strcmp({sheet.figures.name}, 'stiffness')).value, 'its fields differ');
    done = osimcontact.design('human.osim', 'indentation', 0.1, 'dry_run', true);
    must(isfield(done, 'changes'), 'design with a model is a change');
    done = osimcontact.plot('fig4', 'output', 'fig4.svg');
    must(strcmp(done.output, 'fig4.svg') && numel(dir('fig4.svg')) == 1, 'a figure without models');
    osimcontact.plot('force', 'human.osim', 'output', 'force.svg');
    must(numel(dir('force.svg')) == 1, 'a figure with a model');
    for call = {@() osimcontact.inspect(), @() osimcontact.rescale('human.osim', 'target_mass'), @() osimcontact.plot()}
        must_throw('osimcontact:usage', call{1});
    end
end

function objects_as_structs_and_maps()
    map = containers.Map({'stiffness', 'dissipation'}, {'x2', 1.5});
    for value = {struct('stiffness', 'x2', 'dissipation', 1.5), map}
        done = osimcontact.set('human.osim', 'set', value{1}, 'select', {'*_r'}, 'dry_run', true);
        is_stiffness = strcmp({done.changes.property}, 'stiffness');
        must(sum(is_stiffness) == 6 && all([done.changes(is_stiffness).to] == 2e6), 'stiffness is another one');
        must(all([done.changes(~is_stiffness).to] == 1.5), 'dissipation is another one');
    end
end

function functions = functions_of_verbs()
    files = dir(fullfile(package(), '*.m'));
    functions = cellfun(@(name) name(1:end - 2), {files.name}, 'UniformOutput', false);
    functions = setdiff(functions, {'Contents', 'apply', 'predsim', 'program', 'read_table'});
end

function text = help_of(name)
    % As help prints it: the lines of the comment, without the percent sign.
    text = fileread(fullfile(package(), [name '.m']));
    comment = regexp(text, '^%.*?\n(?=[^%])', 'match', 'once', 'lineanchors');
    text = [regexprep(comment, '^%', '', 'lineanchors') sprintf('\n')];
end

function folder = package()
    folder = fileparts(which('osimcontact.program'));
end

function folder = root()
    folder = fileparts(fileparts(fileparts(mfilename('fullpath'))));
end
