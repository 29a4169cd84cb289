"""A mesh, and a state of it, as a dataset for figures."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import xarray as xr

from softlub.solid.mesh import BodyMesh, FloatArray


def mesh_dataset(
    mesh: BodyMesh, displacement: FloatArray | None = None, fields: Mapping[str, FloatArray] | None = None
) -> xr.Dataset:
    """Put a mesh into a dataset.

    Parameters
    ----------
    mesh : BodyMesh
    displacement : ndarray, shape (n, 2), optional
        Of every node [m]; the mesh at rest without it.
    fields : mapping of str to ndarray, shape (m,), optional
        One value a cell, under the names that they get in the dataset [SI].

    Returns
    -------
    xarray.Dataset
        mesh_point and mesh_displacement over mesh_node and component, mesh_cell over cell and corner, mesh_edge over
        edge_node, mesh_held over held_node, and the fields over cell.
    """
    moved = np.zeros_like(mesh.points) if displacement is None else displacement
    variables = {
        "mesh_point": (("mesh_node", "component"), mesh.points),
        "mesh_displacement": (("mesh_node", "component"), moved),
        "mesh_cell": (("cell", "corner"), mesh.cells),
        "mesh_edge": (("edge_node",), mesh.edge),
        "mesh_held": (("held_node",), mesh.held),
        **{name: (("cell",), values) for name, values in (fields or {}).items()},
    }
    return xr.Dataset(variables, coords={"component": ["x", "y"]})
