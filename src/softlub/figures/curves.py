"""The curves of a Stribeck dataset: one a combination of everything but the speed."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import xarray as xr

from softlub.datasets.variables import FLAGS
from softlub.figures import style
from softlub.figures.quantities import FloatArray, quantity


class Curve(NamedTuple):
    """One curve over speed and what tells it from its fellows: `places` are its positions along what is swept."""

    label: str
    data: xr.Dataset
    position: int
    places: tuple[tuple[str, int], ...] = ()

    @property
    def hersey_number(self) -> FloatArray:
        """ηv [N/m], shape (speeds,)."""
        return np.asarray(self.data["hersey_number"].values, dtype=float)

    def values(self, variable: str) -> FloatArray:
        """A variable over speed, NaN where the point failed, shape (speeds,)."""
        return np.where(self.data["converged"].values, self.data[variable].values, np.nan)

    @property
    def failed(self) -> np.ndarray:
        """Speeds that were attempted and did not converge."""
        return ~self.data["converged"].values.astype(bool) & attempted(self.data)

    @property
    def flags(self) -> np.ndarray:
        """Flags of every point, shape (speeds,)."""
        if "flags" not in self.data:
            return np.zeros(self.data["converged"].shape, dtype=int)
        return self.data["flags"].values.astype(int)


INACCURATE = {
    "separation": ("inaccurate_separation",),
    "": ("inaccurate_friction", "inaccurate_area"),
}
"""Which flags say that a variable is inaccurate, by how its name begins; load shares are as good as friction."""


def _doubting(variable: str) -> dict[str, str]:
    """Flags of points that converged and whose value of a variable should yet not be relied on; and their words."""
    names = next(names for begin, names in INACCURATE.items() if variable.startswith(begin))
    return {"outside_half_space": "no half-space"} | dict.fromkeys(names, "inaccurate")


def doubtful(flags: np.ndarray, variable: str) -> np.ndarray:
    """At which points a variable should not be relied on; that part of its curve is drawn thin and pale."""
    return (np.asarray(flags) & sum(FLAGS[name] for name in _doubting(variable))) > 0


def doubts(flags: np.ndarray, variable: str) -> list[str]:
    """What these flags say against a variable, for a legend."""
    words = [word for name, word in _doubting(variable).items() if (np.asarray(flags) & FLAGS[name]).any()]
    return list(dict.fromkeys(words))


def attempted(dataset: xr.Dataset) -> np.ndarray:
    """Which points a solver was asked for at all."""
    if "flags" not in dataset:
        return np.ones(dataset["converged"].shape, dtype=bool)
    return (dataset["flags"].values.astype(int) & FLAGS["not_attempted"]) == 0


def curves(dataset: xr.Dataset) -> Iterator[Curve]:
    """Curves over speed, in the order of the dataset's dimensions.

    Parameters
    ----------
    dataset : xarray.Dataset
        With dimension speed; fields over nodes are left aside.

    Yields
    ------
    Curve
        Labelled by those dimensions that have more than one value; the label is empty where there is one curve.
    """
    scalars = dataset.drop_dims("node", errors="ignore")
    dimensions = [str(name) for name in scalars["converged"].dims if name != "speed"]
    choices = itertools.product(*(range(scalars.sizes[name]) for name in dimensions))
    for count, choice in enumerate(choices):
        picked = dict(zip(dimensions, choice, strict=True))
        places = tuple((name, position) for name, position in picked.items() if scalars.sizes[name] > 1)
        label = ", ".join(value_label(scalars, name, position) for name, position in places)
        yield Curve(label, scalars.isel(picked), count, places)


def value_label(dataset: xr.Dataset, dimension: str, position: int) -> str:
    """One value of a dimension as a legend shows it: ``"E = 10 MPa"``, ``"BML"``."""
    if dimension not in dataset.coords:
        return f"{dimension.replace('_', ' ')} {position}"
    value = dataset[dimension].values[position]
    if isinstance(value, str):
        return style.readable(value)
    axis = quantity(dimension, unit=dataset[dimension].attrs.get("units"))
    return f"{_mathematical(axis.label)} = {axis.text(float(value))}"


def _mathematical(symbol: str) -> str:
    name, underscore, index = symbol.partition("_")
    return rf"${name}_\mathrm{{{index}}}$" if underscore else symbol


def nearest_speed(dataset: xr.Dataset, speed: float | None) -> float:
    """The dataset's speed closest, in its logarithm, to the one wanted; the middle one when none is.

    Parameters
    ----------
    dataset : xarray.Dataset
    speed : float or None
        [m/s].

    Returns
    -------
    float

    Raises
    ------
    ValueError
        If the closest speed differs from the wanted one by more than a tenth.
    """
    return _nearest(dataset, "speed", speed, "m/s")


def nearest_load(dataset: xr.Dataset, load: float | None) -> float:
    """The dataset's load closest, in its logarithm, to the one wanted; the middle one when none is.

    Parameters
    ----------
    dataset : xarray.Dataset
    load : float or None
        [N/m].

    Returns
    -------
    float

    Raises
    ------
    ValueError
        If the closest load differs from the wanted one by more than a tenth.
    """
    return _nearest(dataset, "load", load, "N/m")


def _nearest(dataset: xr.Dataset, name: str, wanted: float | None, unit: str) -> float:
    values = np.asarray(dataset[name].values, dtype=float)
    if wanted is None:
        return float(values[values.size // 2])
    closest = float(values[np.argmin(np.abs(np.log(values / wanted)))])
    if abs(closest - wanted) > 0.1 * wanted:
        raise ValueError(
            f"the dataset holds no {name} near {wanted:g} {unit} (closest: {closest:g} {unit}); "
            "add it to the study's grid"
        )
    return closest
