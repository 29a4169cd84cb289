"""Condensing the triangular specimen onto its contact edge: time and rounding of three ways over the mesh's size."""

import numpy as np
import xarray as xr
from condensation_methods import METHODS
from measuring import cpu_seconds
from scipy import linalg, sparse
from scipy.sparse.linalg import splu

from softlub.figures import style
from softlub.figures.panel import DataFigure, Panel, new_figure, share_legend, styled
from softlub.figures.quantities import quantity
from softlub.solid.body import Body
from softlub.solid.materials.neo_hookean import NeoHookean
from softlub.solid.shapes.density import MeshDensity
from softlub.solid.shapes.triangle import TriangularSpecimen

MESHES = ((65, 11), (129, 11), (257, 11), (513, 11), (1025, 11), (513, 20), (513, 40), (1025, 20))
"""Edge nodes and rows; the first five share the rows of `standard`."""
ROWS = 11
EDGE_NODES = 513
REPEATS = 3
LONGEST_METHOD = "many right-hand sides"
MOST_KEPT = 1026
"""Degrees of freedom beyond which the longest method is left out."""
MATERIAL = NeoHookean(c10=0.5932e6, d1=1e-9)
LOAD, FRICTION, HALF_WIDTH = 17.0, 0.4, 30e-6
LIMITS = {"seconds": (1e-2, 1e1), "error": (1e-11, 1e-8)}
COLOURS = (style.BLUE, style.VERMILION, style.GREEN)


def measure() -> xr.Dataset:
    """One row a mesh and method."""
    rows = []
    for edge_nodes, mesh_rows in MESHES:
        matrix, kept, forces = _specimen(edge_nodes, mesh_rows)
        exact = _displacement(matrix, kept, forces)
        for method, condense in METHODS.items():
            if method == LONGEST_METHOD and kept.size > MOST_KEPT:
                continue
            found = linalg.solve(condense(matrix, kept), forces)
            rows.append(
                {
                    "method": method,
                    "edge_nodes": edge_nodes,
                    "rows": mesh_rows,
                    "degrees_of_freedom": matrix.shape[0],
                    "kept": kept.size,
                    "seconds": cpu_seconds(lambda: condense(matrix, kept), REPEATS, warm_up=False),  # noqa: B023
                    "error": np.max(np.abs(found - exact)) / np.max(np.abs(exact)),
                }
            )
    return xr.Dataset(
        {name: ("trial", np.array([row[name] for row in rows])) for name in rows[0]},
        attrs={
            "title": "Condensation of the triangular specimen onto its contact edge",
            "timed": f"CPU time, quickest of {REPEATS}; 'many right-hand sides' left out beyond {MOST_KEPT} kept",
            "error": "largest error of the edge's displacement at 17 N/m, friction 0.4, over the largest displacement, "
            "against the whole sparse system refined in extended precision",
        },
    )


def _specimen(edge_nodes: int, rows: int) -> tuple[sparse.csr_array, np.ndarray, np.ndarray]:
    """Tangent of the free degrees of freedom, those to keep, and forces on these like Hertz's."""
    mesh = TriangularSpecimen().mesh(MeshDensity(edge_nodes=edge_nodes, rows=rows))
    free = mesh.free_dofs
    tangent = sparse.csr_array(Body(mesh, MATERIAL).tangent())
    pressure = np.sqrt(np.maximum(1 - (mesh.edge_positions / HALF_WIDTH) ** 2, 0)) * mesh.edge_widths
    normal = LOAD * pressure / pressure.sum()
    forces = np.stack([FRICTION * normal, normal], axis=1).ravel()
    return sparse.csr_array(tangent[free][:, free]), np.searchsorted(free, mesh.edge_dofs), forces


def _displacement(matrix: sparse.csr_array, kept: np.ndarray, forces: np.ndarray) -> np.ndarray:
    """Of the kept degrees of freedom by the whole system, its residuals in extended precision."""
    right = np.zeros(matrix.shape[0])
    right[kept] = forces
    factors = splu(sparse.csc_array(matrix))
    solution = factors.solve(right).astype(np.longdouble)
    for _ in range(3):
        products = matrix.data.astype(np.longdouble) * solution[matrix.indices]
        residual = right - np.add.reduceat(products, matrix.indptr[:-1])
        solution += factors.solve(residual.astype(float))
    return solution[kept].astype(float)


def draw(dataset: xr.Dataset) -> DataFigure:
    """Time over the size with the edge refined (a) and with more rows (b); rounding over the size (c)."""
    size = quantity("degrees_of_freedom", label="free degrees of freedom", unit="1")
    time = quantity("seconds", label="CPU time", unit="s")
    error = quantity("error", label="relative error of the displacement", unit="1")
    with styled():
        figure = new_figure(style.PAGE, 2.8)
        axes = figure.subplots(1, 3)
        chosen = (dataset["rows"] == ROWS, dataset["edge_nodes"] == EDGE_NODES, dataset["rows"] == ROWS)
        panels = [Panel(*parts) for parts in zip(axes, (size,) * 3, (time, time, error), "abc", strict=True)]
        for panel, where, name in zip(panels, chosen, ("seconds", "seconds", "error"), strict=True):
            panel.letter(panel.name)
            panel.axes.set(xscale="log", yscale="log", xlim=(1e3, 1e5), ylim=LIMITS[name])
            for index, method in enumerate(METHODS):
                own = dataset.isel(trial=np.flatnonzero(where & (dataset["method"] == method)))
                panel.line(
                    method,
                    own["degrees_of_freedom"].values,
                    own[name].values,
                    color=COLOURS[index],
                    marker=style.MARKERS[index],
                )
        share_legend(figure, panels, 3)
        figure.notes.append(
            f"(a) and (c): {ROWS} rows, 65 to 1025 nodes on the edge; (b): {EDGE_NODES} nodes, 11, 20 and 40 rows."
        )
        return figure
