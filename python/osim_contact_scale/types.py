"""Types for annotations: what the functions of this package take and give.

from osim_contact_scale.types import Source, Table

def softer(model: Source) -> Table:
    return ocs.design(model, indentation=0.1).changes
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Any, Protocol, TypeVar

from ._options import Property, Question

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

StrPath = str | os.PathLike[str]
"""The name of a file or folder."""

Progress = bool | Callable[[int, bool], object]
"""`True` for a bar where tqdm is there, `False` for none, or a function that is called with 1 and whether it failed, for each model."""


class LiveModel(Protocol):
    """An `opensim.Model`, by two of its methods: OpenSim's own package has no types."""

    def printToXML(self, path: str, /) -> Any:
        """Writes it to a file."""

    def getInputFileName(self) -> Any:
        """The file that it was read from."""


class ModelInMemory(Protocol):
    """A model without a file of its own, such as a `Result`: its new bytes, and the name of the old file."""

    @property
    def path(self) -> str:
        """The name of the file that it was made from."""

    def to_bytes(self) -> bytes:
        """The model."""


Source = str | os.PathLike[str] | bytes | bytearray | memoryview | ModelInMemory | LiveModel
"""A model: the name of its file, its bytes, a result of this package, or an `opensim.Model`."""

Sources = Source | Iterable[Source]
"""One model or several: paths, folders, bytes, results or live models."""


class ArrowTable(Protocol):
    """A table that other libraries can read by the interface of Arrow, such as a `pyarrow.Table`."""

    def __arrow_c_stream__(self, requested_schema: Any = None) -> object:
        """Its data."""


class InterchangeTable(Protocol):
    """A table that other libraries can read by the interchange protocol of DataFrames."""

    def __dataframe__(self, nan_as_null: bool = False, allow_copy: bool = True) -> Any:
        """Its data."""


class Polars(Protocol):
    """A DataFrame of polars, by a method that those of other libraries have not."""

    def lazy(self) -> object:
        """The same, to be calculated later."""


PolarsTable = TypeVar("PolarsTable", bound=Polars)
"""A DataFrame of polars that comes in and goes out."""

if TYPE_CHECKING:
    Table: TypeAlias = pd.DataFrame
    """A table that goes out: a DataFrame. Where pandas is not installed, it is a list of dictionaries with the same names."""

    TableLike: TypeAlias = (
        pd.DataFrame | ArrowTable | InterchangeTable | Mapping[str, Iterable[object]] | Iterable[Mapping[str, object]]
    )
    """A table that comes in: a DataFrame of pandas, polars or another library, a dictionary of columns, or a list of dictionaries."""
else:
    # pandas takes long to import, and need not be there.
    Table = Any
    TableLike = ArrowTable | InterchangeTable | Mapping[str, Iterable[object]] | Iterable[Mapping[str, object]]
