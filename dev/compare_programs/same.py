"""What counts as the same: names of temporary files, and fields that were given other names on purpose."""

import csv
import io
import json
import re
from dataclasses import dataclass, field
from pathlib import Path

TEMPORARY = re.compile(rb"\.osim-contact-scale-[A-Za-z0-9._]+-\d+-[A-Za-z0-9]{6}\.tmp")
PLAIN_NAME = b".osim-contact-scale-HOST-PID-XXXXXX.tmp"
MODELS = (".osim", ".xml")
STANDARD_OUTPUT = "standard output"


class Digits(str):
    """A number of JSON as it is spelt."""


# The digest of all settings in summaries, and its old name.
SETTINGS = {"recipe", "sha256_settings"}


@dataclass(frozen=True)
class Map:
    """Names that changed on purpose, and fields that only the new program has.

    A name stands for that field wherever it is, `a.b` for field `b` of a top field `a` (lists between are passed).
    `columns` and `added_columns` are the same for tables (.csv).
    """

    fields: dict[str, str] = field(default_factory=dict)
    added: frozenset[str] = frozenset()
    columns: dict[str, str] = field(default_factory=dict)
    added_columns: frozenset[str] = frozenset()

    @classmethod
    def read(cls, path: Path) -> "Map":
        """From a JSON object: names, and the keys `added`, `columns` and `added_columns`."""
        whole = json.loads(path.read_text("utf-8"))
        added = frozenset(whole.pop("added", []))
        columns, added_columns = whole.pop("columns", {}), frozenset(whole.pop("added_columns", []))
        if not all(isinstance(name, str) for name in whole.values()):
            raise ValueError(f"{path}: expected names of fields, and the keys added, columns, added_columns")
        return cls(whole, added, columns, added_columns)

    def lines(self) -> list[str]:
        """The map in words."""
        told = [f"  field {old} is now {new}" for old, new in self.fields.items()]
        told += [f"  field {name} is new" for name in sorted(self.added)]
        told += [f"  column {old} is now {new}" for old, new in self.columns.items()]
        return told + [f"  column {name} is new" for name in sorted(self.added_columns)]


@dataclass(frozen=True)
class Rules:
    """How what a program left is made ready for the comparison."""

    map: Map = field(default_factory=Map)
    ignore_settings: bool = False
    # Only what is in models: whether they are written, and their bytes.
    models_only: bool = False

    def compares(self, name: str) -> bool:
        """Whether a file of this name is compared."""
        return not self.models_only or name.removesuffix(".bak").endswith(MODELS)

    def apply(self, data: bytes, name: str, is_old: bool) -> bytes:
        """The bytes of a file, or of a stream of that name, as they are compared."""
        if PLAIN_NAME[:20] in data:
            data = TEMPORARY.sub(PLAIN_NAME, data)
        name = name.removesuffix(".partial")
        of_json = bool(self.map.fields or self.map.added)
        if (of_json and name == STANDARD_OUTPUT) or ((of_json or self.ignore_settings) and name.endswith(".ndjson")):
            return b"".join(self._json_line(line, is_old) for line in data.splitlines(keepends=True))
        of_tables = bool(self.map.columns or self.map.added_columns)
        if (of_tables and name == STANDARD_OUTPUT) or ((of_tables or self.ignore_settings) and name.endswith(".csv")):
            return self._table(data, is_old)
        return data

    def _json_line(self, line: bytes, is_old: bool) -> bytes:
        if not line.startswith(b"{"):
            return line
        try:
            whole = json.loads(line, parse_int=Digits, parse_float=Digits)
        except ValueError:
            return line
        return (_spelt(self._object(whole, "", is_old)) + "\n").encode("utf-8", "surrogatepass")

    def _object(self, value: object, path: str, is_old: bool) -> object:
        """The value with fields renamed (of the old program) or taken out (of the new one)."""
        if isinstance(value, list):
            return [self._object(item, path, is_old) for item in value]
        if not isinstance(value, dict):
            return value
        result = {}
        for name, inner in value.items():
            full = f"{path}.{name}" if path else name
            if not is_old and (name in self.map.added or full in self.map.added):
                continue
            renamed = self.map.fields.get(full, self.map.fields.get(name, name)) if is_old else name
            ignored = self.ignore_settings and full in SETTINGS
            result[renamed] = None if ignored else self._object(inner, full, is_old)
        return result

    def _table(self, data: bytes, is_old: bool) -> bytes:
        """A table whose columns are renamed, taken out or emptied; what is no such table stays as it is."""
        touched = {*self.map.columns, *self.map.added_columns} | (SETTINGS if self.ignore_settings else set())
        try:
            rows = list(csv.reader(io.StringIO(data.decode("utf-8"), newline="")))
        except (csv.Error, UnicodeDecodeError):
            return data
        if not rows or not touched.intersection(rows[0]):
            return data
        header = rows[0]
        kept = [at for at, name in enumerate(header) if is_old or name not in self.map.added_columns]
        for row in rows[1:]:
            for name in SETTINGS.intersection(header) if self.ignore_settings and len(row) == len(header) else ():
                row[header.index(name)] = ""
        if is_old:
            rows[0] = [self.map.columns.get(name, name) for name in header]
        out = io.StringIO(newline="")
        csv.writer(out, lineterminator="\n").writerows([row[at] for at in kept if at < len(row)] for row in rows)
        return out.getvalue().encode("utf-8")


def _spelt(value: object) -> str:
    """A value of JSON as text, numbers as they were spelt."""
    if isinstance(value, Digits):
        return str(value)
    if isinstance(value, dict):
        return "{" + ",".join(f"{_spelt(name)}:{_spelt(inner)}" for name, inner in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ",".join(map(_spelt, value)) + "]"
    return json.dumps(value, ensure_ascii=False)
