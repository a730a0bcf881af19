"""Moco's predictive problem, at any size: the second part of its example2DWalking. No reference is tracked.

Half a stride at a given speed, the second half its mirror image, with the least cubed effort over the distance. A size changes units and
nothing else: the speed has the same Froude number, and the cost is the same number.
"""

import opensim
from problem import set_bounds, state_names, symmetry

SPEED = 1.2  # m/s, on average
TIMES = (0.4, 0.6)  # s, which half a stride may take
EFFORT, EXPONENT = 10.0, 3
TOLERANCE = 1e-3  # of convergence


def prediction(model, size):
    """The MocoStudy for a model of this size.

    Parameters
    ----------
    model : Path
        The model.
    size : sizes.Size
    """
    study = opensim.MocoStudy()
    study.setName("prediction")
    problem = study.updProblem()
    processor = opensim.ModelProcessor(str(model))
    problem.setModelProcessor(processor)
    problem.addGoal(symmetry(state_names(processor)))
    speed = opensim.MocoAverageSpeedGoal("speed")
    speed.set_desired_average_speed(SPEED * size.length / size.time)
    problem.addGoal(speed)
    # Effort is a time over a length, which would grow as bodies become smaller.
    effort = opensim.MocoControlGoal("effort", EFFORT * size.length / size.time)
    effort.setExponent(EXPONENT)
    effort.setDivideByDisplacement(True)
    problem.addGoal(effort)
    problem.setTimeBounds(0.0, opensim.MocoFinalBounds(*(time * size.time for time in TIMES)))
    set_bounds(problem, size)
    study.initCasADiSolver()
    return study
