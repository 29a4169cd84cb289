"""Rough contact with hardly any contact, hardly any gap, hardly any surface: converged, or clearly refused."""

import numpy as np
import pytest

from softlub import contact
from softlub.surfaces.spectrum import SelfAffine
from softlub.surfaces.synthesis import synthesize
from softlub.surfaces.topography import Topography

MODULUS = 1e7
SPACING = 1e-6


def rough(shape: tuple[int, int], periodic: bool = True) -> Topography:
    spectrum = SelfAffine(1e-6, 0.8, 2 * np.pi / 3e-5, np.pi / SPACING / 2)
    whole = synthesize(spectrum, 64 * SPACING, 64, seed=5)
    return Topography(whole.heights[: shape[0], : shape[1]].copy(), SPACING, periodic)


def full_load(surface: Topography) -> float:
    """Mean pressure at which the last point touches: -min of the pressure that flattens the surface."""
    waves = np.fft.rfft2(surface.heights)
    q = (
        2
        * np.pi
        * np.hypot(
            np.fft.fftfreq(surface.heights.shape[0], SPACING)[:, None],
            np.fft.rfftfreq(surface.heights.shape[1], SPACING),
        )
    )
    return -float(np.fft.irfft2(MODULUS / 2 * q * waves, surface.heights.shape).min())


def holds(surface: Topography, pressure: float, found) -> None:
    """Converged, carrying the load, without tension or penetration."""
    assert found.converged
    assert found.pressure.mean() == pytest.approx(pressure, rel=1e-12)
    assert found.pressure.min() >= 0
    scale = surface.heights.std()
    assert found.gap.min() >= -1e-5 * scale
    assert np.abs(found.gap[found.pressure > 0]).max() <= 1e-4 * scale


@pytest.mark.parametrize("shape", [(64, 64), (31, 47)])
@pytest.mark.parametrize("share", [1e-5, 1e-3, 0.05, 0.5, 0.999, 0.99999])
def test_from_a_hundred_thousandth_of_full_load_to_nearly_all(shape, share) -> None:
    surface = rough(shape)
    pressure = share * full_load(surface)
    holds(surface, pressure, contact.solve(surface, MODULUS, pressure))


@pytest.mark.parametrize("shape", [(64, 64), (31, 47)])
@pytest.mark.parametrize("share", [1e-5, 0.05, 0.5])
def test_finite_patches(shape, share) -> None:
    surface = rough(shape, periodic=False)
    pressure = share * full_load(surface)
    holds(surface, pressure, contact.solve(surface, MODULUS, pressure))


def test_one_point_in_contact() -> None:
    surface = rough((31, 47))
    pressure = 1e-9 * full_load(surface)
    found = contact.solve(surface, MODULUS, pressure)
    holds(surface, pressure, found)
    assert np.count_nonzero(found.pressure) == 1
    assert found.pressure.argmax() == surface.heights.argmax()


@pytest.mark.parametrize("share", [1e-6, 0.1, 10.0])
def test_a_spike_on_a_plane(share) -> None:
    heights = np.zeros((31, 47))
    heights[12, 30] = 1e-6
    surface = Topography(heights, SPACING)
    pressure = share * full_load(surface)
    holds(surface, pressure, contact.solve(surface, MODULUS, pressure))


def test_a_plane_is_refused() -> None:
    with pytest.raises(ValueError, match=r"the surface is constant .* no rough contact to solve"):
        contact.solve(Topography(np.full((31, 47), 2e-6), SPACING), MODULUS, 1e4)
