"""Which input matters where: first-order indices of friction (a) and smallest separation (b) over speed."""

from __future__ import annotations

import numpy as np
import xarray as xr

from softlub.figures import style
from softlub.figures.panel import DataFigure, Panel, new_figure, share_legend, styled
from softlub.figures.quantities import FloatArray, quantity
from softlub.figures.sample import first_order_index, inputs

NAMES = {
    "young_modulus": "Young's modulus E",
    "rms_roughness": "roughness $h_\\mathrm{rms}$",
    "viscosity": "viscosity η",
    "radius": "radius R",
    "load": "load W",
}


def draw(dataset: xr.Dataset, bins: int = 25, height: float = 3.0) -> DataFigure:
    """Draw the share of the variance that each input explains by itself.

    Parameters
    ----------
    dataset : xarray.Dataset
        With dimensions sample and speed.
    bins : int
        Bins of each input.
    height : float
        Of the figure [inch].

    Returns
    -------
    DataFigure
    """
    causes = inputs(dataset)
    with styled():
        figure = new_figure(style.PAGE, height)
        panels = []
        effects = {
            "friction_coefficient": "μ",
            "separation_min": r"$\ln u_\mathrm{min}$",
        }
        for axes, letter, (variable, effect) in zip(
            figure.subplots(1, 2), "ab", effects.items(), strict=True
        ):
            axis = quantity("first_order_index", label=f"share of the variance of {effect}", unit="1")
            panel = Panel(axes, quantity("speed"), axis, letter)
            panel.letter(letter)
            panel.axes.set_xscale("log")
            panel.axes.set_ylim(-0.02, 1.02)
            _draw_indices(panel, dataset, variable, causes, bins)
            panels.append(panel)
        share_legend(figure, panels, 3)
        return figure


def _draw_indices(
    panel: Panel, dataset: xr.Dataset, variable: str, causes: dict[str, FloatArray], bins: int
) -> None:
    converged = dataset["converged"].transpose("sample", "speed").values.astype(bool)
    effect = np.where(converged, dataset[variable].transpose("sample", "speed").values, np.nan)
    if variable.startswith("separation"):
        effect = np.log(effect)
    speed = dataset["speed"].values
    total = np.zeros(speed.size)
    for index, (name, cause) in enumerate(causes.items()):
        share = np.array([first_order_index(cause, effect[:, i], bins) for i in range(speed.size)])
        total += share
        panel.line(
            NAMES.get(name, name.replace("_", " ")),
            speed,
            share,
            color=style.CYCLE[index % len(style.CYCLE)],
            marker=style.MARKERS[index % len(style.MARKERS)],
            markersize=3,
        )
    panel.line("all of them; the rest is interaction", speed, total, color=style.GREY, linestyle="--")
