"""The source's own algorithm: conjugate gradients as Polonsky and Keer (1999) wrote them, its section 4.5.

It stays as a named alternative to `solve`, for comparison: with the same convolutions it needs many times as many
of them, the more so the nearer to full contact.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from softlub.contact.rough_surface import Scales, check_pressure, scaled_heights, scales
from softlub.contact.solution import ContactSolution
from softlub.contact.solver.compliance import Compliance, FreeCompliance, PeriodicCompliance
from softlub.contact.summation import SummedCompliance
from softlub.surfaces.topography import Topography

FloatArray = NDArray[np.float64]

SOURCE_CHANGE = 1e-10
"""The source's criterion, equation 4-47: relative change of the pressure in one iteration."""


def solve_polonsky_keer(
    topography: Topography,
    modulus: float,
    pressure: float,
    tolerance: float = 1e-6,
    change: float = SOURCE_CHANGE,
    iterations: int = 10_000,
    summation: bool = False,
) -> ContactSolution:
    """Contact of a rough surface at one nominal pressure, by the source's equations 4-35 to 4-47.

    Iterates until either the residual that `solve` uses or the source's change of the pressure is reached; the
    solution counts as converged by the residual only, since a small change is no proof of a small error.

    Parameters
    ----------
    topography : Topography
        Periodic surfaces take the periodic compliance, others DC-FFT on a grid padded to twice its size.
    modulus : float
        E* [Pa].
    pressure : float
        Nominal pressure [Pa].
    tolerance : float
        Root mean square gap over the contact, over h_rms; 0 to stop on `change` alone.
    change : float
        Σ |p - p_old| / Σ p (equation 4-47); 0 to stop on `tolerance` alone.
    iterations : int
        Iterations at most.
    summation : bool
        Sum all influences directly instead of by transforms; not for periodic surfaces.

    Returns
    -------
    ContactSolution

    Raises
    ------
    ValueError
        As `solve` does; for direct summation on a periodic surface, and for a pressure of 0.
    """
    check_pressure(pressure)
    if pressure == 0:
        raise ValueError("the source's algorithm needs a load: pressure must be above 0 Pa")
    units = scales(topography, modulus)
    heights = scaled_heights(topography, units.height)
    convolution = _convolution(topography, summation)
    found, gap, residuals = _iterate(
        convolution, heights, pressure / units.pressure, tolerance, change, iterations
    )
    return ContactSolution(
        **_in_units(found, gap, heights, units),
        nominal_pressure=pressure,
        periodic=topography.periodic,
        full_contact=bool((found > 0).all()),
        converged=residuals[-1] <= tolerance,
        iterations=len(residuals) - 1,
        convolutions=convolution.count,
        residual=residuals[-1],
        residuals=tuple(residuals),
    )


def _in_units(pressure: FloatArray, gap: FloatArray, heights: FloatArray, units: Scales) -> dict[str, Any]:
    """Pressure, gap above the contact level and rigid approach, no longer dimensionless."""
    level = float(gap.mean(where=pressure > 0))
    return {
        "pressure": pressure * units.pressure,
        "gap": (gap - level) * units.height,
        "rigid_approach": (float(heights.max()) + level) * units.height,
    }


def _convolution(topography: Topography, summation: bool) -> Compliance:
    shape = (topography.heights.shape[0], topography.heights.shape[1])
    if not summation:
        kind = PeriodicCompliance if topography.periodic else FreeCompliance
        return kind(shape, np.float64)
    if topography.periodic:
        raise ValueError(
            "direct summation is for surfaces that are not periodic: use periodic=False or transforms"
        )
    return SummedCompliance(shape)


def _iterate(
    convolution: Compliance,
    heights: FloatArray,
    mean: float,
    tolerance: float,
    change: float,
    iterations: int,
) -> tuple[FloatArray, FloatArray, list[float]]:
    """Steps 1 to 8 of section 4.5; pressure, gap and residuals."""
    pressure = np.full(heights.shape, mean)
    direction = np.zeros(heights.shape)
    old_square, conjugate = 1.0, 0.0
    residuals: list[float] = []
    while True:
        gap = _displacement(convolution, pressure) - heights  # 4-35
        carrying = pressure > 0
        deviation = gap - gap.mean(where=carrying)  # 4-36
        free = carrying | (deviation < 0)
        residuals.append(float(np.sqrt(np.mean(deviation**2, where=free))))
        if residuals[-1] <= tolerance or len(residuals) > iterations:
            return pressure, gap, residuals
        square = float(np.sum(deviation**2, where=carrying))  # 4-37
        direction = np.where(carrying, deviation + conjugate * (square / old_square) * direction, 0)  # 4-38
        old_square = square
        response = _displacement(convolution, direction)  # 4-39
        response -= response.mean(where=carrying)  # 4-40
        curvature = float(np.sum(response * direction, where=carrying))
        if curvature <= 0:  # a single point in contact, or nothing left to change
            return pressure, gap, residuals
        step = float(np.sum(deviation * direction, where=carrying)) / curvature  # 4-41
        new = np.maximum(np.where(carrying, pressure - step * direction, 0), 0)  # 4-42
        overlapping = (new == 0) & (deviation < 0)  # 4-43
        conjugate = 0.0 if overlapping.any() else 1.0
        new[overlapping] -= step * deviation[overlapping]  # 4-44
        new *= mean / new.mean()  # 4-45 and 4-46, the factor being W over F_n
        moved = float(np.abs(new - pressure).sum() / new.sum())  # 4-47
        pressure = new
        if moved <= change:
            tolerance = np.inf  # one more gap, and done


def _displacement(convolution: Compliance, pressure: FloatArray) -> FloatArray:
    convolution.source[:] = pressure
    convolution.apply()
    return convolution.result.copy()
