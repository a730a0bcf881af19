function [path, change] = predsim(model, generic, varargin)
%PREDSIM Give a scaled model contacts that fit it, in a new file for PredSim.
%   PATH = osimcontact.predsim(MODEL, GENERIC) writes NAME_contacts.osim beside MODEL, NAME.osim, and gives its path for PredSim's
%   runPredSim(S, PATH). GENERIC is the model that was scaled, with the contacts as they should be. Places of spheres
%   follow the bones from GENERIC, radii the mass; stiffness, dissipation and smoothing follow from both masses. It does not matter whether
%   PredSim's fixContactSpherePositionAfterScaling has moved the spheres of MODEL before. MODEL stays as it is.
%
%   PredSim keeps what it compiled from a model in Subjects/NAME_OF_SUBJECT, under the name of the model's file (F_NAME.dll, .so
%   or .casadi, and F_NAME_IO.mat). The new name has nothing there, so that PredSim compiles the new contacts. It also fits the
%   geometry of the muscles again. To replace NAME_contacts.osim, add 'Force', true, and say
%   S.OpenSimADOptions.always_generate = true.
%
%   [PATH, CHANGE] = osimcontact.predsim(MODEL, GENERIC, NAME, VALUE, ...) takes every option of osimcontact.transfer, and gives its
%   result, too. Without options 'FollowBodies' and 'Level' are true, 'MovedSpheres' is 'replace', and 'Output' is
%   NAME_contacts.osim.
%
%   Example:
%       osim_path = osimcontact.predsim('Subjects/Child/Child.osim', 'Subjects/Falisse_et_al_2022/Falisse_et_al_2022.osim');
%       S.subject.name = 'Child';
%       runPredSim(S, osim_path);
%
%   See also osimcontact.transfer, osimcontact.check, osimcontact.drop_test.

    [folder, name] = fileparts(char(model));
    options = {'from', generic, 'follow_bodies', true, 'level', true, 'moved_spheres', 'replace', ...
        'output', fullfile(folder, [name '_contacts.osim'])};
    given = lower(strrep(cellfun(@char, varargin(1:2:end), 'UniformOutput', false), '_', ''));
    for i = numel(options) - 1:-2:1
        if any(strcmp(given, strrep(options{i}, '_', '')))
            options(i:i + 1) = [];
        end
    end
    change = osimcontact.transfer(model, options{:}, varargin{:});
    path = change.output;
end
