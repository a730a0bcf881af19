"""Compares the tests that were skipped with those that tests/skips.txt lets be skipped.

    python3 dev/skips.py LOG...

Reads what the steps of .ci/run printed. Exits with 1 if something was skipped that is not listed for where this runs.
Needs Python 3.9.
"""

import os
import re
import sys
from pathlib import Path

LISTED = Path(__file__).resolve().parent.parent / "tests/skips.txt"

# The headings of the list, and whether what stands below them holds here.
HOLDS = {
    "anywhere": True,
    "as root": getattr(os, "geteuid", lambda: 1)() == 0,
    "not as root": getattr(os, "geteuid", lambda: 1)() != 0,
    "without OSIM_CORPUS": not os.environ.get("OSIM_CORPUS"),
    "without OSIM_CASES": not os.environ.get("OSIM_CASES"),
}

# Tests in Rust and scripts say it themselves, pytest says it with -rs --no-fold-skipped. Where tests run one after the
# other, the line of the test in Rust is not at its end yet.
SKIPPED_BY_RUST = re.compile(r"^(?:test .* \.\.\. )?skipped: (?P<test>.+?): (?P<why>.+)$")
SAID_BY_PYTEST = re.compile(r"^SKIPPED (?P<test>\S+?\.py(?:::.+?)?) - (?:Skipped: )?(?P<why>.+)$")


def skipped(log):
    """`(test, why)` for each line of a log that says so.

    >>> list(skipped("test a::b ... skipped: zsh's completion: zsh: not found"))
    [("zsh's completion", 'zsh: not found')]
    >>> list(skipped("SKIPPED tests/test_a.py::test_b[c: d] - Skipped: no floor\\n2 passed, 1 skipped in 0.1s"))
    [('tests/test_a.py::test_b[c: d]', 'no floor')]
    >>> list(skipped("SKIPPED tests/test_a.py - Skipped: no pandas"))
    [('tests/test_a.py', 'no pandas')]
    """
    for line in log.splitlines():
        match = SKIPPED_BY_RUST.match(line) or SAID_BY_PYTEST.match(line)
        if match:
            yield match["test"], match["why"]


def allowed(text):
    """The patterns of a list that hold here; `*` stands for anything.

    >>> [pattern.pattern for pattern in allowed("# why\\n[anywhere]\\na[*.osim]: b: c\\n")]
    ['a\\\\[.*\\\\.osim\\\\]']
    """
    holds = None
    for number, line in enumerate(text.splitlines(), 1):
        if not line.strip() or line.startswith("#"):
            continue
        if line.startswith("["):
            heading = line.strip().strip("[]")
            if heading not in HOLDS:
                sys.exit(f"{LISTED}:{number}: no heading '{heading}', there are: {', '.join(HOLDS)}")
            holds = HOLDS[heading]
            continue
        test, _, why = line.partition(": ")
        if holds is None or not why:
            sys.exit(f"{LISTED}:{number}: expected a line 'TEST: WHY' below a heading")
        if holds:
            yield re.compile(".*".join(map(re.escape, test.split("*"))))


def main(logs):
    patterns = list(allowed(LISTED.read_text(encoding="utf-8")))
    result = {said for log in logs for said in skipped(Path(log).read_text(encoding="utf-8", errors="replace"))}
    unlisted = 0
    for test, why in sorted(result):
        is_listed = any(pattern.fullmatch(test) for pattern in patterns)
        unlisted += not is_listed
        print(f"{'listed' if is_listed else 'NOT LISTED'}: {test}: {why}")
    if unlisted:
        print(
            f"error: {unlisted} of {len(result)} skipped tests are not in tests/skips.txt for where this runs: "
            "install what they need (dev/install.sh), or list them with a reason"
        )
    return 1 if unlisted else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
