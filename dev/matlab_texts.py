"""Texts of dev/generate_matlab.py that the schemas do not have: how the verbs are called from MATLAB."""

# The schema in schemas/results/ of what a verb gives, where it is not a change; None: it gives no JSON.
RESULTS = {
    "sweep": "sweep",
    "inspect": "inspection",
    "check": "check",
    "drop-test": "drop-test",
    "motion": "motion",
    "plot": None,
    "reproduce": "reproduction",
    "presets": "preset",
    "explain": "explanation",
}

# Verbs that give something else without an option, and what they give then.
WITHOUT = {"design": ("models", "design"), "fit": ("motion", "fit")}

# The argument of a verb that may be a table instead of the name of a file.
TABLES = {"add": "contacts", "batch": "manifest", "fit": "file", "plot": "table"}

# The group of options that has no use in MATLAB: results are data, and nothing is printed.
LEFT_OUT = "shown"

# Words of descriptions that hold for a terminal only, and what stands there instead.
NO_STANDARD_STREAMS = {
    ", or - for standard input": "",
    "; - is standard input": "",
    " (- is SVG on standard output)": "",
    "Write to this file, or - [default": "Write to this file [default",
    "; may be repeated": "",
    "; once for each": "; one for each",
    " (or one, BODY=f)": "",
}

# Run as they stand by tests/matlab/test_verbs.m. The archive of the program has these fixtures.
EXAMPLES = {
    "add": """
change = osimcontact.add('fixtures/feet/human_40000.osim', 'from', 'fixtures/table1/human_62kg_smooth_sphere.osim', 'output', 'with contacts.osim');
{change.objects.name}""",
    "batch": """
rows = {'model', 'target_mass'; 'fixtures/table1/human_62kg_smooth_sphere.osim', 500; 'fixtures/table1/emu_10_spheres_smooth_sphere.osim', 40};
change = osimcontact.batch(rows, 'output_dir', 'scaled');
{change.output}""",
    "check": """
models = osimcontact.check('fixtures/table1');
for finding = models(1).findings', disp(finding.message), end""",
    "convert": """
change = osimcontact.convert('fixtures/table1/human_62kg_smooth_sphere.osim', 'to', 'hunt-crossley', 'output', 'converted.osim');""",
    "design": """
sheet = osimcontact.design('radius', 0.032, 'indentation', 0.16, 'mass', 62, 'spheres', 6);
for figure = sheet.figures', fprintf('%s: %g %s\\n', figure.name, figure.value, figure.unit), end""",
    "drop-test": """
fall = osimcontact.drop_test('falisse2022', 'height', 'x0.5');
plot(fall.series.time_s, fall.series.force_bw)""",
    "explain": """
topics = osimcontact.explain({'C.2', 'stiffness'});
topics(1).formulas.formula""",
    "fit": """
fitted = osimcontact.fit('fixtures/measured/heel_pad.csv', 'radius', 0.03, 'indentation_unit', 'mm');
fitted.stiffness.value""",
    "inspect": """
models = osimcontact.inspect('fixtures/table1');
[models.mass_kg]
models(1).forces(1).parameters.stiffness""",
    "motion": """
walk = osimcontact.motion('fixtures/motion/walker.osim', 'fixtures/motion/walk.mot');
fprintf('%.1f body weights\\n', [walk.feet.peak_n] / walk.weight_n)""",
    "note": """
change = osimcontact.note('fixtures/table1/human_62kg_smooth_sphere.osim', 'contacts_mass', 62, 'output', 'noted.osim');""",
    "plot": """
models = {'fixtures/table1/human_62kg_smooth_sphere.osim', 'fixtures/table1/emu_10_spheres_smooth_sphere.osim'};
change = osimcontact.plot('force', models, 'output', 'force.pdf');""",
    "presets": """
preset = osimcontact.presets('falisse2022');
preset.stiffness""",
    "remove": """
change = osimcontact.remove('fixtures/table1/human_62kg_smooth_sphere.osim', 'output', 'bare.osim');""",
    "reproduce": """
paper = osimcontact.reproduce();
fprintf('%d of %d numbers agree\\n', paper.within_last_digit, paper.numbers)""",
    "rescale": """
change = osimcontact.rescale('fixtures/table1/human_62kg_smooth_sphere.osim', 'TargetMass', 500, 'output', 'giant.osim');
[change.changes.factor]""",
    "set": """
factors = struct('stiffness', 'x2', 'dissipation', 1.5);
change = osimcontact.set('fixtures/table1/human_62kg_smooth_sphere.osim', 'set', factors, 'output', 'stiffer.osim');""",
    "sweep": """
grid = struct('stiffness', 'x0.1..x10/5', 'dissipation', [0.5 1 2]);
variants = osimcontact.sweep('fixtures/table1/human_62kg_smooth_sphere.osim', 'grid', grid, 'output_dir', 'variants');
variants.models""",
    "transfer": """
change = osimcontact.transfer('fixtures/table1/emu_10_spheres_smooth_sphere.osim', 'from', 'falisse2022', 'output', 'emu as human.osim');""",
}
