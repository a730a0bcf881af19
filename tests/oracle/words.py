"""Models with odd texts: a table of spellings, and models that are changed at random from a seed.

What a spelling means is never written here: the real OpenSim tells.
"""

import html
import random
import re
import sys

from models import FIXTURES

sys.path.insert(0, str(FIXTURES))

from quirks import base  # noqa: E402  (the fixtures' own building blocks)

NBSP, BOM = "\u00a0", "\ufeff"
DEFAULTS = '<defaults><SmoothSphereHalfSpaceForce name="default">{}</SmoothSphereHalfSpaceForce></defaults>'
SPHERE_DEFAULTS = '<defaults><ContactSphere name="default">{}</ContactSphere></defaults>'
MODEL, STIFFNESS = '<Model name="one_foot">', "<stiffness>1234567.8</stiffness>"

NUMBERS = """1e6|+8e6|.5E+6|5.|1,5|1;5|1_0|(1e6)|1e6)|,1e6|1e6,|1e6 ,|nan|NaN|+nan|-nan|nan5|inf|+Inf|-Infinity|infi|3 nan|3 -nan|3 x|
0x10|0x1p3|1e|1e+|1e5e5|.|-.|1e400|-1e400|1e-400|1e-310|--1|- 1|1.2.3|1f|1d0|1.7976931348623157e308|1.7976931348623159e308||  |abc|
&#49;e6|1&#46;5|&#32;12|12&#32;|12&#10;|&#10;12|12&#160;|&#xFEFF;12|12 &lt;|12&#32;13|<![CDATA[1e6]]>|<![CDATA[ 1e6]]>|<![CDATA[1e6 ]]>|
 <![CDATA[1e6]]> |<![CDATA[1 2]]>|<![CDATA[1]]><![CDATA[2]]>|<![CDATA[]]>1e6|1e6<![CDATA[]]>|<!-- x -->12|12<!-- x -->|1<!-- x -->2|
<!-- x --> 12 <!-- y -->|<!-- x -->|<?x?>12|1<?x?>2|<x/>12|<x>12</x>""".replace("\n", "").split("|")
NUMBERS += [
    *(f"{space}12" for space in ("\v", "\f", "\r", NBSP, BOM, "\u2003", "\u0085")),
    *(f"12{space}" for space in ("\v", "\f", "\r", NBSP, BOM, "\u2003", "\u0085")),
    *(f"1{space}2" for space in ("\v", "\f", NBSP, "\u0085")),
]
FLAGS = """true|false|TRUE|False|tRuE| true |1|0|2|-1|-0|+0|+1|0.0|0.5|1.0|00|01|0abc|1abc|abc|t|f|yes||  |true false|false true|0 1|1 0|
false abc|true abc|1 abc|false 2|0 2|falsey|truely|false.|(false)|false,true|,false|0x1|0x0|1e0|0e5|99999999999999999999|-5|nan|+|-|+false|
<!-- x -->false|false<!-- x -->|fa<!-- x -->lse|<![CDATA[false]]>|<![CDATA[ false]]>|<![CDATA[false ]]>|f&#97;lse|false&#32;|&#32;false|
<x/>false|<x>false</x>|&#11;false""".replace("\n", "").split("|")
FLAGS += [f"{before}false{behind}" for before in ("", "\v", NBSP) for behind in ("", "\f", NBSP, "\vtrue")]
TRIPLES = """1 2 3|1,2,3|0,5 1 2|1 nan 3|0,-9.81,0|1, 2, 3|(1 2 3)|(1,2,3)|~[1,2,3]|[1 2 3]|1 2|1 2 3 4|1 2 3 4 5 6|1 2 3 x|1 x 3|1x 2 3|1 2 3x|1 2 nan|1 2 inf|
1 2 3)(|1;2;3|1 , 2 , 3|,1 2 3|1 2 3,|1 2 3 ,|1 2 1e400|1 2 -nan|1-2 3||  |<!-- x -->1 2 3|1 <!-- x --> 2 3|<![CDATA[1 2 3]]>|
<![CDATA[1 2 3 ]]>|1&#32;2 3|1 2 3&#32;""".replace("\n", "").split("|")
TRIPLES += ["1\v2\f3", f"1{NBSP}2 3", f"{NBSP}1 2 3", f"1 2 3{NBSP}"]
LISTS = """floor heel_r|floor,heel_r|floor, heel_r|(floor heel_r)|floor <!-- x --> heel_r|<!-- x -->floor heel_r|floor heel_r<!-- x -->|
<![CDATA[floor heel_r]]>|<![CDATA[ floor heel_r ]]>|floor heel_r&#32;|&#32;floor heel_r|floor&#32;heel_r|floor heel_r heel_r||floor|FLOOR heel_r|
./floor heel_r|/floor heel_r|floor/ heel_r|/contactgeometryset/floor contactgeometryset/heel_r|floor heel&#95;r""".replace("\n", "").split("|")
LISTS += ["floor\vheel_r", "floor\fheel_r", f"floor{NBSP}heel_r", f"{NBSP}floor heel_r"]
PATHS = """{0}| {0} |<!-- x -->{0}|<![CDATA[{0}]]>|<![CDATA[ {0}]]>|{0}&#32;|{0} x|x {0}|{0}/|/{0}|{0},|({0})|../..{0}|/contactgeometryset/./heel_r|
/contactgeometryset/../contactgeometryset/heel_r|/contactgeometryset/heel_R|/contactgeometryset/ heel_r|heel&#95;r|\v{0}\v"""
PATHS = PATHS.replace("\n", "").format("/contactgeometryset/heel_r").split("|") + [f"{NBSP}/contactgeometryset/heel_r"]
NAMES = ["heel_r", " heel_r", "heel_r ", "\theel_r", "\vheel_r", f"heel_r{NBSP}", "heel&#95;r", "HEEL_R", "heel r", "heel,r"]
VERSIONS = ["40000", " 40000 ", "40000abc", "4e4", "+40000", "040000", f"40000{NBSP}", "\v40000", "", "40000.5", "40000 3", "99999999999"]


def table():
    """`{what it is: model}`."""
    smooth, hunt = base.ONE_FOOT, base.ONE_FOOT_HUNT
    flagged = base.edit(smooth, (STIFFNESS, "<appliesForce>{}</appliesForce>" + STIFFNESS))
    old = base.edit(hunt, ('Version="40000"', 'Version="30505"'), ("<transition_velocity>", "{}<transition_velocity>"))
    twice_disabled = ["<appliesForce>{}</appliesForce><isDisabled>{}</isDisabled>", "<isDisabled>{}</isDisabled><appliesForce>{}</appliesForce>"]
    over = (MODEL, MODEL + DEFAULTS)
    places = {
        "stiffness": (base.edit(smooth, (STIFFNESS, "<stiffness>{}</stiffness>")), NUMBERS),
        "stiffness, defaults": (
            base.edit(smooth, (STIFFNESS, "<stiffness>{}</stiffness>"), (over[0], over[1].format("<stiffness>7e5</stiffness>"))),
            NUMBERS[::8],
        ),
        "mass": (base.edit(smooth, ("61.5", "{}")), NUMBERS[::4]),
        "radius": (base.edit(smooth, ("0.0325", "{}")), NUMBERS[1::4]),
        "appliesForce": (flagged, FLAGS),
        "appliesForce, defaults": (
            base.edit(flagged, (over[0], over[1].format("<appliesForce>false</appliesForce>"))),
            FLAGS[::2],
        ),
        "isDisabled": (old.replace("{}", "<isDisabled>{}</isDisabled>"), FLAGS[1::2]),
        "isDisabled of later documents": (flagged.replace("appliesForce", "isDisabled"), FLAGS[:4]),
        "location": (base.edit(smooth, ("0.01 -0.02 0.003", "{}")), TRIPLES),
        "location, defaults": (
            base.edit(smooth, ("0.01 -0.02 0.003", "{}"), (MODEL, MODEL + SPHERE_DEFAULTS.format("<location>7 8 9</location>"))),
            TRIPLES[::3],
        ),
        "location of defaults": (
            base.edit(smooth, ("<location>0.01 -0.02 0.003</location>", ""), (MODEL, MODEL + SPHERE_DEFAULTS.format("<location>{}</location>"))),
            TRIPLES[1::3],
        ),
        "gravity": (base.edit(smooth, ("0 -9.81 0", "{}")), TRIPLES),
        "geometry": (base.edit(hunt, ("<geometry>floor heel_r<", "<geometry>{}<")), LISTS),
        "socket": (base.edit(smooth, ("<socket_sphere>/contactgeometryset/heel_r<", "<socket_sphere>{}<")), PATHS),
        "name": (base.edit(smooth, ('<ContactSphere name="heel_r">', '<ContactSphere name="{}">')), NAMES),
        "version": (base.edit(smooth, ('Version="40000"', 'Version="{}"')), VERSIONS),
    }
    models = loops() | {f"{place}: {text!r}": model.replace("{}", text) for place, (model, texts) in places.items() for text in texts}
    for order in twice_disabled:
        for one in ("true", "false", "abc"):
            for other in ("true", "false"):
                text = order.format(one, other)
                models[f"both flags: {text}"] = old.replace("{}", text)
    return models | files()


# Places of the table with three numbers.
VECTORS = ("location", "gravity")


def as_it_looks(model, tag):
    """The three numbers that a person sees in the text of `tag` of the one sphere or the model; None where they are not three plain ones.

    A person takes commas with blanks behind them and blanks for what parts numbers, and knows no more of the format.
    """
    objects = re.findall("<ContactSphere.*?</ContactSphere>", model, re.S) if tag == "location" else [model]
    text = re.findall(rf"<{tag}>(.*?)</{tag}>", "".join(objects), re.S)[-1]
    text = html.unescape(re.sub(r"<!--.*?-->|<!\[CDATA\[|\]\]>", "", text))
    parts = re.split(r"[ \v\f\n\t]+", text.strip(" \v\f\n\t"))
    parts = [part.removesuffix(",") for part in parts[:-1]] + parts[-1:]
    plain = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?|[+-]?inf|nan", re.I)
    return [float(part) for part in parts] if len(parts) == 3 and all(map(plain.fullmatch, parts)) else None


def loops():
    """A loop of joints in the foot of a pelvis, closed by every kind of joint, to bodies and to ground."""
    models = {}
    kinds = ["PinJoint", "SliderJoint", "BallJoint", "UniversalJoint", "GimbalJoint", "PlanarJoint", "WeldJoint", "FreeJoint"]
    for kind in kinds:
        for parent, child in (("calcn_r", "calcn_l"), ("pelvis", "calcn_r"), ("calcn_r", "pelvis")):
            bar = base.pin_joint("bar", parent, child, "-0.2", kind)
            models[f"loop: {kind} from {parent} to {child}"] = with_joint(bar)
        bar = base.pin_joint("bar", "pelvis", "calcn_r", "-0.2", kind)
        models[f"loop: {kind} from ground"] = with_joint(bar.replace("/bodyset/pelvis", "/ground"))
    return models


def with_joint(joint):
    forces = [base.hunt(f"contact_{side}", base.material(f"floor heel_{side} toe_{side}")) for side in "rl"]
    geometry = [base.half_space(), *base.spheres("r"), *base.spheres("l")]
    return base.model(base.FEET[0], [*base.FEET[1], joint], forces, geometry, name="loop")


def files():
    """`file=` on every start tag in turn: OpenSim opens it for few, and finds nothing there."""
    models = {}
    for stem, model in (("smooth", base.ONE_FOOT), ("hunt", base.ONE_FOOT_HUNT)):
        for tag in re.finditer(r"<[A-Z_a-z:]+( name=\"\w*\")?( /)?>", model):
            if tag.start() > model.index("<Model"):
                text = re.sub(r"( /)?>$", r' file="nowhere.xml"\1>', tag[0])
                models[f"file of {stem} {tag[0]} at {tag.start()}"] = model[: tag.start()] + text + model[tag.end() :]
    return models


SPACES = [" ", "\t", "\n", "\v", "\f", NBSP, BOM, "\u2003", "&#32;", "&#10;", "&#160;"]
TEXTS = [*NUMBERS, *FLAGS, *TRIPLES]


def changed_model(seed):
    """A model with one to three changes, and what they were."""
    draw = random.Random(seed)
    model = draw.choice([base.ONE_FOOT, base.ONE_FOOT_HUNT, base.TWO_FEET, base.TWO_FEET_HUNT])
    if draw.random() < 0.2:
        model = model.replace('Version="40000"', f'Version="{draw.choice([30517, 40500, 40600])}"')
    description = []
    for _ in range(draw.randint(1, 3)):
        change = draw.choice([odd_text, spaced, commented, cdata, entity, file_of, with_element_twice, without_element, renamed, swapped])
        model, what = change(draw, model)
        description.append(f"{change.__name__} {what}")
    return model, description


def leaf(draw, model):
    """A random property with text: its tag, and the position of the text."""
    leaves = list(re.finditer(r"<(\w+)>([^<>]+)</\1>", model))
    return draw.choice(leaves)


def replaced(model, found, text):
    """`model` with `text` as the content of the leaf `found`."""
    return model[: found.start(2)] + text + model[found.end(2) :], f"{found[1]}: {text!r}"


def odd_text(draw, model):
    return replaced(model, leaf(draw, model), draw.choice(TEXTS))


def at_random_place(draw, text, more):
    """`text` with `more` in front of it, behind it, or anywhere."""
    at = draw.choice([0, len(text), draw.randrange(len(text) + 1)])
    return text[:at] + more + text[at:]


def spaced(draw, model):
    found = leaf(draw, model)
    return replaced(model, found, at_random_place(draw, found[2], draw.choice(SPACES)))


def commented(draw, model):
    found = leaf(draw, model)
    return replaced(model, found, at_random_place(draw, found[2], draw.choice(["<!-- x -->", " <!-- x --> ", "<!---->"])))


def cdata(draw, model):
    found = leaf(draw, model)
    cell = draw.choice(["{}", " {}", "{} ", "\v{}"]).format(found[2])
    return replaced(model, found, f"<![CDATA[{cell}]]>")


def entity(draw, model):
    found = leaf(draw, model)
    at = draw.randrange(len(found[2]))
    return replaced(model, found, f"{found[2][:at]}&#{ord(found[2][at])};{found[2][at + 1 :]}")


def file_of(draw, model):
    tag = draw.choice(list(re.finditer(r"<[A-Z_a-z:]+( name=\"\w*\")?>", model)))
    return model[: tag.end() - 1] + ' file="nowhere.xml"' + model[tag.end() - 1 :], tag[0]


def with_element_twice(draw, model):
    found = leaf(draw, model)
    second = f"<{found[1]}>{draw.choice(TEXTS)}</{found[1]}>"
    at = draw.choice([found.start(), found.end()])
    return model[:at] + second + model[at:], second


def without_element(draw, model):
    found = leaf(draw, model)
    return model[: found.start()] + model[found.end() :], found[1]


def renamed(draw, model):
    name = draw.choice(list(re.finditer(r' name="(\w+)"', model)))
    text = at_random_place(draw, name[1], draw.choice(["\v", NBSP, "&#95;", " "]))
    return model[: name.start(1)] + text + model[name.end(1) :], repr(text)


def swapped(draw, model):
    """A tag in other letters: OpenSim does not know it then."""
    found = leaf(draw, model)
    tag = found[1].swapcase()
    return model[: found.start()] + f"<{tag}>{found[2]}</{tag}>" + model[found.end() :], tag
