"""Reading what the checks of chapter 4 need out of the curves of rough contacts."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from softlub.claims.printed_surfaces import PrintedSurface, find, rows
from softlub.claims.printed_tables import STUDIES
from softlub.claims.verdict import Datasets, NotComputed
from softlub.datasets.contact_curves import ContactCurve, FloatArray, contact_curve

MEDIUM = 0.05
"""p/(E* h'rms) at which areas are compared."""
GAP = 0.1
"""Difference of u/h_rms up to which gaps "hardly" differ."""


class Row(NamedTuple):
    """A row of a table and its contact."""

    printed: PrintedSurface
    curve: ContactCurve


def table_curves(datasets: Datasets, table: str, fewest: int = 2, common: bool = False) -> list[Row]:
    """Contacts of those rows of a table that were run.

    Parameters
    ----------
    datasets : Datasets
    table : str
        ``"table_4_2"``.
    fewest : int
        Rows that must be there.
    common : bool
        Whether to keep the first realisation only, which all grids of one surface share.

    Returns
    -------
    list of Row
        In the table's order.

    Raises
    ------
    NotComputed
        If fewer rows were run.
    """
    dataset = datasets(STUDIES[table])
    found = []
    for printed in rows(table):
        surface = find(dataset, printed)
        if surface is not None:
            if common and "realisation" in surface.dims:
                surface = surface.isel(realisation=[0])
            found.append(Row(printed, contact_curve(surface)))
    if len(found) < fewest:
        raise NotComputed(f"{len(found)} surfaces of {table.replace('_', ' ')} were run, {fewest} are needed")
    return found


def points_of(found: list[Row]) -> str:
    """Points a side of each row, as text."""
    return ", ".join(str(row.printed.points) for row in found)


def reduced_pressure(curve: ContactCurve) -> FloatArray:
    """p/E*: the load that figures draw the gap over, shape (loads,)."""
    return curve.reduced_pressure


def normalised(curve: ContactCurve) -> FloatArray:
    """p/(E* h'rms), shape (loads,)."""
    return curve.load


def at(load: FloatArray, values: FloatArray, wanted: float) -> float:
    """A value between the loads, linear in the logarithm of the load.

    Raises
    ------
    NotComputed
        If the loads do not reach there, or those beside it failed.
    """
    known = np.isfinite(values)
    logarithm = np.log(load[known])
    if logarithm.size < 2 or not logarithm[0] - 1e-9 <= np.log(wanted) <= logarithm[-1] + 1e-9:
        raise NotComputed(f"no converged loads on both sides of {wanted:g}")
    return float(np.interp(np.log(wanted), logarithm, values[known]))


def relative_separation(curve: ContactCurve, pressure: float) -> float:
    """u/h_rms at p/E*."""
    return at(curve.reduced_pressure, curve.relative_separation(), pressure)


def largest_gap_difference(
    curves: list[ContactCurve], load: Callable[[ContactCurve], FloatArray]
) -> tuple[float, float]:
    """Largest difference of u/h_rms between curves at one load, over the loads that all of them have.

    Parameters
    ----------
    curves : list of ContactCurve
    load : callable
        What counts as the load: p/E* or p/(E* h'rms).

    Returns
    -------
    difference, load : float
        In parts of h_rms, and where.
    """
    lightest = max(float(load(curve)[0]) for curve in curves)
    heaviest = min(float(load(curve)[-1]) for curve in curves)
    if not lightest < heaviest:
        raise NotComputed("the curves have no loads in common")
    common = np.geomspace(lightest, heaviest, 60)
    gaps = np.array([[at(load(c), c.relative_separation(), p) for p in common] for c in curves])
    spread = np.ptp(gaps, axis=0)
    worst = int(np.argmax(spread))
    return float(spread[worst]), float(common[worst])


def numbers(values: list[float], digits: int = 3) -> str:
    """Values in a row, as text."""
    return ", ".join(f"{value:.{digits}g}" for value in values)
