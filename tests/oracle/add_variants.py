"""Models without contacts, of two feet with toes, in documents of every version and in forms that the corpus lacks.

`chosen()` gives `(name, text)`: every version and every form, but not each with each unless `ORACLE_DOCUMENTS=all`. Meshes are of uneven factors; the left foot's are the right one's.
"""

import os
import sys

from models import FIXTURES

sys.path.insert(0, str(FIXTURES))

from quirks import versions  # noqa: E402  (the fixtures' own building blocks)
from quirks.base import body, edit, free_joint, half_space, indent  # noqa: E402

OLD = (10905, 20001, 20302, 30000, 30500)  # joints in bodies
NEW = (30505, 30517, 40000, 40600)
FORMS = ("empty_sets", "no_sets", "two_force_sets", "floor_in_components", "no_meshes")

# Body: mass, the joint above it with its parent and place, mesh and its factors. The right side.
MASSES = {"pelvis": "50.25", "calcn": "1.75", "toes": "0.375"}
PLACES = {"calcn": ("ankle", "pelvis", (-0.04, -0.87, 0.09)), "toes": ("mtp", "calcn", (0.181, -0.0035, 0.0012))}
MESHES = {"calcn": ("foot", "1.07 1.02 1.11"), "toes": ("bofoot", "1.07 1.02 1.13")}


def documents():
    """Name and text of each: versions and forms."""
    for version in (*OLD, *NEW):
        for form in FORMS:
            yield f"{form}_{version}", document(version, form)


def with_mesh(factors):
    """The right foot with a second mesh of the same bone."""
    mesh = f'<Mesh name="second"><socket_frame>..</socket_frame><scale_factors>{factors}</scale_factors><mesh_file>r_foot.vtp</mesh_file></Mesh>'
    return edit(document(40000, "empty_sets"), (">foot.vtp</mesh_file>\n\t\t\t\t\t\t</Mesh>", f">foot.vtp</mesh_file></Mesh>{mesh}"))


def with_left(factors):
    """The left foot's mesh with other factors."""
    old = "<scale_factors>1.07 1.02 1.11</scale_factors>\n\t\t\t\t\t\t\t<mesh_file>l_foot.vtp"
    return edit(document(40000, "empty_sets"), (old, old.replace("1.07 1.02 1.11", factors)))


def sources():
    """Name and text of models whose sources of factors differ, but not so far that it has to be asked."""
    yield "toes_of_one_side", edit(document(40000, "empty_sets"), ("l_bofoot.vtp", "other.vtp"))
    yield "no_toes", document(40000, "empty_sets").replace("bofoot.vtp", "other.vtp")
    yield "sides_4_percent_apart", with_left("1.07 1.06 1.11")
    yield "meshes_half_a_percent_apart", with_mesh("1.075 1.02 1.11")
    yield "joint_farther_than_the_mesh", document(40000, "empty_sets").replace("0.181", "0.231")
    yield "mirrored_mesh", with_left("1.07 1.02 -1.11")


def chosen():
    """All documents, or two forms of each version in turn."""
    every = list(documents())
    if os.environ.get("ORACLE_DOCUMENTS") == "all":
        return [*every, *sources()]
    step = len(FORMS)
    return [one for number, one in enumerate(every) if (number % step - 2 * (number // step)) % step < 2] + list(sources())


def document(version, form):
    """A pelvis over two feet, in one form."""
    parts = ["<gravity>0 -9.80665 0</gravity>"]
    parts += old_parts(version, form) if version in OLD else new_parts(form)
    if form == "floor_in_components":
        parts.insert(0, f"<components>\n{indent(plane(version), 1)}</components>")
    parts += sets(form)
    inner = "".join(indent(part, 2) for part in parts)
    head = f'<?xml version="1.0" encoding="UTF-8" ?>\n<OpenSimDocument Version="{version}">\n\t<Model name="feet">\n'
    return f"{head}{inner}\t</Model>\n</OpenSimDocument>\n"


def plane(version):
    """A floor with a name and a height of its own."""
    text = half_space("pavement").replace("<location>0 0 0<", "<location>0 0.125 0<")
    return text.replace("<socket_frame>/ground</socket_frame>", "<body_name>ground</body_name>") if version in OLD else text


def sets(form):
    """The sets of a model before contacts are added."""
    if form == "no_sets":
        return []
    if form == "two_force_sets":
        return [forces("push"), "<ContactGeometrySet>\n\t<objects/>\n\t<groups/>\n</ContactGeometrySet>", forces("ignored")]
    return ["<ForceSet>\n\t<objects/>\n</ForceSet>", '<ContactGeometrySet name="contactgeometryset">\n\t<objects />\n</ContactGeometrySet>']


def forces(name):
    """A force set with a force that is not a contact."""
    push = f'<PointActuator name="{name}">\n\t<body>pelvis</body>\n\t<optimal_force>3</optimal_force>\n</PointActuator>'
    return f"<ForceSet>\n\t<objects>\n{indent(push, 2)}\t</objects>\n\t<groups/>\n</ForceSet>"


def limbs():
    """`(body, mass, joint, parent, place, mesh file, factors)` of each body but the pelvis."""
    for side, sign in (("r", 1), ("l", -1)):
        for part, (joint, parent, (x, y, z)) in PLACES.items():
            bone, factors = MESHES[part]
            above = parent if parent == "pelvis" else f"{parent}_{side}"
            file = f"{bone}.vtp" if side == "r" else f"l_{bone}.vtp"
            yield f"{part}_{side}", MASSES[part], f"{joint}_{side}", above, f"{x} {y} {sign * z}", file, factors


def members(tag, elements):
    inner = "".join(indent(one, 2) for one in elements)
    return f"<{tag}>\n\t<objects>\n{inner}\t</objects>\n\t<groups/>\n</{tag}>"


def old_parts(version, form):
    """Joints in bodies, meshes in a VisibleObject."""
    bodies = [versions.GROUND, versions.old_body("pelvis", MASSES["pelvis"], versions.old_joint("FreeJoint", "ground_pelvis", "ground"))]
    for name, mass, joint, parent, place, file, factors in limbs():
        text = versions.old_body(name, mass, versions.old_joint("PinJoint", joint, parent, place))
        if form != "no_meshes":
            text = text.replace("\n</Body>", "\n" + indent(visible(version, file, factors), 1) + "</Body>")
        bodies.append(text)
    return [members("BodySet", bodies)]


def visible(version, file, factors):
    """How a body of OpenSim 1 to 3 shows its bones: whole factors, which count for every mesh."""
    if version < 20302:
        element = f"<geometry_files> {file} </geometry_files>"
    else:
        element = f"<GeometrySet><objects><DisplayGeometry><geometry_file>{file}</geometry_file></DisplayGeometry></objects></GeometrySet>"
    return f"<VisibleObject>\n\t{element}\n\t<scale_factors> {factors} </scale_factors>\n</VisibleObject>"


def new_parts(form):
    """Bodies with attached geometry, and a JointSet."""
    bodies, joints = [body("pelvis", MASSES["pelvis"])], [free_joint("ground_pelvis", "pelvis")]
    for name, mass, joint, parent, place, file, factors in limbs():
        text = body(name, mass)
        if form != "no_meshes":
            mesh = (
                f'<attached_geometry>\n\t<Mesh name="{name}_geom">\n\t\t<socket_frame>..</socket_frame>\n'
                f"\t\t<scale_factors>{factors}</scale_factors>\n\t\t<mesh_file>{file}</mesh_file>\n\t</Mesh>\n</attached_geometry>"
            )
            text = text.replace("\n</Body>", "\n" + indent(mesh, 1) + "</Body>")
        bodies.append(text)
        joints.append(
            f'<PinJoint name="{joint}">\n\t<socket_parent_frame>{parent}_offset</socket_parent_frame>\n'
            f"\t<socket_child_frame>/bodyset/{name}</socket_child_frame>\n\t<frames>\n"
            f'\t\t<PhysicalOffsetFrame name="{parent}_offset">\n\t\t\t<socket_parent>/bodyset/{parent}</socket_parent>\n'
            f"\t\t\t<translation>{place}</translation>\n\t\t</PhysicalOffsetFrame>\n\t</frames>\n</PinJoint>"
        )
    return ['<Ground name="ground" />', members("BodySet", bodies), members("JointSet", joints)]


NAMES = [name for name, _ in chosen()]
# What has to be asked: name, text, and the body and both values that the question names.
MASS_OPTIONS = (
    ("sides_6_percent_apart", with_left("1.07 1.09 1.11"), ("calcn_r", "calcn_l", "1.1161", "1.1927")),
    ("meshes_2_percent_apart", with_mesh("1.09 1.02 1.11"), ("calcn_r", "foot.vtp", "r_foot.vtp", "1.1708", "1.1927")),
)
