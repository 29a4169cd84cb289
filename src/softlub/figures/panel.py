"""A panel: axes that remember, in SI, every series drawn into them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from numpy.typing import ArrayLike

from softlub.figures import style
from softlub.figures.quantities import FloatArray, Quantity


class Series(NamedTuple):
    """One series as drawn, in SI, and what it means: y over x, or z over both for a map.

    NaN stands where a point failed or a map has no data.
    """

    panel: str
    series: str
    x_quantity: Quantity
    y_quantity: Quantity
    x: FloatArray
    y: FloatArray
    z_quantity: Quantity | None = None
    z: FloatArray | None = None


class DataFigure(Figure):
    """A matplotlib figure with the data it shows, in the order drawn.

    Attributes
    ----------
    series : list of Series
    """

    def __init__(self, *arguments: Any, **options: Any) -> None:
        super().__init__(*arguments, **options)
        self.series: list[Series] = []
        FigureCanvasAgg(self)


@dataclass
class Panel:
    """Axes with one quantity on each side.

    Parameters
    ----------
    axes : matplotlib.axes.Axes
    x, y : Quantity
    name : str
        Letter or word that names the panel in the figure's data.
    """

    axes: Axes
    x: Quantity
    y: Quantity
    name: str = ""
    handles: list[Line2D] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.axes.set_xlabel(self.x.axis_label)
        self.axes.set_ylabel(self.y.axis_label)

    def line(self, series: str, x: ArrayLike, y: ArrayLike, label: str | None = None, **look: Any) -> Line2D:
        """Draw and record one series.

        Parameters
        ----------
        series : str
            Name in the figure's data, and in the legend unless `label` says otherwise.
        x, y : array_like, shape (n,)
            In SI; NaN leaves a gap.
        label : str, optional
            Name in the legend; an empty one keeps the series out of it.
        **look
            Of `matplotlib.lines.Line2D`.

        Returns
        -------
        matplotlib.lines.Line2D
        """
        x, y = np.asarray(x, dtype=float), np.asarray(y, dtype=float)
        self.record(Series(self.name, series, self.x, self.y, x, y))
        legend = series if label is None else label
        (line,) = self.axes.plot(self.x.shown(x), self.y.shown(y), label=legend or "_", **look)
        if legend:
            self.handles.append(line)
        return line

    def record(self, series: Series) -> None:
        """Keep a series with the figure; `line` does so by itself."""
        figure = self.axes.get_figure()
        assert isinstance(figure, DataFigure)
        figure.series.append(series)

    def mark_failed(self, x: ArrayLike, colour: str = style.BLACK, row: int = 0) -> None:
        """Mark points that did not converge on the lower edge of the panel.

        Parameters
        ----------
        x : array_like
            Where they would stand [SI].
        colour : str
            Of the series they belong to.
        row : int
            Rows above the edge, so that marks of several series do not cover each other.
        """
        x = np.atleast_1d(np.asarray(x, dtype=float))
        if x.size == 0:
            return
        self.axes.plot(
            self.x.shown(x),
            np.full(x.shape, 0.035 + 0.05 * row),
            linestyle="none",
            marker=style.FAILED_MARKER,
            color=colour,
            label="_",
            gid="failed",
            clip_on=False,
            transform=self.axes.get_xaxis_transform(),
        )
        if not any(handle.get_gid() == "failed" for handle in self.handles):
            self.handles.append(
                Line2D(
                    [],
                    [],
                    linestyle="none",
                    marker=style.FAILED_MARKER,
                    color=style.BLACK,
                    label="did not converge",
                    gid="failed",
                )
            )

    def letter(self, text: str) -> None:
        """Put the panel's letter above its upper left corner."""
        self.axes.set_title(f"({text})", loc="left", fontweight="bold")

    def legend(self, **options: Any) -> None:
        """Legend of everything that was given a name."""
        if self.handles:
            self.axes.legend(handles=_failed_last(self.handles), **options)


def _failed_last(handles: Sequence[Line2D]) -> list[Line2D]:
    return sorted(handles, key=lambda handle: handle.get_gid() == "failed")


def new_figure(width: float, height: float) -> DataFigure:
    """An empty figure in the one style.

    Parameters
    ----------
    width, height : float
        Inches.

    Returns
    -------
    DataFigure
    """
    return DataFigure(figsize=(width, height), dpi=150, layout="constrained")


def styled() -> Any:
    """Context in which figures are made and saved: our settings, whatever the user's matplotlibrc says."""
    settings: dict[Any, Any] = {**matplotlib.rcParamsDefault, **style.RC, "backend": "agg"}
    return matplotlib.rc_context(settings)


def share_legend(figure: DataFigure, panels: Sequence[Panel], columns: int) -> None:
    """One legend below all panels; equal names appear once."""
    every = [handle for panel in panels for handle in panel.handles]
    handles = {handle.get_label(): handle for handle in _failed_last(every)}
    if handles:
        figure.legend(handles=list(handles.values()), loc="outside lower center", ncols=columns)
