function results = table_of_masses(table_file, output_folder)
%TABLE_OF_MASSES Scale every model of a table; a model that fails does not stop the others.
%   The table is a CSV file: a header, then in each line a model, the mass its contacts stand for, and the wanted mass:
%
%       model,contacts_mass,target_mass
%       human.osim,62,500
%
%   results is a struct array with the fields model, output, factor (of the stiffness) and problem.

    file = fopen(table_file, 'r');
    if file < 0
        error('table_of_masses:file', 'cannot open %s', table_file);
    end
    columns = textscan(file, '%s %f %f', 'Delimiter', ',', 'HeaderLines', 1);
    fclose(file);
    [models, from, to] = deal(columns{:});
    if ~exist(output_folder, 'dir')
        mkdir(output_folder);
    end

    results = struct('model', models, 'output', '', 'factor', NaN, 'problem', '');
    for i = 1:numel(models)
        [folder, name] = fileparts(models{i}); %#ok<ASGLU>
        output = fullfile(output_folder, sprintf('%s_%gkg.osim', name, to(i)));
        try
            done = contact_scale(models{i}, '--contacts-mass', from(i), '--target-mass', to(i), '-o', output, '--force');
            done = done{1};
            if isfield(done, 'error')
                results(i).problem = done.error.message;
                continue
            end
            results(i).output = done.output;
            if isempty(done.changes)
                continue
            end
            is_stiffness = strcmp({done.changes.property}, 'stiffness');
            factors = [done.changes(is_stiffness).factor];
            results(i).factor = factors(1);
        catch problem
            % Wrong usage, such as a mass of 0.
            results(i).problem = problem.message;
        end
    end
end
