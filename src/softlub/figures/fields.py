"""Pressures and separation over x at one speed: what the drawings of profiles share."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from softlub.figures import style
from softlub.figures.curves import nearest_load, nearest_speed, value_label
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


class Where(NamedTuple):
    """Speed [m/s] and load [N/m] that profiles are drawn at."""

    speed: float
    load: float

    @property
    def title(self) -> str:
        """For the figure."""
        return f"v = {style.power(self.speed)} m/s, W = {style.power(self.load)} N/m"

    @property
    def sentence(self) -> str:
        """For its caption."""
        return f"Drawn for v = {self.speed:.4g} m/s and W = {self.load:.4g} N/m."


def where(dataset: xr.Dataset, speed: float | None, load: float | None) -> Where:
    """The speed and the load of a dataset closest to those wanted; the middle ones where none is.

    Raises
    ------
    ValueError
        If there is none near.
    """
    return Where(nearest_speed(dataset, speed), nearest_load(dataset, load))


def profiles(dataset: xr.Dataset, at: Where, dimension: str | None) -> list[Profile]:
    """Profiles at one speed and load, one a value of a dimension.

    Parameters
    ----------
    dataset : xarray.Dataset
        With fields over nodes.
    at : Where
        One of the dataset's speeds and loads.
    dimension : str or None
        What the profiles differ in; None gives one.

    Returns
    -------
    list of Profile

    Raises
    ------
    ValueError
        If the dataset varies anything else, or holds more profiles than line styles tell apart.
    """
    others = [name for name in _varied(dataset) if name != dimension]
    if others:
        raise ValueError(
            f"profiles along {dimension} leave open which value of {', '.join(others)} to draw; vary one of them only"
        )
    point = dataset.sel(speed=at.speed, load=at.load)
    if dimension is None:
        return [_profile("", point.isel(dict.fromkeys(point["converged"].dims, 0)))]
    count = dataset.sizes[dimension]
    if count > len(style.LINE_STYLES):
        raise ValueError(
            f"{count} profiles cannot be told apart in one figure; allowed: {len(style.LINE_STYLES)} values "
            f"of {dimension} at most"
        )
    found = []
    for position in range(count):
        one = point.isel({dimension: position})
        one = one.isel(dict.fromkeys(one["converged"].dims, 0))
        found.append(_profile(value_label(dataset, dimension, position), one))
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
    return next(iter(_varied(dataset)), None)


def _varied(dataset: xr.Dataset) -> list[str]:
    names = [str(name) for name in dataset["converged"].dims if name not in ("load", "speed")]
    return [name for name in names if dataset.sizes[name] > 1]


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
    return {"linestyle": style.LINE_STYLES[index]}


def pressure_axis(drawn: list[Profile]) -> Quantity:
    """Axis that suits all pressures."""
    largest = max(float(np.nanmax([np.nanmax(p.fluid_pressure), np.nanmax(p.solid_pressure)])) for p in drawn)
    return quantity("pressure", largest, label="pressure", unit="Pa")
