"""Study of surfaces: their topographies joined along what is swept."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from softlub.datasets import store
from softlub.datasets.variables import FLAGS

INPUTS = ("hurst", "rolloff", "cutoff", "long_cutoff", "size", "points", "seed")
"""What a synthetic surface was made from, beside the statistics that it has."""

FILL: dict[str, Any] = {
    "converged": False,
    "full_contact": 0,
    "iterations": 0,
    "convolutions": 0,
    "flags": FLAGS["not_attempted"],
}
"""What stands in variables that are no floating-point numbers where nothing was attempted; NaN elsewhere."""

Spec = Mapping[str, Any]


def run(spec: Spec, inputs: Mapping[str, Sequence[Path]], outputs: Sequence[Path]) -> None:
    """Join the topographies and write the study's dataset.

    Parameters
    ----------
    spec : mapping
        Canonical spec of the node: sweeps, surfaces (asked for and made), topographies (which of the inputs are each
        surface's).
    inputs : mapping
        ``topography``: files in the plan's order.
    outputs : sequence of Path
        The dataset.
    """
    read = [store.read(path).drop_attrs(deep=False) for path in inputs.get("topography", ())]
    rows = [
        xr.merge([described(surface), joined([read[index] for index in own])], compat="equals")
        for surface, own in zip(spec["surfaces"], spec["topographies"], strict=True)
    ]
    store.write(swept(rows, spec["sweeps"]), outputs[0], dict(spec))


def described(surface: Mapping[str, Any]) -> xr.Dataset:
    """Inputs of a surface as it was made, or as it was asked for where it was not; and how often it was made."""
    made = surface["made"]
    known = made or surface["asked"]
    values = {name: float(known[name]) for name in INPUTS if known.get(name) is not None}
    if "rolloff" in values:
        values.setdefault("long_cutoff", values["rolloff"])
    count = 0 if made is None else made.get("realisations", 1)
    return xr.Dataset({**values, "realisations": count})


def joined(pieces: Sequence[xr.Dataset]) -> xr.Dataset:
    """Realisations of one surface along their dimension, which a single one does without; heights of the first alone.

    A line among them, which has no realisations, stays as it is.
    """
    lines = [piece for piece in pieces if "position" in piece.dims]
    areas = [piece for piece in pieces if "position" not in piece.dims]
    heights = [piece[["height"]] for piece in areas[:1] if "height" in piece]
    bare = [piece.drop_vars(["height", "x", "y"], errors="ignore") for piece in areas]
    together = [realised(bare)] if len(bare) > 1 else bare
    return xr.merge([*together, *heights, *lines], join="outer", compat="equals")


def realised(pieces: Sequence[xr.Dataset]) -> xr.Dataset:
    """Pieces of one surface along their own dimension."""
    numbers = xr.Variable("realisation", np.arange(len(pieces)))
    return xr.concat(pieces, dim=numbers, join="outer", data_vars="all")


def swept(
    rows: Sequence[xr.Dataset], sweeps: Sequence[Mapping[str, Any]], fill: Mapping[str, Any] | None = None
) -> xr.Dataset:
    """Datasets of all combinations along the swept dimensions.

    Parameters
    ----------
    rows : sequence of xarray.Dataset
        The last dimension varying fastest.
    sweeps : sequence of mapping
        ``dimension`` and ``labels`` of each swept field.
    fill : mapping, optional
        Variable -> what stands where a row lacks it, besides those of `FILL`.

    Returns
    -------
    xarray.Dataset
        What a surface lacks is NaN, whole numbers 0.
    """
    rows = _with_realisations(rows)
    for sweep in reversed(sweeps):
        count = len(sweep["labels"])
        labels = xr.Variable(sweep["dimension"], np.array(sweep["labels"]))
        # A swept parameter is its own coordinate already.
        bare = [row.drop_vars(sweep["dimension"], errors="ignore") for row in rows]
        rows = [
            xr.concat(
                bare[first : first + count],
                dim=labels,
                join="outer",
                fill_value={**FILL, **(fill or {})},
                data_vars="all",
                coords="minimal",
            )
            for first in range(0, len(bare), count)
        ]
    return store.describe(rows[0])


def _with_realisations(rows: Sequence[xr.Dataset]) -> list[xr.Dataset]:
    """Rows of which none or all have realisations: a single one becomes the first."""
    varying = {name for row in rows for name in row.data_vars if "realisation" in row[name].dims}
    return [
        row.assign(
            {
                name: row[name].expand_dims(realisation=[0])
                for name in varying
                if name in row and "realisation" not in row[name].dims
            }
        )
        for row in rows
    ]
