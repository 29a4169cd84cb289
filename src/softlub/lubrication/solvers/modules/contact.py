"""A problem on the modules' even grid, in Hertz units, and the fields that they iterate on.

The modules discretise exactly as the finite volumes do (`finite_volume.fluxes`, `finite_volume.rows`) on an even
grid, so that Newton's solution on the same nodes is a fixed point of each.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from softlub.lubrication.problem import Problem
from softlub.lubrication.solvers.finite_volume.grid import EvenGrid
from softlub.lubrication.solvers.finite_volume.reynolds import film_pressure
from softlub.lubrication.solvers.finite_volume.scaled import ScaledContact, scale
from softlub.protocols import FloatArray

DOMAIN_HALF_WIDTHS = 4.0
"""Reach of the grid in Hertz half-widths where the problem names no domain (the source's ±1 mm are 3.2)."""
DOMAIN_ROUGHNESS_WIDTHS = 8.0
"""The same in units of √(2 R h_rms), for light loads on rough surfaces."""
LARGEST_PRESSURE = 5.0
"""Fluid pressure over the Hertz pressure beyond which an iterate has no meaning."""


class Fields(NamedTuple):
    """An iterate, in Hertz units."""

    fluid: FloatArray
    """P_f, shape (n,)."""
    solid: FloatArray
    """P_s, shape (n,)."""
    gap: FloatArray
    """H, shape (n,)."""
    approach: float
    """H_c."""


@dataclass(frozen=True, eq=False)
class EvenContact:
    """A problem at one speed on an even grid.

    Parameters
    ----------
    problem : Problem
        With its domain settled.
    scaled : ScaledContact
        Elasticity and law in Hertz units.
    kernel : ndarray, shape (n,)
        Influence of a control volume over the distance in nodes, in Hertz units.
    """

    problem: Problem
    scaled: ScaledContact
    kernel: FloatArray

    @property
    def nodes(self) -> FloatArray:
        """X = x/a, shape (n,)."""
        return self.scaled.space.positions

    @property
    def speed_number(self) -> float:
        """λ."""
        return self.problem.speed_number

    @property
    def centre(self) -> int:
        """The node at (or next to) X = 0."""
        return self.nodes.size // 2

    def at(self, speed: float) -> EvenContact:
        """The same contact at another speed."""
        return replace(self, problem=self.problem.at(speed=speed))

    def force(self, pressure: FloatArray) -> float:
        """∫ P dX; π/2 is the load."""
        return float(self.scaled.space.widths @ pressure)

    def reynolds_pressure(self, gap: FloatArray, start: FloatArray) -> FloatArray:
        """P_f that solves the Reynolds equation and its complementarity for a given gap, shape (n,).

        It is cut at `LARGEST_PRESSURE`, which no solution reaches: for the rough gaps of early iterates the equation
        has pressures of any size.
        """
        ends = np.zeros_like(gap)
        fluid = film_pressure(self.nodes, gap, self.speed_number, False, ends, start > 0)[0]
        return np.minimum(fluid, LARGEST_PRESSURE)


def even_contact(problem: Problem, nodes: int) -> EvenContact:
    """Put a problem on its even grid.

    Parameters
    ----------
    problem : Problem
        A `half_domain` that it names is kept; otherwise the grid reaches 4 Hertz half-widths, or 8 √(2 R h_rms)
        where that is wider: an even grid over the domain of the other solvers (64 half-widths) would leave only a
        few nodes in the contact.
    nodes : int
        Number of nodes.

    Returns
    -------
    EvenContact

    Raises
    ------
    ValueError
        If the body is meshed, or the lubricant's film is to conserve mass: the modules clip the pressure, which is
        the Reynolds condition.
    """
    problem.refuse_meshed("modules'")
    if problem.lubricant.cavitation != "reynolds":
        raise ValueError(
            f"the modules know the cavitation condition 'reynolds' alone, not {problem.lubricant.cavitation!r}; "
            "use the solver finite_volume"
        )
    if problem.half_domain is None:
        problem = replace(problem, half_domain=default_half_domain(problem))
    space = EvenGrid().space(problem, nodes)
    return EvenContact(problem, scale(problem, space), space.kernel)


def default_half_domain(problem: Problem) -> float:
    """Half-width of the even grid where the problem names no domain [m]."""
    rough_width = float(np.sqrt(2 * problem.body.radius * problem.rms_roughness))
    return max(DOMAIN_HALF_WIDTHS * problem.hertz.half_width, DOMAIN_ROUGHNESS_WIDTHS * rough_width)
