"""How a body accelerates in OpenSim when the model is released at its default pose, m/s2 in ground.

A job is `[model, body]`.
"""


def run_job(job):
    """The acceleration, computed in this process."""
    import opensim

    path, body = job
    model = opensim.Model(path)
    state = model.initSystem()
    model.realizeAcceleration(state)
    acceleration = model.getBodySet().get(body).getLinearAccelerationInGround(state)
    return [acceleration.get(k) for k in range(3)]
