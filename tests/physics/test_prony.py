"""Viscoelasticity: relaxation, moduli over frequency, superposition, and the fit of a series."""

import felupe
import numpy as np
import pytest
from scipy.integrate import quad

from softlub.references.viscoelasticity import largest_loss_factor, maxwell_moduli, ramp_and_hold
from softlub.solid.materials.dmta import fit_prony
from softlub.solid.materials.linear_elastic import LinearElastic
from softlub.solid.materials.moduli import (
    DynamicModulus,
    material_at_frequency,
    relaxation_modulus,
    shear_dynamics,
    tensile_dynamics,
)
from softlub.solid.materials.mooney_rivlin import MooneyRivlin
from softlub.solid.materials.neo_hookean import NeoHookean
from softlub.solid.materials.prony import PronySeries
from softlub.solid.materials.viscoelastic import Viscoelastic
from softlub.solid.materials.wlf import WilliamsLandelFerry
from softlub.solid.materials.yeoh import Yeoh

RUBBER = NeoHookean(0.5932e6, 1e-9)
SHORT = PronySeries((1e-4, 1e-2, 1.0), (5.0, 0.7, 0.1), "long_term")
WIDE = PronySeries(
    tuple(10.0**exponent for exponent in range(-13, 0)),
    (60.0, 120.0, 150.0, 120.0, 60.0, 22.0, 5.0, 0.8, 0.22, 0.08, 0.03, 0.012, 0.005),
    "long_term",
)
"""Thirteen decades from glass to rubber."""
MATERIALS = [
    RUBBER,
    MooneyRivlin(0.4e6, 0.2e6, 1e-9),
    Yeoh(0.6e6, -0.02e6, 4e3, 1e-9),
    LinearElastic(3.5e6, 0.5),
]


def sheared(amount):
    deformation = np.eye(3)
    deformation[0, 1] = amount
    return deformation[:, :, None, None]


def stress(response, deformation):
    return response.gradient([deformation, None])[0]


def advance(response, deformation, duration):
    """One accepted increment; its stress."""
    response.begin_increment(duration)
    found = stress(response, deformation)
    response.accept()
    return found


def turned(angle):
    cosine, sine = np.cos(angle), np.sin(angle)
    return np.array([[cosine, -sine, 0], [sine, cosine, 0], [0, 0, 1.0]])


@pytest.mark.parametrize("material", MATERIALS, ids=lambda material: type(material).__name__)
@pytest.mark.parametrize("series", [SHORT, WIDE], ids=["short", "wide"])
@pytest.mark.parametrize("ramp", [1e-9, 1e-3, 2.0])
def test_step_strain_relaxes_as_the_closed_form(material, series, ramp):
    """A finite shear put on within one ramp and held, all its stress components."""
    response = Viscoelastic(material, series).element_material()
    deformation = sheared(0.8)
    at_rest = stress(material.element_material(), deformation)
    advance(response, np.eye(3)[:, :, None, None], 1.0)
    times = np.concatenate([[ramp], ramp + np.geomspace(1e-10, 10, 45)])
    found = [advance(response, deformation, duration)[..., 0, 0] for duration in np.diff(times, prepend=0)]
    expected = ramp_and_hold(times, ramp, series.relaxation_times, series.long_term_terms)
    scale = np.abs(at_rest).max() * expected[:, None, None]
    np.testing.assert_allclose(
        np.array(found) / scale, expected[:, None, None] * at_rest[..., 0, 0] / scale, atol=1e-10
    )


def test_a_sheared_block_relaxes_as_the_closed_form():
    """The same through felupe's element, force by force at all nodes."""
    mesh = felupe.Rectangle(n=(3, 4))
    field = felupe.FieldContainer([felupe.FieldPlaneStrain(felupe.RegionQuad(mesh), dim=2)])
    response = Viscoelastic(RUBBER, SHORT).element_material()
    block = felupe.SolidBodyNearlyIncompressible(response, field, bulk=RUBBER.bulk_modulus)
    still = felupe.SolidBodyNearlyIncompressible(
        RUBBER.element_material(), field.copy(), bulk=RUBBER.bulk_modulus
    )
    for body in (block, still):
        body.field[0].values[:, 0] = 0.4 * mesh.points[:, 1]
        body.assemble.vector(body.field)
    at_rest = still.assemble.vector(still.field).toarray()[:, 0]
    times = np.array([1e-3, 2e-3, 1e-2, 0.3, 5.0])
    expected = ramp_and_hold(times, 1e-3, SHORT.relaxation_times, SHORT.long_term_terms)
    for duration, ratio in zip(np.diff(times, prepend=0), expected, strict=True):
        response.begin_increment(duration)
        force = block.assemble.vector(block.field).toarray()[:, 0]
        response.accept()
        np.testing.assert_allclose(force, ratio * at_rest, atol=1e-10 * np.abs(at_rest).max())


def test_an_increment_of_no_duration_is_instantaneous_and_an_infinite_one_relaxes():
    material = Viscoelastic(RUBBER, SHORT)
    at_rest = stress(RUBBER.element_material(), sheared(0.5))
    response = material.element_material()
    np.testing.assert_array_equal(stress(response, sheared(0.5)), at_rest)
    ratio = material.instantaneous_shear_modulus / material.shear_modulus
    np.testing.assert_allclose(advance(response, sheared(0.5), 0.0), ratio * at_rest, rtol=1e-13)
    np.testing.assert_allclose(advance(response, sheared(0.5), np.inf), at_rest, rtol=1e-13)
    with pytest.raises(ValueError, match="an increment of -1 s: the duration must be at least 0 s"):
        response.begin_increment(-1.0)
    with pytest.raises(ValueError, match="an increment of nan s"):
        response.begin_increment(float("nan"))


def test_a_held_strain_forgets_its_path():
    response, straight = (Viscoelastic(RUBBER, SHORT).element_material() for _ in range(2))
    for amount in (0.9, -0.4, 0.2):
        advance(response, sheared(amount), 1e-3)
    advance(response, sheared(0.6), 60.0)
    advance(straight, sheared(0.6), 60.0)
    np.testing.assert_allclose(
        advance(response, sheared(0.6), 60.0), advance(straight, sheared(0.6), 60.0), rtol=1e-12
    )


def test_a_failed_increment_leaves_no_trace():
    response, other = (Viscoelastic(RUBBER, SHORT).element_material() for _ in range(2))
    for each in (response, other):
        advance(each, sheared(0.3), 1e-3)
    response.begin_increment(1e-2)
    stress(response, sheared(5.0))
    response.begin_increment(3e-3)
    stress(response, sheared(0.7))
    response.accept()
    advance(other, sheared(0.7), 3e-3)
    np.testing.assert_array_equal(advance(response, sheared(0.1), 1e-4), advance(other, sheared(0.1), 1e-4))


def test_a_checkpoint_brings_back_stress_and_future():
    response = Viscoelastic(RUBBER, SHORT).element_material()
    fresh = response.checkpoint()
    first = advance(response, sheared(0.3), 1e-3)
    kept = response.checkpoint()
    np.testing.assert_array_equal(stress(response, sheared(0.3)), first)
    second = advance(response, sheared(0.5), 1e-2)
    response.restore(kept)
    np.testing.assert_array_equal(stress(response, sheared(0.3)), first)
    np.testing.assert_array_equal(advance(response, sheared(0.5), 1e-2), second)
    response.restore(fresh)
    np.testing.assert_array_equal(advance(response, sheared(0.3), 1e-3), first)


def test_nothing_to_accept_is_said():
    with pytest.raises(RuntimeError, match="nothing to accept"):
        Viscoelastic(RUBBER, SHORT).element_material().accept()


def test_a_history_seen_by_a_turning_observer_is_the_same():
    still, turning = (Viscoelastic(RUBBER, SHORT).element_material() for _ in range(2))
    for amount, angle in ((0.2, 0.5), (0.7, -2.0), (0.4, 3.0), (-0.3, 1.0)):
        deformation, rotation = sheared(amount), turned(angle)
        seen = np.einsum("ij,jk...->ik...", rotation, deformation)
        expected = np.einsum("ij,jk...->ik...", rotation, advance(still, deformation, 2e-3))
        np.testing.assert_allclose(
            advance(turning, seen, 2e-3), expected, atol=1e-13 * np.abs(expected).max()
        )


def driven(steps):
    """Storage and loss shear modulus from the first harmonic of stress under small oscillation."""
    frequency, cycles, amount = 60.0, 3, 1e-6
    response = Viscoelastic(RUBBER, PronySeries((1e-2, 1e-3), (2.0, 5.0), "long_term")).element_material()
    phase = 2 * np.pi * np.arange(1, cycles * steps + 1) / steps
    strain = amount * np.sin(phase)
    found = [advance(response, sheared(value), 2 * np.pi / frequency / steps)[0, 1, 0, 0] for value in strain]
    last = slice(-steps, None)
    storage, loss = (
        2 * np.mean(np.array(found)[last] * wave(phase[last])) / amount for wave in (np.sin, np.cos)
    )
    return np.array([storage, loss])


def test_time_stepping_gives_the_moduli_over_frequency():
    """Two independent ways to storage and loss, meeting with the square of the step."""
    series = PronySeries((1e-2, 1e-3), (2.0, 5.0), "long_term")
    exact = shear_dynamics(Viscoelastic(RUBBER, series), [60.0])
    expected = np.array([exact.storage[0], exact.loss[0]])
    errors = [np.abs(driven(steps) / expected - 1) for steps in (64, 128, 256)]
    assert errors[2].max() < 3e-4
    np.testing.assert_allclose(np.divide(errors[1:], errors[:-1]), 0.25, rtol=0.1)


def transform(frequency, slow, weight):
    """∫ exp(-t/τ) sin or cos(ωt) dt by quadrature, the tail beyond 40 τ left out."""
    return quad(
        lambda time: np.exp(-time / slow),
        0,
        40 * slow,
        weight=weight,
        wvar=frequency,
        limit=400,
        epsabs=1e-12 * slow,
    )[0]


@pytest.mark.parametrize("frequency", [0.3, 40.0, 3e3])
def test_moduli_are_the_transform_of_the_relaxation(frequency):
    """G' = G∞ + ω ∫ (G(t) - G∞) sin ωt dt and G'' = ω ∫ (G(t) - G∞) cos ωt dt."""
    material = Viscoelastic(RUBBER, SHORT)
    pairs = list(zip(SHORT.times, SHORT.terms, strict=True))
    storage, loss = (
        frequency * sum(term * transform(frequency, slow, weight) for slow, term in pairs)
        for weight in ("sin", "cos")
    )
    found = shear_dynamics(material, [frequency])
    assert found.storage[0] == pytest.approx(material.shear_modulus * (1 + storage), rel=1e-8)
    assert found.loss[0] == pytest.approx(material.shear_modulus * loss, rel=1e-8)


def test_relaxation_modulus_is_what_a_step_leaves():
    times = np.geomspace(1e-6, 100, 30)
    material = Viscoelastic(RUBBER, SHORT)
    found = relaxation_modulus(material, times)
    expected = ramp_and_hold(times, 1e-12, SHORT.relaxation_times, SHORT.long_term_terms)
    np.testing.assert_allclose(found, material.shear_modulus * expected, rtol=1e-6)
    assert relaxation_modulus(material, 0.0)[0] == pytest.approx(material.instantaneous_shear_modulus)
    with pytest.raises(ValueError, match="time -1 s must be finite and at least 0 s"):
        relaxation_modulus(material, [1.0, -1.0])


def test_one_arm_has_the_textbook_moduli():
    frequency = np.geomspace(1e-3, 1e9, 2000)
    found = shear_dynamics(Viscoelastic(RUBBER, PronySeries((1e-4,), (30.0,), "long_term")), frequency)
    storage, loss = maxwell_moduli(frequency, 1e-4, 30.0)
    np.testing.assert_allclose(found.storage, RUBBER.shear_modulus * storage, rtol=1e-13)
    np.testing.assert_allclose(found.loss, RUBBER.shear_modulus * loss, rtol=1e-13)
    assert found.loss_factor.max() == pytest.approx(largest_loss_factor(30.0), rel=1e-3)
    np.testing.assert_allclose(found.magnitude**2, found.storage**2 + found.loss**2)


def test_tensile_modulus_is_that_of_a_bar_with_free_sides():
    """σ = (K + 4G/3) ε + (K - 2G/3) 2ε_side along the bar, and nothing on its sides."""
    material = Viscoelastic(RUBBER, WIDE)
    frequency = np.geomspace(1, 1e15, 60)
    shear, tensile = shear_dynamics(material, frequency), tensile_dynamics(material, frequency)
    for index in range(frequency.size):
        modulus = shear.storage[index] + 1j * shear.loss[index]
        along, across = material.bulk_modulus + 4 / 3 * modulus, material.bulk_modulus - 2 / 3 * modulus
        side = np.linalg.solve([[along + across]], [-across])[0]
        expected = along + 2 * across * side
        assert tensile.storage[index] == pytest.approx(expected.real, rel=1e-9)
        assert tensile.loss[index] == pytest.approx(expected.imag, rel=1e-7)


def test_three_times_the_shear_modulus_is_too_high_in_glass():
    material = Viscoelastic(RUBBER, WIDE)
    ends = [1e-3, 1e17]
    ratio = 3 * shear_dynamics(material, ends).storage / tensile_dynamics(material, ends).storage
    np.testing.assert_allclose(ratio, [1.0002, 1.107], rtol=1e-3)
    assert tensile_dynamics(material, [0.0]).storage[0] == pytest.approx(material.young_modulus)


@pytest.mark.parametrize("base", MATERIALS, ids=lambda material: type(material).__name__)
def test_the_material_at_a_frequency_has_its_storage_modulus(base):
    material = Viscoelastic(base, SHORT)
    for frequency in (0.0, 100.0, 1e7):
        still = material_at_frequency(material, frequency)
        expected = shear_dynamics(material, [frequency]).storage[0]
        assert type(still) is type(base)
        assert still.shear_modulus == pytest.approx(expected, rel=1e-10)
        assert still.bulk_modulus == pytest.approx(base.bulk_modulus, rel=1e-9)
    with pytest.raises(ValueError, match="angular frequency -1 rad/s must be"):
        material_at_frequency(material, -1.0)


def test_a_shift_in_temperature_is_a_shift_in_frequency():
    wlf = WilliamsLandelFerry(17.44, 51.6, 220.0)
    frequency, temperature = np.geomspace(1, 1e12, 30), 290.0
    warm = Viscoelastic(RUBBER, wlf.at_temperature(WIDE, temperature))
    reference = Viscoelastic(RUBBER, WIDE)
    shifted = frequency * wlf.shift_factor(temperature)
    for name in ("storage", "loss"):
        found = getattr(tensile_dynamics(warm, frequency), name)
        np.testing.assert_allclose(found, getattr(tensile_dynamics(reference, shifted), name), rtol=1e-12)


UNEVEN = PronySeries((3e-7, 2e-5, 4.7e-4, 0.013, 0.4), (9.0, 4.0, 2.0, 0.6, 0.3), "long_term")


@pytest.mark.parametrize(
    ("series", "band"),
    [(WIDE, (1e-1, 1e14)), (UNEVEN, (1e-1, 1e8)), (UNEVEN, (1e1, 1e6)), (SHORT, (1e-2, 1e6))],
    ids=["wide", "uneven", "uneven, part of it", "short"],
)
@pytest.mark.parametrize(
    "bulk_modulus", [RUBBER.bulk_modulus, np.inf], ids=["compressible", "incompressible"]
)
def test_a_fit_recovers_the_moduli(series, band, bulk_modulus):
    frequency = np.geomspace(*band, 90)
    material = Viscoelastic(RUBBER, series)
    shear = shear_dynamics(material, frequency)
    incompressible = DynamicModulus(frequency, 3 * shear.storage, 3 * shear.loss)
    measured = incompressible if np.isinf(bulk_modulus) else tensile_dynamics(material, frequency)
    fit = fit_prony(measured, bulk_modulus)
    between = np.geomspace(*band, 1000)
    fitted = shear_dynamics(
        Viscoelastic(NeoHookean(fit.long_term_shear_modulus / 2, 1e-9), fit.series), between
    )
    exact = shear_dynamics(material, between)
    np.testing.assert_allclose(fitted.storage, exact.storage, rtol=0.01)
    np.testing.assert_allclose(fitted.loss, exact.loss, rtol=0.01)
    assert fit.rms_residual <= fit.largest_residual < 0.01


def test_a_fit_reports_the_noise_of_its_data():
    random = np.random.default_rng(3)
    frequency = np.geomspace(1e-1, 1e8, 200)
    exact = tensile_dynamics(Viscoelastic(RUBBER, UNEVEN), frequency)
    noise = 1 + 0.03 * random.standard_normal((2, 200))
    measured = DynamicModulus(frequency, exact.storage * noise[0], exact.loss * noise[1])
    fit = fit_prony(measured, RUBBER.bulk_modulus)
    assert 0.02 < fit.rms_residual < 0.035
    assert fit.long_term_shear_modulus == pytest.approx(RUBBER.shear_modulus, rel=0.05)


def test_moduli_that_no_solid_has_are_refused():
    frequency = np.geomspace(1, 1e4, 20)
    liquid = DynamicModulus(frequency, 1e-6 * frequency**2, 1e3 * frequency)
    with pytest.raises(ValueError, match="fit to a liquid: no long-term modulus"):
        fit_prony(liquid)
    with pytest.raises(ValueError, match=r"loss\[3\] = -1 must be finite and above 0"):
        fit_prony(DynamicModulus(frequency, frequency, np.where(np.arange(20) == 3, -1.0, 1.0)))
    with pytest.raises(ValueError, match="3 frequencies: a fit needs at least 4"):
        fit_prony(DynamicModulus(frequency[:3], frequency[:3], frequency[:3]))
    glass = DynamicModulus(frequency, np.full(20, 3e10), np.full(20, 1e9))
    with pytest.raises(ValueError, match=r"3e\+10 Pa cannot go with a bulk modulus of 2e\+09 Pa"):
        fit_prony(glass, 2e9)
