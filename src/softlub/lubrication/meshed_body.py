"""A body whose deflection is known on its own nodes alone, as finite elements give it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from softlub.protocols import Compliance, FloatArray
from softlub.units import Length, Pressure, check

FEWEST_TO_HALVE = 5
"""Nodes of which every second one still makes a film."""


@dataclass(frozen=True, eq=False)
class MeshedBody:
    """Elastic body that brings its compliance and with it the film's nodes.

    Its radius and modulus make units and first guesses, and enter no result otherwise.

    Parameters
    ----------
    compliance : Compliance
        Gap over pressure on the nodes of the contact edge, the apex at x = 0.
    radius : float
        R of the tip [m].
    modulus : float
        Plane-strain modulus E* [Pa].

    Raises
    ------
    ValueError
        If a number is not positive, there are fewer than three nodes or they do not ascend.
    """

    compliance: Compliance
    radius: Length
    modulus: Pressure

    def __post_init__(self) -> None:
        check(self)
        x = self.compliance.positions
        if x.size < 3 or not np.all(np.diff(x) > 0):
            raise ValueError(f"MeshedBody: {x.size} nodes; at least three are needed, x strictly ascending")

    @property
    def node_count(self) -> int:
        """Nodes of the compliance."""
        return self.compliance.positions.size

    @property
    def can_be_halved(self) -> bool:
        """Whether every second node leaves both ends and enough between them."""
        return self.node_count % 2 == 1 and self.node_count >= FEWEST_TO_HALVE

    def halved(self) -> MeshedBody:
        """The same body seen on every second node only: a coarser film on the same elasticity."""
        return MeshedBody(NodalCompliance.of(self.compliance).halved(), self.radius, self.modulus)


@dataclass(frozen=True, eq=False)
class NodalCompliance:
    """A compliance held as its matrix; in SI or in other units.

    Parameters
    ----------
    positions, widths, base_gap : ndarray, shape (n,)
    influence : ndarray, shape (n, n)
        As `matrix` of `softlub.protocols.Compliance`.
    """

    positions: FloatArray
    widths: FloatArray
    base_gap: FloatArray
    influence: FloatArray

    @classmethod
    def of(cls, compliance: Compliance) -> NodalCompliance:
        """The matrix form of any compliance."""
        return cls(compliance.positions, compliance.widths, compliance.base_gap, compliance.matrix())

    def deflection(self, pressure: ArrayLike) -> FloatArray:
        """Opening of the gap under nodal pressures, shape (n,)."""
        return self.influence @ np.asarray(pressure, dtype=float)

    def matrix(self) -> FloatArray:
        """Derivative of `deflection` by the pressures, shape (n, n); not a copy."""
        return self.influence

    def scaled(self, length: float, pressure: float, gap: float) -> NodalCompliance:
        """In units of a length along x, a pressure and a gap."""
        return NodalCompliance(
            self.positions / length,
            self.widths / length,
            self.base_gap / gap,
            np.ascontiguousarray(self.influence * (pressure / gap)),
        )

    def halved(self) -> NodalCompliance:
        """On every second node, the pressure between two of them linear in x.

        Raises
        ------
        ValueError
            If the number of nodes is even, so that the last one would be lost, or below five.
        """
        count = self.positions.size
        if count % 2 == 0 or count < FEWEST_TO_HALVE:
            raise ValueError(
                f"{count} nodes cannot be halved: an odd number from {FEWEST_TO_HALVE} on is needed"
            )
        x = self.positions
        to_right = (x[1::2] - x[:-2:2]) / (x[2::2] - x[:-2:2])
        influence, widths = (
            _gathered(values, to_right) for values in (self.influence[::2], self.widths[None])
        )
        return NodalCompliance(x[::2], widths[0], self.base_gap[::2], influence)


def _gathered(columns: FloatArray, to_right: FloatArray) -> FloatArray:
    """Columns of every second node, with those between shared out linearly to their neighbours."""
    gathered = columns[:, ::2].copy()
    gathered[:, :-1] += columns[:, 1::2] * (1 - to_right)
    gathered[:, 1:] += columns[:, 1::2] * to_right
    return gathered
