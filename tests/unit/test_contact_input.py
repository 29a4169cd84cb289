"""What the contact solver refuses, before work starts, and the odd surfaces that it solves all the same."""

import numpy as np
import pytest

from softlub import contact
from softlub.contact import memory
from softlub.contact.area import corrected_area_ratio, edge_faces, pixel_area_ratio
from softlub.surfaces.topography import Topography

MODULUS = 1e7
NOISE = np.random.default_rng(0)


def white(*shape: int, periodic: bool = True) -> Topography:
    return Topography(1e-7 * NOISE.standard_normal(shape), 1e-6, periodic)


@pytest.mark.parametrize("pressure", [-1.0, np.nan, np.inf])
def test_pressure_must_press(pressure: float) -> None:
    with pytest.raises(ValueError, match="pressure"):
        contact.solve(white(8, 8), MODULUS, pressure)
    with pytest.raises(ValueError, match="pressure"):
        contact.sweep(white(8, 8), MODULUS, [1e3, pressure])


@pytest.mark.parametrize("modulus", [0.0, -1.0, np.nan])
def test_modulus_must_be_positive(modulus: float) -> None:
    with pytest.raises(ValueError, match="modulus"):
        contact.solve(white(8, 8), modulus, 1e3)


@pytest.mark.parametrize("tolerance", [0.0, 1e-15, 1.0, np.nan])
def test_tolerance_must_be_within_reach(tolerance: float) -> None:
    with pytest.raises(ValueError, match="tolerance"):
        contact.solve(white(8, 8), MODULUS, 1e3, tolerance=tolerance)


@pytest.mark.parametrize("level", [0.0, 1.0, 1e-6])
def test_constant_surface_is_refused(level: float) -> None:
    with pytest.raises(ValueError, match="constant"):
        contact.solve(Topography(np.full((8, 8), level), 1e-6), MODULUS, 1e3)


def test_what_will_not_fit_is_refused_with_the_estimate(monkeypatch: pytest.MonkeyPatch) -> None:
    surface = white(64, 64)
    monkeypatch.setattr(memory, "available_bytes", lambda: 1e8)
    with pytest.raises(MemoryError, match=r"64 x 64 points needs about 0\.3 GB, 0\.1 GB are free"):
        contact.solve(surface, MODULUS, 1e3)


def test_memory_estimate_holds_the_stated_sizes() -> None:
    assert memory.estimated_bytes((8192, 8192), periodic=True) < 7e9
    assert memory.estimated_bytes((64, 64), periodic=False) > memory.estimated_bytes((64, 64), periodic=True)
    assert memory.available_bytes() > 0


def test_start_of_another_grid_is_refused() -> None:
    start = contact.solve(white(8, 8), MODULUS, 1e3)
    with pytest.raises(ValueError, match="shape"):
        contact.solve(white(8, 9), MODULUS, 1e3, start=start)


def test_start_without_load_is_refused() -> None:
    surface = white(8, 8)
    with pytest.raises(ValueError, match="no load"):
        contact.solve(surface, MODULUS, 1e3, start=contact.solve(surface, MODULUS, 0.0))


def test_sweep_needs_loads() -> None:
    with pytest.raises(ValueError, match="pressures"):
        contact.sweep(white(8, 8), MODULUS, [])


def test_gap_out_of_range_is_refused() -> None:
    surface = white(16, 16)
    for gap in (0.0, -1e-6, 2 * float(np.ptp(surface.heights))):
        with pytest.raises(ValueError, match="mean gap"):
            contact.solve_at_mean_gap(surface, MODULUS, gap)
    with pytest.raises(ValueError, match="approach"):
        contact.solve_at_approach(surface, MODULUS, -1.0)


def test_the_sources_algorithm_refuses_what_it_cannot_do() -> None:
    with pytest.raises(ValueError, match="periodic"):
        contact.solve_polonsky_keer(white(8, 8), MODULUS, 1e3, summation=True)
    with pytest.raises(ValueError, match="above 0"):
        contact.solve_polonsky_keer(white(8, 8), MODULUS, 0.0)


def test_no_load_touches_the_summit() -> None:
    surface = white(16, 16)
    found = contact.solve(surface, MODULUS, 0.0)
    assert found.converged
    assert found.gap.min() == 0
    assert found.contact_area_ratio == 0
    assert found.load_error == 0


@pytest.mark.parametrize("periodic", [True, False])
@pytest.mark.parametrize("pressure", [1e-3, 1e2, 1e4, 1e6, 1e8])
@pytest.mark.parametrize("shape", [(31, 47), (2, 2), (3, 2), (5, 300)])
def test_any_grid_from_one_point_to_full_contact(shape, pressure: float, periodic: bool) -> None:
    found = contact.solve(white(*shape, periodic=periodic), MODULUS, pressure)
    assert found.converged
    assert abs(found.load_error) < 1e-12
    assert found.pressure.min() >= 0


@pytest.mark.parametrize("periodic", [True, False])
@pytest.mark.parametrize("pressure", [1.0, 1e5, 1e7])
def test_a_single_spike(pressure: float, periodic: bool) -> None:
    heights = np.zeros((48, 48))
    heights[5, 7] = 1e-6
    found = contact.solve(Topography(heights, 1e-6, periodic), MODULUS, pressure)
    assert found.converged
    centre = found.pressure[2:9, 4:11]  # a finite patch that touches all over presses hardest along its edges
    assert found.pressure[5, 7] == centre.max()


def test_one_point_carries_a_light_load() -> None:
    heights = np.zeros((16, 16))
    heights[3, 4] = 1e-6
    found = contact.solve(Topography(heights, 1e-6), MODULUS, 1.0)
    assert np.count_nonzero(found.pressure) == 1
    assert found.pressure[3, 4] == pytest.approx(256.0)


def test_an_inclined_plane_touches_at_its_edge() -> None:
    heights = np.tile(np.linspace(0, 1e-6, 40)[:, None], (1, 32))
    found = contact.solve(Topography(heights, 1e-6, periodic=False), MODULUS, 1e3)
    assert found.converged
    assert np.all(found.pressure[:-2] == 0)


def test_area_of_pixels_and_of_their_edge() -> None:
    pressure = np.zeros((10, 12))
    pressure[2:5, 3:7] = 1
    assert pixel_area_ratio(pressure) == 0.1
    assert edge_faces(pressure, periodic=True) == edge_faces(pressure, periodic=False) == 14
    assert corrected_area_ratio(pressure, True) == pytest.approx(
        (12 - (np.pi - 1 + np.log(2)) / 24 * 14) / 120
    )
    at_edge = np.roll(pressure, -3, axis=1)
    assert edge_faces(at_edge, periodic=True) == 14
    assert edge_faces(at_edge, periodic=False) == 11
    single = np.zeros((4, 4))
    single[1, 1] = 1
    assert 0 < corrected_area_ratio(single, True) < pixel_area_ratio(single)
