"""The study of `docs/studies/bodies.md`: one of its models falls once more; the page says what the table says."""

import csv
import os
import subprocess
import sys

import pytest
from conftest import TOP

HERE = TOP / "demonstrations" / "bodies"
PAGE = TOP / "docs" / "studies" / "bodies.md"
CORPUS = os.environ.get("OSIM_CORPUS")
needs_corpus = pytest.mark.skipif(not CORPUS, reason="OSIM_CORPUS is not set: models by other people are not at hand")
MODEL = "v40000_moco_2d_gait.osim"
DIGITS = 2e-5  # of a number in the committed table, which has six digits


def read(path):
    """The rows of a table, by model, build and contacts."""
    with open(path, newline="", encoding="utf-8") as file:
        return {(row["model"], row["build"], row["contacts"]): row for row in csv.DictReader(file)}


@needs_corpus
def test_one_model_falls_as_the_table_says(tmp_path):
    words = ["--models", CORPUS, "--results", tmp_path, "--table", tmp_path / "bodies.csv"]
    words += ["--only", MODEL, "--builds", "similar"]
    process = subprocess.run([sys.executable, HERE / "bodies.py", *map(str, words)], capture_output=True, text=True)
    assert process.returncode == 0, process.stderr
    committed, found = read(HERE / "bodies.csv"), read(tmp_path / "bodies.csv")
    assert len(found) == 5
    for key, row in found.items():
        for name in ("mass_kg", "radius_m", "peak_force_bw", "depth", "pressure_m", "carrying"):
            assert float(row[name]) == pytest.approx(float(committed[key][name]), rel=DIGITS, abs=1e-9), (key, name)


def test_a_similar_body_falls_like_the_original_with_places_and_not_without():
    """Similarity requires the same dimensionless numbers for both bodies."""
    rows = read(HERE / "bodies.csv")
    for (model, build, contacts), row in rows.items():
        if build == "similar":
            original = rows[model, "original", "left"]
            away = [
                abs(float(row[name]) / float(original[name]) - 1) for name in ("peak_force_bw", "depth", "pressure_m")
            ]
            assert max(away) < 1e-4 if contacts.startswith("places") else max(away) > 0.02, (model, contacts, away)


def test_the_page_says_what_the_committed_table_says():
    printed = subprocess.run([sys.executable, HERE / "page.py"], capture_output=True, text=True, check=True)
    block = PAGE.read_text(encoding="utf-8").split("<!-- begin bodies -->")[1].split("<!-- end bodies -->")[0]
    assert block.strip() == printed.stdout.strip()
