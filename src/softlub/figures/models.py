"""The bodies of a study of equivalents under one load: the viscoelastic one, the fitted one and those of given α."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
import xarray as xr

from softlub.figures.bodies import chosen_scene, trimmed
from softlub.figures.quantities import FloatArray

VISCOELASTIC = "viscoelastic"
CONDITIONS = ("load", "friction", "steps", "material")


class Model(NamedTuple):
    """One body of a study of equivalents.

    Parameters
    ----------
    name : str
        As the dataset has it.
    label : str
        For a legend.
    data : xarray.Dataset
    """

    name: str
    label: str
    data: xr.Dataset

    def along_edge(self, variable: str) -> dict[str, FloatArray]:
        """A variable over the edge by component, NaN where the body did not get to its end, shape (k,) each."""
        values = self.data[variable]
        ready = bool(self.data["converged"])
        return {
            name: np.asarray(values.sel(component=name).values)
            if ready
            else np.full(values.sizes["node"], np.nan)
            for name in ("x", "y")
        }


def models(dataset: xr.Dataset, wanted: Mapping[str, float | str | None]) -> list[Model]:
    """All bodies of one scene under one load, the viscoelastic one first.

    Parameters
    ----------
    dataset : xarray.Dataset
        Of a study of the kind equivalence.
    wanted : mapping
        Dimension -> value [SI], label or None, as `bodies.chosen_scene` takes it.

    Returns
    -------
    list of Model
    """
    one = chosen_scene(dataset, wanted, apart=("model",))
    names = [str(name) for name in one["model"].values]
    return [
        Model(name, _label(name, one.isel(model=i)), trimmed(one.isel(model=i)))
        for i, name in enumerate(names)
    ]


def _label(name: str, one: xr.Dataset) -> str:
    if name == VISCOELASTIC:
        return name
    if not np.isfinite(one["coefficient"]):
        return "hyperelastic, no α found"
    fitted = " (fitted)" if name == "fitted" else ""
    return f"hyperelastic, α = {float(one['coefficient']):.4g}{fitted}"


def scene_sentences(dataset: xr.Dataset, everyone: list[Model]) -> list[str]:
    """Under what the bodies were taken through their steps, which of them stopped early, and α under other steps."""
    data = everyone[0].data
    known = [_condition(data, name) for name in CONDITIONS if name in data.coords]
    found = [f"Drawn at {', '.join(known)}."] if known else []
    found += [
        f"The body {model.name} stopped before the end, it is not drawn: "
        f"{str(model.data['stop_reason'].values).rstrip('.')}."
        for model in everyone
        if not bool(model.data["converged"])
    ]
    over = [str(name) for name in dataset["converged"].dims if dataset.sizes[name] > 1 and name != "model"]
    if not over:
        return found
    fitted = dataset["coefficient"].sel(model="fitted")
    each = []
    for place in np.ndindex(fitted.shape):
        one = fitted[place]
        words = ", ".join(_condition(one, name) for name in over if name in one.coords)
        each.append(f"{float(one):.4g} ({words})" if np.isfinite(one) else f"none found ({words})")
    return [*found, f"Fitted α: {', '.join(each)}."]


def _condition(data: xr.Dataset | xr.DataArray, name: str) -> str:
    value = data[name].values.item()
    value = value.replace(" us", " µs") if isinstance(value, str) else value
    unit = {"load": " N/m"}.get(name, "")
    symbol = {"load": "W = ", "friction": "μ = ", "steps": "steps of ", "material": "material "}.get(
        name, f"{name} "
    )
    return f"{symbol}{value if isinstance(value, str) else format(value, 'g')}{unit}"
