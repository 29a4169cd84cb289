"""Where the march begins: Martin's film as grid and first iterate."""

from __future__ import annotations

import numpy as np
from numba import njit

from softlub.lubrication.solvers.spectral.basis import Basis, FloatArray
from softlub.lubrication.solvers.spectral.equations import Scene
from softlub.lubrication.solvers.spectral.martin import rigid_film
from softlub.lubrication.solvers.spectral.remesh import Mesh, make_mesh


@njit(cache=True)
def martin_start(
    log_speed: float, scene: Scene, basis: Basis, gauss: FloatArray, dead_gap: float
) -> tuple[Mesh, FloatArray]:
    """Mesh and first iterate of a film that is thick against the deflection and the roughness."""
    speed_number = np.exp(log_speed)
    film, rupture = rigid_film(speed_number, scene.half_domain)
    end = max(min(np.sqrt(2 * max(dead_gap - film, 0.0)), scene.half_domain), rupture)
    mesh = make_mesh(rupture, film, log_speed, film, 1.0, end, scene, basis, gauss)
    grid = mesh.grid
    order = basis.nodes.size - 1
    n = grid.nodes.size
    state = np.zeros(n + 2)
    flow = np.empty(n)
    for i in range(n):
        gap = film + 0.5 * grid.nodes[i] ** 2
        flow[i] = (gap - film - 0.5 * rupture**2) / gap**3
    for e in range(grid.inlet):
        half = 0.5 * (grid.breaks[e + 1] - grid.breaks[e]) * speed_number
        for i in range(1, order + 1):
            rise = 0.0
            for j in range(order + 1):
                rise += basis.integration[i, j] * flow[e * order + j]
            state[e * order + i] = state[e * order] + half * rise
    middle = 0
    for i in range(n):
        if abs(grid.nodes[i]) < abs(grid.nodes[middle]):
            middle = i
    state[n] = film
    for j in range(n):
        state[n] += grid.kernel[middle, j] * state[j] / np.pi
    state[n + 1] = rupture
    return mesh, state
