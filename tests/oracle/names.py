"""Models whose objects have odd names, in documents of four versions, made from a seed.

Names of sets and classes, names with dots, slashes, blanks and signs, one name for several objects; connected by every spelling of a
path. Bodies weigh and spheres measure something of their own each, so that a reader who takes the wrong one gives itself away.
"""

import random
import sys
from html import escape

from models import FIXTURES

sys.path.insert(0, str(FIXTURES))

from quirks import base, versions  # noqa: E402  (the fixtures' own building blocks)

VERSIONS = (30000, 30505, 30516, 40000)
SETS = """bodyset jointset forceset contactgeometryset componentset markerset ground floor default defaults frames objects components
geometry model one_foot BodySet ContactGeometrySet Ground Body ContactSphere contactsphere frame sphere""".split()
ODD = ["heel.r", "a.b.c", ".heel", "heel.", ".", "..", "...", "heel r", " heel", "heel ", "heel/r", "/heel", "heel/", "/", "heel_0", "heel:r", "heel,r"]
ODD += ["heel*", "heel+1", "heel\\r", "a|b", "a&b", "<a>", "héél", "HEEL", "heel-1", "1", "/bodyset/foot", "bodyset/foot", "../heel", ""]
PLAIN = ["heel", "toe", "foot", "shank", "plane", "press", "push"]
# Where OpenSim has what is called so.
SET_OF = {"foot": "bodyset", "shank": "bodyset", "knee": "jointset", "press": "forceset", "push": "forceset"}
SET_OF |= dict.fromkeys(("heel", "toe", "plane"), "contactgeometryset")


class Names:
    """Names of the objects of one model, most of them plain."""

    def __init__(self, draw):
        self.draw, self.plain = draw, list(PLAIN)
        self.odd = [draw.choice(draw.choice([SETS, ODD])) for _ in range(2)]
        kinds = ["foot", "shank", "heel", "toe", "plane", "press", "push", "knee"]
        self.of = dict(zip(kinds, ["foot", "shank", "heel", "toe", "plane", "press", "push", "knee"]))
        for _ in range(draw.randint(1, 3)):
            kind = draw.choice(kinds)
            self.of[kind] = draw.choice([*self.odd, SET_OF[kind], SET_OF[kind], draw.choice(PLAIN)])

    def __getitem__(self, kind):
        return self.of[kind]


def naming(seed):
    """A model, and what is odd about it."""
    draw = random.Random(f"names {seed}")
    version, names = VERSIONS[seed % len(VERSIONS)], Names(draw)
    smooth = version >= 30516 and draw.random() < 0.5
    style = draw.choice(["absolute", "absolute", "relative", "bare", "dotted", "from_root"]) if version > 30000 else "bare"
    listed = draw.choice(["bare", "bare", "absolute", "from_root", "dotted"])
    text = {30000: in_bodies, 30505: with_connectors, 30516: with_sockets, 40000: plain_sockets}[version](names, smooth, style, listed)
    if draw.random() < 0.2:
        text = with_a_double(text, version, names, draw)
    odd = {kind: name for kind, name in names.of.items() if kind != name}
    return text, f"{version} {'smooth' if smooth else 'hunt'} {style} {listed} {odd}"


def path(style, in_set, name, up="../../"):
    """A path as a socket spells it."""
    whole = f"{in_set}/{name}" if in_set else name
    return {
        "absolute": f"/{whole}",
        "relative": up + whole,
        "bare": name,
        "dotted": f"{up}./{in_set}/../{whole}" if in_set else up + whole,
        "from_root": whole,
    }[style]


def force(names, smooth, style, listed, kind, sphere, more=""):
    """A force between one sphere and the plane."""
    sphere, plane = names[sphere], names["plane"]
    if smooth:
        one = base.smooth("X", "A", half_space_name="B")
        one = one.replace("/contactgeometryset/A", escape(path(style, "contactgeometryset", sphere)))
        one = one.replace("/contactgeometryset/B", escape(path(style, "contactgeometryset", plane)))
    else:
        both = [path(listed, "contactgeometryset", name, up="./") for name in (plane, sphere)]
        one = base.hunt("X", base.material(escape(" ".join(both))))
    start, remainder = one.split("\n", 1)
    return start.replace('"X"', f'"{escape(names[kind])}"') + more + "\n" + remainder


def forces(names, smooth, style, listed, more=""):
    return [force(names, smooth, style, listed, "press", "heel", more), force(names, smooth, style, listed, "push", "toe", more)]


def geometry(names, socket):
    """Two spheres and a plane; `socket` says where each stands."""
    made = [base.half_space("X", "A").replace("<socket_frame>A</socket_frame>", socket(None))]
    made += [
        base.sphere("X", "A", radius).replace("<socket_frame>A</socket_frame>", socket(carrier))
        for carrier, radius in (("foot", "0.0325"), ("shank", "0.05"))
    ]
    kinds = ("plane", "heel", "toe")
    return [one.replace('"X"', f'"{escape(names[kind])}"') for one, kind in zip(made, kinds)]


def joints(names, ends):
    """The foot on ground, the shank on the foot; `ends` writes both."""
    return [
        f'<{tag} name="{escape(names.of.get(name, name))}">\n{ends(parent, child)}\n</{tag}>'
        for tag, name, parent, child in (("FreeJoint", "root", None, "foot"), ("PinJoint", "knee", "foot", "shank"))
    ]


def document(version, names, smooth, style, listed, socket, ends, more=""):
    bodies = [base.body(escape(names["foot"]), "61.5"), base.body(escape(names["shank"]), "3.25")]
    text = base.model(
        bodies, joints(names, ends), forces(names, smooth, style, listed, more), geometry(names, socket), version=version
    )
    return text if version > 30516 else text.replace('\t\t<Ground name="ground" />\n', "")


def body_path(names, style, carrier):
    name = "ground" if carrier is None else names[carrier]
    return escape(path(style, "" if carrier is None else "bodyset", name))


def plain_sockets(names, smooth, style, listed):
    def socket(carrier):
        return f"<socket_frame>{body_path(names, style, carrier)}</socket_frame>"

    def ends(parent, child):
        one, other = body_path(names, "absolute", parent), body_path(names, "absolute", child)
        return f"\t<socket_parent_frame>{one}</socket_parent_frame>\n\t<socket_child_frame>{other}</socket_child_frame>"

    return document(40000, names, smooth, style, listed, socket, ends)


def with_sockets(names, smooth, style, listed):
    style = "relative" if style == "absolute" else style
    text = spelled(30516, "socket", names, smooth, style, listed)
    return text.replace("socket_sphere>", "socket_sphere_connectee_name>").replace("half_space>", "half_space_connectee_name>")


def with_connectors(names, smooth, style, listed):
    style = "relative" if style == "absolute" else style
    return spelled(30505, "connectors", names, smooth, style, listed, "\n\t<isDisabled>false</isDisabled>")


def spelled(version, frames, names, smooth, style, listed, more=""):
    def socket(carrier):
        return versions.GEOMETRY_FRAMES[frames].format(body_path(names, style, carrier)).replace("\n", "\n\t")

    def ends(parent, child):
        both = body_path(names, "relative", parent), body_path(names, "relative", child)
        return base.indent(versions.JOINT_FRAMES[frames].format(*both), 1).rstrip("\n")

    return document(version, names, smooth, style, listed, socket, ends, more)


def in_bodies(names, smooth, style, listed):
    """Version 3: joints in bodies, which are called by their names."""
    foot, shank = escape(names["foot"]), escape(names["shank"])
    bodies = [
        versions.GROUND,
        versions.old_body(foot, "61.5", versions.old_joint("FreeJoint", "root", "ground")),
        versions.old_body(shank, "3.25", versions.old_joint("PinJoint", escape(names["knee"]), foot)),
    ]
    made = [
        versions.old_geometry("ContactHalfSpace", escape(names["plane"]), "ground", "0 0 -1.57079633"),
        versions.old_geometry("ContactSphere", escape(names["heel"]), foot, "0 0 0", "\n\t<radius>0.0325</radius>"),
        versions.old_geometry("ContactSphere", escape(names["toe"]), shank, "0 0 0", "\n\t<radius>0.05</radius>"),
    ]
    all_forces = forces(names, False, style, listed, "\n\t<isDisabled>false</isDisabled>")
    return versions.old_model(30000, bodies, all_forces, made)


def with_a_double(text, version, names, draw):
    """A third sphere in the model's own components, with a name that something else has."""
    frame = {40000: "<socket_frame>/ground</socket_frame>", 30516: "<socket_frame_connectee_name>../ground</socket_frame_connectee_name>"}
    if version not in frame:
        return text
    name = escape(draw.choice([names["heel"], names["toe"], "contactgeometryset", "bodyset"]))
    if name == "ground":  # then ground itself gets another name, and nothing stands on it
        return text
    sphere = base.sphere(name, "A", "0.4").replace("<socket_frame>A</socket_frame>", frame[version])
    return base.edit(text, ("\t</Model>", f"<components>{sphere}</components>\n\t</Model>"))
