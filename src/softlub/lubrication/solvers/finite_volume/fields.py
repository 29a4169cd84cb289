"""From a solution in Hertz units to the fields and numbers of a lubricated contact."""

from __future__ import annotations

import numpy as np

from softlub.lubrication.half_space import control_volume_faces
from softlub.lubrication.problem import Problem
from softlub.lubrication.result import LubricatedContact
from softlub.lubrication.solvers.finite_volume.newton import Iterate
from softlub.lubrication.solvers.finite_volume.scaled import LOAD, ScaledContact
from softlub.protocols import FloatArray


def contact_fields(problem: Problem, contact: ScaledContact, iterate: Iterate) -> LubricatedContact:
    """Fields of one speed in SI units.

    The gradient of the fluid pressure is the difference of the neighbours over their distance: its sum with the
    tributary widths is then exactly a sum by parts, as the identity μ_Poiseuille = -x̄/(2R) asks for.
    """
    hertz = problem.hertz
    half_width, peak, height = hertz.half_width, hertz.peak_pressure, hertz.gap_scale
    nodes, gap, total = contact.space.positions, iterate.equations.gap, iterate.state.pressure
    cavitated = iterate.equations.rows.flux_weight == 0
    solid = np.where(cavitated & iterate.converged, total, iterate.equations.solid)
    fluid = total - solid
    return LubricatedContact(
        load=problem.load,
        speed=problem.speed,
        positions=half_width * nodes,
        weights=half_width * contact.space.widths,
        fluid_pressure=peak * fluid,
        solid_pressure=peak * solid,
        separation=height * gap,
        fluid_pressure_gradient=peak / half_width * gradient(nodes, fluid),
        rigid_approach=height * iterate.state.approach,
        separation_min=height * float(np.exp(parabola_minimum(nodes, np.log(gap)))),
        separation_central=height * parabola_value(nodes, gap, 0.0),
        rupture=half_width * rupture(nodes, fluid),
        converged=iterate.converged,
        iterations=iterate.iterations,
        residual=iterate.history[-1],
        load_error=abs(float(contact.space.widths @ total) - LOAD) / LOAD,
        solver="finite_volume",
        residual_history=iterate.history,
    )


def gradient(nodes: FloatArray, values: FloatArray) -> FloatArray:
    """Differences over the control volumes; one-sided at the ends, where the first volume ends at its node."""
    at_faces = np.concatenate([values[:1], 0.5 * (values[1:] + values[:-1]), values[-1:]])
    return np.diff(at_faces) / np.diff(control_volume_faces(nodes))


def parabola_minimum(nodes: FloatArray, values: FloatArray) -> float:
    """Minimum of the parabola through the lowest node and its neighbours."""
    lowest = int(np.clip(np.argmin(values), 1, nodes.size - 2))
    slope, curvature = _parabola(nodes, values, lowest)
    if curvature <= 0:
        return float(values[lowest])
    return float(values[lowest] - slope**2 / (4 * curvature))


def parabola_value(nodes: FloatArray, values: FloatArray, place: float) -> float:
    """Value at a place on the parabola through the nearest three nodes."""
    nearest = int(np.clip(np.argmin(np.abs(nodes - place)), 1, nodes.size - 2))
    slope, curvature = _parabola(nodes, values, nearest)
    offset = place - nodes[nearest]
    return float(values[nearest] + offset * (slope + offset * curvature))


def _parabola(nodes: FloatArray, values: FloatArray, middle: int) -> tuple[float, float]:
    """Slope at the middle node and half the second derivative of the parabola through three nodes."""
    left, right = nodes[middle] - nodes[middle - 1], nodes[middle + 1] - nodes[middle]
    fall = (values[middle] - values[middle - 1]) / left
    rise = (values[middle + 1] - values[middle]) / right
    curvature = (rise - fall) / (left + right)
    return fall + curvature * left, curvature


def rupture(nodes: FloatArray, fluid: FloatArray) -> float:
    """End of the last pressurised stretch, where p_f falls to zero like a parabola: √p_f is continued linearly."""
    pressurised = np.flatnonzero(fluid > 0)
    if pressurised.size == 0:
        return float(nodes[0])
    last = int(pressurised[-1])
    if last < 1 or last + 1 >= nodes.size or fluid[last - 1] <= fluid[last]:
        return float(nodes[last])
    before, root = np.sqrt(fluid[last - 1]), np.sqrt(fluid[last])
    distance = root / (before - root) * (nodes[last] - nodes[last - 1])
    return float(min(nodes[last] + distance, nodes[last + 1]))
