"""Tables of measured numbers from CSV files, with units in the header.

A file holds lines ``# key: value`` and free comments ``# …``, a header ``name [unit],name [unit]`` and rows of
numbers with a decimal point, separated by commas.
"""

from __future__ import annotations

import csv
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]

Units = Mapping[str, float]
"""Units that a column may have, with their factor to SI."""

TIMES: Units = {"s": 1.0, "ms": 1e-3, "us": 1e-6, "µs": 1e-6, "ns": 1e-9}
PRESSURES: Units = {"Pa": 1.0, "kPa": 1e3, "MPa": 1e6, "GPa": 1e9}
ANGULAR_FREQUENCIES: Units = {"rad/s": 1.0, "Hz": 2 * np.pi, "kHz": 2e3 * np.pi, "MHz": 2e6 * np.pi}
NUMBERS: Units = {"1": 1.0}

_HEADING = re.compile(r"\s*([^\[\]]+?)\s*(?:\[\s*([^\[\]]*?)\s*\])?\s*")
_SETTING = re.compile(r"#\s*(\w+)\s*:\s*(.*?)\s*")
_COMMA = re.compile(r"\s*[+-]?[0-9]*,[0-9]+([eE][+-]?[0-9]+)?\s*")


@dataclass(frozen=True, eq=False)
class Table:
    """What a file holds.

    Parameters
    ----------
    settings : dict of str to str
        Of the lines ``# key: value``.
    columns : dict of str to ndarray, shape (rows,)
        In SI.
    """

    settings: dict[str, str]
    columns: dict[str, FloatArray]


def read_columns(path: str | Path, columns: Mapping[str, Units]) -> Table:
    """Read a CSV file that has certain columns and no others.

    Parameters
    ----------
    path : str or Path
    columns : mapping of str to mapping
        Name of each column and the units that it may have, with their factors to SI. A column of pure numbers needs
        no unit.

    Returns
    -------
    Table

    Raises
    ------
    ValueError
        If the file is no text, its columns are others, a unit is missing or unknown, an entry is no finite number,
        or there is no row. The message names the file and the line.
    FileNotFoundError
        If there is no such file.
    """
    path = Path(path)
    settings, rows = _split(path)
    number, heading = next(rows, (0, []))
    if not number:
        raise ValueError(f"{path}: the file is empty; it needs the header {_header(columns)}")
    headings = _headings(f"{path}, line {number}", heading, columns)
    values = [_numbers(f"{path}, line {line}", row, headings) for line, row in rows]
    if not values:
        raise ValueError(f"{path}: no rows below the header of line {number}")
    array = np.array(values, dtype=np.float64).T
    read = {name: column * columns[name][unit] for (name, unit), column in zip(headings, array, strict=True)}
    return Table(settings, read)


def _split(path: Path) -> tuple[dict[str, str], Iterator[tuple[int, list[str]]]]:
    """Settings, and the numbered lines that are neither comments nor empty."""
    if not path.is_file():
        raise FileNotFoundError(f"{path}: no such file")
    try:
        lines = path.read_text(encoding="utf-8-sig").splitlines()
    except UnicodeDecodeError:
        raise ValueError(f"{path}: is no text in UTF-8; save it as CSV in UTF-8") from None
    comments = [line.strip() for line in lines if line.lstrip().startswith("#")]
    matches = [match for match in map(_SETTING.fullmatch, comments) if match]
    rows = (
        (number, next(csv.reader([line])))
        for number, line in enumerate(lines, start=1)
        if line.strip() and not line.lstrip().startswith("#")
    )
    return {match[1]: match[2] for match in matches}, rows


def _headings(place: str, row: Sequence[str], columns: Mapping[str, Units]) -> list[tuple[str, str]]:
    """Name and unit of each column of the file."""
    wanted = f"the header must be {_header(columns)}, in any order"
    separator = next((sign for sign in (";", "\t") if len(row) == 1 and sign in row[0]), "")
    if separator:
        word = "semicolons" if separator == ";" else "tabs"
        raise ValueError(
            f"{place}: columns are separated by {word}; use commas and a decimal point; {wanted}"
        )
    found = []
    for entry in row:
        match = _HEADING.fullmatch(entry)
        name, unit = (match[1], match[2] or "") if match else (entry, "")
        if name not in columns:
            raise ValueError(f'{place}: the column "{name}" is unknown; {wanted}')
        if not unit and columns[name] is NUMBERS:
            unit = "1"
        if unit not in columns[name]:
            what = f'the unit "{unit}" of the column {name} is unknown' if unit else f"{name} has no unit"
            raise ValueError(
                f"{place}: {what}; allowed: {', '.join(columns[name])}, as {name} [{_first(columns[name])}]"
            )
        found.append((name, unit))
    names = [name for name, _ in found]
    missing = [name for name in columns if name not in names]
    if missing or len(names) != len(columns):
        problem = f"the column {missing[0]} is missing" if missing else "a column stands there twice"
        raise ValueError(f"{place}: {problem}; {wanted}")
    return found


def _numbers(place: str, row: Sequence[str], headings: Sequence[tuple[str, str]]) -> list[float]:
    if len(row) != len(headings):
        raise ValueError(
            f"{place}: {len(row)} entries below {len(headings)} columns; a decimal comma? numbers have a decimal "
            "point, and commas separate columns"
        )
    return [_number(place, entry, name) for entry, (name, _) in zip(row, headings, strict=True)]


def _number(place: str, entry: str, name: str) -> float:
    if _COMMA.fullmatch(entry):
        raise ValueError(f'{place}: {name} = "{entry}" has a decimal comma; numbers have a decimal point')
    try:
        value = float(entry)
    except ValueError:
        raise ValueError(f'{place}: {name} = "{entry}" is no number') from None
    if not np.isfinite(value):
        raise ValueError(
            f"{place}: {name} = {entry.strip()} is not finite; delete the row or measure it again"
        )
    return value


def _header(columns: Mapping[str, Units]) -> str:
    return ",".join(f"{name} [{_first(units)}]" for name, units in columns.items())


def _first(units: Units) -> str:
    return next(iter(units))
