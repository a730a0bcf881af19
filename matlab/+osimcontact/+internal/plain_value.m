function [value, problem] = plain_value(value)
%PLAIN_VALUE A value of a class that only MATLAB has, as a text where it is one; a PROBLEM where no option takes it.
%   Strings and categories are texts. Times are refused: options have units, and whose a time is meant in is not known.

    problem = '';
    switch class(value)
        case {'string', 'categorical'}
            if isscalar(value)
                value = char(value);
            else
                value = cellstr(value);
            end
        case 'datetime'
            problem = 'is a datetime, which no option takes: give its text, char(value)';
        case {'duration', 'calendarDuration'}
            problem = ['is a ' class(value) ', which no option takes: give a number in the unit of the option, such as seconds(value)'];
        case {'table', 'timetable'}
            problem = ['is a ' class(value) ', which this option does not take'];
    end
end
