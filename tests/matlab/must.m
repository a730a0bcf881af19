function must(holds, varargin)
%MUST An error unless something holds, with what is said of it.
    if ~(islogical(holds) && isscalar(holds) && holds)
        error('test:failed', varargin{:});
    end
end
