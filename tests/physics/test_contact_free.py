"""Contact of a finite patch: Love's rectangle, DC-FFT against direct summation, Hertz's sphere."""

import numpy as np
import pytest

from softlub import contact
from softlub.contact.solver.compliance import FreeCompliance
from softlub.contact.solver.kernels import love_rectangle
from softlub.contact.summation import SummedCompliance
from softlub.surfaces.topography import Topography

MODULUS = 1e7
RADIUS = 1e-2
CONTACT_RADIUS = 1e-4
APPROACH = CONTACT_RADIUS**2 / RADIUS


def sphere(points: int, half_width: float = 2 * CONTACT_RADIUS) -> tuple[Topography, float, np.ndarray]:
    """Paraboloid, the nominal pressure of Hertz's force, and the distances from its axis."""
    spacing = 2 * half_width / (points - 1)
    x = (np.arange(points) - (points - 1) / 2) * spacing
    distance = np.hypot(x[:, None], x[None, :])
    force = 4 * MODULUS * CONTACT_RADIUS**3 / (3 * RADIUS)
    heights = -(distance**2) / (2 * RADIUS)
    return Topography(heights, spacing, periodic=False), force / (points * spacing) ** 2, distance


def radius_of(found: contact.ContactSolution, topography: Topography) -> float:
    return float(np.sqrt(found.contact_area_ratio * np.prod(topography.size) / np.pi))


def test_love_rectangle() -> None:
    zero = np.zeros(1)
    assert love_rectangle(zero, zero)[0] == pytest.approx(2 * np.log(1 + np.sqrt(2)) / np.pi, rel=1e-14)
    assert love_rectangle(np.array([300.0]), np.array([400.0]))[0] == pytest.approx(
        1 / (2 * np.pi * 500), rel=1e-6
    )
    x, y = np.array([2.0, 3.0]), np.array([5.0, 0.0])
    np.testing.assert_allclose(love_rectangle(x, y), love_rectangle(y, -x), rtol=1e-13)


def test_love_rectangle_is_the_integral_of_a_point_load() -> None:
    points = (np.arange(400) + 0.5) / 400 - 0.5
    exact = np.mean(1 / np.hypot(1.0 - points[:, None], 2.0 - points[None, :])) / (2 * np.pi)
    assert love_rectangle(np.ones(1), np.full(1, 2.0))[0] == pytest.approx(exact, rel=1e-6)


@pytest.mark.parametrize("shape", [(16, 16), (15, 22), (7, 3)])
def test_transforms_agree_with_direct_summation(shape: tuple[int, int]) -> None:
    pressure = np.random.default_rng(1).random(shape)
    fast, slow = FreeCompliance(shape, np.float64), SummedCompliance(shape)
    energies = []
    for compliance in (fast, slow):
        compliance.source[:] = pressure
        energies.append(compliance.apply())
    np.testing.assert_allclose(fast.result, slow.result, rtol=1e-12)
    assert energies[0] == pytest.approx(energies[1], rel=1e-12)


def test_hertz_sphere() -> None:
    topography, pressure, distance = sphere(513)
    found = contact.solve(topography, MODULUS, pressure)
    assert found.converged
    assert found.convolutions <= 25
    assert found.rigid_approach == pytest.approx(APPROACH, rel=1e-5)
    assert radius_of(found, topography) == pytest.approx(CONTACT_RADIUS, rel=5e-3)
    peak = 2 * MODULUS * CONTACT_RADIUS / (np.pi * RADIUS)
    inside = distance < 0.9 * CONTACT_RADIUS
    exact = peak * np.sqrt(1 - (distance[inside] / CONTACT_RADIUS) ** 2)
    assert np.abs(found.pressure[inside] - exact).max() < 2e-3 * peak


def test_displacement_around_hertz_sphere() -> None:
    topography, pressure, distance = sphere(257)
    found = contact.solve(topography, MODULUS, pressure)
    displacement = found.gap + topography.heights - topography.heights.max() + found.rigid_approach
    outside = distance > 1.05 * CONTACT_RADIUS
    r = distance[outside]
    exact = (
        (2 * CONTACT_RADIUS**2 - r**2) * np.arcsin(CONTACT_RADIUS / r)
        + CONTACT_RADIUS * np.sqrt(r**2 - CONTACT_RADIUS**2)
    ) / (np.pi * RADIUS)
    assert np.abs(displacement[outside] - exact).max() < 2e-4 * APPROACH
    inside = distance < 0.95 * CONTACT_RADIUS
    exact = APPROACH - distance[inside] ** 2 / (2 * RADIUS)
    assert np.abs(displacement[inside] - exact).max() < 2e-5 * APPROACH


def test_hertz_approach_converges() -> None:
    grids = [33, 49, 65, 97, 129, 193, 257]
    errors = []
    for points in grids:
        topography, pressure, _ = sphere(points)
        found = contact.solve(topography, MODULUS, pressure, tolerance=1e-9)
        assert found.converged
        errors.append(abs(found.rigid_approach / APPROACH - 1))
    # second order but for where the edge falls between two grid points, which scatters
    assert -np.polyfit(np.log(grids), np.log(errors), 1)[0] > 1.3


@pytest.mark.parametrize("tolerance", [1e-4, 1e-6, 1e-8, 1e-10])
@pytest.mark.parametrize("points", [64, 129])
def test_hertz_at_any_tolerance(points: int, tolerance: float) -> None:
    topography, pressure, _ = sphere(points)
    found = contact.solve(topography, MODULUS, pressure, tolerance=tolerance)
    assert found.converged
    assert found.residual <= tolerance
    assert found.iterations < 45
