"""The bodies of a finite-element study's dataset: one a combination of what is swept and the load."""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
import xarray as xr

from softlub.figures import style
from softlub.figures.quantities import FloatArray, quantity

MOST_BODIES = 4
"""Bodies that one figure tells apart."""
NAMES = {
    "mean_dilatation": "mean dilatation",
    "reduced_integration": "reduced integration",
    "full_integration": "full integration",
    "specimen_5_4": "linear elastic",
    "L_H": r"$L_\mathrm{H}$",
    "Y_H": r"$Y_\mathrm{H}$",
}
"""How a label of a study file reads in a figure."""
CLOSE = 1e-3
"""Relative difference up to which a wanted value is one of the dataset's."""


class Body(NamedTuple):
    """One body at the end of its steps, its nodes without those that only other meshes have.

    Parameters
    ----------
    label : str
        What tells it from the others; empty where there is one.
    data : xarray.Dataset
    position : int
    """

    label: str
    data: xr.Dataset
    position: int

    @property
    def x(self) -> FloatArray:
        """Places of the nodes of the unloaded contact edge along the plate [m], shape (k,)."""
        return np.asarray(self.data["x"].values, dtype=float)

    @property
    def converged(self) -> bool:
        """Whether all steps were gone through."""
        return bool(self.data["converged"])

    def named(self, text: str) -> str:
        """A series of this body in a legend."""
        return f"{self.label}: {text}" if self.label else text

    def reached(self, values: FloatArray) -> FloatArray:
        """Values [SI], NaN where the body did not get to the end: its last state is not what was asked for."""
        return values if self.converged else np.full_like(values, np.nan)


def bodies(dataset: xr.Dataset, chosen: Mapping[str, float | None] | None = None) -> list[Body]:
    """All bodies of a dataset, in the order of its dimensions.

    Parameters
    ----------
    dataset : xarray.Dataset
        Of a study of the kind solid.
    chosen : mapping, optional
        Dimension -> the one value wanted [SI]; None for all of them.

    Returns
    -------
    list of Body

    Raises
    ------
    ValueError
        If the dataset lacks a wanted value, or holds more bodies than a figure tells apart.
    """
    for name, wanted in (chosen or {}).items():
        if wanted is not None and name in dataset.dims:
            dataset = dataset.isel({name: _place(dataset, name, wanted)})
    swept = [str(name) for name in dataset["converged"].dims]
    choices = list(itertools.product(*(range(dataset.sizes[name]) for name in swept)))
    if len(choices) > MOST_BODIES:
        raise ValueError(
            f"the figure would show {len(choices)} bodies and tells {MOST_BODIES} apart; choose one "
            "friction or load by the figure's options, or sweep fewer values"
        )
    found = []
    for position, choice in enumerate(choices):
        picked = dict(zip(swept, choice, strict=True))
        varied = [name for name in swept if dataset.sizes[name] > 1]
        label = ", ".join(_label(dataset, name, picked[name]) for name in varied)
        found.append(Body(label, trimmed(dataset.isel(picked)), position))
    return found


def trimmed(one: xr.Dataset) -> xr.Dataset:
    """One body without the nodes, points and cells that only the meshes of others have."""
    if "node" in one.dims and "x" in one:
        one = one.isel(node=np.flatnonzero(np.isfinite(one["x"].values)))
    if "mesh_cell" not in one:
        return one
    places = {
        "cell": one["mesh_cell"].values[:, 0] >= 0,
        "edge_node": one["mesh_edge"].values >= 0,
        "held_node": one["mesh_held"].values >= 0,
        "mesh_node": np.isfinite(one["mesh_point"].values[:, 0]),
    }
    kept = one.isel({name: np.flatnonzero(there) for name, there in places.items()})
    return kept.assign({name: kept[name].astype(int) for name in ("mesh_cell", "mesh_edge", "mesh_held")})


def one_body(dataset: xr.Dataset, friction: float | None = None, load: float | None = None) -> Body:
    """The body that a drawing of one body shows.

    Parameters
    ----------
    dataset : xarray.Dataset
    friction, load : float, optional
        Which one where several were swept [1], [N/m]; without them the first friction and the heaviest load.

    Returns
    -------
    Body
        Its label says nothing.

    Raises
    ------
    ValueError
        If the dataset lacks them.
    """
    return Body("", trimmed(chosen_scene(dataset, {"friction": friction, "load": load})), 0)


def chosen_scene(
    dataset: xr.Dataset, wanted: Mapping[str, float | str | None], apart: Sequence[str] = ()
) -> xr.Dataset:
    """One combination of what is swept: the wanted values, else the first, and the heaviest load.

    Parameters
    ----------
    dataset : xarray.Dataset
    wanted : mapping
        Dimension -> value [SI] or label; None or empty for any.
    apart : sequence of str
        Dimensions that stay.

    Returns
    -------
    xarray.Dataset

    Raises
    ------
    ValueError
        If the dataset lacks a wanted value.
    """
    for name in map(str, dataset["converged"].dims):
        if name not in apart:
            value = wanted.get(name)
            default = dataset.sizes[name] - 1 if name == "load" else 0
            dataset = dataset.isel({name: _place(dataset, name, value) if value or value == 0 else default})
    return dataset


def with_mesh(
    dataset: xr.Dataset, friction: float | None = None, load: float | None = None
) -> tuple[xr.Dataset, list[str]]:
    """The mesh of one body of a study, and sentences on which body it is; a mesh by itself stays as it is.

    Raises
    ------
    ValueError
        If the dataset lacks that friction or load, or keeps no mesh.
    """
    if "converged" not in dataset:
        return dataset, []
    if "mesh_point" not in dataset:
        raise ValueError("the dataset keeps no mesh; add outputs: [mesh] to the study")
    body = one_body(dataset, friction, load)
    scene = {"load": ("W", " N/m"), "friction": ("μ", "")}
    known = [
        # Through a float, since 120000 reads better than 1.2e+05.
        f"{symbol} = {float(f'{float(body.data[name]):.4g}'):g}{unit}"
        for name, (symbol, unit) in scene.items()
        if name in body.data.coords
    ]
    under = [f"Drawn at {', '.join(known)}."] if known else []
    return body.data, under + stopped([body], "the last state that it reached is drawn")


def _place(dataset: xr.Dataset, name: str, wanted: float | str) -> int:
    if isinstance(wanted, str):
        labels = [str(label) for label in dataset[name].values]
        if wanted not in labels:
            raise ValueError(f"the dataset holds no {name} {wanted}, only {', '.join(labels)}")
        return labels.index(wanted)
    values = np.asarray(dataset[name].values, dtype=float)
    place = int(np.argmin(np.abs(values - wanted)))
    if abs(values[place] - wanted) > CLOSE * abs(wanted):
        listed = ", ".join(f"{value:g}" for value in values)
        raise ValueError(
            f"the dataset holds no {name} = {wanted:g}, only {listed}; add it to the study's grid"
        )
    return place


def _label(dataset: xr.Dataset, name: str, place: int) -> str:
    if name not in dataset.coords:
        return f"{name.replace('_', ' ')} {place + 1}"
    value = dataset[name].values[place]
    if isinstance(value, str):
        return readable(value)
    axis = quantity(name, unit=dataset[name].attrs.get("units"))
    symbols = {"friction": "μ", "load": "W"}
    if name == "edge_nodes":
        return f"{value:.0f} edge nodes"
    return f"{symbols.get(name, axis.label)} = {axis.text(float(value))}"


def readable(label: str) -> str:
    """A label of a study file as a reader of the figure expects it."""
    return NAMES.get(label, label.replace("_", " "))


def stopped(everyone: Sequence[Body], drawn: str = "it is not drawn") -> list[str]:
    """A sentence for each body that did not get to the end of its steps, with the reason."""
    return [
        f"{style.plain(body.label) or 'The body'} stopped before the end, {drawn}: "
        f"{str(body.data['stop_reason'].values).rstrip('.')}."
        for body in everyone
        if not body.converged
    ]
