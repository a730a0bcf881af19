function results = drop_test(varargin)
%DROP_TEST Lets a model fall on its contacts and shows what they do.
%   RESULTS = osimcontact.drop_test(SUBJECT, NAME, VALUE, ...)
%
%   SUBJECT: The model to drop (.osim), or a preset; without one, give the numbers. Takes a text. May be
%       left out.
%
%   Options, each a NAME and a VALUE (target_mass and TargetMass are the same):
%     height: Height of the spheres' lowest points at the start: metres, or a factor of the radius like
%         x0.25 [default: 'x0.25']. Takes a number or a text.
%     duration: How long to follow the body, s [default: 2]. Takes a number.
%     samples: Points of the series [default: 1001]. Takes a whole number.
%     compare: Say how far this drop and that of OTHER (a model or preset) lie apart in dimensionless
%         form. Takes a text.
%     compare_spheres: With compare: the spheres that share OTHER's weight [default: as found on one
%         limb]. Takes a whole number.
%     foot_mass: Let a foot of this mass fall in the place of the body, kg: it is the foot that strikes
%         the ground. Takes a number.
%     presets: A file with presets of your own (TOML). Takes a text.
%     radius: Sphere radius, m. Takes a number.
%     stiffness: OpenSim's stiffness (plane strain modulus of one surface), N/m2. Takes a number.
%     dissipation: OpenSim's dissipation, s/m. Takes a number.
%     constant_contact_force: With the next two: SmoothSphereHalfSpaceForce's law, m2. Takes a number.
%     hertz_smoothing: 1/m. Takes a number.
%     hunt_crossley_smoothing: s/m. Takes a number.
%     gravity: Gravity, m/s2 [default: the model's, else 9.80665]. Takes a number.
%     spheres: Spheres that share the body weight, all stance limbs together [default: as found per
%         limb]. Takes a whole number.
%     stance_limbs: Limbs that share the body weight [default: as the note in the model says, else 1].
%         Takes a whole number.
%     contacts_mass: Mass the contacts are made for now, kg [default: the note, else mass]. Takes a
%         number.
%     mass: Mass of this model, kg [default: the sum of its bodies]. Takes a number.
%     exclude_body: Leave these bodies out of the sum (props, platforms). Takes a text or a cell array
%         of texts.
%     select: Only forces with such a name. Takes a text or a cell array of texts.
%     exclude: No forces with such a name. Takes a text or a cell array of texts.
%     skip_disabled: Leave out forces that are switched off. Takes true or false.
%     geometry: The ContactGeometrySet (or model) that holds the spheres of a standalone ForceSet. Takes
%         a text.
%     model: The model a standalone ForceSet belongs to, for its masses and joints. Takes a text.
%     yes: Confirm what looks like a mistake: the code of the error that asks. Takes 'implausible-mass'
%         or 'mass-in-pounds' or 'against-note' or 'implausible-radius' or 'implausible-place' or
%         'implausible-scale' or 'tilted-foot' or 'unequal-feet' or 'wrong-afterwards' or 'many-models'
%         or 'poor-fit' or a cell array of these.
%     AsTable: true gives a table with a row for each result; the name of a list in the results, such as
%         'series', one with a row for each of its entries. Columns without any value are left out. In
%         GNU Octave, which has no tables, a struct of columns.
%
%   RESULTS: an array of structs with the fields model, mass_kg, sphere_count, gravity_m_s2, height_m,
%   duration_s, reference_radius_m, reference_time_s, final_relative_indentation,
%   relative_indentation_hertz, relative_indentation_model_law, peak_force_n, peak_force_bw,
%   equilibrium_stiffness_n_m, hertz_stiffness_n_m, impact_speed_m_s, restitution_exact,
%   restitution_approximate, contact_time_s, rebound_speed_m_s, compare, series. docs/reference/json.md
%   and schemas/ say what each holds; what is missing is NaN, '' or empty.
%
%   Example, in the folder of the program's archive:
%       fall = osimcontact.drop_test('falisse2022', 'height', 'x0.5');
%       plot(fall.series.time_s, fall.series.force_bw)
%
%   See also osimcontact.sweep, osimcontact.inspect, osimcontact.check, osimcontact.motion,
%   osimcontact.plot, osimcontact.reproduce, osimcontact.presets, osimcontact.explain,
%   osimcontact.program.

% Made by dev/generate_matlab.py from the schemas of requests and results: change those, and run it.
    results = osimcontact.internal.run_verb('drop_test', varargin);
end
