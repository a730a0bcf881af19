function new_stiffness = look_and_rescale(model, contacts_mass, target_mass, output)
%LOOK_AND_RESCALE Show the contacts of a model, scale them, and say what changed.
%   look_and_rescale('mouse.osim', 62, 0.0209, 'mouse with small contacts.osim')

    % What is there?
    seen = contact_scale('inspect', model);
    seen = seen{1};
    if isfield(seen, 'error')
        error('look_and_rescale:model', '%s: %s', seen.model, seen.error.message);
    end
    fprintf('%s weighs %g kg and has %d contact forces\n', seen.name, seen.mass_kg, numel(seen.forces));

    % Scale. Warnings are for you to read.
    done = contact_scale(model, '--contacts-mass', contacts_mass, '--target-mass', target_mass, '-o', output, '--force');
    done = done{1};
    if isfield(done, 'error')
        error('look_and_rescale:model', '%s: %s', done.model, done.error.message);
    end
    for i = 1:numel(done.warnings)
        fprintf('warning: %s [%s]\n', done.warnings(i).message, done.warnings(i).code);
    end

    if isempty(done.changes)
        fprintf('nothing to change\n');
        new_stiffness = [];
        return
    end

    % One struct for each number that changed.
    is_stiffness = strcmp({done.changes.property}, 'stiffness');
    stiffness = done.changes(is_stiffness);
    fprintf('stiffness of %s: %g -> %g N/m^2, by equation (%s)\n', ...
        stiffness(1).force, stiffness(1).from, stiffness(1).to, stiffness(1).equation);
    new_stiffness = stiffness(1).to;
end
