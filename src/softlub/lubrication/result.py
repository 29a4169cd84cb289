"""What every lubrication solver returns for one point."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]


@dataclass(frozen=True)
class LubricatedContact:
    """Solution of one lubricated contact, or the last iterate of one that did not converge.

    The quadrature ``weights @ f(positions)`` covers the whole domain, so that friction and shares are computed in
    one way for every solver.

    Parameters
    ----------
    load, speed : float
        W [N/m] and v [m/s] that were asked for.
    positions, weights : ndarray, shape (n,)
        Nodes x [m] and their quadrature weights [m].
    fluid_pressure, solid_pressure, separation : ndarray, shape (n,)
        p_f [Pa], p_s [Pa], u [m].
    fluid_pressure_gradient : ndarray, shape (n,)
        dp_f/dx at the nodes [Pa/m], by the solver's own discretisation.
    rigid_approach : float
        H_c [m], the rigid term of the separation.
    separation_min, separation_central : float
        Smallest separation and that at x = 0, interpolated by the solver's own discretisation [m].
    rupture : float
        Where the pressurised film ends [m].
    converged : bool
        Whether the true residual fell below the solver's tolerance and the solution is admissible.
    iterations : int
        Newton steps or sweeps.
    residual : float
        Largest scaled residual of the last iterate.
    load_error : float
        |∫(p_f + p_s) dx - W| / W.
    breaks : range
        Indices of the nodes where spectral elements end; empty for other solvers.
    seconds : float
        CPU time spent on this point alone, NaN where a solver treats its speeds together [s].
    residual_history : tuple of float
        One value an iteration (or every so many, as the solver says).
    solver : str
        Name of the solver that made it.
    """

    load: float
    speed: float
    positions: FloatArray
    weights: FloatArray
    fluid_pressure: FloatArray
    solid_pressure: FloatArray
    separation: FloatArray
    fluid_pressure_gradient: FloatArray
    rigid_approach: float
    separation_min: float
    separation_central: float
    rupture: float
    converged: bool
    iterations: int
    residual: float
    load_error: float
    solver: str
    breaks: range = range(0)
    seconds: float = float("nan")
    residual_history: tuple[float, ...] = field(default=(), repr=False)
