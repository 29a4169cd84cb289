"""A measured line on its way to roughness (figure 4-1): raw, without its form, without its waviness."""

from __future__ import annotations

import numpy as np
import xarray as xr

from softlub.figures import style
from softlub.figures.panel import DataFigure, Panel, new_figure, styled
from softlub.figures.quantities import quantity

STAGES = (
    ("profile_raw", "raw", "form"),
    ("profile_form_removed", "form removed", "waviness"),
    ("profile_roughness", "waviness removed: roughness", ""),
)
"""Variable, what it is, and what is taken off it next."""


def draw(dataset: xr.Dataset, height: float = 4.2) -> DataFigure:
    """Draw the three stages below each other; the red line is what is taken off next.

    Parameters
    ----------
    dataset : xarray.Dataset
        With profile_raw, profile_form_removed and profile_roughness over position.
    height : float
        Of the figure [inch].

    Returns
    -------
    DataFigure
    """
    position = dataset["position"].values
    heights = [dataset[variable].values for variable, _, _ in STAGES]
    with styled():
        figure = new_figure(style.PAGE, height)
        x = quantity("position", position, label="position x", unit="m")
        every_axes = figure.subplots(3, 1, sharex=True)
        for index, (axes, (_, shown, removed)) in enumerate(zip(every_axes, STAGES, strict=True)):
            y = quantity("height", np.ptp(heights[index]), label="height z", unit="m")
            panel = Panel(axes, x, y, shown)
            panel.axes.label_outer()
            panel.line(shown, position, heights[index], color=style.BLUE, linewidth=0.6)
            if removed:
                taken = heights[index] - heights[index + 1]
                panel.line(removed, position, taken, color=style.VERMILION)
            panel.axes.set_xlim(float(x.shown(position[0])), float(x.shown(position[-1])))
            low, high = axes.get_ylim()
            axes.set_ylim(low, high + 0.25 * (high - low))
            panel.legend(loc="upper right", ncols=2)
        return figure
