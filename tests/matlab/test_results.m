function tests = test_results()
%TEST_RESULTS What comes back: the right values, and the same fields in every element.
    tests = {@rescaling_follows_the_paper, @all_elements_have_the_same_fields, @missing_numbers_are_nan, ...
        @some_models_fail, @explanations_of_all_kinds, @series_are_columns, @only_a_fit_has_errors_of_the_fit, @columns_of_results, @tables_are_made_of_columns, ...
        @findings_are_said_once, @tables_of_the_program, @texts_of_json, @real_models};
end

function rescaling_follows_the_paper()
    done = osimcontact.rescale('human.osim', 'TargetMass', 500, 'output', 'out.osim');
    must(strcmp(done.output, 'out.osim') && numel(dir('out.osim')) == 1, 'nothing was written to out.osim');
    ratio = 500 / 62;
    % Equations (8), (10) and (14): radius and stiffness as M^(1/3), dissipation as R^(-1/2).
    expected = struct('radius', 0.032 * ratio ^ (1 / 3), 'stiffness', 1e6 * ratio ^ (1 / 3), 'dissipation', 2 * ratio ^ (-1 / 6));
    for name = fieldnames(expected)'
        is_this = strcmp({done.changes.property}, name{1});
        to = [done.changes(is_this).to];
        must(numel(to) == 12 && all(abs(to / expected.(name{1}) - 1) < 1e-14), '%s is %.17g', name{1}, to(1));
    end
    must(isempty(done.error) && isempty(done.objects) && iscellstr(done.remarks), 'fields are of other kinds');
end

function all_elements_have_the_same_fields()
    % A human of the smooth class, and a horse with Hunt-Crossley forces.
    seen = osimcontact.inspect({'human.osim', 'horse.osim'});
    must(isequal(size(seen), [2 1]) && isequal([seen.mass_kg], [62 545]), 'masses are %s', mat2str([seen.mass_kg]));
    must(isstruct(seen(1).known_contacts) && isstruct(seen(2).known_contacts), 'known_contacts is not a struct');
    must(isnan(seen(2).forces(1).dimensionless.hertz_smoothing), 'a Hunt-Crossley force has no hertz_smoothing');
    must(isempty([seen.body_factors]) && isfield(seen(1).body_factors, 'factors'), 'an empty list has no fields');
    must(numel(vertcat(seen.spheres)) == 12 + 20, 'there are other spheres');
    must(isequal(size(seen(1).spheres(1).location_m), [3 1]), 'a place is not a column');
end

function missing_numbers_are_nan()
    [values, numbers] = osimcontact.internal.json_values({['{"model":"m","mass_kg":null,"limbs":null,"forces":[{"parameters":{"a":1},"set":null},' ...
        '{"parameters":{"b":null}}],"body_factors":[{"factors":[1.5,null,2],"sources":["joint",null,null],"by_source":{"scale file":[2]}},' ...
        '{"sources":[null,null,null]}],"newer":[{"x":4}],"new":7}']});
    full = osimcontact.internal.complete_fields(values, {osimcontact.internal.shapes('inspection')}, numbers);
    must(isnan(full.mass_kg) && isnan(full.gravity_m_s2) && isnan(full.contacts_mass_kg.value), 'numbers are not NaN');
    must(ischar(full.name) && isempty(full.name) && strcmp(full.model, 'm'), 'texts are not empty');
    must(isstruct(full.limbs) && isempty(full.limbs) && isfield(full.limbs, 'side'), 'a list has lost its fields');
    must(isnan(full.forces(1).set) && full.forces(1).parameters.a == 1 && isnan(full.forces(1).parameters.b), 'parameters differ');
    must(isnan(full.forces(2).parameters.a), 'the second force has no a');
    must(isequal(isnan(full.body_factors(1).factors), [false; true; false]) && full.body_factors(1).factors(3) == 2, 'factors differ');
    must(isequal({full.body_factors.sources}, {{'joint'; ''; ''}, {''; ''; ''}}), 'sources differ');
    must(full.body_factors(1).by_source.scale_file == 2 && isnan(full.body_factors(2).by_source.scale_file), 'a name with a blank');
    must(full.newer.x == 4 && full.new == 7, 'what is not known yet is lost');
end

function some_models_fail()
    state = warning('off', 'osimcontact:someFailed');
    back = onCleanup(@() warning(state));
    done = osimcontact.rescale({'human.osim', 'decimal comma.osim', 'gone.osim'}, 'target_mass', 500, 'output_dir', 'out');
    must(numel(done) == 3 && isempty(done(1).error) && numel(done(1).changes) == 72, 'the first is not done');
    must(strcmp(done(2).error.code, 'not-a-number') && isequal([done(2).error.line done(2).error.column], [30 17]), ...
        'the error of the second is another one');
    must(strcmp(done(3).error.code, 'unreadable') && isnan(done(3).error.line), 'the error of the third is another one');
    must(isempty(done(3).changes) && isfield(done(3).changes, 'factor') && isnan(done(3).target_mass_kg), ...
        'a failed model has not the fields of the others');
end

function explanations_of_all_kinds()
    known = osimcontact.explain({'C.2', 'stiffness', 'floats', 'no-contacts'});
    must(isequal({known.kind}, {'equation', 'quantity', 'finding', 'error'}), 'kinds differ');
    must(strcmp(known(1).formulas(1).formula(1:2), 'cf') && isempty(known(2).formulas), 'formulas differ');
    must(numel(osimcontact.explain()) > 100, 'without a name it is everything');
end

function series_are_columns()
    fall = osimcontact.drop_test('falisse2022', 'samples', 101);
    must(isequal(size(fall.series.time_s), [101 1]) && fall.series.time_s(1) == 0, 'the series differs');
    must(isnan(fall.compare.force_bw), 'nothing was compared');
    found = osimcontact.fit('measured.csv', 'radius', 0.03, 'indentation_unit', 'mm');
    count = numel(found.parameters);
    must(isequal(size(found.covariance), [count count]) && isequal(found.covariance, found.covariance'), ...
        'the covariance is not a symmetric matrix');
end

function only_a_fit_has_errors_of_the_fit()
    done = osimcontact.rescale('human.osim', 'target_mass', 500, 'dry_run', true);
    must(~isfield(done, 'errors') && isempty(done.fit_errors) && isfield(done.fit_errors, 'cop_rms_m'), 'a change has errors of a fit');
    done = osimcontact.fit('walker.osim', 'motion', 'walk.mot', 'plates', 'plates.sto', 'dry_run', true);
    must(isscalar(done.fit_errors) && done.fit_errors.vertical_rms_bw >= 0, 'a fit has no errors');
    errors = done.fit_errors;
    must(numel(errors.feet) == 2 && max([errors.feet.vertical_rms_bw]) == errors.vertical_rms_bw, 'feet differ');
    must(isequal({errors.parameters.name}, {'stiffness_factor', 'dissipation_s_m', 'floor_up_m'}) ...
        && all([errors.parameters.written]) && numel(errors.correlations) == 3, 'parameters differ');
end

function columns_of_results()
    seen = osimcontact.inspect({'human.osim', 'horse.osim'});
    shape = osimcontact.internal.shapes('inspection');
    columns = osimcontact.internal.as_columns(seen, shape);
    must(isequal(columns.mass_kg, [62; 545]) && isequal(columns.contacts_mass_kg_source, {'bodies'; 'bodies'}), 'columns differ');
    must(isequal(columns.spheres, [12; 20]), 'a list is not its number of entries');
    columns = osimcontact.internal.as_columns(seen, shape, 'spheres');
    must(isequal(size(columns.radius_m), [32 1]) && strcmp(columns.model{13}, 'horse.osim'), 'rows of spheres differ');
    must(isequal(size(columns.location_m), [32 3]), 'a place is not three columns');
    columns = osimcontact.internal.as_columns(seen, shape, 'forces');
    must(iscellstr(columns.spheres) && isequal(size(columns.parameters_stiffness), [numel(columns.model) 1]), 'forces differ');
    must_throw('osimcontact:usage', @() osimcontact.internal.as_columns(seen, shape, 'nothing'));
    % Nothing changes whole objects here: a table without rows, which has its columns.
    done = osimcontact.rescale('human.osim', 'target_mass', 500, 'dry_run', true);
    columns = osimcontact.internal.as_columns(done, osimcontact.internal.shapes('change'), 'objects');
    must(isempty(columns.path) && isequal(size(columns.model), [0 1]) && isfield(columns, 'radius_m'), 'no rows differ');
    none = osimcontact.inspect('no contacts.osim');
    columns = osimcontact.internal.as_columns(none, shape, 'forces');
    must(isempty(columns.name) && isequal(size(columns.model), [0 1]), 'no forces differ');
    columns = osimcontact.internal.as_columns(none([]), shape, 'spheres');
    must(isempty(columns.radius_m) && isfield(columns, 'model'), 'no models differ');
    % One model that failed, and two that have one finding each: a list of one is a list.
    [full, numbers] = osimcontact.internal.json_values({'{"model":"a","findings":[{"code":"floats"}]}', ...
        '{"model":"b","findings":[{"code":"floats"}],"error":[{"code":"x","line":3}]}'});
    failure = osimcontact.internal.shapes('failure');
    shape = osimcontact.internal.shapes('change');
    shape.error = {failure.error};
    columns = osimcontact.internal.as_columns(osimcontact.internal.complete_fields(full, {shape}, numbers), shape);
    must(isequal(columns.findings, [1; 1]) && isequal(columns.error_code, {''; 'x'}), 'findings and errors differ');
    must(isnan(columns.error_line(1)) && columns.error_line(2) == 3, 'lines differ');
end

function tables_are_made_of_columns()
    if ~exist('OCTAVE_VERSION', 'builtin')
        seen = osimcontact.inspect({'human.osim', 'horse.osim'}, 'AsTable', true);
        must(istable(seen) && isequal(seen.mass_kg, [62; 545]), 'it is not a table');
        return
    end
    seen = osimcontact.inspect({'human.osim', 'horse.osim'}, 'AsTable', true);
    must(isequal(seen.mass_kg, [62; 545]), 'it is not a struct of columns');
end

function findings_are_said_once()
    lastwarn('', '');
    % Both are right for 53 kg already, which is a warning, and have two feet with one force for several spheres, which is a remark.
    printed = evalc('osimcontact.rescale({''one force.osim'', ''one force too.osim''}, ''target_mass'', 53, ''dry_run'', true);');
    [message, identifier] = lastwarn();
    must(strcmp(identifier, 'osimcontact:already_at_target') && ~isempty(strfind(message, '(and 1 more')), ...
        '%s: %s', identifier, message);
    must(~isempty(regexp(printed, 'remark: one force.osim: [^\n]*\(and 1 more: see', 'once')), 'it printed: %s', printed);
    lastwarn('', '');
    evalc('osimcontact.rescale(''one force.osim'', ''target_mass'', 500, ''dry_run'', true);');
    must(isempty(lastwarn()), 'a remark was raised: %s', lastwarn());
end

function tables_of_the_program()
    [status, ~] = system(['"' osimcontact.program() '" inspect human.osim horse.osim --format csv > all.csv']);
    columns = osimcontact.read_table('all.csv');
    must(status == 0 && isequal(unique(columns.mass_kg), [62; 545]) && numel(columns.sphere) == 32, 'columns differ');
    seen = osimcontact.inspect('human.osim');
    of_human = [seen.figures.limbs(1).spheres.load_n]';
    must(isequal(columns.load_at_1_body_weight_N(1:numel(of_human)), of_human), 'loads have other bits');
    file = fopen('odd.csv', 'w');
    fprintf(file, 'a,"b ""c"", d",1e\r\n1,"x,\ny",\n2.5,,3\n');
    fclose(file);
    columns = osimcontact.read_table('odd.csv');
    must(isequal(columns.a, [1; 2.5]) && isequal(columns.b__c___d, {sprintf('x,\ny'); ''}), 'cells differ');
    must(isnan(columns.x1e(1)) && columns.x1e(2) == 3, 'an empty cell is not NaN');
    % Sides, and what a German spreadsheet writes: no numbers.
    file = fopen('texts.csv', 'w');
    fprintf(file, '#side,#dose,mass,odd\ni,"0,5",-1.5e3,inf\nj,"1,25",.5,NaN\n');
    fclose(file);
    columns = osimcontact.read_table('texts.csv');
    must(isequal(columns.x_side, {'i'; 'j'}) && isequal(columns.x_dose, {'0,5'; '1,25'}), 'texts became numbers');
    must(isequal(columns.mass, [-1500; 0.5]) && columns.odd(1) == Inf && isnan(columns.odd(2)), 'numbers became texts');
    file = fopen('short.csv', 'w');
    fprintf(file, 'a,b\n1,2\n3\n');
    fclose(file);
    must_throw('osimcontact:unreadable', @() osimcontact.read_table('short.csv'));
    must_throw('osimcontact:unreadable', @() osimcontact.read_table('gone.csv'));
end

function texts_of_json()
    text = ['"x\"y\\z\/\u0007\ud83d\ude00' native2unicode(uint8([195 169]), 'UTF-8') '"'];
    values = osimcontact.internal.json_values({text});
    % U+1F600 is F0 9F 98 80 in UTF-8.
    must(isequal(unicode2native(values{1}, 'UTF-8'), uint8([double('x"y\z/') 7 240 159 152 128 195 169])), 'another text');
    values = osimcontact.internal.json_values({'{"a":true}', '{}', '{"b":[],"c":{"d":null}}'});
    must(values{1}.a && isempty(fieldnames(values{2})) && isempty(values{3}.c.d), 'values without numbers');
    for broken = {'{"a":1', '[1,', '', '{"a":1}}', 'nonsense', '{"a":[true}', '{"a":1.2.3}', '{"a":1-2}', '{"a":-}', '[1 2]'}
        must_throw('osimcontact:programFailed', @() osimcontact.internal.json_values(broken));
    end
end

function real_models()
    corpus = getenv('OSIM_CORPUS');
    if isempty(corpus)
        error('test:skipped', 'published models in Octave: models of other people are not part of the project');
    end
    state = warning('off', 'all');
    back = onCleanup(@() warning(state));
    seen = osimcontact.inspect(corpus);
    must(numel(seen) > 20 && all(strcmp(class([seen.mass_kg]), 'double')), 'there are %d models', numel(seen));
    must(numel([seen.mass_kg]) == numel(seen), 'a mass was lost');
    columns = osimcontact.internal.as_columns(seen, osimcontact.internal.shapes('inspection'), 'forces');
    must(numel(columns.model) == numel(vertcat(seen.forces)), 'a force was lost');
end
