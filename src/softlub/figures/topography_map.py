"""A rough surface (a) and the distribution of its heights beside Gauss's curve (b) (figure 4-2)."""

from __future__ import annotations

import numpy as np
import xarray as xr

from softlub.figures import style
from softlub.figures.maps import draw_map
from softlub.figures.panel import DataFigure, Panel, new_figure, styled
from softlub.figures.quantities import Quantity, quantity


def draw(dataset: xr.Dataset, height: float = 2.9) -> DataFigure:
    """Draw the heights as a map and as a probability density with the Gaussian of the same h_rms.

    Parameters
    ----------
    dataset : xarray.Dataset
        With height over x and y, height_density over height_bin, rms_roughness, skewness and kurtosis.
    height : float
        Of the figure [inch].

    Returns
    -------
    DataFigure
    """
    rms = float(dataset["rms_roughness"])
    with styled():
        figure = new_figure(style.PAGE, height)
        left, right = figure.subplots(1, 2, width_ratios=(1.15, 1.0))
        values = dataset["height"].transpose("x", "y").values
        meaning = quantity("height", values, label="height z", unit="m")
        surface = draw_map(figure, left, "a", dataset["x"].values, dataset["y"].values, values, meaning)
        surface.letter("a")
        inside = np.isfinite(dataset["height_density"].values)
        bins = dataset["height_bin"].values[inside]
        panel = Panel(
            right,
            quantity("height", bins, label="height z", unit="m"),
            Quantity("height_density", "probability density", "1/m", exponent=6),
            "b",
        )
        panel.letter("b")
        panel.line(
            "surface", bins, dataset["height_density"].values[inside], color=style.BLUE, drawstyle="steps-mid"
        )
        gauss = np.exp(-((bins / rms) ** 2) / 2) / (np.sqrt(2 * np.pi) * rms)
        panel.line("Gauss", bins, gauss, color=style.VERMILION, linestyle="--")
        panel.axes.set_title(
            f"skewness {style.signed(float(dataset['skewness']))}, kurtosis {float(dataset['kurtosis']):.2f}",
            loc="right",
        )
        panel.axes.set_ylim(bottom=0, top=1.25 * panel.axes.get_ylim()[1])
        panel.legend(loc="upper right")
        return figure
