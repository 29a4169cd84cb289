"""Periodic contact against closed forms: Westergaard's sinusoid, full contact, the double cosine."""

import numpy as np
import pytest

from softlub import contact
from softlub.contact.solver.compliance import PeriodicCompliance
from softlub.surfaces.spectrum import SelfAffine
from softlub.surfaces.synthesis import synthesize
from softlub.surfaces.topography import Topography

MODULUS = 1e7
AMPLITUDE = 1e-6
WAVELENGTH = 1e-4
FULL_LOAD = np.pi * MODULUS * AMPLITUDE / WAVELENGTH


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize("shape", [(31, 47), (2, 2), (64, 65), (33, 510), (128, 128)])
def test_compliance_divides_every_wave(shape: tuple[int, int], dtype: type[np.floating]) -> None:
    compliance = PeriodicCompliance(shape, dtype)
    compliance.source[:] = np.random.default_rng(1).standard_normal(shape)
    energy = compliance.apply()
    theta = 2 * np.pi * np.hypot(np.fft.fftfreq(shape[0])[:, None], np.fft.fftfreq(shape[1]))
    waves = np.fft.fft2(compliance.source.astype(float))
    displacement = np.fft.ifft2(waves * np.divide(1, theta, out=np.zeros(shape), where=theta > 0)).real
    accuracy = 10 * float(np.finfo(dtype).eps)
    assert np.abs(compliance.result - displacement).max() < accuracy * np.abs(displacement).max()
    assert energy == pytest.approx(np.vdot(compliance.source, displacement), rel=accuracy)
    compliance.stiffness_of_source()
    pressure = np.fft.ifft2(waves * theta).real
    assert np.abs(compliance.result - pressure).max() < accuracy * np.abs(pressure).max()


def test_renewed_arrays_leave_the_old_ones_alone() -> None:
    compliance = PeriodicCompliance((32, 48), np.float64)
    compliance.source[:] = np.random.default_rng(2).standard_normal((32, 48))
    compliance.apply()
    source, result = compliance.source, compliance.result
    kept = result.copy()
    compliance.renew()
    compliance.source[:] = 2 * source
    compliance.apply()
    np.testing.assert_array_equal(result, kept)
    np.testing.assert_allclose(compliance.result, 2 * kept, rtol=1e-12, atol=1e-12)


def sinusoid(points: int, axis: int = 0) -> Topography:
    wave = AMPLITUDE * np.cos(2 * np.pi * np.arange(points) / points)
    heights = np.tile(wave[:, None], (1, 4))
    return Topography(heights if axis == 0 else heights.T.copy(), WAVELENGTH / points)


def rough(points: int = 64, seed: int = 3) -> Topography:
    size = 4e-4
    spacing = size / points
    spectrum = SelfAffine(1e-6, 0.8, 2 * np.pi / 1e-4, np.pi / spacing / 2, 2 * np.pi / 2e-4)
    return synthesize(spectrum, size, points, seed)


def full_contact_pressure(topography: Topography) -> np.ndarray:
    nx, ny = topography.heights.shape
    q = (
        2
        * np.pi
        * np.hypot(
            np.fft.fftfreq(nx, topography.spacing)[:, None], np.fft.fftfreq(ny, topography.spacing)[None, :]
        )
    )
    return np.fft.ifft2(np.fft.fft2(topography.heights) * MODULUS * q / 2).real


def westergaard_gap_error(points: int, share: float, axis: int = 0) -> float:
    found = contact.solve(sinusoid(points, axis), MODULUS, share * FULL_LOAD, tolerance=1e-10)
    assert found.converged
    exact = AMPLITUDE * (1 - share + share * np.log(share))
    return (found.mean_gap - exact) / AMPLITUDE


@pytest.mark.parametrize("axis", [0, 1])
@pytest.mark.parametrize("share", [0.05, 0.1, 0.2, 0.4, 0.5, 0.8])
def test_westergaard(share: float, axis: int) -> None:
    assert abs(westergaard_gap_error(256, share, axis)) < 5e-5
    found = contact.solve(sinusoid(256, axis), MODULUS, share * FULL_LOAD)
    width = 2 / np.pi * np.arcsin(np.sqrt(share))
    assert found.contact_area_ratio_pixel == pytest.approx(width, abs=1.5 / 256)
    assert found.gap.min() > -1e-5 * AMPLITUDE


def test_westergaard_converges_with_second_order() -> None:
    shares = np.linspace(0.05, 0.45, 9)
    errors = [
        np.sqrt(np.mean([westergaard_gap_error(points, share) ** 2 for share in shares]))
        for points in (64, 128, 256, 512)
    ]
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    assert orders.mean() > 1.8


@pytest.mark.parametrize("points", [63, 64])
@pytest.mark.parametrize("factor", [1.0001, 2.0, 1e4])
def test_full_contact_is_exact(points: int, factor: float) -> None:
    whole = rough(64)
    surface = Topography(whole.heights[:points, :].copy(), whole.spacing)
    wavy = full_contact_pressure(surface)
    load = -factor * wavy.min()
    found = contact.solve(surface, MODULUS, load)
    assert found.full_contact
    assert found.converged
    assert found.contact_area_ratio == 1
    assert np.abs(found.pressure - load - wavy).max() < 1e-10 * load
    assert np.abs(found.gap).max() < 1e-10 * surface.heights.std() * factor


def test_full_contact_needs_the_rms_slope() -> None:
    surface = rough(64)
    found = contact.solve(surface, MODULUS, -2 * full_contact_pressure(surface).min())
    waves = np.fft.fft2(surface.heights) / surface.heights.size
    q = 2 * np.pi * np.fft.fftfreq(64, surface.spacing)
    slope = np.sqrt(np.sum((q[:, None] ** 2 + q[None, :] ** 2) * np.abs(waves) ** 2))
    assert found.pressure.std() == pytest.approx(MODULUS * slope / 2, rel=1e-10)


@pytest.mark.parametrize("factor", [0.9, 0.99, 0.999, 0.999999])
def test_just_below_full_contact(factor: float) -> None:
    surface = rough(64)
    found = contact.solve(surface, MODULUS, -factor * full_contact_pressure(surface).min())
    assert found.converged
    assert not found.full_contact
    assert found.contact_area_ratio_pixel > 0.99
    assert abs(found.mean_gap) < 1e-3 * surface.heights.std()


def test_double_cosine_closes_where_its_deepest_point_does() -> None:
    x = 2 * np.pi * np.arange(96) / 96
    surface = Topography(AMPLITUDE * np.cos(x)[:, None] * np.cos(x)[None, :], WAVELENGTH / 96)
    full = MODULUS * np.sqrt(2) * np.pi / WAVELENGTH * AMPLITUDE
    assert not contact.solve(surface, MODULUS, 0.99 * full).full_contact
    assert contact.solve(surface, MODULUS, 1.01 * full).full_contact


def test_double_cosine_begins_as_hertz() -> None:
    x = 2 * np.pi * np.arange(512) / 512
    surface = Topography(AMPLITUDE * np.cos(x)[:, None] * np.cos(x)[None, :], WAVELENGTH / 512)
    # two summits a period, each of radius of curvature 1 / (q² D)
    radius = (WAVELENGTH / (2 * np.pi)) ** 2 / AMPLITUDE
    contact_radius = WAVELENGTH / 40
    force = 4 * MODULUS * contact_radius**3 / (3 * radius)
    found = contact.solve(surface, MODULUS, 2 * force / WAVELENGTH**2)
    area = 2 * np.pi * contact_radius**2 / WAVELENGTH**2
    assert found.contact_area_ratio == pytest.approx(area, rel=0.03)
    assert found.pressure.max() == pytest.approx(2 * MODULUS * contact_radius / (np.pi * radius), rel=0.01)
