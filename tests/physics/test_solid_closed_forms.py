"""The finite elements against closed forms: tension, elastica, Cook's membrane, bonded strip, Hertz's contact."""

import numpy as np
import pytest
from scipy.integrate import solve_bvp
from solid_meshes import PlainMesh, Rubber, rectangle

from softlub.references import sinusoidal_pressure
from softlub.references.elastica import EndLoadedCantilever
from softlub.references.hertz_line import HertzLineContact
from softlub.references.hyperelasticity import PlaneStrainTension, neo_hookean
from softlub.references.strip import response
from softlub.solid.body import Body
from softlub.solid.free_system import FreeSystem
from softlub.solid.materials.neo_hookean import NeoHookean
from softlub.solid.mesh import BodyMesh
from softlub.solid.plate import PlateContact
from softlub.solid.steps import InContact, Loading, run

UNLOCKED = ["mean_dilatation", "reduced_integration"]


def solved(body, free, loads, increments=1):
    """Displacement (n, 2) under dead nodal loads, by Newton's method from increments in proportion."""
    displacement = before = np.zeros_like(body.mesh.points)
    system = FreeSystem(body.tangent(), free)
    for part in np.linspace(0, 1, increments + 1)[1:]:
        before, displacement = displacement, 2 * displacement - before
        for _ in range(20):
            missing = part * loads[free] - body.forces(displacement)[free]
            if np.abs(missing).max() <= 1e-6 * np.abs(loads).max():
                break
            displacement.reshape(-1)[free] += system.factorise(body.tangent().data).solve(missing)
        else:
            raise AssertionError(f"no convergence at {part} of the load")
    return displacement


def free_but_for(count, nodes, components=(0, 1)):
    """All degrees of freedom but some components of some nodes."""
    fixed = [2 * np.asarray(nodes) + component for component in components]
    return np.setdiff1d(np.arange(2 * count), np.concatenate(fixed))


def order(coarse, middle, fine):
    """Order of convergence from three meshes, each half as wide as the one before."""
    return np.log2(abs((coarse - middle) / (middle - fine)))


@pytest.mark.parametrize("stretch", [0.6, 0.9, 1.1, 1.7])
@pytest.mark.parametrize("d1", [0.001e-6, 0.04e-6])
@pytest.mark.parametrize("element", UNLOCKED)
def test_tension_in_plane_strain(stretch, d1, element):
    """Sides free, ends held apart: the free nodes find the lateral stretch, the ends carry the nominal stress."""
    material = NeoHookean(0.5932e6, d1)
    reference = PlaneStrainTension(neo_hookean(material.c10), material.bulk_modulus, stretch)
    mesh = rectangle(1e-3, 2e-3, 3, 4)
    body = Body(mesh, material, element)
    displacement = mesh.points * [reference.lateral_stretch - 1, stretch - 1]
    system = FreeSystem(
        body.tangent(), free_but_for(len(mesh.points), np.flatnonzero(mesh.points[:, 0] == 0), [0])
    )
    bottom, top = mesh.points[:, 1] == 0, mesh.points[:, 1] == 2e-3
    free = np.setdiff1d(system.free, 2 * np.flatnonzero(bottom | top) + 1)
    system = FreeSystem(body.tangent(), free)
    displacement[~(bottom | top)] *= 0.999  # a start beside the solution
    for _ in range(8):
        forces = body.forces(displacement)
        displacement.reshape(-1)[free] -= system.factorise(body.tangent().data).solve(forces[free])
    forces = body.forces(displacement).reshape(-1, 2)
    assert forces[top, 1].sum() / 1e-3 == pytest.approx(reference.nominal_stress, rel=1e-8)
    right = mesh.points[:, 0] == 1e-3
    np.testing.assert_allclose(displacement[right, 0] / 1e-3 + 1, reference.lateral_stretch, rtol=1e-8)
    expected = np.diag([0, reference.cauchy_stress, reference.held_stress])
    np.testing.assert_allclose(
        body.stress()[0], expected, atol=1e-8 * abs(reference.cauchy_stress) * (1e-9 / d1 + 1)
    )


@pytest.mark.parametrize("load_number", [0.01, 1.0, 4.0, 10.0])
def test_elastica_solves_its_differential_equation(load_number):
    rod = np.linspace(0, 1, 41)
    angle = solve_bvp(
        lambda s, y: [y[1], -load_number * np.cos(y[0]), np.cos(y[0]), np.sin(y[0])],
        lambda start, end: np.array([start[0], end[1], start[2], start[3]]),
        rod,
        [np.minimum(load_number, 1.5) * rod, 0 * rod, rod, 0.3 * rod],
        tol=1e-9,
        max_nodes=20000,
    )
    assert angle.success
    closed = EndLoadedCantilever(load_number)
    assert closed.end_angle == pytest.approx(angle.y[0, -1], rel=1e-7)
    assert closed.reach == pytest.approx(angle.y[2, -1], rel=1e-7)
    assert closed.deflection == pytest.approx(angle.y[3, -1], rel=1e-7)


def test_elastica_is_euler_s_beam_at_small_loads():
    assert EndLoadedCantilever(1e-4).deflection == pytest.approx(1e-4 / 3, rel=1e-6)


def cantilever_end(element, columns, rows, load_number, slenderness=40.0):
    """Deflection and reach of the end's middle in parts of the length."""
    material = Rubber(bulk_modulus=200e6)
    length, height = 40e-3, 40e-3 / slenderness
    mesh = rectangle(length, height, columns, rows)
    body = Body(mesh, material, element)
    shear, bulk = material.shear_modulus, material.bulk_modulus
    plane_strain_modulus = 4 * shear * (3 * bulk + shear) / (3 * bulk + 4 * shear)
    force = load_number * plane_strain_modulus * height**3 / 12 / length**2
    loads = np.zeros(2 * len(mesh.points))
    end = np.flatnonzero(mesh.points[:, 0] == length)
    loads[2 * end + 1] = force * np.where((end == end[0]) | (end == end[-1]), 0.5, 1.0) / rows
    clamped = np.flatnonzero(mesh.points[:, 0] == 0)
    displacement = solved(body, free_but_for(len(mesh.points), clamped), loads, increments=16)
    middle = end[rows // 2]
    return np.array([displacement[middle, 1], length + displacement[middle, 0]]) / length


@pytest.mark.parametrize("element", UNLOCKED)
def test_slender_cantilever_converges_to_the_elastica(element):
    """The shear strain that the elastica leaves out adds some (height/length)² = 6e-4."""
    exact = EndLoadedCantilever(3.0)
    coarse, middle, fine = (cantilever_end(element, n, n // 40, 3.0) for n in (80, 160, 320))
    assert order(coarse[0], middle[0], fine[0]) == pytest.approx(2.0, abs=0.3)
    limit = fine + (fine - middle) / 3
    assert limit[0] == pytest.approx(exact.deflection, rel=2e-3)
    assert limit[1] == pytest.approx(exact.reach, rel=2e-3)


def cook_rise(element, columns, bulk_modulus=500e6, load=1.2e3):
    """Rise of the upper right corner of Cook's membrane under a load along its right side [m]."""
    square = rectangle(1.0, 1.0, columns, columns)
    along, up = square.points.T
    points = 1e-3 * np.column_stack([48 * along, 44 * along + up * (44 * (1 - along) + 16 * along)])
    mesh = PlainMesh(points, square.cells)
    loads = np.zeros(2 * len(points))
    end = np.flatnonzero(along == 1)
    loads[2 * end + 1] = load / columns * np.where((end == end[0]) | (end == end[-1]), 0.5, 1.0)
    body = Body(mesh, Rubber(1e6, bulk_modulus), element)
    displacement = solved(body, free_but_for(len(points), np.flatnonzero(along == 0)), loads, increments=4)
    return displacement[-1, 1]


def test_cook_s_membrane_converges_where_full_integration_locks():
    """The corners of the clamped side keep the order below 2."""
    rises = [cook_rise("mean_dilatation", n) for n in (4, 8, 16, 32)]
    reduced = [cook_rise("reduced_integration", n) for n in (8, 16, 32)]
    assert 1.2 < order(*rises[1:]) < 2.3
    assert 1.0 < order(*reduced) < 2.5
    limit = rises[-1] + (rises[-1] - rises[-2]) / (2 ** order(*rises[1:]) - 1)
    assert reduced[-1] == pytest.approx(limit, rel=1e-2)
    assert rises[1] == pytest.approx(limit, rel=0.05)
    assert cook_rise("full_integration", 8) < 0.7 * limit


@pytest.mark.parametrize("poisson_ratio", [0.3, 0.49, 0.5])
def test_strip_response_has_its_limits(poisson_ratio):
    young, thickness = 3e6, 2e-3
    modulus = young / (1 - poisson_ratio**2)
    deep = response(np.array([1e4]), thickness, young, poisson_ratio)
    np.testing.assert_allclose(deep, sinusoidal_pressure.deflection(0.0, 1.0, 1e4, modulus), rtol=1e-6)
    shallow = response(np.array([1.0]), thickness, young, poisson_ratio)
    if poisson_ratio < 0.5:
        uniaxial = young * (1 - poisson_ratio) / (1 + poisson_ratio) / (1 - 2 * poisson_ratio)
        np.testing.assert_allclose(shallow, thickness / uniaxial, rtol=1e-3)
    else:  # squeezed like a film: (q t)² t/(3 G)
        np.testing.assert_allclose(shallow, 1e-6 * thickness**3 / young * 1e6, rtol=1e-3)


def strip_indentation(element, wavevector, columns, rows, thickness, material):
    """Indentation under the crest of a unit pressure wave, on half a wave between planes of symmetry."""
    mesh = rectangle(np.pi / wavevector, thickness, columns, rows)
    x, y = mesh.points.T
    body = Body(mesh, material, element)
    sides = np.flatnonzero((x == 0) | (x == x.max()))
    free = np.intersect1d(
        free_but_for(len(x), sides, [0]), free_but_for(len(x), np.flatnonzero(y == y.max()))
    )
    bottom = np.flatnonzero(y == 0)
    # The work of a linear displacement against the wave: nodal loads by the second difference of -cos(qx)/q².
    width = x[bottom][1]
    shrink = 2 * (1 - np.cos(wavevector * width)) / (wavevector**2 * width)
    loads = np.zeros(2 * len(x))
    loads[2 * bottom + 1] = (
        shrink * np.cos(wavevector * x[bottom]) * np.where(np.isin(bottom, sides), 0.5, 1.0)
    )
    displacement = np.zeros(2 * len(x))
    displacement[free] = FreeSystem(body.tangent(), free).factorise(body.tangent().data).solve(loads[free])
    return displacement[1]


@pytest.mark.parametrize("element", UNLOCKED)
@pytest.mark.parametrize("bulk_modulus", [4e6, 2e9])
@pytest.mark.parametrize("depth", [0.7, 2.0, 6.0])
def test_bonded_strip_answers_every_wave(element, bulk_modulus, depth):
    """Second order in the width of the elements, to 0.1 % of the closed form."""
    material, thickness = Rubber(bulk_modulus=bulk_modulus), 1e-3
    shear = material.shear_modulus
    young = 9 * bulk_modulus * shear / (3 * bulk_modulus + shear)
    poisson = (3 * bulk_modulus - 2 * shear) / (6 * bulk_modulus + 2 * shear)
    exact = response(np.array([depth / thickness]), thickness, young, poisson)[0]
    errors = [
        strip_indentation(element, depth / thickness, n, int(n * max(1, depth / 3)), thickness, material)
        / exact
        - 1
        for n in (16, 32, 64)
    ]
    assert np.log2(abs(errors[1] / errors[2])) == pytest.approx(2.0, abs=0.3)
    assert abs(errors[2]) <= 1e-3 * max(1, depth / 2)


def large_block(half_width, radius, per_half_width=16, extent=60.0):
    """A block of `extent` contact half-widths every way, parabolic below, coarser away from the contact."""
    spacing = half_width / per_half_width
    edge = np.linspace(-1.5, 1.5, 3 * per_half_width + 1) * half_width
    steps = np.cumsum(spacing * 1.15 ** np.arange(1, 60))
    away = 1.5 * half_width + steps[: np.searchsorted(steps, extent * half_width)]
    x = np.concatenate([-away[::-1], edge, away])
    heights = np.concatenate([[0.0], np.cumsum(spacing * 1.12 ** np.arange(80))])
    heights = heights[: np.searchsorted(heights, extent * half_width)]
    plain = rectangle(1.0, 1.0, x.size - 1, heights.size - 1)
    bottom = np.minimum(x**2 / (2 * radius), 10 * half_width**2 / radius)
    part = (heights / heights[-1])[:, None]
    points = np.stack(
        [np.broadcast_to(x, (heights.size, x.size)), bottom + part * (heights[-1] - bottom)], axis=2
    )
    nodes = np.arange(points.size // 2)
    contact = nodes[away.size : away.size + edge.size]
    return BodyMesh(points.reshape(-1, 2), plain.cells, contact, nodes[-x.size :])


@pytest.mark.parametrize("element", UNLOCKED)
def test_hertz_in_a_large_body(element):
    """Half-width and peak from a parabola through p², which neither counts nodes nor trusts the outermost."""
    material = NeoHookean(0.5932e6, 0.001e-6)
    radius, half_width = 10e-3, 0.05e-3
    load = np.pi * material.plane_strain_modulus * half_width**2 / (4 * radius)
    hertz = HertzLineContact(radius, material.plane_strain_modulus, load)
    mesh = large_block(half_width, radius)
    history = run(Body(mesh, material, element), PlateContact(), [InContact(1e-7), Loading(load)])
    assert history.converged
    pressure = history.last.normal / mesh.edge_widths
    inside = pressure > 0
    ratio = mesh.edge_positions / half_width
    square, _, top = np.polyfit(ratio[inside], (pressure[inside] / hertz.peak_pressure) ** 2, 2)
    assert np.sqrt(-top / square) == pytest.approx(1.0, abs=5e-3)
    assert np.sqrt(top) == pytest.approx(1.0, abs=5e-3)
