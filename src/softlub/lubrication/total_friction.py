"""The solid part of friction, once the shear strength is known, and the sum of both parts (3-31, 3-32, 3-38)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from softlub.datasets.store import describe

if TYPE_CHECKING:
    import xarray as xr


def with_total_friction(dataset: xr.Dataset, shear_strength: xr.DataArray) -> xr.Dataset:
    """Add the solid and the total friction coefficient, and the latter's estimated error where there is one.

    Parameters
    ----------
    dataset : xarray.Dataset
        With ``friction_coefficient_fluid``, ``real_contact_width`` and ``load``.
    shear_strength : xarray.DataArray
        σ1 of the real contact [Pa], over any of the dataset's dimensions.

    Returns
    -------
    xarray.Dataset
    """
    per_width = shear_strength / dataset["load"]
    solid = per_width * dataset["real_contact_width"]
    derived = {
        "shear_strength": shear_strength,
        "friction_coefficient_solid": solid,
        "friction_coefficient": dataset["friction_coefficient_fluid"] + solid,
    }
    if "real_contact_width_error" in dataset:
        derived["friction_coefficient_error"] = (
            dataset["friction_coefficient_fluid_error"] + per_width * dataset["real_contact_width_error"]
        )
    order = dataset["separation_min"].dims
    # A sum keeps the attributes of its first term: what is derived gets those of the table instead.
    arranged = {
        name: value.transpose(*order, missing_dims="ignore").drop_attrs(deep=False)
        for name, value in derived.items()
    }
    return describe(dataset.assign(arranged))
