"""Draws the pictures of docs/glossary.md: `python3 docs/glossary/draw.py [FOLDER]`, by default into its own folder."""

import math
import sys
from pathlib import Path

INK, GREY, BLUE, ORANGE, GROUND = "#222222", "#888888", "#0072B2", "#D55E00", "#E8E2D8"


def line(x1, y1, x2, y2, colour=INK, width=1.5, more=""):
    return f'<line x1="{x1:g}" y1="{y1:g}" x2="{x2:g}" y2="{y2:g}" stroke="{colour}" stroke-width="{width}" {more}/>'


def arrow(x1, y1, x2, y2, colour=INK):
    """A line with a head at its end."""
    angle = math.atan2(y2 - y1, x2 - x1)
    sides = [(x2 - 8 * math.cos(angle + turn), y2 - 8 * math.sin(angle + turn)) for turn in (-0.4, 0.4)]
    points = " ".join(f"{x:.1f},{y:.1f}" for x, y in [(x2, y2), *sides])
    return line(x1, y1, x2, y2, colour) + f'<polygon points="{points}" fill="{colour}"/>'


def words(x, y, text, colour=INK, anchor="start", size=14):
    return f'<text x="{x:g}" y="{y:g}" fill="{colour}" text-anchor="{anchor}" font-size="{size}">{text}</text>'


def circle(x, y, radius, colour=BLUE, fill="none"):
    return f'<circle cx="{x:g}" cy="{y:g}" r="{radius:g}" stroke="{colour}" stroke-width="2" fill="{fill}"/>'


def ground(x, y, width, height):
    """A floor: its surface, and what is solid below it."""
    area = f'<rect x="{x:g}" y="{y:g}" width="{width:g}" height="{height:g}" fill="{GROUND}"/>'
    return area + line(x, y, x + width, y, GREY, 2)


def curve(points, colour, more=""):
    joined = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
    return f'<polyline points="{joined}" fill="none" stroke="{colour}" stroke-width="2" {more}/>'


def picture(title, width, height, *parts):
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" role="img" width="{width}" height="{height}" viewBox="0 0 {width} {height}"'
        f' font-family="Arial, Helvetica, sans-serif">\n<title>{title}</title>\n'
        f'<rect width="{width}" height="{height}" fill="#FFFFFF"/>\n' + "\n".join(parts) + "\n</svg>\n"
    )


def indentation():
    floor, radius, depth = 142, 80, 28
    x, y = 130, floor + depth - radius
    return picture(
        "Indentation: how deep a sphere is in the floor",
        420, 200,
        ground(20, floor, 380, 50),
        circle(x, y, radius, fill="#0072B222"),
        circle(x, y, 2.5, INK, INK),
        arrow(x, y, x - radius * math.cos(0.6), y - radius * math.sin(0.6)),
        words(x - 26, y - 26, "R"),
        line(x, y + radius, 270, y + radius, GREY, 1, 'stroke-dasharray="4 3"'),
        arrow(250, floor - 34, 250, floor, ORANGE),
        line(250, floor, 250, floor + depth, ORANGE, 2),
        arrow(250, floor + depth + 20, 250, floor + depth, ORANGE),
        words(262, floor + 20, f"x; x/R = {depth / radius:.2f}", ORANGE),
        words(390, floor - 8, "floor", GREY, "end"),
    )  # fmt: skip


def smoothing():
    # Falisse et al. (2022): R = 32 mm, cf = 1e-5 m2, bd = 300 1/m. Forces over that of Hertz at 0.3 R.
    radius, cf, bd = 0.032, 1e-5, 300.0
    at = [(-0.3 + 0.01 * step) for step in range(61)]

    def hertz(x):
        return max(x, 0.0) ** 1.5 / 0.3**1.5

    def smooth(x):
        return (0.5 + 0.5 * math.tanh(bd * x * radius)) * (x * x + cf / radius**2) ** 0.75 / 0.3**1.5

    def place(x, force):
        return 210 + 560 * x, 160 - 120 * force

    return picture(
        "Smoothing: the force begins before the sphere touches",
        420, 200,
        arrow(30, 160, 395, 160, GREY),
        arrow(210, 175, 210, 20, GREY),
        words(395, 180, "x/R", GREY, "end"),
        words(218, 28, "force", GREY),
        words(206, 176, "0", GREY, "end"),
        curve([place(x, hertz(x)) for x in at], BLUE, 'stroke-dasharray="6 4"'),
        curve([place(x, smooth(x)) for x in at], ORANGE),
        words(330, 130, "Hertz", BLUE),
        words(60, 120, "smooth: above 0", ORANGE),
        words(60, 138, "before contact", ORANGE),
        arrow(168, 134, 194, 152, ORANGE),
    )  # fmt: skip


def restitution():
    def flight(left, height, width, half):
        steps = [step / 20 for step in range(21)]
        rise = (lambda s: 1 - s * s) if half else (lambda s: 1 - (2 * s - 1) ** 2)
        return [(left + width * s, 138 - height * rise(s)) for s in steps]

    return picture(
        "Restitution: the speed after an impact over the speed before",
        420, 180,
        ground(20, 150, 380, 24),
        curve(flight(50, 110, 90, True), GREY, 'stroke-dasharray="4 3"'),
        curve(flight(140, 54, 130, False), GREY, 'stroke-dasharray="4 3"'),
        circle(50, 28, 12, fill="#FFFFFF"),
        circle(140, 138, 12, fill="#FFFFFF"),
        circle(205, 84, 12, fill="#FFFFFF"),
        arrow(112, 62, 130, 116, ORANGE),
        words(104, 58, "v", ORANGE, "end"),
        arrow(150, 116, 163, 88, BLUE),
        words(152, 82, "v'", BLUE, "end"),
        words(285, 60, "c_r = v'/v"),
        words(285, 84, "1: all comes back", GREY),
        words(285, 104, "0: nothing", GREY),
    )  # fmt: skip


def half_space():
    return picture(
        "Half space: solid on one side of a plane",
        420, 180,
        ground(20, 100, 380, 60),
        *(line(x, 158, x + 24, 104, "#CFC6B6", 1) for x in range(26, 376, 24)),
        arrow(210, 100, 210, 40),
        words(220, 50, "faces up: spheres above"),
        arrow(210, 100, 210, 150, ORANGE),
        words(220, 148, "x axis: into the solid", ORANGE),
        words(30, 92, "surface", GREY),
    )  # fmt: skip


def limb():
    def side(sign, name):
        hip, knee, ankle = (210 + 34 * sign, 52), (210 + 40 * sign, 96), (210 + 36 * sign, 142)
        out = "start" if sign > 0 else "end"
        colour = BLUE if sign > 0 else ORANGE
        bones = line(*hip, *knee, colour, 4) + line(*knee, *ankle, colour, 4) + line(*ankle, ankle[0] + 40 * sign, 152, colour, 4)
        spheres = "".join(circle(ankle[0] + offset * sign, 158, 8, colour, "#FFFFFF") for offset in (-4, 20, 42))
        label = 210 + 62 * sign
        return (
            bones + spheres
            + words(label, 70, f"limb femur_{name}", colour, out)
            + words(label, 90, "n = 3 spheres", colour, out)
        )  # fmt: skip

    return picture(
        "Limbs: what is below the place where left and right split",
        420, 190,
        ground(20, 166, 380, 16),
        '<rect x="168" y="30" width="84" height="24" rx="8" fill="#DDDDDD"/>',
        words(210, 47, "pelvis", INK, "middle"),
        side(1, "r"),
        side(-1, "l"),
    )  # fmt: skip


PICTURES = {
    "indentation.svg": indentation,
    "smoothing.svg": smoothing,
    "restitution.svg": restitution,
    "half-space.svg": half_space,
    "limb.svg": limb,
}

if __name__ == "__main__":
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
    for name, draw in PICTURES.items():
        (folder / name).write_text(draw(), encoding="utf-8", newline="\n")
