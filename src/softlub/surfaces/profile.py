"""A rough line: heights on evenly spaced points, as a stylus scans them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, eq=False)
class Profile:
    """Heights along a line, positive outwards.

    Parameters
    ----------
    heights : ndarray, shape (n,)
        z [m].
    spacing : float
        Distance of neighbouring points [m].
    periodic : bool
        Whether the line repeats itself beyond its ends.

    Raises
    ------
    ValueError
        If the heights are not a finite one-dimensional array of at least 2 points, or the spacing is not positive.
    """

    heights: NDArray[np.float64]
    spacing: float
    periodic: bool = False

    def __post_init__(self) -> None:
        if self.heights.ndim != 1 or self.heights.size < 2:
            raise ValueError(f"heights of shape {self.heights.shape}: at least 2 points on a line are needed")
        if not np.all(np.isfinite(self.heights)):
            bad = int(np.count_nonzero(~np.isfinite(self.heights)))
            raise ValueError(f"{bad} heights are NaN or infinite: fill or cut them out first")
        if not self.spacing > 0:
            raise ValueError(f"spacing {self.spacing:g} m must be above 0")

    @property
    def length(self) -> float:
        """Length of the line [m]; of one period where it is periodic."""
        return self.heights.size * self.spacing

    @property
    def positions(self) -> NDArray[np.float64]:
        """x of the points [m], from 0."""
        return self.spacing * np.arange(self.heights.size, dtype=np.float64)
