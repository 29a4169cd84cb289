"""A measured contact edge: points along the plate and their heights, checked to be the lower side of a body."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from softlub.solid.materials.columns import Units, read_columns
from softlub.solid.mesh import FloatArray

LEAST_POINTS = 10

LENGTHS: Units = {"mm": 1e-3, "m": 1.0, "um": 1e-6, "µm": 1e-6, "nm": 1e-9}
"""Units that a column of lengths may have, with their factors to SI."""


@dataclass(frozen=True, eq=False)
class EdgeProfile:
    """Lower side of a body, its lowest point at the origin.

    Parameters
    ----------
    positions : ndarray, shape (n,)
        x, ascending [m].
    heights : ndarray, shape (n,)
        y above the lowest point [m].
    """

    positions: FloatArray
    heights: FloatArray

    @property
    def width(self) -> float:
        """Extent along x [m]."""
        return float(self.positions[-1] - self.positions[0])

    @property
    def middle(self) -> float:
        """x halfway between the ends [m]."""
        return float(self.positions[-1] + self.positions[0]) / 2

    def at(self, positions: FloatArray) -> FloatArray:
        """Heights between the points, without overshoot; beyond the ends that of the end.

        Parameters
        ----------
        positions : ndarray, shape (k,)
            x [m].

        Returns
        -------
        ndarray, shape (k,)
            y [m].
        """
        from scipy.interpolate import PchipInterpolator

        inside = np.clip(positions, self.positions[0], self.positions[-1])
        return np.asarray(PchipInterpolator(self.positions, self.heights)(inside), dtype=np.float64)

    @property
    def area_below(self) -> float:
        """Area between the edge and the level of its lowest point [m²]."""
        from scipy.interpolate import PchipInterpolator

        curve = PchipInterpolator(self.positions, self.heights)
        return float(curve.integrate(self.positions[0], self.positions[-1]))


def edge_profile(x: FloatArray, y: FloatArray) -> EdgeProfile:
    """The lower side of a body through points in their order along it.

    Parameters
    ----------
    x, y : ndarray, shape (n,)
        Along the plate, from either end, and upwards, from any level [m].

    Returns
    -------
    EdgeProfile

    Raises
    ------
    ValueError
        If there are fewer than 10 points, one is not finite, the line crosses itself, or it has two heights at one x.
        The message names the points, counted from 1.
    """
    if x.shape != y.shape or x.ndim != 1 or x.size < LEAST_POINTS:
        raise ValueError(
            f"a contact edge of {x.size} points; at least {LEAST_POINTS} are needed, better one for every contact node"
        )
    bad = np.flatnonzero(~(np.isfinite(x) & np.isfinite(y)))
    if bad.size:
        raise ValueError(
            f"point {bad[0] + 1} is not finite: ({x[bad[0]]}, {y[bad[0]]}); delete it or measure again"
        )
    direction = 1 if x[-1] > x[0] else -1
    turns = np.flatnonzero(direction * np.diff(x) <= 0)
    if turns.size:
        _refuse_turn(x, y, int(turns[0]))
    x, y = x[::direction], y[::direction]
    return EdgeProfile(x - x[y == y.min()].mean(), y - y.min())


def read_edge(path: str | Path) -> EdgeProfile:
    """Read a contact edge from a CSV file with the columns x and y and their units in the header.

    Parameters
    ----------
    path : str or Path

    Returns
    -------
    EdgeProfile

    Raises
    ------
    ValueError
        If the file is no such table (see `softlub.solid.materials.columns`), or its points make no lower side of a
        body (see `edge_profile`). The message names the file and the line or the point.
    FileNotFoundError
        If there is no such file.
    """
    columns = read_columns(path, {"x": LENGTHS, "y": LENGTHS}).columns
    try:
        return edge_profile(columns["x"], columns["y"])
    except ValueError as error:
        raise ValueError(f"{path}: {error} (point 1 stands in the first row below the header)") from None


def _refuse_turn(x: FloatArray, y: FloatArray, first: int) -> None:
    """Say whether a line that does not go on along x crosses itself or only turns back."""
    crossing = _crossing(x, y)
    if crossing:
        one, other = crossing
        raise ValueError(
            f"the contact edge crosses itself: the piece from point {one + 1} to {one + 2} and that from point "
            f"{other + 1} to {other + 2} meet; delete the loop between them, or put the points in their order along "
            "the edge"
        )
    raise ValueError(
        f"the contact edge has two heights at one x: from point {first + 1} (x = {x[first]:g} m) to point {first + 2} "
        f"(x = {x[first + 1]:g} m) it does not go on along the plate; keep the part below, that can touch the plate, "
        "and put its points in their order along x"
    )


def _crossing(x: FloatArray, y: FloatArray) -> tuple[int, int] | None:
    """The first two pieces of a line that cross, by the numbers of their first points."""
    start, end = np.stack([x[:-1], y[:-1]], axis=1), np.stack([x[1:], y[1:]], axis=1)
    for piece in range(len(start) - 2):
        others = slice(piece + 2, None)
        ends_apart = (
            _side(start[piece], end[piece], start[others]) * _side(start[piece], end[piece], end[others]) < 0
        )
        own_apart = (
            _side(start[others], end[others], start[piece]) * _side(start[others], end[others], end[piece])
            < 0
        )
        found = np.flatnonzero(ends_apart & own_apart)
        if found.size:
            return piece, piece + 2 + int(found[0])
    return None


def _side(start: FloatArray, end: FloatArray, point: FloatArray) -> FloatArray:
    """Positive for points on the left of the way from start to end."""
    way, away = end - start, point - start
    return np.asarray(way[..., 0] * away[..., 1] - way[..., 1] * away[..., 0])
