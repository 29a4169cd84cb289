"""κ of the tables' surfaces over the load window, and how a statement on it is worded."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from softlub.claims.reading_contact import MEDIUM, at, numbers, table_curves
from softlub.claims.verdict import Datasets, NotComputed
from softlub.datasets.contact_curves import ContactCurve, local_kappa, window_kappa

PERSSON, BUSH = float(np.sqrt(8 / np.pi)), float(np.sqrt(2 * np.pi))
"""κ of Persson's theory and of that of Bush, Gibson and Thomas."""
ABOUT = 0.05
"""Relative difference up to which κ is "about" a value."""
LIGHT = 0.005
"""p/(E* h'rms) at which local slopes are given besides `MEDIUM`."""
WINDOW_TEXT = "kappa of the line through the origin up to A/A0 = 0.2, loads over the spectral h'rms"


class Kappa(NamedTuple):
    """κ of one curve over the load window, by what it counts and normalises with.

    Attributes
    ----------
    corrected, pixel : float
        By the area corrected for its edge, and by pixels; over the spectral h'rms.
    forward : float
        By the corrected area over the h'rms of forward differences.
    light, heavy : float
        Local slope of the corrected area at p/(E* h'rms) = 0.005 and 0.05.
    """

    corrected: float
    pixel: float
    forward: float
    light: float
    heavy: float


def kappa(curve: ContactCurve) -> Kappa:
    """κ of one curve.

    Raises
    ------
    NotComputed
        If too few loads converged within the window.
    """
    area, pixels = curve.mean["contact_area_ratio"], curve.mean["contact_area_ratio_pixel"]
    corrected = window_kappa(curve.load, area)
    if not np.isfinite(corrected):
        raise NotComputed("fewer than three loads with A/A0 up to 0.2 converged")
    slope = local_kappa(curve.load, area)
    return Kappa(
        corrected=corrected,
        pixel=window_kappa(curve.load, pixels),
        forward=corrected * curve.inputs["rms_slope_forward"] / curve.inputs["rms_slope_spectral"],
        light=at(curve.load, slope, LIGHT),
        heavy=at(curve.load, slope, MEDIUM),
    )


def table_kappas(datasets: Datasets, table: str, fewest: int = 2) -> list[Kappa]:
    """κ of those rows of a table that were run."""
    return [kappa(row.curve) for row in table_curves(datasets, table, fewest)]


def listed(kappas: list[Kappa]) -> str:
    """κ by either count of the area, as text."""
    return (
        f"kappa {numbers([k.corrected for k in kappas])} by the area corrected for its edge, "
        f"{numbers([k.pixel for k in kappas])} by pixels"
    )


def beside(kappas: list[Kappa]) -> str:
    """Local slopes and the other estimator of the slope, as every statement on κ needs them beside it."""
    return (
        f"{WINDOW_TEXT}; its local slope is {numbers([k.light for k in kappas])} at p/(E* h'rms) = 0.005 and "
        f"{numbers([k.heavy for k in kappas])} at 0.05; over the forward-difference h'rms kappa is "
        f"{numbers([k.forward for k in kappas])}"
    )


def spread(values: list[float]) -> float:
    """Largest over smallest value, less one."""
    return max(values) / min(values) - 1


def about(values: list[float], wanted: float) -> bool:
    """Whether all values are within 5 % of one."""
    return all(abs(value / wanted - 1) <= ABOUT for value in values)
