"""Messages between a worker and the process that simulates its models: a length of eight bytes, then a pickle."""

from __future__ import annotations

import os
import pickle
import struct
from typing import Any

_LENGTH = struct.Struct("<Q")

#: Whether the system can copy a process that has loaded OpenSim already; otherwise OpenSim starts again for each model.
CAN_FORK = hasattr(os, "fork")


def encode(message: Any) -> bytes:
    """A message as bytes."""
    body = pickle.dumps(message, protocol=pickle.HIGHEST_PROTOCOL)
    return _LENGTH.pack(len(body)) + body


def send(descriptor: int, message: Any) -> None:
    """Writes a whole message.

    Raises
    ------
    OSError
        The other side has closed the pipe.
    """
    remaining = memoryview(encode(message))
    while remaining:
        remaining = remaining[os.write(descriptor, remaining) :]


def receive(descriptor: int) -> Any:
    """Waits for a message.

    Raises
    ------
    EOFError
        The other side ended before the message was complete.
    """
    (length,) = _LENGTH.unpack(_read_exactly(descriptor, _LENGTH.size))
    return pickle.loads(_read_exactly(descriptor, length))


def _read_exactly(descriptor: int, length: int) -> bytes:
    parts = bytearray()
    while len(parts) < length:
        part = os.read(descriptor, min(length - len(parts), 1 << 20))
        if not part:
            raise EOFError
        parts += part
    return bytes(parts)


class MessageBuffer:
    """Collects messages that arrive in pieces, without blocking."""

    def __init__(self, first: bytes = b"") -> None:
        self._bytes = bytearray(first)

    def add(self, piece: bytes) -> None:
        """Adds bytes that were read."""
        self._bytes += piece

    def is_complete(self) -> bool:
        """Whether the buffer has a complete message."""
        return len(self._bytes) >= _LENGTH.size and len(self._bytes) >= self._end()

    def take_message(self) -> Any:
        """Removes the first message, which must be complete, and returns it."""
        end = self._end()
        message = pickle.loads(self._bytes[_LENGTH.size : end])
        del self._bytes[:end]
        return message

    def _end(self) -> int:
        (length,) = _LENGTH.unpack_from(self._bytes)
        return _LENGTH.size + int(length)
