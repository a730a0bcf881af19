"""Numbers in the findings of docs/studies that a table gives: each is computed once more from that table."""

import csv
import re
from decimal import Decimal
from itertools import product
from math import comb

import pytest
from conftest import TOP

NUMBER = r"[-+]?\d+(?:\.\d+)?(?:e-\d+)?"


def rows(text, block):
    """The cells of a block's tables."""
    lines = text.split(f"<!-- begin {block} -->")[1].split(f"<!-- end {block} -->")[0].splitlines()
    return [line[1:-1].split("|") for line in lines if line.startswith("|") and not line.startswith("|--")]


def numbers(*cells):
    return [float(one) for cell in cells for one in re.findall(NUMBER, cell)]


def ends(values):
    values = list(values)
    return min(values), max(values)


def changes(*pairs):
    """Least and largest change between cells, in percent."""
    return ends(100 * abs(new / old - 1) for pair in pairs for old, new in product(*map(numbers, pair)))


def walker(text):
    effort, success, ladder = (rows(text, name)[1:] for name in ("effort", "success", "ladder"))
    mesh = rows(text, "mesh")[1:]
    yield "Effort changes by at most {} %", ends(abs(float(row[5][:-2])) for row in mesh)[1:]
    forces = [changes([row[7], row[6]])[0] for row in mesh]
    failed = [force for force in forces if force > 2]
    yield "by up to {} %, and by more than 2 % at {} of {}", [max(forces), len(failed), len(forces)]
    yield "by {} to {} % for α from 0.25 to 2 s/m", changes(*zip(effort[1][1:5], effort[4][1:5]))
    rises = [changes([effort[0][n], effort[1][n]])[0] for n in (3, 1)]
    yield "falls by {} % at α = 1 s/m, and rises by {} % at 0.25", rises
    ranges = [end for row in effort[::2] for end in changes([row[1], row[4]])]
    yield "by {} to {} % at k̂ = 1.2, {} to {} % at 3.4, {} to {} % at 9.4", ranges
    yield "ended {} to {} % apart", ends(changes([c, c])[1] for row in effort for c in row[1:] if "(" in c)
    counts = [sum(numbers(row[column])[0] for row in success) for column in range(1, 5)]
    yield "of {} searches {} are solved, {} have the same effort with the mesh doubled, and {} the same force", counts
    yield "{} and {} % more effort", numbers(*(row[4] for row in rows(text, "sizes")[4:]))
    yield "By effort alone, {} and {} succeed", [numbers(row[3])[0] for row in ladder]
    yield "a median of {} s against {}.", numbers(ladder[1][7], ladder[0][7])
    with open(TOP / "demonstrations" / "walker" / "ladder.csv", encoding="utf-8") as file:
        table = list(csv.DictReader(file))
    for row in table:
        row["same"] = [abs(float(row[f"{name}_change"])) < 0.02 for name in ("effort", "force")]
    pairs = list(zip(table[::2], table[1::2]))
    lone = [all(once["same"]) for once, rungs in pairs if all(once["same"]) != all(rungs["same"])]
    tail = sum(comb(len(lone), n) for n in range(lone.count(False) + 1)) / 2 ** (len(lone) - 1)
    yield (
        "{} guesses succeed in only one of the two ways; {} of them succeed directly (p = {})",
        [len(lone), sum(lone), tail],
    )
    less = [(100 - 100 * float(rungs["effort"]) / float(once["effort"]), rungs) for once, rungs in pairs]
    cheaper = [(share, *rungs["same"]) for share, rungs in less if share > 3.6]
    yield "{} guesses gave {} to {} % less effort", [len(cheaper), *ends(share for share, *_ in cheaper)]
    dearer = [int(rungs["seed"]) for share, rungs in less if share < -0.01]
    yield "(seeds {} and {}) {} % more", [*dearer, -min(share for share, _ in less)]
    yield "With the mesh doubled {} of the {} keep it", [sum(effort for _, effort, _ in cheaper), len(cheaper)]


def falls(text):
    fallen, slides = rows(text, "falls"), rows(text, "slides")[1:]
    mouse, human, _, _, giraffe = ([float(cell) for cell in row[3:]] for row in fallen[-6:] if row[0] != "emu")
    radii, kept, heavy = (ends(a[n] / human[n] for n in (k, k + 3)) for a, k in ((mouse, 1), (mouse, 2), (giraffe, 2)))
    yield "A mouse meets {} to {} times the force, and a giraffe {} to {} times", [*kept, *heavy]
    yield "enough:** {} to {} times for the mouse", radii
    alike = {row[0] + row[1]: max(numbers(*row[3:])) for row in fallen if row[2] == "rescaled"}
    yield "with free joints: {}.", [alike.pop("smoothfree")]
    yield "at most {}, with one exception", [max(alike.values())]
    landed, pushed = ([numbers(row[6]) for row in slides if row[1].startswith(kind)] for kind in ("lands", "pushed"))
    yield "slides {} to {} % further** when it lands", ends(high for _, high in landed)
    yield "and {} to {} times as far when pushed", ends(1 + high / 100 for _, high in pushed)
    less = [end for kind in (landed, pushed) for end in ends(-low for low, _ in kind)]
    yield "A giraffe slides {} to {} % less when it lands, and {} to {} % less when pushed", less
    yield "change by {} to {} %, upward ones", ends(numbers(*(row[7] for row in slides)))


def bodies(text):
    peaks = [numbers(row[2]) for row in rows(text, "bodies") if row[1] == "places"]
    yield "impacts differ by up to {} %", [max(100 * abs(peak - 1) for pair in peaks for peak in pair)]


@pytest.mark.parametrize("page", [walker, falls, bodies])
def test_numbers_in_sentences_are_those_of_the_tables(page):
    text = (TOP / "docs" / "studies" / f"{page.__name__}.md").read_text(encoding="utf-8")
    for template, values in page(text):
        found = re.search(re.escape(template).replace(r"\{\}", f"({NUMBER})"), " ".join(text.split()))
        assert found, template
        for given, value in zip(found.groups(), values, strict=True):
            unit = 10.0 ** Decimal(given).as_tuple().exponent
            assert abs(float(given) - value) <= 0.6 * unit, (template, given, value)
