"""Pieces of the datasets of finite-element studies: ends of states, displacements compared, a stiffness's entries."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import xarray as xr

from softlub.solid.contact_patch import reaches_end
from softlub.solid.reduced_stiffness import ReducedStiffness

PADDED = {"mesh_cell": -1, "mesh_edge": -1, "mesh_held": -1}
"""What stands in whole numbers where a mesh has fewer nodes or cells than another."""
ALONG = ("node", "component")
MESH = (
    "mesh_point",
    "mesh_displacement",
    "mesh_cell",
    "mesh_edge",
    "mesh_held",
    "stress_von_mises",
    "stress_vertical",
)
"""What ``outputs: [mesh]`` keeps of all nodes."""
HISTORY = (
    "step_number",
    "time",
    "applied_load",
    "applied_friction",
    "plate_height",
    "displacement",
    "nodal_force",
)
"""What ``outputs: [history]`` keeps of every increment."""
SAME = ("x", "node_width", "base_gap", "mesh_point", "mesh_cell", "mesh_edge", "mesh_held")
"""What a load leaves as it is."""


def final(state: xr.Dataset, keep: Sequence[str]) -> xr.Dataset:
    """A state as a study tells it: its last increment, and what was asked for besides.

    Parameters
    ----------
    state : xarray.Dataset
        As `softlub.stages.solid_state` writes it.
    keep : sequence of str
        ``history`` and ``mesh``.

    Returns
    -------
    xarray.Dataset
    """
    # A body that met its limit at once has no increment, and no displacement to tell.
    reached = state if state.sizes["increment"] else state.pad(increment=(1, 0))
    last = reached.drop_vars(["increment", "step"]).isel(increment=-1)
    # The load reached stands beside the load asked for: of a body that stopped they differ.
    told = (
        "displacement",
        "nodal_force",
        "applied_load",
        "applied_friction",
        "plate_height",
        "node_width",
        "base_gap",
    )
    end = last[list(told)]
    pressure = end["nodal_force"].sel(component="y", drop=True) / end["node_width"]
    dataset = end.assign(
        contact_pressure=pressure,
        converged=state["completed"] == 1,
        iterations=state["iterations"].sum(),
        increments=state.sizes["increment"],
        rejected_increments=state["rejected_increments"],
        residual=reached["residual"].max(),
        solver_seconds=state["solver_seconds"],
        stop_reason=state["stop_reason"],
        reaches_edge_end=int(reaches_end(end["nodal_force"].sel(component="y").values)),
    )
    if "mesh" in keep:
        dataset = dataset.assign({name: state[name] for name in MESH})
        numbered = ("mesh_node", "cell", "edge_node", "held_node")
        dataset = dataset.assign_coords({name: np.arange(state.sizes[name]) for name in numbered})
    if "history" in keep:
        dataset = dataset.assign({f"{name}_history": state[name] for name in HISTORY})
    # As a variable: nodes of other meshes lie elsewhere.
    return dataset.drop_vars("step", errors="ignore").reset_coords("x")


def over_loads(states: Sequence[xr.Dataset], loads: Sequence[float]) -> xr.Dataset:
    """States of one body under its loads; what the loads leave as it is has no such dimension."""
    return along(states, "load", loads)


def along(states: Sequence[xr.Dataset], dimension: str, labels: Sequence[Any]) -> xr.Dataset:
    """States of one mesh along a dimension, which what belongs to the mesh does not have."""
    same = [name for name in SAME if name in states[0].data_vars]
    rows = [state.drop_vars(same) for state in states]
    joined = xr.concat(
        rows,
        dim=xr.Variable(dimension, np.array(labels)),
        join="outer",
        data_vars="all",
        coords="minimal",
    )
    return joined.assign(states[0][same].data_vars)


def compared(
    found: Mapping[Any, np.ndarray], dimension: str, name: str = "displacement"
) -> dict[str, xr.DataArray]:
    """Displacements along a dimension, and how far each is from the first.

    Parameters
    ----------
    found : mapping
        Label -> displacement [m], shape (k, 2).
    dimension, name : str
        Of the labels and of the displacement.

    Returns
    -------
    dict of str to DataArray
        The displacement; ``<name>_error``, the longest difference from the first over its longest displacement;
        ``<name>_error_component``, the same of each component by itself. The first has no error, but NaN.
    """
    values = np.array(list(found.values()))
    first, others = values[0], values - values[0]
    others[0] = np.nan
    coordinates = {dimension: list(found)}
    with np.errstate(invalid="ignore", divide="ignore"):
        length = np.hypot(others[..., 0], others[..., 1]).max(axis=1) / np.hypot(*first.T).max()
        component = np.abs(others).max(axis=1) / np.abs(first).max(axis=0)
    return {
        name: xr.DataArray(values, coordinates, (dimension, *ALONG)),
        f"{name}_error": xr.DataArray(length, coordinates, (dimension,)),
        f"{name}_error_component": xr.DataArray(component, coordinates, (dimension, "component")),
    }


def reduced_displacement(reduced: ReducedStiffness, forces: np.ndarray) -> np.ndarray:
    """Displacement under nodal forces [m], shape (k, 2); NaN where the forces or the stiffness are not known."""
    if not (np.all(np.isfinite(forces)) and np.all(np.isfinite(reduced.stiffness))):
        return np.full_like(forces, np.nan)
    return reduced.displacement(forces)


def stiffness_entries(stiffness: xr.Dataset) -> xr.Dataset:
    """Entries of a reduced stiffness worth looking at, and what it was condensed from."""
    matrix = stiffness["stiffness"].values
    nodes = np.arange(matrix.shape[0])
    apex = int(np.argmin(stiffness["base_gap"].values))
    diagonal = np.stack([matrix[nodes, i, nodes, i] for i in range(2)], axis=1)
    row = np.stack([matrix[apex, i, :, i] for i in range(2)], axis=1)
    return xr.Dataset(
        {
            "stiffness_diagonal": (ALONG, diagonal),
            "stiffness_apex_row": (ALONG, row),
            "degrees_of_freedom": stiffness["degrees_of_freedom"],
            "stored_entries": stiffness["stored_entries"],
            "condensation_seconds": stiffness["solver_seconds"],
        },
        coords={"node": nodes, "component": stiffness["component"].values},
    )
