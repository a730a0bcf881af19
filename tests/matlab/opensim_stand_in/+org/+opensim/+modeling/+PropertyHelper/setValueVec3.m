function setValueVec3(value, property, index)
%SETVALUEVEC3 Stands in for OpenSim's: see test_apply.m.
    values = property.get();
    must(numel(values) == 3 && isscalar(value), 'OpenSim: this property is no Vec3');
    values(index + 1) = value;
    property.set(values);
end
