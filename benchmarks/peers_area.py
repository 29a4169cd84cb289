"""The area errors of the comparison with other projects, drawn as `peers` draws the gap errors."""

from collections.abc import Sequence

import peers_drawing
import xarray as xr

from softlub.figures.panel import DataFigure


def measure(parts: Sequence[xr.Dataset]) -> xr.Dataset:
    """Times and errors of the joined dataset, without the sweep."""
    (joined,) = parts
    found = joined[["tolerance", "cpu_time", "area_error", "gap_error"]].drop_attrs()
    return found.assign_attrs(title="Rough contact: CPU time against errors of the area")


def draw(dataset: xr.Dataset) -> DataFigure:
    """Area error over CPU time."""
    return peers_drawing.work_precision(dataset, "area_error")
