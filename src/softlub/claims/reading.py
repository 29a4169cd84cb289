"""Reading what the checks need out of a study's dataset, or saying what is not there."""

from __future__ import annotations

import numpy as np
import xarray as xr

from softlub.claims.verdict import NotComputed
from softlub.datasets.minimum import FrictionMinimum, friction_minimum
from softlub.datasets.variables import FLAGS

AGREEMENT = 0.02
"""Largest difference of two fields, as part of their scale, up to which they agree: what a printed figure shows."""
NEWTON = ("auto", "spectral", "finite_volume")


def curve(dataset: xr.Dataset, **where: float | str) -> xr.Dataset:
    """One Stribeck curve: the Newton solution where several solvers are compared, the first load.

    Parameters
    ----------
    dataset : xarray.Dataset
    **where
        Values of swept dimensions; numbers are matched within one part in a thousand.

    Returns
    -------
    xarray.Dataset
        Dimensions speed and, for fields, node.

    Raises
    ------
    NotComputed
        If the dataset has no such value.
    """
    picked = dataset
    for name, value in where.items():
        picked = picked.isel({name: _position(dataset, name, value)})
    if "solver" in picked.dims:
        picked = solver(picked, *NEWTON)
    return picked.isel({name: 0 for name in picked["converged"].dims if name != "speed"})


def _position(dataset: xr.Dataset, name: str, value: float | str) -> int:
    if name not in dataset.dims:
        raise NotComputed(f"the dataset was not swept over {name}")
    values = dataset[name].values
    match = values == value if isinstance(value, str) else np.isclose(values, value, rtol=1e-3)
    if not match.any():
        raise NotComputed(f"the dataset holds no {name} = {value}")
    return int(np.argmax(match))


def solver(dataset: xr.Dataset, *names: str, option: str = "", without: str = "\n") -> xr.Dataset:
    """The part of a dataset that one of some solvers made.

    Parameters
    ----------
    dataset : xarray.Dataset
    *names : str
        First words of labels; the first that is found counts.
    option, without : str
        What the label must and must not contain.

    Returns
    -------
    xarray.Dataset

    Raises
    ------
    NotComputed
        If the dataset has none of them.
    """
    if "solver" not in dataset.dims:
        raise NotComputed("the dataset compares no solvers")
    labels = [str(label) for label in dataset["solver"].values]
    for name in names:
        # A label without options goes first.
        for position in sorted(range(len(labels)), key=lambda i: len(labels[i])):
            label = labels[position]
            if label.split()[0].rstrip(",(") == name and option in label and without not in label:
                return dataset.isel(solver=position)
    raise NotComputed(f"the dataset holds no solver {' or '.join(names)} {option}".rstrip())


def law(dataset: xr.Dataset, name: str, gamma: float = 1.0) -> xr.Dataset:
    """The part of a dataset with one contact law; γ stands in the label unless it is 1."""
    if "contact_law" not in dataset.dims:
        raise NotComputed("the dataset was not swept over contact_law")
    for position, label in enumerate(map(str, dataset["contact_law"].values)):
        if label.startswith(name) and (f"{gamma:g}" in label) == (gamma != 1.0):
            return dataset.isel(contact_law=position)
    raise NotComputed(f"the dataset holds no contact law {name} with gamma = {gamma:g}")


def at_speed(curve: xr.Dataset, speed: float) -> xr.Dataset:
    """The point of a curve closest to a speed [m/s], within 5 %; failed points too.

    Raises
    ------
    NotComputed
        If no speed is that close, or the point was not attempted.
    """
    speeds = curve["speed"].values
    closest = int(np.argmin(np.abs(np.log(speeds / speed))))
    if abs(speeds[closest] / speed - 1) > 0.05:
        raise NotComputed(f"the dataset holds no speed near {speed:g} m/s")
    point = curve.isel(speed=closest)
    if int(point["flags"]) & FLAGS["not_attempted"]:
        raise NotComputed(f"this solver was not asked for at {speed:g} m/s")
    return point


def number(point: xr.Dataset, variable: str) -> float:
    """One number of a point.

    Raises
    ------
    NotComputed
        If the point did not converge.
    """
    if not bool(point["converged"]):
        raise NotComputed(
            f"the point at {float(point['speed']):g} m/s did not converge (residual {float(point['residual']):.1e})"
        )
    return float(point[variable])


def interpolated(curve: xr.Dataset, speed: float, variable: str) -> float:
    """A positive variable of a curve at any of its speeds: cubic through the four nearest points, in logarithms.

    Parameters
    ----------
    curve : xarray.Dataset
    speed : float
        [m/s]
    variable : str

    Returns
    -------
    float

    Raises
    ------
    NotComputed
        If the speed lies outside the curve, or one of the four points failed.
    """
    log_speed = np.log(curve["speed"].values) - np.log(speed)
    if log_speed.size < 4 or not log_speed[0] - 1e-9 <= 0 <= log_speed[-1] + 1e-9:
        raise NotComputed(f"the curve does not reach over {speed:g} m/s")
    nearest = np.sort(np.argsort(np.abs(log_speed), kind="stable")[:4])
    if not curve["converged"].values[nearest].all():
        raise NotComputed(f"a point beside {speed:g} m/s did not converge")
    cubic = np.polyfit(log_speed[nearest], np.log(curve[variable].values[nearest]), 3)
    return float(np.exp(cubic[-1]))


def minimum(curve: xr.Dataset) -> FrictionMinimum:
    """Minimum of friction of a curve.

    Raises
    ------
    NotComputed
        If it has none inside its speeds.
    """
    found = friction_minimum(curve)
    if found is None:
        raise NotComputed("the curve has no minimum of friction inside its speeds, or failed beside it")
    return found


def attempted(dataset: xr.Dataset) -> np.ndarray:
    """Which points a solver was asked for."""
    return (dataset["flags"].values.astype(int) & FLAGS["not_attempted"]) == 0


def profile_difference(first: xr.Dataset, second: xr.Dataset, name: str) -> float:
    """Largest difference of a field between two points, as part of the first one's scale.

    Parameters
    ----------
    first, second : xarray.Dataset
        Points, each on its own nodes.
    name : str
        Of the field. Pressures are compared within 1.5 times the contact and scaled with the largest total
        pressure; separations within the contact, since they grow without bound outside, and scaled with the largest.

    Returns
    -------
    float
    """
    x, values = field(first, name)
    others_x, others = field(second, name)
    total = field(first, "fluid_pressure")[1] + field(first, "solid_pressure")[1]
    core = np.abs(x[total > 0.1 * total.max()]).max()
    reach = core if name == "separation" else 1.5 * core
    inside = (np.abs(x) <= reach) & (x >= others_x[0]) & (x <= others_x[-1])
    scale = np.abs(values[inside]).max() if name == "separation" else total.max()
    return float(np.max(np.abs(values - np.interp(x, others_x, others))[inside]) / scale)


def field(point: xr.Dataset, name: str) -> tuple[np.ndarray, np.ndarray]:
    """Nodes and values of a field of one point, sorted, without padding.

    Raises
    ------
    NotComputed
        If the dataset keeps no fields.
    """
    if name not in point:
        raise NotComputed("the dataset keeps no fields over x")
    x = np.asarray(point["x"].values, dtype=float)
    known = np.isfinite(x)
    order = np.argsort(x[known])
    return x[known][order], np.asarray(point[name].values, dtype=float)[known][order]


def hertz_half_width(dataset: xr.Dataset) -> float:
    """Hertz's half-width a of a curve's or a point's scene [m]."""
    scale = 4 * dataset["load"] * dataset["radius"] / (np.pi * dataset["plane_strain_modulus"])
    return float(scale**0.5)


def hertz_peak_pressure(dataset: xr.Dataset) -> float:
    """Hertz's peak pressure p0 [Pa]."""
    return float(2 * dataset["load"]) / (np.pi * hertz_half_width(dataset))
