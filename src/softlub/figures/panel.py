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
from softlub.figures.curves import doubtful, doubts
from softlub.figures.quantities import FloatArray, Quantity


class Series(NamedTuple):
    """One series as drawn, in SI, and what it means: y over x, or z over both for a map.

    NaN stands where a point failed or a map has no data; `flags` are those of its points, where they have any.
    """

    panel: str
    series: str
    x_quantity: Quantity
    y_quantity: Quantity
    x: FloatArray
    y: FloatArray
    z_quantity: Quantity | None = None
    z: FloatArray | None = None
    flags: np.ndarray | None = None


PALE: dict[str, Any] = {"linewidth": 0.6, "alpha": 0.45, "markeredgewidth": 0.4, "gid": "doubtful"}
"""Look of the part of a curve that should not be relied on."""


class DataFigure(Figure):
    """A matplotlib figure with the data it shows, in the order drawn.

    Attributes
    ----------
    series : list of Series
    notes : list of str
        Sentences that the caption needs to be understood, such as the speed and the load that were chosen.
    """

    def __init__(self, *arguments: Any, **options: Any) -> None:
        super().__init__(*arguments, **options)
        self.series: list[Series] = []
        self.notes: list[str] = []
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

    def line(
        self,
        series: str,
        x: ArrayLike,
        y: ArrayLike,
        label: str | None = None,
        flags: np.ndarray | None = None,
        **look: Any,
    ) -> Line2D:
        """Draw and record one series; what its flags cast doubt on is drawn thin and pale.

        Parameters
        ----------
        series : str
            Name in the legend unless `label` says otherwise, and, without marks of mathematical type, in the
            figure's data.
        x, y : array_like, shape (n,)
            In SI; NaN leaves a gap.
        label : str, optional
            Name in the legend; an empty one keeps the series out of it.
        flags : ndarray of int, shape (n,), optional
            Of every point.
        **look
            Of `matplotlib.lines.Line2D`.

        Returns
        -------
        matplotlib.lines.Line2D
        """
        x, y = np.asarray(x, dtype=float), np.asarray(y, dtype=float)
        self.record(Series(self.name, style.plain(series), self.x, self.y, x, y, flags=flags))
        legend = series if label is None else label
        variable = self.y.name
        in_doubt = doubtful(flags, variable) if flags is not None else np.zeros(x.shape, dtype=bool)
        sound = np.where(in_doubt, np.nan, y)
        (line,) = self.axes.plot(self.x.shown(x), self.y.shown(sound), label=legend or "_", **look)
        if flags is not None and (in_doubt & np.isfinite(y)).any():
            reasons = doubts(flags, variable)
            self._draw_doubtful(x, np.where(_with_neighbours(in_doubt), y, np.nan), reasons, look)
        if legend:
            self.handles.append(line)
        return line

    def _draw_doubtful(
        self, x: FloatArray, y: FloatArray, reasons: Sequence[str], look: dict[str, Any]
    ) -> None:
        """The doubtful part of a curve, up to the sound points beside it; each reason stands in the legend."""
        self.axes.plot(self.x.shown(x), self.y.shown(y), label="_", **look | PALE)
        for reason in reasons:
            self._explain(Line2D([], [], color=style.BLACK, label=f"thin: {reason}", **PALE))

    def _explain(self, handle: Line2D) -> None:
        if not any(known.get_label() == handle.get_label() for known in self.handles):
            self.handles.append(handle)

    def explain_doubts_of(self, other: Panel) -> None:
        """Say in this panel's legend what looks doubtful in another, which has none."""
        for handle in other.handles:
            if handle.get_gid() == "doubtful":
                self._explain(handle)

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
    """Curves before what the looks of their points mean."""
    return sorted(handles, key=lambda handle: handle.get_gid() in ("doubtful", "failed"))


def _with_neighbours(marked: np.ndarray) -> np.ndarray:
    """The points marked and those beside them, so that lines drawn apart meet."""
    wide = marked.copy()
    wide[1:] |= marked[:-1]
    wide[:-1] |= marked[1:]
    return wide


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


MOST_INSIDE = 4
"""Entries of a legend that find room between the curves."""
ROW = 0.15
"""Height of a row of a legend [inch]."""
SAMPLE, LETTER = 0.5, 0.056
"""Width of an entry's line with the blanks around it, and of a letter [inch]."""


def place_legend(figure: DataFigure, panel: Panel, **options: Any) -> None:
    """The panel's legend inside it, or below all panels where it has too many entries; the figure grows by it.

    Parameters
    ----------
    figure : DataFigure
    panel : Panel
    **options
        Of a legend inside.
    """
    if len(panel.handles) <= MOST_INSIDE:
        panel.legend(**options)
        return
    longest = max(len(style.plain(str(handle.get_label()))) for handle in panel.handles)
    columns = int(np.clip(figure.get_figwidth() // (SAMPLE + LETTER * longest), 1, 4))
    figure.set_figheight(figure.get_figheight() + ROW * -(-len(panel.handles) // columns))
    share_legend(figure, [panel], columns)


def share_legend(figure: DataFigure, panels: Sequence[Panel], columns: int) -> None:
    """One legend below all panels; equal names appear once."""
    every = [handle for panel in panels for handle in panel.handles]
    handles = {handle.get_label(): handle for handle in _failed_last(every)}
    if handles:
        figure.legend(handles=list(handles.values()), loc="outside lower center", ncols=columns)
