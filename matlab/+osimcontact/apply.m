function apply(model, planned)
%APPLY Make the changes of a plan in a live model of OpenSim's own bindings.
%   osimcontact.apply(MODEL, PLANNED) sets every number that changes in MODEL, an org.opensim.modeling.Model, and the note in its
%   credits, which says what the contacts are made for now. PLANNED is what rescale, transfer, design, set, note or a row of
%   batch gave for this model. Plan with 'dry_run', and no file is written. Call MODEL.initSystem() again before you simulate,
%   and model.print(FILE) to keep the result.
%
%   Nothing is set before every component and every value is looked at: is one not there, or is it not what the plan has
%   read, it is an error (osimcontact:noComponent, osimcontact:notAsPlanned) and the model is as it was. Whole contacts, which
%   add, remove and convert make, cannot be made so (osimcontact:wholeObjects): let these write a file, and open it.
%
%   Example (needs OpenSim's bindings for MATLAB):
%       import org.opensim.modeling.*
%       model = Model('fixtures/table1/human_62kg_smooth_sphere.osim');
%       change = osimcontact.rescale('fixtures/table1/human_62kg_smooth_sphere.osim', 'TargetMass', 500, 'DryRun', true);
%       osimcontact.apply(model, change);
%       model.initSystem();
%
%   See also osimcontact.rescale, osimcontact.transfer, osimcontact.design, osimcontact.set.

    if ~isstruct(planned) || ~isscalar(planned) || ~all(isfield(planned, {'changes', 'objects', 'credits'}))
        error('osimcontact:usage', 'expected what rescale, transfer, design or set gave for this one model, with all of its fields');
    end
    if ~isempty(planned.objects)
        error('osimcontact:wholeObjects', '%s would be %s: let a file be written, and open it. Nothing was changed', ...
            planned.objects(1).path, planned.objects(1).change);
    end
    changes = planned.changes;
    properties = cell(1, numel(changes));
    for i = 1:numel(changes)
        properties{i} = find_property(model, changes(i));
        current = current_value(properties{i}, numel(changes(i).to));
        if any(abs(current - changes(i).from(:)) > 1e-9 * abs(changes(i).from(:))) || any(isnan([current; changes(i).to(:)]))
            error('osimcontact:notAsPlanned', '%s: %s is %s in the model, but the plan is for %s. Nothing was changed', ...
                changes(i).path, changes(i).property, mat2str(current', 17), mat2str(changes(i).from(:)', 17));
        end
    end
    for i = 1:numel(changes)
        set_value(properties{i}, changes(i).to);
    end
    if ~isempty(planned.credits)
        model.set_credits(planned.credits);
    elseif ~isempty(changes)
        % Of a file without credits, such as one whose note went, OpenSim reads its own.
        new = org.opensim.modeling.Model();
        model.set_credits(new.getCredits());
    end
end

function property = find_property(model, change)
    try
        owner = model.getComponent(change.path);
        if ~isnan(change.set)
            % The parameters of a HuntCrossleyForce are in a list of its own; the plan counts it from 0, as OpenSim does.
            sets = owner.updPropertyByName('contact_parameters').updValueAsObject(0);
            owner = sets.updPropertyByName('objects').updValueAsObject(change.set);
        end
        property = owner.updPropertyByName(change.property);
    catch problem
        error('osimcontact:noComponent', '%s with %s is not in the model: %s. Nothing was changed', change.path, ...
            change.property, problem.message);
    end
end

function value = current_value(property, count)
    if count == 3
        value = zeros(3, 1);
        for i = 1:3
            value(i) = org.opensim.modeling.PropertyHelper.getValueVec3(property, i - 1);
        end
    else
        value = org.opensim.modeling.PropertyHelper.getValueDouble(property);
    end
end

function set_value(property, value)
    if numel(value) == 3
        for i = 1:3
            org.opensim.modeling.PropertyHelper.setValueVec3(value(i), property, i - 1);
        end
    else
        org.opensim.modeling.PropertyHelper.setValueDouble(value, property);
    end
end
