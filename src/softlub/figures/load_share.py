"""Load carried by the fluid and by asperities over Hersey number (figure 3-16)."""

from __future__ import annotations

import xarray as xr

from softlub.datasets.minimum import friction_minimum
from softlub.figures import style
from softlub.figures.curves import Curve, curves
from softlub.figures.looks import MOST_DASHED, dashes, handles, refuse_many
from softlub.figures.panel import DataFigure, Panel, new_figure, place_legend, styled
from softlub.figures.quantities import quantity

COLOURS = {"fluid": style.FLUID, "asperities": style.SOLID}


def draw(dataset: xr.Dataset, height: float = 2.7) -> DataFigure:
    """Draw both load shares; a dashed line marks the minimum of friction.

    Parameters
    ----------
    dataset : xarray.Dataset
        Stribeck dataset. Along `solver` only the Newton solution is drawn.
    height : float
        Of the figure [inch].

    Returns
    -------
    DataFigure
    """
    with styled():
        figure = new_figure(style.COLUMN, height)
        share = quantity("load_share", label="share of the load", unit="1")
        panel = Panel(figure.subplots(), quantity("hersey_number"), share, "a")
        panel.axes.set_xscale("log")
        chosen = newton_curves(dataset)
        refuse_many("load_share", len(chosen), MOST_DASHED)
        panel.handles += handles(COLOURS, chosen)
        for curve in chosen:
            _draw_curve(panel, curve, alone=len(chosen) == 1)
        panel.axes.set_ylim(-0.04, 1.04)
        place_legend(figure, panel, loc="center right")
        return figure


def newton_curves(dataset: xr.Dataset) -> list[Curve]:
    """Curves of the Newton solution alone, where several solvers are compared."""
    if "solver" in dataset.dims:
        names = [style.solver_of(str(label)) for label in dataset["solver"].values]
        newton = [i for i, name in enumerate(names) if name in style.NEWTON_SOLVERS]
        dataset = dataset.isel(solver=newton[:1] if newton else [0])
    return list(curves(dataset))


def _draw_curve(panel: Panel, curve: Curve, alone: bool) -> None:
    solid = curve.values("load_share_solid")
    suffix = f", {curve.label}" if curve.label else ""
    for name, share in (("fluid", 1 - solid), ("asperities", solid)):
        panel.line(
            f"{name}{suffix}",
            curve.hersey_number,
            share,
            label="",
            flags=curve.flags,
            color=COLOURS[name],
            linestyle=dashes(curve),
        )
    panel.mark_failed(curve.hersey_number[curve.failed])
    least = friction_minimum(curve.data)
    if least is not None:
        _mark_minimum(panel, least.hersey_number, least.load_share_solid, alone)


def _mark_minimum(panel: Panel, hersey_number: float, share: float, alone: bool) -> None:
    panel.line(
        "minimum of friction",
        [hersey_number, hersey_number],
        [0.0, 1.0],
        label="minimum of friction" if alone else "",
        color=style.GREY,
        linestyle="--",
        linewidth=0.8,
    )
    if alone:
        panel.axes.annotate(
            f"asperities carry\n{100 * share:.2g} % here",
            (hersey_number, share),
            xytext=(0.97, 0.25),
            textcoords="axes fraction",
            ha="right",
            fontsize=7,
            arrowprops={"arrowstyle": "-", "linewidth": 0.5, "color": style.GREY},
        )
