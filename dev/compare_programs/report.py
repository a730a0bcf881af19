"""What is told at the end: how much was compared, and what differs, grouped by its likely cause."""

import re
from collections import Counter, defaultdict
from collections.abc import Sequence
from os.path import commonprefix

from calls import Case
from differ import WIDTH, Difference
from run import Result

NUMBER = re.compile(r"\b[0-9a-f]{16,}\b|\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")
FILE = re.compile(r"[\w./+-]*?((?:\.scaled)?\.(?:osim|xml|csv|ndjson|toml|svg|png|html|bak\d*|tmp|partial)\b)")
# Length of a cause, and how many calls are named as examples.
LONGEST, EXAMPLES = 100, 3

Key = tuple[str, str, str]


def table(cases: Sequence[Case], results: Sequence[Result]) -> str:
    """A row for each verb."""
    rows: dict[str, Counter[str]] = defaultdict(Counter)
    for result in results:
        for row in (rows[cases[result.case].verb], rows["all"]):
            row["cases"] += 1
            row["files"] += result.files
            row["bytes"] += result.bytes
            row["differ"] += bool(result.differences)
    lines = [f"{'verb':<12} {'cases':>7} {'files':>9} {'bytes':>15} {'differ':>7}"]
    for verb in [*sorted(verb for verb in rows if verb != "all"), "all"]:
        row = rows[verb]
        lines.append(f"{verb:<12} {row['cases']:>7} {row['files']:>9} {row['bytes']:>15} {row['differ']:>7}")
    return "\n".join(lines)


def groups(results: Sequence[Result]) -> dict[Key, list[Result]]:
    """Differing cases by what differs first, the largest group first."""
    found: dict[Key, list[Result]] = defaultdict(list)
    for result in results:
        if result.differences:
            found[key_of(result.differences)].append(result)
    return dict(sorted(found.items(), key=lambda item: -len(item[1])))


def key_of(differences: Sequence[Difference]) -> Key:
    """The likely cause: the words in which the first differing lines differ, numbers and names of files left out."""
    first = differences[0]
    part = re.sub(r"^call \d+: ", "", first.part)
    if part == "exit status":
        part = f"exit status {first.old}, now {first.new}"
        streams = [one for name in ("error", "output") for one in differences if one.part.endswith(f"standard {name}")]
        return part, *(changed_words(streams[0].old, streams[0].new) if streams else ("", ""))
    if part.startswith("file "):
        part = "file *" + "".join(re.findall(r"\.\w+$", part))
    return part, *changed_words(first.old, first.new)


def changed_words(old: str, new: str) -> tuple[str, str]:
    """The words in which two lines differ, without numbers and names of files."""
    gone, came = (NUMBER.sub("#", FILE.sub(r"*\1", words)) for words in between(old, new))
    return gone[:LONGEST], came[:LONGEST]


def between(old: str, new: str) -> tuple[str, str]:
    """The two lines without the words at both ends that they share."""
    start = len(commonprefix([old, new]))
    while start and old[start - 1].isalnum():
        start -= 1
    end = len(commonprefix([old[start:][::-1], new[start:][::-1]]))
    while end and old[-end].isalnum():
        end -= 1
    return old[start : len(old) - end], new[start : len(new) - end]


def told_groups(cases: Sequence[Case], found: dict[Key, list[Result]]) -> str:
    """The groups, each with its count and some calls."""
    lines = []
    for (part, old, new), members in found.items():
        lines.append(f"{len(members)} x {part}:  - {old!r}  + {new!r}")
        unsteady = sum(member.unsteady for member in members)
        if unsteady:
            lines.append(f"    (in {unsteady} of them the old program does not agree with itself either)")
        lines += [f"    {cases[member.case].call}" for member in members[:EXAMPLES]]
    return "\n".join(lines)


def told_cases(cases: Sequence[Case], found: dict[Key, list[Result]], show: int) -> str:
    """Some differing cases in full: of each group its first, then of each its second, and so on."""
    chosen: list[Result] = []
    for place in range(show):
        chosen += [members[place] for members in found.values() if place < len(members)]
    lines = []
    for result in chosen[:show]:
        lines.append(f"$ {cases[result.case].call}")
        for difference in result.differences[:4]:
            lines.append(f"  {difference.part}")
            if max(len(difference.old), len(difference.new)) > WIDTH:
                gone, came = between(difference.old, difference.new)
                lines.append(f"    within a long line:  - {gone[:LONGEST]!r}  + {came[:LONGEST]!r}")
            lines += [f"    {line}" for line in difference.diff]
        more = len(result.differences) - 4
        lines += [f"  ... and {more} more differences"] if more > 0 else []
    return "\n".join(lines)
