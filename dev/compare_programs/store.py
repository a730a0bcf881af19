"""The files that cases are about: fixtures, models of other people, and small texts written here."""

import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from calls import ESCAPE, Case, Content, steps_of
from texts import TEXTS

TOKEN = re.compile(r"[\w./+-]+")
INCLUDED = re.compile(rb'\bfile="([^"]+)"')
HELD = (".osim", ".xml", ".csv", ".toml")

# Short names of fixtures that many cases use.
ALIASES = {
    "human.osim": "table1/human_62kg_smooth_sphere.osim",
    "hunt.osim": "table1/human_62kg_hunt_crossley.osim",
    "heavy.osim": "table1/human_500kg_smooth_sphere.osim",
    "mouse.osim": "table1/mouse_smooth_sphere.osim",
    "rat.osim": "table1/mouse_hunt_crossley.osim",
    "emu.osim": "table1/emu_10_spheres_smooth_sphere.osim",
    "emu2.osim": "table1/emu_2_spheres_hunt_crossley.osim",
    "horse.osim": "table1/horse_smooth_sphere.osim",
    "giraffe.osim": "table1/giraffe_smooth_sphere.osim",
    "model.osim": "format/v40000.osim",
    "other.osim": "format/v30000.osim",
    "old.osim": "format/v20001.osim",
    "feet.osim": "format/v30000_two_feet.osim",
    "foot.osim": "format/left_out_in_the_middle.osim",
    "counts.osim": "format/unequal_counts.osim",
    "radii.osim": "format/unequal_radii.osim",
    "unlike.osim": "format/unequal_stiffness.osim",
    "sideless.osim": "format/no_sides.osim",
    "ball.osim": "format/player_and_ball.osim",
    "weightless.osim": "format/no_gravity.osim",
    "materials.osim": "format/three_materials.osim",
    "mixed.osim": "format/mixed_radii.osim",
    "elastic.osim": "format/zero_dissipation.osim",
    "shared.osim": "format/shared_sphere.osim",
    "terrain.osim": "format/terrain_welded.osim",
    "include.osim": "format/file_forceset.osim",
    "none.osim": "bad/no_contacts.osim",
    "comma.osim": "bad/number_decimal_comma.osim",
    "truncated.osim": "bad/truncated.osim",
    "zero.osim": "bad/stiffness_zero.osim",
    "text.osim": "bad/not_xml.osim",
    "massless.osim": "bad/mass_missing.osim",
    "floats.osim": "check/floats.osim",
    "good.osim": "check/within_limits.osim",
    "sunk.osim": "check/sunk_in.osim",
    "forces.xml": "format/standalone_ForceSet.xml",
    "geometry.xml": "format/standalone_ContactGeometrySet.xml",
    "bones.osim": "format/standalone_model_without_contacts.osim",
    "generic.osim": "scale_tool/generic_smooth.osim",
    "scaled.osim": "scale_tool/scaled_smooth.osim",
    "generic_hunt.osim": "scale_tool/generic_hunt_crossley.osim",
    "scaled_hunt.osim": "scale_tool/scaled_hunt_crossley.osim",
    "applied.xml": "scale_tool/applied_scale_set.xml",
    "heel.csv": "measured/heel_pad.csv",
    "heel_eu.csv": "measured/heel_pad_european.csv",
}

# Folders, as name to what is in them.
FOLDERS = {
    "lib": {
        "a_human.osim": "human.osim",
        "b_comma.osim": "comma.osim",
        "c_none.osim": "none.osim",
        "d_sunk.osim": "sunk.osim",
    },
    "shape": {
        "right/foot.osim": "model.osim",
        "left/foot.osim": "other.osim",
        "UPPER.OSIM": "old.osim",
        "none.osim": "none.osim",
        "before.scaled.osim": "model.osim",
        "notes.txt": "text.osim",
    },
    "pair": {"a.osim": "model.osim", "b.osim": "other.osim"},
    "left": {"foot.osim": "model.osim", "more.osim": "mouse.osim"},
    "right": {"FOOT.osim": "other.osim", "more.osim": "emu2.osim"},
}
# Models of the numbered libraries, in turn: small and large ones of both classes, in old and new spelling.
IN_TURN = ("model.osim", "human.osim", "other.osim", "hunt.osim", "old.osim")
NUMBERED = {"five": 5, "dozen": 12, "thirty": 30}
# A folder in which any known file can be named.
DEEP = "deep"
# A large one has small models alone.
LARGE, SMALL = {"thousand": 1005}, ("model.osim",)


class Store:
    """Every file by the name under which cases know it."""

    def __init__(self, fixtures: Path, corpus: Path | None) -> None:
        self.fixtures = fixtures
        self.files: dict[str, Content] = {name: text.encode() for name, text in TEXTS.items()}
        self.models: list[str] = []
        self._add_all(fixtures)
        if corpus:
            self._add_all(corpus)
        for name, fixture in ALIASES.items():
            self.files[name] = fixtures / fixture
        self.folders = {folder: self._folder(files) for folder, files in FOLDERS.items()}
        self.folders |= {folder: dict(self._numbered(count, IN_TURN)) for folder, count in NUMBERED.items()}
        self.folders |= {folder: dict(self._numbered(count, SMALL)) for folder, count in LARGE.items()}

    def _add_all(self, top: Path) -> None:
        for path in sorted(top.rglob("*")):
            if path.is_file() and path.suffix in HELD and not path.name.endswith(".scaled.osim"):
                self.files.setdefault(path.name, path)
                if path.suffix in (".osim", ".xml"):
                    self.models.append(path.name)

    def _folder(self, files: dict[str, str]) -> dict[str, Content]:
        return {name: self.files[alias] for name, alias in files.items()}

    def _numbered(self, count: int, in_turn: tuple[str, ...]) -> Iterator[tuple[str, Content]]:
        """Models of which no two are alike, in two folders."""
        for number in range(count):
            alias = in_turn[number % len(in_turn)]
            side = "even" if number % 2 == 0 else "odd"
            yield f"{side}/model{number:02}.osim", self.read(alias) + b"<!-- model %d -->\n" % number

    def read(self, name: str) -> bytes:
        """The bytes of a file known as `name`."""
        content = self.files[name]
        return content if isinstance(content, bytes) else content.read_bytes()

    def case(self, family: str, call: str) -> Case:
        """The case of a line: its steps, and the files that it names."""
        files: dict[str, Content] = {}
        # The line ends of texts that the call writes part names, too.
        self._collect(ESCAPE.sub(" ", call), "", files)
        return Case(call, family, steps_of(call), tuple(files.items()))

    def _collect(self, text: str, folder: str, files: dict[str, Content]) -> None:
        """Adds what `text` names to `files`; names in it begin in `folder`."""
        for token in TOKEN.findall(text):
            name = token.removeprefix("./").rstrip("/")
            top = name.split("/")[0]
            if name in self.files:
                self._add(folder + name, self.files[name], files)
            elif top in self.folders:
                for inner, content in self.folders[top].items():
                    self._add(f"{folder}{top}/{inner}", content, files)
            elif top == DEEP:
                self._collect(name.removeprefix(f"{DEEP}/"), f"{folder}{DEEP}/", files)
            elif top == "fixtures":
                self._add_fixture(name, files)

    def _add_fixture(self, name: str, files: dict[str, Content]) -> None:
        """A fixture under its own path, as the documents name it."""
        path = self.fixtures.parent / name
        inner = sorted(path.rglob("*.osim")) if path.is_dir() else [path] if path.is_file() else []
        for one in inner:
            self._add(one.relative_to(self.fixtures.parent).as_posix(), one, files)

    def _add(self, name: str, content: Content, files: dict[str, Content]) -> None:
        """A file with what it includes, or, a table, with the models that it names."""
        if name in files:
            return
        files[name] = content
        folder = name[: name.rfind("/") + 1]
        if name.endswith(".csv"):
            text = content if isinstance(content, bytes) else content.read_bytes()
            self._collect(text.decode("utf-8", "replace"), folder, files)
        elif isinstance(content, Path) and content.suffix in (".osim", ".xml"):
            for included in included_by(content):
                files.setdefault(folder + included.name, included)


@cache
def included_by(path: Path) -> list[Path]:
    """Files that a model or set includes, as far as they are there."""
    names = [match.group(1).decode("utf-8", "replace") for match in INCLUDED.finditer(path.read_bytes())]
    return [path.parent / name for name in names if (path.parent / name).is_file()]
