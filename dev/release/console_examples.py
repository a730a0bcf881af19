"""The ```console examples of the documentation: finds them, runs them with a program, and compares what it prints.

    python3 dev/release/console_examples.py PROGRAM FOLDER [PAGE...]

FOLDER is the top of the sources or of an unpacked archive. Examples are written as tests/documents.rs reads them: `$ COMMAND`, then
`? STATUS` if it is not 0, then the output, where a line `...` means any lines and `[..]` any text of a line.
"""

import difflib
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import NamedTuple

COMMAND = "osim-contact-scale"
BLOCK = re.compile(r"^```console[^\n]*\n(?P<body>.*?)^```$", re.S | re.M)
#: A folder of fixtures in a command: its files may name one another, so that they belong together.
FIXTURES = re.compile(r"(?<![\w/])fixtures/(\w+)(?=/|\s|$)")
#: Settings as in tests/documents.rs: no terminal, which would break lines, no colours, and the date of notes, 2025-11-26.
SETTINGS = {"NO_COLOR": "1", "SOURCE_DATE_EPOCH": "1764115200"}
SECONDS = 120


class Example(NamedTuple):
    line: int
    command: str
    status: int
    output: list


def pages(folder):
    """The pages that may hold examples."""
    return [folder / "README.md", *sorted((folder / "docs").rglob("*.md"))]


def examples(text):
    """The examples of a page, in its order."""
    result = []
    for block in BLOCK.finditer(text):
        first = text.count("\n", 0, block.start("body")) + 1
        result += in_block(block["body"].splitlines(), first)
    return result


def in_block(lines, first):
    starts = [at for at, line in enumerate(lines) if line.startswith("$ ")]
    result = []
    for start, end in zip(starts, [*starts[1:], len(lines)]):
        command, rest = lines[start][2:], lines[start + 1:end]
        while rest and rest[0].startswith("> "):
            command += "\n" + rest.pop(0)[2:]
        status = int(rest.pop(0)[2:]) if rest and re.fullmatch(r"\? \d+", rest[0]) else 0
        result.append(Example(first + start, command, status, rest))
    return result


def folders(text):
    """The folders of fixtures that the examples of a page name."""
    return {name for example in examples(text) for name in FIXTURES.findall(example.command)}


def as_expected(lines, printed):
    """Whether a program printed these lines; blanks at the ends of lines and empty lines at the end do not count."""
    expected = list(lines)
    while expected and not expected[-1].strip():
        expected.pop()
    pattern = "".join(r"(?:.*\n)*?" if line.strip() == "..." else one_line(line) for line in expected)
    printed = re.sub(r"[ ]+$", "", printed, flags=re.M).rstrip("\n")
    return re.fullmatch(pattern, printed + "\n" if printed else "") is not None


def one_line(line):
    text = re.escape(line.rstrip()).replace(re.escape("[..]"), ".*").replace(re.escape("[EXE]"), r"(?:\.exe)?")
    return text + r"\n"


def run(example, program, folder):
    """The status and what is printed, with nothing of this machine's environment."""
    words = shlex.split(example.command)
    if words[0] != COMMAND:
        raise ValueError(f"an example calls {words[0]}, not {COMMAND}")
    # Windows loads no program without it.
    needed = {"SystemRoot": os.environ["SystemRoot"]} if os.name == "nt" else {}
    process = subprocess.run([program, *words[1:]], cwd=folder, env={**needed, **SETTINGS}, stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=SECONDS)
    printed = process.stdout.decode("utf-8").replace("\r\n", "\n")
    return process.returncode, printed.replace("\\", "/") if os.name == "nt" else printed


def differences(page, program, fixtures):
    """Runs a page from a folder with untouched fixtures; gives the number of its examples and a text for each that is not true."""
    found = examples(page.read_text(encoding="utf-8"))
    wrong = []
    if found:
        with tempfile.TemporaryDirectory() as folder:
            shutil.copytree(fixtures, Path(folder) / "fixtures")
            for example in found:
                status, printed = run(example, program, folder)
                if status != example.status or not as_expected(example.output, printed):
                    wrong.append(differences_of_example(page, example, status, printed))
    return len(found), wrong


def differences_of_example(page, example, status, printed):
    """The differences between an example and its run: its status, and the lines that are not as the page has them."""
    lines = difflib.unified_diff(example.output, printed.splitlines(), "expected", "printed", lineterm="")
    return "\n".join([f"{page}:{example.line}: $ {example.command}", f"status {status}, expected {example.status}", *lines])


def compare(program, folder, some=None):
    """Runs all pages of a folder, or some; gives the number of examples, and fails with those that are not true."""
    counted = [differences(page, program, folder / "fixtures") for page in some or pages(folder)]
    wrong = [text for _, texts in counted for text in texts]
    assert not wrong, "\n".join([*wrong, f"{len(wrong)} examples are not true"])
    return sum(number for number, _ in counted)


def main(program, folder, *some):
    number = compare(Path(program).resolve(), Path(folder).resolve(), [Path(page).resolve() for page in some])
    print(f"{number} examples are true")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
