"""Study: its panels joined, the shear strength applied, and what follows from the two."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from softlub.datasets import store
from softlub.datasets.variables import FLAGS
from softlub.lubrication.total_friction import with_total_friction

NOT_ATTEMPTED = {"flags": FLAGS["not_attempted"], "converged": False, "iterations": 0}
"""What stands in the integer variables of a point that a solver was not asked for; elsewhere it is NaN."""


def run(spec: Mapping[str, Any], inputs: Mapping[str, Sequence[Path]], outputs: Sequence[Path]) -> None:
    """Join the panels and write the study's dataset.

    Parameters
    ----------
    spec : mapping
        Canonical spec of the node: shear_strength, solvers (a label for each panel), left_out (variables that
        nobody asked for), and what the dataset is to tell of itself.
    inputs : mapping
        ``panel``: the panels' files, in the plan's order.
    outputs : sequence of Path
        The dataset.
    """
    joined = join([store.read(path) for path in inputs["panel"]], spec["solvers"])
    dataset = with_scales(with_total_friction(joined, shear_strength(joined, spec["shear_strength"])))
    kept = dataset.drop_vars(spec["left_out"], errors="ignore")
    store.write(kept.drop_attrs(deep=False), outputs[0], dict(spec))


def join(panels: Sequence[xr.Dataset], solvers: Sequence[str]) -> xr.Dataset:
    """One dataset of all panels: along `sample` where they are chunks of a design, else along `solver`.

    Parameters
    ----------
    panels : sequence of xarray.Dataset
    solvers : sequence of str
        Label of each panel's solver.

    Returns
    -------
    xarray.Dataset
    """
    if len(panels) == 1:
        return panels[0]
    if "sample" in panels[0].dims:
        return xr.concat(panels, dim="sample", join="outer", data_vars="minimal", combine_attrs="drop")
    # Nodes have no labels to be aligned by, so they are made equal in number first.
    everywhere = xr.align(*_pad_nodes(panels), join="outer", fill_value=NOT_ATTEMPTED)
    solved = [name for name in everywhere[0].data_vars if _depends_on_solver(str(name), everywhere)]
    return xr.concat(
        everywhere,
        dim=xr.Variable("solver", np.array(solvers)),
        data_vars=solved,
        coords=[name for name in ("x",) if name in everywhere[0].coords],
        compat="equals",
        join="exact",
        combine_attrs="drop",
    )


def _depends_on_solver(name: str, panels: Sequence[xr.Dataset]) -> bool:
    """Whether a variable is a result, or an input that the solvers were given different values of."""
    first = panels[0][name]
    return "speed" in first.dims or not all(panel[name].equals(first) for panel in panels)


def _pad_nodes(panels: Sequence[xr.Dataset]) -> list[xr.Dataset]:
    """Solvers have grids of their own; the shorter ones are filled with NaN."""
    longest = max(panel.sizes.get("node", 0) for panel in panels)
    return [
        panel.pad(node=(0, longest - panel.sizes["node"]))
        if panel.sizes.get("node", longest) < longest
        else panel
        for panel in panels
    ]


def shear_strength(dataset: xr.Dataset, rule: Mapping[str, Any]) -> xr.DataArray:
    """Shear strength σ1 of the real contact [Pa], over whatever it depends on (equation 3-32).

    Parameters
    ----------
    dataset : xarray.Dataset
        Joined panels.
    rule : mapping
        ``{"modulus_fraction": f}`` of the long-term modulus, ``{"value": σ1}``, or ``{"table": {"over": "speed" or
        "load", "at": […], "value": […]}}``, interpolated linearly in the logarithm and held constant outside.

    Returns
    -------
    xarray.DataArray
    """
    if "modulus_fraction" in rule:
        return rule["modulus_fraction"] * dataset["long_term_modulus"]
    if "value" in rule:
        return xr.DataArray(rule["value"])
    table = rule["table"]
    over = dataset[table["over"]]
    return over.copy(data=np.interp(np.log(over), np.log(table["at"]), table["value"]))


def with_scales(dataset: xr.Dataset) -> xr.Dataset:
    """Add the Hersey number ηv and the lambda ratio, NaN where the surface is smooth.

    Parameters
    ----------
    dataset : xarray.Dataset
        Joined panels.

    Returns
    -------
    xarray.Dataset
    """
    roughness = dataset["rms_roughness"]
    derived = {
        "hersey_number": dataset["viscosity"] * dataset["speed"],
        "lambda_ratio": dataset["separation_min"] / roughness.where(roughness > 0),
    }
    order = dataset["separation_min"].dims
    # A sum keeps the attributes of its first term: what is derived gets those of the table instead.
    arranged = {
        name: value.transpose(*order, missing_dims="ignore").drop_attrs(deep=False)
        for name, value in derived.items()
    }
    return store.describe(dataset.assign(arranged))
