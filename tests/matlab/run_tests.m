function run_tests(only)
%RUN_TESTS Test the package in matlab/: from the top folder of the project,
%       octave --no-gui --norc --eval "cd tests/matlab; run_tests"
%   The program is that of OSIM_CONTACT_SCALE, else target/release/osim-contact-scale; the package is the one in
%   OSIMCONTACT_FOLDER, else matlab/. With the name of a file, such as run_tests('test_paths'), only its tests are run. Ends with one line of counts, and with an error if a test failed.

    here = fileparts(mfilename('fullpath'));
    root = fileparts(fileparts(here));
    if isempty(getenv('OSIM_CONTACT_SCALE'))
        setenv('OSIM_CONTACT_SCALE', fullfile(root, 'target', 'release', 'osim-contact-scale'));
    end
    % Octave takes osimcontact.set for a function that hides its own set, which it does not.
    warning('off', 'Octave:shadowed-function');
    package = getenv('OSIMCONTACT_FOLDER');
    if isempty(package)
        package = fullfile(root, 'matlab');
    end
    addpath(here, package, fullfile(here, 'opensim_stand_in'));

    files = dir(fullfile(here, 'test_*.m'));
    counts = struct('passed', 0, 'failed', 0, 'skipped', 0);
    for i = 1:numel(files)
        [~, name] = fileparts(files(i).name);
        if nargin > 0 && ~strcmp(only, name)
            continue
        end
        tests = feval(name);
        for j = 1:numel(tests)
            outcome = run_one(root, name, tests{j});
            counts.(outcome) = counts.(outcome) + 1;
        end
    end
    cannot_be_run = not_run();
    for i = 1:size(cannot_be_run, 1)
        fprintf('skipped: %s: %s\n', cannot_be_run{i, :});
        counts.skipped = counts.skipped + 1;
    end
    fprintf('%d passed, %d failed, %d skipped\n', counts.passed, counts.failed, counts.skipped);
    if counts.failed > 0 || counts.passed == 0
        exit(1);
    end
end

function outcome = run_one(root, file, test)
    name = [file '.' func2str(test)];
    before = pwd();
    program = getenv('OSIM_CONTACT_SCALE');
    path = getenv('PATH');
    bench = tempname();
    mkdir(bench);
    cleaner = onCleanup(@() put_back(before, program, path, bench));
    copy_models(root, bench);
    cd(bench);
    try
        test();
        outcome = 'passed';
    catch problem
        if strcmp(problem.identifier, 'test:skipped')
            outcome = 'skipped';
            fprintf('skipped: %s\n', problem.message);
        else
            outcome = 'failed';
            fprintf('FAILED: %s: [%s] %s\n', name, problem.identifier, problem.message);
            for i = 1:numel(problem.stack)
                fprintf('    %s, line %d\n', problem.stack(i).name, problem.stack(i).line);
            end
        end
    end
end

function put_back(before, program, path, bench)
    cd(before);
    setenv('OSIM_CONTACT_SCALE', program);
    setenv('PATH', path);
    if exist('OCTAVE_VERSION', 'builtin')
        confirm_recursive_rmdir(false, 'local');
    end
    rmdir(bench, 's');
end

function copy_models(root, bench)
    copies = {'table1/human_62kg_smooth_sphere.osim', 'human.osim'; ...
        'table1/emu_10_spheres_smooth_sphere.osim', 'emu.osim'; ...
        'table1/horse_hunt_crossley.osim', 'horse.osim'; ...
        'feet/human_40000.osim', 'no contacts.osim'; ...
        'format/v40000.osim', 'one force.osim'; ...
        'format/v40000.osim', 'one force too.osim'; ...
        'bad/number_decimal_comma.osim', 'decimal comma.osim'; ...
        'measured/heel_pad.csv', 'measured.csv'
        'motion/plates.sto', 'plates.sto'
        'motion/walker.osim', 'walker.osim'
        'motion/walk.mot', 'walk.mot'};
    for i = 1:size(copies, 1)
        copyfile(fullfile(root, 'fixtures', copies{i, 1}), fullfile(bench, copies{i, 2}));
    end
    file = fopen(fullfile(bench, 'masses.csv'), 'w');
    fprintf(file, 'model,target_mass\nhuman.osim,500\nemu.osim,40\n');
    fclose(file);
end

function list = not_run()
    list = {};
    if exist('OCTAVE_VERSION', 'builtin')
        list = {'the MATLAB package in MATLAB', 'there is no MATLAB here; its language was kept to what both have'; ...
            'tables of MATLAB', 'GNU Octave has no table; their columns are tested'; ...
            'osimcontact.apply with OpenSim''s own bindings for MATLAB', ...
            'they need MATLAB; a stand-in has the calls, and tests/oracle/test_live_model.py tries them in Python'};
    end
end
