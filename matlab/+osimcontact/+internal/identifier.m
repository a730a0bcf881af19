function text = identifier(code)
%IDENTIFIER The identifier of an error or a warning with a code of the program, such as osimcontact:mass_missing.
%   MATLAB's identifiers have no hyphens.

    text = ['osimcontact:' strrep(code, '-', '_')];
end
