"""Pressures and separation over x at one speed: what the drawings of profiles share."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from softlub.figures import style
from softlub.figures.curves import value_label
from softlub.figures.quantities import FloatArray, Quantity, quantity


class Profile(NamedTuple):
    """Fields of one contact over x, sorted, without padding."""

    label: str
    solver: str
    x: FloatArray
    fluid_pressure: FloatArray
    solid_pressure: FloatArray
    separation: FloatArray
    converged: bool
    residual: float
    iterations: float


def profiles(dataset: xr.Dataset, speed: float, dimension: str | None) -> list[Profile]:
    """Profiles at one speed, one a value of a dimension.

    Parameters
    ----------
    dataset : xarray.Dataset
        With fields over nodes; loads beyond the first are left aside.
    speed : float
        One of the dataset's speeds [m/s].
    dimension : str or None
        What the profiles differ in; None gives one.

    Returns
    -------
    list of Profile
    """
    at_speed = dataset.sel(speed=speed)
    positions = range(dataset.sizes[dimension]) if dimension else [0]
    found = []
    for position in positions:
        point = at_speed.isel({dimension: position}) if dimension else at_speed
        point = point.isel(dict.fromkeys(point["converged"].dims, 0))
        label = value_label(dataset, dimension, position) if dimension else ""
        found.append(_profile(label, point))
    return found


def _profile(label: str, point: xr.Dataset) -> Profile:
    x = np.asarray(point["x"].values, dtype=float)
    order = np.argsort(x[np.isfinite(x)])
    fluid, solid, separation = (
        np.asarray(point[name].values, dtype=float)[np.isfinite(x)][order]
        for name in ("fluid_pressure", "solid_pressure", "separation")
    )
    return Profile(
        label=label,
        solver=str(point["solver"].values) if "solver" in point.coords else "",
        x=x[np.isfinite(x)][order],
        fluid_pressure=fluid,
        solid_pressure=solid,
        separation=separation,
        converged=bool(point["converged"]),
        residual=float(point["residual"]),
        iterations=float(point["iterations"]),
    )


def swept_dimension(dataset: xr.Dataset) -> str | None:
    """The first dimension besides load, speed and node that has several values; None if there is none."""
    names = [str(name) for name in dataset["converged"].dims if name not in ("load", "speed")]
    return next((name for name in names if dataset.sizes[name] > 1), None)


def contact_window(drawn: list[Profile], level: float = 1e-3) -> tuple[float, float]:
    """Stretch of x that holds all pressures above a part of their maximum, with a margin on both sides [m].

    Parameters
    ----------
    drawn : list of Profile
    level : float
        Part of the largest total pressure.

    Returns
    -------
    tuple of float
    """
    starts, ends = [], []
    for profile in drawn:
        total = np.nan_to_num(profile.fluid_pressure + profile.solid_pressure)
        inside = profile.x[total > level * np.max(total, initial=0.0)]
        if inside.size:
            starts.append(inside[0])
            ends.append(inside[-1])
    if not starts:
        return -1.0, 1.0
    # The inlet's pressure has a long tail that says little; the outlet sets the scale.
    start = max(min(starts), -3 * max(ends))
    margin = 0.15 * (max(ends) - start)
    left, right = (limit([edge(p.x) for p in drawn]) for limit, edge in ((min, np.min), (max, np.max)))
    return max(start - margin, float(left)), min(max(ends) + margin, float(right))


def separation_limit(drawn: list[Profile], window: tuple[float, float]) -> float:
    """Upper end of the separation axis: the film in the contact fills the lower part of it [m]."""
    largest = 0.0
    for profile in drawn:
        total = np.nan_to_num(profile.fluid_pressure + profile.solid_pressure)
        inside = (
            (profile.x > window[0]) & (profile.x < window[1]) & (total > 0.5 * np.max(total, initial=0.0))
        )
        if inside.any():
            largest = max(largest, float(np.nanmax(profile.separation[inside])))
    return 2.5 * largest if largest > 0 else 1.0


def look(index: int) -> dict[str, Any]:
    """Line style of the index-th profile; colours are taken by the three fields."""
    return {"linestyle": style.LINE_STYLES[index % len(style.LINE_STYLES)]}


def pressure_axis(drawn: list[Profile]) -> Quantity:
    """Axis that suits all pressures."""
    largest = max(float(np.nanmax([np.nanmax(p.fluid_pressure), np.nanmax(p.solid_pressure)])) for p in drawn)
    return quantity("pressure", largest, label="pressure", unit="Pa")
