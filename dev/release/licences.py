"""The licences of everything that is in what people download: of libraries, of the font, of what the compiler adds."""

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LICENCE_FILES = re.compile(r"(LICEN[CS]E|COPYING|COPYRIGHT|NOTICE|UNLICENSE)", re.IGNORECASE)


def linked(metadata, root):
    """Packages of other people that the package `root` of ours is built from, sorted by name."""
    nodes = {node["id"]: node for node in metadata["resolve"]["nodes"]}
    packages = {package["id"]: package for package in metadata["packages"]}
    ours = next(p["id"] for p in packages.values() if p["name"] == root)
    visited, todo = set(), [ours]
    while todo:
        node = nodes[todo.pop()]
        if node["id"] not in visited:
            visited.add(node["id"])
            todo += [d["pkg"] for d in node["deps"] if any(k["kind"] is None for k in d["dep_kinds"])]
    foreign = [packages[i] for i in visited if packages[i]["source"]]
    return sorted(foreign, key=lambda package: (package["name"], package["version"]))


def licences(metadata, root, target):
    """Names, licences and licence texts of everything in `root` built for `target`; a text that is the same stands once."""
    texts, head = {}, ["The program contains these libraries. Their licence texts follow.\n"]
    for package in linked(metadata, root):
        name = f"{package['name']} {package['version']}"
        head.append(f"{name}: {package['license']}")
        for file in sorted(Path(package["manifest_path"]).parent.iterdir()):
            if file.is_file() and LICENCE_FILES.match(file.name):
                text = file.read_text(encoding="utf-8", errors="replace").strip()
                texts.setdefault(text, []).append(f"{name} ({file.name})")
    # The font of PNG pictures is compiled in, but is no library.
    font = ROOT / "crates/contact-plots/fonts/OFL.txt"
    head.append("Arimo 1.33: OFL-1.1")
    texts.setdefault(font.read_text(encoding="utf-8").strip(), []).append("Arimo 1.33 (OFL.txt)")
    head.append("\nThe standard library of Rust: MIT OR Apache-2.0 (https://www.rust-lang.org).")
    # A wheel for musl has the archive's program, too.
    if "-linux-" in target:
        head.append("The GNU C Library: LGPL-2.1-or-later (https://www.gnu.org/software/libc). The program's sources are\n"
                    "open: dev/release/build_archive.py links them with any other version of it.")
    if target.endswith("linux-musl"):
        head.append("musl: MIT (https://musl.libc.org).")
    parts = ["\n".join(head)]
    parts += ["\n".join(names) + "\n\n" + text for text, names in texts.items()]
    return ("\n\n" + "=" * 80 + "\n\n").join(parts).encode() + b"\n"
