"""What holds for every surface: invariances, sums, round trips."""

from __future__ import annotations

from dataclasses import astuple, replace

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from softlub.surfaces import SelfAffine, Topography, describe, synthesize, synthesize_profile
from softlub.surfaces.autocorrelation import autocorrelation
from softlub.surfaces.filtering import separate_waviness
from softlub.surfaces.modes import mode_powers
from softlub.surfaces.power_spectra import power_spectrum_map, radial_power_spectrum

shapes = st.tuples(st.integers(8, 48), st.integers(8, 48))
hursts = st.floats(0.05, 1.0)
seeds = st.integers(0, 2**64)
SPACING = 1e-6


def spectra(draw, hurst: float, shape: tuple[int, int]) -> SelfAffine:
    """A spectrum whose waves the grid can carry."""
    nyquist = np.pi / SPACING
    lowest = 2 * np.pi / (min(shape) * SPACING)
    cutoff = draw(st.floats(min(1.2 * lowest, 0.9 * nyquist), nyquist))
    rolloff = draw(st.floats(0.3 * lowest, 0.95 * min(lowest, cutoff)))
    long_cutoff = draw(st.none() | st.floats(0.1 * rolloff, rolloff))
    return SelfAffine(1e-6, hurst, rolloff, cutoff, long_cutoff)


@st.composite
def surfaces(draw) -> Topography:
    shape = draw(shapes)
    spectrum = spectra(draw, draw(hursts), shape)
    return synthesize(spectrum, (shape[0] * SPACING, shape[1] * SPACING), shape, draw(seeds))


@settings(deadline=None, max_examples=60)
@given(surfaces())
def test_height_target_and_parseval(surface):
    assert np.isclose(np.std(surface.heights), 1e-6, rtol=1e-10)
    assert np.isclose(mode_powers(surface).sum(), 1e-12, rtol=1e-9)
    cell = (2 * np.pi) ** 2 / (surface.size[0] * surface.size[1])
    assert np.isclose(power_spectrum_map(surface).density.sum() * cell, 1e-12, rtol=1e-9)


@settings(deadline=None, max_examples=30)
@given(surfaces(), st.integers(-50, 50), st.integers(-50, 50))
def test_statistics_know_neither_place_nor_mirror(surface, along_x, along_y):
    reference = astuple(describe(surface))
    moved = np.roll(surface.heights, (along_x, along_y), axis=(0, 1))
    for heights in (moved, surface.heights[::-1], surface.heights[:, ::-1], surface.heights.T + 3e-6):
        other = astuple(describe(replace(surface, heights=np.ascontiguousarray(heights))))
        np.testing.assert_allclose(other, reference, rtol=1e-7, atol=1e-12)


@settings(deadline=None, max_examples=30)
@given(surfaces(), st.floats(1e-3, 1e3), st.floats(1e-3, 1e3))
def test_statistics_scale_with_heights_and_lengths(surface, height, length):
    first = describe(surface)
    second = describe(Topography(height * surface.heights, length * surface.spacing))
    assert np.isclose(second.rms_roughness, height * first.rms_roughness)
    assert np.isclose(second.rms_slope_spectral, height / length * first.rms_slope_spectral)
    assert np.isclose(second.rms_slope_forward, height / length * first.rms_slope_forward)
    np.testing.assert_allclose(
        (second.skewness, second.kurtosis, second.nayak_parameter),
        (first.skewness, first.kurtosis, first.nayak_parameter),
        rtol=1e-6,
        atol=1e-9,
    )
    assert first.nayak_parameter >= 1.5 * (1 - 1e-9)
    assert first.rms_slope_spectral >= first.rms_slope_forward >= first.rms_slope_central > 0


@settings(deadline=None, max_examples=30)
@given(surfaces())
def test_turning_a_surface_upside_down_flips_the_skewness_only(surface):
    upright, turned = describe(surface), describe(replace(surface, heights=-surface.heights))
    assert np.isclose(turned.skewness, -upright.skewness, atol=1e-9)
    assert np.isclose(turned.kurtosis, upright.kurtosis)
    assert np.isclose(turned.rms_slope_spectral, upright.rms_slope_spectral)


@settings(deadline=None, max_examples=30)
@given(surfaces())
def test_autocorrelation_never_exceeds_its_origin(surface):
    for periodic in (True, False):
        measured = autocorrelation(replace(surface, periodic=periodic))
        assert np.isclose(measured.covariance[0], 1e-12, rtol=1e-9)
        if periodic:
            assert np.all(np.abs(measured.covariance) <= 1e-12 * (1 + 1e-9))


@settings(deadline=None, max_examples=30)
@given(st.data(), st.integers(10, 30), st.integers(2, 3), hursts, seeds)
def test_refining_the_grid_keeps_the_waves(data, points, factor, hurst, seed):
    spectrum = spectra(data.draw, hurst, (points, points))
    coarse = synthesize(spectrum, points * SPACING, points, seed)
    fine = synthesize(spectrum, points * SPACING, factor * points, seed)
    np.testing.assert_allclose(fine.heights[::factor, ::factor], coarse.heights, rtol=0, atol=1e-17)
    line = synthesize_profile(spectrum, points * SPACING, points, seed)
    finer = synthesize_profile(spectrum, points * SPACING, factor * points, seed)
    np.testing.assert_allclose(finer.heights[::factor], line.heights, rtol=0, atol=1e-17)


@settings(deadline=None, max_examples=30)
@given(surfaces(), st.floats(2.5, 100))
def test_filter_splits_without_loss_and_never_amplifies(surface, spacings):
    for periodic in (True, False):
        kept, removed = separate_waviness(replace(surface, periodic=periodic), spacings * SPACING)
        np.testing.assert_allclose(kept.heights + removed.heights, surface.heights, rtol=0, atol=1e-18)
        if periodic:
            assert np.all(mode_powers(kept) <= mode_powers(surface) * (1 + 1e-9) + 1e-40)
            assert np.all(mode_powers(removed) <= mode_powers(surface) * (1 + 1e-9) + 1e-40)


@settings(deadline=None, max_examples=30)
@given(surfaces(), st.none() | st.integers(3, 30))
def test_radial_average_is_positive_and_ascends_in_wavevector(surface, bins):
    spectrum = radial_power_spectrum(surface, bins)
    assert np.all(np.diff(spectrum.wavevector) > 0)
    assert np.all(spectrum.density >= 0)
    assert np.all(spectrum.modes > 0)
