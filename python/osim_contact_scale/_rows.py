"""Reads tables of all supported kinds, and writes them as CSV for the Rust half."""

from __future__ import annotations

import importlib.util
import numbers
import os
import re
import warnings
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

from ._cells import is_control_character, to_cell
from ._errors import RequestError
from ._keywords import expand_home
from ._kinds import kind_of
from ._option_names import PATHS, ROW_OPTIONS
from ._text import printable


def to_rows(data: Any) -> list[dict[str, Any]]:
    """The rows of a DataFrame, a dictionary of columns, or a list of dictionaries.

    Raises
    ------
    TypeError
        It is not a table.
    RequestError
        Two columns have one name.
    """
    data = to_known_table(data)
    kind = type(data).__name__
    if kind in ("DataArray", "Dataset") and hasattr(data, "to_dataframe"):
        raise TypeError(f"expected a table, not {kind}: to_dataframe() makes a table of it")
    if hasattr(data, "read"):
        raise TypeError(f"expected a table, not {kind}: give the path of the file, or read it, as by pandas.read_csv")
    if hasattr(data, "to_dict") and hasattr(data, "columns"):
        _refuse_same_names([str(name) for name in data.columns])
        rows = data.to_dicts() if hasattr(data, "to_dicts") else data.to_dict("records")
    elif isinstance(data, Mapping):
        columns = {name: _column_values(name, values) for name, values in data.items()}
        count = max((len(column) for column in columns.values()), default=0)
        if any(len(column) != count for column in columns.values()):
            raise ValueError("the columns of this table are not equally long")
        rows = [{name: column[index] for name, column in columns.items()} for index in range(count)]
    elif isinstance(data, Iterable) and not isinstance(data, (str, bytes, os.PathLike)):
        rows = list(data)
        if not all(isinstance(row, Mapping) for row in rows):
            raise TypeError("expected a DataFrame, a dictionary of columns or a list of dictionaries")
    else:
        raise TypeError(f"expected a table, not {type(data).__name__}")
    for row in rows:
        _refuse_same_names([str(name) for name in row])
    return [{str(key): value for key, value in row.items()} for row in rows]


def row_names(source: Any, count: int) -> list[str]:
    """The rows of a table as messages name them: by the label of a DataFrame's index, and by their position from 0."""
    names = [f"row {position}" for position in range(count)]
    index = getattr(source, "index", None) if kind_of(source) is not None else None
    if index is None or list(index) == list(range(count)):
        return names
    return [f"{printable(str(label))} ({name})" for label, name in zip(index, names)]


def to_known_table(data: Any) -> Any:
    """Converts a table of a library other than pandas and polars to a DataFrame of pandas; everything else is returned unchanged.

    Raises
    ------
    TypeError
        pandas is not installed, or the table has no rows yet.
    """
    if not _is_foreign(data):
        if hasattr(type(data), "collect") and hasattr(type(data), "columns"):
            raise TypeError(f"a {type(data).__name__} has no rows yet: collect() makes a table of it")
        return data
    missing = [name for name in _reading_libraries(data) if importlib.util.find_spec(name) is None]
    if missing:
        kind = f"{type(data).__module__.split('.')[0]}.{type(data).__name__}"
        needed = " and ".join(missing)
        raise TypeError(
            f"a {kind} is read by {needed}, not installed here: give a list of dictionaries, or install {needed}"
        )
    if hasattr(data, "__arrow_c_stream__"):
        import pyarrow

        return pyarrow.table(data).to_pandas()
    import pandas as pd

    with warnings.catch_warnings():
        # pandas warns that Arrow should be used, but the library of this table does not have it.
        warnings.simplefilter("ignore")
        return pd.api.interchange.from_dataframe(data)


def _reading_libraries(data: Any) -> tuple[str, ...]:
    """The libraries that read a table of another library."""
    return ("pandas", "pyarrow") if hasattr(data, "__arrow_c_stream__") else ("pandas",)


def _is_foreign(data: Any) -> bool:
    """Whether the data are a table of a library other than pandas and polars."""
    # A column also has the interface of Arrow, and a type, which a table does not have.
    is_arrow = hasattr(data, "__arrow_c_stream__") and not (hasattr(data, "dtype") or hasattr(data, "type"))
    can_be_read = is_arrow or hasattr(data, "__dataframe__")
    return can_be_read and not (hasattr(data, "to_dict") and hasattr(data, "columns"))


def _column_values(name: Any, values: Any) -> list[Any]:
    if isinstance(values, (str, bytes, os.PathLike, Mapping)) or not isinstance(values, Iterable):
        raise TypeError(
            f"column {str(name)!r}: expected a list with a value for each row; a single row is a list with one dictionary"
        )
    return list(values)


def _refuse_same_names(names: Sequence[str]) -> None:
    if len(set(names)) < len(names):
        repeated = next(name for name in names if names.count(name) > 1)
        raise RequestError("usage", f"the column {repeated!r} appears twice, expected one")


def is_missing(value: Any) -> bool:
    """Whether a cell is empty."""
    # NaN, NaT and pandas.NA are not equal to themselves, or cannot be compared.
    try:
        return value is None or bool(value != value)
    except (TypeError, ValueError):
        return type(value).__name__ == "NAType"


def is_blank(row: Mapping[str, Any]) -> bool:
    """Whether all cells of a row are empty."""
    return all(map(is_missing, row.values()))


def to_csv(rows: Sequence[Mapping[str, Any]], value_to_text: Callable[[str, Any], str] | None = None) -> bytes:
    """Rows as CSV that Rust reads: numbers with all digits, one line for each row.

    `value_to_text` converts a value in the column of a name. Missing values are empty cells; a column without values is left out.

    Raises
    ------
    RequestError
        A table cannot hold a name or a value.
    TypeError
        A value is neither a number nor a text.
    """
    import csv
    import io

    names: dict[str, None] = {}
    for row in rows:
        names.update(dict.fromkeys(name for name, value in row.items() if not is_missing(value)))
    for name in names:
        # Rust finds the separator in the first line, so that names must not contain these characters.
        if any(letter in ";\t" or is_control_character(letter) for letter in name):
            raise RequestError(
                "usage", f"the column {name!r}: its name must not contain a semicolon, a tab or a line end"
            )
    text = io.StringIO()
    # All cells are quoted, so that no content of a cell is read as a separator.
    writer = csv.writer(text, lineterminator="\n", quoting=csv.QUOTE_ALL)
    writer.writerow(names)
    # Rows are counted as in a spreadsheet, and as Rust does: the names of the columns are row 1.
    for number, row in enumerate(rows, 2):
        cells = []
        for name in names:
            value = row.get(name)
            try:
                cells.append("" if is_missing(value) else to_cell((value_to_text or _plain_text)(name, value)))
            except (RequestError, TypeError) as error:
                message = f"table: row {number}, column {name!r}: {error}"
                raise (
                    RequestError("usage", message) if isinstance(error, RequestError) else TypeError(message)
                ) from None
        writer.writerow(cells)
    try:
        return text.getvalue().encode("utf-8")
    except UnicodeEncodeError:
        raise RequestError("usage", "a table takes texts in Unicode only: this one has other bytes in a name") from None


def to_storage(data: Any, what: str) -> bytes:
    """A table over time as a `.sto` file of OpenSim: a column `time`, and numbers in rad, m and N.

    If the index of a DataFrame is called `time`, it becomes that column.

    Raises
    ------
    RequestError
        There is no column `time`, or a cell is not a number.
    """
    if hasattr(data, "reset_index") and getattr(getattr(data, "index", None), "name", None) == "time":
        data = data.reset_index()
    rows = to_rows(data)
    names = list(rows[0]) if rows else []
    if "time" not in names:
        raise RequestError(
            "usage", f"{what}: a table over time has a column 'time', and one of these: {', '.join(names)}"
        )
    names = ["time", *(name for name in names if name != "time")]
    lines = ["version=1", "inDegrees=no", "endheader", "\t".join(names)]
    for number, row in enumerate(rows):
        try:
            lines.append("\t".join(repr(float(row[name])) for name in names))
        except (TypeError, ValueError, KeyError):
            raise RequestError("usage", f"{what}: row {number} has a cell that is not a number") from None
    return "\n".join(lines).encode("utf-8")


def _plain_text(name: str, value: Any) -> str:
    return value_text(value)


def value_text(value: Any) -> str:
    """A number or a text as the text of a cell.

    Whole numbers have no decimal point: if a column has a gap, pandas makes floats of 1 and True, and both become `1` here. A number
    with three decimals gets a fourth one, because `1.125` may be 1125 in tables of some countries.

    Raises
    ------
    TypeError
        The value is neither a number nor a text.
    """
    if hasattr(value, "tolist"):  # NumPy's numbers.
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float):
        if value.is_integer() and abs(value) < 1e15:
            return str(int(value))
        text = repr(value)
        return text + "0" if re.fullmatch(r"-?\d{1,3}\.\d{3}", text) else text
    if isinstance(value, (str, numbers.Number)):
        return str(value)
    if isinstance(value, os.PathLike):
        return os.fsdecode(value)
    raise TypeError(f"expected a number or a text, not {type(value).__name__}")


#: Separators of the items of a list in the cells of these columns; all others have a semicolon (docs/libraries.md).
_SEPARATORS = {"only": ",", "keep": ",", "set": " "}


def models_csv(rows: Sequence[Mapping[str, Any]]) -> bytes:
    """Rows of a table of models as CSV. Its columns may be written like keywords: `from_` is `from`.

    Raises
    ------
    RequestError
        A table cannot hold a name or a value.
    TypeError
        A value has a type that tables do not have.
    """
    renamed = []
    for row in rows:
        names = [name if name.startswith("#") else name.rstrip("_") for name in row]
        _refuse_same_names(names)
        renamed.append(dict(zip(names, row.values())))
    return to_csv(renamed, _text_in_column)


def column_option(name: str) -> str:
    """The option that has the name of a column, which may be written as in the command or like a keyword."""
    return name.strip().rstrip("_").lower().replace("-", "_").lstrip("_")


def _text_in_column(name: str, value: Any) -> str:
    """The text of a cell in a table of models."""
    field = column_option(name)
    if field not in ROW_OPTIONS:
        # The column is the user's own, or Rust refuses it by its name.
        return str(value)
    if field in PATHS:
        return _path_in_cell(value)
    if isinstance(value, Mapping):
        return _join_items([_assignment(key, item) for key, item in value.items()], _SEPARATORS.get(field, ";"))
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, (list, tuple, set, frozenset)):
        return _join_items([_item_text(item) for item in value], _SEPARATORS.get(field, ";"))
    return value_text(value)


def _path_in_cell(value: Any) -> str:
    if not isinstance(value, (str, os.PathLike)):
        raise TypeError(f"a table takes paths of files, not {type(value).__name__}: write it to a file first")
    path = expand_home(value)
    if path != path.strip():
        raise RequestError("usage", f"{path!r}: a path in a table must not begin or end with a blank")
    return path


def _item_text(value: Any) -> str:
    if is_missing(value):
        raise RequestError("usage", "an item of the list is missing")
    return value_text(value)


def _assignment(name: Any, value: Any) -> str:
    """`BODY=f`, or `BODY=x,y,z` if the value is a list."""
    if "=" in str(name):
        raise RequestError("usage", f"{name!r}: a name in a table must not contain =")
    if hasattr(value, "tolist"):
        value = value.tolist()
    items = value if isinstance(value, (list, tuple)) else [value]
    return f"{name}={_join_items([_item_text(item) for item in items], ',')}"


def _join_items(items: Sequence[str], separator: str) -> str:
    """A text of items from which Rust can read each item again.

    Raises
    ------
    RequestError
        An item contains the separator, or begins or ends with a blank.
    """
    for item in items:
        if separator in item or not item or item != item.strip():
            message = "an item of a list in a table must not be empty, begin or end with a blank, or contain"
            raise RequestError("usage", f"{item!r}: {message} {separator!r}")
    return separator.join(items)
