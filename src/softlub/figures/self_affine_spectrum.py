"""The spectrum of a self-affine surface with its three wavevectors (figure 4-3), drawn from equation 4-5."""

from __future__ import annotations

import numpy as np
import xarray as xr

from softlub.datasets.contact_curves import inputs
from softlub.figures import style
from softlub.figures.panel import DataFigure, Panel, new_figure, styled
from softlub.figures.spectra_and_heights import SPECTRUM, WAVEVECTOR, asked_spectrum

NAMES = {"long_cutoff": r"$q_\mathrm{L}$", "rolloff": r"$q_\mathrm{r}$", "cutoff": r"$q_\mathrm{s}$"}


def draw(dataset: xr.Dataset, height: float = 2.7) -> DataFigure:
    """Draw C(q) of the surface that the dataset describes, with its roll-off, cut-offs and slope.

    Parameters
    ----------
    dataset : xarray.Dataset
        With hurst, rolloff, cutoff, long_cutoff and rms_roughness.
    height : float
        Of the figure [inch].

    Returns
    -------
    DataFigure
    """
    known = inputs(dataset)
    spectrum = asked_spectrum(known)
    q = np.unique(np.r_[np.geomspace(spectrum.plateau_start, spectrum.cutoff, 120), spectrum.rolloff])
    density = spectrum.density(q)
    with styled():
        figure = new_figure(style.COLUMN, height)
        panel = Panel(figure.subplots(), WAVEVECTOR, SPECTRUM, "spectrum")
        panel.axes.set_xscale("log")
        panel.axes.set_yscale("log")
        panel.line("equation 4-5", q, density, "", color=style.BLUE, linewidth=1.6)
        bottom, top = density.min() / 10, density.max() * 10
        for name, text in _marks(known).items():
            value = known[name]
            height_there = float(spectrum.density(min(value, spectrum.cutoff)))
            panel.line(name, [value, value], [bottom, height_there], "", color=style.GREY, linestyle=":")
            panel.axes.annotate(
                text, (value, height_there), xytext=(4, 4), textcoords="offset points", fontsize=9
            )
        middle = np.sqrt(spectrum.rolloff * spectrum.cutoff)
        panel.axes.annotate(
            f"slope −2(1 + H)\nH = {spectrum.hurst:g}",
            (middle, float(spectrum.density(middle))),
            xytext=(6, 6),
            textcoords="offset points",
        )
        panel.axes.set_ylim(bottom, top)
        panel.axes.set_xlim(q[0] / 2, q[-1] * 4)
        return figure


def _marks(known: dict[str, float]) -> dict[str, str]:
    """The wavevectors to be marked; q_L and q_r are one where there is no plateau."""
    if known["long_cutoff"] < known["rolloff"] * (1 - 1e-9):
        return NAMES
    return {"rolloff": f"{NAMES['long_cutoff']} = {NAMES['rolloff']}", "cutoff": NAMES["cutoff"]}
