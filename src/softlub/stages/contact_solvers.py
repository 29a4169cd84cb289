"""From the solver's part of a law's spec to a sweep of loads, the same dataset whichever solver it is."""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import xarray as xr

from softlub.contact import load_sweep
from softlub.contact.polonsky_keer import solve_polonsky_keer
from softlub.contact.solution import ContactSolution
from softlub.surfaces.topography import Topography

JUDGED = 1e-6
"""Residual of a converged contact where a solver was given no tolerance."""
SCALARS = (
    "mean_gap",
    "contact_area_ratio",
    "contact_area_ratio_pixel",
    "rigid_approach",
    "full_contact",
    "converged",
    "iterations",
    "convolutions",
    "residual",
    "load_error",
)


def descend(
    topography: Topography,
    pressures: np.ndarray,
    solver: Mapping[str, Any],
    thresholds: Sequence[float] = (),
    maps: bool = False,
) -> xr.Dataset:
    """Contact of one surface at several loads, from the heaviest down, for E* = 1 Pa.

    Parameters
    ----------
    topography : Topography
    pressures : ndarray, shape (n,)
        p/E*, in any order.
    solver : mapping
        ``name`` and settings.
    thresholds : sequence of float
        Gaps [m] below which points are counted, for comparison with the area under pressure.
    maps : bool
        Whether to keep pressure and gap at every point.

    Returns
    -------
    xarray.Dataset
        Over `load_step`, in the order given; `contact_area_ratio_gap` over `threshold` besides, maps over x and y.
        Separation and areas of a load that did not converge are NaN.
    """
    order = np.argsort(-pressures, kind="stable")
    rows: list[dict[str, Any]] = []
    clock = time.process_time()
    for solution in _solutions(topography, pressures[order], solver):
        row = {name: getattr(solution, name) for name in SCALARS}
        row["solver_seconds"] = time.process_time() - clock
        row["contact_area_ratio_gap"] = [float(np.mean(solution.gap < limit)) for limit in thresholds]
        if maps:
            row["contact_pressure"] = solution.pressure.astype(np.float32)
            row["gap"] = solution.gap.astype(np.float32)
        rows.append(row)
        clock = time.process_time()
    return _dataset([rows[place] for place in np.argsort(order)], topography, thresholds)


def _solutions(
    topography: Topography, falling: np.ndarray, solver: Mapping[str, Any]
) -> Iterator[ContactSolution]:
    if solver["name"] == "conjugate_gradients":
        yield from load_sweep.descend(topography, 1.0, falling, solver["tolerance"])
        return
    settings = {key: value for key, value in solver.items() if key != "name"}
    for pressure in falling:
        solution = solve_polonsky_keer(topography, 1.0, float(pressure), **settings)
        # Stopped by the change of the pressure alone, it is judged as every other contact is.
        limit = solver["tolerance"] or JUDGED
        yield replace(solution, converged=solution.residual <= limit)


def _dataset(rows: list[dict[str, Any]], topography: Topography, thresholds: Sequence[float]) -> xr.Dataset:
    columns = {name: np.array([row[name] for row in rows]) for name in rows[0]}
    columns["mean_separation"] = columns.pop("mean_gap")
    failed = ~columns["converged"]
    for name in ("mean_separation", "contact_area_ratio", "contact_area_ratio_pixel", "rigid_approach"):
        columns[name][failed] = np.nan
    extra = {
        "contact_area_ratio_gap": ("load_step", "threshold"),
        "contact_pressure": ("load_step", "x", "y"),
        "gap": ("load_step", "x", "y"),
    }
    if not thresholds:
        del columns["contact_area_ratio_gap"]
    dataset = xr.Dataset(
        {name: (extra.get(name, ("load_step",)), values) for name, values in columns.items()}
    )
    for name, points in zip(("x", "y"), topography.heights.shape, strict=True):
        if name in dataset.dims:
            dataset = dataset.assign_coords({name: topography.spacing * np.arange(points)})
    if thresholds:
        dataset = dataset.assign_coords(threshold=np.array(thresholds))
    return dataset
