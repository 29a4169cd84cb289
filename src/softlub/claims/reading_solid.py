"""Reading what the checks of chapter 5 need out of a dataset of finite-element bodies, or saying what is not there."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
import xarray as xr

from softlub.claims.verdict import NotComputed
from softlub.protocols import FloatArray


class Differences(NamedTuple):
    """Largest difference from finite elements over the largest displacement, and of the components over their own."""

    whole: float
    lateral: float
    vertical: float

    def __str__(self) -> str:
        return f"{percent(self.whole)} (lateral {percent(self.lateral)}, vertical {percent(self.vertical)} of its own)"


def percent(share: float) -> str:
    """A share as a table gives it."""
    return f"{100 * share:.2g} %" if abs(share) < 0.995 else f"{100 * share:.0f} %"


def scene(dataset: xr.Dataset, where: Mapping[str, float | str] | None = None) -> xr.Dataset:
    """One body: of what was swept the value asked for, else the first; the heaviest load.

    Parameters
    ----------
    dataset : xarray.Dataset
    where : mapping, optional
        Swept dimension -> value; numbers are matched within one part in a thousand.

    Returns
    -------
    xarray.Dataset

    Raises
    ------
    NotComputed
        If the dataset has no such value or the body did not get to the end of its steps.
    """
    wanted = {name: _place(dataset, name, value) for name, value in (where or {}).items()}
    swept = map(str, dataset["converged"].dims)
    picked = dataset.isel({name: dataset.sizes[name] - 1 if name == "load" else 0 for name in swept} | wanted)
    if not bool(picked["converged"]):
        raise NotComputed(f"the body stopped before the end: {picked['stop_reason'].item()}")
    return trimmed(picked)


def _place(dataset: xr.Dataset, name: str, value: float | str) -> int:
    if name not in dataset.dims:
        raise NotComputed(f"the dataset was not swept over {name}")
    values = dataset[name].values
    match = values == value if isinstance(value, str) else np.isclose(values, value, rtol=1e-3)
    if not match.any():
        raise NotComputed(f"the dataset holds no {name} = {value}")
    return int(np.argmax(match))


def trimmed(body: xr.Dataset) -> xr.Dataset:
    """A body without the nodes that only finer meshes have."""
    if "node" not in body.dims or "x" not in body or body["x"].dims != ("node",):
        return body
    return body.isel(node=np.flatnonzero(np.isfinite(body["x"].values)))


def differences(body: xr.Dataset, method: str = "reduced") -> Differences:
    """How far the displacement by a method is from that by finite elements.

    Parameters
    ----------
    body : xarray.Dataset
        As `scene` gives it.
    method : str

    Returns
    -------
    Differences

    Raises
    ------
    NotComputed
        If the dataset does not compare that method.
    """
    if "method" not in body.dims or method not in body["method"].values:
        raise NotComputed(f"the dataset does not compare {method} with finite elements")
    whole = float(body["displacement_error"].sel({"method": method}))
    each = body["displacement_error_component"].sel({"method": method})
    return Differences(whole, *(float(each.sel(component=name)) for name in ("x", "y")))


def displacement(body: xr.Dataset, method: str = "full") -> FloatArray:
    """Displacement of the contact edge by a method, shape (k, 2)."""
    if "method" not in body.dims or method not in body["method"].values:
        raise NotComputed(f"the dataset holds no displacement by {method}")
    return np.asarray(body["displacement"].sel({"method": method}).transpose("node", "component").values)


def largest(vectors: FloatArray) -> float:
    """Length of the longest of some vectors, shape (k, 2)."""
    return float(np.hypot(*vectors.T).max())


def sweep(dataset: xr.Dataset, name: str) -> list[float | str]:
    """Values of a swept dimension.

    Raises
    ------
    NotComputed
        If there are fewer than two.
    """
    if name not in dataset.dims or dataset.sizes[name] < 2:
        raise NotComputed(f"the dataset compares no two values of {name}")
    return [value.item() for value in dataset[name].values]


def apex(body: xr.Dataset) -> int:
    """Node of least height."""
    return int(np.argmin(body["base_gap"].values))
