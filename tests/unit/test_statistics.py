"""Statistics, spectra and fits against closed forms and against SurfaceTopography."""

from __future__ import annotations

import warnings
from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.special import j0

from softlub.surfaces import Profile, SelfAffine, Topography, describe, synthesize
from softlub.surfaces.autocorrelation import autocorrelation
from softlub.surfaces.fit import fit_self_affine
from softlub.surfaces.line_spectrum import line_density, line_factor
from softlub.surfaces.power_spectra import power_spectrum_map, profile_power_spectrum, radial_power_spectrum
from softlub.surfaces.slopes import (
    central_difference_rms_slope,
    forward_difference_rms_slope,
    nayak_parameter,
    spectral_rms_slope,
)
from softlub.surfaces.statistics import average_roughness, height_distribution, kurtosis, skewness
from softlub.surfaces.surface_topography import as_surface_topography

SPECTRUM = SelfAffine(
    1e-6, 0.8, rolloff=2 * np.pi / 1e-4, cutoff=2 * np.pi / 1.25e-5, long_cutoff=2 * np.pi / 2e-4
)


@pytest.fixture(scope="module")
def surface() -> Topography:
    return synthesize(SPECTRUM, 8e-4, 256, seed=1)


def wave(points: int = 96, amplitude: float = 2e-6, number: int = 3) -> Profile:
    phase = 2 * np.pi * number * np.arange(points) / points
    return Profile(amplitude * np.cos(phase + 0.3), 1e-6, periodic=True)


def test_amplitudes_of_a_sine():
    statistics = describe(wave(points=960))
    assert statistics.average_roughness == pytest.approx(2e-6 * 2 / np.pi, rel=1e-3)
    assert statistics.rms_roughness == pytest.approx(2e-6 / np.sqrt(2), rel=1e-12)
    assert statistics.skewness == pytest.approx(0, abs=1e-9)
    assert statistics.kurtosis == pytest.approx(1.5, rel=1e-9)
    assert statistics.nayak_parameter == pytest.approx(1.0, rel=1e-9)


def test_each_slope_estimator_of_a_sine():
    line, wavevector = wave(), 2 * np.pi * 3 / 96e-6
    exact = 2e-6 * wavevector / np.sqrt(2)
    assert spectral_rms_slope(line) == pytest.approx(exact, rel=1e-12)
    half = wavevector * line.spacing / 2
    assert forward_difference_rms_slope(line) == pytest.approx(exact * np.sin(half) / half, rel=1e-12)
    assert central_difference_rms_slope(line) == pytest.approx(
        exact * np.sin(2 * half) / (2 * half), rel=1e-12
    )


def test_slope_of_an_area_is_that_of_its_gradient():
    x, y = np.meshgrid(np.arange(60), np.arange(40), indexing="ij")
    heights = 1e-7 * np.cos(2 * np.pi * (2 * x / 60 + 3 * y / 40))
    area = Topography(heights, 1e-6)
    wavevector = 2 * np.pi * np.hypot(2 / 60e-6, 3 / 40e-6)
    assert spectral_rms_slope(area) == pytest.approx(1e-7 * wavevector / np.sqrt(2), rel=1e-12)
    assert nayak_parameter(area) == pytest.approx(1.5, rel=1e-9)


@pytest.mark.parametrize("estimator", [forward_difference_rms_slope, central_difference_rms_slope])
def test_differences_stay_within_the_edges_of_a_finite_surface(estimator):
    plane = 0.02 * np.arange(20)[:, None] * 1e-6 + 0.05 * np.arange(30) * 1e-6
    assert estimator(Topography(plane, 1e-6, periodic=False)) == pytest.approx(np.hypot(0.02, 0.05), rel=1e-9)
    assert estimator(Topography(plane, 1e-6, periodic=True)) > 0.1
    with pytest.raises(ValueError, match="points"):
        central_difference_rms_slope(Topography(plane[:2, :2], 1e-6))


def test_estimators_against_surface_topography(surface):
    library = as_surface_topography(surface)
    assert forward_difference_rms_slope(surface) == pytest.approx(library.rms_gradient(), rel=1e-9)


def test_gaussian_heights_have_gaussian_moments():
    heights = np.random.default_rng(3).normal(scale=1e-6, size=(400, 400))
    area = Topography(heights, 1e-6)
    assert skewness(area) == pytest.approx(0, abs=0.03)
    assert kurtosis(area) == pytest.approx(3, abs=0.06)
    assert average_roughness(area) == pytest.approx(1e-6 * np.sqrt(2 / np.pi), rel=0.01)
    height, density = height_distribution(area, bins=41)
    assert np.sum(density) * (height[1] - height[0]) == pytest.approx(1, rel=1e-12)
    middle = np.abs(height) < 1e-6
    gaussian = np.exp(-((height / 1e-6) ** 2) / 2) / (1e-6 * np.sqrt(2 * np.pi))
    np.testing.assert_allclose(density[middle], gaussian[middle], rtol=0.05)


def test_skewness_tells_peaks_from_valleys():
    heights = np.zeros((8, 8))
    heights[2, 3] = 1e-6
    assert skewness(Topography(heights, 1e-6)) > 5
    assert skewness(Topography(-heights, 1e-6)) < -5


def test_more_plateau_makes_heights_more_gaussian():
    """Claim of section 4.6.2: the wider the plateau, the nearer the heights to Gaussian."""
    deviations = []
    for longest in (1e-4, 8e-4):
        spectrum = SelfAffine(1e-6, 0.8, 2 * np.pi / 1e-4, 2 * np.pi / 6.25e-6, 2 * np.pi / longest)
        surfaces = [
            synthesize(spectrum, 2 * longest, round(2 * longest / 3.125e-6), seed) for seed in range(6)
        ]
        deviations.append(np.sqrt(np.mean([skewness(s) ** 2 + (kurtosis(s) - 3) ** 2 for s in surfaces])))
    assert deviations[1] < 0.5 * deviations[0]


@pytest.mark.parametrize("statistic", [describe, skewness, kurtosis, nayak_parameter])
def test_a_constant_surface_has_no_statistics(statistic):
    with pytest.raises(ValueError, match="all heights are equal"):
        statistic(Topography(np.full((4, 4), 2.0), 1e-6))


@pytest.mark.parametrize("shape", [(32, 32), (33, 32), (32, 33), (31, 47), (2, 5)])
@pytest.mark.parametrize("periodic", [True, False])
def test_map_holds_all_the_power(shape, periodic):
    heights = np.random.default_rng(1).normal(size=shape)
    area = Topography(heights, 1e-3, periodic)
    spectrum = power_spectrum_map(area)
    assert spectrum.density.shape == shape
    cell = (2 * np.pi) ** 2 / (area.size[0] * area.size[1])
    if periodic:
        assert np.sum(spectrum.density) * cell == pytest.approx(np.var(heights), rel=1e-12)
        reference = np.abs(np.fft.fft2(heights - heights.mean())) ** 2 / heights.size**2 / cell
        np.testing.assert_allclose(spectrum.density, np.fft.fftshift(reference), rtol=1e-9, atol=1e-20)
    else:
        assert 0.1 * np.var(heights) < np.sum(spectrum.density) * cell < 3 * np.var(heights)


@pytest.mark.parametrize("shape", [(64, 64), (63, 64), (48, 81)])
def test_spectra_against_surface_topography(shape):
    spectrum = SelfAffine(1e-6, 0.8, 5e4, 3e5, 2e4)
    area = synthesize(spectrum, tuple(1e-5 * n for n in shape), shape, seed=1)
    library = as_surface_topography(area)
    edges = np.geomspace(2e4, np.pi / 1e-5, 8)
    _, theirs = library.power_spectrum_from_area(collocation=edges)
    _, _, whole = library.power_spectrum_from_area(return_map=True)
    ours = power_spectrum_map(area)
    np.testing.assert_allclose(
        ours.density, np.fft.fftshift(whole) / (2 * np.pi) ** 2, rtol=1e-6, atol=1e-12 * ours.density.max()
    )
    magnitude = np.hypot(ours.wavevector_x[:, None], ours.wavevector_y)
    inside = (magnitude > edges[2]) & (magnitude <= edges[3])
    assert np.mean(ours.density[inside]) == pytest.approx(theirs[2] / (2 * np.pi) ** 2, rel=1e-9)
    wavevector, lines = library.power_spectrum_from_profile(resampling_method=None)
    mine = profile_power_spectrum(area)
    count = wavevector.size - 1
    np.testing.assert_allclose(mine.wavevector[:count], wavevector[1:], rtol=1e-12)
    np.testing.assert_allclose(mine.density[:count], lines[1:] / np.pi, rtol=1e-9, atol=1e-15 * lines.max())


def test_radial_average_returns_the_spectrum(surface):
    for bins in (None, 12):
        spectrum = radial_power_spectrum(surface, bins)
        kept = (spectrum.wavevector > 1.2 * SPECTRUM.rolloff) & (spectrum.wavevector < 0.85 * SPECTRUM.cutoff)
        ratio = spectrum.density[kept] / SPECTRUM.density(spectrum.wavevector[kept])
        assert kept.sum() >= 5
        assert np.abs(ratio / ratio[-1] - 1).max() < (0.05 if bins is None else 0.1)
    rings = radial_power_spectrum(surface)
    assert rings.wavevector[-1] <= np.pi / surface.spacing * (1 + 1e-9)
    cell = (2 * np.pi) ** 2 / (surface.size[0] * surface.size[1])
    assert np.sum(rings.density * rings.modes) * cell == pytest.approx(np.var(surface.heights), rel=1e-9)


@pytest.mark.parametrize(("hurst", "factor"), [(1.0, np.pi), (0.8, 3.4158), (0.5, 4.0)])
def test_factor_between_line_and_area_spectrum(hurst, factor):
    assert line_factor(hurst) == pytest.approx(factor, rel=1e-4)
    spectrum = SelfAffine(1e-6, hurst, 1e4, 1e9, 5e3)
    wavevector = np.array([1e5, 1e6])
    np.testing.assert_allclose(
        line_density(spectrum, wavevector), factor * wavevector * spectrum.density(wavevector), rtol=1e-3
    )


@pytest.mark.parametrize("long_cutoff", [None, 3e4])
def test_line_spectrum_is_the_projection_of_the_area_spectrum(long_cutoff):
    spectrum = SelfAffine(1e-6, 0.6, 1e5, 1e6, long_cutoff)
    for wavevector in (1e3, 2e4, 6e4, 2e5, 9e5):
        bends = [np.sqrt(max(end**2 - wavevector**2, 0.0)) for end in (3e4, 1e5, 1e6)]
        by_number = 4 * sum(
            quad(lambda y: float(spectrum.density(np.hypot(wavevector, y))), low, high, epsabs=0)[0]  # noqa: B023
            for low, high in zip([0.0, *bends], bends, strict=False)
            if high > low
        )
        assert float(line_density(spectrum, wavevector)) == pytest.approx(by_number, rel=1e-6)
    total = quad(
        lambda q: float(line_density(spectrum, q)), 1e-3, 1e6, points=[3e4, 1e5], limit=300, epsabs=0
    )[0]
    assert total == pytest.approx(1e-12, rel=1e-4)


@pytest.mark.parametrize("hurst", [0.2, 0.5, 0.8, 1.0])
@pytest.mark.parametrize("long_cutoff", [None, 3e4])
def test_closed_moments_are_integrals_of_the_density(hurst, long_cutoff):
    spectrum = SelfAffine(1e-6, hurst, 1e5, 1e6, long_cutoff)

    def integral(power: int) -> float:
        pieces = [(spectrum.plateau_start, 1e5), (1e5, 1e6)]
        return sum(
            quad(lambda q: q**power * float(spectrum.density(q)), a, b, epsabs=0)[0] for a, b in pieces
        )

    for power in (1, 2, 3, 5):
        assert spectrum.moment(power) == pytest.approx(integral(power), rel=1e-9)
    assert 2 * np.pi * spectrum.moment(1) == pytest.approx(1e-12, rel=1e-12)
    assert spectrum.nayak_parameter == pytest.approx(
        1.5 * integral(1) * integral(5) / integral(3) ** 2, rel=1e-9
    )


@pytest.mark.parametrize("periodic", [True, False])
def test_autocorrelation_against_surface_topography(surface, periodic):
    measured = replace(surface, periodic=periodic)
    line = Profile(surface.heights[:, 3], surface.spacing, periodic)
    ours = autocorrelation(line)
    heights = line.heights - line.heights.mean()
    lag = 7
    pairs = heights * np.roll(heights, -lag) if periodic else heights[:-lag] * heights[lag:]
    assert ours.covariance[lag] == pytest.approx(np.mean(pairs), rel=1e-9)
    assert ours.distance[lag] == pytest.approx(lag * line.spacing)
    area = autocorrelation(measured)
    assert area.covariance[0] == pytest.approx(np.var(surface.heights), rel=1e-12)
    assert area.distance.size == 129


def test_autocorrelation_is_the_transform_of_the_spectrum():
    """R(r) = 2π ∫ C(q) J0(q r) q dq, on a surface large enough to average itself."""
    spectrum = SelfAffine(1e-6, 0.8, 2e5, 1.6e6, 1e5)
    area = synthesize(spectrum, 32 * 2 * np.pi / 1e5, 1600, seed=1)
    measured = autocorrelation(area)
    q = np.geomspace(1e5, 1.6e6, 20001)
    for index in (3, 8, 15):
        r = measured.distance[index]
        exact = 2 * np.pi * np.trapezoid(spectrum.density(q) * j0(q * r) * q, q)
        assert measured.covariance[index] == pytest.approx(exact, abs=5e-3 * 1e-12)


@pytest.mark.parametrize(("hurst", "rolloff"), [(0.8, 1e5), (0.3, 2e5), (1.0, 5e4)])
def test_fit_returns_hurst_exponent_and_rolloff(hurst, rolloff):
    spectrum = SelfAffine(1e-6, hurst, rolloff, 3e6, 1e4)
    q = np.geomspace(1.2e4, 2.9e6, 40)
    fit = fit_self_affine(q, spectrum.density(q))
    assert fit.hurst == pytest.approx(hurst, abs=1e-6)
    assert fit.rolloff == pytest.approx(rolloff, rel=1e-5)
    assert fit.residual < 1e-6
    if hurst < 1:
        assert fit.spectrum.level == pytest.approx(spectrum.level, rel=1e-5)


def test_fit_without_a_plateau_begins_at_the_lowest_wavevector():
    q = np.geomspace(1e5, 1e7, 30)
    fit = fit_self_affine(q, SelfAffine(1e-6, 0.7, 1e5, 1e7).density(q))
    assert fit.rolloff == pytest.approx(1e5, rel=1e-6)
    assert fit.hurst == pytest.approx(0.7, abs=1e-6)
    assert fit.spectrum.long_cutoff is None


def test_fit_of_a_synthetic_surface():
    spectrum = SelfAffine(1e-6, 0.8, 2 * np.pi / 1e-4, 2 * np.pi / 1.5625e-6, 2 * np.pi / 8e-4)
    area = synthesize(spectrum, 8e-4, 1024, seed=1)
    measured = radial_power_spectrum(area, bins_per_decade=12)
    fit = fit_self_affine(measured.wavevector, measured.density, highest=0.9 * spectrum.cutoff)
    assert fit.hurst == pytest.approx(0.8, abs=0.02)
    assert fit.rolloff == pytest.approx(spectrum.rolloff, rel=0.1)


def test_fit_of_noise_says_that_it_is_no_self_affine_surface():
    noise = Topography(np.random.default_rng(1).normal(size=(128, 128)), 1e-6)
    measured = radial_power_spectrum(noise, bins_per_decade=10)
    fit = fit_self_affine(measured.wavevector, measured.density)
    with pytest.raises(ValueError, match="hurst"):
        _ = fit.spectrum
    with pytest.raises(ValueError, match="at least 4"):
        fit_self_affine(measured.wavevector, measured.density, lowest=1e9)


def test_finite_surfaces_are_windowed(surface):
    """A tilt on a finite surface would otherwise fill the spectrum with its jump at the edge."""
    tilted = surface.heights + 1e-5 * np.linspace(0, 1, 256)[:, None]
    high = SPECTRUM.cutoff * 1.1

    def share(periodic: bool) -> float:
        spectrum = radial_power_spectrum(Topography(tilted, surface.spacing, periodic))
        return float(np.sum((spectrum.density * spectrum.modes)[spectrum.wavevector > high]))

    assert share(False) < 1e-3 * share(True)
    line = Profile(tilted[:, 0], surface.spacing, periodic=False)
    assert describe(line).rms_slope_spectral < 2 * describe(line).rms_slope_forward


def test_surface_topography_is_imported_without_a_warning():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert as_surface_topography(wave()).dim == 1
