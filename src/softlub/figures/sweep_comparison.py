"""One contact by two sweeps (figure 3-12): profiles at one speed; sweeps, time and residual over speed."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.lines import Line2D

from softlub.figures import fields, style
from softlub.figures.curves import Curve, curves
from softlub.figures.looks import refuse_many
from softlub.figures.module_comparison import MODULE_LOOKS, NEWTON_LOOK, draw_profile
from softlub.figures.panel import DataFigure, Panel, new_figure, styled
from softlub.figures.profiles import field_handles, field_panels
from softlub.figures.quantities import Quantity, quantity

EFFORT = ("iterations", "solver_seconds", "residual")
COLOURS = (style.BLACK, style.PURPLE, style.ORANGE, style.SKY)
"""Of the solvers over speed; the three fields of the profiles have taken blue, green and red."""


def draw(
    dataset: xr.Dataset, speed: float | None = None, load: float | None = None, height: float = 4.6
) -> DataFigure:
    """Draw profiles by each solver (a), and what each needs over speed (b–d); failed points as crosses.

    Parameters
    ----------
    dataset : xarray.Dataset
        With dimension solver and fields over nodes.
    speed : float, optional
        Of the profiles [m/s].
    load : float, optional
        [N/m]; of a dataset with several loads the closest is taken, the middle one by default.
    height : float
        Of the figure [inch].

    Returns
    -------
    DataFigure
    """
    at = fields.where(dataset, speed, load)
    drawn = fields.profiles(dataset, at, "solver")
    with styled():
        figure = new_figure(style.PAGE, height)
        figure.notes += [at.sentence, style.SOLVERS_EXPLAINED]
        axes = figure.subplot_mosaic([["a", "b"], ["a", "c"], ["a", "d"]], width_ratios=[1.25, 1])
        pressure, separation = field_panels(axes["a"], drawn)
        looks = _profile_looks(drawn)
        for profile, look in zip(drawn, looks, strict=True):
            draw_profile(pressure, separation, profile, look)
        pressure.letter("a")
        pressure.axes.set_title(at.title, loc="right")
        swept = [curve for curve in curves(dataset.sel(load=[at.load])) if _is_module(curve)]
        for letter, variable in zip("bcd", EFFORT, strict=True):
            panel = Panel(axes[letter], quantity("speed"), _axis(variable, dataset), letter)
            panel.letter(letter)
            panel.axes.set_xscale("log")
            panel.axes.set_yscale("log")
            for curve in swept:
                _draw_effort(panel, curve, variable)
            if variable != EFFORT[-1]:
                panel.axes.set_xlabel("")
                panel.axes.tick_params(labelbottom=False)
        _legend(figure, drawn, looks, swept)
        return figure


def _is_module(curve: Curve) -> bool:
    return style.solver_of(str(curve.data["solver"].values)) not in style.NEWTON_SOLVERS


def _axis(variable: str, dataset: xr.Dataset) -> Quantity:
    labels = {"iterations": "sweeps", "solver_seconds": "CPU time", "residual": "last residual"}
    # Seconds on a logarithmic axis need no prefix.
    return quantity(variable, label=labels[variable])


def _draw_effort(panel: Panel, curve: Curve, variable: str) -> None:
    """A solver's effort at every speed attempted; the points that failed carry a cross instead of a marker."""
    speed = curve.data["speed"].values
    effort = np.asarray(curve.data[variable].values, dtype=float)
    converged = curve.data["converged"].values.astype(bool)
    look = _look(curve)
    panel.line(curve.label, speed, np.where(converged, effort, np.nan), "", curve.flags, **look)
    if curve.failed.any():
        name = f"{curve.label}, did not converge"
        failed = np.where(curve.failed, effort, np.nan)
        crosses = look | {"marker": style.FAILED_MARKER, "markersize": 6}
        panel.line(name, speed, failed, "", curve.flags, gid="failed", **crosses)


def _look(curve: Curve) -> dict[str, Any]:
    return {
        "color": COLOURS[curve.position % len(COLOURS)],
        "marker": style.MARKERS[curve.position % len(style.MARKERS)],
        "linestyle": style.LINE_STYLES[curve.position % len(style.LINE_STYLES)],
        "linewidth": 0.8,
    }


def _profile_looks(drawn: list[fields.Profile]) -> list[dict[str, Any]]:
    """The Newton solution as a broad band, the others as dashes, circles, dots."""
    newton = [profile for profile in drawn if style.solver_of(profile.solver) in style.NEWTON_SOLVERS][:1]
    refuse_many("sweep_comparison", len(drawn), len(newton) + len(MODULE_LOOKS))
    others = iter(MODULE_LOOKS)
    return [NEWTON_LOOK if any(profile is one for one in newton) else next(others) for profile in drawn]


def _legend(
    figure: DataFigure, drawn: list[fields.Profile], looks: list[dict[str, Any]], swept: list[Curve]
) -> None:
    """Fields by colour, profiles of (a) by look, sweeps of (b–d) by colour and marker."""
    handles = field_handles()
    for profile, look in zip(drawn, looks, strict=True):
        ending = "" if profile.converged else ", last iterate"
        handles.append(Line2D([], [], color=style.BLACK, label=f"(a) {profile.label}{ending}", **look))
    handles += [Line2D([], [], label=f"(b–d) {curve.label}", **_look(curve)) for curve in swept]
    if any(curve.failed.any() for curve in swept):
        handles.append(
            Line2D(
                [],
                [],
                color=style.BLACK,
                linestyle="none",
                marker=style.FAILED_MARKER,
                label="did not converge",
            )
        )
    figure.legend(handles=handles, loc="outside lower center", ncols=3)
