function tests = test_tables()
%TEST_TABLES Results as tables, tables as arguments, and values that are missing.
    tests = {@every_list_is_a_table, @series_are_tables, @lists_in_lists, @lists_that_are_not_there, @rows_of_a_batch, ...
        @tables_of_places_and_measurements, @wrong_cells_have_a_row_and_a_column, @missing_cells_are_empty, @tables_of_a_file, ...
        @not_given, @nothing_known_is_no_value, @truth_is_no_number};
end

function every_list_is_a_table()
    calls = {'rescale', {'human.osim', 'target_mass', 80, 'dry_run', true}, {'changes', 'objects', 'findings'}; ...
        'inspect', {{'human.osim', 'horse.osim'}}, {'spheres', 'forces', 'bodies', 'limbs', 'figures.limbs', 'standing.bottoms'}; ...
        'check', {{'human.osim', 'emu.osim'}}, {'findings'}; ...
        'design', {'radius', 0.032, 'indentation', 0.16, 'mass', 62, 'spheres', 6}, {'figures'}; ...
        'motion', {'walker.osim', 'walk.mot'}, {'feet', 'feet.spheres', 'feet.stances'}; ...
        'explain', {{'C.2', 'stiffness'}}, {'formulas'}; ...
        'reproduce', {}, {'table1', 'table1.values'}};
    state = warning('off', 'all');
    back = onCleanup(@() warning(state));
    for i = 1:size(calls, 1)
        whole = columns_of(calls{i, 1}, [calls{i, 2}, {'AsTable', true}]);
        must(height(whole) >= 1, '%s gives no rows', calls{i, 1});
        for list = calls{i, 3}
            columns = columns_of(calls{i, 1}, [calls{i, 2}, {'AsTable', list{1}}]);
            must(numel(fieldnames(columns)) > 1 && height(columns) >= 0, '%s: %s', calls{i, 1}, list{1});
            no_column_is_empty(columns);
        end
        no_column_is_empty(whole);
    end
end

function no_column_is_empty(columns)
    for name = fieldnames(columns)'
        column = columns.(name{1});
        is_empty = (iscell(column) && all(cellfun(@isempty, column))) || (isnumeric(column) && all(isnan(column(:))));
        must(isempty(column) || ~is_empty, '%s has no value', name{1});
    end
end

function columns = columns_of(verb, arguments)
    columns = feval(['osimcontact.' verb], arguments{:});
    if ~isstruct(columns)
        columns = table2struct(columns, 'ToScalar', true);
    end
end

function count = height(columns)
    counts = structfun(@(column) size(column, 1), columns);
    must(all(counts == counts(1)), 'columns are of different lengths: %s', mat2str(counts'));
    count = counts(1);
end

function series_are_tables()
    fall = columns_of('drop_test', {'human.osim', 'samples', 11, 'AsTable', 'series'});
    must(height(fall) == 11 && isequal(size(fall.force_bw), [11 1]), 'the series differs');
end

function lists_in_lists()
    one = osimcontact.inspect('human.osim');
    columns = columns_of('inspect', {'human.osim', 'AsTable', 'figures.limbs.spheres'});
    loads = arrayfun(@(limb) [limb.spheres.load_n], one.figures.limbs(:)', 'UniformOutput', false);
    must(isequal(columns.load_n, [loads{:}]') && strcmp(columns.limbs{1}, one.figures.limbs(1).limb), 'spheres differ');
end

function lists_that_are_not_there()
    message = must_throw('osimcontact:usage', @() osimcontact.inspect('human.osim', 'AsTable', 'mass_kg'));
    must(~isempty(strfind(message, 'figures.limbs.spheres')), 'it does not say which lists there are: %s', message);
    must_throw('osimcontact:usage', @() osimcontact.inspect('human.osim', 'AsTable', 3));
    must_throw('osimcontact:usage', @() osimcontact.inspect('human.osim', 'AsTable', 'figures.gone'));
end

function rows_of_a_batch()
    rows = struct('model', {'human.osim'; 'emu.osim'}, 'target_mass', {500; 40.1});
    columns = struct('model', {{'human.osim'; 'emu.osim'}}, 'target_mass', [500; 40.1]);
    cells = {'model', 'target_mass'; 'human.osim', 500; 'emu.osim', 40.1};
    inputs = {rows, columns, cells};
    if exist('struct2table', 'file') == 2
        inputs = [inputs, {struct2table(columns), table(columns.target_mass, 'RowNames', columns.model, 'VariableNames', {'target_mass'})}];
    end
    for input = inputs
        done = osimcontact.batch(input{1}, 'dry_run', true);
        must(isequal([done.target_mass_kg], [500 40.1]) && strcmp(done(2).model, 'emu.osim'), 'rows of a %s differ', class(input{1}));
    end
    % Commas and blanks are part of a name, and so are quotation marks.
    must(strcmp(osimcontact.internal.table_text({'a'; 'b "c", d'}, ''), sprintf('"a"\n"b ""c"", d"\n')), 'quotation marks');
    copyfile('human.osim', 'a, c.osim');
    done = osimcontact.batch({'model', 'target_mass'; 'a, c.osim', 500}, 'output_dir', 'out');
    must(strcmp(done.model, 'a, c.osim') && ~isempty(dir('out')), 'the name is %s', done.model);
end

function tables_of_places_and_measurements()
    measured = osimcontact.read_table('measured.csv');
    found = osimcontact.fit(measured, 'radius', 0.03, 'indentation_unit', 'mm');
    from_file = osimcontact.fit('measured.csv', 'radius', 0.03, 'indentation_unit', 'mm');
    must(found.stiffness.value == from_file.stiffness.value, 'stiffness is %.17g', found.stiffness.value);
    grid = {'grid_a', 'grid_b', 'z'; 1, 1, 2; 1, 2, 3; 2, 1, 3; 2, 2, 4};
    osimcontact.plot('sweep', 'table', grid, 'value_column', 'z', 'output', 'a.svg');
    must(numel(dir('a.svg')) == 1, 'nothing is drawn');
end

function wrong_cells_have_a_row_and_a_column()
    wrong = {{'model', 'target_mass'; 'human.osim', 500; 'emu.osim', -1}, 'row 2, column ''target_mass'''; ...
        {'model', 'target_mass'; 'human.osim', Inf}, 'row 1, column ''target_mass'''; ...
        {'model', 'target_mass'; NaN, 500}, 'row 1, column ''model''';
        {'model', 'target_mass'; 'human.osim', NaN}, 'row 1'};
    for i = 1:size(wrong, 1)
        message = must_throw('osimcontact:manifest', @() osimcontact.batch(wrong{i, 1}, 'dry_run', true));
        must(~isempty(strfind(message, wrong{i, 2})) && strncmp(message, 'the table: ', 11), '%s', message);
    end
    odd = {1i, [1 2], {1}, struct('a', 1), @sin, ['ab'; 'cd']};
    for i = 1:numel(odd)
        message = must_throw('osimcontact:usage', @() osimcontact.batch({'model', 'target_mass'; 'human.osim', odd{i}}, 'dry_run', true));
        must(~isempty(strfind(message, 'row 1, column ''target_mass''')), '%s', message);
    end
    columns = struct('model', {{'human.osim'; 'emu.osim'}}, 'target_mass', [500; 40; 3]);
    message = must_throw('osimcontact:usage', @() osimcontact.batch(columns));
    must(~isempty(strfind(message, 'column ''target_mass'' is 3 x 1, expected 2 x 1')), '%s', message);
    must_throw('osimcontact:usage', @() osimcontact.batch({'model', NaN; 'human.osim', 3}));
    places = struct('name', {{'s'; 't'}}, 'body', {{'calcn_r'; 'calcn_r'}}, 'x', {{0; 'a'}}, 'y', [0; 0], 'z', [0; 0]);
    message = must_throw('osimcontact:table', @() osimcontact.add('no contacts.osim', 'contacts', places, 'from', 'human.osim'));
    must(strncmp(message, 'the table: row 2, column ''x''', 28), '%s', message);
    % Rows of a file are counted as in the file.
    file = fopen('wrong.csv', 'w');
    fprintf(file, 'model,target_mass\nhuman.osim,-1\n');
    fclose(file);
    message = must_throw('osimcontact:manifest', @() osimcontact.batch('wrong.csv'));
    must(~isempty(strfind(message, 'wrong.csv:2:2: row 2, ')), '%s', message);
end

function missing_cells_are_empty()
    for nothing = {NaN, [], '', single(NaN)}
        done = osimcontact.batch({'model', 'target_mass', 'level'; 'human.osim', 500, nothing{1}; 'emu.osim', 40, true}, 'dry_run', true);
        must(isequal([done.target_mass_kg], [500 40]), 'an empty cell is something');
    end
end

function tables_of_a_file()
    columns = osimcontact.read_table('measured.csv', 'AsTable', true);
    must(numel(columns.force) > 10, 'the table is empty');
    must_throw('osimcontact:usage', @() osimcontact.read_table('measured.csv', 'AsTabel', true));
    must_throw('osimcontact:usage', @() osimcontact.read_table('measured.csv', 'AsTable', 1));
end

function not_given()
    done = osimcontact.rescale('human.osim', 'target_mass', 500, 'mass', [], 'radius', [], 'dry_run', true, 'AsTable', []);
    without = osimcontact.rescale('human.osim', 'target_mass', 500, 'dry_run', true);
    must(isequal({done.changes.to}, {without.changes.to}), '[] is a value');
    must_throw('osimcontact:usage', @() osimcontact.rescale('human.osim', 'target_mass', []));
    must_throw('osimcontact:usage', @() osimcontact.rescale([], 'target_mass', 500));
    sheet = osimcontact.design([], 'radius', 0.032, 'indentation', 0.16, 'load', 100, 'spheres', 6);
    must(isfield(sheet, 'figures'), 'no model is no calculator');
    if ~exist('OCTAVE_VERSION', 'builtin')
        done = osimcontact.rescale('human.osim', 'target_mass', 500, 'mass', missing, 'radius', string(missing), 'dry_run', true);
        must(isequal({done.changes.to}, {without.changes.to}), 'missing is a value');
    end
end

function nothing_known_is_no_value()
    for value = {NaN, single(NaN), [1 NaN], struct('stiffness', NaN), {{'a', NaN}}, zeros(0, 1), zeros(1, 0), {{[]}}, struct('stiffness', [])}
        must_throw('osimcontact:usage', @() osimcontact.set('human.osim', 'set', value{1}));
    end
    message = must_throw('osimcontact:usage', @() osimcontact.rescale('human.osim', 'target_mass', NaN));
    must(~isempty(strfind(message, 'missing')), '%s', message);
    message = must_throw('osimcontact:usage', @() osimcontact.rescale('human.osim', 'target_mass', 80, 'body_scale', [1 NaN]));
    must(~isempty(strfind(message, 'entry 2')), '%s', message);
end

function truth_is_no_number()
    for call = {@() osimcontact.rescale('human.osim', 'target_mass', true), ...
            @() osimcontact.rescale('human.osim', 'target_mass', [true false]), ...
            @() osimcontact.set('human.osim', 'set', struct('stiffness', true)), ...
            @() osimcontact.drop_test('human.osim', 'samples', true), ...
            @() osimcontact.rescale('human.osim', 'target_mass', 500, 'level', 2), ...
            @() osimcontact.batch({'model', 'target_mass'; 'human.osim', true}, 'dry_run', true)}
        try
            call{1}();
        catch problem
            must(any(strcmp(problem.identifier, {'osimcontact:usage', 'osimcontact:manifest'})), '%s', problem.message);
            continue
        end
        error('test:failed', 'a truth value is taken for a number: %s', func2str(call{1}));
    end
end
