"""Steps that prepare or change the folder of a case (`calls.py` lists them)."""

import contextlib
import os
import shutil
import socket
from collections.abc import Callable
from pathlib import Path

from calls import bytes_of


def do(here: Path, words: tuple[str, ...]) -> None:
    """Does what a step says; where a call before it left nothing to change, nothing is changed."""
    verb, *names = words
    with contextlib.suppress(FileNotFoundError):
        CHANGES[verb](here, *names)


def write(path: Path, data: bytes) -> None:
    """Writes a file, with the folders above it."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(data)


def _put(here: Path, name: str, text: str) -> None:
    write(here / name.replace("@HOST@", _host()), bytes_of(text))


def _host() -> str:
    """This computer as it stands in the names of temporary files."""
    return "".join(c if c.isascii() and (c.isalnum() or c in "._") else "_" for c in socket.gethostname()[:64])


def _copy(here: Path, source: str, target: str) -> None:
    write(here / target, (here / source).read_bytes())


def _edit(here: Path, name: str, old: str, new: str, count: int = -1) -> None:
    data = (here / name).read_bytes()
    (here / name).write_bytes(data.replace(old.encode(), new.encode(), count))


def _once(here: Path, name: str, old: str, new: str) -> None:
    _edit(here, name, old, new, 1)


def _cut(here: Path, name: str, count: str) -> None:
    os.truncate(here / name, max(0, (here / name).stat().st_size - int(count)))


def _rm(here: Path, name: str) -> None:
    if (here / name).is_dir():
        shutil.rmtree(here / name)
    else:
        (here / name).unlink()


def _mkdir(here: Path, name: str) -> None:
    (here / name).mkdir(parents=True, exist_ok=True)


def _link(here: Path, target: str, name: str) -> None:
    _room(here / name).symlink_to(target)


def _hard(here: Path, target: str, name: str) -> None:
    _room(here / name).hardlink_to(here / target)


def _pipe(here: Path, name: str) -> None:
    os.mkfifo(_room(here / name))


def _chmod(here: Path, mode: str, name: str) -> None:
    (here / name).chmod(int(mode, 8))


def _room(path: Path) -> Path:
    """Makes room at `path`."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.unlink(missing_ok=True)
    return path


CHANGES: dict[str, Callable[..., None]] = {
    ":put": _put,
    ":copy": _copy,
    ":edit": _edit,
    ":once": _once,
    ":cut": _cut,
    ":rm": _rm,
    ":mkdir": _mkdir,
    ":link": _link,
    ":hard": _hard,
    ":pipe": _pipe,
    ":chmod": _chmod,
}
