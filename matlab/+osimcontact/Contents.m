% OSIMCONTACT  Contact parameters of OpenSim models, right at every body size.
%
%
% Every function hands a request to the program osim-contact-scale and gives what comes back as structs.
% Type help osimcontact.rescale, say, for all options of a function. This list is shown by help osimcontact, in GNU
% Octave by help osimcontact.Contents.
%
%   add        - Gives a model that has no foot contacts those of another model or of a preset, of a table, or spheres under its bones.
%   batch      - One row per model; columns are named like the long options of rescale, transfer, design and set.
%   check      - Compares models with the limits of the paper and the traps of the format.
%   convert    - Makes forces of one class from those of the other, one for each sphere, or connects sockets.
%   design     - Finds parameters from what is wanted: indentation, stiffness, restitution.
%   drop_test  - Lets a model fall on its contacts and shows what they do.
%   explain    - Explains equations, quantities, and the codes of findings and errors.
%   fit        - Finds contact parameters from a measured indentation and force, or those of a model from recordings of its gait.
%   inspect    - Shows what contacts models have.
%   motion     - Shows what contacts do along a recorded motion, beside what force plates measured.
%   note       - Writes into models which mass their contacts were made for, or how many limbs share the weight; no number changes.
%   plot       - Draws what contacts do.
%   presets    - Lists presets, or shows one.
%   remove     - Takes the foot contacts out of models: forces, the spheres that nothing else uses, and what was made for them.
%   reproduce  - Compares Table 1 of the paper with what its equations give, and draws its figures 4 and C.5.
%   rescale    - Rescales a model's own contacts to another mass.
%   set        - Sets properties to a value, or multiplies them by a factor.
%   sweep      - One file per point of a grid, or per step of a ladder, and a table that says what is in which.
%   transfer   - Gives a model the contacts of another model or of a preset, at its own size.
%   apply      - Make the changes of a plan in a live model of OpenSim's own bindings.
%   predsim    - Give a scaled model contacts that fit it, in a new file for PredSim.
%   program    - Say where the program is, or ask for it.
%   read_table - Read a table (CSV) that the program wrote.

% Made by dev/generate_matlab.py from the schemas of requests and results: change those, and run it.
