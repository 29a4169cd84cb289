"""The contact of one surface over many loads: from the heaviest down, each from what the last two foretell."""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from softlub.contact.rough_contact import RoughContact
from softlub.contact.rough_surface import check_pressure
from softlub.contact.solution import ContactSolution
from softlub.surfaces.topography import Topography


def descend(
    topography: Topography,
    modulus: float,
    pressures: Sequence[float] | NDArray[np.float64],
    tolerance: float = 1e-6,
) -> Iterator[ContactSolution]:
    """Contacts at falling nominal pressures, one after another; for maps and distributions of every load.

    Parameters
    ----------
    topography : Topography
    modulus : float
        E* [Pa].
    pressures : sequence of float
        Nominal pressures [Pa], in any order.
    tolerance : float
        As in `solve`.

    Yields
    ------
    ContactSolution
        In the order of falling pressure.

    Raises
    ------
    ValueError
        If a pressure is negative or not finite, or as `solve` does.
    """
    falling = sorted((float(pressure) for pressure in pressures), reverse=True)
    for pressure in falling:
        check_pressure(pressure)
    contact = RoughContact(topography, modulus, tolerance)
    last: ContactSolution | None = None
    before: ContactSolution | None = None
    for pressure in falling:
        start = None if last is None or pressure == 0 else foretell(pressure, last, before)
        before, last = last, contact.solve(pressure, start)
        yield last


def foretell(pressure: float, last: ContactSolution, before: ContactSolution | None) -> NDArray[np.float64]:
    """Pressure map at a lower load, linear in the logarithm of the load through the last two, never below 0.

    Parameters
    ----------
    pressure : float
        Nominal pressure to come [Pa].
    last, before : ContactSolution
        The last load's contact, and that of the load before it.

    Returns
    -------
    ndarray, shape (nx, ny)
    """
    if before is None or before.nominal_pressure == last.nominal_pressure:
        return last.pressure
    ratio = np.log(pressure / last.nominal_pressure) / np.log(last.nominal_pressure / before.nominal_pressure)
    expected = last.pressure + ratio * (last.pressure - before.pressure)
    np.maximum(expected, 0, out=expected)
    # a leap over many loads may foretell nothing
    return expected if expected.any() else last.pressure


def sweep(
    topography: Topography,
    modulus: float,
    pressures: Sequence[float] | NDArray[np.float64],
    tolerance: float = 1e-6,
) -> xr.Dataset:
    """Contact area and mean separation over nominal pressure.

    Parameters
    ----------
    topography : Topography
    modulus : float
        E* [Pa].
    pressures : sequence of float
        Nominal pressures [Pa], in any order.
    tolerance : float
        As in `solve`.

    Returns
    -------
    xarray.Dataset
        Over `pressure`, in the order given: `mean_separation`, `contact_area_ratio`, `contact_area_ratio_pixel`,
        `rigid_approach`, `full_contact`, `converged`, `iterations`, `convolutions`, `residual`, `load_error` and
        `solver_seconds`.

    Raises
    ------
    ValueError
        As `descend` does.
    """
    given = np.asarray(pressures, dtype=float)
    if given.ndim != 1 or given.size == 0:
        raise ValueError("pressures must be a sequence of at least one nominal pressure")
    rows = []
    clock = time.process_time()
    for solution in descend(topography, modulus, given, tolerance):
        rows.append({**_row(solution), "solver_seconds": time.process_time() - clock})
        clock = time.process_time()
    order = np.argsort(np.argsort(-given, kind="stable"), kind="stable")
    columns = {name: ("pressure", np.array([row[name] for row in rows])[order]) for name in rows[0]}
    return xr.Dataset(columns, coords={"pressure": given}, attrs={"modulus": modulus, "tolerance": tolerance})


def _row(solution: ContactSolution) -> dict[str, float | int | bool]:
    return {
        "mean_separation": solution.mean_gap,
        "contact_area_ratio": solution.contact_area_ratio,
        "contact_area_ratio_pixel": solution.contact_area_ratio_pixel,
        "rigid_approach": solution.rigid_approach,
        "full_contact": solution.full_contact,
        "converged": solution.converged,
        "iterations": solution.iterations,
        "convolutions": solution.convolutions,
        "residual": solution.residual,
        "load_error": solution.load_error,
    }
