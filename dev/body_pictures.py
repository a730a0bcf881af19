"""Draws docs/pictures: a body before and after, and a body for each symptom of docs/symptoms.md.

    python3 dev/body_pictures.py PROGRAM

The body is the child of fixtures/walks, seen from the side, at the height where its lowest sphere touches the floor. Spheres and
their places are to scale; the model has no mesh, so capsules between the joints, and a wedge from ankle to toes, are drawn instead.
"""

import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

TOP = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(TOP / "docs" / "glossary"))

from draw import BLUE, GREY, INK, ORANGE, arrow, ground, line, picture, words  # noqa: E402

BEFORE, GENERIC = "fixtures/walks/child.osim", "fixtures/scale_tool/generic_smooth.osim"
SKIN = "#E9D3BF"


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

    def capsule(self, ends, width, colour=SKIN):
        (x1, y1), (x2, y2) = (self.at(*end) for end in ends)
        outline, inside = width * self.scale + 2, width * self.scale
        both = ((GREY, outline), (colour, inside))
        return "".join(
            line(round(x1, 1), round(y1, 1), round(x2, 1), round(y2, 1), c, f"{w:.1f}", 'stroke-linecap="round"')
            for c, w in both
        )

    def circle(self, x, y, radius, colour, more=""):
        x, y = self.at(x, y)
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius * self.scale:.1f}" stroke="{colour}" stroke-width="2" fill="{colour}33" {more}/>'

    def foot(self, ankle, sole, colour=SKIN):
        """A wedge from the ankle over the toes; `sole` is the height of its lower side."""
        x, y = ankle
        corners = [
            (x - 0.02, y + 0.015),
            (x - 0.035, sole),
            (x + TOES[0] + 0.045, sole),
            (x + TOES[0] + 0.04, sole + 0.02),
            (x + 0.03, y + 0.015),
        ]
        points = " ".join("{:.1f},{:.1f}".format(*self.at(*corner)) for corner in corners)
        return f'<polygon points="{points}" fill="{colour}" stroke="{GREY}" stroke-linejoin="round"/>'

    def body(self, ankle, sole, whole=True):
        """The leg, and all above it."""
        knee = (ankle[0] - JOINTS["calcn_r"][0], ankle[1] - JOINTS["calcn_r"][1])
        hip = (knee[0] - JOINTS["tibia_r"][0], knee[1] - JOINTS["tibia_r"][1])
        shin = self.capsule([ankle, knee], 0.045)
        if not whole:
            return shin + self.foot(ankle, sole)
        pelvis = (hip[0] - JOINTS["femur_r"][0], hip[1] - JOINTS["femur_r"][1])
        neck = (pelvis[0] - 0.01, pelvis[1] + 0.28)
        head = self.circle(neck[0] + 0.01, neck[1] + 0.13, 0.075, GREY)
        return (
            head + self.capsule([pelvis, neck], 0.12) + shin + self.capsule([knee, hip], 0.07) + self.foot(ankle, sole)
        )

    def spheres(self, ankle, spheres, colour):
        return "".join(self.circle(ankle[0] + x, ankle[1] + y, radius, colour) for x, y, radius in spheres)


def lowest(spheres):
    return min(y - radius for _, y, radius in spheres)


def before_and_after(before, after):
    """The whole body on the left of each half, its foot larger on the right."""
    sole, parts = lowest(after), []
    texts = (
        ("After OpenSim's Scale Tool", ORANGE, "the spheres of an adult"),
        ("After osim-contact-scale", BLUE, "spheres for this body"),
    )
    parts.append(ground(0, 415, 800, 45))
    for left, spheres, (title, colour, text) in zip((0, 400), (before, after), texts):
        ankle = (0.0, -lowest(spheres))
        small, large = View(left + 70, 415, 330), View(left + 185, 415, 800)
        for view, whole in ((small, True), (large, False)):
            parts += [view.body(ankle, ankle[1] + sole, whole), view.spheres(ankle, spheres, colour)]
        gap, radius = 1000 * (ankle[1] + sole), 1000 * spheres[0][2]
        where = [f"sole {gap:.0f} mm", "above the floor"] if gap > 1 else ["sole on the floor"]
        parts += [words(left + 20, 28, title, INK, size=16)]
        parts += [
            words(left + 230, 110 + 22 * row, each, colour)
            for row, each in enumerate([text, f"radius {radius:.0f} mm", *where])
        ]
    parts += [
        line(0, 415, 800, 415, INK, 2),
        words(400, 445, "floor", GREY, "middle"),
        line(400, 15, 400, 400, GREY, 1, 'stroke-dasharray="4 3"'),
    ]
    return picture(
        "A child from the side: the spheres of an adult hold it above the floor; its own let it stand", 800, 460, *parts
    )


def symptom(title, *parts, floor=200):
    return picture(title, 420, 240, ground(0, floor, 420, 240 - floor), *parts, line(0, floor, 420, floor, INK, 2))


def symptoms(spheres):
    """A foot for each symptom."""
    sole, view = lowest(spheres), View(120, 200, 900)

    def foot(lift=0.0, found=spheres, colour=BLUE, where=view, x=0.0):
        ankle = (x, lift - sole)
        return where.body(ankle, lift, whole=False) + where.spheres(ankle, found, colour)

    uneven = [(x, y + (0.0 if at == 0 else 0.014), radius) for at, (x, y, radius) in enumerate(spheres)]
    yield (
        "sunk",
        symptom(
            "A foot whose spheres are almost whole inside the floor",
            foot(-0.03, colour=ORANGE),
            words(285, 60, "too soft"),
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
    left = [(x + (0.05 if at == 2 else 0.0), y, radius) for at, (x, y, radius) in enumerate(spheres)]
    small = View(60, 200, 600)
    yield (
        "left-right",
        symptom(
            "A right foot, and a left foot with one sphere elsewhere",
            foot(where=small),
            foot(found=left, colour=ORANGE, where=View(250, 200, 600)),
            words(110, 80, "right"),
            words(300, 80, "left"),
        ),
    )
    yield (
        "sliding",
        symptom(
            "A foot that moves along the floor while it carries the body",
            foot(x=-0.04, colour=GREY),
            foot(x=0.06),
            arrow(330, 120, 395, 120, ORANGE),
            words(330, 108, "creeps", ORANGE),
        ),
    )
    deep = View(85, 150, 600)
    yield (
        "exploding",
        symptom(
            "A body that begins deep inside the floor, and is thrown up",
            foot(-0.045, colour=ORANGE, where=deep),
            *(arrow(x, 145, x, 60, ORANGE) for x in (200, 225, 250)),
            words(265, 100, "forces of many", ORANGE),
            words(265, 118, "body weights", ORANGE),
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
