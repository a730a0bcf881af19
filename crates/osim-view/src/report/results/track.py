"""Track the corrected motion and the forces of the plates with Moco. Run it in this folder."""

import opensim as osim

# For the force in plates.xml on each foot: the contacts under this foot, and its bodies after the first.
FEET = {}
START, END = 0.0, 1.0


def make_study(intervals):
    """Make a study that starts from the corrected motion, and its solver. Torques move the joints, not muscles."""
    model = osim.Model("model.osim")
    model.initSystem()
    welded, held = osim.StdVectorString(), {}  # Moco refuses locks
    for joint in [model.getJointSet().get(place) for place in range(model.getJointSet().getSize())]:
        coordinates = [joint.upd_coordinates(place) for place in range(joint.numCoordinates())]
        frames = [frame.getConcreteClassName() for frame in (joint.getParentFrame(), joint.getChildFrame())]
        can_weld = all(one.get_locked() and one.getDefaultValue() == 0 for one in coordinates)
        if coordinates and can_weld and frames == ["PhysicalOffsetFrame"] * 2:
            welded.append(joint.getName())
            continue
        for coordinate in filter(osim.Coordinate.get_locked, coordinates):
            held[coordinate.getAbsolutePathString() + "/value"] = coordinate.getDefaultValue()
            coordinate.set_locked(False)
    model.finalizeConnections()
    processor, motion = osim.ModelProcessor(model), osim.TableProcessor("motion.sto")
    processor.append(osim.ModOpReplaceJointsWithWelds(welded))
    processor.append(osim.ModOpRemoveMuscles())
    processor.append(osim.ModOpAddReserves(100.0, 100.0))
    model = processor.process()
    model.initSystem()
    motion.append(osim.TabOpUseAbsoluteStateNames())
    motion.append(osim.TabOpAppendCoordinateValueDerivativesAsSpeeds())
    motion, states = motion.process(model), model.getStateVariableNames()
    coordinates, contacts = osim.MocoStateTrackingGoal("coordinates"), osim.MocoContactTrackingGoal("contacts")
    study = osim.MocoStudy()
    problem = study.updProblem()
    problem.setModel(model)
    problem.setTimeBounds(START, END)
    for label in motion.getColumnLabels():
        if states.findIndex(label) < 0:
            motion.removeColumn(label)
            continue
        values, room = motion.getDependentColumn(label).to_numpy(), 20 if label.endswith("/speed") else 0.5
        low, high = (held[label],) * 2 if label in held else (values.min() - room, values.max() + room)
        problem.setStateInfo(label, [low - 1e-4, high + 1e-4])
        coordinates.setWeightForState(label, 1 if label.endswith("/speed") else 1000)
    coordinates.setReference(osim.TableProcessor(motion))
    contacts.setExternalLoadsFile("plates.xml")
    for load, (forces, bodies) in FEET.items():
        contacts.addContactGroup(osim.MocoContactTrackingGoalGroup(forces, load, bodies))
    for goal in (coordinates, contacts, osim.MocoControlGoal("effort", 0.1)):
        problem.addGoal(goal)
    solver = study.initCasADiSolver()
    solver.set_num_mesh_intervals(intervals)
    guess = solver.createGuess()
    guess.insertStatesTrajectory(motion, True)
    solver.setGuess(guess)
    return study, solver


if __name__ == "__main__":
    make_study(intervals=50)[0].solve().unseal().write("solution.sto")
