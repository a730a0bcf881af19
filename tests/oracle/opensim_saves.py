"""Save or scale a model with the real OpenSim.

`how` is `save`, `init` (save after initSystem), `scale` (Model.scale of each body by 0.7), `tool` (the Scale Tool, from a setup
file of its own) or `processor` (a ModelProcessor).
"""

from pathlib import Path

from apart import run_one_job

FACTOR = 0.7

SETUP = """<?xml version="1.0" encoding="UTF-8" ?>
<OpenSimDocument Version="40000">
	<ScaleTool name="scaled">
		<mass>{mass!r}</mass>
		<GenericModelMaker><model_file>{model}</model_file></GenericModelMaker>
		<ModelScaler>
			<apply>true</apply>
			<scaling_order>manualScale</scaling_order>
			<ScaleSet><objects>{scales}</objects></ScaleSet>
			<preserve_mass_distribution>true</preserve_mass_distribution>
			<output_model_file>{output}</output_model_file>
		</ModelScaler>
		<MarkerPlacer><apply>false</apply></MarkerPlacer>
	</ScaleTool>
</OpenSimDocument>
"""


def save(model, output, how):
    """The model as OpenSim has written it; the caller's process stays free of OpenSim."""
    run_one_job("opensim_saves", [str(Path(model).absolute()), str(Path(output).absolute()), how])
    return output


def run_job(job):
    """Runs a job in this process."""
    import opensim

    model, output, how = job
    if how == "processor":
        opensim.ModelProcessor(model).process().printToXML(output)
        return
    loaded = opensim.Model(model)
    if how == "save":
        loaded.finalizeConnections()
        loaded.printToXML(output)
        return
    state = loaded.initSystem()
    bodies = loaded.getBodySet()
    names = [bodies.get(index).getName() for index in range(bodies.getSize())]
    mass = loaded.getTotalMass(state) * FACTOR**3
    if how == "scale":
        scales = opensim.ScaleSet()
        for name in names:
            one = opensim.Scale()
            one.setSegmentName(name)
            one.setScaleFactors(opensim.Vec3(FACTOR, FACTOR, FACTOR))
            one.setApply(True)
            scales.cloneAndAppend(one)
        if not loaded.scale(state, scales, True, mass):
            raise SystemExit("Model.scale failed")
    elif how == "tool":
        with_tool(opensim, model, output, names, mass)
        return
    loaded.printToXML(output)


def with_tool(opensim, model, output, names, mass):
    """The Scale Tool reads the model from the file and writes the scaled one."""
    scales = "".join(
        f'<Scale><scales>{FACTOR} {FACTOR} {FACTOR}</scales><segment>{name}</segment><apply>true</apply></Scale>'
        for name in names
    )
    setup = Path("setup.xml")
    setup.write_text(SETUP.format(mass=mass, model=model, output=output, scales=scales), encoding="utf-8")
    opensim.ScaleTool(str(setup.resolve())).run()  # its answer is about markers
