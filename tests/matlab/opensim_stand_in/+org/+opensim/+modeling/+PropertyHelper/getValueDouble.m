function value = getValueDouble(property)
%GETVALUEDOUBLE Stands in for OpenSim's: see test_apply.m.
    value = property.get();
    must(isscalar(value), 'OpenSim: this property is no number');
end
