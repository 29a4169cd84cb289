"""Figures of the comparison with other projects: work against precision, and CPU time at equal errors."""

from textwrap import wrap

import numpy as np
import xarray as xr
from contact_errors import LARGEST_AREA_ERROR, LARGEST_GAP_ERROR, meets
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.ticker import LogLocator, NullFormatter

from softlub.figures import style
from softlub.figures.panel import DataFigure, Panel, new_figure, share_legend, styled
from softlub.figures.quantities import Quantity, quantity

LOOKS = {
    "softlub": (style.BLUE, "o", "-"),
    "Polonsky–Keer (softlub)": (style.SKY, "s", "--"),
    "ASPHER": (style.VERMILION, "^", "-"),
    "ASPHER, native build": (style.ORANGE, "v", "--"),
    "tamaas, system's FFTW": (style.GREEN, "D", "-"),
    "tamaas, wheel": (style.BLACK, "P", "--"),
    "ContactMechanics": (style.PURPLE, "X", "-"),
}
"""Colour, marker and line of each solver: told apart without colour too."""
DRAWN_LOADS = (1.0, 0.05, 1e-3)
LIMITS = {"gap_error": LARGEST_GAP_ERROR, "area_error": LARGEST_AREA_ERROR}
LABELS = {"gap_error": r"gap error / $h_\mathrm{rms}$", "area_error": r"error of $A/A_0$"}
SCALES = {
    "gap_error": {"value": "log"},
    "area_error": {"value": "symlog", "linthresh": 5e-8, "linscale": 0.4},
}
"""Areas may be without any error; a single point of 4096² is 6e-8."""
ONE_LOAD = 0.05


def work_precision(dataset: xr.Dataset, error: str) -> DataFigure:
    """An error over CPU time: a row a load, a column a grid; runs that miss either limit are hollow."""
    with styled():
        figure = new_figure(style.PAGE, 5.2)
        sizes = dataset["points"].values.tolist()
        axes = figure.subplots(len(DRAWN_LOADS), len(sizes), sharex="col", sharey=True, squeeze=False)
        panels = [
            _errors_panel(axes[row, column], dataset.sel(load=load, points=points), error, (load, points))
            for row, load in enumerate(DRAWN_LOADS)
            for column, points in enumerate(sizes)
        ]
        _label_outside(axes, sizes)
        for column, points in enumerate(sizes):
            _set_time_limits(axes[0, column], dataset["cpu_time"].sel(points=points, load=list(DRAWN_LOADS)))
        _explain(panels[0])
        share_legend(figure, panels, 4)
        figure.notes.append(_not_run(dataset))
        figure.legends[0].set_title("\n".join(wrap(figure.notes[0], 150)), {"size": 5.5})
        return figure


def one_grid(dataset: xr.Dataset, error: str) -> DataFigure:
    """The same for a single grid, a panel a load."""
    with styled():
        figure = new_figure(style.PAGE, 2.7)
        axes = figure.subplots(1, len(DRAWN_LOADS), sharey=True)
        (points,) = dataset["points"].values.tolist()
        panels = []
        for axis, load in zip(axes, DRAWN_LOADS, strict=True):
            runs = dataset.sel(load=load, points=points)
            panels.append(_errors_panel(axis, runs, error, (load, points)))
            axis.set_title(rf"$N$ = {points}, $p$ = {style.power(load)} $E^* h'_\mathrm{{rms}}$", fontsize=7)
            _set_time_limits(axis, runs["cpu_time"])
        for axis in axes[1:]:
            axis.set_ylabel("")
        _explain(panels[0])
        share_legend(figure, panels, 5)
        return figure


def _label_outside(axes: np.ndarray, sizes: list[int]) -> None:
    """Grids above the columns, loads beside the rows, and axis labels on the outer panels only."""
    for axis, points in zip(axes[0], sizes, strict=True):
        axis.set_title(f"$N$ = {points}", fontsize=7)
    for axis, load in zip(axes[:, -1], DRAWN_LOADS, strict=True):
        axis.annotate(
            rf"$p$ = {style.power(load)} $E^* h'_\mathrm{{rms}}$",
            (1.06, 0.5),
            xycoords="axes fraction",
            rotation=-90,
            va="center",
            fontsize=7,
        )
    for axis in axes[:-1].flat:
        axis.set_xlabel("")
    for axis in axes[:, 1:].flat:
        axis.set_ylabel("")


def _set_time_limits(axes: Axes, seconds: xr.DataArray) -> None:
    """Limits of the time axis around all its points, wide enough for the labels of two powers of ten."""
    exponents = np.log10(seconds.values[np.isfinite(seconds.values)])
    lower, upper = exponents.min() - 0.25, exponents.max() + 0.25
    if np.floor(upper) <= np.ceil(lower):
        if lower - np.floor(lower) < np.ceil(upper) - upper:
            lower = np.floor(lower)
        else:
            upper = np.ceil(upper)
    axes.set_xlim(10.0**lower, 10.0**upper)
    axes.xaxis.set_major_locator(LogLocator(numticks=12))
    axes.xaxis.set_minor_formatter(NullFormatter())


def _errors_panel(axes: Axes, runs: xr.Dataset, error: str, case: tuple[float, int]) -> Panel:
    load, points = case
    seconds = quantity("cpu_time", label="CPU time", unit="s")
    name = f"N = {points}, p = {load:g} E* h'_rms"
    panel = Panel(axes, seconds, quantity(error, label=LABELS[error], unit="1"), name)
    axes.set_xscale("log")
    axes.set_yscale(**SCALES[error])
    if error == "area_error":
        axes.set_yticks([0, *(10.0**power for power in range(-7, -2))])
    axes.axhline(LIMITS[error], color=style.GREY, linewidth=0.6, linestyle=(0, (2, 2)))
    for solver in runs["solver"].values.tolist():
        run = runs.sel(solver=solver)
        drawn = np.isfinite(run["cpu_time"].values)
        if drawn.any():
            within = meets(run["area_error"], run["gap_error"]).values[drawn]
            _points(panel, solver, run["cpu_time"].values[drawn], run[error].values[drawn], within)
    return panel


def _points(panel: Panel, solver: str, x: np.ndarray, y: np.ndarray, within: np.ndarray) -> None:
    """One solver's line; its markers are filled where both limits are kept."""
    colour, marker, line = LOOKS[solver]
    look = {"color": colour, "marker": marker, "linestyle": line, "markersize": 3.2, "linewidth": 0.9}
    panel.line(solver, x, y, **look)
    missed = ~within
    panel.axes.plot(
        panel.x.shown(x[missed]),
        panel.y.shown(y[missed]),
        linestyle="none",
        marker=marker,
        markersize=3.2,
        color=colour,
        markerfacecolor="white",
        markeredgewidth=0.7,
        zorder=3,
        label="_",
    )


def _explain(panel: Panel) -> None:
    """What hollow markers and the dashed line mean, for the legend."""
    panel.handles.append(
        Line2D(
            [],
            [],
            linestyle="none",
            marker="o",
            markersize=3.2,
            color=style.BLACK,
            markerfacecolor="white",
            label="hollow: misses a limit",
        )
    )
    panel.handles.append(
        Line2D([], [], color=style.GREY, linewidth=0.6, linestyle=(0, (2, 2)), label="limit")
    )


def _not_run(dataset: xr.Dataset) -> str:
    """Which solver was left out on which grids and loads."""
    run = dataset["cpu_time"].notnull().any("step")
    wanted = run.any("solver")
    left_out = []
    for solver in dataset["solver"].values.tolist():
        here = run.sel(solver=solver)
        somewhere = dataset["points"].values[here.any("load").values]
        everywhere = dataset["points"].values[(here == wanted).all("load").values]
        if everywhere.size == dataset.sizes["points"]:
            continue
        partly = f", beyond {everywhere.max()} only at one load" if somewhere.max() > everywhere.max() else ""
        beyond = f"beyond N = {somewhere.max()}" if somewhere.max() < dataset["points"].max() else ""
        left_out.append(f"{solver} {beyond}{partly}".replace(" , ", " "))
    return (
        f"Not run, for their time: {'; '.join(left_out)}." if left_out else "Every solver was run everywhere."
    )


def equal_errors(dataset: xr.Dataset) -> DataFigure:
    """CPU time of the quickest run within the limits and its convolutions, over the load and over the grid."""
    with styled():
        figure = new_figure(style.PAGE, 4.8)
        axes = figure.subplots(2, 2, sharex="col", sharey="row")
        load = quantity("load", label=r"$p / (E^* h'_\mathrm{rms})$", unit="1")
        points = quantity("points", label=r"points a side $N$", unit="1")
        seconds = quantity("cpu_time", label="CPU time", unit="s")
        convolutions = quantity("convolutions", label="convolutions", unit="1")
        size = dataset.attrs["sweep_points"]
        over_load = dataset.sel(points=size)
        over_points = dataset.sel(load=ONE_LOAD)
        panels = [
            _quickest_panel(axes[0, 0], over_load, load, seconds, "a"),
            _quickest_panel(axes[0, 1], over_points, points, seconds, "b"),
            _quickest_panel(axes[1, 0], over_load, load, convolutions, "c"),
            _quickest_panel(axes[1, 1], over_points, points, convolutions, "d"),
        ]
        sizes = dataset["points"].values
        axes[1, 1].set_xticks(sizes, [str(size) for size in sizes])
        axes[1, 1].minorticks_off()
        for axis in (axes[0, 0], axes[0, 1]):
            axis.set_xlabel("")
        for axis in (axes[0, 1], axes[1, 1]):
            axis.set_ylabel("")
        share_legend(figure, panels, 4)
        figure.notes.append(
            f"(a, c): {size}² points; (b, d): p/(E*h'rms) = {ONE_LOAD:g}. Area within "
            f"{LARGEST_AREA_ERROR:g}, gap within {LARGEST_GAP_ERROR:g} h_rms."
        )
        return figure


def _quickest_panel(axes: Axes, runs: xr.Dataset, x: Quantity, y: Quantity, letter: str) -> Panel:
    panel = Panel(axes, x, y, letter)
    panel.letter(letter)
    axes.set_xscale("log")
    axes.set_yscale("log")
    for solver in runs["solver"].values.tolist():
        colour, marker, line = LOOKS[solver]
        values = runs[y.name].sel(solver=solver).values
        drawn = np.isfinite(values)
        if drawn.any():
            panel.line(
                solver, runs[x.name].values[drawn], values[drawn], color=colour, marker=marker, linestyle=line
            )
    return panel
