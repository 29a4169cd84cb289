"""Two modules at one speed over the Newton solution (figures 3-13 and 3-14): pressures (a), separation (b)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import xarray as xr
from matplotlib.lines import Line2D

from softlub.figures import fields, style
from softlub.figures.panel import DataFigure, Panel, new_figure, styled
from softlub.figures.profiles import field_handles
from softlub.figures.quantities import quantity

NEWTON_LOOK: dict[str, Any] = {"linestyle": "-", "linewidth": 3.5, "alpha": 0.35, "zorder": 1}
MODULE_LOOKS: tuple[dict[str, Any], ...] = (
    {"linestyle": "--", "zorder": 2},
    {"linestyle": "none", "marker": "o", "markevery": 0.05, "markerfacecolor": "none", "zorder": 3},
    {"linestyle": ":", "zorder": 2},
)
"""Curves that agree lie on each other: a broad band, dashes and sparse circles stay visible all the same."""


def draw(
    dataset: xr.Dataset,
    speed: float | None = None,
    load: float | None = None,
    solvers: Sequence[str] | None = None,
    height: float = 3.0,
) -> DataFigure:
    """Draw the fields of each module as lines over the Newton solution's broad bands.

    A module that did not converge is drawn by its last iterate, and the figure says so with its residual.

    Parameters
    ----------
    dataset : xarray.Dataset
        With dimension solver and fields over nodes; the last iterates of failed points are kept there.
    speed : float, optional
        [m/s]; the dataset's closest is taken.
    load : float, optional
        [N/m]; of a dataset with several loads the closest is taken, the middle one by default.
    solvers : sequence of str, optional
        First words of the solvers' labels to be drawn, besides the Newton solution; by default the first three.
    height : float
        Of the figure [inch].

    Returns
    -------
    DataFigure
    """
    at = fields.where(dataset, speed, load)
    everyone = [p for p in fields.profiles(dataset, at, "solver") if p.x.size]
    newton = [p for p in everyone if style.solver_of(p.solver) in style.NEWTON_SOLVERS][:1]
    modules = [p for p in everyone if _wanted(p, solvers)]
    drawn = newton + modules
    with styled():
        figure = new_figure(style.PAGE, height)
        figure.notes += [at.sentence, style.SOLVERS_EXPLAINED]
        left, right = figure.subplots(1, 2)
        window = fields.contact_window(newton or drawn)
        position = quantity("x", max(abs(window[0]), abs(window[1])))
        film = fields.separation_limit(newton or drawn, window)
        pressure = Panel(left, position, fields.pressure_axis(newton or drawn), "a")
        separation = Panel(right, position, quantity("separation", film), "b")
        for panel in (pressure, separation):
            panel.letter(panel.name)
            panel.axes.set_xlim(*position.shown(window))
        separation.axes.set_ylim(0.0, float(separation.y.shown(film)))
        separation.axes.set_title(at.title, loc="right")
        for profile in newton:
            draw_profile(pressure, separation, profile, NEWTON_LOOK)
        for profile, look in zip(modules, MODULE_LOOKS, strict=False):
            draw_profile(pressure, separation, profile, look)
        _legend(figure, newton, modules)
        return figure


def _wanted(profile: fields.Profile, solvers: Sequence[str] | None) -> bool:
    name = style.solver_of(profile.solver)
    return name not in style.NEWTON_SOLVERS and (solvers is None or name in solvers)


def draw_profile(pressure: Panel, separation: Panel, profile: fields.Profile, look: dict[str, Any]) -> None:
    """The three fields of one profile in one look."""
    name = profile.label
    pressure.line(f"fluid pressure, {name}", profile.x, profile.fluid_pressure, "", color=style.FLUID, **look)
    pressure.line(
        f"asperity pressure, {name}", profile.x, profile.solid_pressure, "", color=style.SOLID, **look
    )
    separation.line(f"separation, {name}", profile.x, profile.separation, "", color=style.SEPARATION, **look)


def state(profile: fields.Profile) -> str:
    """What became of a module, in words: ``"BML: last iterate, residual 0.03 after 20000 sweeps"``."""
    if profile.converged:
        return f"{profile.label}: converged in {profile.iterations:.0f} sweeps"
    return (
        f"{profile.label}: NOT CONVERGED, last iterate, residual {profile.residual:.1e} "
        f"after {profile.iterations:.0f} sweeps"
    )


def _legend(figure: DataFigure, newton: list[fields.Profile], modules: list[fields.Profile]) -> None:
    handles = field_handles()
    handles += [Line2D([], [], color=style.BLACK, label=p.label, **NEWTON_LOOK) for p in newton]
    for profile, look in zip(modules, MODULE_LOOKS, strict=False):
        handles.append(Line2D([], [], color=style.BLACK, label=state(profile), **look))
    figure.legend(handles=handles, loc="outside lower center", ncols=2)
