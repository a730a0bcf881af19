function tests = test_docs()
%TEST_DOCS The examples of docs/ run as they stand, and the package is in the language that MATLAB and Octave share.
    tests = {@the_page_about_matlab, @the_table_of_a_folder, @the_numbers_of_a_figure, @the_language_of_both};
end

function the_page_about_matlab()
    mkdir('fixtures');
    copyfile(fullfile(root(), 'fixtures', 'table1'), fullfile('fixtures', 'table1'));
    copyfile(fullfile(root(), 'fixtures', 'feet'), fullfile('fixtures', 'feet'));
    found = blocks('matlab.md');
    must(numel(found) >= 8, 'there are %d examples', numel(found));
    run_code(strjoin(found, sprintf('\n')));
    must(numel(dir(fullfile('scaled', '*.osim'))) == 2, 'batch has not written two models');
    must(numel(dir('human_*kg.osim')) == 3, 'the script has not written three models');
end

function the_table_of_a_folder()
    models_of_table_1();
    system(['"' osimcontact.program() '" inspect my_models --format csv > models.csv']);
    found = blocks('libraries.md');
    said = run_code(found{1});
    columns = osimcontact.read_table('models.csv');
    % Table 1: spheres of all feet, 6 and 6 of the humans, 10 and 2 of the emus; on four limbs 1, 5 and 4 each.
    must(numel(columns.mass_kg) == 2 * (6 + 6 + 10 + 2) + 4 * (1 + 5 + 4), 'there are %d rows', numel(columns.mass_kg));
    must(max(columns.mass_kg) == 1190 && numel(unique(columns.model_file)) == 7, 'models differ');
    must(~isempty(strfind(said, '.osim')), 'no model is named that sinks in deep');
end

function the_numbers_of_a_figure()
    osimcontact.plot('force', 'falisse2022', 'target_mass', 1190, 'label', {'Human', 'Giraffe'}, 'output', 'a.svg', 'data', 'print.csv');
    found = blocks('plots.md');
    said = run_code([found{1} sprintf('\nfprintf(''from %%.12g to %%.12g'', min(points.x(chosen)), max(points.x(chosen)))')]);
    % From half a radius above the ground to half a radius in it.
    must(~isempty(strfind(said, 'from -0.5 to 0.5')), 'the curve is another one: %s', said);
end

function the_language_of_both()
    % Words and signs that Octave knows and MATLAB does not, what came after MATLAB R2016b, and loops that MATLAB enters once for a
    % column without entries, and Octave never.
    foreign = {'\<end(if|for|function|while|_try_catch|switch)\>', '\<(printf|puts|unwind_protect)\>', '#', '!=', '\+=', ...
        '\+\+', '\|\|=', '^\s*arguments\s*$', '^\s*for \w+ = unique\(', '\<(newline|isfile|isfolder|contains|startsWith|strlength)\(', '"'};
    folder = package();
    files = [dir(fullfile(folder, '*.m')); dir(fullfile(folder, '+internal', '*.m'))];
    folders = [repmat({folder}, numel(dir(fullfile(folder, '*.m'))), 1); ...
        repmat({fullfile(folder, '+internal')}, numel(dir(fullfile(folder, '+internal', '*.m'))), 1)];
    must(numel(files) > 30, 'there are %d files', numel(files));
    for i = 1:numel(files)
        text = fileread(fullfile(folders{i}, files(i).name));
        % Without texts, then without comments.
        code = regexprep(regexprep(text, '(?<![\w)\]}.''])''([^''\n]|'''')*''', 't'), '%.*?$', '', 'lineanchors');
        for pattern = foreign
            [found, place] = regexp(code, pattern{1}, 'match', 'start', 'once', 'lineanchors');
            line = sum(code(1:place) == sprintf('\n')) + 1;
            must(isempty(found), '%s:%d: %s', files(i).name, line, found);
        end
        name = files(i).name(1:end - 2);
        is_function = ~isempty(regexp(text, ['^function [^\n]*\<' name '\('], 'once')) || strcmp(name, 'Contents');
        must(is_function, '%s has no function of its name', files(i).name);
        must(all(text < 128), '%s has letters that MATLAB reads otherwise on each system', files(i).name);
    end
end

function models_of_table_1()
    mkdir('my_models');
    for name = {'human_62kg', 'human_500kg', 'mouse', 'emu_10_spheres', 'emu_2_spheres', 'horse', 'giraffe'}
        file = [name{1} '_smooth_sphere.osim'];
        copyfile(fullfile(root(), 'fixtures', 'table1', file), fullfile('my_models', file));
    end
end

function found = blocks(page)
    text = strrep(fileread(fullfile(root(), 'docs', page)), sprintf('\r\n'), sprintf('\n'));
    found = regexp(text, '```matlab\n(.*?)\n```', 'tokens');
    found = cellfun(@(block) block{1}, found, 'UniformOutput', false);
    must(~isempty(found), '%s has no examples', page);
end

function said = run_code(code)
    % Nothing is drawn where there is no screen. Variables of an example stay here.
    code = regexprep(code, '^(plot|loglog|xlabel|ylabel)\(', 'not_drawn(', 'lineanchors');
    code = regexprep(code, ', ylabel\(', ', not_drawn(');
    state = warning('off', 'all');
    back = onCleanup(@() warning(state));
    said = evalc(code);
end

function not_drawn(varargin)
end

function folder = package()
    folder = fileparts(which('osimcontact.program'));
end

function folder = root()
    folder = fileparts(fileparts(fileparts(mfilename('fullpath'))));
end
