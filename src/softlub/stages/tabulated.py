"""From a law's dataset to what a contact law is made of."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

import xarray as xr

from softlub.contact.laws.persson_integral import ScaledCurve
from softlub.contact.laws.tabulated import ContactCurve, averaged
from softlub.datasets import store


class SweptSurface(NamedTuple):
    """A surface that was swept over its load.

    Attributes
    ----------
    curve : ContactCurve
        Averaged over the realisations.
    closing : ScaledCurve
        Persson's curve of the same surface, for where the gap closes.
    rms_roughness : float
        h_rms in the law's unit of height.
    rms_slope : float
        Spectral h'_rms in that unit.
    """

    curve: ContactCurve
    closing: ScaledCurve
    rms_roughness: float
    rms_slope: float


def read_law(path: Path) -> SweptSurface:
    """Read a law.

    Parameters
    ----------
    path : Path
        Dataset of the stage `law`.

    Returns
    -------
    SweptSurface

    Raises
    ------
    ValueError
        If too few loads converged for a law.
    """
    law = store.read(path)
    roughness, slope = (float(law[name].mean()) for name in ("rms_roughness", "rms_slope_spectral"))
    # The realisations of one spectrum differ in h'_rms by their rounding alone.
    load = (law["reduced_pressure"] / law["rms_slope_spectral"]).isel(realisation=0)
    curve = averaged(
        load.values, (law["mean_separation"] / law["rms_roughness"]).values, law["contact_area_ratio"].values
    )
    return SweptSurface(curve, closing_curve(law.isel(realisation=0)), roughness, slope)


def closing_curve(law: xr.Dataset) -> ScaledCurve:
    """Persson's curve as the law's dataset holds it."""
    return ScaledCurve(*(law[f"persson_{name}"].values for name in ("separation", "pressure", "rate")))
