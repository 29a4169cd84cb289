"""The self-affine roughness power spectrum and its moments in closed form.

C(q) is the two-dimensional isotropic spectrum, normalised by h_rms² = 2π ∫ C(q) q dq:
constant on [q_L, q_r] (the plateau) and C_r (q/q_r)^(-2-2H) on [q_r, q_s]; zero elsewhere.
Without a plateau q_L = q_r, which is what the source's chapter 3 uses (its figure 3-3, D_f = 3 - H).
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from softlub.units import HurstExponent, Length, Wavevector


@dataclass(frozen=True)
class SelfAffine:
    """Self-affine surface by its spectrum.

    Parameters
    ----------
    rms_roughness : float
        Root mean square height h_rms of the whole spectrum, plateau included [m].
    hurst : float
        Hurst exponent H in (0, 1].
    rolloff : float
        Roll-off wavevector q_r, where the self-affine branch begins [1/m].
    cutoff : float
        Short-wavelength cut-off q_s [1/m].
    long_cutoff : float, optional
        Long-wavelength cut-off q_L <= q_r [1/m]; q_r when it is left out: no plateau.

    Raises
    ------
    ValueError
        If H lies outside (0, 1], a length or wavevector is not positive and finite, or the cut-offs are not in the
        order q_L <= q_r < q_s.
    """

    rms_roughness: Length
    hurst: HurstExponent
    rolloff: Wavevector
    cutoff: Wavevector
    long_cutoff: Wavevector | None = None

    def __post_init__(self) -> None:
        if not 0 < self.hurst <= 1:
            raise ValueError(f"hurst {self.hurst:g} must be above 0 and at most 1")
        for name in ("rms_roughness", "rolloff", "cutoff", "long_cutoff"):
            value = getattr(self, name)
            if value is not None and not 0 < value < np.inf:
                raise ValueError(f"{name} {value:g} must be positive and finite")
        if not self.cutoff > self.rolloff:
            raise ValueError(
                f"cutoff {self.cutoff:g} 1/m must lie above rolloff {self.rolloff:g} 1/m; raise cutoff or lower rolloff"
            )
        if self.long_cutoff is not None and self.long_cutoff > self.rolloff:
            raise ValueError(
                f"long_cutoff {self.long_cutoff:g} 1/m must not exceed rolloff {self.rolloff:g} 1/m; "
                "leave it out for a spectrum without a plateau"
            )

    @classmethod
    def from_rms_slope(
        cls, rms_slope: float, hurst: float, rolloff: float, cutoff: float, long_cutoff: float | None = None
    ) -> SelfAffine:
        """Make the spectrum that has a given root mean square slope h'_rms instead of a given h_rms.

        Parameters
        ----------
        rms_slope : float
            h'_rms of the whole spectrum.
        hurst, rolloff, cutoff, long_cutoff
            As in the class.
        """
        if not 0 < rms_slope < np.inf:
            raise ValueError(f"rms_slope {rms_slope:g} must be positive and finite")
        unit = cls(1.0, hurst, rolloff, cutoff, long_cutoff)
        return replace(unit, rms_roughness=rms_slope / unit.rms_slope)

    @property
    def plateau_start(self) -> float:
        """q_L [1/m]: `long_cutoff`, or q_r where there is no plateau."""
        return self.rolloff if self.long_cutoff is None else self.long_cutoff

    @property
    def level(self) -> float:
        """C(q_r) [m⁴], from h_rms² = 2π ∫ C q dq."""
        return self.rms_roughness**2 / (2 * np.pi * self._relative_moment(1))

    def density(self, wavevector: ArrayLike) -> NDArray[np.float64]:
        """C(q) [m⁴] at wavevectors [1/m] of any shape; zero beyond q_L and q_s (equation 4-5)."""
        q = np.asarray(wavevector, dtype=float)
        branch = self.level * np.maximum(q / self.rolloff, 1.0) ** (-2 - 2 * self.hurst)
        return np.where((q >= self.plateau_start) & (q <= self.cutoff), branch, 0.0)

    def moment(self, power: int) -> float:
        """∫ q^power C(q) dq over the whole spectrum, in closed form [m^(3 - power)]."""
        return self.level * self._relative_moment(power)

    def _relative_moment(self, power: int) -> float:
        exponent = power - 1 - 2 * self.hurst
        ratio = np.log(self.cutoff / self.rolloff)
        # expm1 keeps the value through exponent = 0, where the integral is the logarithm.
        branch = ratio if exponent == 0 else np.expm1(exponent * ratio) / exponent
        plateau = (1 - (self.plateau_start / self.rolloff) ** (power + 1)) / (power + 1)
        return float(self.rolloff ** (power + 1) * (branch + plateau))

    @property
    def rms_slope(self) -> float:
        """Root mean square slope h'_rms, from h'_rms² = 2π ∫ C q³ dq."""
        return float(np.sqrt(2 * np.pi * self.moment(3)))

    @property
    def nayak_parameter(self) -> float:
        """Nayak's bandwidth m0 m4 / m2² of a line's moments, 3/2 ∫Cq dq ∫Cq⁵ dq / (∫Cq³ dq)²."""
        return 1.5 * self.moment(1) * self.moment(5) / self.moment(3) ** 2


@dataclass(frozen=True)
class Smooth:
    """A surface without roughness: no asperity ever touches."""

    @property
    def rms_roughness(self) -> float:
        """Zero [m]."""
        return 0.0
