"""The Reynolds solve for a given gap against closed forms of rigid bearings."""

import numpy as np
import pytest

from softlub.lubrication.solvers.finite_volume.reynolds import pressure
from softlub.references.linear_slider import LinearSlider
from softlub.references.martin import MartinRoller
from softlub.references.rayleigh_step import RayleighStep


@pytest.mark.parametrize("nodes", [3, 17, 64])
def test_linear_slider_is_exact_on_any_grid(nodes: int) -> None:
    slider = LinearSlider(inlet=3e-6, outlet=1e-6, length=1e-3, viscosity=0.1, speed=0.5)
    x = slider.length * np.linspace(0, 1, nodes) ** 1.5
    film = pressure(x, slider.separation(x), 0.1, 0.5)
    assert film.converged
    assert film.pressure == pytest.approx(slider.pressure(x), rel=1e-9, abs=1e-6)


def test_diverging_slider_carries_nothing() -> None:
    x = np.linspace(0, 1e-3, 65)
    film = pressure(x, 1e-6 + 2e-3 * x, 0.1, 0.5)
    assert film.converged
    assert np.all(film.pressure == 0)


def test_rayleigh_step_with_a_node_on_each_side_of_the_step() -> None:
    step = RayleighStep(
        inlet=2e-6, outlet=1e-6, inlet_length=7e-4, outlet_length=3e-4, viscosity=0.1, speed=0.5
    )
    edge = step.inlet_length
    x = np.concatenate([np.linspace(0, edge, 9), np.linspace(edge * (1 + 1e-8), 1e-3, 9)])
    film = pressure(x, np.where(x <= edge, step.inlet, step.outlet), 0.1, 0.5)
    assert film.pressure == pytest.approx(step.pressure(x), rel=1e-6, abs=1.0)


def test_martin_roller_converges_at_second_order() -> None:
    roller = MartinRoller(radius=0.01, viscosity=0.1, speed=0.5, load=100.0)
    errors = []
    for nodes in (129, 257, 513, 1025):
        x = roller.length_scale * np.sinh(np.linspace(-8, 8, nodes))
        film = pressure(x, roller.separation(x), 0.1, 0.5)
        assert film.converged
        errors.append(np.max(np.abs(film.pressure - roller.pressure(x))) / roller.pressure(x).max())
    assert errors[-1] < 2e-4
    assert -np.polyfit(np.arange(4), np.log2(errors), 1)[0] > 1.9


def test_bad_walls_are_refused() -> None:
    x = np.linspace(0, 1, 5)
    with pytest.raises(ValueError, match="positive"):
        pressure(x, x, 0.1, 1.0)
    with pytest.raises(ValueError, match="ascending"):
        pressure(x[::-1], 1 + x, 0.1, 1.0)
