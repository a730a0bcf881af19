function path = program(path)
%PROGRAM Say where the program osim-contact-scale is, or ask for it.
%   osimcontact.program('C:\Users\YOU\osim-contact-scale\osim-contact-scale.exe') is used from now on, until MATLAB ends. To
%   have it always, write this line into your startup.m.
%
%   PATH = osimcontact.program() is the program that is used. Without the line above it is that of the environment variable
%   OSIM_CONTACT_SCALE, one beside this package, in a folder of PATH, or where programs usually are. There is none: the error
%   osimcontact:programNotFound, and a program that was named before stays.
%
%   See also osimcontact.

    if nargin > 0
        before = getenv('OSIM_CONTACT_SCALE');
        setenv('OSIM_CONTACT_SCALE', char(path));
        try
            path = osimcontact.internal.find_program();
        catch missing
            setenv('OSIM_CONTACT_SCALE', before);
            rethrow(missing);
        end
        return
    end
    path = osimcontact.internal.find_program();
end
