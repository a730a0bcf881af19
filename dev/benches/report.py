#!/usr/bin/env python3
"""Measures the page of `--report` on a library of 1000 models, and a browser that opens it: see README.md."""

import argparse
import statistics
import sys
import tempfile
from pathlib import Path

from library import is_rescaled, write_texts
from measure import MIB, ROOT, Table, build, peak, rescale, run

sys.path.insert(0, str(ROOT / "tests" / "browser"))
from browser import Browser, missing  # noqa: E402

LIMIT_S = 5.0
LIMIT_MB = 10.0
LIMIT_SHOWN_S = 2.0
LIMIT_MIB = 128.0

# When the browser has the page laid out and painted, from the start of the navigation, in ms.
MEASURE = """
document.body.offsetHeight;
const load = performance.getEntriesByType('navigation')[0].loadEventEnd;
const paint = performance.getEntriesByName('first-contentful-paint').map(entry => entry.startTime);
return Math.max(load, ...paint);
"""


def main():
    options = arguments()
    command = options.command or build()
    table = Table()
    with tempfile.TemporaryDirectory(prefix="osim-report-") as folder:
        folder = Path(folder)
        models = sorted((ROOT / "fixtures" / "table1").glob("*.osim")) + sorted((ROOT / "fixtures" / "check").glob("*.osim"))
        # Those that cannot be rescaled without a question stay in the library: a page has failures, too.
        assert any(is_rescaled(command, path) for path in models)
        write_texts([path.read_bytes() for path in models], folder / "library", options.models)
        table.head(f"{options.models} models, medians of {options.rounds}")
        report_page(table, "rescaled", rescale(command, folder / "library", "--dry-run", "--quiet"), folder, options.rounds)
        report_page(table, "checked", [command, "check", folder / "library"], folder, options.rounds)
    return table.finish()


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--models", type=int, default=1000, help="in the library (default 1000)")
    parser.add_argument("--rounds", type=int, default=5, help="of each measurement (default 5)")
    parser.add_argument("--command", help="a command built before, instead of building one")
    return parser.parse_args()


def report_page(table, what, call, folder, rounds):
    """The page that `call` writes of the library: time, memory, size, and how soon it is seen."""
    page = folder / f"{what}.html"
    call = [*map(str, call), "--report", str(page), "--force"]
    times = [run(call, status=1) for _ in range(rounds)]
    table.row(f"{what}: time", statistics.median(wall for wall, _ in times), "s", LIMIT_S)
    table.row(f"{what}: peak memory", peak(call, status=1) / MIB, "MiB", LIMIT_MIB)
    table.row(f"{what}: size of the page", page.stat().st_size / 1e6, "MB", LIMIT_MB)
    if missing():
        print(f"not measured how soon it is seen: {', '.join(missing())} not installed")
        return
    with Browser() as browser:
        # People have their browser open already: its own start does not count.
        time_to_show(browser, page)
        shown = [time_to_show(browser, page) for _ in range(rounds)]
    table.row(f"{what}: until Chromium shows it", statistics.median(shown), "s", LIMIT_SHOWN_S)


def time_to_show(browser, page):
    browser.open(page, 1280, "light")
    return browser.run(MEASURE) / 1000


if __name__ == "__main__":
    sys.exit(main())
