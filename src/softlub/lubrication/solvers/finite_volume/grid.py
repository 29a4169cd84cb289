"""Nodes of the finite volumes, in units of the Hertz half-width a.

A meshed body brings its nodes. On a half-space a grid is a smooth map of evenly spaced parameters, so that the nodes
of n are every second one of 2n - 1 and the error of the scheme has an expansion in the even powers of the spacing
(Richardson's extrapolation lives on it).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np

from softlub.lubrication.half_space import HalfSpace, HalfSpaceFFT
from softlub.lubrication.meshed_body import MeshedBody, NodalCompliance
from softlub.lubrication.problem import Problem
from softlub.lubrication.solvers.finite_volume.scaled import HERTZ_BODY
from softlub.protocols import Compliance, FloatArray


class Grid(Protocol):
    """Maker of the nodes and of the elasticity on them."""

    def space(self, problem: Problem, count: int) -> Compliance:
        """Scaled elasticity on `count` nodes X = x/a."""
        ...


@dataclass(frozen=True)
class OwnNodes:
    """The nodes of a meshed body's contact edge, or every second, fourth … of them."""

    body: MeshedBody

    def space(self, problem: Problem, count: int) -> NodalCompliance:
        """Compliance in Hertz units on `count` nodes."""
        hertz = problem.hertz
        compliance = NodalCompliance.of(self.body.compliance)
        while compliance.positions.size > count:
            compliance = compliance.halved()
        return compliance.scaled(hertz.half_width, hertz.peak_pressure, hertz.gap_scale)


@dataclass(frozen=True)
class EvenGrid:
    """Evenly spaced nodes from -L to L, as in the source; the elasticity then is a convolution."""

    def space(self, problem: Problem, count: int) -> HalfSpaceFFT:
        """Scaled half-space on `count` nodes X = x/a."""
        reach = problem.domain / problem.hertz.half_width
        return HalfSpaceFFT(HERTZ_BODY, np.linspace(-reach, reach, count))


@dataclass(frozen=True)
class GradedGrid:
    """Nodes that crowd about the edges X = -1 and X = 1 of the dry contact and thin out like 1/|X| outside.

    The parameter is ξ(X) = asinh((X + 1)/d) + asinh((X - 1)/d) + m X/√(1 + X²): spacing of the order of d at the edges,
    even between them, geometric outside.

    Parameters
    ----------
    middle : float
        m, the weight of the nodes between the edges.
    edge_min, edge_max : float
        Bounds of d; within them d = H^(2/3), H the larger of the scaled roughness h_rms R/a² and of the film of the
        smooth contact 0.446 λ^(3/5): the width over which a gap of that height opens outside the dry contact.
    """

    middle: float = 0.5
    edge_min: float = 2e-3
    edge_max: float = 0.6

    def space(self, problem: Problem, count: int) -> HalfSpace:
        """Scaled half-space on `count` nodes X = x/a."""
        hertz = problem.hertz
        reach = problem.domain / hertz.half_width
        film = 0.446 * problem.speed_number**0.6
        thinnest = max(problem.rms_roughness / hertz.gap_scale, film)
        edge = float(np.clip(thinnest ** (2 / 3), self.edge_min, self.edge_max))
        return HalfSpace(HERTZ_BODY, graded_nodes(reach, edge, self.middle, count))


def graded_nodes(reach: float, edge: float, middle: float, count: int) -> FloatArray:
    """Nodes at evenly spaced values of ξ, symmetric about 0, found by safeguarded Newton steps."""
    outermost = float(_parameter(np.array([reach]), edge, middle)[0][0])
    wanted = np.linspace(0, outermost, (count + 1) // 2) if count % 2 else _half_steps(outermost, count)
    table = reach * np.linspace(0, 1, 400) ** 3
    x: FloatArray = np.interp(wanted, _parameter(table, edge, middle)[0], table)
    for _ in range(50):
        value, slope = _parameter(x, edge, middle)
        step = (wanted - value) / slope
        x = np.clip(x + step, 0.5 * x, np.minimum(2 * x + edge, reach))
        if np.max(np.abs(step)) <= 1e-13 * reach:
            break
    x[-1] = reach
    if count % 2:
        x[0] = 0.0
        return np.concatenate([-x[:0:-1], x])
    return np.concatenate([-x[::-1], x])


def _half_steps(outermost: float, count: int) -> FloatArray:
    """Positive parameters of an even number of nodes."""
    return np.linspace(0.5, 0.5 * count - 0.5, count // 2) * (2 * outermost / (count - 1))


def _parameter(x: FloatArray, edge: float, middle: float) -> tuple[FloatArray, FloatArray]:
    """ξ and dξ/dX."""
    left, right = (x + 1) / edge, (x - 1) / edge
    value = np.arcsinh(left) + np.arcsinh(right) + middle * x / np.sqrt(1 + x * x)
    slope = (1 / np.sqrt(1 + left**2) + 1 / np.sqrt(1 + right**2)) / edge + middle * (1 + x * x) ** -1.5
    return np.asarray(value), np.asarray(slope)


GRIDS: dict[str, Grid] = {"graded": GradedGrid(), "even": EvenGrid()}
"""Grids by name."""
