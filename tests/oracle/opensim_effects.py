"""What a model is for OpenSim: where its bodies are, what they weigh, and how its contacts press.

A job is `[model, states]`, with the states of opensim_shifts. The result has the places of bodies and meshes, all masses, and the contact
forces in each state.
"""

import opensim_feet
import opensim_shifts


def run_job(job):
    """The result, computed in this process."""
    import opensim

    path, states = job
    model = opensim.Model(path)
    state = model.initSystem()
    masses = [[body.get_mass(), [body.get_mass_center().get(k) for k in range(3)]] for body in model.getBodyList()]
    return {
        "places": opensim_feet.run_job(path),
        "mass": model.getTotalMass(state),
        "masses": masses,
        "states": opensim_shifts.run_job([path, states]),
    }
