"""Writing a figure: PDF, PNG and SVG that are the same on every run, and the data that it shows as CSV."""

from __future__ import annotations

import csv
import io
import os
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from softlub.datasets.variables import FLAGS
from softlub.figures.panel import DataFigure, Series, styled
from softlub.figures.quantities import Quantity

FORMATS = ("pdf", "png", "svg", "csv")
PNG_RESOLUTION = 200
"""Dots per inch: a page-wide figure fills a screen and no more."""

# Dates and the library's version would make equal figures differ.
METADATA: dict[str, dict[str, str | None]] = {
    "pdf": {"CreationDate": None, "Producer": None, "Creator": "softlub"},
    "png": {"Software": None},
    "svg": {"Date": None, "Creator": "softlub"},
}


def save(figure: DataFigure, paths: Sequence[str | os.PathLike[str]]) -> None:
    """Write a figure in the formats that the paths end in, each whole or not at all.

    Parameters
    ----------
    figure : DataFigure
    paths : sequence of path-like
        Ending in .pdf, .png, .svg or .csv (the data drawn).

    Raises
    ------
    ValueError
        If a path has another ending.
    """
    for path in map(Path, paths):
        kind = path.suffix.removeprefix(".")
        if kind not in FORMATS:
            raise ValueError(f"figures are written as {', '.join(FORMATS)}; {path} is none of them")
        content = table(figure).encode() if kind == "csv" else _image(figure, kind)
        _replace(path, content)


def _image(figure: DataFigure, kind: str) -> bytes:
    buffer = io.BytesIO()
    with styled():
        figure.savefig(buffer, format=kind, dpi=PNG_RESOLUTION, metadata=METADATA[kind])
    return buffer.getvalue()


def _replace(path: Path, content: bytes) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    partial = path.with_name(f".{path.name}.{os.getpid()}.part")
    try:
        partial.write_bytes(content)
        os.replace(partial, path)
    finally:
        partial.unlink(missing_ok=True)


def table(figure: DataFigure) -> str:
    """The data drawn as CSV in SI: panel, series, then one column a quantity with its unit in the header.

    Parameters
    ----------
    figure : DataFigure

    Returns
    -------
    str
        A row a point, in the order drawn; a column that does not concern a series is empty, a failed point NaN. A
        last column names the flags of each point, where any point has one.
    """
    columns: dict[str, None] = {}
    for series in figure.series:
        columns.update(dict.fromkeys(_header(quantity) for quantity, _ in _quantities(series)))
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    flagged = any(series.flags is not None and series.flags.any() for series in figure.series)
    writer.writerow(["panel", "series", *columns, *(["flags"] if flagged else [])])
    for series in figure.series:
        values = {_header(quantity): numbers for quantity, numbers in _quantities(series)}
        for i in range(series.x.size):
            cells = [f"{values[name][i]:.10g}" if name in values else "" for name in columns]
            writer.writerow([series.panel, series.series, *cells, *([_flags(series, i)] if flagged else [])])
    return text.getvalue()


def _flags(series: Series, i: int) -> str:
    """Names of the flags of a point, with blanks between them."""
    if series.flags is None:
        return ""
    return " ".join(name for name, bit in FLAGS.items() if int(series.flags[i]) & bit)


def _header(quantity: Quantity) -> str:
    return f"{quantity.name} [{quantity.unit}]"


def _quantities(series: Series) -> list[tuple[Quantity, np.ndarray]]:
    pairs = [(series.x_quantity, series.x), (series.y_quantity, series.y)]
    if series.z_quantity is not None and series.z is not None:
        pairs.append((series.z_quantity, series.z))
    return pairs
