function is = is_missing(value)
%IS_MISSING Whether this one value is what MATLAB has for a value that is not known: NaN, missing, NaT, <undefined>.

    is = false;
    if ~isscalar(value)
        return
    end
    if isfloat(value)
        is = isnan(value);
    elseif any(strcmp(class(value), {'missing', 'string', 'categorical', 'datetime', 'duration'}))
        is = ismissing(value);
    end
end
