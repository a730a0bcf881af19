"""Reads models with the real OpenSim.

Each is read in a process of its own, because OpenSim keeps a document's `<defaults>` for every model it loads later.
Floats are written as `float.hex()`: two readings are equal when their bits are.

With `dump` the model as OpenSim prints it, every default spelled out, comes along as `dump`.
"""

import os
from pathlib import Path

from apart import ask

SMOOTH = (
    "stiffness",
    "dissipation",
    "static_friction",
    "dynamic_friction",
    "viscous_friction",
    "transition_velocity",
    "constant_contact_force",
    "hertz_smoothing",
    "hunt_crossley_smoothing",
)
MATERIAL = ("stiffness", "dissipation", "static_friction", "dynamic_friction", "viscous_friction")
GEOMETRY = ("ContactSphere", "ContactHalfSpace", "ContactMesh", "ContactEllipsoid", "ContactCylinder", "ContactTorus")


def read_models(paths, dump=False):
    """`{path: reading}`; the caller's process stays free of OpenSim."""
    jobs = [[os.path.abspath(path), dump] for path in paths]
    readings = ask("opensim_reads", jobs)
    return {str(path): {"loads": False} | reading for path, reading in zip(paths, readings, strict=True)}


def run_job(job):
    """The reading of one model, in this process."""
    import opensim

    path, dump = job
    if is_standalone_set(path):
        return read_set(opensim, path, dump)
    try:
        model = opensim.Model(str(path))
    except Exception as error:  # OpenSim throws its own kinds; all mean that the file was not read
        return {"loads": False, "error": str(error)}
    reading = {"loads": True, "connects": True, "error": None}
    joints = model.getJointSet().getSize()
    try:
        model.finalizeConnections()
    except Exception as error:
        reading |= {"connects": False, "error": str(error)}
    reading |= parts(opensim, model)
    welded = welded_to_ground(model) if reading["connects"] else set()
    reading["fixed"] = sorted(welded)
    reading["jointed_to_ground_alone"] = sorted(bodies_alone(model)) if reading["connects"] else []
    reading["gravity"] = vector(model.get_gravity())
    reading["name"] = model.getName()
    reading["mass_sum"] = left_to_right(body["mass"] for body in reading["bodies"])
    if dump:
        opensim.OpenSimObject.setSerializeAllDefaults(True)
        reading["dump"] = model.dump()
    reading |= simulated(model)
    if model.getJointSet().getSize() > joints:
        # To connect a body without a joint, OpenSim adds one; what was only read cannot be built (invalid MobilizedBodyIndex).
        reading |= {"builds": False, "total_mass": None, "build_error": "a body has no joint"}
    # In what cannot be built, OpenSim may look for the body of a frame for ever.
    reading["uncounted"] = sorted(welded - welded_bodies(model, welded) - {"/ground"}) if reading["builds"] else []
    return reading


def parts(opensim, model):
    """Contacts and bodies, wherever they stand in the model."""
    result = {"bodies": [], "spheres": [], "half_spaces": [], "forces": [], "others": []}
    for component in list(model.getComponentsList()):
        kind = component.getConcreteClassName()
        here = {"name": component.getName(), "path": component.getAbsolutePathString()}
        if kind == "Body" and component.getOwner().getConcreteClassName() != "Body":  # of a loop, OpenSim divides a body
            result["bodies"].append(here | {"mass": number(component, "mass")})
        elif kind == "ContactSphere":
            result["spheres"].append(here | geometry(component) | {"radius": number(component, "radius")})
        elif kind == "ContactEllipsoid":
            radii = component.getPropertyByName("radii")
            radii = [opensim.PropertyHelper.getValueVec3(radii, i).hex() for i in range(3)]
            result["spheres"].append(here | geometry(component) | {"radius": None, "radii": radii})
        elif kind == "ContactHalfSpace":
            result["half_spaces"].append(here | geometry(component))
        elif kind == "SmoothSphereHalfSpaceForce":
            result["forces"].append(here | smooth(component))
        elif kind == "HuntCrossleyForce":
            result["forces"] += [here | one for one in hunt_crossley(opensim, model, component)]
        elif kind in ("ElasticFoundationForce", "ExponentialContactForce", "MeyerFregly2016Force"):
            result["others"].append(here | {"type": kind})
    return result


def geometry(component):
    """The frame and place of a sphere or half-space."""
    import opensim

    location = component.getPropertyByName("location")
    return {
        "location": [opensim.PropertyHelper.getValueVec3(location, i).hex() for i in range(3)],
        "frame": connectee(component, "frame"),
        "base": base(component, "frame"),
        "centre_in_base": centre_in_base(component, location),
    }


def centre_in_base(component, location):
    """A sphere's centre, seen from the body (or ground) under its frame; None where nothing is connected."""
    import opensim

    try:
        transform = downcast_frame(component.getConnectee("frame")).findTransformInBaseFrame()
        values = [opensim.PropertyHelper.getValueVec3(location, i) for i in range(3)]
        return vector(transform.shiftFrameStationToBase(opensim.Vec3(*values)))
    except Exception:
        return None


def smooth(force):
    """A SmoothSphereHalfSpaceForce."""
    return {
        "type": "SmoothSphereHalfSpaceForce",
        "set": None,
        "applies": flag(force, "appliesForce"),
        "geometry": [connectee(force, "sphere"), connectee(force, "half_space")],
        "parameters": {name: number(force, name) for name in SMOOTH},
    }


def hunt_crossley(opensim, model, force):
    """A HuntCrossleyForce: one entry for each of its ContactParameters."""
    materials = force.getPropertyByName("contact_parameters").getValueAsObject().getPropertyByName("objects")
    for k in range(materials.size()):
        material = materials.getValueAsObject(k)
        names = material.getPropertyByName("geometry")
        names = [opensim.PropertyHelper.getValueString(names, i) for i in range(names.size())]
        yield {
            "type": "HuntCrossleyForce",
            "set": k,
            "applies": flag(force, "appliesForce"),
            "names": names,
            "geometry": [resolve(model, name) for name in names],
            "parameters": {name: number(material, name) for name in MATERIAL}
            | {"transition_velocity": number(force, "transition_velocity")},
        }


def resolve(model, name):
    """The path of the geometry OpenSim means by `name` in a `<geometry>` list (as HuntCrossleyForce looks it up)."""
    for path in (name, f"contactgeometryset/{name}"):
        try:
            component = model.getComponent(path)
        except Exception:
            continue
        if component.getConcreteClassName() in GEOMETRY:  # a frame of the same name does not count
            return component.getAbsolutePathString()
    return None


def connectee(component, socket):
    """The path a socket points to, or None where nothing is connected."""
    try:
        return component.getConnectee(socket).getAbsolutePathString()
    except Exception:
        return None


def base(component, socket):
    """The body or ground under the frame a socket points to."""
    try:
        return downcast_frame(component.getConnectee(socket)).findBaseFrame().getAbsolutePathString()
    except Exception:
        return None


def downcast_frame(component):
    """A frame as the bindings know it."""
    import opensim

    return opensim.Frame.safeDownCast(component)


def welded_to_ground(model):
    """The paths of ground and of all bodies that hang on it by WeldJoints alone."""
    return welded_to({"/ground"}, [ends(joint) for joint in joints(model) if is_weld(joint)])


def bodies_alone(model):
    """The bodies that only ground is joined to."""
    pairs = [set(ends(joint)) for joint in joints(model)]
    neighbours = {end: set().union(*(both for both in pairs if end in both)) for both in pairs for end in both}
    return [end for end, both in neighbours.items() if end != "/ground" and both == {end, "/ground"}]


def welded_bodies(model, welded):
    """The welded bodies on which others hang by joints without a coordinate along which they move away."""
    import opensim

    def moves_away(joint):
        return any(
            joint.get_coordinates(index).getMotionType() == opensim.Coordinate.Translational
            for index in range(joint.numCoordinates())
        )

    if welded == {"/ground"}:
        return set()
    pairs = [(joint, set(ends(joint))) for joint in joints(model)]
    holding = {end for joint, both in pairs if not (both <= welded or moves_away(joint)) for end in both & welded - {"/ground"}}
    return welded_to(holding, [both for joint, both in pairs if is_weld(joint) and "/ground" not in both])


def joints(model):
    import opensim

    result = [opensim.Joint.safeDownCast(component) for component in list(model.getComponentsList())]
    return [joint for joint in result if joint]


def is_weld(joint):
    return joint.getConcreteClassName() == "WeldJoint"


def ends(joint):
    """The paths of the two bodies that it joins."""
    return [frame.findBaseFrame().getAbsolutePathString() for frame in (joint.getParentFrame(), joint.getChildFrame())]


def welded_to(bodies, welds):
    """These, and what is welded to them."""
    for _ in welds:
        bodies = bodies | {end for weld in welds if bodies & set(weld) for end in weld}
    return bodies


def simulated(model):
    """Whether OpenSim can build the system, and the total mass it finds then."""
    try:
        return {"builds": True, "total_mass": model.getTotalMass(model.initSystem()).hex()}
    except Exception as error:
        return {"builds": False, "total_mass": None, "build_error": str(error)}


def is_standalone_set(path):
    """Whether the document holds a bare ForceSet or ContactGeometrySet."""
    head = Path(path).read_bytes()[:2000]
    return b"<Model" not in head and (b"<ForceSet" in head or b"<ContactGeometrySet" in head)


def read_set(opensim, path, dump):
    """A standalone set: its members' own properties; sockets point into a model elsewhere."""
    forces = b"<ForceSet" in Path(path).read_bytes()[:2000]
    try:
        component_set = (opensim.ForceSet if forces else opensim.ContactGeometrySet)(str(path))
    except Exception as error:
        return {"loads": False, "error": str(error)}
    result = {"loads": True, "connects": False, "error": None, "forces": [], "spheres": [], "bodies": []}
    for i in range(component_set.getSize()):
        member = component_set.get(i)
        here = {"name": member.getName(), "path": member.getName()}
        if member.getConcreteClassName() == "SmoothSphereHalfSpaceForce":
            result["forces"].append(here | smooth(member))
        elif member.getConcreteClassName() == "ContactSphere":
            result["spheres"].append(here | geometry(member) | {"radius": number(member, "radius")})
    if dump:
        opensim.OpenSimObject.setSerializeAllDefaults(True)
        result["dump"] = component_set.dump()
    return result


def number(component, name):
    """A double property as hex."""
    import opensim

    return opensim.PropertyHelper.getValueDouble(component.getPropertyByName(name)).hex()


def flag(component, name):
    """A bool property."""
    import opensim

    return opensim.PropertyHelper.getValueBool(component.getPropertyByName(name))


def vector(value):
    """A Vec3 as hex."""
    return [value.get(i).hex() for i in range(3)]


def left_to_right(masses):
    """The plain sum, in the order of the file."""
    total = 0.0
    for mass in masses:
        total += float.fromhex(mass)
    return total.hex()
