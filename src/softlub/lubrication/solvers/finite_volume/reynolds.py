"""The Reynolds equation for a given separation: the rigid bearing, and the start of every elastic solution.

For a given gap the complementarity problem of `rows` is linear as long as the set of pressurised nodes stays; the
iteration here is its Newton method (a primal-dual active set). Pressurised nodes couple to their neighbours alone,
or across a void to the last pressurised node before it, so each step is one tridiagonal elimination.
"""

from __future__ import annotations

from typing import Literal, NamedTuple

import numba
import numpy as np
from numpy.typing import ArrayLike, NDArray

from softlub.lubrication.solvers.finite_volume.fluxes import face_fluxes
from softlub.lubrication.solvers.finite_volume.rows import complementarity_rows
from softlub.protocols import FloatArray


class Film(NamedTuple):
    """Film between given walls."""

    pressure: FloatArray
    """p_f above that of the void [Pa], shape (n,)."""
    void_fraction: FloatArray
    """θ, the share of the gap without lubricant; 0 throughout under the Reynolds condition, shape (n,)."""
    converged: bool
    """Whether the set of pressurised nodes settled."""
    iterations: int
    """Eliminations that it took."""


def pressure(
    positions: ArrayLike,
    separation: ArrayLike,
    viscosity: float,
    speed: float,
    cavitation: Literal["reynolds", "mass_conserving"] = "reynolds",
    ambient_pressure: float = 0.0,
) -> Film:
    """Pressure of the lubricant between rigid walls, one of which moves in +x (equation 3-2).

    Parameters
    ----------
    positions : array_like, shape (n,)
        Nodes x [m], ascending, any spacing.
    separation : array_like, shape (n,)
        u [m], positive.
    viscosity, speed : float
        η [Pa s] and v [m/s].
    cavitation : {"reynolds", "mass_conserving"}
        See `softlub.lubrication.film.Lubricant`.
    ambient_pressure : float
        Pressure at both ends, above that of the void [Pa].

    Returns
    -------
    Film

    Raises
    ------
    ValueError
        If a separation is not positive or the nodes do not ascend.
    """
    x = np.ascontiguousarray(positions, dtype=float)
    u = np.ascontiguousarray(separation, dtype=float)
    if x.shape != u.shape or x.size < 3 or not np.all(np.diff(x) > 0):
        raise ValueError("the film needs at least three ascending nodes and one separation for each")
    if not np.all(u > 0):
        raise ValueError("the separation must be positive everywhere")
    length, height = x[-1] - x[0], float(u.min())
    nodes, gap = x / length, u / height
    unit = 6 * viscosity * speed * length / height**2
    start = np.full(x.size, ambient_pressure / unit)
    fluid, inflow, iterations, settled = film_pressure(nodes, gap, 1.0, False, start, x > -np.inf)
    void = np.zeros_like(x)
    if cavitation == "mass_conserving":
        fluid, inflow, more, settled = film_pressure(nodes, gap, 1.0, True, start, fluid > 0)
        iterations += more
        void = np.where(fluid > 0, 0.0, 1 - inflow / gap)
    return Film(unit * fluid, void, settled, iterations)


@numba.njit(cache=True, error_model="numpy")
def film_pressure(
    nodes: FloatArray,
    gap: FloatArray,
    speed_number: float,
    mass_conserving: bool,
    ends: FloatArray,
    start: NDArray[np.bool_],
) -> tuple[FloatArray, FloatArray, int, bool]:
    """Pressure P_f and the flux into each node for given gaps in the units of `fluxes`; the steps, their success.

    The ends keep the first and last value of `ends`, shape (n,); the search begins with the nodes of `start`
    pressurised.
    """
    couette, conductance, _ = face_fluxes(nodes, gap, np.zeros(nodes.size), speed_number)
    flux = couette.copy()
    pressurised = start.copy()
    most = 4 * nodes.size
    fluid = np.zeros(nodes.size)
    for step in range(1, most + 1):
        fluid = eliminate(couette, conductance, pressurised, mass_conserving, ends)
        for i in range(flux.size):
            flux[i] = couette[i] - conductance[i] * (fluid[i + 1] - fluid[i])
        _, weight, source = complementarity_rows(fluid, flux, conductance, mass_conserving)
        changed = False
        for i in range(1, nodes.size - 1):
            if pressurised[i] != (weight[i] > 0):
                pressurised[i] = weight[i] > 0
                changed = True
        if not changed or step == most:
            break
    arriving = speed_number * gap
    for i in range(1, nodes.size - 1):
        arriving[i] = flux[source[i]]
    return fluid, arriving, step, not changed


@numba.njit(cache=True, error_model="numpy")
def eliminate(
    couette: FloatArray,
    conductance: FloatArray,
    pressurised: NDArray[np.bool_],
    mass_conserving: bool,
    ends: FloatArray,
) -> FloatArray:
    """Pressures that make r = 0 at the pressurised nodes and P_f = 0 at the others.

    Forward: P_i = constant_i + coupling_i P_{i+1}; backward: their values.
    """
    count = pressurised.size
    constant = np.zeros(count)
    coupling = np.zeros(count)
    constant[0] = ends[0]
    before = -1
    for i in range(1, count - 1):
        if not pressurised[i]:
            continue
        diagonal, right = conductance[i], -couette[i]
        if i == 1 or pressurised[i - 1] or not mass_conserving:
            diagonal += conductance[i - 1] * (1 - coupling[i - 1])
            right += couette[i - 1] + conductance[i - 1] * constant[i - 1]
        elif before < 0:
            right += couette[0]
        else:
            right += couette[before] + conductance[before] * constant[before]
        constant[i] = right / diagonal
        coupling[i] = conductance[i] / diagonal
        before = i
    fluid = np.zeros(count)
    fluid[0], fluid[count - 1] = ends[0], ends[count - 1]
    for i in range(count - 2, 0, -1):
        if pressurised[i]:
            fluid[i] = constant[i] + coupling[i] * fluid[i + 1]
    return fluid
