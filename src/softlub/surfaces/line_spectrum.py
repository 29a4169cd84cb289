"""The one-sided spectrum C1D+(q) of lines cut through a self-affine surface (equation 4-6, put right)."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import beta, betainc, gamma

from softlub.surfaces.spectrum import SelfAffine


def line_density(spectrum: SelfAffine, wavevector: ArrayLike) -> NDArray[np.float64]:
    """C1D+(q) = 4 ∫ C(√(q² + y²)) dy over y > 0, exact with all cut-offs, so that h_rms² = ∫ C1D+ dq.

    Far from the cut-offs it is `line_factor`·q·C(q).

    Parameters
    ----------
    spectrum : SelfAffine
        The surface's power spectrum C(q).
    wavevector : array_like
        Positive wavevectors along the line [1/m], of any shape.

    Returns
    -------
    ndarray
        C1D+ [m³], of the same shape; zero from the cut-off on.
    """
    q = np.asarray(wavevector, dtype=float)

    def cross(limit: float) -> NDArray[np.float64]:
        return np.sqrt(np.maximum(limit**2 - q**2, 0.0))

    plateau = cross(spectrum.rolloff) - cross(spectrum.plateau_start)
    # ∫ (q² + y²)^(-1-H) dy by v = q²/(q² + y²); the parts near v = 0 do not cancel.
    order = spectrum.hurst + 0.5
    near = betainc(order, 0.5, (q / np.maximum(q, spectrum.rolloff)) ** 2)
    far = betainc(order, 0.5, np.minimum((q / spectrum.cutoff) ** 2, 1.0))
    unlimited = q / 2 * beta(order, 0.5) * (q / spectrum.rolloff) ** (-2 - 2 * spectrum.hurst)
    return np.asarray(4 * spectrum.level * (plateau + unlimited * np.maximum(near - far, 0.0)))


def line_factor(hurst: float) -> float:
    """C1D+(q) / (q C(q)) of an unlimited self-affine branch, 2√π Γ(H + ½)/Γ(H + 1); π at H = 1 only."""
    return float(2 * np.sqrt(np.pi) * gamma(hurst + 0.5) / gamma(hurst + 1))
