"""What a program left, and how two of these differ."""

from dataclasses import dataclass
from difflib import unified_diff
from itertools import dropwhile, takewhile

from same import STANDARD_OUTPUT, Rules

# Lines of a difference that are kept, their length, and how many lines are compared one by one.
KEPT, WIDTH, MOST = 14, 240, 20_000

# Everything in a folder: name to what it is, and its bytes.
Files = dict[str, tuple[str, bytes]]


@dataclass
class Outcome:
    """What a call left: its exit status, both streams, and every file."""

    status: str
    out: bytes
    err: bytes
    files: Files

    def count(self) -> int:
        """How many files there are."""
        return sum(kind.startswith("file") for kind, _ in self.files.values())

    def size(self) -> int:
        """Bytes of all that."""
        return len(self.out) + len(self.err) + sum(len(data) for _, data in self.files.values())


@dataclass
class Difference:
    """One thing that differs: where, its first line in both, and a short diff."""

    part: str
    old: str
    new: str
    diff: list[str]


def differences(old: list[Outcome], new: list[Outcome], rules: Rules) -> list[Difference]:
    """What differs in the first call that left something else: exit status, both streams, then files."""
    for number, (one, other) in enumerate(zip(old, new, strict=True), start=1):
        step = f"call {number}: " if len(old) > 1 else ""
        found = texts_differ(step + "exit status", one.status.encode(), other.status.encode())
        streams = ((STANDARD_OUTPUT, one.out, other.out), ("standard error", one.err, other.err))
        for name, mine, theirs in () if rules.models_only else streams:
            found += texts_differ(step + name, rules.apply(mine, name, True), rules.apply(theirs, name, False))
        found += files_differ(step, one.files, other.files, rules)
        if found:
            return found
    return []


def files_differ(step: str, old: Files, new: Files, rules: Rules) -> list[Difference]:
    """Names and kinds first, then the bytes of what both have."""
    found = texts_differ(step + "files", listed(old, rules), listed(new, rules))
    for name in old:
        if name in new and old[name][1] != new[name][1] and rules.compares(name):
            mine, theirs = rules.apply(old[name][1], name, True), rules.apply(new[name][1], name, False)
            found += texts_differ(f"{step}file {name}", mine, theirs)
    return found


def listed(files: Files, rules: Rules) -> bytes:
    """Names and kinds of all files, a line each."""
    shown = {name: kind for name, (kind, _) in files.items() if rules.compares(name)}
    lines = (f"{name} ({kind})\n".encode("utf-8", "surrogateescape") for name, kind in shown.items())
    return rules.apply(b"".join(lines), "", True)


def texts_differ(part: str, old: bytes, new: bytes) -> list[Difference]:
    """The difference of two texts, if there is one, shortened."""
    if old == new:
        return []
    before, after = lines_of(old), lines_of(new)
    if b"\0" in old + new:
        return [Difference(part, "binary", "binary", [f"binary: {len(old)} and {len(new)} bytes"])]
    if max(len(before), len(after)) > MOST:
        both = zip(before, after, strict=False)
        lines = next(([f"-{mine}", f"+{theirs}"] for mine, theirs in both if mine != theirs), ["+more or fewer lines"])
    else:
        lines = list(unified_diff(before, after, "old", "new", lineterm="", n=1))[2:]
    first = first_change(lines) if new else ("(something)", "(nothing)")
    diff = [line[:WIDTH] for line in lines[:KEPT]] + ["..."] * (len(lines) > KEPT)
    return [Difference(part, *first, diff)]


def first_change(diff: list[str]) -> tuple[str, str]:
    """The first line that is gone and the first that came, where the texts first differ; either may be absent."""
    changed = dropwhile(lambda line: line[:1] not in ("-", "+"), diff)
    block = list(takewhile(lambda line: line[:1] in ("-", "+"), changed))
    gone = next((line[1:] for line in block if line.startswith("-")), "")
    came = next((line[1:] for line in block if line.startswith("+")), "")
    return gone, came


def lines_of(data: bytes) -> list[str]:
    """The lines of a text; what is no UTF-8 is shown as escapes."""
    return data.decode("utf-8", "backslashreplace").split("\n")
