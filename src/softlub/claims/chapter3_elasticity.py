"""Checks of chapter 3's printed equations for deflection, load and the modules' updates, against Hertz's contact."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from softlub.claims.chapter3_equations import HERTZ, MODULUS, _factor
from softlub.claims.verdict import Datasets, Verdict, check, judge

SPACING = HERTZ.half_width / 200
X = SPACING * np.arange(-400, 401)
PRESSURE = HERTZ.peak_pressure * np.sqrt(np.clip(1 - (X / HERTZ.half_width) ** 2, 0, None))
"""Hertz's pressure on an even grid."""


def _antiderivative(distance: NDArray[np.float64]) -> NDArray[np.float64]:
    """∫ ln|s| ds = s (ln|s| - 1), 0 at 0."""
    size = np.abs(distance)
    return distance * (np.log(np.where(size > 0, size, 1.0)) - 1)


def _kernel() -> NDArray[np.float64]:
    """K_ij of equation 3-16."""
    distance = X[:, None] - X[None, :]
    return _antiderivative(distance + SPACING / 2) - _antiderivative(distance - SPACING / 2)


def _flattening(deflection: NDArray[np.float64]) -> float:
    """Deflection at the centre less that half-way to the edge; it must undo x²/(2R) there."""
    return float(deflection[X.size // 2 + 100] - deflection[X.size // 2])


NEEDED = -((HERTZ.half_width / 2) ** 2) / (2 * HERTZ.radius)
"""What the deflection must do between centre and half-way for a flat contact [m]."""


@check("eq_3_14")
def squared_logarithm(datasets: Datasets) -> Verdict:
    """The printed deflection under Hertz's pressure against the parabola that it must undo."""
    printed = -2 / (np.pi * MODULUS) * 2 * (_kernel() @ PRESSURE)
    return _factor(
        NEEDED, _flattening(printed), "Hertz's pressure must flatten the parabola; printed form is too soft"
    )


@check("eq_3_16")
def influence_coefficient(datasets: Datasets) -> Verdict:
    """Deflection by 3-15 with this coefficient against the parabola."""
    right = -2 / (np.pi * MODULUS) * (_kernel() @ PRESSURE)
    return _factor(NEEDED, _flattening(right), "Hertz's pressure flattens the parabola with it")


@check("eq_3_17")
def missing_pi(datasets: Datasets) -> Verdict:
    """The printed factor 2/E against the parabola."""
    printed = -2 / MODULUS * (_kernel() @ PRESSURE)
    return _factor(
        NEEDED, _flattening(printed), "Hertz's pressure must flatten the parabola; 1/pi is missing"
    )


@check("eq_3_19")
def load_factor(datasets: Datasets) -> Verdict:
    """What the printed factor 0.1 moves for a load that is off by one part in a hundred."""
    moved = 0.1 * 0.01 * HERTZ.load
    return judge(
        moved < HERTZ.gap_scale,
        f"moves the body by {moved:.1g} m, {moved / HERTZ.gap_scale:.0e} times the indentation a2/R",
        "the factor must carry m per N/m; with the printed 0.1 of table 3-2 and 1 % of load missing",
    )


@check("eq_3_23")
def rigid_approach(datasets: Datasets) -> Verdict:
    """The deflection at the centre, which lies between u(0) and the rigid approach."""
    centre = -2 / (np.pi * MODULUS) * float((_kernel() @ PRESSURE)[X.size // 2])
    return judge(
        abs(centre) < 1e-3 * HERTZ.gap_scale,
        f"w(0) = {centre * 1e6:.3g} µm",
        "the law gives the separation at the centre; the rigid approach is u(0) - w(0)",
    )


@check("eq_3_24")
def sweep_residual(datasets: Datasets) -> Verdict:
    """The printed residual of an exact solution: a constant pressure in a constant gap."""
    pressure, conductance = 1.0, 1.0
    left_over = -(conductance * pressure + conductance * pressure + 2 * conductance * pressure) / SPACING
    return judge(
        left_over == 0,
        f"{left_over * SPACING:.2g} ε p/Δx is left over where nothing flows",
        "the term of the node itself needs a minus, and the bracket a factor 2 to match its right-hand side",
    )


@check("eq_3_26")
def missing_sum(datasets: Datasets) -> Verdict:
    """The printed load of one node against the load of all."""
    single = SPACING * float(PRESSURE.max())
    return _factor(
        HERTZ.load, single, "a sum over the nodes is missing, and one spacing of the two is too many"
    )


@check("eq_3_27")
def sum_of_iterates(datasets: Datasets) -> Verdict:
    """The printed change of two iterates that do not change at all."""
    change = 0.9 * HERTZ.load + 0.9 * HERTZ.load
    return judge(
        change == 0,
        f"{change:.0f} N/m for two equal iterates of {0.9 * HERTZ.load:.0f} N/m",
        "a minus belongs between the iterates; with a plus the change is never negative, whatever the load does",
    )


def _gap_equation(kernel: NDArray[np.float64]) -> NDArray[np.float64]:
    """g of 3-28 in the contact for a film of 1 µm over Hertz's dry solution, which solves it exactly."""
    deflection = -2 / (np.pi * MODULUS) * (_kernel() @ PRESSURE)
    inside = np.abs(X) < 0.9 * HERTZ.half_width
    rigid = 1e-6 - deflection[X.size // 2]
    return (-1 + (rigid + X**2 / (2 * HERTZ.radius) + kernel @ PRESSURE) / 1e-6)[inside]


@check("eq_3_28")
def signed_kernel(datasets: Datasets) -> Verdict:
    """The printed residual at the exact solution."""
    printed = float(np.abs(_gap_equation(_kernel())).max())
    right = float(np.abs(_gap_equation(-2 / (np.pi * MODULUS) * _kernel())).max())
    return judge(
        printed < 1e-2,
        f"residual {printed:.1e} at the exact solution, {right:.0e} with the signed kernel",
        "the kernel stands without its factor -2/(pi E*)",
    )


@check("eq_3_30")
def newton_diagonal(datasets: Datasets) -> Verdict:
    """The derivative of the deflection at a node by its own pressure, against a neighbour's coefficient."""
    kernel = -2 / (np.pi * MODULUS) * _kernel()
    middle = X.size // 2
    unit = np.zeros_like(X)
    unit[middle] = 1.0
    derivative = float((kernel @ unit)[middle])
    return _factor(
        derivative,
        float(kernel[middle, middle + 100]),
        "Newton's derivative needs K_ii; K_ij with j 100 nodes off",
    )
