"""The rupture front, helped along.

At a start that is merely near, noise in the outlet makes P_f exceed c r here and there and scatters pressurised
nodes over it; so the first step takes the front from the start, not from the complementarity. Later on a film that
is too long is cut back at once, but one too short releases the single node behind its end that sees the suction:
the front creeps a node a step while the residual falls to zero almost linearly. Then the nodes that are still to
come are estimated from that fall, and most of them released together.
"""

from __future__ import annotations

import numpy as np

from softlub.lubrication.solvers.finite_volume.equations import Linearisation
from softlub.lubrication.solvers.finite_volume.rows import Rows

LEAD = 0.7
"""Part of the nodes still to come that is released together."""


def last_pressurised(equations: Linearisation) -> int:
    """Index of the last node that is not cavitated."""
    pressurised = np.flatnonzero(equations.rows.flux_weight)
    return int(pressurised[-1]) if pressurised.size else 0


def with_front(equations: Linearisation, front: int) -> Linearisation:
    """The equations with the nodes up to the front pressurised and all others cavitated."""
    count = equations.gap.size
    front = min(max(front, 1), count - 2)
    inner = slice(1, count - 1)
    scale = 1 / (equations.conductance[:-1] + equations.conductance[1:])
    pressurised = np.zeros(count, dtype=bool)
    pressurised[1 : front + 1] = True
    residual = equations.fluid.copy()
    residual[inner] = np.where(pressurised[inner], scale * np.diff(equations.flux), residual[inner])
    flux_weight = np.zeros(count)
    flux_weight[inner] = np.where(pressurised[inner], scale, 0.0)
    rows = Rows(residual, flux_weight, np.arange(-1, count - 1))
    return equations._replace(rows=rows)


class Creep:
    """Watches the front and the residual from step to step."""

    def __init__(self) -> None:
        self.end = 0
        self.residual = 0.0

    def overtake(self, equations: Linearisation) -> Linearisation:
        """The equations for the next step, with the film longer where its end has been creeping outwards."""
        end, residual = last_pressurised(equations), equations.residual
        advance = end - self.end if self.end else 0
        fall = self.residual - residual
        self.end, self.residual = end, residual
        if advance <= 0:
            return equations
        to_come = advance * residual / fall if fall > 0 else 2 * advance
        lead = int(LEAD * (min(to_come, equations.gap.size / 8) - 1))
        return with_front(equations, end + lead) if lead > 0 else equations
