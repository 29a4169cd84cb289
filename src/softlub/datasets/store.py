"""Reading and writing datasets: one format, written whole or not at all.

netCDF refuses booleans, None and nested attributes; they travel as small integers and JSON. A file is written
beside its name and renamed, so that a killed job leaves none behind that looks finished.
"""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from softlub.datasets.variables import FLAGS, VARIABLES


def describe(dataset: xr.Dataset) -> xr.Dataset:
    """Give every known variable its units, meaning and equation from the one table.

    Parameters
    ----------
    dataset : xarray.Dataset

    Returns
    -------
    xarray.Dataset
        A shallow copy with attributes.
    """
    described = dataset.copy()
    for name, variable in described.variables.items():
        if name in VARIABLES:
            variable.attrs = {**VARIABLES[str(name)].attributes, **variable.attrs}
    if "flags" in described:
        described["flags"].attrs.update(
            flag_masks=np.array(list(FLAGS.values()), dtype=np.int32), flag_meanings=" ".join(FLAGS)
        )
    return described


def write(
    dataset: xr.Dataset, path: str | os.PathLike[str], attributes: dict[str, Any] | None = None
) -> None:
    """Write a dataset as compressed netCDF-4, atomically.

    Parameters
    ----------
    dataset : xarray.Dataset
    path : path-like
    attributes : dict, optional
        Global attributes; what is not a string or a number is stored as JSON.
    """
    target = Path(path)
    target.parent.mkdir(parents=True, exist_ok=True)
    storable = describe(dataset)
    encoding = {}
    for name, variable in storable.variables.items():
        if variable.dtype == bool:
            storable[name] = storable[name].astype(np.int8)
        if np.issubdtype(variable.dtype, np.number) and variable.ndim:
            encoding[name] = {"zlib": True, "complevel": 4}
    storable.attrs = {name: _plain(value) for name, value in {**dataset.attrs, **(attributes or {})}.items()}
    partial = target.with_name(f".{target.name}.{os.getpid()}.part")
    try:
        storable.to_netcdf(partial, engine="netcdf4", encoding=encoding)
        os.replace(partial, target)
    finally:
        partial.unlink(missing_ok=True)


def read(path: str | os.PathLike[str]) -> xr.Dataset:
    """Read a dataset wholly into memory; `converged` comes back as booleans.

    Parameters
    ----------
    path : path-like

    Returns
    -------
    xarray.Dataset
    """
    with xr.open_dataset(path, engine="netcdf4") as stored:
        dataset = stored.load()
    # A dimension without entries is one of any length to netCDF, which nothing made of the dataset needs to be.
    dataset.encoding.pop("unlimited_dims", None)
    if "converged" in dataset:
        dataset["converged"] = dataset["converged"].astype(bool)
    return dataset


def _plain(value: Any) -> str | int | float:
    if isinstance(value, (str, int, float)) and not isinstance(value, bool):
        return value
    return json.dumps(value, sort_keys=True)
