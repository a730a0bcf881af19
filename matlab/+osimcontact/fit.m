function results = fit(varargin)
%FIT Finds contact parameters from a measured indentation and force.
%   RESULTS = osimcontact.fit(FILE, NAME, VALUE, ...)
%
%   FILE: Measured indentation and force (.csv). Takes a text.
%
%   Options, each a NAME and a VALUE (target_mass and TargetMass are the same):
%     radius: Sphere radius, m. Takes a number. Must be given.
%     spheres: Spheres that share the measured force [default: 1]. Takes a whole number.
%     onset: Where contact begins, in metres, or fit to find it. Takes 'fit' or a number.
%     branch: Which part of the measurement [default: 'both']. Takes 'both' or 'loading' or 'unloading'.
%     indentation_column: Column of the indentation [default: 'indentation']. Takes a text.
%     force_column: Column of the force [default: 'force']. Takes a text.
%     speed_column: Column of the speed of indentation; without it and without a time, dissipation is
%         not fitted. Takes a text.
%     time_column: Column of the time, from which the speed is taken. Takes a text.
%     indentation_unit: Unit of the indentation [default: 'm']. Takes 'm' or 'mm' or 'um'.
%     force_unit: Unit of the force [default: 'N']. Takes 'N' or 'kN' or 'mN'.
%     speed_unit: Unit of the speed [default: 'm/s']. Takes 'm/s' or 'mm/s'.
%     time_unit: Unit of the time [default: 's']. Takes 's' or 'ms'.
%     AsTable: true gives a table of MATLAB with a row for each result; the name of a list in the
%         results, such as 'warnings', one with a row for each of its entries. Not in GNU Octave.
%
%   RESULTS: an array of structs with the fields file, sphere_count, radius_m, composite_modulus_n_m2,
%   stiffness, dissipation, onset_m, parameters, covariance, warnings, r_squared, degrees_of_freedom,
%   residual_deviation_n, largest_relative_indentation, within_hertz_limit, largest_speed_m_s,
%   restitution, within_hunt_crossley_limit, residuals. docs/json.md says what each holds; what is
%   missing is NaN, '' or empty.
%
%   Example:
%       found = osimcontact.fit('measured.csv', 'radius', 0.01);
%       found.stiffness.value
%
%   See also osimcontact.sweep, osimcontact.inspect, osimcontact.check, osimcontact.drop_test,
%   osimcontact.motion, osimcontact.plot, osimcontact.reproduce, osimcontact.presets,
%   osimcontact.explain, osimcontact.program.

% Made by dev/generate_matlab.py from the schemas of requests and results: change those, and run it.
    results = osimcontact.internal.run_verb('fit', varargin);
end
