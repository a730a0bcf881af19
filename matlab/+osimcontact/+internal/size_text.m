function text = size_text(value)
%SIZE_TEXT The size of a value for a message, such as 2 x 3.

    text = strjoin(strsplit(num2str(size(value))), ' x ');
end
