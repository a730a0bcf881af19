"""Moco on a folder that `motion --moco` wrote: `python opensim_moco.py FOLDER INTERVALS ITERATIONS` prints, as one line of JSON at the end,
the force of each foot's contacts along the initial guess, and the objective after the iterations; without any, that of the guess."""

import json
import os
import sys

import opensim


def forces_of_guess(track, study, solver):
    """Times, and for each load of a foot the sum of its contact forces at each of them."""
    guess, problem = solver.getGuess(), study.getProblem()
    states = guess.exportToStatesTrajectory(problem)
    model = problem.getPhase(0).getModelProcessor().process()
    model.initSystem()
    contacts = {
        load: [opensim.SmoothSphereHalfSpaceForce.safeDownCast(model.getComponent(path)) for path in paths]
        for load, (paths, _) in track.FEET.items()
    }
    found = {load: [] for load in contacts}
    for place in range(states.getSize()):
        state = states.get(place)
        model.realizeVelocity(state)
        for load, forces in contacts.items():
            records = [force.getRecordValues(state) for force in forces]
            found[load].append([sum(record.get(axis) for record in records) for axis in range(3)])
    return {"time": list(guess.getTimeMat()), "forces": found}


def main(folder, intervals, iterations):
    os.chdir(folder)
    sys.path.insert(0, "")
    import track

    study, solver = track.make_study(intervals)
    result = forces_of_guess(track, study, solver)
    if iterations >= 0:
        solver.set_optim_max_iterations(iterations)
        solution = study.solve()
        solution.unseal()
        result["iterations"] = solution.getNumIterations()
        result["objective"] = sum(solution.getObjectiveTerm(name) for name in solution.getObjectiveTermNames())
    print()
    print(json.dumps(result))


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]), int(sys.argv[3]))
