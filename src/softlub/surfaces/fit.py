"""Hurst exponent and roll-off from a measured spectrum (figure 6-4)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.optimize import minimize_scalar

from softlub.surfaces.spectrum import SelfAffine

ROUNDING = 1e-24
"""Share of the largest density below which a density is rounding."""


@dataclass(frozen=True)
class SelfAffineFit:
    """A self-affine spectrum fitted to a measured one.

    Attributes
    ----------
    hurst : float
        Hurst exponent H from the slope −2(1 + H); a measured spectrum may give one outside (0, 1].
    rolloff : float
        Roll-off wavevector q_r [1/m]; the lower end of the range where no plateau shows.
    level : float
        C(q_r) [m⁴].
    lowest, highest : float
        Range of wavevectors fitted [1/m].
    residual : float
        Root mean square difference of log10 C between fit and measurement.
    """

    hurst: float
    rolloff: float
    level: float
    lowest: float
    highest: float
    residual: float

    @property
    def spectrum(self) -> SelfAffine:
        """The fit as a surface's spectrum between the ends of the range fitted.

        Raises
        ------
        ValueError
            If the fitted H lies outside (0, 1].
        """
        long_cutoff = self.lowest if self.lowest < self.rolloff * (1 - 1e-9) else None
        unit = SelfAffine(1.0, self.hurst, self.rolloff, self.highest, long_cutoff)
        return SelfAffine(
            float(np.sqrt(self.level / unit.level)), self.hurst, self.rolloff, self.highest, long_cutoff
        )


def fit_self_affine(
    wavevector: ArrayLike, density: ArrayLike, lowest: float | None = None, highest: float | None = None
) -> SelfAffineFit:
    """Fit a plateau and a self-affine branch to C(q) by least squares of log C.

    For each roll-off the best level and H follow linearly; the roll-off that leaves the least is sought on a scan of
    the range and refined. Bins of equal width on a logarithmic scale weigh all decades alike.

    Parameters
    ----------
    wavevector, density : array_like, shape (n,)
        q [1/m] and C(q) [m⁴], as `radial_power_spectrum(topography, bins_per_decade=…)` gives them.
    lowest, highest : float, optional
        Wavevectors between which to fit [1/m]; below lies the window's or the form's trace, above it the
        instrument's noise.

    Returns
    -------
    SelfAffineFit
        The fit; look at its residual.

    Raises
    ------
    ValueError
        If fewer than 4 wavevectors with a positive density lie in the range.
    """
    q, measured = (np.asarray(values, dtype=float) for values in (wavevector, density))
    # Modes that a surface does not have hold the transform's rounding.
    kept = (
        (measured > ROUNDING * np.max(measured, initial=0.0))
        & (q >= (lowest or 0.0))
        & (q <= (highest or np.inf))
    )
    if np.count_nonzero(kept) < 4:
        raise ValueError(
            f"{np.count_nonzero(kept)} wavevectors with a positive density between {lowest or 0:g} and "
            f"{highest or np.inf:g} 1/m: at least 4 are needed to fit a Hurst exponent and a roll-off"
        )
    x, y = np.log(q[kept]), np.log(measured[kept])
    # Two points at least must lie on the branch.
    scan = np.linspace(x[0], x[-2], 200, endpoint=False)
    best = int(np.argmin([_branch(x, y, bend)[2] for bend in scan]))
    step = scan[1] - scan[0]
    refined = minimize_scalar(
        lambda bend: _branch(x, y, bend)[2],
        bounds=(max(x[0], scan[best] - step), scan[best] + step),
        method="bounded",
        options={"xatol": 1e-10},
    )
    # The scan's own first point is the case without a plateau, which the open search never reaches.
    bend = float(min((refined.x, scan[best]), key=lambda value: _branch(x, y, value)[2]))
    intercept, slope, squares = _branch(x, y, bend)
    return SelfAffineFit(
        hurst=-slope / 2 - 1,
        rolloff=float(np.exp(bend)),
        level=float(np.exp(intercept)),
        lowest=float(q[kept][0]),
        highest=float(q[kept][-1]),
        residual=float(np.sqrt(squares / x.size) / np.log(10)),
    )


def _branch(x: NDArray[np.float64], y: NDArray[np.float64], bend: float) -> tuple[float, float, float]:
    """Best level and slope of y = level + slope·max(x − bend, 0), and the sum of squares that they leave."""
    rise = np.maximum(x - bend, 0.0)
    centred = rise - rise.mean()
    slope = float(centred @ y / (centred @ centred))
    level = float(y.mean() - slope * rise.mean())
    return level, slope, float(np.sum((y - level - slope * rise) ** 2))
