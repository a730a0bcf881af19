"""The recipes of docs/simulations.md, as they stand on the page.

A block whose first comment begins with the name of a file (`# array.sh: ...`) is that file; other blocks in `bash` are typed.
"""

import re
from dataclasses import dataclass

from conftest import TOP

PAGE = TOP / "docs" / "simulations.md"

_SECTION = re.compile(r"^## (.*)$", re.M)
_BLOCK = re.compile(r"^```(bash|python)\n(.*?)^```$", re.M | re.S)
#: The beginning of a recipe's file.
NAME = re.compile(r"\A(?:#!.*\n)?# ([\w.]+): ")


@dataclass(frozen=True)
class Recipe:
    """A section of the page: the lines to type, and the output."""

    #: Texts of files by their names.
    files: dict[str, str]
    #: The lines that are typed, in their order.
    typed: tuple[str, ...]

    def write(self, folder):
        """Writes the files into a folder."""
        for name, text in self.files.items():
            (folder / name).write_text(text, encoding="utf-8")


def recipe(section):
    """The recipe with this heading."""
    parts = _SECTION.split(PAGE.read_text(encoding="utf-8"))
    text = dict(zip(parts[1::2], parts[2::2]))[section]
    files, typed = {}, []
    for language, block in _BLOCK.findall(text):
        name = NAME.match(block)
        if name:
            files[name[1]] = block
        else:
            assert language == "bash", block
            typed.append(block)
    assert files or typed, section
    return Recipe(files, tuple(typed))


def changed(text, *pairs):
    """A text with words replaced, each of which must be in it."""
    for old, new in pairs:
        assert old in text, (old, text)
        text = text.replace(old, new)
    return text
