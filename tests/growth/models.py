"""Models that grow in one thing: forces, spheres, bodies, defaults, or forces that share spheres.

Each is a foot or a chain of bodies with as little beside that one thing as possible, so that time that does not grow with
it does not hide time that grows with its square.
"""

import math
import re

HALF_PI = 1.5707963267948966
FLOOR = (
    '<ContactHalfSpace name="floor"><socket_frame>/ground</socket_frame><location>0 0 0</location>'
    f"<orientation>0 0 -{HALF_PI}</orientation></ContactHalfSpace>"
)


def forces(n):
    """n spheres on one foot, each with a force of its own."""
    return model(feet(2), spheres(n, foot), [smooth(i, i, of=n) for i in range(n)])


def spheres_only(n):
    """n spheres, of which two have a force."""
    return model(feet(2), spheres(max(n, 2), foot), [smooth(i, i) for i in range(2)])


def feet_of_their_own(n):
    """n bodies at the pelvis, each with a sphere and a force."""
    return model(feet(n), spheres(n, lambda i: foot(i, n)), [smooth(i, i) for i in range(n)])


def circle(n):
    """A model as of `feet_of_their_own`, the joints on a circle: each pair of them may be the one that is farthest apart."""
    bodies, joints = feet(n)
    angles = [2 * math.pi * i / n for i in range(n)]
    places = [f"{0.1 * math.cos(angle)} -0.1 {0.1 * math.sin(angle)}" for angle in angles]
    around = [one.replace("<translation>0 -0.1 0<", f"<translation>{place}<") for one, place in zip(joints[1:], places)]
    return model((bodies, [joints[0], *around]), spheres(n, lambda i: foot(i, n)), [smooth(i, i) for i in range(n)])


def chain(n):
    """Two legs of n bodies together, each body at the one before; the last of each leg carries a sphere."""
    return model(legs(n), spheres(2, lambda i: foot(n - 2 + i, n)), [smooth(i, i) for i in range(2)])


def chain_with_spheres(n):
    """A model as of `chain`, with a sphere and a force on every body."""
    return model(legs(n), spheres(n, lambda i: foot(i, n)), [smooth(i, i) for i in range(n)])


def defaults(n):
    """n objects in <defaults>, and n spheres with a force that look up theirs."""
    objects = "".join(f'<Marker name="default{i}"><location>0 0 0</location></Marker>' for i in range(n))
    objects += '<SmoothSphereHalfSpaceForce name="default"><transition_velocity>0.2</transition_velocity>'
    objects += "</SmoothSphereHalfSpaceForce>"
    some = [smooth(i, i, short=True, of=n) for i in range(n)]
    return model(feet(2), spheres(n, foot), some, f"<defaults>{objects}</defaults>")


def shared(n):
    """n forces on one sphere of each foot."""
    return model(feet(2), spheres(2, foot), [smooth(i, i % 2, of=n) for i in range(n)])


def one_force(n):
    """Forces of the older kind, one for each foot, that names n spheres together."""
    halves = [" ".join(f"s{i}" for i in range(n) if i % 2 == side) for side in range(2)]
    some = [hunt_crossley(side, f"{names} floor") for side, names in enumerate(halves)]
    return model(feet(2), spheres(max(n, 2), foot), some)


def apart(n):
    """A force of the older kind that names n spheres of n bodies, which are so far apart that no two touch."""
    bodies, joints = feet(n)
    apart = [one.replace("<translation>0 -0.1 0<", f"<translation>{2 * i} -0.1 0<") for i, one in enumerate(joints[1:])]
    names = " ".join(f"s{i}" for i in range(n))
    return model((bodies, [joints[0], *apart]), spheres(n, lambda i: foot(i, n)), [hunt_crossley(0, f"{names} floor")])


def named(n):
    """n forces of the older kind that call their spheres by name."""
    return model(feet(2), spheres(n, foot), [hunt_crossley(i, f"s{i} floor") for i in range(n)])


def radii(n):
    """A model as of `named`, with another radius for each sphere."""
    some = [one.replace("<radius>0.032", f"<radius>{0.032 + 1e-6 * i:.6f}") for i, one in enumerate(spheres(n, foot))]
    return model(feet(2), some, [hunt_crossley(i, f"s{i} floor") for i in range(n)])


def many_sets(n):
    """A force of the older kind for each foot, with a parameter set for each of n spheres together and one for the floor."""
    parameters = re.search("<HuntCrossleyForce::ContactParameters>.*</HuntCrossleyForce::ContactParameters>", hunt_crossley(0, "GEOMETRY"))[0]
    some = []
    for side in range(2):
        names = [*(f"s{i}" for i in range(n) if i % 2 == side), "floor"]
        some.append(hunt_crossley(side, "GEOMETRY").replace(parameters, "".join(parameters.replace("GEOMETRY", name) for name in names)))
    return model(feet(2), spheres(max(n, 2), foot), some)


def shared_by_all(n):
    """n forces of the older kind, each with its own sphere and one of eight that they share."""
    some = [hunt_crossley(i, f"s{i} s{i % 8} floor") for i in range(n)]
    return model(feet(2), spheres(max(n, 8), foot), some)


def bare_sockets(n):
    """A model as of `forces`, with a marker for each sphere, and bare names where OpenSim needs paths."""
    markers = [f'<Marker name="m{i}"><socket_parent_frame>{foot(i)}</socket_parent_frame></Marker>' for i in range(n)]
    some = [smooth(i, i, of=n).replace("/contactgeometryset/", "") for i in range(n)]
    bare = [one.replace("/bodyset/", "") for one in spheres(n, foot)]
    return model(feet(2), bare, some, f"<MarkerSet><objects>{''.join(markers)}</objects></MarkerSet>")


def foundations(n):
    """A model as of `forces`, and n forces of another class."""
    others = [hunt_crossley(i, f"s{i} floor").replace("HuntCrossley", "ElasticFoundation").replace('"f', '"e') for i in range(n)]
    return model(feet(2), spheres(n, foot), [*(smooth(i, i, of=n) for i in range(n)), *others])


def same_name(n):
    """n forces with one and the same name."""
    some = [smooth(i, i, of=n).replace(f'name="f{i}"', 'name="f"') for i in range(n)]
    return model(feet(2), spheres(n, foot), some)


def sunk_in(n):
    """A model as of `forces`, each with findings of its own: no smoothness, dissipation below nothing, a long name."""
    some = [smooth(i, i).replace("<dissipation>2", "<dissipation>0").replace("<stiffness>1e6", f"<stiffness>1e{2 + i % 3}") for i in range(n)]
    return model(feet(2), spheres(n, foot), some)


def brackets(n):
    """Credits with three n square brackets, where a note could begin: with blanks after them and without."""
    credits = "see [1], [2]; " * n + "[" * n
    return model(feet(2), spheres(2, foot), [smooth(i, i) for i in range(2)], f"<credits>{credits}</credits>")


# A motion of all kinds of models here: nothing moves.
STILL = "still\nversion=1\ninDegrees=no\nendheader\ntime\t/jointset/pelvis_joint/_coord_0/value\n" + "".join(f"{i / 100}\t0\n" for i in range(8))

KINDS = {
    "forces": forces,
    "spheres": spheres_only,
    "bodies": feet_of_their_own,
    "circle": circle,
    "chain": chain,
    "chain+": chain_with_spheres,
    "defaults": defaults,
    "shared": shared,
    "one force": one_force,
    "apart": apart,
    "named": named,
    "radii": radii,
    "many sets": many_sets,
    "shared+": shared_by_all,
    "bare sockets": bare_sockets,
    "foundations": foundations,
    "same name": same_name,
    "findings": sunk_in,
    "brackets": brackets,
}


def model(bodies_and_joints, contact_spheres, contact_forces, before=""):
    bodies, joints = bodies_and_joints
    sets = [
        ("BodySet", bodies),
        ("JointSet", joints),
        ("ContactGeometrySet", [FLOOR, *contact_spheres]),
        ("ForceSet", contact_forces),
    ]
    lines = ['<?xml version="1.0" encoding="UTF-8" ?>', '<OpenSimDocument Version="40000">', '<Model name="growth">']
    lines += [before, '<Ground name="ground"/>', "<gravity>0 -9.80665 0</gravity>"]
    for tag, items in sets:
        lines += [f'<{tag} name="{tag.lower()}"><objects>', *items, f"</objects><groups/></{tag}>"]
    return "\n".join([*lines, "</Model></OpenSimDocument>", ""])


def foot(number, feet=2):
    return f"foot{number % feet // 2}_{'rl'[number % 2]}"


def feet(n):
    """A pelvis and n feet at it."""
    names = [foot(i, n) for i in range(n)]
    bodies = [body("pelvis", 1), *(body(name, n) for name in names)]
    return bodies, [joint("pelvis", None), *(joint(name, "pelvis") for name in names)]


def legs(n):
    """A pelvis, and n bodies in two chains from it."""
    names = [foot(i, n) for i in range(n)]
    bodies, joints = feet(n)
    return bodies, [joints[0], *(joint(name, names[i - 2] if i > 1 else "pelvis") for i, name in enumerate(names))]


def body(name, of):
    """A body, one of `of` bodies that weigh 40 kg together."""
    return (
        f'<Body name="{name}"><attached_geometry><Mesh name="bone"><scale_factors>1 1 1</scale_factors>'
        f"<mesh_file>{name}.vtp</mesh_file></Mesh></attached_geometry><mass>{40 / of}</mass><mass_center>0 0 0</mass_center>"
        "<inertia>1 1 1 0 0 0</inertia></Body>"
    )


def joint(name, parent):
    path = f"/bodyset/{parent}" if parent else "/ground"
    return (
        f'<PinJoint name="{name}_joint"><socket_parent_frame>parent_offset</socket_parent_frame>'
        f"<socket_child_frame>/bodyset/{name}</socket_child_frame>"
        f'<frames><PhysicalOffsetFrame name="parent_offset"><socket_parent>{path}</socket_parent>'
        "<translation>0 -0.1 0</translation></PhysicalOffsetFrame></frames></PinJoint>"
    )


def spheres(n, body_of):
    return [
        f'<ContactSphere name="s{i}"><socket_frame>/bodyset/{body_of(i)}</socket_frame>'
        f"<location>{i % 100 / 100} -0.01 {i // 100 / 100}</location><radius>0.032</radius></ContactSphere>"
        for i in range(n)
    ]


def smooth(number, sphere, short=False, of=64):
    """`short`: the rest comes from <defaults>. The softer, the more there are: how long a search for the rest takes follows from how deep
    spheres sink."""
    rest = "" if short else "<transition_velocity>0.2</transition_velocity>"
    stiffness = f"{6.4e7 / of:.6g}".replace("e+0", "e")
    return (
        f'<SmoothSphereHalfSpaceForce name="f{number}"><socket_sphere>/contactgeometryset/s{sphere}</socket_sphere>'
        f"<socket_half_space>/contactgeometryset/floor</socket_half_space><stiffness>{stiffness}</stiffness>"
        "<dissipation>2</dissipation><static_friction>0.8</static_friction><dynamic_friction>0.8</dynamic_friction>"
        f"<viscous_friction>0.5</viscous_friction>{rest}</SmoothSphereHalfSpaceForce>"
    )


def hunt_crossley(number, geometry):
    return (
        f'<HuntCrossleyForce name="f{number}"><HuntCrossleyForce::ContactParametersSet name="contact_parameters"><objects>'
        f"<HuntCrossleyForce::ContactParameters><geometry>{geometry}</geometry><stiffness>1e7</stiffness>"
        "<dissipation>1</dissipation><static_friction>0.8</static_friction><dynamic_friction>0.8</dynamic_friction>"
        "<viscous_friction>0.5</viscous_friction></HuntCrossleyForce::ContactParameters></objects><groups/>"
        "</HuntCrossleyForce::ContactParametersSet><transition_velocity>0.1</transition_velocity></HuntCrossleyForce>"
    )
