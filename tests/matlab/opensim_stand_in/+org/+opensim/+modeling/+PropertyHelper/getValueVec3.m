function value = getValueVec3(property, index)
%GETVALUEVEC3 Stands in for OpenSim's: see test_apply.m.
    values = property.get();
    must(numel(values) == 3, 'OpenSim: this property is no Vec3');
    value = values(index + 1);
end
