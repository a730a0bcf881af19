function verb = verb_declaration(name)
%VERB_DECLARATION The declaration of a function of this package: its options, positional arguments and results.

% Made by dev/generate_matlab.py from the schemas of requests and results: change those, and run it.
    switch name
        case 'add'
            verb.verb = 'add';
            verb.positional = {'models'};
            verb.required = 1;
            verb.table = 'contacts';
            verb.result = 'change';
            verb.without = {};
            verb.flags = {'default_pose', 'friction', 'level', 'replace', 'skip_disabled', 'in_place', 'no_backup', 'force', 'no_note', 'dry_run', 'resume'};
            verb.options = {'models', 'from', 'contacts', 'default_pose', 'feet', 'count', 'pad', 'geometry_dir', 'mirror', ...
                'class', 'friction', 'radius', 'body_scale', 'body_map', 'level', 'replace', 'select', 'exclude', ...
                'skip_disabled', 'indentation', 'young', 'poisson', 'restitution', 'impact_speed', ...
                'constant_indentation', 'state_width', 'speed_width', 'threshold', 'static_friction', ...
                'dynamic_friction', 'viscous_friction', 'transition_velocity', 'load', 'body_weights', 'gravity', ...
                'spheres', 'stance_limbs', 'reference_mass', 'reference_spheres', 'reference_gravity', ...
                'reference_select', 'reference_sphere', 'contacts_mass', 'mass', 'exclude_body', 'output', ...
                'geometry_output', 'output_dir', 'in_place', 'no_backup', 'force', 'no_note', 'dry_run', 'report', ...
                'jobs', 'summary', 'resume', 'shard', 'yes', 'as_table'};
        case 'batch'
            verb.verb = 'batch';
            verb.positional = {'manifest'};
            verb.required = 1;
            verb.table = 'manifest';
            verb.result = 'change';
            verb.without = {};
            verb.flags = {'in_place', 'no_backup', 'force', 'no_note', 'allow_outside', 'dry_run', 'resume'};
            verb.options = {'manifest', 'output', 'geometry_output', 'output_dir', 'in_place', 'no_backup', 'force', 'no_note', ...
                'allow_outside', 'dry_run', 'report', 'jobs', 'summary', 'resume', 'shard', 'yes', 'as_table'};
        case 'check'
            verb.verb = 'check';
            verb.positional = {'models'};
            verb.required = 1;
            verb.table = '';
            verb.result = 'check';
            verb.without = {};
            verb.flags = {'fix', 'in_place', 'force', 'skip_disabled'};
            verb.options = {'models', 'from', 'body_scale_file', 'moco_setup', 'from_moco_setup', 'motion', 'plates', 'loads', ...
                'angles', 'fix', 'output', 'output_dir', 'in_place', 'report', 'force', 'spheres', 'stance_limbs', ...
                'impact_speed', 'gravity', 'contacts_mass', 'mass', 'exclude_body', 'select', 'exclude', ...
                'skip_disabled', 'geometry', 'model', 'yes', 'as_table'};
        case 'convert'
            verb.verb = 'convert';
            verb.positional = {'models'};
            verb.required = 1;
            verb.table = '';
            verb.result = 'change';
            verb.without = {};
            verb.flags = {'sockets', 'strict', 'skip_disabled', 'in_place', 'no_backup', 'force', 'no_note', 'dry_run', 'resume'};
            verb.options = {'models', 'to', 'sockets', 'constant_contact_force', 'hertz_smoothing', 'hunt_crossley_smoothing', ...
                'strict', 'select', 'exclude', 'skip_disabled', 'output', 'geometry_output', 'output_dir', ...
                'in_place', 'no_backup', 'force', 'no_note', 'dry_run', 'report', 'jobs', 'summary', 'resume', ...
                'shard', 'yes', 'as_table'};
        case 'design'
            verb.verb = 'design';
            verb.positional = {'models'};
            verb.required = 0;
            verb.table = '';
            verb.result = 'change';
            verb.without = {'models', 'design'};
            verb.flags = {'skip_disabled', 'in_place', 'no_backup', 'force', 'no_note', 'dry_run', 'resume'};
            verb.options = {'models', 'radius', 'indentation', 'contact_stiffness', 'young', 'poisson', 'stiffness', ...
                'restitution', 'impact_speed', 'constant_indentation', 'state_width', 'speed_width', 'threshold', ...
                'dimensionless_stiffness', 'stress', 'other_young', 'other_poisson', 'state_smoothing', ...
                'speed_smoothing', 'load', 'body_weights', 'gravity', 'contacts_mass', 'mass', 'exclude_body', ...
                'spheres', 'stance_limbs', 'select', 'exclude', 'skip_disabled', 'output', 'geometry_output', ...
                'output_dir', 'in_place', 'no_backup', 'force', 'no_note', 'dry_run', 'report', 'jobs', 'summary', ...
                'resume', 'shard', 'yes', 'geometry', 'model', 'as_table'};
        case 'drop_test'
            verb.verb = 'drop-test';
            verb.positional = {'subject'};
            verb.required = 0;
            verb.table = '';
            verb.result = 'drop-test';
            verb.without = {};
            verb.flags = {'skip_disabled'};
            verb.options = {'subject', 'height', 'duration', 'samples', 'compare', 'compare_spheres', 'foot_mass', 'presets', ...
                'radius', 'stiffness', 'dissipation', 'constant_contact_force', 'hertz_smoothing', ...
                'hunt_crossley_smoothing', 'gravity', 'spheres', 'stance_limbs', 'contacts_mass', 'mass', ...
                'exclude_body', 'select', 'exclude', 'skip_disabled', 'geometry', 'model', 'yes', 'as_table'};
        case 'explain'
            verb.verb = 'explain';
            verb.positional = {'topics'};
            verb.required = 0;
            verb.table = '';
            verb.result = 'explanation';
            verb.without = {};
            verb.flags = {};
            verb.options = {'topics', 'as_table'};
        case 'fit'
            verb.verb = 'fit';
            verb.positional = {'file'};
            verb.required = 1;
            verb.table = 'file';
            verb.result = 'change';
            verb.without = {'motion', 'fit'};
            verb.flags = {'unbounded', 'skip_disabled', 'in_place', 'no_backup', 'force', 'no_note', 'dry_run', 'resume'};
            verb.options = {'file', 'motion', 'plates', 'loads', 'fit', 'unbounded', 'height_in', 'belt', 'belt_column', ...
                'start', 'end', 'angles', 'low_pass', 'plates_delay', 'radius', 'spheres', 'onset', 'branch', ...
                'indentation_column', 'force_column', 'speed_column', 'time_column', 'indentation_unit', ...
                'force_unit', 'speed_unit', 'time_unit', 'contacts_mass', 'mass', 'exclude_body', 'select', ...
                'exclude', 'skip_disabled', 'output', 'geometry_output', 'output_dir', 'in_place', 'no_backup', ...
                'force', 'no_note', 'dry_run', 'report', 'jobs', 'summary', 'resume', 'shard', 'yes', 'geometry', ...
                'model', 'as_table'};
        case 'inspect'
            verb.verb = 'inspect';
            verb.positional = {'models'};
            verb.required = 1;
            verb.table = '';
            verb.result = 'inspection';
            verb.without = {};
            verb.flags = {'force', 'skip_disabled'};
            verb.options = {'models', 'from', 'body_scale_file', 'target_mass', 'report', 'force', 'spheres', 'stance_limbs', ...
                'impact_speed', 'gravity', 'contacts_mass', 'mass', 'exclude_body', 'select', 'exclude', ...
                'skip_disabled', 'geometry', 'model', 'yes', 'as_table'};
        case 'motion'
            verb.verb = 'motion';
            verb.positional = {'subject', 'motion'};
            verb.required = 2;
            verb.table = '';
            verb.result = 'motion';
            verb.without = {};
            verb.flags = {'vertical', 'force', 'skip_disabled'};
            verb.options = {'subject', 'motion', 'plates', 'loads', 'angles', 'low_pass', 'plates_delay', 'belt', ...
                'belt_column', 'start', 'end', 'correct', 'vertical', 'floor', 'moco', 'nmsm', 'error', 'output', ...
                'force', 'contacts_mass', 'mass', 'exclude_body', 'select', 'exclude', 'skip_disabled', 'geometry', ...
                'model', 'as_table'};
        case 'note'
            verb.verb = 'note';
            verb.positional = {'models'};
            verb.required = 1;
            verb.table = '';
            verb.result = 'change';
            verb.without = {};
            verb.flags = {'in_place', 'no_backup', 'force', 'no_note', 'dry_run', 'resume'};
            verb.options = {'models', 'contacts_mass', 'contacts_gravity', 'stance_limbs', 'output', 'geometry_output', ...
                'output_dir', 'in_place', 'no_backup', 'force', 'no_note', 'dry_run', 'report', 'jobs', 'summary', ...
                'resume', 'shard', 'yes', 'geometry', 'model', 'as_table'};
        case 'plot'
            verb.verb = 'plot';
            verb.positional = {'kind', 'models'};
            verb.required = 1;
            verb.table = 'table';
            verb.result = '';
            verb.without = {};
            verb.flags = {'force', 'skip_disabled'};
            verb.options = {'kind', 'models', 'output', 'data', 'force', 'target_mass', 'axes', 'geometry_dir', 'motion', ...
                'plates', 'loads', 'angles', 'presets', 'gravity', 'height', 'duration', 'quantity', 'stiffness', ...
                'dissipation', 'table', 'value_column', 'x_column', 'y_column', 'value_range', 'title', 'label', ...
                'width', 'font_size', 'x_range', 'y_range', 'dpi', 'spheres', 'stance_limbs', 'contacts_mass', ...
                'mass', 'exclude_body', 'select', 'exclude', 'skip_disabled', 'geometry', 'model', 'yes', ...
                'as_table'};
        case 'presets'
            verb.verb = 'presets';
            verb.positional = {'name'};
            verb.required = 0;
            verb.table = '';
            verb.result = 'preset';
            verb.without = {};
            verb.flags = {};
            verb.options = {'name', 'presets', 'as_table'};
        case 'remove'
            verb.verb = 'remove';
            verb.positional = {'models'};
            verb.required = 1;
            verb.table = '';
            verb.result = 'change';
            verb.without = {};
            verb.flags = {'skip_disabled', 'in_place', 'no_backup', 'force', 'no_note', 'dry_run', 'resume'};
            verb.options = {'models', 'select', 'exclude', 'skip_disabled', 'output', 'geometry_output', 'output_dir', ...
                'in_place', 'no_backup', 'force', 'no_note', 'dry_run', 'report', 'jobs', 'summary', 'resume', ...
                'shard', 'yes', 'as_table'};
        case 'reproduce'
            verb.verb = 'reproduce';
            verb.positional = {};
            verb.required = 0;
            verb.table = '';
            verb.result = 'reproduction';
            verb.without = {};
            verb.flags = {'force'};
            verb.options = {'output_dir', 'force', 'as_table'};
        case 'rescale'
            verb.verb = 'rescale';
            verb.positional = {'models'};
            verb.required = 1;
            verb.table = '';
            verb.result = 'change';
            verb.without = {};
            verb.flags = {'level', 'friction', 'follow_bodies', 'skip_disabled', 'in_place', 'no_backup', 'force', 'no_note', 'dry_run', 'resume'};
            verb.options = {'models', 'target_mass', 'contacts_mass', 'mass', 'exclude_body', 'radius', 'level', 'level_axis', ...
                'only', 'keep', 'dissipation_by', 'friction', 'contacts_gravity', 'target_gravity', ...
                'body_scale_file', 'follow_bodies', 'select', 'exclude', 'skip_disabled', 'output', ...
                'geometry_output', 'output_dir', 'in_place', 'no_backup', 'force', 'no_note', 'dry_run', 'report', ...
                'jobs', 'summary', 'resume', 'shard', 'yes', 'geometry', 'model', 'as_table'};
        case 'set'
            verb.verb = 'set';
            verb.positional = {'models'};
            verb.required = 1;
            verb.table = '';
            verb.result = 'change';
            verb.without = {};
            verb.flags = {'level', 'skip_disabled', 'in_place', 'no_backup', 'force', 'no_note', 'dry_run', 'resume'};
            verb.options = {'models', 'set', 'level', 'contacts_mass', 'mass', 'exclude_body', 'select', 'exclude', ...
                'skip_disabled', 'output', 'geometry_output', 'output_dir', 'in_place', 'no_backup', 'force', ...
                'no_note', 'dry_run', 'report', 'jobs', 'summary', 'resume', 'shard', 'yes', 'geometry', 'model', ...
                'as_table'};
        case 'sweep'
            verb.verb = 'sweep';
            verb.positional = {'model'};
            verb.required = 1;
            verb.table = '';
            verb.result = 'sweep';
            verb.without = {};
            verb.flags = {'force', 'resume', 'no_note', 'dry_run', 'skip_disabled'};
            verb.options = {'model', 'grid', 'ladder', 'soft', 'point', 'shard', 'output_dir', 'force', 'resume', 'no_note', ...
                'dry_run', 'jobs', 'radius', 'indentation', 'contact_stiffness', 'young', 'poisson', 'stiffness', ...
                'restitution', 'impact_speed', 'constant_indentation', 'state_width', 'speed_width', 'threshold', ...
                'load', 'body_weights', 'gravity', 'contacts_mass', 'mass', 'exclude_body', 'spheres', ...
                'stance_limbs', 'select', 'exclude', 'skip_disabled', 'yes', 'as_table'};
        case 'transfer'
            verb.verb = 'transfer';
            verb.positional = {'models'};
            verb.required = 1;
            verb.table = '';
            verb.result = 'change';
            verb.without = {};
            verb.flags = {'follow_bodies', 'strict', 'level', 'friction', 'skip_disabled', 'in_place', 'no_backup', 'force', 'no_note', 'dry_run', 'resume'};
            verb.options = {'models', 'from', 'presets', 'spheres', 'stance_limbs', 'reference_mass', 'reference_spheres', ...
                'reference_gravity', 'reference_select', 'reference_sphere', 'follow_bodies', 'body_scale_file', ...
                'body_scale', 'radius_axis', 'moved_spheres', 'strict', 'rule', 'height_ratio', 'contacts_mass', ...
                'mass', 'exclude_body', 'radius', 'level', 'level_axis', 'only', 'keep', 'dissipation_by', ...
                'friction', 'contacts_gravity', 'target_gravity', 'select', 'exclude', 'skip_disabled', 'output', ...
                'geometry_output', 'output_dir', 'in_place', 'no_backup', 'force', 'no_note', 'dry_run', 'report', ...
                'jobs', 'summary', 'resume', 'shard', 'yes', 'geometry', 'model', 'as_table'};
        otherwise
            error('osimcontact:usage', 'there is no verb ''%s''', name);
    end
    verb.name = name;
    verb.gives_json = ~isempty(verb.result);
    verb.left_out = {'diff', 'format', 'quiet', 'deny', 'full', 'ascii'};
end
