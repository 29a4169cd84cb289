"""Pressure over mean separation in Persson's theory and its exponential tail (figure 4-8)."""

from __future__ import annotations

import numpy as np
import xarray as xr

from softlub.datasets.contact_curves import contact_curve, surfaces
from softlub.figures import style
from softlub.figures.panel import DataFigure, Panel, new_figure, styled
from softlub.figures.quantities import FloatArray, quantity

THEORIES = (
    ("mean_separation_persson", "full integral, γ = 1", style.BLUE, "-"),
    ("mean_separation_persson_gamma", "full integral, γ = 0.45", style.VERMILION, "--"),
)


def draw(dataset: xr.Dataset, height: float = 2.8) -> DataFigure:
    """Draw p/E* over u/h_rms: the full integral, its exponential tail, and the numerical contact where there is one.

    Parameters
    ----------
    dataset : xarray.Dataset
        Of one surface over its loads, with Persson's separations and the tail's pressure at those with γ = 1.
    height : float
        Of the figure [inch].

    Returns
    -------
    DataFigure
    """
    surface = next(surfaces(dataset))
    curve = contact_curve(surface)
    rms = curve.inputs["rms_roughness"]
    with styled():
        figure = new_figure(style.COLUMN, height)
        x = quantity("relative_separation", label=r"mean separation $u/h_\mathrm{rms}$", unit="1")
        y = quantity("reduced_pressure", label=r"pressure $p/E^*$", unit="1")
        panel = Panel(figure.subplots(), x, y, "pressure")
        panel.axes.set_yscale("log")
        for variable, name, colour, look in THEORIES:
            panel.line(name, curve.mean[variable] / rms, curve.reduced_pressure, color=colour, linestyle=look)
        separation = curve.mean["mean_separation_persson"]
        panel.line(
            "exponential tail, equation 4-23",
            separation / rms,
            _tail(curve.mean, surface),
            color=style.GREEN,
            linestyle=":",
        )
        if "mean_separation" in curve.mean:
            panel.line(
                "boundary elements",
                curve.relative_separation(),
                curve.reduced_pressure,
                color=style.BLACK,
                linestyle="none",
                marker="o",
                markersize=3,
                markerfacecolor="none",
            )
            panel.mark_failed(curve.relative_separation()[curve.failed])
        panel.axes.set_xlim(left=0.0)
        panel.axes.axvline(1.0, color=style.GREY, linewidth=0.6)
        panel.axes.annotate(
            r"$u = h_\mathrm{rms}$",
            (1.0, 0.02),
            xycoords=("data", "axes fraction"),
            xytext=(-3, 0),
            textcoords="offset points",
            ha="right",
        )
        panel.legend(loc="upper right")
        return figure


def _tail(mean: dict[str, FloatArray], surface: xr.Dataset) -> FloatArray:
    """p/E* of the tail, from pascals."""
    modulus = float(np.nanmedian(surface["pressure"] / surface["reduced_pressure"]))
    return mean["pressure_exponential"] / modulus
