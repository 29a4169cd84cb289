"""Every closed form against an integration of its own differential equation or integral."""

from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import cumulative_simpson, quad, simpson
from scipy.optimize import brentq, minimize_scalar
from scipy.special import erf

from softlub.references import dry_limit, flat_punch, sinusoidal_pressure, soft_similarity
from softlub.references.hertz_line import HertzLineContact
from softlub.references.linear_slider import LinearSlider
from softlub.references.martin import LOAD_COEFFICIENT, MartinRoller
from softlub.references.pocket import Pocket
from softlub.references.rayleigh_step import RayleighStep
from softlub.references.wavy_slider import WavySlider

VISCOSITY, SPEED = 0.1, 0.7


def film_between_ends(position, film):
    """Full film without pressure at both ends: p' = 6ηv (h - h*)/h³, h* from p(B) = 0; with load and wall friction."""
    square = simpson(film**-2, x=position)
    cube = simpson(film**-3, x=position)
    gradient = 6 * VISCOSITY * SPEED * (film**-2 - square / cube * film**-3)
    pressure = cumulative_simpson(gradient, x=position, initial=0.0)
    drag = simpson(VISCOSITY * SPEED / film + film / 2 * gradient, x=position)
    return pressure, simpson(pressure, x=position), drag


@pytest.mark.parametrize("inlet", [1.2e-6, 2.2e-6, 8e-6])
def test_linear_slider_solves_the_reynolds_equation(inlet):
    slider = LinearSlider(inlet, 1e-6, 2e-3, VISCOSITY, SPEED)
    position = np.linspace(0, slider.length, 4001)
    pressure, load, drag = film_between_ends(position, slider.separation(position))
    np.testing.assert_allclose(slider.pressure(position), pressure, atol=1e-8 * pressure.max())
    assert slider.load == pytest.approx(load, rel=1e-8)
    assert slider.friction == pytest.approx(drag, rel=1e-8)


def test_rayleigh_step_conserves_flow_and_adds_up():
    step = RayleighStep(1.9e-6, 1e-6, 1.4e-3, 0.6e-3, VISCOSITY, SPEED)
    before = SPEED * step.inlet / 2 - step.inlet**3 * step.step_pressure / step.inlet_length / (
        12 * VISCOSITY
    )
    after = SPEED * step.outlet / 2 + step.outlet**3 * step.step_pressure / step.outlet_length / (
        12 * VISCOSITY
    )
    assert before == pytest.approx(after, rel=1e-12)
    position = np.array([0, step.inlet_length, step.inlet_length + step.outlet_length])
    assert step.load == pytest.approx(np.trapezoid(step.pressure(position), position), rel=1e-12)
    drag = sum(
        (VISCOSITY * SPEED / film + film / 2 * gradient) * length
        for film, gradient, length in (
            (step.inlet, step.step_pressure / step.inlet_length, step.inlet_length),
            (step.outlet, -step.step_pressure / step.outlet_length, step.outlet_length),
        )
    )
    assert step.friction == pytest.approx(drag, rel=1e-12)


def test_rayleigh_s_best_step():
    """Most load for given length and outlet film: h₁/h₂ = 1 + √3/2, and 0.2063 ηvB²/h₂² with it."""

    def load(ratio, share):
        return RayleighStep(ratio, 1.0, share, 1 - share, 1.0, 1.0).load

    def best_load(ratio):
        return -minimize_scalar(
            lambda share: -load(ratio, share), bounds=(0.3, 0.95), method="bounded", options={"xatol": 1e-10}
        ).fun

    best = minimize_scalar(
        lambda r: -best_load(r), bounds=(1.3, 3), method="bounded", options={"xatol": 1e-8}
    )
    assert best.x == pytest.approx(1 + np.sqrt(3) / 2, abs=1e-5)
    assert -best.fun == pytest.approx(6 * 4 * (2 * np.sqrt(3) - 3) / 54, rel=1e-6)


def test_martin_s_roller_by_integration_of_the_reynolds_equation():
    """Shooting for the rupture at which p and its gradient vanish together, h = h₀ (1 + ξ²), x = √(2R h₀) ξ."""

    def pressure_at(rupture):
        return quad(lambda xi: (xi**2 - rupture**2) / (1 + xi**2) ** 3, -np.inf, rupture, epsabs=1e-13)[0]

    rupture = brentq(pressure_at, 0.1, 1.0, xtol=1e-13)
    roller = MartinRoller(radius=0.01, viscosity=VISCOSITY, speed=SPEED, load=100.0)
    assert roller.rupture_position == pytest.approx(rupture * roller.length_scale, rel=1e-9)
    assert pytest.approx(2.447, abs=6e-4) == LOAD_COEFFICIENT

    # W = -∫ x dp
    moment = quad(lambda xi: xi * (xi**2 - rupture**2) / (1 + xi**2) ** 3, -np.inf, rupture, epsabs=1e-13)[0]
    load = -6 * VISCOSITY * SPEED * roller.length_scale**2 / roller.smallest_separation**2 * moment
    assert load == pytest.approx(roller.load, rel=1e-9)

    position = np.linspace(-3, rupture, 7) * roller.length_scale
    gradient = [
        quad(
            lambda xi: (xi**2 - rupture**2) / (1 + xi**2) ** 3, -np.inf, x / roller.length_scale, epsabs=1e-13
        )[0]
        for x in position
    ]
    scale = 6 * VISCOSITY * SPEED * roller.length_scale / roller.smallest_separation**2
    np.testing.assert_allclose(roller.pressure(position), scale * np.array(gradient), atol=1e-10 * scale)
    assert np.all(
        roller.pressure(position[-1] * np.array([1.0, 1.5, 10])) == pytest.approx(0.0, abs=1e-12 * scale)
    )


def half_plane_deflection(pressure, half_width, position, modulus):
    """-(2/(πE*)) ∫ p ln|x - s| ds, s = a sin θ, with the logarithm's place as a break."""

    def integrand(angle):
        s = half_width * np.sin(angle)
        return pressure(s) * half_width * np.cos(angle) * np.log(abs(position - s))

    stops = [-np.pi / 2, np.pi / 2]
    if abs(position) < half_width:
        stops.insert(1, np.arcsin(position / half_width))
    parts = [quad(integrand, a, b, epsabs=1e-12, limit=400)[0] for a, b in pairwise(stops)]
    return -2 / (np.pi * modulus) * sum(parts)


def test_hertz_pressure_carries_the_load_and_makes_the_gap():
    hertz = HertzLineContact(radius=0.01, modulus=13.3e6, load=100.0)
    a = hertz.half_width
    load = quad(lambda angle: hertz.pressure(a * np.sin(angle)) * a * np.cos(angle), -np.pi / 2, np.pi / 2)[0]
    assert load == pytest.approx(100.0, rel=1e-10)
    middle = half_plane_deflection(hertz.pressure, a, 0.0, hertz.modulus)
    for ratio in (0.3, 0.9, 1.1, 3.0, 64.0):
        deflection = half_plane_deflection(hertz.pressure, a, ratio * a, hertz.modulus) - middle
        assert hertz.deflection(ratio * a) == pytest.approx(deflection, rel=1e-7)
    assert hertz.gap(np.array([0.0, -0.99 * a, a])) == pytest.approx([0, 0, 0])


def test_flat_punch_deflects_evenly():
    a, load, modulus = 1e-3, 100.0, 13.3e6

    def pressure(s):
        return flat_punch.pressure(s, a, load)

    middle = half_plane_deflection(pressure, a, 0.0, modulus)
    for ratio in (-0.7, 0.4, 1.5, 20.0):
        deflection = half_plane_deflection(pressure, a, ratio * a, modulus) - middle
        assert flat_punch.deflection(ratio * a, a, load, modulus) == pytest.approx(
            deflection, rel=1e-6, abs=1e-12
        )


def test_sinusoidal_pressure_deflects_by_its_own_shape():
    """The logarithmic kernel's slope is (2/(πE*)) ∫_0^∞ [p(x + t) - p(x - t)] dt/t: Dirichlet's integral here."""
    amplitude, wavevector, modulus, x = 1e5, 2e4, 13.3e6, 3e-5
    # cos q(x + t) - cos q(x - t) = -2 sin qx sin qt, and ∫_0^∞ sin(qt)/t dt, done by parts beyond many waves
    periods = 400 * np.pi / wavevector
    integral = quad(lambda t: np.sinc(wavevector * t / np.pi) * wavevector, 0, periods, limit=2000)[0]
    integral += 1 / (wavevector * periods)
    slope = -2 * amplitude / (np.pi * modulus) * 2 * np.sin(wavevector * x) * integral
    step = 1e-8
    ends = sinusoidal_pressure.deflection(np.array([x - step, x + step]), amplitude, wavevector, modulus)
    assert (ends[1] - ends[0]) / (2 * step) == pytest.approx(slope, rel=1e-4)


@pytest.mark.parametrize("rms_slope", [1e-3, 0.05, 0.3, 5.0])
def test_dry_contact_width_is_the_integral_of_the_area(rms_slope):
    half_width, peak, modulus = 0.309e-3, 2.06e5, 13.3e6

    def area(angle):
        return erf(np.sqrt(2) * peak * np.cos(angle) / (modulus * rms_slope)) * np.cos(angle)

    width = half_width * quad(area, -np.pi / 2, np.pi / 2, epsabs=1e-13, limit=200)[0]
    assert dry_limit.real_contact_width(half_width, peak, modulus, rms_slope) == pytest.approx(
        width, rel=1e-9
    )


def test_dry_friction_of_table_3_1():
    """σ₁ = 0.1 E, E = 10 MPa, ν = 0.4999, h'_rms of h_rms 1 µm, H 0.8, 1e4 to 0.78e10 1/m: 0.3972."""
    slope = 1e-6 * np.sqrt(
        quad(lambda t: np.exp(0.4 * t), 0, np.log(7.8e5))[0]
        / quad(lambda t: np.exp(-1.6 * t), 0, np.log(7.8e5))[0]
    )
    hertz = HertzLineContact(0.01, 10e6 / (1 - 0.4999**2), 100.0)
    friction = dry_limit.friction_coefficient(
        1e6, 100.0, hertz.half_width, hertz.peak_pressure, hertz.modulus, slope * 1e4
    )
    assert friction == pytest.approx(0.3972, abs=5e-5)


def test_soft_film_scales_as_the_similarity_says():
    """λ^(3/5) a²/R means u ~ (ηv)^(3/5) E*^(-2/5) R^(3/5) W^(-1/5): no scale of its own."""

    def film(viscosity, modulus, radius, load):
        hertz = HertzLineContact(radius, modulus, load)
        number = soft_similarity.speed_number(radius, hertz.half_width, hertz.peak_pressure, viscosity, SPEED)
        return soft_similarity.central_film(radius, hertz.half_width, number)

    base = film(0.1, 1e7, 0.01, 100.0)
    assert film(0.2, 1e7, 0.01, 100.0) / base == pytest.approx(2**0.6)
    assert film(0.1, 2e7, 0.01, 100.0) / base == pytest.approx(2**-0.4)
    assert film(0.1, 1e7, 0.02, 100.0) / base == pytest.approx(2**0.6)
    assert film(0.1, 1e7, 0.01, 200.0) / base == pytest.approx(2**-0.2)


def test_pocket_conserves_flow_everywhere():
    pocket = Pocket(1e-6, 3e-6, 1e-3, 2e-3, 1.5e-3, 1e5, 0.01, 1.0)
    assert (
        pocket.rupture_position < pocket.reformation_position < pocket.rupture_position + pocket.pocket_length
    )

    def flow(position):
        step = 1e-7
        gradient = np.diff(pocket.pressure(np.array([position - step, position + step])))[0] / (2 * step)
        film = pocket.separation(np.array(position))
        return pocket.speed * film / 2 - film**3 * gradient / (12 * pocket.viscosity)

    end = pocket.rupture_position + pocket.pocket_length
    for position in (0.5e-3, (pocket.reformation_position + end) / 2, end + 0.5e-3):
        assert flow(position) == pytest.approx(pocket.flow, rel=1e-9)
    ruptured = pocket.speed * pocket.filling * pocket.pocket_film / 2
    assert ruptured == pytest.approx(pocket.flow, rel=1e-12)
    assert pocket.pressure(np.array([0.0, 4.5e-3])) == pytest.approx([1e5, 1e5])


def test_pocket_that_stays_full_is_refused():
    with pytest.raises(ValueError, match="does not rupture"):
        Pocket(1e-6, 3e-6, 1e-3, 2e-3, 1.5e-3, 1e5, 0.01, 0.02)


@pytest.fixture(scope="module")
def wavy():
    return WavySlider(1e-6, 0.5, 1e-3, 2.0, 1.29e-3, VISCOSITY, SPEED)


def test_wavy_slider_solves_the_reynolds_equation_where_it_is_full(wavy):
    film = wavy.separation(wavy.rupture_position)
    assert wavy.neck < wavy.rupture_position < wavy.reformation_position < wavy.length
    for start, stop in ((0.0, wavy.rupture_position), (wavy.reformation_position, wavy.length)):
        x = np.linspace(start, stop, 4001)
        pressure = wavy.pressure(x)
        gradient = 6 * VISCOSITY * SPEED * (wavy.separation(x) - film) / wavy.separation(x) ** 3
        by_simpson = cumulative_simpson(gradient, x=x, initial=0.0)
        np.testing.assert_allclose(pressure, by_simpson, atol=1e-8 * pressure.max())
        assert np.min(pressure) > -1e-9 * pressure.max()
        assert abs(pressure[-1]) < 1e-9 * pressure.max()


def test_wavy_slider_conserves_flow_over_both_edges(wavy):
    """In the ruptured part θ h is constant and below h; it joins without a jump at the rupture, with one at f."""
    x = np.linspace(wavy.rupture_position, wavy.reformation_position, 100)[1:-1]
    assert np.all(wavy.filling(x) < 1)
    np.testing.assert_allclose(wavy.filling(x) * wavy.separation(x), wavy.separation(wavy.rupture_position))
    assert np.all(wavy.pressure(x) == 0)
    just_inside = wavy.filling(np.array([wavy.rupture_position * (1 + 1e-9)]))
    assert just_inside == pytest.approx([1.0], abs=1e-7)


@pytest.mark.parametrize("length", [1.1e-3, 1.4e-3])
def test_wavy_slider_that_ends_elsewhere_is_refused(length):
    with pytest.raises(ValueError, match="length"):
        WavySlider(1e-6, 0.5, 1e-3, 2.0, length, VISCOSITY, SPEED)
