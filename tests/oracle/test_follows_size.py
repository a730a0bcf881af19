"""What else follows size: the list of `check --from` against the numbers that the real OpenSim reads from both models.

Counts, medians and ranges of factors, and the factors of similarity are computed here from OpenSim's numbers alone.
"""

from pathlib import Path
from statistics import median

import pytest

import command
import models
import opensim_sizes
from models import FIXTURES
from opensim_scales import scaled

TOLERANCE = 1e-9
#: Models of the corpus that somebody scaled with the Scale Tool, and what from.
PUBLISHED = {
    "gait2354": ("v40000_gait2354_subject01_scaled_without_contacts", "v10905_gait2354_without_contacts"),
    "gait10dof18musc": ("v30000_gait1018_subject01_without_contacts", "v40000_gait10dof18musc_without_contacts"),
    "rajagopal": ("v40600_moco_3d_walking_model_without_contacts", "v40000_rajagopal_2016_without_contacts"),
}
#: Models of the corpus that OpenSim scales here: limits, bushings, actuators with an activation.
SCALED = (
    "v30000_osim_rl_gait9dof18musc_crlf",
    "v40000_toy_landing",
    "v40000_falisse_2022_human",
    "v40000_moco_2d_gait",
    "v30000_scone_h0914m",
)
FACTORS, MASS = [0.69, 0.72, 0.66], 20.0

#: Powers of M and L at equal gravity, by hand: N is M, m is L, s is L^(1/2).
POWERS = {
    "inertia": (1, 2), "max_isometric_force": (1, 0), "optimal_fiber_length": (0, 1), "tendon_slack_length": (0, 1),
    "max_contraction_velocity": (0, -0.5), "activation_time_constant": (0, 0.5), "deactivation_time_constant": (0, 0.5),
    "ligament_length": (0, 1), "ligament_force": (1, 0), "ligament_damping": (0, 0.5), "spring_stiffness": (1, -1),
    "spring_length": (0, 1), "spring_dissipation": (0, -0.5), "bushing_stiffness": (1, -1),
    "bushing_rotational_stiffness": (1, 1), "bushing_damping": (1, -0.5), "bushing_rotational_damping": (1, 1.5),
    "coordinate_rotational_stiffness": (1, 1), "coordinate_rotational_damping": (1, 1.5), "coordinate_stiffness": (1, -1),
    "coordinate_damping": (1, -0.5), "coordinate_length": (0, 1), "limit_rotational_stiffness": (1, 1),
    "limit_rotational_damping": (1, 1.5), "limit_stiffness": (1, -1), "limit_damping": (1, -0.5), "limit_length": (0, 1),
    "actuator_force": (1, 0), "actuator_torque": (1, 1), "actuator_time": (0, 0.5),
}  # fmt: skip

#: By OpenSim's class and property: the kind, or the two kinds of an angle and of a translation.
SPRINGS = {"stiffness": "spring_stiffness", "rest_length": "spring_length", "resting_length": "spring_length",
           "dissipation": "spring_dissipation"}  # fmt: skip
BUSHINGS = {"rotational_stiffness": "bushing_rotational_stiffness", "translational_stiffness": "bushing_stiffness",
            "rotational_damping": "bushing_rotational_damping", "translational_damping": "bushing_damping"}  # fmt: skip
STIFF = ("limit_rotational_stiffness", "limit_stiffness")
ACTUATOR = {"optimal_force": ("actuator_torque", "actuator_force"), "activation_time_constant": "actuator_time"}
KINDS = {
    "PathSpring": SPRINGS,
    "PointToPointSpring": SPRINGS,
    "BushingForce": BUSHINGS,
    "ExpressionBasedBushingForce": BUSHINGS,
    "Blankevoort1991Ligament": {
        "slack_length": "ligament_length", "linear_stiffness": "ligament_force", "damping_coefficient": "ligament_damping"
    },
    "SpringGeneralizedForce": {
        "stiffness": ("coordinate_rotational_stiffness", "coordinate_stiffness"),
        "viscosity": ("coordinate_rotational_damping", "coordinate_damping"),
        "rest_length": (None, "coordinate_length"),
    },
    "CoordinateLimitForce": {
        "upper_stiffness": STIFF, "lower_stiffness": STIFF, "damping": ("limit_rotational_damping", "limit_damping"),
        "upper_limit": (None, "limit_length"), "lower_limit": (None, "limit_length"), "transition": (None, "limit_length"),
    },
    "CoordinateActuator": ACTUATOR,
    "ActivationCoordinateActuator": ACTUATOR,
    "PointActuator": {"optimal_force": "actuator_force"},
    "TorqueActuator": {"optimal_force": "actuator_torque"},
}  # fmt: skip
MUSCLE = {
    name: name
    for name in (
        "max_isometric_force", "optimal_fiber_length", "tendon_slack_length", "max_contraction_velocity",
        "activation_time_constant", "deactivation_time_constant",
    )
}  # fmt: skip


def numbers_of(read):
    """`{(kind, object, property, place): number}` of OpenSim's reading."""
    result = {("inertia", name, "inertia", 0): value for name, value in read["inertia"].items()}
    for one in read["objects"]:
        is_muscle = one["class"].endswith("Muscle")
        for name, kinds in (MUSCLE if is_muscle else KINDS.get(one["class"], {})).items():
            kind = kinds if isinstance(kinds, str) else kinds[0 if one["turns"] else 1]
            for place, value in enumerate(one["numbers"].get(name, ()) if kind else ()):
                result[kind, one["name"], name, place] = value
    return result


def expected_list(new, old):
    """By kind: how many, the factors, and the factor of similarity."""
    numbers, others = numbers_of(new), numbers_of(old)
    mass = new["mass"] / old["mass"]
    shared = new["distances"].keys() & old["distances"].keys()
    length = sum(new["distances"][name] for name in shared) / sum(old["distances"][name] for name in shared)
    rows = {}
    for key, value in numbers.items():
        row = rows.setdefault(key[0], {"count": 0, "factors": [], "pairs": 0})
        row["count"] += 1
        if key in others:
            row["pairs"] += 1
            row["factors"] += [value / others[key]] if others[key] != 0 else []
    for kind, row in rows.items():
        powers = POWERS[kind]
        row["similar"] = mass ** powers[0] * length ** powers[1]
    return mass, length, rows


def close(a, b):
    return abs(a - b) <= TOLERANCE * abs(b)


def compare(model, original):
    outcome = command.run("check", model, "--from", original)
    assert outcome.report is not None, outcome
    ours = outcome.report["similarity"]
    mass, length, rows = expected_list(*opensim_sizes.read_sizes([model, original]))
    assert close(ours["mass_ratio"], mass)
    # OpenSim rounds the joints of old documents to six digits.
    assert ours["length_ratio"] == pytest.approx(length, rel=1e-6)
    assert ours["gravity_ratio"] == pytest.approx(1, abs=1e-3)
    assert {row["kind"] for row in ours["kinds"]} == rows.keys()
    for row in ours["kinds"]:
        want = rows[row["kind"]]
        assert (row["count"], row["pairs"]) == (want["count"], want["pairs"]), row
        if want["factors"]:
            for name, function in (("median", median), ("min", min), ("max", max)):
                # OpenSim rounds the inertia of old documents, too.
                limit = 1e-5 if row["kind"] == "inertia" else TOLERANCE
                assert row["factor"][name] == pytest.approx(function(want["factors"]), rel=limit), (row, name)
        else:
            assert row["factor"] is None, row
        assert abs(row["similarity_factor"] / want["similar"] - 1) < 1e-3 and row["similarity_factor"] > 0, row
    return {row["kind"]: row for row in ours["kinds"]}


@pytest.mark.parametrize("name", PUBLISHED)
def test_published_scaled_models(name):
    if not models.CORPUS:
        pytest.skip(models.NO_CORPUS)
    model, original = (Path(models.CORPUS) / f"{stem}.osim" for stem in PUBLISHED[name])
    kinds = compare(model, original)
    # The Scale Tool has changed lengths, and left what is a force or a time.
    assert {kinds[kind]["verdict"] for kind in ("max_isometric_force", "activation_time_constant")} <= {"left", "undecided"}
    assert kinds["optimal_fiber_length"]["factor"]["median"] != 1


@pytest.mark.parametrize("name", SCALED)
def test_models_that_opensim_scales(name, tmp_path, readings):
    if not models.CORPUS:
        pytest.skip(models.NO_CORPUS)
    original, output = Path(models.CORPUS) / f"{name}.osim", tmp_path / "scaled.osim"
    bodies = [body["path"].rsplit("/", 1)[-1] for body in readings[original]["bodies"]]
    scaled({"model": str(original), "output": str(output), "factors": dict.fromkeys(bodies, FACTORS), "mass": MASS})
    kinds = compare(output, original)
    assert any(row["verdict"] == "left" for row in kinds.values())


def test_each_class_of_the_fixture():
    folder = FIXTURES / "follows_size"
    kinds = compare(folder / "scaled.osim", folder / "generic.osim")
    assert kinds["actuator_torque"]["verdict"] == "follows" and kinds["actuator_force"]["verdict"] == "left"
