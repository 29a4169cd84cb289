"""Spectra (a) and height distributions (b) of several rough surfaces (figure 4-13)."""

from __future__ import annotations

import numpy as np
import xarray as xr

from softlub.datasets.contact_curves import inputs, surfaces
from softlub.figures import style
from softlub.figures.panel import DataFigure, Panel, new_figure, share_legend, styled
from softlub.figures.quantities import FloatArray, quantity
from softlub.figures.surface_labels import surface_labels
from softlub.surfaces.spectrum import SelfAffine

SPECTRUM = quantity("power_spectrum", label="power spectrum C(q)", unit="m⁴")
WAVEVECTOR = quantity("wavevector", label="wavevector q", unit="1/m")
HEIGHT = quantity("relative_height", label=r"height $z/h_\mathrm{rms}$", unit="1")
DENSITY = quantity(
    "relative_height_density", label=r"probability density $\times\, h_\mathrm{rms}$", unit="1"
)


def draw(dataset: xr.Dataset, height: float = 3.1) -> DataFigure:
    """Draw the radial spectrum of each surface over the asked one, and its heights beside Gauss's curve.

    Parameters
    ----------
    dataset : xarray.Dataset
        Of a study of surfaces, with spectra and height distributions.
    height : float
        Of the figure [inch].

    Returns
    -------
    DataFigure
    """
    everyone = list(surfaces(dataset))
    labels = surface_labels([inputs(surface) for surface in everyone])
    with styled():
        figure = new_figure(style.PAGE, height)
        left, right = figure.subplots(1, 2)
        spectra = Panel(left, WAVEVECTOR, SPECTRUM, "a")
        heights = Panel(right, HEIGHT, DENSITY, "b")
        for panel in (spectra, heights):
            panel.letter(panel.name)
        spectra.axes.set_xscale("log")
        spectra.axes.set_yscale("log")
        for index, (label, surface) in enumerate(zip(labels, everyone, strict=True)):
            colour = style.CYCLE[index % len(style.CYCLE)]
            _draw_spectrum(spectra, label or "surface", surface, index, colour)
            _draw_heights(heights, label or "surface", surface, colour)
        z = np.linspace(-4, 4, 201)
        gauss = np.exp(-(z**2) / 2) / np.sqrt(2 * np.pi)
        heights.line("Gauss", z, gauss, color=style.BLACK, linestyle="--", linewidth=0.9)
        heights.axes.set_xlim(-4, 4)
        heights.axes.set_ylim(bottom=0)
        share_legend(figure, [spectra, heights], 2)
        return figure


def _draw_spectrum(panel: Panel, name: str, surface: xr.Dataset, index: int, colour: str) -> None:
    """The mean over realisations as points, the asked spectrum as a line."""
    one = surface.isel(realisation=0) if "realisation" in surface.dims else surface
    density = surface["power_spectrum"]
    if "realisation" in density.dims:
        density = density.mean("realisation", skipna=True)
    wavevector = np.asarray(one["wavevector"].values, dtype=float)
    known = np.isfinite(wavevector) & np.isfinite(density.values) & (density.values > 0)
    measured = _without_rounding(np.where(known, density.values, np.nan))
    panel.line(name, wavevector, measured, "", color=colour, linestyle="none", marker=".", markersize=3)
    asked = asked_spectrum(inputs(surface))
    q = np.geomspace(asked.plateau_start, asked.cutoff, 100)
    panel.line(f"{name}, asked", q, asked.density(q), "", color=colour, linewidth=0.9, alpha=0.7)


def _without_rounding(density: FloatArray) -> FloatArray:
    """NaN where a wave that the surface does not have holds the transform's rounding."""
    return np.where(density > 1e-12 * np.nanmax(density), density, np.nan)


def asked_spectrum(known: dict[str, float]) -> SelfAffine:
    """The spectrum that a surface was made from."""
    plateau = known["long_cutoff"] < known["rolloff"] * (1 - 1e-9)
    return SelfAffine(
        rms_roughness=known["rms_roughness"],
        hurst=known["hurst"],
        rolloff=known["rolloff"],
        cutoff=known["cutoff"],
        long_cutoff=known["long_cutoff"] if plateau else None,
    )


def _draw_heights(panel: Panel, name: str, surface: xr.Dataset, colour: str) -> None:
    """The density of each realisation thin, with the mean kurtosis in the legend."""
    known = inputs(surface)
    legend = f"{name}: kurtosis {known['kurtosis']:.2f}, skewness {style.signed(known['skewness'])}"
    for number in range(surface.sizes.get("realisation", 1)):
        one = surface.isel(realisation=number) if "realisation" in surface.dims else surface
        density, scale = one["height_density"].values, float(one["rms_roughness"])
        inside = np.isfinite(density)
        if inside.any():
            heights = one["height_bin"].values[inside] / scale
            series = f"{name}, realisation {number + 1}"
            panel.line(series, heights, density[inside] * scale, legend, color=colour, linewidth=0.9)
            legend = ""
