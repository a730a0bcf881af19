function setValueDouble(value, property)
%SETVALUEDOUBLE Stands in for OpenSim's: see test_apply.m.
    must(isscalar(value) && isscalar(property.get()), 'OpenSim: this property is no number');
    property.set(value);
end
