"""When a grid no longer serves, and the next one."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numba import njit

from softlub.lubrication.solvers.spectral.basis import Basis, FloatArray
from softlub.lubrication.solvers.spectral.breaks import element_breaks, is_hertzian
from softlub.lubrication.solvers.spectral.equations import Grid, Scene, separation
from softlub.lubrication.solvers.spectral.grid import make_grid
from softlub.lubrication.solvers.spectral.kernel import log_kernel
from softlub.lubrication.solvers.spectral.remainder import Remainder, make_remainder
from softlub.pressure_table import pressure_and_slope

# A grid serves as long as the speed number changes by less than this (in the logarithm), the rupture point (and the
# elements with it) by less than this share of the finest element, the smallest gap falls by less than this factor, and
# the solid pressure at its end stays below this (in p0).
LOG_RANGE = 2.8
RUPTURE_SHARE = 0.4
GAP_FACTOR = 0.45
LIVE_PRESSURE = 1e-9


class Mesh(NamedTuple):
    """A grid with its remainder, and the contact that it was made for.

    Attributes
    ----------
    grid, remainder : Grid, Remainder
    log_speed : float
        ln λ.
    film_min : float
        Smallest separation.
    hertzian : bool
        Whether the contact had distinct edges.
    """

    grid: Grid
    remainder: Remainder
    log_speed: float
    film_min: float
    hertzian: bool


@njit(cache=True)
def rupture_layer(gap: float, speed_number: float, scene: Scene) -> float:
    """Length |dp_s/dH| H³/λ over which asperities and flow find their balance before the rupture, where H = `gap`."""
    _, slope = pressure_and_slope(scene.first, scene.step, scene.coefficients, gap)
    return -slope * gap**3 / speed_number


@njit(cache=True)
def serves(
    mesh: Mesh, state: FloatArray, log_speed: float, film_min: float, end_gap: float, scene: Scene
) -> bool:
    """Whether a grid is good for a predicted state, whose gap is `end_gap` where the elements end."""
    grid = mesh.grid
    finest = np.inf
    for e in range(grid.inlet):
        finest = min(finest, grid.breaks[e + 1] - grid.breaks[e])
    alive, _ = pressure_and_slope(scene.first, scene.step, scene.coefficients, end_gap)
    return (
        abs(log_speed - mesh.log_speed) <= LOG_RANGE
        and abs(state[-1] - grid.rupture) <= RUPTURE_SHARE * finest
        and film_min >= GAP_FACTOR * mesh.film_min
        and is_hertzian(state[-2], film_min, np.exp(log_speed), scene.roughness) == mesh.hertzian
        and (alive <= LIVE_PRESSURE or grid.breaks[-1] >= scene.half_domain)
    )


@njit(cache=True)
def outlet_end(state: FloatArray, grid: Grid, scene: Scene, basis: Basis, dead_gap: float) -> float:
    """Where right of the rupture the separation reaches `dead_gap`, at which the solid pressure has died out."""
    rupture = state[-1]
    width = 0.1
    position, gap, unused = np.empty(1), np.empty(1), np.empty(1)
    stretch = (rupture + scene.half_domain) / (grid.rupture + scene.half_domain)
    end = rupture
    for _ in range(30):
        position[0] = (end + scene.half_domain) / stretch - scene.half_domain
        kernel = log_kernel(position, grid.breaks, basis.legendre_weights)
        separation(state, grid, scene.half_domain, position, kernel, gap, unused)
        if gap[0] >= dead_gap or end >= scene.half_domain:
            break
        end = min(rupture + width, scene.half_domain)
        width *= 1.5
    return end


@njit(cache=True)
def make_mesh(
    rupture: float,
    approach: float,
    log_speed: float,
    film_min: float,
    layer: float,
    end: float,
    scene: Scene,
    basis: Basis,
    gauss: FloatArray,
) -> Mesh:
    """The grid for a contact whose solid pressure lives up to `end`."""
    breaks, inlet = element_breaks(
        rupture, approach, film_min, np.exp(log_speed), scene.roughness, layer, -scene.half_domain, end
    )
    grid = make_grid(breaks, inlet, basis)
    hertzian = is_hertzian(approach, film_min, np.exp(log_speed), scene.roughness)
    return Mesh(grid, make_remainder(grid, scene.half_domain, basis, gauss), log_speed, film_min, hertzian)
