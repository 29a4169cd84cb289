"""Autocorrelation (a) and the two spectra of one surface (b) (figure 4-4)."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.axes import Axes

from softlub.datasets.contact_curves import inputs
from softlub.figures import style
from softlub.figures.panel import DataFigure, Panel, new_figure, styled
from softlub.figures.quantities import FloatArray, Quantity, quantity
from softlub.figures.spectra_and_heights import SPECTRUM, WAVEVECTOR
from softlub.surfaces.line_spectrum import line_factor

LINE_SPECTRUM = quantity("power_spectrum_profile", label=r"spectrum of lines $C_\mathrm{1D+}(q)$", unit="m³")


def draw(dataset: xr.Dataset, height: float = 2.8) -> DataFigure:
    """Draw the radial autocorrelation, the radial spectrum C(q) and the lines' spectrum C1D+(q).

    Beside the lines' spectrum stands the one that follows from C(q), with the right factor and with the printed π.

    Parameters
    ----------
    dataset : xarray.Dataset
        With autocorrelation over lag, power_spectrum over wavevector, power_spectrum_profile over
        wavevector_profile, and hurst where it is known.
    height : float
        Of the figure [inch].

    Returns
    -------
    DataFigure
    """
    with styled():
        figure = new_figure(style.PAGE, height)
        left, right = figure.subplots(1, 2)
        _draw_autocorrelation(left, dataset)
        _draw_spectra(right, dataset)
        return figure


def _draw_autocorrelation(axes: Axes, dataset: xr.Dataset) -> None:
    lag = dataset["lag"].values
    covariance = dataset["autocorrelation"].values
    panel = Panel(
        axes,
        quantity("lag", lag, label="distance r", unit="m"),
        Quantity("autocorrelation", "autocorrelation", "m²", exponent=-12),
        "a",
    )
    panel.letter("a")
    panel.line("autocorrelation", lag, covariance, "", color=style.BLUE)
    panel.axes.axhline(0, color=style.GREY, linewidth=0.5)
    panel.axes.set_xlim(0, float(panel.x.shown(lag[-1])))


def _draw_spectra(axes: Axes, dataset: xr.Dataset) -> None:
    wavevector, density = positive_part(dataset, "wavevector", "power_spectrum")
    along, lines = positive_part(dataset, "wavevector_profile", "power_spectrum_profile")
    radial = Panel(axes, WAVEVECTOR, SPECTRUM, "b")
    radial.letter("b")
    profile = Panel(radial.axes.twinx(), WAVEVECTOR, LINE_SPECTRUM, "b, right axis")
    for panel in (radial, profile):
        panel.axes.set_xscale("log")
        panel.axes.set_yscale("log")
    radial.axes.tick_params(right=False, which="both")
    radial.line("C(q), left axis", wavevector, density, color=style.BLUE)
    profile.line(r"$C_\mathrm{1D+}(q)$ of lines, right axis", along, lines, color=style.VERMILION)
    known = inputs(dataset)
    factors = {r"$\pi q C(q)$, as printed": np.pi}
    if "hurst" in known:
        factors = {rf"{line_factor(known['hurst']):.2f} $q C(q)$": line_factor(known["hurst"])} | factors
    for (name, factor), look in zip(factors.items(), ("--", ":"), strict=False):
        profile.line(
            name, wavevector, factor * wavevector * density, color=style.BLACK, linestyle=look, linewidth=0.9
        )
    # Each spectrum gets a decade of its own, or they would lie on each other.
    low, high = radial.axes.get_ylim()
    radial.axes.set_ylim(low / 1e2, high)
    low, high = profile.axes.get_ylim()
    profile.axes.set_ylim(low, high * 1e2)
    profile.axes.legend(handles=[*radial.handles, *profile.handles], loc="lower left", fontsize=6.5)


def positive_part(dataset: xr.Dataset, wavevector: str, density: str) -> tuple[FloatArray, FloatArray]:
    """A spectrum without NaN padding and without waves that hold nothing but the transform's rounding.

    Parameters
    ----------
    dataset : xarray.Dataset
    wavevector, density : str
        Names of the variables.

    Returns
    -------
    wavevector, density : ndarray, shape (n,)
    """
    q, values = (np.asarray(dataset[name].values, dtype=float) for name in (wavevector, density))
    kept = np.isfinite(q) & (values > 1e-12 * np.nanmax(values))
    return q[kept], values[kept]
