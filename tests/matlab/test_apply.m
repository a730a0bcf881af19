function tests = test_apply()
%TEST_APPLY osimcontact.apply with a stand-in for OpenSim's bindings: the calls of it that apply makes, and nothing else.
%   tests/oracle/test_live_model.py makes the same calls of OpenSim itself, in Python. They are, in github.com/opensim-org/opensim-core,
%   commit 0435b081dc383498e217f92ca63bb97616145c14: Bindings/PropertyHelper.h, lines 72 to 75 and 103 to 113; in OpenSim/Common,
%   Component.h, line 896, Object.h, line 337, and AbstractProperty.h, line 217; OpenSim/Simulation/Model/Model.h, line 640.
    tests = {@every_change_is_made, @places_have_three_numbers, @nothing_is_changed_where_the_model_is_another_one, ...
        @a_component_that_is_not_there, @a_note_that_goes, @what_cannot_be_applied};
end

function every_change_is_made()
    state = warning('off', 'all');
    back = onCleanup(@() warning(state));
    for name = {'human.osim', 'horse.osim'}
        planned = osimcontact.rescale(name{1}, 'target_mass', 200, 'dry_run', true, 'friction', true);
        [model, values] = live(planned.changes);
        osimcontact.apply(model, planned);
        for change = planned.changes'
            must(isequal(values(key_of(change)), change.to), '%s of %s is not set', change.property, change.path);
        end
        % Without the note, the next call would take the contacts for those of before.
        must(~isempty(strfind(values('credits'), '[contacts made for 200 kg')), 'the note is %s', values('credits'));
    end
end

function places_have_three_numbers()
    planned = osimcontact.rescale('human.osim', 'target_mass', 200, 'dry_run', true, 'level', true);
    places = planned.changes(strcmp({planned.changes.property}, 'location'));
    must(numel(places) == 12 && isequal(size(places(1).to), [3 1]), 'there are other places');
    [model, values] = live(planned.changes);
    osimcontact.apply(model, planned);
    must(isequal(values(key_of(places(1))), places(1).to), 'the place is not set');
end

function nothing_is_changed_where_the_model_is_another_one()
    planned = osimcontact.rescale('human.osim', 'target_mass', 200, 'dry_run', true);
    [model, values] = live(planned.changes);
    last = key_of(planned.changes(end));
    values(last) = values(last) * 1.001; %#ok<NASGU>
    message = must_throw('osimcontact:notAsPlanned', @() osimcontact.apply(model, planned));
    must(~isempty(strfind(message, planned.changes(end).path)), 'the force is not named: %s', message);
    first = planned.changes(1);
    must(isequal(values(key_of(first)), first.from), 'the first was changed');
end

function a_component_that_is_not_there()
    planned = osimcontact.rescale('human.osim', 'target_mass', 200, 'dry_run', true);
    [model, values] = live(planned.changes(1:end - 1));
    must_throw('osimcontact:noComponent', @() osimcontact.apply(model, planned));
    first = planned.changes(1);
    must(isequal(values(key_of(first)), first.from), 'the first was changed');
end

function a_note_that_goes()
    planned = osimcontact.rescale('human.osim', 'target_mass', 200, 'dry_run', true, 'no_note', true);
    [model, values] = live(planned.changes);
    must(isempty(strfind(planned.credits, 'contacts made for')), 'the plan has a note: %s', planned.credits);
    % As of a model whose credits were nothing but the note.
    planned.credits = '';
    values('credits') = '[contacts made for 62 kg]'; %#ok<NASGU>
    osimcontact.apply(model, planned);
    must(strcmp(values('credits'), 'Frank Anderson, Peter Loan'), 'the note is still there: %s', values('credits'));
end

function what_cannot_be_applied()
    planned = osimcontact.rescale('human.osim', 'target_mass', 200, 'dry_run', true);
    model = live(planned.changes);
    must_throw('osimcontact:usage', @() osimcontact.apply(model, planned.changes));
    must_throw('osimcontact:usage', @() osimcontact.apply(model, [planned; planned]));
    removed = osimcontact.remove('human.osim', 'dry_run', true);
    message = must_throw('osimcontact:wholeObjects', @() osimcontact.apply(model, removed));
    must(~isempty(strfind(message, ' would be removed')), 'it does not say what: %s', message);
end

function [model, values] = live(changes)
    % A model that has what a plan has read, in a map that all of it shares.
    values = containers.Map('KeyType', 'char', 'ValueType', 'any');
    values('credits') = '';
    for change = changes'
        values(key_of(change)) = change.from;
    end
    model.getComponent = @(path) component(values, path);
    model.set_credits = @(text) put(values, 'credits', text);
end

function held = component(values, path)
    known = strncmp(values.keys(), [path '|'], numel(path) + 1);
    must(any(known), 'OpenSim: there is no component %s', path);
    held.updPropertyByName = @(name) property(values, path, NaN, name);
end

function held = property(values, path, set, name)
    if strcmp(name, 'contact_parameters') || strcmp(name, 'objects')
        % The set of a HuntCrossleyForce, then its list.
        held.updValueAsObject = @(index) object(values, path, index, name);
        return
    end
    key = sprintf('%s|%g|%s', path, set, name);
    must(values.isKey(key), 'OpenSim: there is no property %s', key);
    held.get = @() values(key);
    held.set = @(value) put(values, key, value);
end

function held = object(values, path, index, name)
    if strcmp(name, 'contact_parameters')
        must(index == 0, 'OpenSim: there is one set');
        held.updPropertyByName = @(inner) property(values, path, NaN, inner);
    else
        held.updPropertyByName = @(inner) property(values, path, index, inner);
    end
end

function put(values, key, value)
    values(key) = value; %#ok<NASGU>
end

function key = key_of(change)
    key = sprintf('%s|%g|%s', change.path, change.set, change.property);
end
