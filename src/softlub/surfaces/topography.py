"""A rough surface as heights on an even grid."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, eq=False)
class Topography:
    """Heights of a surface on an even grid, positive outwards (towards the other body).

    Parameters
    ----------
    heights : ndarray, shape (nx, ny)
        z [m]; axis 0 runs along x (the sliding direction), axis 1 along y.
    spacing : float
        Distance of neighbouring points along both axes [m].
    periodic : bool
        Whether the surface repeats itself beyond its edges.

    Raises
    ------
    ValueError
        If the heights are not a finite two-dimensional array of at least 2 by 2 points, or the spacing is not
        positive.
    """

    heights: NDArray[np.float64]
    spacing: float
    periodic: bool = True

    def __post_init__(self) -> None:
        if self.heights.ndim != 2 or min(self.heights.shape) < 2:
            raise ValueError(f"heights of shape {self.heights.shape}: at least 2 by 2 points are needed")
        if not np.all(np.isfinite(self.heights)):
            bad = int(np.count_nonzero(~np.isfinite(self.heights)))
            raise ValueError(f"{bad} heights are NaN or infinite: fill or cut them out first")
        if not self.spacing > 0:
            raise ValueError(f"spacing {self.spacing:g} m must be above 0")

    @property
    def size(self) -> tuple[float, float]:
        """Lengths of the sides [m]; of one period where the surface is periodic."""
        return self.heights.shape[0] * self.spacing, self.heights.shape[1] * self.spacing
