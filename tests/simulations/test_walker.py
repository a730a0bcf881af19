"""The demonstration of `docs/studies/walker.md`: its parts, and a 2 × 2 of its grid at a coarse mesh, solved by OpenSim Moco."""

import math
import subprocess
import sys
from types import SimpleNamespace

import numpy as np
import opensim
import pandas as pd
import pytest
from conftest import TOP

HERE = TOP / "demonstrations" / "walker"
sys.path.insert(0, str(HERE))

import contacts  # noqa: E402
import guesses  # noqa: E402
import judge  # noqa: E402
import model  # noqa: E402
import page  # noqa: E402
import problem  # noqa: E402
import walk  # noqa: E402
import walker  # noqa: E402
from osim_contact_scale import simulate  # noqa: E402

G, LEG_M, KG = 9.80665, 0.901, 62.0
COARSE = 18


def test_a_bound_is_active_where_the_solution_touches_it():
    limits = {"time_s": (0.0, 2.0), "knee_r_rad": (-1.0, 1.0), "forward_m": (0.0, 2.0)}
    # The time counts with its end alone, and the start of the way is given.
    free = {"time_s": [0.0, 1.0], "knee_r_rad": [-0.5, 0.5], "forward_m": [0.0, 1.0]}
    assert judge.active(free, limits) == []
    assert judge.distances(free, limits) == {"time_s": 0.5, "knee_r_rad": 0.25, "forward_m": 0.5}
    assert judge.active({**free, "knee_r_rad": [0.0, 0.99]}, limits) == ["knee_r_rad"]
    assert judge.active({**free, "knee_r_rad": [-1.5, 0.0]}, limits) == ["knee_r_rad"]
    assert judge.active({**free, "time_s": [0.0, 1.999]}, limits) == ["time_s"]
    assert judge.active({**free, "forward_m": [0.0, math.nan]}, limits) == ["forward_m"]


def accelerations(path, length):
    """Dimensionless accelerations of all coordinates, by OpenSim: at a pose with both feet in the ground, moving, all torques at work."""
    walker = opensim.Model(str(path))
    state = walker.initSystem()
    root = math.sqrt(length)
    chosen = np.random.default_rng(1)
    for name, where in problem.coordinates().items():
        value, speed = chosen.uniform(-0.3, 0.3, 2)
        if name == "up":
            value = LEG_M - 0.07
        size, rate = (length, root) if name in ("up", "forward") else (1, 1 / root)
        walker.setStateVariableValue(state, f"{where}/value", value * size)
        walker.setStateVariableValue(state, f"{where}/speed", speed * rate)
    for where in problem.torques().values():
        actuator = opensim.CoordinateActuator.safeDownCast(walker.getComponent(where))
        actuator.overrideActuation(state, True)
        actuator.setOverrideActuation(state, 0.1 * actuator.getOptimalForce())
    walker.realizeAcceleration(state)
    result = {}
    for name, where in problem.coordinates().items():
        value = opensim.Coordinate.safeDownCast(walker.getComponent(where)).getAccelerationValue(state)
        result[name] = value * (1 if name in ("up", "forward") else length)
    return result


@pytest.mark.parametrize("length", [0.25, 4.0])
def test_a_walker_of_another_size_moves_alike_on_rescaled_contacts(length, tmp_path):
    """In the real OpenSim, masses, torques, dampers, stops, contacts and friction are all in these accelerations."""
    paths = {(row["length"], row["contacts"]): row["path"] for row in contacts.sizes(tmp_path, (length,))}
    human = accelerations(paths[1.0, "rescaled"], 1.0)
    assert max(map(abs, human.values())) > 10
    assert accelerations(paths[length, "rescaled"], length) == pytest.approx(human, rel=1e-9, abs=1e-9)
    assert accelerations(paths[length, "left"], length) != pytest.approx(human, rel=0.1)


@pytest.mark.parametrize("length", [0.25, 4.0])
def test_the_problem_of_another_size_is_the_same(length):
    root = math.sqrt(length)
    sizes = {
        "time_s": root,
        "up_m": length,
        "up_m_s": root,
        "hip_r_rad": 1,
        "hip_r_rad_s": 1 / root,
        "hip_r_control": 1,
    }
    ours, theirs = problem.bounds(length), problem.bounds()
    guess, drawn = guesses.scaled(guesses.by_hand(), length), guesses.by_hand()
    for name, factor in sizes.items():
        assert ours[name] == pytest.approx([factor * bound for bound in theirs[name]], rel=1e-12)
        assert np.allclose(guess[name], factor * drawn[name], rtol=1e-12, atol=0)


@pytest.mark.parametrize("guess", [guesses.by_hand(), guesses.at_random(1), guesses.at_random(2)])
def test_guesses_are_half_a_cycle_of_a_symmetric_motion_on_the_ground(guess):
    for joint in model.JOINTS:
        assert guess[f"{joint}_r_rad"].iloc[-1] == pytest.approx(guess[f"{joint}_l_rad"].iloc[0], abs=1e-9)
        assert guess[f"{joint}_l_rad"].iloc[-1] == pytest.approx(guess[f"{joint}_r_rad"].iloc[0], abs=1e-9)
    gone = guess["forward_m"].iloc[-1] - guess["forward_m"].iloc[0]
    assert gone / guess["time_s"].iloc[-1] == pytest.approx(problem.SPEED)


def test_a_seed_is_one_guess():
    pd.testing.assert_frame_equal(guesses.at_random(3), guesses.at_random(3))
    assert not guesses.at_random(3).equals(guesses.at_random(4))


@pytest.fixture(scope="module")
def square(tmp_path_factory):
    """2 × 2 of the grid at a coarse mesh, from the guess that is kept beside the program."""
    folder = tmp_path_factory.mktemp("walker")
    manifest = contacts.grid(folder / "models", dissipations=(0.5, 2.0)).manifest
    table = pd.read_csv(manifest).sort_values(["stiffness", "dissipation"])
    table["path"] = [str(manifest.parent / file) for file in table["file"]]
    rows = table.iloc[[2, 3, 6, 7]][["path", "stiffness", "dissipation", "dimensionless_stiffness"]]
    task = simulate.Function(walk.walk, {"mesh": COARSE, "start": "guess.csv"}, version=walk.version())
    return simulate.run(rows, task, results=folder / "results", workers=2, scheduler="here")


def test_a_square_of_the_grid_is_solved_and_no_bound_is_active(square):
    table = square.table
    assert len(table) == 4 and not len(square.failures)
    assert (table["converged"] == 1).all(), table
    assert (table["active_bounds"] == 0).all(), table
    # Five values of k̂ from 1.2 to 1.5/0.16, equally far apart in the logarithm; these are the second and the fourth.
    ratio = (1.5 / 0.16 / 1.2) ** 0.25
    assert sorted(set(table["dimensionless_stiffness"])) == pytest.approx([1.2 * ratio, 1.2 * ratio**3], rel=1e-9)


def test_the_effort_is_that_of_the_torques_and_the_speed_is_kept(square):
    """The integral by Simpson's rule over the mesh, as Hermite–Simpson collocation has it, of torques in N m."""
    for place, row in square.table.iterrows():
        series = square.series(int(place))
        names = [name for name in series.columns if name.endswith("_control")]
        assert len(names) == 6
        largest = 0.5 * KG * G * LEG_M
        squares = ((series[names] * largest / (KG * G * LEG_M)) ** 2).sum(axis=1).to_numpy()
        time = series["time_s"].to_numpy()
        step = time[2] - time[0]
        whole = step / 6 * (squares[:-2:2] + 4 * squares[1:-1:2] + squares[2::2]).sum()
        gone = series["forward_m"].iloc[-1]
        assert gone / time[-1] == pytest.approx(1.2, rel=1e-3)
        assert row["effort"] == pytest.approx(100 * math.sqrt(G * LEG_M) / gone * whole, rel=1e-6)


def test_the_ground_carries_the_body(square):
    """Over half a cycle, which ends as it began, the mean vertical force is the weight: by Simpson's rule, as the mesh has it."""
    for place in range(4):
        series = square.series(place)
        force = (series["force_r_bw"] + series["force_l_bw"]).to_numpy()
        mean = (force[:-2:2] + 4 * force[1:-1:2] + force[2::2]).mean() / 6
        assert mean == pytest.approx(1, abs=1e-3)


def test_the_square_has_the_effects_that_the_page_claims(square):
    """Stiffer contacts and less dissipation cost less; the coarse mesh finds the efforts of the committed table."""
    effort = square.table.pivot(index="stiffness", columns="dissipation", values="effort").to_numpy()
    claim = 3 * np.abs(page.mesh_errors(page.read("mesh"))).max()
    assert effort[0, 0] < effort[0, 1] / (1 + claim) and effort[1, 0] < effort[1, 1] / (1 + claim)
    assert (effort[1] < effort[0] / (1 + claim)).all()
    committed = page.read("grid").pivot(index="stiffness", columns="dissipation", values="effort")
    assert effort == pytest.approx(committed.to_numpy()[[1, 3]][:, [1, 3]], rel=0.04)


def test_the_committed_tables_are_well_posed():
    """No bound is active where a search converged, and twice the mesh changes the effort by less than 2 %."""
    mesh = page.read("mesh")
    assert len(mesh) == 5 and (mesh["converged"] == 1).all()
    assert np.abs(page.mesh_errors(mesh)).max() < 0.02
    assert (mesh["active_bounds_at_double_mesh"] == 0).all()
    for name in ("grid", "branch", "mesh", "random", "sizes", "sizes_by_hand"):
        table = page.read(name)
        assert (table.loc[table["converged"] == 1, "active_bounds"] == 0).all(), name
    assert len(page.read("grid")) == len(page.read("branch")) == 25
    for name in ("success", "ladder"):
        table = page.read(name)
        assert (
            table["seed"].nunique() >= 20 and (table.groupby(list(table.columns[:1]))["seed"].nunique() >= 20).all()
        ), name
    climbed = page.read("ladder")
    assert (climbed.loc[climbed["solved"] == 1, "active_bounds"] == 0).all()


def test_the_page_says_what_the_committed_tables_say():
    text = (TOP / "docs" / "studies" / "walker.md").read_text(encoding="utf-8")
    for name, block in page.BLOCKS.items():
        printed = text.split(f"<!-- begin {name} -->")[1].split(f"<!-- end {name} -->")[0]
        assert printed.strip() == "\n".join(block()), name


def test_the_grid_that_is_made_is_that_of_the_committed_table(tmp_path):
    (tmp_path / "models").mkdir()
    made = pd.DataFrame(walker.grid_rows(SimpleNamespace(results=tmp_path))).set_index("index")
    committed = page.read("grid").set_index("index")
    for name in ("stiffness", "dissipation", "relative_indentation", "dimensionless_stiffness", "restitution"):
        assert made[name].to_numpy() == pytest.approx(committed[name].to_numpy(), rel=1e-5), name


def test_rescaled_walkers_walk_alike_and_others_do_not():
    for _, row in page.read("sizes").iterrows():
        share = page.apart(page.read("sizes_curves"), row)
        assert share < 1e-3 if row["contacts"] == "rescaled" else share > 0.1, row


def test_the_program_says_what_it_does():
    process = subprocess.run([sys.executable, HERE / "walker.py", "--help"], capture_output=True, text=True)
    assert process.returncode == 0 and "branch" in process.stdout
