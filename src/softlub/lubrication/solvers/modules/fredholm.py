"""The Fredholm solver of the mixed module: gap and asperity pressure for given fluid pressure and approach.

For given P_f and H_c the gap solves H = H_c + X²/2 + C (P_f + p_s(H)) (equation 3-28). Equations 3-29 and 3-30 take
Newton steps with the diagonal of the kernel alone; their signs and the K_ij of the text (C_ii is meant) are put right
in `fredholm_gap`. Where asperities are stiff, the far field that the diagonal leaves out is many times as large as the
diagonal: the relaxed steps then are accelerated like the sweeps.
"""

from __future__ import annotations

import numpy as np

from softlub.lubrication.solvers.modules.anderson import Anderson
from softlub.lubrication.solvers.modules.contact import EvenContact
from softlub.lubrication.solvers.modules.iteration import LARGEST_LOG_CHANGE
from softlub.protocols import FloatArray

MEMORY = 8
"""Anderson's memory within the solver."""
MOST_STEPS = 30
"""Steps of one call; the sweep that called goes on with what it has."""


def fredholm_gap(
    contact: EvenContact,
    fluid: FloatArray,
    approach: float,
    start: FloatArray,
    relaxation: float,
    tolerance: float,
    memory: int = MEMORY,
) -> tuple[FloatArray, FloatArray, int]:
    """Gap and asperity pressure by H <- H (1 + α_fs g / (1 + g - C_ii dp_s/dH)), g = (H_c + X²/2 + C P)/H - 1.

    Parameters
    ----------
    contact : EvenContact
    fluid : ndarray, shape (n,)
        P_f.
    approach : float
        H_c.
    start : ndarray, shape (n,)
        Gap to begin with.
    relaxation : float
        α_fs.
    tolerance : float
        Largest |g| of a solution.
    memory : int
        Anderson's memory; 0 for plain steps.

    Returns
    -------
    gap, solid : ndarray, shape (n,)
        H and p_s(H).
    steps : int
    """
    space = contact.scaled.space
    given = contact.scaled.gap(fluid, approach)
    diagonal = contact.kernel[0]
    accelerator = Anderson(memory, start.size)
    gap = start
    for step in range(MOST_STEPS + 1):
        solid, slope = contact.scaled.solid(gap)
        mismatch = (given + space.deflection(solid)) / gap - 1
        if np.max(np.abs(mismatch)) <= tolerance or step == MOST_STEPS:
            break
        denominator = np.maximum(1 + mismatch - diagonal * slope, 0.1)
        change = np.log1p(np.clip(relaxation * mismatch / denominator, -0.4, 0.6))
        state = np.log(gap)
        move = np.clip(accelerator.next(state, change) - state, -LARGEST_LOG_CHANGE, LARGEST_LOG_CHANGE)
        gap = np.exp(state + move)
    return gap, solid, step
