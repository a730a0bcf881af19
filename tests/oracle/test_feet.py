"""Bones of feet in ground at the default pose, and spheres on their soles, against the real OpenSim and NumPy.

OpenSim says where the bodies are, and which meshes are attached to them with which factors and frames. NumPy reads the mesh
files itself, places their points, and compares with what `osim-model` prints through its example `feet`.
"""

import json
import re
import subprocess
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import command
import feet_variants
from apart import Refused, run_one_job
from models import CORPUS, FIXTURES, NO_CORPUS, corpus, label

PLACE = 1e-9  # m
FEET = sorted((FIXTURES / "feet").glob("*.osim"))
GEOMETRY = Path(CORPUS) / "Geometry" if CORPUS else FIXTURES
# What the crate refuses, and why.
REFUSED = {
    "v20303_bouncing_block.osim": "PointOnLineConstraint",
    "v30000_bouncing_block.osim": "PointOnLineConstraint",
    # OpenSim moves the independent coordinate.
    "coupled_constant.osim": "CoordinateCouplerConstraint",
}
# OpenSim needs a contact mesh that is not here.
NOT_READ = {"v30517_elastic_foundation_with_sphere.osim"}


def feet_by_program(*arguments):
    """The lines of JSON that the example prints."""
    run = subprocess.run([command.example("feet"), *map(str, arguments)], capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    return [json.loads(line) for line in run.stdout.splitlines()]


@cache
def opensim(path):
    """OpenSim's reading, from a separate process."""
    return run_one_job("opensim_feet", str(Path(path).absolute()))


@cache
def points_of_file(path):
    """The points of an ASCII .vtp file, each once, read by nothing but a pattern and NumPy."""
    text = Path(path).read_text(encoding="utf-8")
    array = re.search(r"<Points>\s*<DataArray[^>]*>([^<]*)</DataArray>", text).group(1)
    points = np.array(array.split(), dtype=float).reshape(-1, 3)
    _, first = np.unique(points + 0.0, axis=0, return_index=True)
    return points[np.sort(first)]


def placed(matrix, points):
    """Points of a frame in ground."""
    matrix = np.array(matrix)
    return points @ matrix[:, :3].T + matrix[:, 3]


@pytest.mark.parametrize("path", FEET + corpus(), ids=label)
def test_bodies_and_bones_are_where_opensim_has_them(path):
    compare_bones(path)


@pytest.mark.parametrize("name, text", [*feet_variants.poses(), *feet_variants.meshes()], ids=lambda value: value[:40])
def test_variants_are_where_opensim_has_them(name, text, tmp_path):
    """Variants that the corpus lacks: each joint class, function, constraint and spelling."""
    path = tmp_path / f"{name}.osim"
    path.write_text(text, encoding="utf-8")
    (tmp_path / "Geometry").symlink_to(FIXTURES / "feet/Geometry")
    compare_bones(path)


def compare_bones(path):
    """Places of all bodies, and of all points of meshes that are at hand."""
    if path.name in NOT_READ:
        with pytest.raises(Refused):
            opensim(path)
        return
    known = opensim(path)
    lines = feet_by_program("bones", path, GEOMETRY)
    assert len(lines) == len(known["bodies"])
    for line in lines:
        if path.name in REFUSED:
            assert REFUSED[path.name] in line["pose_fault"]
            continue
        body = line["body"]
        frame = np.array(known["bodies"][body])
        corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=float)
        assert np.abs(placed(frame, corners) - line["frame"]).max() < PLACE, body
        meshes = [mesh for mesh in known["meshes"] if mesh["body"] == body]
        if line["fault"]:
            assert not meshes or re.search(r"shows mesh \S+, which is in none of the folders", line["fault"]), line["fault"]
            continue
        # OpenSim lists frames in another order.
        points = [placed(mesh["frame"], np.array(mesh["factors"]) * points_of_file(find_mesh(mesh, path))) for mesh in meshes]
        points, here = np.vstack(points), np.array(line["points"])
        assert len(points) == len(here)
        order, other = np.lexsort(np.round(points, 7).T), np.lexsort(np.round(here, 7).T)
        assert np.abs(points[order] - here[other]).max() < PLACE, body


def find_mesh(mesh, model):
    """The file of a mesh: of its name, of that of the standard right bone, or without the v of some marks of the side."""
    names = (mesh["file"], "r_" + mesh["file"], re.sub(r"^(.+)_([rl])v(\.\w+)$", r"\2_\1\3", mesh["file"]))
    for folder in (model.parent / "Geometry", GEOMETRY):
        for name in names:
            if (folder / name).exists():
                return folder / name
    raise AssertionError(mesh)


@pytest.mark.skipif(not CORPUS, reason=NO_CORPUS)
def test_the_corpus_has_bones_to_compare():
    """The standard foot, toes and talus were read in every model with feet: 2 of each."""
    compared = {path.name: sum(not line.get("fault", "none") for line in feet_by_program("bones", path, GEOMETRY)) for path in corpus()}
    assert sum(count >= 4 for count in compared.values()) >= 15, compared


# Soles.

FOOT_BODIES = {
    "human": "calcn_r,toes_r,calcn_l,toes_l",
    "bird": "toes_r,toes_l",
    "hoof": "hoof_r,hoof_l",
}
RADIUS, PAD = 0.02, 0.012
SOLE_LAYER = 0.1  # of the foot's greatest extent along the ground
ANGLES = np.linspace(0, 2 * np.pi, 720, endpoint=False)
AROUND = np.stack([np.cos(ANGLES), np.sin(ANGLES)])


def feet():
    """Models whose feet have meshes that are at hand, with the bodies of their feet."""
    for path in FEET:
        yield path, FOOT_BODIES[path.stem.split("_")[0]]
    for path in corpus():
        if path.name not in NOT_READ and {mesh["file"] for mesh in opensim(path)["meshes"]} & {"foot.vtp", "r_foot.vtp"}:
            # One model has a foot of one piece.
            yield path, ",".join(body for body in FOOT_BODIES["human"].split(",") if body in opensim(path)["bodies"])


def bone_points(path, bodies):
    """Points in ground and the body of each, from what OpenSim says and NumPy reads."""
    points, owners = [], []
    for mesh in opensim(path)["meshes"]:
        if mesh["body"] in bodies:
            points.append(placed(mesh["frame"], np.array(mesh["factors"]) * points_of_file(find_mesh(mesh, path))))
            owners += [mesh["body"]] * len(points[-1])
    return np.vstack(points), np.array(owners)


def check_sole(path, sole, count):
    """Plane, outline, places and bodies of one sole."""
    points, owners = bone_points(path, sole["bodies"])
    gravity = np.array(opensim(path)["gravity"])
    up = -gravity / np.linalg.norm(gravity)
    assert np.argmax(up) == 1  # y
    heights, flat = points @ up, points[:, [0, 2]]
    assert abs(sole["height"] - (heights.min() - PAD)) < PLACE
    lowest = flat[heights - heights.min() <= SOLE_LAYER * np.ptp(flat, axis=0).max()]
    # A convex outline is how far it reaches in each direction.
    reach = (lowest @ AROUND).max(axis=0)
    outline = np.array(sole["outline"])
    assert np.abs(outline @ up - sole["height"]).max() < PLACE
    assert np.abs((outline[:, [0, 2]] @ AROUND).max(axis=0) - reach).max() < PLACE

    spheres = sole["spheres"]
    assert len(spheres) == count
    bottoms = np.array([sphere["bottom"] for sphere in spheres])
    assert np.abs(bottoms @ up - sole["height"]).max() < PLACE
    assert ((bottoms[:, [0, 2]] @ AROUND).max(axis=0) <= reach + PLACE).all()
    if count > 1:
        apart = np.linalg.norm(bottoms[:, None] - bottoms[None], axis=2) + np.eye(count)
        assert apart.min() >= 1e-3
    if count >= 4:
        assert (np.ptp(bottoms[:, [0, 2]], axis=0) >= 0.8 * np.ptp(lowest, axis=0)).all()
    for sphere, bottom in zip(spheres, bottoms):
        assert sphere["radius"] == RADIUS
        centre = placed(opensim(path)["bodies"][sphere["body"]], np.array(sphere["centre"]))
        assert np.abs(centre - (bottom + RADIUS * up)).max() < PLACE
        distances = np.linalg.norm(points - bottom, axis=1)
        assert distances[owners == sphere["body"]].min() <= distances.min() + PLACE


def mirrored_bones(path, bodies):
    """Whether the points of these bodies are mirror images of those of the other side: in their own frames, and in ground."""
    sides = {}
    for side, sign in (("_r", 1), ("_l", -1)):
        names = [body.replace("_r", side) for body in bodies]
        meshes = [mesh for mesh in opensim(path)["meshes"] if mesh["body"] in names]
        own_points = np.vstack([np.array(mesh["factors"]) * points_of_file(find_mesh(mesh, path)) for mesh in meshes])
        both_sides = np.hstack([own_points, bone_points(path, names)[0]]) * (1, 1, sign, 1, 1, sign)
        sides[side] = both_sides[np.lexsort(np.round(both_sides[:, :3], 7).T)]
    right, left = sides.values()
    return len(right) == len(left) and np.abs(right - left).max() < PLACE


@pytest.mark.parametrize("count", [1, 2, 3, 4, 6, 9])
@pytest.mark.parametrize("path, bodies", list(feet()), ids=lambda value: label(value) if isinstance(value, Path) else "")
def test_spheres_stand_on_the_sole(path, bodies, count):
    lines = feet_by_program("soles", path, GEOMETRY, bodies, count, RADIUS, PAD)
    assert [line.get("side") for line in lines] == ["right", "left"], lines
    for sole in lines:
        check_sole(path, sole, count)
    right, left = lines
    if mirrored_bones(path, right["bodies"]):
        for one, other in zip(right["spheres"], left["spheres"]):
            assert one["body"].replace("_r", "_l") == other["body"]
            assert np.abs(np.array(one["centre"]) * (1, 1, -1) - other["centre"]).max() < PLACE


def test_feet_were_compared():
    """Our own three animals in two versions, one with a mesh in millimetres, the corpus' standard feet, and mirror images among all."""
    compared = [path for path, bodies in feet() if mirrored_bones(path, bodies.split(",")[: bodies.count(",") // 2 + 1])]
    assert len([path for path in compared if path in FEET]) == 7
    if CORPUS:
        assert len(compared) >= 7 + 10, compared
