"""Draws docs/pictures: a body before and after, and a body for each symptom of docs/symptoms.md.

    python3 dev/body_pictures.py PROGRAM

The body is the child of fixtures/walks, seen from the side, at the height where its lowest sphere touches the floor. Spheres and
their places are to scale; the model has no mesh, so rounded limbs between the joints, and a foot from ankle to toes, are drawn instead.
"""

import json
import math
import re
import subprocess
import sys
import tempfile
from pathlib import Path

TOP = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(TOP / "docs" / "glossary"))

from draw import BLUE, GREY, INK, ORANGE, arrow, ground, line, picture, words  # noqa: E402

BEFORE, GENERIC = "fixtures/walks/child.osim", "fixtures/scale_tool/generic_smooth.osim"
SKIN, EDGE = "#F0DCC8", "#8A7463"


def run(program, *words_of_call):
    return subprocess.run([program, *words_of_call], cwd=TOP, capture_output=True, text=True).stdout


def measured(program, model):
    """The right foot's spheres as (x, y, radius) from the ankle, in m."""
    spheres = []
    for sphere in json.loads(run(program, "inspect", model, "--format", "json"))["spheres"]:
        x, lowest, _ = sphere["lowest_point_m"]
        toes = TOES if sphere["body"] == "toes_r" else (0.0, 0.0)
        if sphere["limb"] == "femur_r":
            spheres.append((x + toes[0], lowest + sphere["radius_m"] + toes[1], sphere["radius_m"]))
    return spheres


def joints():
    """Places of hip, knee, ankle and toes in the frame of the body above, in m: x and y of each offset frame of a joint."""
    text = (TOP / BEFORE).read_text(encoding="utf-8")
    places = {}
    for name in ("femur_r", "tibia_r", "calcn_r", "toes_r"):
        joint = text[text.index(f'<PinJoint name="{name}_joint">') :]
        places[name] = tuple(
            float(number) for number in re.search(r"<translation>(.*?)</translation>", joint)[1].split()[:2]
        )
    return places


JOINTS = joints()
TOES = JOINTS["toes_r"]


class View:
    """Places in m, from the floor below the ankle, as pixels."""

    def __init__(self, x, floor, scale):
        self.x, self.floor, self.scale = x, floor, scale

    def at(self, x, y):
        return self.x + self.scale * x, self.floor - self.scale * y

    def limb(self, first, second):
        """The hull of two circles, each (x, y, radius), of which the first is the larger one."""
        (x1, y1), (x2, y2) = self.at(*first[:2]), self.at(*second[:2])
        r1, r2 = first[2] * self.scale, second[2] * self.scale
        along, turn = math.atan2(y2 - y1, x2 - x1), math.acos((r1 - r2) / math.dist((x1, y1), (x2, y2)))
        corners = [
            f"{x + r * math.cos(along + angle):.1f},{y + r * math.sin(along + angle):.1f}"
            for x, y, r, angle in ((x1, y1, r1, turn), (x1, y1, r1, -turn), (x2, y2, r2, -turn), (x2, y2, r2, turn))
        ]
        arcs = f"A{r1:.1f},{r1:.1f} 0 1 1 {corners[1]} L{corners[2]} A{r2:.1f},{r2:.1f} 0 0 1 {corners[3]}"
        return f'<path d="M{corners[0]} {arcs} Z"/>'

    def silhouette(self, *limbs):
        """Limbs with one outline around them all."""
        joined = "".join(self.limb(*limb) for limb in limbs)
        outline = f'<g fill="{EDGE}" stroke="{EDGE}" stroke-width="2.4">{joined}</g>'
        return f'{outline}<g fill="{SKIN}">{joined}</g>'

    def circle(self, x, y, radius, colour):
        x, y = self.at(x, y)
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius * self.scale:.1f}" stroke="{colour}" stroke-width="2" fill="{colour}44"/>'

    def body(self, ankle, sole, whole=True):
        """The leg, and all above it; `sole` is the height of the foot's lower side."""
        x, y = ankle
        knee = (x - JOINTS["calcn_r"][0], y - JOINTS["calcn_r"][1])
        hip = (knee[0] - JOINTS["tibia_r"][0], knee[1] - JOINTS["tibia_r"][1])
        heel, ball = (x - 0.012, sole + 0.02, 0.02), (x + TOES[0], sole + 0.013, 0.013)
        leg = [
            ((*knee, 0.03), (x, y + 0.015, 0.019)),
            (heel, (x, y + 0.015, 0.019)),
            ((x + 0.005, y + 0.01, 0.02), ball),
            (heel, ball),
            (ball, (x + TOES[0] + 0.045, sole + 0.009, 0.009)),
        ]
        if not whole:
            return self.silhouette(*leg)
        pelvis = (hip[0] - JOINTS["femur_r"][0], hip[1] - JOINTS["femur_r"][1])
        seat = (hip[0] + 0.012, hip[1])
        chest, head = (pelvis[0] - 0.004, pelvis[1] + 0.2), (pelvis[0] + 0.008, pelvis[1] + 0.365)
        elbow, hand = (chest[0] - 0.014, chest[1] - 0.135), (chest[0] + 0.024, chest[1] - 0.26)
        trunk = [
            ((*chest, 0.06), (pelvis[0] + 0.002, pelvis[1] + 0.07, 0.05)),
            ((*seat, 0.054), (pelvis[0] + 0.002, pelvis[1] + 0.07, 0.05)),
            ((chest[0], chest[1] + 0.04, 0.032), (head[0] - 0.008, head[1] - 0.03, 0.03)),
            ((*head, 0.072), (head[0] + 0.012, head[1] - 0.022, 0.062)),
        ]
        arm = [((chest[0], chest[1] + 0.02, 0.026), (*elbow, 0.02)), ((*elbow, 0.02), (*hand, 0.016))]
        return self.silhouette(*trunk, ((*seat, 0.054), (*knee, 0.031)), *leg) + self.silhouette(*arm)

    def spheres(self, ankle, spheres, colour):
        return "".join(self.circle(ankle[0] + x, ankle[1] + y, radius, colour) for x, y, radius in spheres)


def lowest(spheres):
    return min(y - radius for _, y, radius in spheres)


def before_and_after(before, after):
    """The whole body on the left of each half, its foot larger in a lens on the right."""
    sole, parts = lowest(after), [ground(0, 380, 800, 40), line(0, 380, 800, 380, INK, 2)]
    texts = (
        ("After OpenSim's Scale Tool", ORANGE, "an adult's spheres: radius"),
        ("After osim-contact-scale", BLUE, "its own spheres: radius"),
    )
    for left, spheres, (title, colour, text) in zip((0, 400), (before, after), texts):
        ankle, x, y, lens = (0.0, -lowest(spheres)), left + 268, 232, 118
        small, large = View(left + 78, 380, 300), View(x - 66, y + 62, 810)
        of_foot = (left + 101, 366, 42)
        parts += [small.body(ankle, ankle[1] + sole), small.spheres(ankle, spheres, colour)]
        parts += [lens_edge(*of_foot), *tangents(of_foot, (x, y, lens))]
        parts += [
            f'<clipPath id="lens{left}"><circle cx="{x}" cy="{y}" r="{lens}"/></clipPath>',
            f'<g clip-path="url(#lens{left})"><rect x="{x - lens}" y="{y - lens}" width="{2 * lens}" height="{2 * lens}" fill="#FFFFFF"/>',
            ground(x - lens, y + 62, 2 * lens, lens),
            large.body(ankle, ankle[1] + sole, whole=False),
            line(x - lens, y + 62, x + lens, y + 62, INK, 2),
            large.spheres(ankle, spheres, colour) + "</g>",
            lens_edge(x, y, lens),
        ]
        gap, radius = 1000 * (ankle[1] + sole), 1000 * spheres[0][2]
        where = f"sole {gap:.0f} mm above the floor" if gap > 1 else "sole on the floor"
        parts += [words(left + 20, 30, title, INK, size=17)]
        parts += [
            words(left + 150, 60 + 20 * row, each, colour)
            for row, each in enumerate([f"{text} {radius:.0f} mm", where])
        ]
    parts += [words(400, 405, "floor", GREY, "middle"), line(400, 15, 400, 365, "#CCCCCC", 1)]
    return picture(
        "A child from the side: the spheres of an adult hold it above the floor; its own let it stand", 800, 420, *parts
    )


def lens_edge(x, y, radius):
    return f'<circle cx="{x}" cy="{y}" r="{radius}" fill="none" stroke="{GREY}" stroke-width="1.2"/>'


def tangents(small, large):
    """The two lines that touch both circles from outside, each (x, y, radius)."""
    (x1, y1, r1), (x2, y2, r2) = small, large
    along, turn = math.atan2(y2 - y1, x2 - x1), math.acos((r1 - r2) / math.dist((x1, y1), (x2, y2)))
    for angle in (along + turn, along - turn):
        c, s = math.cos(angle), math.sin(angle)
        ends = (x1 + r1 * c, y1 + r1 * s, x2 + r2 * c, y2 + r2 * s)
        yield line(*(round(end, 1) for end in ends), GREY, 1)


def symptom(title, *parts, floor=200):
    return picture(title, 420, 240, ground(0, floor, 420, 240 - floor), *parts, line(0, floor, 420, floor, INK, 2))


def symptoms(spheres):
    """A foot for each symptom."""
    sole, view = lowest(spheres), View(120, 200, 900)

    def foot(lift=0.0, found=spheres, colour=BLUE, where=view, x=0.0, opacity=1):
        ankle = (x, lift - sole)
        drawn = where.body(ankle, lift, whole=False) + where.spheres(ankle, found, colour)
        return f'<g opacity="{opacity}">{drawn}</g>'

    uneven = [(x, y + (0.0 if at == 0 else 0.014), radius) for at, (x, y, radius) in enumerate(spheres)]
    yield (
        "sunk",
        symptom(
            "A foot whose spheres are almost whole inside the floor",
            foot(-0.03, colour=ORANGE),
            words(288, 64, "too soft"),
            words(288, 82, "for the weight"),
            arrow(275, 70, 275, 150, ORANGE),
        ),
    )
    yield (
        "floating",
        symptom(
            "A foot that is carried above the floor",
            foot(0.025),
            arrow(290, 200, 290, 178, ORANGE),
            words(300, 150, "carried before", ORANGE),
            words(300, 168, "it touches", ORANGE),
        ),
    )
    yield (
        "uneven",
        symptom(
            "A foot with one sphere lower than the others",
            foot(0.0, uneven),
            arrow(112, 232, 112, 204, ORANGE),
            words(130, 228, "this one carries all", ORANGE),
            words(262, 135, "these carry nothing"),
        ),
    )
    elsewhere = [(x + (0.04 if at == 2 else 0.0), y, radius) for at, (x, y, radius) in enumerate(spheres)]
    right, left = View(55, 200, 740), View(255, 200, 740)
    yield (
        "left-right",
        symptom(
            "A right foot, and a left foot with one sphere elsewhere",
            foot(where=right),
            foot(found=elsewhere, colour=ORANGE, where=left),
            words(115, 80, "right"),
            words(315, 80, "left"),
        ),
    )
    yield (
        "sliding",
        symptom(
            "A foot that moves along the floor while it carries the body",
            foot(x=-0.04, colour=GREY, opacity=0.35),
            foot(x=0.06),
            arrow(330, 120, 395, 120, ORANGE),
            words(330, 108, "creeps", ORANGE),
        ),
    )
    deep = View(75, 150, 740)
    yield (
        "exploding",
        symptom(
            "A body that begins deep inside the floor, and is thrown up",
            foot(-0.045, colour=ORANGE, where=deep),
            *(arrow(x, 145, x, 60, ORANGE) for x in (205, 230, 255)),
            words(270, 92, "forces of many", ORANGE),
            words(270, 110, "body weights", ORANGE),
            floor=150,
        ),
    )


def main(program):
    program = str(Path(program).resolve())
    with tempfile.TemporaryDirectory() as folder:
        scaled = str(Path(folder) / "after.osim")
        run(program, "transfer", BEFORE, "--from", GENERIC, "--follow-bodies", "--level", "-o", scaled)
        before, after = measured(program, BEFORE), measured(program, scaled)
    folder = TOP / "docs" / "pictures"
    folder.mkdir(exist_ok=True)
    for name, text in [("before-after", before_and_after(before, after)), *symptoms(after)]:
        (folder / f"{name}.svg").write_text(text, encoding="utf-8", newline="\n")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
