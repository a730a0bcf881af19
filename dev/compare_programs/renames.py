"""The map of what changed on purpose: applied to what the old program left, printed, and counted.

One entry a line, `KIND OLD -> NEW`; lines that begin with `#` are comments:

    field to_kg -> target_mass_kg      a field of JSON, at any depth; `finding.to_kg` only within `finding`
    field remedy ->                    the old program alone has it;  `field -> request`: the new one alone
    column mass -> target_mass         the same for columns of CSV
    text give --mass -> give --to      any text, in streams and files
    pattern mass of (\\d+) -> \\1 kg     the same by a regular expression
    ignore [0-9a-f]{64}                a regular expression: what it matches is not compared, in the old and in the new

A side that is written as a JSON string ("a -> b", " blank") is read as one.
"""

import csv
import io
import json
import re
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

TOKEN = re.compile(r'"(?:[^"\\]|\\.)*"|[{}\[\],:]|[^\s"{}\[\],:]+')
# Names of temporary files hold the process and chance.
TEMPORARY = re.compile(r"\.osim-contact-scale-[A-Za-z0-9._]+-\d+-[A-Za-z0-9]{6}\.tmp")

Entry = tuple[str, str, str]


class Map:
    """All entries, as kind, old and new; and how often each was used."""

    def __init__(self, path: Path | None) -> None:
        lines = path.read_text("utf-8").splitlines() if path else []
        self.entries = [parse_entry(line.strip()) for line in lines if line.strip() and not line.strip().startswith("#")]
        self.used: Counter[Entry] = Counter()

    def apply(self, data: bytes, name: str, is_old: bool) -> bytes:
        """The bytes of a stream or a file as they are compared."""
        text = TEMPORARY.sub(".temporary", data.decode("utf-8", "surrogateescape"))
        if any(kind == "field" for kind, _, _ in self.entries):
            text = "".join(self.json_line(line, is_old) for line in text.splitlines(keepends=True))
        if name.removesuffix(".partial").endswith((".csv", "standard output")):
            text = self.table(text, is_old)
        for entry in self.entries:
            kind, old, new = entry
            if kind == "ignore" or (kind in ("text", "pattern") and is_old):
                pattern = re.escape(old) if kind == "text" else old
                text, count = re.subn(pattern, new if kind == "pattern" else lambda _, new=new: new, text)
                self.used[entry] += count * is_old
        return text.encode("utf-8", "surrogateescape")

    def json_line(self, line: str, is_old: bool) -> str:
        """A line with its fields renamed or left out, if it is a JSON object that has such fields; else as it is."""
        if not line.startswith("{") or not any(f'"{name}"' in line for name in self.names("field", is_old)):
            return line
        try:
            json.loads(line)
        except ValueError:
            return line
        before = self.used.total()
        changed = self.value(iter(TOKEN.findall(line)), "", is_old) + line[len(line.rstrip()) :]
        return changed if self.used.total() > before else line

    def value(self, tokens: Iterator[str], path: str, is_old: bool, first: str = "") -> str:
        """The next value, spelled as it was but for the names of fields."""
        token = first or next(tokens)
        if token not in ("{", "["):
            return token
        parts = []
        end = {"{": "}", "[": "]"}[token]
        for inner in iter(lambda: next(tokens), end):
            if end == "]":
                parts += [self.value(tokens, path, is_old, inner)] if inner != "," else []
            elif inner not in (",", ":"):
                name = json.loads(inner)
                next(tokens)
                value = self.value(tokens, f"{path}.{name}", is_old)
                renamed = self.renamed("field", f"{path}.{name}", is_old)
                parts += [f"{inner if renamed == name else json.dumps(renamed)}:{value}"] if renamed else []
        return f"{token}{','.join(parts)}{end}"

    def table(self, text: str, is_old: bool) -> str:
        """A table with its columns renamed or left out; as it is where it has no such columns."""
        if not self.names("column", is_old).intersection(next(csv.reader([text.split("\n", 1)[0]]), [])):
            return text
        rows = list(csv.reader(io.StringIO(text, newline="")))
        rows[0] = [self.renamed("column", name, is_old) for name in rows[0]]
        remaining = [at for at, name in enumerate(rows[0]) if name]
        out = io.StringIO(newline="")
        csv.writer(out, lineterminator="\n").writerows([row[at] for at in remaining if at < len(row)] for row in rows)
        return out.getvalue()

    def names(self, kind: str, is_old: bool) -> set[str]:
        """The last parts of all names that entries of a kind have on one side."""
        return {entry[1 if is_old else 2].rsplit(".", 1)[-1] for entry in self.entries if entry[0] == kind} - {""}

    def renamed(self, kind: str, name: str, is_old: bool) -> str:
        """The name under which a field or column is compared; empty if it is left out."""
        for entry in self.entries:
            _, old, new = entry
            if entry[0] == kind and (is_old or not old) and f".{name}".endswith(f".{old if is_old else new}"):
                self.used[entry] += 1
                return new.rsplit(".", 1)[-1] if is_old else ""
        return name.rsplit(".", 1)[-1] if kind == "field" else name

    def lines(self) -> list[str]:
        """The map, each entry with how often it was used."""
        return [f"{self.used[entry]:>9} x  {entry[0]}  {entry[1]!r} -> {entry[2]!r}" for entry in self.entries]


def parse_entry(line: str) -> Entry:
    """Reads an entry."""
    kind, _, remainder = line.partition(" ")
    old, arrow, new = (remainder, "->", "...") if kind == "ignore" else f" {remainder} ".partition(" -> ")
    old, new = (json.loads(side) if re.fullmatch(r'\s*".*"\s*', side) else side.strip() for side in (old, new))
    if kind not in ("field", "column", "text", "pattern", "ignore") or not arrow or not (old or (new and kind in ("field", "column"))):
        raise SystemExit(f"error: {line!r}: expected KIND OLD -> NEW, with one of the kinds of renames.py")
    return kind, old, new
