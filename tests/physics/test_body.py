"""The body's forces and tangent: against felupe, against finite differences, and what no force may come from."""

import felupe
import numpy as np
import pytest
from solid_meshes import Rubber, distorted, on_the_edge, rectangle

from softlub.solid.body import Body
from softlub.solid.elements import ELEMENTS, ElementInverted
from softlub.solid.materials.neo_hookean import NeoHookean
from softlub.solid.materials.prony import PronySeries
from softlub.solid.materials.viscoelastic import Viscoelastic

KINDS = sorted(ELEMENTS)
MESH = distorted(rectangle(3e-3, 2e-3, 6, 5), 1e-4)
MODERATE = Rubber(bulk_modulus=50e6)
"""Compressible enough that tangents can be told from rounding."""


def deformed(mesh, strain, seed=3):
    """A smooth finite deformation with shear, stretch and some noise."""
    x, y = (mesh.points / 1e-3).T
    noise = np.random.default_rng(seed).standard_normal(mesh.points.shape)
    return 1e-3 * strain * (np.column_stack([np.sin(y) + 0.3 * x, 0.2 * x * y - 0.3 * y]) + 0.03 * noise)


def rotated(mesh, angle):
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    return mesh.points @ turn.T - mesh.points


def test_agrees_with_the_solid_body_of_felupe():
    mesh = felupe.Mesh(MESH.points, MESH.cells, "quad")
    field = felupe.FieldContainer([felupe.FieldPlaneStrain(felupe.RegionQuad(mesh), dim=2)])
    peer = felupe.SolidBodyNearlyIncompressible(felupe.NeoHooke(mu=1.19e6), field, bulk=2e9)
    body = Body(MESH, Rubber())
    for strain in (1e-3, 0.1, 0.2):  # in sequence: the lagged pressures have to agree too
        displacement = deformed(MESH, strain)
        field[0].values[:] = displacement
        expected = peer.assemble.vector(field).toarray().ravel()
        tangent = peer.assemble.matrix().toarray()
        np.testing.assert_allclose(body.forces(displacement), expected, atol=1e-12 * np.abs(expected).max())
        np.testing.assert_allclose(body.tangent().toarray(), tangent, atol=1e-12 * np.abs(tangent).max())


@pytest.mark.parametrize("element", KINDS)
def test_patch_of_distorted_elements_carries_a_uniform_strain_exactly(element):
    mesh = distorted(rectangle(1e-3, 1e-3, 4, 4), 8e-5)
    slope = np.array([[0.11, 0.27], [-0.08, -0.12]])
    body = Body(mesh, MODERATE, element)
    forces = body.forces(mesh.points @ slope.T).reshape(-1, 2)
    edge = on_the_edge(mesh)
    assert np.abs(forces[~edge]).max() <= 1e-12 * np.abs(forces[edge]).max()
    stress = body.stress()
    assert np.abs(stress - stress[0]).max() <= 1e-11 * np.abs(stress[0]).max()


@pytest.mark.parametrize("element", KINDS)
def test_a_patch_solved_for_takes_the_uniform_strain(element):
    mesh = distorted(rectangle(1e-3, 1e-3, 4, 4), 8e-5)
    exact = mesh.points @ np.array([[0.05, 0.1], [0.0, -0.04]]).T
    body = Body(mesh, MODERATE, element)
    free = np.repeat(~on_the_edge(mesh), 2)
    displacement = exact.copy()
    displacement[~on_the_edge(mesh)] *= 0.8
    for _ in range(8):
        forces = body.forces(displacement)
        step = np.linalg.solve(body.tangent().toarray()[np.ix_(free, free)], -forces[free])
        displacement.reshape(-1)[free] += step
    assert np.abs(displacement - exact).max() <= 1e-12 * np.abs(exact).max()


@pytest.mark.parametrize("element", KINDS)
@pytest.mark.parametrize("angle", [0.0, 0.3, 2.0])
def test_rigid_motion_needs_no_force(element, angle):
    body = Body(MESH, Rubber(), element)
    scale = np.abs(body.forces(deformed(MESH, 1e-3))).max()
    forces = body.forces(rotated(MESH, angle) + np.array([2e-3, -5e-4]))
    # Rounding of a displacement of millimetres, times the bulk modulus; a strain of 1e-3 needs `scale`.
    assert np.abs(forces).max() <= 1e-9 * scale


@pytest.mark.parametrize("element", KINDS)
def test_forces_turn_with_the_body(element):
    body = Body(MESH, MODERATE, element)
    displacement = deformed(MESH, 0.2)
    forces = body.forces(displacement).reshape(-1, 2)
    turn = np.array([[0.6, -0.8], [0.8, 0.6]])
    turned = body.forces((MESH.points + displacement) @ turn.T - MESH.points).reshape(-1, 2)
    np.testing.assert_allclose(turned, forces @ turn.T, atol=1e-11 * np.abs(forces).max())


@pytest.mark.parametrize("element", KINDS)
def test_the_free_tangent_has_three_zero_modes(element):
    body = Body(MESH, Rubber(), element)
    values = np.linalg.eigvalsh(body.tangent().toarray())
    soft = values[:6] / Rubber().shear_modulus
    assert np.abs(soft[:3]).max() < 1e-10
    assert soft[3] > 1e-5


def test_without_its_spring_the_one_point_element_has_more_zero_modes():
    values = np.linalg.eigvalsh(Body(MESH, Rubber(), "reduced_integration").tangent().toarray())
    body = Body(MESH, Rubber(), "reduced_integration")
    body._hourglass = np.zeros_like(body._hourglass)
    without = np.linalg.eigvalsh(body.tangent().toarray())
    assert np.sum(values < 1e-7 * Rubber().shear_modulus) == 3
    assert np.sum(without < 1e-7 * Rubber().shear_modulus) == 5


@pytest.mark.parametrize("element", KINDS)
def test_tangent_agrees_with_finite_differences(element):
    body = Body(MESH, MODERATE, element)
    displacement = deformed(MESH, 0.2)
    tangent = body.tangent_at(displacement)
    direction = np.random.default_rng(7).standard_normal(displacement.shape)
    step = 1e-5 * 1e-3
    ahead, behind = (body.forces(displacement + sign * step * direction) for sign in (1, -1))
    change = (ahead - behind) / (2 * step)
    assert np.abs(tangent @ direction.ravel() - change).max() <= 1e-6 * np.abs(change).max()


@pytest.mark.parametrize("element", KINDS)
def test_tangent_is_symmetric_and_keeps_its_pattern(element):
    body = Body(MESH, Rubber(), element)
    first = body.tangent()
    second = body.tangent_at(deformed(MESH, 0.1))
    assert abs(second - second.T).max() <= 1e-14 * abs(second).max()
    np.testing.assert_array_equal(first.indices, second.indices)
    assert second.has_sorted_indices


def test_the_lagged_pressure_matters_to_the_tangent_alone():
    displacement = deformed(MESH, 0.1)
    direct, led = Body(MESH, Rubber()), Body(MESH, Rubber())
    led.forces(deformed(MESH, 0.05))
    np.testing.assert_array_equal(direct.forces(displacement), led.forces(displacement))
    assert abs(direct.tangent() - led.tangent()).max() > 1e-9 * abs(direct.tangent()).max()


def test_restoring_forgets_what_was_tried_since():
    body, other = Body(MESH, Rubber()), Body(MESH, Rubber())
    start, trial, end = (deformed(MESH, strain) for strain in (0.02, 0.15, 0.03))
    body.forces(start)
    other.forces(start)
    checkpoint = body.checkpoint()
    body.forces(trial)
    body.restore(checkpoint)
    np.testing.assert_array_equal(body.forces(end), other.forces(end))
    np.testing.assert_array_equal(body.tangent().data, other.tangent().data)


def test_an_inverted_element_is_named_and_leaves_the_state():
    body = Body(MESH, Rubber())
    good = deformed(MESH, 0.01)
    body.forces(good)
    before = body.tangent()
    bad = good.copy()
    bad[MESH.cells[7]] *= [[-60.0, 1.0]]
    bad[MESH.cells[7, 0], 0] += 2e-3
    with pytest.raises(ElementInverted, match=r"element \d+ near x = .* m, y = .* m"):
        body.forces(bad)
    np.testing.assert_array_equal(body.tangent().data, before.data)
    bad[0] = np.nan
    with pytest.raises(ElementInverted):
        body.forces(bad)


def test_an_unknown_element_is_refused_with_the_known_ones():
    with pytest.raises(ValueError, match="'hybrid' must be one of mean_dilatation, reduced_integration"):
        Body(MESH, Rubber(), "hybrid")


def viscoelastic_body():
    material = NeoHookean(0.6e6, 0.04e-6)
    prony = PronySeries((1e-3, 0.5), (0.8, 0.4), "long_term")
    return Body(MESH, Viscoelastic(material, prony)), Body(MESH, material)


def test_held_at_one_strain_the_overstress_relaxes_as_the_series_says():
    body, at_rest = viscoelastic_body()
    held = deformed(MESH, 0.2)
    body.begin_increment(0.0)
    overstress = []
    for duration in (0.0, 2e-3, 0.3):
        body.begin_increment(duration)
        overstress.append(body.forces(held) - at_rest.forces(held))
        body.accept()
    times = np.array([0.0, 2e-3, 0.302])
    parts = 0.8 * np.exp(-times / 1e-3) + 0.4 * np.exp(-times / 0.5)
    scale = np.abs(overstress[0]).max()
    for part, force in zip(parts, overstress, strict=True):
        np.testing.assert_allclose(force, overstress[0] * part / parts[0], atol=1e-10 * scale)
    body.begin_increment(np.inf)
    np.testing.assert_allclose(body.forces(held), at_rest.forces(held), atol=1e-10 * scale)


def test_tangent_with_a_history_agrees_with_finite_differences():
    body, _ = viscoelastic_body()
    body.begin_increment(1e-3)
    body.forces(deformed(MESH, 0.1))
    body.accept()
    body.begin_increment(0.2)
    displacement = deformed(MESH, 0.2, seed=4)
    tangent = body.tangent_at(displacement)
    direction = np.random.default_rng(7).standard_normal(displacement.shape)
    ahead, behind = (body.forces(displacement + step * direction) for step in (1e-8, -1e-8))
    change = (ahead - behind) / 2e-8
    assert np.abs(tangent @ direction.ravel() - change).max() <= 1e-6 * np.abs(change).max()


def test_restoring_brings_the_history_back():
    body, _ = viscoelastic_body()
    body.begin_increment(1e-3)
    body.forces(deformed(MESH, 0.1))
    body.accept()
    checkpoint = body.checkpoint()
    body.begin_increment(0.1)
    expected = body.forces(deformed(MESH, 0.12))
    body.restore(checkpoint)
    body.begin_increment(5.0)
    body.forces(deformed(MESH, 0.3))
    body.accept()
    body.restore(checkpoint)
    body.begin_increment(0.1)
    np.testing.assert_array_equal(body.forces(deformed(MESH, 0.12)), expected)
