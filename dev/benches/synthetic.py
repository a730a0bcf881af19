"""Models of any size: segments with a body, a joint, muscles and contacts each, as OpenSim 4 would spell them.

A pair of segments (right and left) takes about 110 KB, much of it in paths of muscles and in OpenSim's own comments, as
in published models. Two legs branch from the pelvis; every segment carries one sphere with one contact force.
"""

import itertools
import random

HEAD = """<?xml version="1.0" encoding="UTF-8" ?>
<OpenSimDocument Version="40000">
\t<Model name="synthetic">
\t\t<Ground name="ground">
\t\t\t<attached_geometry />
\t\t</Ground>
\t\t<!--Acceleration due to gravity, expressed in ground.-->
\t\t<gravity>0 -9.8066499999999994 0</gravity>
"""
BODY = """\t\t\t\t<Body name="{name}">
\t\t\t\t\t<!--List of geometry attached to this Frame. Note, the geometry are treated as fixed to the frame and they share the transform of the frame when visualized-->
\t\t\t\t\t<attached_geometry>
\t\t\t\t\t\t<Mesh name="{name}_geom_1">
\t\t\t\t\t\t\t<!--Path to a Component that satisfies the Socket 'frame' of type Frame.-->
\t\t\t\t\t\t\t<socket_frame>..</socket_frame>
\t\t\t\t\t\t\t<!--Scale factors in X, Y, Z directions respectively.-->
\t\t\t\t\t\t\t<scale_factors>{a:.17g} {b:.17g} {a:.17g}</scale_factors>
\t\t\t\t\t\t\t<!--Name of geometry file.-->
\t\t\t\t\t\t\t<mesh_file>{name}.vtp</mesh_file>
\t\t\t\t\t\t</Mesh>
\t\t\t\t\t</attached_geometry>
\t\t\t\t\t<!--The mass of the body (kg)-->
\t\t\t\t\t<mass>{a:.17g}</mass>
\t\t\t\t\t<!--The location (Vec3) of the mass center in the body frame.-->
\t\t\t\t\t<mass_center>0 {b:.17g} 0</mass_center>
\t\t\t\t\t<!--The elements of the inertia tensor (Vec6) as [Ixx Iyy Izz Ixy Ixz Iyz] measured about the mass_center and not the body origin.-->
\t\t\t\t\t<inertia>{a:.17g} {b:.17g} {a:.17g} 0 0 0</inertia>
\t\t\t\t</Body>
"""
JOINT = """\t\t\t\t<PinJoint name="{name}_joint">
\t\t\t\t\t<!--Path to a Component that satisfies the Socket 'parent_frame' of type PhysicalFrame (description: The parent frame for the joint.).-->
\t\t\t\t\t<socket_parent_frame>{parent}_offset</socket_parent_frame>
\t\t\t\t\t<!--Path to a Component that satisfies the Socket 'child_frame' of type PhysicalFrame (description: The child frame for the joint.).-->
\t\t\t\t\t<socket_child_frame>{name}_offset</socket_child_frame>
\t\t\t\t\t<!--Physical offset frames owned by the Joint that are typically used to satisfy the owning Joint's parent and child frame connections (sockets).-->
\t\t\t\t\t<frames>
\t\t\t\t\t\t<PhysicalOffsetFrame name="{parent}_offset">
\t\t\t\t\t\t\t<socket_parent>{parent_path}</socket_parent>
\t\t\t\t\t\t\t<translation>{a:.17g} {b:.17g} 0</translation>
\t\t\t\t\t\t</PhysicalOffsetFrame>
\t\t\t\t\t\t<PhysicalOffsetFrame name="{name}_offset">
\t\t\t\t\t\t\t<socket_parent>/bodyset/{name}</socket_parent>
\t\t\t\t\t\t\t<translation>0 0 0</translation>
\t\t\t\t\t\t</PhysicalOffsetFrame>
\t\t\t\t\t</frames>
\t\t\t\t</PinJoint>
"""
POINT = """\t\t\t\t\t\t\t\t<PathPoint name="{name}_m{muscle}-P{point}">
\t\t\t\t\t\t\t\t\t<!--Path to a Component that satisfies the Socket 'parent_frame' of type PhysicalFrame (description: The frame in which this path point is defined.).-->
\t\t\t\t\t\t\t\t\t<socket_parent_frame>/bodyset/{name}</socket_parent_frame>
\t\t\t\t\t\t\t\t\t<!--The fixed location of the path point expressed in its parent frame.-->
\t\t\t\t\t\t\t\t\t<location>{a:.17g} {b:.17g} {c:.17g}</location>
\t\t\t\t\t\t\t\t</PathPoint>
"""
MUSCLE = """\t\t\t\t<Thelen2003Muscle name="{name}_m{muscle}">
\t\t\t\t\t<!--The set of points defining the path of the actuator.-->
\t\t\t\t\t<GeometryPath name="geometrypath">
\t\t\t\t\t\t<PathPointSet>
\t\t\t\t\t\t\t<objects>
{points}\t\t\t\t\t\t\t</objects>
\t\t\t\t\t\t\t<groups />
\t\t\t\t\t\t</PathPointSet>
\t\t\t\t\t</GeometryPath>
\t\t\t\t\t<!--Maximum isometric force that the fibers can generate-->
\t\t\t\t\t<max_isometric_force>{force:.17g}</max_isometric_force>
\t\t\t\t\t<!--Optimal length of the muscle fibers-->
\t\t\t\t\t<optimal_fiber_length>{a:.17g}</optimal_fiber_length>
\t\t\t\t\t<!--Resting length of the tendon-->
\t\t\t\t\t<tendon_slack_length>{b:.17g}</tendon_slack_length>
\t\t\t\t\t<!--Angle between tendon and fibers at optimal fiber length expressed in radians-->
\t\t\t\t\t<pennation_angle_at_optimal>0.13962633999999999</pennation_angle_at_optimal>
\t\t\t\t\t<!--Activation time constant, in seconds-->
\t\t\t\t\t<activation_time_constant>0.01</activation_time_constant>
\t\t\t\t</Thelen2003Muscle>
"""
FLOOR = """\t\t\t\t<ContactHalfSpace name="floor">
\t\t\t\t\t<socket_frame>/ground</socket_frame>
\t\t\t\t\t<location>0 0 0</location>
\t\t\t\t\t<orientation>0 0 -1.5707963267948966</orientation>
\t\t\t\t</ContactHalfSpace>
"""
SPHERE = """\t\t\t\t<ContactSphere name="s_{name}">
\t\t\t\t\t<!--Path to a Component that satisfies the Socket 'frame' of type PhysicalFrame (description: The frame to which this geometry is attached.).-->
\t\t\t\t\t<socket_frame>/bodyset/{name}</socket_frame>
\t\t\t\t\t<!--Location of geometry center in the PhysicalFrame.-->
\t\t\t\t\t<location>{a:.17g} -0.01 {b:.17g}</location>
\t\t\t\t\t<!--Radius of the sphere (default: 0).-->
\t\t\t\t\t<radius>0.032000000000000001</radius>
\t\t\t\t</ContactSphere>
"""
CONTACT = """\t\t\t\t<SmoothSphereHalfSpaceForce name="contact_{name}">
\t\t\t\t\t<socket_sphere>/contactgeometryset/s_{name}</socket_sphere>
\t\t\t\t\t<socket_half_space>/contactgeometryset/floor</socket_half_space>
\t\t\t\t\t<!--The stiffness constant (i.e., plain strain modulus), default is 1 (N/m^2)-->
\t\t\t\t\t<stiffness>1000000</stiffness>
\t\t\t\t\t<!--The dissipation coefficient, default is 0 (s/m).-->
\t\t\t\t\t<dissipation>2</dissipation>
\t\t\t\t\t<static_friction>0.80000000000000004</static_friction>
\t\t\t\t\t<dynamic_friction>0.80000000000000004</dynamic_friction>
\t\t\t\t\t<viscous_friction>0.5</viscous_friction>
\t\t\t\t\t<transition_velocity>0.20000000000000001</transition_velocity>
\t\t\t\t</SmoothSphereHalfSpaceForce>
"""
MUSCLES, POINTS = 10, 9


def write(path, size):
    """A model of at least `size` bytes, to within a pair of segments; the same for the same size."""
    dice = random.Random(size)
    pairs = max(1, round(size / len("".join(pair(1, dice)).encode())))
    segments = [segment(side, number) for number in range(1, pairs + 1) for side in "rl"]
    with open(path, "w", encoding="utf-8", newline="\n") as out:
        out.write(HEAD)
        bodies = [("pelvis", None), *segments]
        write_set(out, "BodySet", "bodyset", (body(name, dice) for name, _ in bodies))
        write_set(out, "JointSet", "jointset", (joint(name, parent, dice) for name, parent in [("pelvis", ""), *segments]))
        write_set(out, "ContactGeometrySet", "contactgeometryset", [FLOOR, *(sphere(name, dice) for name, _ in segments)])
        write_set(out, "ForceSet", "forceset", (text for name, _ in segments for text in forces(name, dice)))
        out.write("\t</Model>\n</OpenSimDocument>\n")


def write_forces(path, count):
    """Two feet with `count` spheres and contact forces together, spelled as OpenSim does; no muscles."""
    dice = random.Random(count)
    feet = ["foot_r", "foot_l"]
    with open(path, "w", encoding="utf-8", newline="\n") as out:
        out.write(HEAD)
        write_set(out, "BodySet", "bodyset", (body(name, dice) for name in ["pelvis", *feet]))
        write_set(out, "JointSet", "jointset", [joint("pelvis", "", dice), *(joint(name, "pelvis", dice) for name in feet)])
        on_foot = "<socket_frame>/bodyset/{}</socket_frame>"
        spheres = (
            sphere(f"c{i}", dice).replace(on_foot.format(f"c{i}"), on_foot.format(feet[i % 2])) for i in range(count)
        )
        write_set(out, "ContactGeometrySet", "contactgeometryset", itertools.chain([FLOOR], spheres))
        write_set(out, "ForceSet", "forceset", (CONTACT.format(name=f"c{i}") for i in range(count)))
        out.write("\t</Model>\n</OpenSimDocument>\n")


def segment(side, number):
    """Name and parent: a leg that branches in two at every segment, so that no way to the pelvis is long."""
    return f"segment{number}_{side}", "pelvis" if number == 1 else f"segment{number // 2}_{side}"


def pair(number, dice):
    """All text of one right and one left segment."""
    for side in "rl":
        name, parent = segment(side, number)
        yield body(name, dice)
        yield joint(name, parent, dice)
        yield sphere(name, dice)
        yield from forces(name, dice)


def body(name, dice):
    return BODY.format(name=name, a=dice.random(), b=dice.random())


def joint(name, parent, dice):
    path = f"/bodyset/{parent}" if parent else "/ground"
    return JOINT.format(name=name, parent=parent or "ground", parent_path=path, a=dice.random(), b=dice.random())


def sphere(name, dice):
    return SPHERE.format(name=name, a=dice.random(), b=dice.random())


def forces(name, dice):
    for muscle in range(MUSCLES):
        points = "".join(
            POINT.format(name=name, muscle=muscle, point=p, a=dice.random(), b=dice.random(), c=dice.random())
            for p in range(1, POINTS + 1)
        )
        force = 1000 * dice.random()
        yield MUSCLE.format(name=name, muscle=muscle, points=points, force=force, a=dice.random(), b=dice.random())
    yield CONTACT.format(name=name)


def write_set(out, tag, name, objects):
    out.write(f'\t\t<{tag} name="{name}">\n\t\t\t<objects>\n')
    out.writelines(objects)
    out.write(f"\t\t\t</objects>\n\t\t\t<groups />\n\t\t</{tag}>\n")


def write_nested(path, depth, tag, closed=True):
    """A small model with `depth` elements, each inside the one before; without end tags where not `closed`."""
    write(path, 1)
    with open(path, encoding="utf-8") as file:
        text = file.read()
    nested = f"<{tag}>" * depth + (f"</{tag.split()[0]}>" * depth if closed else "")
    with open(path, "w", encoding="utf-8", newline="\n") as out:
        out.write(text.replace("\t</Model>", f"{nested}\n\t</Model>"))


def write_attributes(path, count, on):
    """A small model with `count` attributes on its first element `on`, before any other."""
    write(path, 1)
    with open(path, encoding="utf-8") as file:
        text = file.read()
    attributes = " ".join(f'a{number}="{number}"' for number in range(count))
    with open(path, "w", encoding="utf-8", newline="\n") as out:
        out.write(text.replace(f"<{on} ", f"<{on} {attributes} ", 1))
