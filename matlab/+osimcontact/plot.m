function results = plot(varargin)
%PLOT Draws what contacts do.
%   RESULTS = osimcontact.plot(KIND, MODELS, NAME, VALUE, ...)
%
%   KIND: What to draw. Takes 'force' or 'state' or 'loop' or 'drop' or 'sweep' or 'feet' or 'motion' or
%       'fig1' or 'fig4' or 'fig-c5'.
%
%   MODELS: Models (.osim) or presets, overlaid in one figure; none for fig4 and fig-c5. Takes a text or
%       a cell array of texts. May be left out.
%
%   Options, each a NAME and a VALUE (target_mass and TargetMass are the same):
%     output: Write to this file: .svg, .pdf or .png. Takes a text. Must be given.
%     data: Write the numbers that are drawn to this file, too (CSV). Takes a text.
%     force: Replace existing files. Takes true or false.
%     target_mass: Draw each contact also as it is after scaling to this mass, kg. Takes a number.
%     axes: Units of indentation and force [default: x/R and N; x/R and shares of the weight for
%         several]. Takes 'dimensionless' or 'real'.
%     geometry_dir: Of feet: a folder with the bones' meshes, beside the model's own and its Geometry.
%         Takes a text.
%     motion: Of motion: coordinates over time (.mot, .sto). Takes a text.
%     plates: Of motion: the ground reactions that force plates measured (.mot, .sto). Takes a text.
%     loads: Of motion: OpenSim's ExternalLoads (.xml). Takes a text.
%     angles: Of motion: the unit of its angles, where its header does not say it. Takes 'degrees' or
%         'radians'.
%     presets: A file with presets of your own (TOML). Takes a text.
%     gravity: Gravity, m/s2 [default: the model's]. Takes a number.
%     height: Height of the spheres' lowest points at the start: metres, or a factor of the radius like
%         x0.25 [default: 'x0.25']. Takes a number or a text.
%     duration: How long to follow the body, s [default: 20 sqrt(R/g), of the slowest]. Takes a number.
%     quantity: What the colours show [default: 'indentation']. Takes 'indentation' or 'restitution' or
%         'peak-force'.
%     stiffness: Values of stiffness: FROM..TO/COUNT in N/m2, or factors like x0.1..x10/25 [default:
%         'x0.1..x10/25']. Takes a text.
%     dissipation: Values of dissipation: FROM..TO/COUNT in s/m, or factors [default: 'x0.1..x4/25'].
%         Takes a text.
%     table: Draw a column of this table (CSV) instead, such as a sweep's with your results in it. Takes
%         the name of a file, or a table, a struct array or a cell array.
%     value_column: The table's column that is drawn. Takes a text.
%     x_column: The table's column along the horizontal axis [default: the first grid_ column]. Takes a
%         text.
%     y_column: The table's column along the vertical axis [default: the second grid_ column]. Takes a
%         text.
%     value_range: From which value to which colours change: FROM..TO. Takes a text.
%     title: Title of the figure; "" for none. Takes a text.
%     label: Name of a curve, in the order of the legend; one for each. Takes a text or a cell array of
%         texts.
%     width: Width on paper, mm [default: 90, one column of a journal; 190 for several panels side by
%         side]. Takes a number.
%     font_size: Size of the letters on paper, points; everything else grows with them [default: 7].
%         Takes a number.
%     x_range: Limits of the horizontal axis, in its unit: FROM..TO. Takes a text.
%     y_range: Limits of the vertical axis, in its unit: FROM..TO. Takes a text.
%     dpi: Pixels to the inch of a PNG [default: 600]. Takes a whole number.
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
%
%   RESULTS: a struct with the fields output (the file) and text (remarks on it).
%
%   Example, in the folder of the program's archive:
%       models = {'fixtures/table1/human_62kg_smooth_sphere.osim', 'fixtures/table1/emu_10_spheres_smooth_sphere.osim'};
%       change = osimcontact.plot('force', models, 'output', 'force.pdf');
%
%   See also osimcontact.sweep, osimcontact.inspect, osimcontact.check, osimcontact.drop_test,
%   osimcontact.motion, osimcontact.reproduce, osimcontact.presets, osimcontact.explain,
%   osimcontact.program.

% Made by dev/generate_matlab.py from the schemas of requests and results: change those, and run it.
    results = osimcontact.internal.run_verb('plot', varargin);
end
