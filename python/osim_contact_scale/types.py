"""Types for annotations: arguments and results of this package's functions.

from osim_contact_scale.types import Source, Table

def softer(model: Source) -> Table:
    return ocs.design(model, indentation=0.1).changes
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Any, BinaryIO, Protocol, TypeVar

from ._option_names import Property, Question

if TYPE_CHECKING:
    from typing import TypeAlias

    import pandas as pd

__all__ = [
    "ArrowTable",
    "InterchangeTable",
    "LiveModel",
    "ModelInMemory",
    "Polars",
    "PolarsTable",
    "Progress",
    "Property",
    "Question",
    "Source",
    "Sources",
    "StrPath",
    "Table",
    "TableLike",
]


def __dir__() -> list[str]:
    return list(__all__)


StrPath = str | os.PathLike[str]
"""The name of a file or folder."""

Progress = bool | Callable[[int, bool], object]
"""`True` for a bar (if tqdm is installed), `False` for none, or a function that is called for each model with 1 and whether it failed."""


class LiveModel(Protocol):
    """An `opensim.Model`, described by two of its methods, because OpenSim's package has no types."""

    def printToXML(self, path: str, /) -> Any:
        """Writes the model to a file."""

    def getInputFileName(self) -> Any:
        """The file that the model was read from."""


class ModelInMemory(Protocol):
    """A model that is in no file yet, such as a `Result`: its new bytes, and the name of the old file."""

    @property
    def path(self) -> str:
        """The name of the file that the model was made from."""

    def to_bytes(self) -> bytes:
        """The model as bytes."""


Source = str | os.PathLike[str] | bytes | bytearray | memoryview | BinaryIO | ModelInMemory | LiveModel
"""A model: the path of its file, its bytes, a file opened for them, a result of this package, or an `opensim.Model`."""

Sources = Source | Iterable[Source]
"""One model or several: paths, folders, bytes, results or live models."""


class ArrowTable(Protocol):
    """A table that other libraries can read by the interface of Arrow, such as a `pyarrow.Table`."""

    def __arrow_c_stream__(self, requested_schema: Any = None) -> object:
        """The data of the table."""


class InterchangeTable(Protocol):
    """A table that other libraries can read by the interchange protocol of DataFrames."""

    def __dataframe__(self, nan_as_null: bool = False, allow_copy: bool = True) -> Any:
        """The data of the table."""


class Polars(Protocol):
    """A DataFrame of polars, described by a method that no other library has."""

    def lazy(self) -> object:
        """The DataFrame as a lazy query."""


PolarsTable = TypeVar("PolarsTable", bound=Polars)
"""A DataFrame of polars, for functions that return the type that they are given."""

if TYPE_CHECKING:
    Table: TypeAlias = pd.DataFrame
    """A table that a function returns: a DataFrame. If pandas is not installed, it is a list of dictionaries with the same names."""

    TableLike: TypeAlias = (
        pd.DataFrame | ArrowTable | InterchangeTable | Mapping[str, Iterable[object]] | Iterable[Mapping[str, object]]
    )
    """A table as an argument: a DataFrame of pandas, polars or another library, a dictionary of columns, or a list of dictionaries."""
else:
    # pandas takes long to import and may not be installed.
    Table = Any
    TableLike = ArrowTable | InterchangeTable | Mapping[str, Iterable[object]] | Iterable[Mapping[str, object]]
