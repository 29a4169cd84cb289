"""Moments of the self-affine spectrum against quadrature of the spectrum itself."""

import numpy as np
import pytest
from scipy.integrate import quad

from softlub.surfaces.spectrum import SelfAffine

SURFACES = [
    SelfAffine(1e-6, 0.8, 1e4, 0.78e10),
    SelfAffine(3e-6, 1.0, 2e5, 3e7),
    SelfAffine(0.5e-6, 0.3, 1e5, 1e7, long_cutoff=2e4),
    SelfAffine(1e-6, 0.5, 6.3e4, 8e6, long_cutoff=3.1e4),
]


def spectrum_integral(surface, power):
    """∫ q^power C dq by quadrature in ln q, C written down from its definition, with C(q_r) = 1."""

    def plateau(logarithm):
        return np.exp((power + 1) * logarithm)

    def branch(logarithm):
        return np.exp(
            (power + 1) * logarithm - (2 + 2 * surface.hurst) * (logarithm - np.log(surface.rolloff))
        )

    start = np.log(surface.long_cutoff or surface.rolloff)
    bend, stop = np.log(surface.rolloff), np.log(surface.cutoff)
    options = {"epsabs": 0, "epsrel": 1e-12}
    upper = quad(branch, bend, stop, **options)[0]
    return upper if start == bend else upper + quad(plateau, start, bend, **options)[0]


@pytest.mark.parametrize("surface", SURFACES)
@pytest.mark.parametrize("power", [1, 2, 3, 5])
def test_moments_are_integrals_of_the_spectrum(surface, power):
    assert surface.moment(power) == pytest.approx(
        surface.level * spectrum_integral(surface, power), rel=1e-10
    )


@pytest.mark.parametrize("surface", SURFACES)
def test_height_and_slope_come_from_the_spectrum(surface):
    level = surface.rms_roughness**2 / (2 * np.pi * spectrum_integral(surface, 1))
    assert surface.level == pytest.approx(level, rel=1e-10)
    slope = np.sqrt(2 * np.pi * level * spectrum_integral(surface, 3))
    assert surface.rms_slope == pytest.approx(slope, rel=1e-10)


def test_logarithmic_moment_is_the_limit_of_its_neighbours():
    """H = 1 makes the slope's integral a logarithm: the closed form must pass through it smoothly."""
    at = SelfAffine(1e-6, 1.0, 1e4, 1e8).rms_slope
    below = SelfAffine(1e-6, 1.0 - 1e-9, 1e4, 1e8).rms_slope
    assert at == pytest.approx(below, rel=1e-7)


def test_height_is_that_of_the_whole_spectrum():
    """The plateau takes its part of h_rms²: equation 4-5 without it would be too rough by 1 + H(1 - (q_L/q_r)²)."""
    surface = SelfAffine(1e-6, 0.8, 1e4, 1e12, long_cutoff=0.5e4)
    without = SelfAffine(1e-6, 0.8, 1e4, 1e12)
    assert without.level / surface.level == pytest.approx(1 + 0.8 * (1 - 0.25), rel=1e-6)


def test_source_area_constant_is_the_slope_in_disguise():
    """Equation 3-33, χ = (πG')^(-1/2) with G' = (π/4) ∫ q³C dq, equals √(8/π)/h'_rms."""
    surface = SURFACES[0]
    chi = 1 / np.sqrt(np.pi * np.pi / 4 * surface.moment(3))
    assert chi == pytest.approx(np.sqrt(8 / np.pi) / surface.rms_slope, rel=1e-12)


def test_wavevectors_out_of_order_are_refused():
    with pytest.raises(ValueError, match="must lie above rolloff"):
        SelfAffine(1e-6, 0.8, 1e4, 1e4)
    with pytest.raises(ValueError, match="must not exceed rolloff"):
        SelfAffine(1e-6, 0.8, 1e4, 1e8, long_cutoff=2e4)
