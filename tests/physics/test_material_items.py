"""The materials as finite elements see them: stress, tangent, objectivity, and uniform states in closed form."""

import felupe
import numpy as np
import pytest

from softlub.references.hyperelasticity import (
    PlaneStrainTension,
    incompressible_tension,
    mooney_rivlin,
    neo_hookean,
    principal_stresses,
    yeoh,
)
from softlub.solid.materials.linear_elastic import LinearElastic
from softlub.solid.materials.mooney_rivlin import MooneyRivlin
from softlub.solid.materials.neo_hookean import NeoHookean
from softlub.solid.materials.prony import PronySeries
from softlub.solid.materials.viscoelastic import Viscoelastic
from softlub.solid.materials.yeoh import Yeoh

MODULUS = 1e6
D1 = 1e-9
HYPERELASTIC = {
    "neo_hookean": (NeoHookean(0.6e6, D1), neo_hookean(0.6e6)),
    "mooney_rivlin": (MooneyRivlin(0.4e6, 0.2e6, D1), mooney_rivlin(0.4e6, 0.2e6)),
    "yeoh": (Yeoh(0.6e6, -0.02e6, 4e3, D1), yeoh(0.6e6, -0.02e6, 4e3)),
    "linear_elastic": (LinearElastic(3.5e6, 0.5), neo_hookean(3.5e6 / 6)),
}
SERIES = PronySeries((1e-4, 1e-2, 1.0), (5.0, 0.7, 0.1), "long_term")


def without_history(material):
    return material.element_material()


def with_history(material):
    """A response in the middle of its third increment."""
    response = Viscoelastic(material, SERIES).element_material()
    for seed, duration in ((11, 3e-3), (12, 5e-4)):
        response.begin_increment(duration)
        response.gradient([deformations(seed), None])
        response.accept()
    response.begin_increment(2e-3)
    return response


@pytest.fixture(
    params=[(name, make) for name in HYPERELASTIC for make in (without_history, with_history)],
    ids=lambda parameter: f"{parameter[0]}-{parameter[1].__name__}",
)
def response(request):
    name, make = request.param
    return make(HYPERELASTIC[name][0])


def deformations(seed, points=(4, 9), size=0.25):
    random = np.random.default_rng(seed)
    return np.eye(3)[:, :, None, None] + size * random.uniform(-1, 1, (3, 3, *points))


def rotations(seed, points=(4, 9)):
    random = np.random.default_rng(seed)
    rotation, _ = np.linalg.qr(random.standard_normal((*points, 3, 3)))
    rotation *= np.linalg.det(rotation)[..., None, None]
    return np.moveaxis(rotation, (-2, -1), (0, 1))


def stress(response, deformation):
    return response.gradient([deformation, None])[0]


def product(left, right):
    return np.einsum("ij...,jk...->ik...", left, right)


def test_tangent_is_the_derivative_of_the_stress(response):
    deformation, step = deformations(1), 1e-5
    tangent = response.hessian([deformation, None])[0]
    differences = np.empty_like(tangent)
    for row, column in np.ndindex(3, 3):
        change = np.zeros_like(deformation)
        change[row, column] = step
        rise = stress(response, deformation + change) - stress(response, deformation - change)
        differences[:, :, row, column] = rise / (2 * step)
    assert np.abs(tangent - differences).max() <= 1e-7 * np.abs(tangent).max()


def test_tangent_has_a_potential(response):
    tangent = response.hessian([deformations(2), None])[0]
    turned = np.transpose(tangent, (2, 3, 0, 1, 4, 5))
    np.testing.assert_allclose(tangent, turned, atol=1e-12 * np.abs(tangent).max())


def test_stress_turns_with_the_body(response):
    """P(QF) = Q P(F), for any rotation after any history."""
    deformation, rotation = deformations(3), rotations(4)
    turned = stress(response, product(rotation, deformation))
    expected = product(rotation, stress(response, deformation))
    np.testing.assert_allclose(turned, expected, atol=1e-13 * np.abs(expected).max())


def test_stress_is_isochoric(response):
    """The Cauchy stress has no mean, and a change of volume alone no effect: both belong to the element."""
    deformation = deformations(5)
    own = stress(response, deformation)
    kirchhoff = product(own, np.swapaxes(deformation, 0, 1))
    size = np.abs(kirchhoff).max()
    assert np.abs(np.trace(kirchhoff)).max() <= 1e-13 * size
    np.testing.assert_allclose(kirchhoff, np.swapaxes(kirchhoff, 0, 1), atol=1e-13 * size)
    np.testing.assert_allclose(stress(response, 1.3 * deformation) * 1.3, own, atol=1e-12 * size)


@pytest.mark.parametrize("name", HYPERELASTIC)
def test_reference_and_its_rotations_are_free_of_stress(name):
    response = HYPERELASTIC[name][0].element_material()
    assert np.abs(stress(response, rotations(6))).max() <= 1e-14 * MODULUS
    viscoelastic = Viscoelastic(HYPERELASTIC[name][0], SERIES).element_material()
    for seed, duration in ((7, 1e-3), (8, 1e-5), (9, 2.0)):
        viscoelastic.begin_increment(duration)
        assert np.abs(stress(viscoelastic, rotations(seed))).max() <= 1e-13 * MODULUS
        viscoelastic.accept()


@pytest.mark.parametrize("name", HYPERELASTIC)
def test_small_strain_stiffness_is_the_shear_modulus(name):
    material = HYPERELASTIC[name][0]
    tangent = material.element_material().hessian([np.eye(3)[:, :, None, None], None])[0][..., 0, 0]
    eye, shear = np.eye(3), material.shear_modulus
    expected = shear * (
        np.einsum("ik,jl->ijkl", eye, eye)
        + np.einsum("il,jk->ijkl", eye, eye)
        - 2 / 3 * np.einsum("ij,kl->ijkl", eye, eye)
    )
    np.testing.assert_allclose(tangent, expected, atol=1e-12 * shear)


@pytest.mark.parametrize("name", HYPERELASTIC)
def test_principal_stresses_agree_with_the_closed_form(name):
    material, slopes = HYPERELASTIC[name]
    response = material.element_material()
    for stretches in ([1.3, 0.9, 1.0], [0.6, 1.5, 1.1], [2.0, 0.7, 0.7], [1.2, 1.2, 1.2]):
        stretch = np.array(stretches)
        nominal = np.diag(stress(response, np.diag(stretch)[:, :, None, None])[..., 0, 0])
        expected = principal_stresses(slopes, 0.0, stretch) * np.prod(stretch) / stretch
        np.testing.assert_allclose(nominal, expected, atol=1e-12 * MODULUS)


def test_the_neo_hookean_response_is_felupe_s():
    deformation = deformations(10, points=(4, 700))
    ours, theirs = NeoHookean(0.6e6, D1).element_material(), felupe.NeoHooke(mu=1.2e6)
    np.testing.assert_allclose(
        stress(ours, deformation), theirs.gradient([deformation, None])[0], atol=1e-13 * MODULUS
    )
    np.testing.assert_allclose(
        ours.hessian([deformation, None])[0], theirs.hessian([deformation, None])[0], atol=1e-12 * MODULUS
    )


def test_an_inverted_point_gives_nan_and_leaves_its_neighbours_alone():
    deformation = deformations(13)
    deformation[:, :, 2, 5] = np.diag([1.0, -1.0, 1.0])
    response = NeoHookean(0.6e6, D1).element_material()
    broken = np.isnan(stress(response, deformation)).any(axis=(0, 1))
    assert broken.sum() == 1
    assert broken[2, 5]
    assert np.isnan(response.hessian([deformation, None])[0]).any(axis=(0, 1, 2, 3)).sum() == 1


def test_the_closed_form_tends_to_the_incompressible_one():
    stretch = np.array([0.5, 0.8, 1.5, 3.0])
    expected = incompressible_tension(1.2e6, stretch)
    errors = []
    for ratio in (1e3, 1e4, 1e5):
        states = [PlaneStrainTension(neo_hookean(0.6e6), ratio * 1.2e6, value) for value in stretch]
        errors.append(np.abs([state.nominal_stress for state in states] - expected).max() / 1.2e6)
    assert errors[0] < 0.1
    np.testing.assert_allclose(np.divide(errors[1:], errors[:-1]), 0.1, rtol=0.05)


@pytest.mark.parametrize("name", HYPERELASTIC)
@pytest.mark.parametrize("stretch", [0.7, 1.5])
def test_a_stretched_block_has_the_stress_of_the_closed_form(name, stretch):
    material, slopes = HYPERELASTIC[name]
    mesh = felupe.Rectangle(b=(2.0, 1.0), n=(4, 3))
    field = felupe.FieldContainer([felupe.FieldPlaneStrain(felupe.RegionQuad(mesh), dim=2)])
    block = felupe.SolidBodyNearlyIncompressible(
        material.element_material(), field, bulk=material.bulk_modulus
    )
    boundaries = felupe.dof.uniaxial(field, clamped=False, return_loadcase=False)
    for value in np.linspace(1, stretch, 6)[1:]:
        boundaries["move"].value = 2.0 * (value - 1)
        fixed, free = felupe.dof.partition(field, boundaries)
        given = felupe.dof.apply(field, boundaries, fixed)
        done = felupe.newtonraphson(
            items=[block], dof0=fixed, dof1=free, ext0=given, tol=1e-11, verbose=0, maxiter=30
        )
        assert done.success
    # The element's pressure lags by one iteration: evaluate once more where it stands.
    force = block.assemble.vector(field).toarray().reshape(-1, 2)
    pulled = force[mesh.points[:, 0] == 2.0, 0].sum()
    state = PlaneStrainTension(slopes, material.bulk_modulus, stretch)
    lateral = field[0].values[mesh.points[:, 1] == 1.0, 1]
    assert pulled == pytest.approx(state.nominal_stress, rel=1e-8)
    np.testing.assert_allclose(1 + lateral, state.lateral_stretch, rtol=1e-9)
