"""Random models from a seed: the quirks of `fixtures/format`, mixed as no one would write them by hand.

`variant(seed)` gives `(bytes, story)`; the story names what was drawn, so that a failing seed can be read.
What a variant means is never written here: the real OpenSim tells.
"""

import random
import sys

from models import FIXTURES

sys.path.insert(0, str(FIXTURES))

from quirks import base, versions  # noqa: E402  (the fixtures' own building blocks)


def variant(seed):
    """A model of one to two feet of one to five spheres."""
    draw = Draw(seed)
    if draw.chance("an OpenSim 3 document", 0.2):
        text = old_document(draw)
    else:
        text = document(draw)
    return as_file(draw, text), draw.story


class Draw:
    """A random source that writes down what it decided."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.story = []

    def chance(self, what, probability):
        """True as often as `probability` says; told in the story."""
        if self.random.random() >= probability:
            return False
        if what not in self.story:
            self.story.append(what)
        return True

    def number(self, low, high):
        """A number between the two, in one of the spellings OpenSim reads as a strict reader does."""
        value = self.random.uniform(low, high)
        return self.random.choice(
            [
                repr(value),
                f"{value:.17g}",
                f"{value:.5e}",
                f"{value:.4E}",
                f"+{value:.6g}",
                f"  {value:.8f} ",
                f"{value:.3g}",
                f"\n\t\t{value!r}\n",
            ]
        )

    def shuffled(self, items):
        items = list(items)
        self.random.shuffle(items)
        return items


def name(draw, stem):
    """A random name as people give to objects."""
    return draw.random.choice(["{}", "{}_contact", "Contact{}", "{}.1", "s-{}", "{}_µ"]).format(stem)


def children_shuffled(draw, element):
    """An element of one-line children, in another order and with comments between."""
    start, *children, end = element.split("\n")
    children = draw.shuffled(children)
    if draw.chance("comments between properties", 0.2):
        children.insert(draw.random.randrange(len(children) + 1), "\t<!--<stiffness>1</stiffness> was too soft-->")
    if draw.chance("a property twice", 0.1):
        children.append("\t<stiffness>7</stiffness>")
    return "\n".join([start, *children, end])


def without_tags(draw, element, *tags):
    """The element, some of `tags` left at their defaults."""
    for tag in tags:
        if draw.chance(f"{tag} left out", 0.15):
            element = "\n".join(line for line in element.split("\n") if f"<{tag}>" not in line)
    return element


def smooth(draw, label, sphere, plane):
    parts = base.smooth(label, sphere, draw.number(1e4, 1e8).strip(), plane)
    parts = parts.replace("<dissipation>2.25<", f"<dissipation>{draw.number(0.1, 9).strip()}<")
    parts = without_tags(
        draw,
        parts,
        "constant_contact_force",
        "hertz_smoothing",
        "hunt_crossley_smoothing",
        "transition_velocity",
        "viscous_friction",
    )
    if draw.chance("a force that does not apply", 0.1):
        parts = parts.replace("\n\t<stiffness>", "\n\t<appliesForce>false</appliesForce>\n\t<stiffness>", 1)
    return children_shuffled(draw, parts)


def hunt(draw, label, spheres, plane):
    """All spheres in one material, or the half-space in a material of its own."""
    refer = (lambda it: it) if draw.chance("geometry by name", 0.7) else (lambda it: f"/contactgeometryset/{it}")
    if draw.chance("the half-space in a material of its own", 0.25):
        lists = draw.shuffled([[refer(plane)], [refer(one) for one in spheres]])
    else:
        lists = [draw.shuffled([refer(one) for one in [plane, *spheres]])]
    materials = [
        children_shuffled(
            draw,
            without_tags(
                draw,
                base.material(" ".join(names), draw.number(1e4, 1e8).strip(), draw.number(0.1, 9).strip()),
                "viscous_friction",
            ),
        )
        for names in lists
    ]
    force = base.hunt(label, *materials)
    spelling = draw.random.choice([' name="contact_parameters"', "", ' name=""', "wrapper"])
    draw.story.append(f"contact_parameters as {spelling.strip() or 'an unnamed tag'}")
    start = '<HuntCrossleyForce::ContactParametersSet name="contact_parameters">'
    if spelling == "wrapper":
        force = force.replace(start, "<contact_parameters><HuntCrossleyForce::ContactParametersSet>").replace(
            "</HuntCrossleyForce::ContactParametersSet>",
            "</HuntCrossleyForce::ContactParametersSet></contact_parameters>",
        )
    else:
        force = force.replace(start, f"<HuntCrossleyForce::ContactParametersSet{spelling}>")
    return without_tags(draw, force, "transition_velocity")


def feet(draw):
    """`(side, sphere names)` of each foot."""
    sides = draw.random.choice(["r", "rl", "rl", "rl"])
    count = draw.random.randint(1, 5)
    return [(side, [name(draw, f"p{k}") + f"_{side}" for k in range(count)]) for side in sides]


def forces_of(draw, legs, plane):
    """Each foot's forces, of either class; sometimes one sphere is used twice."""
    made = []
    for side, spheres in legs:
        if draw.chance("a SmoothSphereHalfSpaceForce for each sphere", 0.5):
            made += [smooth(draw, f"smooth_{k}_{side}", one, plane) for k, one in enumerate(spheres)]
        elif draw.chance("a HuntCrossleyForce for each sphere", 0.5):
            made += [hunt(draw, f"hunt_{k}_{side}", [one], plane) for k, one in enumerate(spheres)]
        else:
            made.append(hunt(draw, f"hunt_{side}", spheres, plane))
    if draw.chance("a sphere in two forces", 0.15):
        made.append(smooth(draw, "again", legs[0][1][0], plane))
    return draw.shuffled(made)


def spheres_of(draw, legs, frame):
    """The spheres: of one radius, or of as many as there are."""
    common = draw.number(0.002, 0.07) if draw.chance("one radius", 0.7) else None
    return [
        children_shuffled(
            draw,
            base.sphere(
                one, frame.format(side), (common or draw.number(0.002, 0.07)).strip(), f"{0.02 * k:.3f} -0.02 0"
            ),
        ).replace("\t<stiffness>7</stiffness>\n", "\t<radius>7</radius>\n")
        for side, names in legs
        for k, one in enumerate(names)
    ]


def document(draw):
    """An OpenSim 4 document."""
    legs, plane = feet(draw), name(draw, draw.random.choice(["floor", "platform", "Ground"]))
    frame = draw.random.choice(["/bodyset/calcn_{}", "../../bodyset/calcn_{}", "  /bodyset/calcn_{} "])
    spheres, forces = spheres_of(draw, legs, frame), forces_of(draw, legs, plane)
    planes = [base.half_space(plane, draw.random.choice(["/ground", "../../ground"]))]
    bodies = [base.body("pelvis", draw.number(20, 900))] + [
        base.body(f"calcn_{side}", draw.number(0.1, 9)) for side, _ in legs
    ]
    joints = [base.free_joint("ground_pelvis", "pelvis")] + [
        base.pin_joint(f"hip_{side}", "pelvis", f"calcn_{side}", "0.1") for side, _ in legs
    ]
    in_components = draw.chance("smooth forces in <components>", 0.15)
    remaining = [force for force in forces if not (in_components and force.startswith("<Smooth"))]
    first = ""
    if len(remaining) < len(forces):
        first = (
            "<components>\n"
            + "".join(base.indent(force, 1) for force in forces if force not in remaining)
            + "</components>\n"
        )
    if draw.chance("<defaults>", 0.2):
        first += (
            '<defaults><SmoothSphereHalfSpaceForce name="default"><hertz_smoothing>222</hertz_smoothing>'
            "<dissipation>3.5</dissipation></SmoothSphereHalfSpaceForce></defaults>\n"
        )
    text = base.model(
        draw.shuffled(bodies),
        draw.shuffled(joints),
        remaining,
        draw.shuffled(spheres + planes),
        name="variant",
        version=draw.random.choice([30517, 40000, 40500, 40600]),
        first=first,
    )
    if draw.chance("sections in another order", 0.3):
        text = sections_shuffled(draw, text)
    return text


def sections_shuffled(draw, text):
    """The model's four sets in another order."""
    starts = [text.index(f"\t\t<{tag} ") for tag in ("BodySet", "JointSet", "ForceSet", "ContactGeometrySet")]
    ends = [*starts[1:], text.index("\t</Model>")]
    parts = draw.shuffled(text[start:end] for start, end in zip(starts, ends))
    return text[: starts[0]] + "".join(parts) + text[ends[-1] :]


def old_document(draw):
    """An OpenSim 2 or 3 document: joints in bodies, body_name, isDisabled."""
    legs = feet(draw)
    bodies = [
        versions.GROUND,
        versions.old_body("pelvis", draw.number(20, 900), versions.old_joint("FreeJoint", "ground_pelvis", "ground")),
    ]
    bodies += [
        versions.old_body(
            f"calcn_{side}", draw.number(0.1, 9), versions.old_joint("PinJoint", f"hip_{side}", "pelvis", "0 -0.9 0.1")
        )
        for side, _ in legs
    ]
    spheres = [
        versions.old_geometry(
            "ContactSphere", one, f"calcn_{side}", "0 0 0", f"\n\t<radius>{draw.number(0.002, 0.07).strip()}</radius>"
        )
        for side, names in legs
        for one in names
    ]
    forces = [
        versions.old_hunt(
            f"hunt_{side}", draw.random.choice(["false", " false ", "true"]), " ".join(draw.shuffled(["floor", *names]))
        )
        for side, names in legs
    ]
    return versions.old_model(
        draw.random.choice([20001, 20302, 30000]), bodies, forces, draw.shuffled([versions.FLOOR, *spheres]), "variant"
    )


def as_file(draw, text):
    """The text as bytes: line ends, a byte order mark, indentation."""
    if draw.chance("indented by spaces", 0.2):
        text = text.replace("\t", "   ")
    if draw.chance("CRLF", 0.3):
        text = text.replace("\n", "\r\n")
    data = text.encode()
    return b"\xef\xbb\xbf" + data if draw.chance("a byte order mark", 0.2) else data
