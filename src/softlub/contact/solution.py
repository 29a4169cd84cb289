"""The contact of a rough surface at one load."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from softlub.contact.area import corrected_area_ratio, pixel_area_ratio

FloatArray = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class ContactSolution:
    """Pressure and gap of a rough surface pressed on an elastic half-space, and how they were found.

    Parameters
    ----------
    pressure : ndarray, shape (nx, ny)
        Contact pressure [Pa].
    gap : ndarray, shape (nx, ny)
        Gap [m]; zero in contact to within the tolerance.
    nominal_pressure : float
        Mean pressure that was asked for [Pa].
    rigid_approach : float
        How far the bodies have approached since they touched [m]. Where the surface is periodic: of the mean
        plane of the elastic body's surface, by the convention that a uniform pressure displaces nothing.
    periodic : bool
    full_contact : bool
        Whether every point carries pressure.
    converged : bool
    iterations, convolutions : int
        Convolutions are pairs of transforms of the whole grid.
    residual : float
        Root mean square of the gap over the points that carry pressure or overlap, over h_rms.
    residuals : tuple of float
        The same after every iteration.
    """

    pressure: FloatArray
    gap: FloatArray
    nominal_pressure: float
    rigid_approach: float
    periodic: bool
    full_contact: bool
    converged: bool
    iterations: int
    convolutions: int
    residual: float
    residuals: tuple[float, ...] = field(default=(), repr=False)

    @property
    def mean_gap(self) -> float:
        """Mean of the gap over the whole surface [m]."""
        return float(self.gap.mean())

    @property
    def contact_area_ratio(self) -> float:
        """Real over nominal contact area A/A0, corrected for the pixels along its edge."""
        return 1.0 if self.full_contact else corrected_area_ratio(self.pressure, self.periodic)

    @property
    def contact_area_ratio_pixel(self) -> float:
        """Share of the points that carry pressure."""
        return pixel_area_ratio(self.pressure)

    @property
    def load_error(self) -> float:
        """Relative error of the mean pressure."""
        if self.nominal_pressure == 0:
            return float(self.pressure.max())
        return float(self.pressure.mean() / self.nominal_pressure - 1)

    def failed(self) -> ContactSolution:
        """The same, flagged as not converged: it is not the contact that was asked for."""
        return replace(self, converged=False)
