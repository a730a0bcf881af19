"""Numbers in sentences of docs/studies that a table gives: each is computed once more from that table, and no other is in a finding.

The checklist of docs/studies/paper.md names tests that are there.
"""

import csv
import re
from decimal import Decimal
from fractions import Fraction
from itertools import product
from math import comb, log, sqrt

import pytest
from conftest import TOP

NUMBER = r"[-+]?\d+(?:\.\d+)?(?:e-\d+)?"
STUDIES = TOP / "docs" / "studies"
GRAVITY = 9.81  # m/s2, of the falls


def rows(text, block):
    """The cells of a block's tables."""
    lines = text.split(f"<!-- begin {block} -->")[1].split(f"<!-- end {block} -->")[0].splitlines()
    return [line[1:-1].split("|") for line in lines if line.startswith("|") and not line.startswith("|--")]


def read(study, name):
    """The rows of a table beside the program of a study."""
    with open(TOP / "demonstrations" / study / f"{name}.csv", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def numbers(*cells):
    return [float(one) for cell in cells for one in re.findall(NUMBER, cell)]


def ends(values):
    values = list(values)
    return min(values), max(values)


def changes(*pairs):
    """Least and largest change between cells, in percent."""
    return ends(100 * abs(new / old - 1) for pair in pairs for old, new in product(*map(numbers, pair)))


def sign_test(more, fewer):
    """Two-sided: the chance of a split at least as uneven."""
    count = more + fewer
    return min(1, sum(comb(count, n) for n in range(min(more, fewer) + 1)) / 2 ** (count - 1))


def walker(text):
    effort, success, ladder = (rows(text, name)[1:] for name in ("effort", "success", "ladder"))
    mesh, sizes = rows(text, "mesh")[1:], rows(text, "sizes")[1:]
    # (C.3) at no depth over (3) at rest, with sqrt(cf)/R = 0.1.
    rests = [float(read("walker", "grid")[place]["relative_indentation"]) for place in (15, 20)]
    yield "just touch carry {} and {} % of their load", [50 * (0.1 / rest) ** 1.5 for rest in rests]
    yield "Effort changes by at most {} %", ends(abs(float(row[5][:-2])) for row in mesh)[1:]
    yield "claimed from {} % on", [3 * max(abs(float(row[5][:-2])) for row in mesh)]
    forces = [changes([row[7], row[6]])[0] for row in mesh]
    failed = [force for force in forces if force > 2]
    yield "by up to {} %, and by more than 2 % at {} of {}", [max(forces), len(failed), len(forces)]
    yield "by {} to {} % for α from 0.25 to 2 s/m", changes(*zip(effort[1][1:5], effort[4][1:5]))
    rises = [changes([effort[0][n], effort[1][n]])[0] for n in (3, 1)]
    yield "falls by {} % at α = 1 s/m, and rises by {} % at 0.25", rises
    ranges = [end for row in effort[::2] for end in changes([row[1], row[4]])]
    yield "by {} to {} % at k̂ = 1.2, {} to {} % at 3.4, {} to {} % at 9.4", ranges
    yield "ended {} to {} % apart", ends(changes([c, c])[1] for row in effort for c in row[1:] if "(" in c)
    drawn = [int(row["converged"]) for row in read("walker", "random")]
    yield "{} of {} searches converged", [sum(drawn), len(drawn)]
    counts = [sum(numbers(row[column])[0] for row in success) for column in range(1, 4)]
    other = [abs(float(row["effort_change"] or 0)) for row in read("walker", "success")]
    other = [100 * change for change in other if change > 0.1]
    yield (
        "of {} searches {} are solved, and {} have the same effort at twice the mesh. {} others change it by {} to {} %",
        [*counts, len(other), *ends(other)],
    )
    yield "from soft to stiff, {}, {} and {} are solved", [numbers(row[2])[0] for row in success]
    yield "after {} to {} iterations", ends(float(row[8]) for row in sizes if row[2] == "rescaled")
    yield "ended at {} and {} % more effort", numbers(*(row[4] for row in sizes[3:]))
    human, *others = (float(row["effort"]) for row in read("walker", "sizes_by_hand"))
    yield "ended in a walk of {} % more effort", {round(100 * other / human - 100, 3) for other in others}
    table = read("walker", "ladder")
    for row in table:
        row["same"] = abs(float(row["effort_change"])) < 0.02
        row["success"] = row["same"] and float(row["held"]) == 1
    pairs = list(zip(table[::2], table[1::2]))
    yield "all {} direct searches", [sum(int(once["solved"]) for once, _ in pairs)]
    lone = [sum(ways[n]["success"] > ways[1 - n]["success"] for ways in pairs) for n in (0, 1)]
    yield "{} at once and {} in steps succeed (p = {})", [*(numbers(row[4])[0] for row in ladder), sign_test(*lone)]
    yield "a median of {} s against {}.", numbers(ladder[1][6], ladder[0][6])
    less = [(100 - 100 * float(rungs["effort"]) / float(once["effort"]), rungs) for once, rungs in pairs]
    cheaper = [(share, rungs["same"]) for share, rungs in less if share > 3.6]
    yield "{} guesses the steps gave {} to {} % less effort", [len(cheaper), *ends(share for share, _ in cheaper)]
    dearer = [int(rungs["seed"]) for share, rungs in less if share < -0.01]
    yield "(seeds {} and {}) {} % more", [*dearer, -min(share for share, _ in less)]
    yield "With twice the mesh {} of the {} keep it", [sum(same for _, same in cheaper), len(cheaper)]
    stages = [read("walker", name) for name in ("grid", "branch", "mesh", "random", "sizes", "sizes_by_hand")]
    took = [sum(float(row["cpu_s"]) for stage in stages for row in stage)]
    took[0] += sum(float(row["cpu_s_at_double_mesh"]) for row in stages[2])
    took += [sum(float(row["cpu_s"]) for name in ("success", "ladder") for row in read("walker", name))]
    yield "took {} minutes of processor time, those of `success.py` {}", [seconds / 60 for seconds in took]


def restitution(product):
    """The exact one of an impact with this product of dissipation and speed, by bisection."""
    d, low, high = 1.5 * product, 0.0, 1.0
    low, high = 0.0, min(1.0, 1 / d)
    for _ in range(60):
        middle = (low + high) / 2
        rises = d - log(1 + d) > -middle * d - log(1 - middle * d)
        low, high = (middle, high) if rises else (low, middle)
    return low


def falls(text):
    table = read("falls", "falls")
    # From a tenth of the hips' height, 0.62 m, with 1 s/m.
    speed = sqrt(2 * GRAVITY * 0.062)
    human = [row for row in table if row["animal"] == "human_62kg" and row["contacts"] == "rescaled"]
    depths = [
        float(row["final_indentation_over_hip_height"]) * float(row["hip_height_m"]) / float(row["sphere_radius_m"])
        for row in human
    ]
    yield (
        "lands at {} m/s with α = 1 s/m, which is a restitution of {} ({} by (13); limit 0.8), and rests {} to {} R deep",
        [speed, restitution(speed), 1 - speed, *ends(depths)],
    )
    fallen, slides = rows(text, "falls"), rows(text, "slides")[1:]
    mouse, human, _, _, giraffe = ([float(cell) for cell in row[3:]] for row in fallen[-6:] if row[0] != "emu")
    radii, kept, heavy = (ends(a[n] / human[n] for n in (k, k + 3)) for a, k in ((mouse, 1), (mouse, 2), (giraffe, 2)))
    yield "A mouse meets {} to {} times the force, and a giraffe {} to {} times", [*kept, *heavy]
    yield "enough:** {} to {} times for the mouse", radii
    floating = [row for row in table if (row["law"], row["contacts"], row["animal"]) == ("smooth", "radii", "mouse")]
    assert all(float(row["peak_time_over_time_unit"]) == 0 for row in floating)
    yield "push a mouse up with {} times", {float(row["peak_force_bw"]) for row in floating}
    alike = {row[0] + row[1]: max(numbers(*row[3:])) for row in fallen if row[2] == "rescaled"}
    yield "Without friction, curves coincide to {}", [alike["smooth, without frictionfree"]]
    yield "with free joints: {}.", [alike.pop("smoothfree")]
    yield "at most {}, the error of the integrator, with one exception", [max(alike.values())]
    off = {law: max(float(row[5]) for row in slides if row[0] == law) for law in ("Hunt–Crossley", "smooth")}
    yield "slide alike**: within {}, with the smooth class {}", off.values()
    landed, pushed = ([numbers(row[6]) for row in slides if row[1].startswith(kind)] for kind in ("lands", "pushed"))
    yield "slides {} to {} % further** when it lands", ends(high for _, high in landed)
    yield "and {} to {} times as far when pushed", ends(1 + high / 100 for _, high in pushed)
    less = [end for kind in (landed, pushed) for end in ends(-low for low, _ in kind)]
    yield "A giraffe slides {} to {} % less when it lands, and {} to {} % less when pushed", less
    yield "change by {} to {} %,", ends(numbers(*(row[7] for row in slides)))
    yield "upward ones by at most {} %", [max(map(abs, numbers(*(row[8] for row in slides))))]


def bodies(text):
    table = read("bodies", "bodies")
    yield "sink in by up to {} R", [max(float(row["depth"]) for row in table if row["contacts"] == "left")]
    similar = {row["model"]: row for row in table if (row["build"], row["contacts"]) == ("similar", "mass")}
    pairs = [(row, similar[row["model"]]) for row in table if row["build"] == "original"]

    def change(name, was, now):
        return float(now[name]) - float(was[name])

    right = [
        (was, now)
        for was, now in pairs
        if float(now["peak_force_bw"]) == pytest.approx(float(was["peak_force_bw"]), rel=1e-3)
        and abs(change("depth", was, now)) < 1e-3
    ]
    assert len(right) == 5
    yield "its pressure is {} to {} mm too far forward", ends(1000 * change("pressure_m", *pair) for pair in right)
    assert sum(int(now["carrying"]) < int(was["carrying"]) for was, now in pairs) == 3
    by_way = {tuple(row[1:4]): row for row in rows(text, "bodies") if row[0] == "all"}

    def worst(*way):
        return max(100 * abs(peak - 1) for peak in numbers(by_way[way][4]))

    yield "peak forces differ by up to {} %", [worst("places", "foot", "radius")]
    yield "(α by mass: {} %)", [worst("places", "foot", "mass")]
    by_mass = by_way["places", "mass", "either"]
    yield "By mass, they differ by {} %", [worst("places", "mass", "either")]
    off = [max(map(abs, numbers(by_mass[column].replace("..", " ")))) for column in (7, 6)]
    yield "but pressure by {} mm and depth by {} R", off


# What the search at twice the mesh starts from.
NEXT = {"reference": "half", "half": "half", "original": "original"}


def muscles(text):
    table = {(row["mass"], row["contacts"], row["mesh"], row["start"]): row for row in read("muscles", "muscles")}
    curves = {}
    for row in read("muscles", "curves"):
        curves.setdefault((row["mass"], row["contacts"], row["mesh"]), []).append(row)
    first, *others = (curves[mass, "rescaled", "15"] for mass in ("1", "8", "0.125"))

    def apart(*parts):
        names = [name for name in first[0] if name.startswith(parts)]
        pairs = (pair for other in others for pair in zip(first, other, strict=True))
        return max(abs(float(one[name]) - float(two[name])) for one, two in pairs for name in names)

    yield "within {} rad and {} body weights", [apart("hip", "knee", "ankle"), apart("up", "along")]
    assert len({table[mass, "rescaled", "15", "reference"]["cost"] for mass in ("1", "8", "0.125")}) == 1
    original, heavy = (table[mass, kind, "60", "half"] for mass, kind in (("1", "rescaled"), ("8", "left")))
    yield "spheres sink in by {} R", [float(original["deepest_x_over_r"])]
    costs = [float(table[mass, "rescaled", "30", "half"]["cost"]) for mass in ("0.125", "1")]
    yield "{} % dearer than the original's", [100 * costs[0] / costs[1] - 100]
    finest = {f"{float(row['cost']):.4f}" for key, row in table.items() if key[1:3] == ("rescaled", "60")}
    yield "with 60 all three cost {}.", [float(cost) for cost in finest]
    deep = [float(heavy["deepest_x_over_r"]), -1000 * float(heavy["lowest_sole_m"])]
    ratio = float(heavy["cost"]) / float(original["cost"])
    yield "at {} times the cost: spheres go {} radii deep, the sole {} mm", [ratio, *deep]
    light = table["0.125", "left", "15", "reference"]
    given_up = [1000 * float(light["lowest_sole_m"]), int(light["iterations"])]
    yield "floats** {} mm above the ground (over s) where Moco gave up, after {} iterations", given_up

    def refined(mass, kind, mesh, start):
        """How much cost and peak force change at twice this mesh, in percent."""
        coarse, fine = table[mass, kind, mesh, start], table[mass, kind, str(2 * int(mesh)), NEXT[start]]
        return [100 * abs(float(coarse[name]) / float(fine[name]) - 1) for name in ("cost", "peak_force_bw")]

    # The light walker's other optimum, and what was searched with 15 intervals alone, have no finer mesh.
    done = [(mass, kind, mesh, start) for mass, kind, mesh, start in table if (mass, kind, "60", NEXT[start]) in table]
    coarse = refined("1", "rescaled", "15", "reference")
    fine = [refined(*key) for key in done if key[2] == "30"]
    yield "cost changes by {} %, peak force by {} %. From 30 to 60, at most by {} and {} %", [*coarse, *map(max, *fine)]
    yield "contacts controls hold {} % of the step", [100 * float(original["forward_held"])]
    predicted = read("muscles", "predictions")
    cost = [float(row["cost"]) for row in predicted]
    angles = [float(row[6]) for row in rows(text, "predictions")[2:4]]
    yield "costs within {}, angles within {} rad", [max(cost[1:3]) / cost[0] - 1, max(angles)]
    held = 100 * float(predicted[0]["forward_held"])
    yield (
        "Controls hold {} % of the step. With 30 intervals the cost is {} % higher",
        [held, 100 * cost[3] / cost[0] - 100],
    )


def paper(_):
    # (11), (A.4), (B.2) and (B.3) of the 62 kg human under 9.81 m/s2, and the printed numbers.
    modulus, radius, load = 1e6 / 2**1.5, 0.032, 62 * 9.81 / 6
    relative = (3 * load / (4 * radius**2 * modulus)) ** (2 / 3)
    stiffness = 2 * radius * modulus * sqrt(relative) / 1000
    yield "Exactly it is {}, which the table rounds to {}.", [stiffness, round(stiffness, 1)]
    yield "4.24 in the text, is {}.", [1000 * stiffness * radius / load]
    yield "two of 13.5 kN/m have {}.", [2 * 13.5]

    def exponents(modulus):
        """Those of x/R and k in M under body weight, if E* goes with this power of M and R with a third."""
        relative = (1 - Fraction(2, 3) - modulus) * Fraction(2, 3)
        return relative, Fraction(1, 3) + modulus + relative / 2

    relative, stiffness = exponents(Fraction(2, 3))
    assert exponents(Fraction(5, 6))[1] == 1
    yield (
        "x̂ then goes with M^({}/{}) and k with M^({}/{}); k ∝ M needs E\\* ∝ M^({}/{})",
        [relative.numerator, relative.denominator, stiffness.numerator, stiffness.denominator, 5, 6],
    )


# What a finding names that is no result: conditions, limits and settings.
CONDITIONS = {
    walker: ["from k̂ = 2 to 9.4**", "From 1.2 to 2 the", "from α = 0.25 to 2 s/m:", "For α = 4 s/m"],
    falls: [],
    bodies: [],
    muscles: [
        "With 15 intervals, all",
        "holds up to 0.16",
        "With 30 intervals the light",
        "with 15 only",
        "at 60 intervals",
        "OpenSim 4.6",
        "tolerance of 1e-3",
    ],
    paper: None,
}


@pytest.mark.parametrize("page", CONDITIONS)
def test_numbers_in_sentences_are_those_of_the_tables(page):
    text = (STUDIES / f"{page.__name__}.md").read_text(encoding="utf-8")
    # A list begins a line of its own; all else is one line.
    sentences = re.sub(r"\n(?!- |\n)\s*", " ", text)
    for template, values in page(text):
        pattern = re.escape(template).replace(r"\{\}", f"({NUMBER})").replace(r"\ ", r"\s+")
        found = re.search(pattern, sentences)
        assert found, template
        for given, value in zip(found.groups(), values, strict=True):
            unit = 10.0 ** Decimal(given).as_tuple().exponent
            assert abs(float(given) - value) <= 0.6 * unit, (template, given, value)
        sentences = sentences.replace(found[0], "")
    if CONDITIONS[page] is None:
        return
    for condition in CONDITIONS[page]:
        assert condition in sentences, condition
        sentences = sentences.replace(condition, "")
    for finding in re.findall(r"^- (?!\*\w).*", sentences, re.MULTILINE):
        left = re.findall(rf"(?<![\w.]){NUMBER}", re.sub(r"`[^`]*`|\(#?[^)]*\.md[^)]*\)", "", finding))
        assert not left, f"{left}: no table of this test gives it: {finding}"


def test_the_checklist_of_the_paper_names_tests_that_are_there():
    text = (STUDIES / "paper.md").read_text(encoding="utf-8").split("## Checklist")[1]
    lines = [line[1:-1].split("|") for line in text.splitlines() if line.startswith("|")][2:]
    folders = [TOP / "tests", *(TOP / "crates").glob("*/tests")]
    files = [path for folder in folders for end in ("rs", "py") for path in folder.rglob(f"*.{end}")]
    sources = [path.read_text(encoding="utf-8") for path in files]
    assert len(lines) > 20
    for what, _, page, test, against in lines:
        name = test.strip("`")
        assert any(f"fn {name}(" in source or f"def {name}(" in source for source in sources), (what, name)
        assert against and page.startswith("["), what
