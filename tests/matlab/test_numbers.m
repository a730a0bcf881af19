function tests = test_numbers()
%TEST_NUMBERS Numbers keep all their bits on both ways.
    tests = {@literals_have_the_bits_that_ieee_754_gives_them, @every_number_comes_back_from_its_text, ...
        @requests_and_answers_have_all_digits, @answers_have_the_bits_of_their_text, @what_json_has_not_is_refused, ...
        @values_are_written_as_requests_have_them};
end

function literals_have_the_bits_that_ieee_754_gives_them()
    % From the standard: nearest double, ties to even, least and largest numbers.
    bits = {'0.1', '3fb999999999999a'; '0.30000000000000004', '3fd3333333333334'; '1e22', '4480f0cf064dd592'; ...
        '1e23', '44b52d02c7e14af6'; '9007199254740993', '4340000000000000'; '5e-324', '0000000000000001'; ...
        '2.2250738585072011e-308', '000fffffffffffff'; '1.7976931348623157e308', '7fefffffffffffff'; ...
        '-0.0', '8000000000000000'; '1E+2', '4059000000000000'};
    for i = 1:size(bits, 1)
        for text = {bits{i, 1}, ['[' bits{i, 1} ']'], ['{"true":[true,' bits{i, 1} ',false]}']}
            value = numbers_of(text{1});
            must(strcmp(num2hex(value), bits{i, 2}), '%s is %s', text{1}, num2hex(value));
        end
    end
end

function every_number_comes_back_from_its_text()
    rand('twister', 7);
    bytes = uint8(floor(256 * rand(8, 5000)));
    numbers = typecast(bytes(:), 'double');
    numbers = numbers(isfinite(numbers));
    must(numel(numbers) > 4900, 'there are too few numbers');
    text = osimcontact.internal.json_text(numbers, 'numbers');
    must(isequal(numbers_of(text), numbers), 'in a list they differ');
    for i = 1:100
        text = osimcontact.internal.json_text(numbers(i), 'number');
        must(isequal(numbers_of(text), numbers(i)), '%s is another number', text);
    end
end

function numbers = numbers_of(text)
    % As fields get them, whatever they are in.
    [values, numbers] = osimcontact.internal.json_values({text});
    value = values{1};
    if isstruct(value)
        value = value.true{2};
    end
    numbers = osimcontact.internal.complete_fields(value, 'numbers', numbers);
end

function requests_and_answers_have_all_digits()
    % A number whose last bit is lost with 16 digits or less.
    stiffness = 1e6 * (0.1 + 0.2);
    must(~strcmp(num2hex(stiffness), num2hex(3e5)), 'this number tests nothing');
    done = osimcontact.set('human.osim', 'set', struct('stiffness', stiffness), 'dry_run', true);
    must(numel(done.changes) == 12 && all([done.changes.to] == stiffness), 'the stiffness is %.17g', done.changes(1).to);
    done = osimcontact.rescale('human.osim', 'target_mass', stiffness / 1000, 'dry_run', true);
    must(done.target_mass_kg == stiffness / 1000, 'the mass is %.17g', done.target_mass_kg);
end

function answers_have_the_bits_of_their_text()
    % The program itself, and str2double on its text.
    [~, text] = system(['"' osimcontact.program() '" rescale human.osim --target-mass 1190 --dry-run --format json']);
    literals = regexp(text, '"to":([-+.0-9eE]+),"factor":([-+.0-9eE]+)', 'tokens');
    literals = vertcat(literals{:});
    % A radius, a stiffness, a dissipation and three numbers of smoothing for each of 12 spheres.
    must(size(literals, 1) == 72, 'there are %d changes', size(literals, 1));
    done = osimcontact.rescale('human.osim', 'target_mass', 1190, 'dry_run', true);
    must(isequal([done.changes.to]', str2double(literals(:, 1))), 'values differ');
    must(isequal([done.changes.factor]', str2double(literals(:, 2))), 'factors differ');
end

function what_json_has_not_is_refused()
    for value = {zeros(0, 1), NaN, Inf, 1i, [1 NaN], struct('stiffness', NaN), {{NaN}}, ones(2), struct('a', {1, 2}), @sin, ['ab'; 'cd']}
        message = must_throw('osimcontact:usage', @() osimcontact.rescale('human.osim', 'TargetMass', value{1}));
        must(~isempty(strfind(message, '''TargetMass')), 'the option is not named: %s', message);
    end
end

function values_are_written_as_requests_have_them()
    map = containers.Map();
    map('a "b"') = 1;
    cases = {4, '4'; int32(-7), '-7'; single(0.5), '0.5'; true, 'true'; [1 2.5], '[1,2.5]'; {'a', 2}, '["a",2]'; {}, '[]'; ...
        '', '""'; sprintf('a\tb\\"'), '"a\u0009b\\\""'; struct('x', {{1}}), '{"x":[1]}'; map, '{"a \"b\"":1}'};
    for i = 1:size(cases, 1)
        text = osimcontact.internal.json_text(cases{i, 1}, 'value');
        must(strcmp(text, cases{i, 2}), '%s, expected %s', text, cases{i, 2});
    end
end
