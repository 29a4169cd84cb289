"""The minimum of friction of one Stribeck curve."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import xarray as xr

NEIGHBOURS = 2
"""Points on each side of the lowest one that the local polynomial goes through."""


class FrictionMinimum(NamedTuple):
    """Where friction is least, between the grid's speeds."""

    speed: float
    hersey_number: float
    friction_coefficient: float
    separation_min: float
    load_share_solid: float


def friction_minimum(curve: xr.Dataset) -> FrictionMinimum | None:
    """Minimum of the friction coefficient over speed.

    Parameters
    ----------
    curve : xarray.Dataset
        One curve: dimension speed alone.

    Returns
    -------
    FrictionMinimum or None
        From the polynomial in ln v through the lowest point and its neighbours; None where the curve has no minimum
        inside, or a neighbour failed.
    """
    friction = np.where(curve["converged"].values, curve["friction_coefficient"].values, np.nan)
    if not np.isfinite(friction).any():
        return None
    lowest = int(np.nanargmin(friction))
    near = slice(lowest - NEIGHBOURS, lowest + NEIGHBOURS + 1)
    if lowest < NEIGHBOURS or lowest + NEIGHBOURS >= friction.size or not np.isfinite(friction[near]).all():
        return None
    log_speed = np.log(curve["speed"].values[near])
    centre = log_speed[NEIGHBOURS]
    fine = np.linspace(log_speed[NEIGHBOURS - 1], log_speed[NEIGHBOURS + 1], 2001) - centre

    def between(values: np.ndarray) -> np.ndarray:
        return np.polyval(np.polyfit(log_speed - centre, values, 2 * NEIGHBOURS), fine)

    at = int(np.argmin(between(friction[near])))
    speed = float(np.exp(fine[at] + centre))
    logarithms = {
        name: between(np.log(np.maximum(curve[name].values[near], np.finfo(float).tiny)))[at]
        for name in ("separation_min", "load_share_solid")
    }
    return FrictionMinimum(
        speed=speed,
        hersey_number=speed * float(curve["hersey_number"].values[lowest] / curve["speed"].values[lowest]),
        friction_coefficient=float(between(friction[near])[at]),
        separation_min=float(np.exp(logarithms["separation_min"])),
        load_share_solid=float(np.exp(logarithms["load_share_solid"])),
    )
