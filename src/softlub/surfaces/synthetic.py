"""A synthetic surface or line as a study names it: its spectrum, and the pieces of it that are made.

Only names and numbers, and the one check that needs both: nothing here makes a surface.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated, Literal

from softlub.surfaces.measurement import Form
from softlub.surfaces.spectrum import SelfAffine
from softlub.units import Length, Unit

Target = Literal["rms_roughness", "rms_slope"]
Points = Annotated[int, Unit("1", at_least=2, at_most=65536)]
Seed = Annotated[int, Unit("1", at_least=0, at_most=2**31 - 1)]

# Wavelengths are often quoted rounded, as 7.81e-7 m for two spacings of 3.90625e-7 m.
NYQUIST_TOLERANCE = 1e-3


def resolved_cutoff(spectrum: SelfAffine, spacing: float) -> float:
    """q_s as far as a grid resolves it [1/m].

    Raises
    ------
    ValueError
        If it lies more than 0.1 % beyond the grid's Nyquist wavevector.
    """
    nyquist = math.pi / spacing
    if spectrum.cutoff > nyquist * (1 + NYQUIST_TOLERANCE):
        raise ValueError(
            f"cutoff {spectrum.cutoff:.6g} 1/m lies beyond the grid's Nyquist wavevector {nyquist:.6g} 1/m "
            f"(spacing {spacing:.4g} m) by more than {NYQUIST_TOLERANCE:.1%}: "
            "take more points, a smaller size or a lower cutoff"
        )
    return min(spectrum.cutoff, nyquist)


@dataclass(frozen=True)
class Synthetic(SelfAffine):
    """A self-affine surface and the square pieces of it that are made where its heights are needed.

    Parameters
    ----------
    rms_roughness, hurst, rolloff, cutoff, long_cutoff
        As in `SelfAffine`.
    size : float, optional
        Side of the piece [m].
    points : int, optional
        Points along each side.
    seed : int
        Seed of the first realisation; the others follow it.
    realisations : int, optional
        Number of pieces that are made and averaged over; left to the accuracy of the study otherwise.
    target : {"rms_roughness", "rms_slope"}
        Which of the spectrum's two moments each piece has exactly.
    wavevectors : {"linear", "exponential"}
        Spacing of the waves; exponential ones distort the spectrum and are there for comparison.
    """

    size: Length | None = None
    points: Points | None = None
    seed: Seed = 1
    realisations: Annotated[int, Unit("1", at_least=1, at_most=100)] | None = None
    target: Target = "rms_roughness"
    wavevectors: Literal["linear", "exponential"] = "linear"

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.size is not None and self.points is not None:
            resolved_cutoff(self, self.size / self.points)


@dataclass(frozen=True)
class SyntheticLine(SelfAffine):
    """A line cut through a self-affine surface, laid over a form, as a stylus would find it.

    Parameters
    ----------
    rms_roughness, hurst, rolloff, cutoff, long_cutoff
        As in `SelfAffine`; what is longer than `waviness_wavelength` is the waviness.
    length : float
        Length of the scan [m]; the line is made twice as long, so that its ends do not meet.
    points : int
        Points of the scan.
    seed : int
        Seed of the phases.
    rise, sag : float
        Form: how far the last point lies above the first, and the middle below their chord [m].
    form : {"mean", "tilt", "curvature"}
        What is taken off first, in the sense of least squares.
    waviness_wavelength : float, optional
        Cut-off of the Gaussian filter that takes the waviness off [m]; none without it.
    """

    # Dataclasses want a default after the spectrum's; both are checked below.
    length: Length | None = None
    points: Points | None = None
    seed: Seed = 1
    rise: Annotated[float, Unit("m")] = 0.0
    sag: Annotated[float, Unit("m")] = 0.0
    form: Form = "tilt"
    waviness_wavelength: Length | None = None

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.length is None or self.points is None:
            raise ValueError("a line needs its length and its points")
        resolved_cutoff(self, self.length / self.points)
