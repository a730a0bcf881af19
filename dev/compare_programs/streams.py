"""What a program reads from and writes to: files, devices, terminals, and pipes that are fed while it runs."""

import contextlib
import fcntl
import os
import pty
import signal
import struct
import subprocess
import termios
import threading
import time
from collections.abc import Iterator
from pathlib import Path

# Rows and columns of a terminal.
SIZE = (40, 100)
# Until a program has noticed that it was interrupted.
NOTICED = 0.3


class Terminal:
    """A terminal that keeps what is written to it."""

    def __init__(self) -> None:
        self.ours, self.theirs = pty.openpty()
        fcntl.ioctl(self.theirs, termios.TIOCSWINSZ, struct.pack("HHHH", *SIZE, 0, 0))
        self.parts: list[bytes] = []
        self.reader = threading.Thread(target=self._read)

    def _read(self) -> None:
        # The end of a terminal is an error on some systems.
        with contextlib.suppress(OSError):
            while part := os.read(self.ours, 65536):
                self.parts.append(part)

    def start(self) -> None:
        """Reads from now on; the program has its end by now."""
        os.close(self.theirs)
        self.reader.start()

    def text(self) -> bytes:
        """All that was written, when the program has ended."""
        self.reader.join()
        os.close(self.ours)
        return b"".join(self.parts)


@contextlib.contextmanager
def standard_input(path: Path | None) -> Iterator[int]:
    """A file as standard input, or nothing to read."""
    if path is None:
        yield subprocess.DEVNULL
        return
    number = os.open(path, os.O_RDONLY)
    try:
        yield number
    finally:
        os.close(number)


@contextlib.contextmanager
def standard_output(kind: str | None) -> Iterator[int]:
    """A full device, a pipe that nobody reads, or what the caller reads."""
    if kind is None:
        yield subprocess.PIPE
        return
    if kind == "full":
        number = os.open("/dev/full", os.O_WRONLY)
    elif kind == "closed":
        reading, number = os.pipe()
        os.close(reading)
    else:
        raise ValueError(f"'> {kind}': expected full, closed or terminal")
    try:
        yield number
    finally:
        os.close(number)


class Feeder:
    """Writes into a named pipe as soon as the program reads it; may interrupt the program (Ctrl-C) before."""

    def __init__(self, pipe: Path, data: bytes, stops: bool) -> None:
        self.pipe, self.data, self.stops = pipe, data, stops
        self.thread = threading.Thread(target=self._feed)
        self.child: subprocess.Popen[bytes] | None = None

    def start(self, child: "subprocess.Popen[bytes]") -> None:
        """Waits for the program beside everything else."""
        self.child = child
        self.thread.start()

    def _feed(self) -> None:
        with contextlib.suppress(OSError):
            number = os.open(self.pipe, os.O_WRONLY)
            try:
                if self.stops and self.child and self.child.poll() is None:
                    self.child.send_signal(signal.SIGINT)
                    time.sleep(NOTICED)
                os.write(number, self.data)
            finally:
                os.close(number)

    def end(self) -> None:
        """Lets go of a pipe that the program never read, and takes it away."""
        while self.thread.is_alive():
            with contextlib.suppress(OSError):
                os.close(os.open(self.pipe, os.O_RDWR | os.O_NONBLOCK))
            self.thread.join(timeout=0.05)
        if self.pipe.is_fifo():
            self.pipe.unlink()
