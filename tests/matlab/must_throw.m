function message = must_throw(identifier, call)
%MUST_THROW An error unless a call throws one with this identifier; gives its message.
    try
        call();
    catch problem
        must(strcmp(problem.identifier, identifier), 'expected %s, not %s: %s', identifier, problem.identifier, problem.message);
        message = problem.message;
        return
    end
    error('test:failed', 'expected %s, but nothing was thrown', identifier);
end
