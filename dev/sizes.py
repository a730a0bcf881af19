#!/usr/bin/env python3
"""How large the project is: files, lines of code, types, public names, attributes, other languages.

    python3 dev/sizes.py            the tables
    python3 dev/sizes.py --unused   also the public names that nothing else uses

A line of code is neither blank nor comment nor documentation nor test. Of Rust, crates/*/src counts; bodies of macros are code.
"""

import re
import subprocess
import sys
from pathlib import Path
from statistics import median

ROOT = Path(__file__).resolve().parent.parent

# Libraries that people may use by themselves: what they show needs no other user.
FREE = ("contact-scaling", "contact-plots")

# A comment, a text, or a word or sign of code.
TOKEN = re.compile(
    r"""(//[^\n]*|/\*.*?\*/)"""
    r"""|(b?r(?P<h>\#*)".*?"(?P=h)|b?c?"(?:\\.|[^"\\])*"|b?'(?:\\(?:x..|u\{[^}]*\}|.)|[^'\\])'|'?\w+|[^\s\w])""",
    re.S,
)
TEST = ["#", "[", "cfg", "(", "test", ")", "]"]
ITEM_KEYWORDS = ("fn", "struct", "enum", "trait", "const", "static", "type")

# Other languages: what counts, and how a line begins that does not.
OTHERS = [
    ("Python", ("python/*.py", "dev/*.py", "demonstrations/*.py", "fixtures/*.py"), "#"),
    ("page", ("web/*.ts", "web/*.mjs", "web/*.css", "web/*.html"), "//"),
    ("MATLAB", ("matlab/*.m",), "%"),
    ("shell", ("dev/*.sh", ".ci/run", "dev/thorough"), "#"),
]


def tracked(*patterns):
    listed = subprocess.run(["git", "ls-files", "-z", *patterns], cwd=ROOT, capture_output=True, check=True, text=True).stdout
    paths = [ROOT / name for name in listed.split("\0") if name]
    return [path for path in paths if path.is_file() and not path.is_symlink()]


def tokens(text):
    """Words and signs of code, each with its line and how many more it has; without items under #[cfg(test)]."""
    line, at, found = 1, 0, []
    for one in TOKEN.finditer(text):
        line, at = line + text.count("\n", at, one.start()), one.start()
        if one[2]:
            found.append((one[2], line, one[2].count("\n")))
    remaining, place = [], 0
    while place < len(found):
        if found[place][0] != "#" or [word for word, _, _ in found[place : place + 7]] != TEST:
            remaining.append(found[place])
            place += 1
            continue
        place, depth = place + 7, 0
        while place < len(found):
            word = found[place][0]
            depth += (word in ("(", "[", "{")) - (word in (")", "]", "}"))
            place += 1
            if depth == 0 and word in (";", "}"):
                break
    return remaining


def public(words):
    """The kinds and names of what is `pub` without a limit."""
    for place, word in enumerate(words[:-2]):
        if word == "pub" and words[place + 1] != "(":
            rest = [one for one in words[place + 1 : place + 5] if one not in ("async", "unsafe")]
            if rest[:2] == ["const", "fn"]:
                rest = rest[1:]
            if rest[0] in ITEM_KEYWORDS:
                yield rest[0], rest[1]


def used_names(words):
    """The names in what is public: in signatures, fields, variants, and associated types. What has a public name there cannot hide it."""
    found = set()
    for place, word in enumerate(words):
        starts = word == "pub" and words[place + 1 : place + 2] != ["("] or word == "type"
        rest = iter(words[place + 2 :]) if starts else iter(())
        is_type = any(one in ("enum", "trait") for one in words[place + 1 : place + 2])
        depth = 0
        for one in rest:
            depth += (one in "([{<") - (one in ")]}>")
            if one == ";" or depth < 0 or (one == "{" and not is_type) or (one == "," and depth == 0) or (one == "}" and depth == 0):
                break
            found.add(one)
    return found


def users_of_names():
    """The words of each crate's sources, and of all tests, examples, benchmarks and fuzz targets together."""
    result = {}
    for path in tracked("*.rs"):
        parts = path.relative_to(ROOT).parts
        of = parts[1] if parts[0] == "crates" and parts[2] == "src" else "tests"
        result.setdefault(of, set()).update(re.findall(r"\w+", path.read_text("utf-8")))
    return result


def rust():
    sources = tracked("crates/*/src/*.rs")
    texts = {path: path.read_text("utf-8") for path in sources}
    code = {path: tokens(text) for path, text in texts.items()}
    words = {path: [word for word, _, _ in found] for path, found in code.items()}
    lines = sum(len({at for _, line, more in found for at in range(line, line + more + 1)}) for found in code.values())
    lengths = [len(text.splitlines()) for text in texts.values()]
    glue = sum(len(re.findall(r"(?m)^\s*(?:(?:pub(?:\([^)]*\))? )?(?:use|mod) |//!)", text)) for text in texts.values())
    types = sum(
        1 for of in words.values() for one, two in zip(of, of[1:]) if one in ("struct", "enum", "trait", "union") and two[0].isupper()
    )
    inner = {path: of for path, of in words.items() if path.relative_to(ROOT).parts[1] not in FREE}
    attributes = sum(of.count("must_use") + of.count("non_exhaustive") for of in inner.values())
    names = [(path.relative_to(ROOT).parts[1], kind, name) for path, of in inner.items() for kind, name in public(of)]
    used = users_of_names()
    reached = {}
    for path, of in inner.items():
        reached.setdefault(path.relative_to(ROOT).parts[1], set()).update(used_names(of))
    unused = [
        one
        for one in names
        if not any(one[2] in of for user, of in used.items() if user != one[0])
        and (one[1] in ("fn", "const", "static") or one[2] not in reached[one[0]])
    ]
    beside = [path for path in tracked("crates/*/src/*") if path.suffix != ".rs"]
    data = sum(len(path.read_text("utf-8").splitlines()) for path in beside)
    rows = [
        ("crates", len({path.relative_to(ROOT).parts[1] for path in sources})),
        ("source files", len(sources)),
        ("lines of the median file", round(median(lengths))),
        ("files under 40 lines", sum(length < 40 for length in lengths)),
        ("files over 500 lines", sum(length > 500 for length in lengths)),
        ("lines of code", lines),
        ("lines of data beside them (tables, lists, presets, styles)", data),
        ("types", types),
        ("use, mod and //! per 1,000 lines of code", round(1000 * glue / lines)),
        ("public names outside the free libraries", len(names)),
        ("  of them that nothing else uses, by name or in what it uses", len(unused)),
        ("#[must_use] and #[non_exhaustive] there", attributes),
    ]
    return rows, unused


def table(title, rows):
    print(f"\n{title}")
    for name, number in rows:
        print(f"{number:9,}  {name}")


def main():
    rows, unused = rust()
    table("Rust, crates/*/src", rows)
    others = []
    for name, patterns, comment in OTHERS:
        result = [line.strip() for path in tracked(*patterns) for line in path.read_text("utf-8").splitlines()]
        others.append((name, sum(bool(line) and not line.startswith(comment) for line in result)))
    table("Lines of other languages, neither blank nor comment", others)
    words = [(name, len((ROOT / name).read_text("utf-8").split())) for name in ("CHANGELOG.md", "CONTRIBUTING.md")]
    table("Words", words)
    if "--unused" in sys.argv:
        print("\n" + "\n".join(sorted(" ".join(one) for one in unused)))


if __name__ == "__main__":
    main()
