"""Linear against exponential wavevectors (figure 4-5): asked and obtained spectra (a), the linear surface (b)."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from softlub.datasets.contact_curves import inputs
from softlub.figures import style
from softlub.figures.maps import draw_map
from softlub.figures.panel import DataFigure, Panel, new_figure, styled
from softlub.figures.quantities import quantity
from softlub.figures.spectra_and_heights import SPECTRUM, WAVEVECTOR, asked_spectrum
from softlub.figures.surface_spectra import positive_part

LOOKS = {
    "linear": (style.VERMILION, "o", "linear wavevectors"),
    "exponential": (style.GREEN, "s", "exponential wavevectors"),
}


def draw(dataset: xr.Dataset, height: float = 2.9) -> DataFigure:
    """Draw the spectrum asked for, those of the surfaces obtained, and the surface of linear wavevectors.

    Parameters
    ----------
    dataset : xarray.Dataset
        With dimension `wavevectors`, power_spectrum over wavevector, height over x and y, and the spectrum's inputs.
    height : float
        Of the figure [inch].

    Returns
    -------
    DataFigure
    """
    linear = dataset.sel(wavevectors="linear")
    spectrum = asked_spectrum(inputs(linear))
    with styled():
        figure = new_figure(style.PAGE, height)
        left, right = figure.subplots(1, 2, width_ratios=(1.1, 1.0))
        panel = Panel(left, WAVEVECTOR, SPECTRUM, "a")
        panel.letter("a")
        panel.axes.set_xscale("log")
        panel.axes.set_yscale("log")
        q = np.unique(np.r_[np.geomspace(spectrum.plateau_start, spectrum.cutoff, 120), spectrum.rolloff])
        panel.line("asked", q, spectrum.density(q), color=style.BLUE, linewidth=1.6)
        for name, (colour, marker, label) in LOOKS.items():
            wavevector, density = positive_part(dataset.sel(wavevectors=name), "wavevector", "power_spectrum")
            look: dict[str, Any] = {
                "color": colour,
                "linestyle": "none",
                "marker": marker,
                "markerfacecolor": "none",
            }
            panel.line(label, wavevector, density, markersize=3, **look)
        panel.legend(loc="lower left")
        values = linear["height"].transpose("x", "y").values
        meaning = quantity("height", values, label="height z", unit="m")
        surface = draw_map(figure, right, "b", dataset["x"].values, dataset["y"].values, values, meaning)
        surface.letter("b")
        return figure
