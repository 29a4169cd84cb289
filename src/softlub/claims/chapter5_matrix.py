"""Checks of chapter 5: elements, meshes and costs of the condensed matrix (5.3, 5.5.3, 5.7)."""

from __future__ import annotations

import numpy as np
import xarray as xr

from softlub.claims.reading import AGREEMENT
from softlub.claims.reading_solid import apex, displacement, largest, percent, scene, sweep
from softlub.claims.verdict import Datasets, NotComputed, Verdict, check, judge
from softlub.protocols import FloatArray

EMPTY = 1e-12
"""Entries below this part of the largest of their row count as empty."""
FAR = 20e-6
"""Distance from the apex beyond which entries of its row count as far [m]."""
FAR_LESS = 0.5
"""Cost of the reduced stiffness over that of finite elements below which it costs far less."""


def _matrix(body: xr.Dataset, study: str) -> xr.Dataset:
    if "stiffness_diagonal" not in body:
        raise NotComputed(f"study {study} holds no reduced stiffness")
    return body


@check("claim_5_02")
def small_and_full(datasets: Datasets) -> Verdict:
    """Size and filling of both matrices."""
    body = _matrix(scene(datasets("ch5-mesh")), "ch5-mesh")
    whole, reduced = int(body["degrees_of_freedom"]), 2 * body.sizes["node"]
    filling = float(body["stored_entries"]) / whole**2
    row = np.abs(body["stiffness_apex_row"].values)
    empty = int((row < EMPTY * row.max(axis=0)).sum())
    return judge(
        reduced < whole and filling < 0.05 and empty == 0,
        f"{whole} degrees of freedom with {percent(filling)} of the entries, condensed to {reduced}, of which {empty} "
        "in the row of the apex are empty",
        f"an entry below {EMPTY:g} of the largest of its row counts as empty, above 5 % filling a matrix is not sparse",
    )


def _pair(dataset: xr.Dataset, name: str) -> tuple[xr.Dataset, xr.Dataset]:
    """First and last body of a swept dimension."""
    values = sweep(dataset, name)
    return scene(dataset, where={name: values[0]}), scene(dataset, where={name: values[-1]})


def _apart(first: xr.Dataset, second: xr.Dataset, method: str) -> float:
    """Largest distance of two displacements at the first body's nodes, over the largest displacement."""
    one, other = displacement(first, method), displacement(second, method)
    x = second["x"].values
    there = np.stack([np.interp(first["x"].values, x, other[:, i]) for i in range(2)], axis=1)
    return largest(there - one) / largest(one)


@check("claim_5_09")
def integration_does_not_matter(datasets: Datasets) -> Verdict:
    """Entries of the matrix by both elements, and the displacement that they give."""
    first, second = _pair(datasets("ch5-elements"), "element")
    ratio = (_matrix(second, "ch5-elements")["stiffness_diagonal"] / first["stiffness_diagonal"]).values
    off = float(np.abs(np.median(ratio, axis=0) - 1).max())
    apart = _apart(first, second, "reduced")
    return judge(
        max(apart, off) <= AGREEMENT,
        f"displacements {percent(apart)} of the largest apart, as those by finite elements are "
        f"({percent(_apart(first, second, 'full'))}); diagonal entries {percent(off)}",
        f"the same within {percent(AGREEMENT)}; entries: median over the edge of the component that changes more. Both "
        "elements still err at this density of the mesh, and the stiffness follows its element",
    )


def _far(body: xr.Dataset) -> FloatArray:
    """Root mean square of the far entries in the row of the apex, by component."""
    distance = np.abs(body["x"].values - body["x"].values[apex(body)])
    row = body["stiffness_apex_row"].transpose("node", "component").values
    return np.asarray(np.sqrt(np.mean(row[distance > FAR] ** 2, axis=0)))


@check("claim_5_10")
def finer_is_softer(datasets: Datasets) -> Verdict:
    """Entries of the finer matrix over those of the coarser one."""
    coarse, fine = (_matrix(body, "ch5-mesh") for body in _pair(datasets("ch5-mesh"), "edge_nodes"))
    diagonal = np.array(
        [
            body["stiffness_diagonal"].transpose("node", "component").values[apex(body)]
            for body in (coarse, fine)
        ]
    )
    near, far = diagonal[1] / diagonal[0], _far(fine) / _far(coarse)
    return judge(
        bool(max(*near, *far) < 1),
        f"at the apex {near[1]:.2f} (vertical) and {near[0]:.2f} (lateral) times, far from it {far[1]:.2g} and "
        f"{far[0]:.2g} times",
        f"finer over coarser: the diagonal, and the root mean square of the entries beyond {1e6 * FAR:g} um in its "
        "row; far nodes share their force among more of them, a single node is held by its own cells",
    )


@check("claim_5_11")
def density_does_not_matter(datasets: Datasets) -> Verdict:
    """Displacement by both meshes."""
    coarse, fine = _pair(datasets("ch5-mesh"), "edge_nodes")
    reduced, full = (_apart(coarse, fine, method) for method in ("reduced", "full"))
    return judge(
        max(reduced, full) <= AGREEMENT,
        f"{percent(reduced)} of the largest displacement by the reduced stiffness, {percent(full)} by finite elements",
        f"alike within {percent(AGREEMENT)}; both meshes have as many rows, so that this is no estimate of the error",
    )


@check("claim_5_12")
def finer_takes_longer(datasets: Datasets) -> Verdict:
    """CPU time of the condensation."""
    coarse, fine = (_matrix(body, "ch5-mesh") for body in _pair(datasets("ch5-mesh"), "edge_nodes"))
    seconds = [float(body["condensation_seconds"]) for body in (coarse, fine)]
    freedoms = [int(body["degrees_of_freedom"]) for body in (coarse, fine)]
    return judge(
        seconds[1] > seconds[0],
        f"{seconds[0]:.2g} s for {freedoms[0]} degrees of freedom, {seconds[1]:.2g} s for {freedoms[1]}",
        "CPU time of making and condensing the matrix",
    )


@check("claim_5_24")
def far_cheaper(datasets: Datasets) -> Verdict:
    """CPU time of the condensation against that of one run of finite elements."""
    body = _matrix(scene(datasets("ch5-mesh")), "ch5-mesh")
    once, full = float(body["condensation_seconds"]), float(body["solver_seconds"])
    return judge(
        once <= FAR_LESS * full,
        f"{once:.2g} s to condense once, {full:.2g} s for one load by finite elements",
        f"far less: at most {FAR_LESS:g} times; each further displacement costs one product with the "
        f"inverse of {2 * body.sizes['node']} rows",
    )
