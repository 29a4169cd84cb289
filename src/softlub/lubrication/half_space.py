"""Deflection of an elastic half-space under line pressure (equations 3-14 to 3-16).

The pressure is constant over each node's control volume, whose faces lie halfway between the nodes (the first
and the last volume end at their node). With E* = E/(1 - ν²) the opening of the gap is

    w_i = -(2/(π E*)) Σ_j K_ij p_j,   K_ij = ∫_{volume j} ln|x_i - s| ds = F(x_i - s_j-½) - F(x_i - s_j+½),
    F(d) = d (ln|d| - 1),

with lengths in metres inside the logarithm: that choice fixes what the rigid approach is measured from, and
nothing else. Two representations of the one operator: `HalfSpace` holds the matrix and takes any grid,
`HalfSpaceFFT` convolves and needs even spacing.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike
from scipy import fft, linalg

from softlub.lubrication.problem import HalfSpaceCylinder
from softlub.protocols import FloatArray


def control_volume_faces(positions: FloatArray) -> FloatArray:
    """Faces of the control volumes: the two ends and the midpoints between nodes, shape (n + 1,)."""
    midpoints = 0.5 * (positions[1:] + positions[:-1])
    return np.concatenate([positions[:1], midpoints, positions[-1:]])


def _antiderivative(distance: FloatArray) -> FloatArray:
    """∫ ln|d| dd = d (ln|d| - 1), continued by its limit 0 at d = 0."""
    size = np.abs(distance)
    size[size == 0] = 1.0
    return distance * (np.log(size) - 1)


def influence_matrix(positions: FloatArray, modulus: float) -> FloatArray:
    """Deflection at every node by unit pressure on every control volume.

    Parameters
    ----------
    positions : ndarray, shape (n,)
        Nodes x [m], ascending, any spacing.
    modulus : float
        Plane-strain modulus E* [Pa].

    Returns
    -------
    ndarray, shape (n, n)
        -(2/(πE*)) K_ij [m/Pa] (equations 3-15 and 3-16 with their constants put right).
    """
    antiderivative = _antiderivative(positions[:, None] - control_volume_faces(positions)[None, :])
    return (-2 / (np.pi * modulus)) * (antiderivative[:, :-1] - antiderivative[:, 1:])


@dataclass(frozen=True, eq=False)
class HalfSpace:
    """Compliance of a parabolic half-space body, as a dense matrix on any ascending grid.

    Parameters
    ----------
    body : HalfSpaceCylinder
    positions : ndarray, shape (n,)
        Nodes x [m], strictly ascending.

    Raises
    ------
    ValueError
        If fewer than three nodes are given or they do not ascend.
    """

    body: HalfSpaceCylinder
    positions: FloatArray
    widths: FloatArray = field(init=False, repr=False)
    base_gap: FloatArray = field(init=False, repr=False)
    _influence: FloatArray = field(init=False, repr=False)

    def __post_init__(self) -> None:
        _describe_nodes(self, self.body, self.positions)
        object.__setattr__(self, "_influence", influence_matrix(self.positions, self.body.modulus))

    def deflection(self, pressure: ArrayLike) -> FloatArray:
        """Opening of the gap [m] under nodal pressures [Pa], shape (n,)."""
        return self._influence @ np.asarray(pressure, dtype=float)

    def matrix(self) -> FloatArray:
        """Derivative of `deflection` by the pressures [m/Pa], shape (n, n); not a copy."""
        return self._influence


@dataclass(frozen=True, eq=False)
class HalfSpaceFFT:
    """Compliance of a parabolic half-space body on an even grid, by fast Fourier transforms.

    The influence of the whole-width volumes depends on i - j alone; that of the two halved end volumes is
    kept as two columns. The result is that of `HalfSpace` up to round-off, for O(n log n) a product.

    Parameters
    ----------
    body : HalfSpaceCylinder
    positions : ndarray, shape (n,)
        Evenly spaced nodes x [m], ascending.

    Raises
    ------
    ValueError
        If the nodes are too few, do not ascend or are not evenly spaced.
    """

    body: HalfSpaceCylinder
    positions: FloatArray
    widths: FloatArray = field(init=False, repr=False)
    base_gap: FloatArray = field(init=False, repr=False)
    kernel: FloatArray = field(init=False, repr=False)
    """Influence of a whole control volume over the distance in nodes, shape (n,) [m/Pa]."""
    _ends: FloatArray = field(init=False, repr=False)
    _transform: FloatArray = field(init=False, repr=False)
    _length: int = field(init=False, repr=False)

    def __post_init__(self) -> None:
        _describe_nodes(self, self.body, self.positions)
        x = self.positions
        count = x.size
        spacing = (x[-1] - x[0]) / (count - 1)
        if not np.allclose(np.diff(x), spacing, rtol=1e-6, atol=0):
            raise ValueError("HalfSpaceFFT needs evenly spaced nodes; use HalfSpace for graded ones")
        factor = -2 / (np.pi * self.body.modulus)
        whole = _antiderivative((np.arange(count + 1) - 0.5) * spacing)
        kernel = factor * np.diff(whole)
        half = _antiderivative(np.arange(count) * spacing)
        first = factor * (half - whole[:-1])
        length = fft.next_fast_len(2 * count - 1, real=True)
        wrapped = np.zeros(length)
        wrapped[:count] = kernel
        wrapped[length - count + 1 :] = kernel[:0:-1]
        object.__setattr__(self, "kernel", kernel)
        object.__setattr__(self, "_ends", np.stack([first, first[::-1]], axis=1))
        object.__setattr__(self, "_transform", fft.rfft(wrapped))
        object.__setattr__(self, "_length", length)

    def deflection(self, pressure: ArrayLike) -> FloatArray:
        """Opening of the gap [m] under nodal pressures [Pa], shape (n,)."""
        p = np.asarray(pressure, dtype=float)
        inner = p.copy()
        inner[0] = inner[-1] = 0.0
        convolved = fft.irfft(fft.rfft(inner, self._length) * self._transform, self._length)[: p.size]
        return convolved + self._ends @ p[[0, -1]]

    def matrix(self) -> FloatArray:
        """Derivative of `deflection` by the pressures [m/Pa], shape (n, n); built at every call."""
        dense = linalg.toeplitz(self.kernel)
        dense[:, [0, -1]] = self._ends
        return dense


def _describe_nodes(space: HalfSpace | HalfSpaceFFT, body: HalfSpaceCylinder, positions: ArrayLike) -> None:
    """Check the nodes; set them, their tributary widths and the parabola x²/(2R) (equation 3-13)."""
    x = np.ascontiguousarray(positions, dtype=float)
    if x.ndim != 1 or x.size < 3 or not np.all(np.diff(x) > 0):
        raise ValueError("a half-space needs at least three nodes in strictly ascending order")
    object.__setattr__(space, "positions", x)
    object.__setattr__(space, "widths", np.diff(control_volume_faces(x)))
    object.__setattr__(space, "base_gap", x**2 / (2 * body.radius))
