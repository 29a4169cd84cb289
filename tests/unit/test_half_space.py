"""The two representations of the half-space: against Hertz, against each other, and what they refuse."""

import numpy as np
import pytest

from softlub.lubrication.half_space import HalfSpace, HalfSpaceFFT
from softlub.lubrication.hertz import HertzLine
from softlub.lubrication.problem import HalfSpaceCylinder

BODY = HalfSpaceCylinder(radius=0.01, modulus=1e7 / 0.75)
HERTZ = HertzLine(BODY.radius, BODY.modulus, 100.0)


def hertz_gap_error(nodes: int) -> float:
    """Spread of the gap inside the Hertz contact, in units of a²/R; a rigid shift is no error."""
    a = HERTZ.half_width
    x = np.linspace(-2 * a, 2 * a, nodes)
    space = HalfSpace(BODY, x)
    pressure = HERTZ.peak_pressure * np.sqrt(np.clip(1 - (x / a) ** 2, 0, None))
    gap = space.base_gap + space.deflection(pressure)
    return float(np.ptp(gap[np.abs(x) < 0.8 * a]) / HERTZ.gap_scale)


def test_hertz_pressure_flattens_the_gap() -> None:
    errors = [hertz_gap_error(n) for n in (129, 257, 513)]
    assert errors[2] < 1e-4
    assert np.all(np.log2(np.array(errors[:-1]) / errors[1:]) > 1.3)  # edge singularity: order 1.5


def test_the_gap_outside_is_hertz() -> None:
    a = HERTZ.half_width
    x = np.linspace(-3 * a, 3 * a, 1537)
    space = HalfSpace(BODY, x)
    scaled = np.abs(x / a)
    pressure = HERTZ.peak_pressure * np.sqrt(np.clip(1 - scaled**2, 0, None))
    gap = (space.base_gap + space.deflection(pressure)) / HERTZ.gap_scale
    outside = scaled > 1.05
    root = np.sqrt(scaled[outside] ** 2 - 1)
    expected = 0.5 * (scaled[outside] * root - np.log(scaled[outside] + root))
    assert gap[outside] - gap[x.size // 2] == pytest.approx(expected, abs=5e-5)


@pytest.mark.parametrize("nodes", [3, 64, 129, 1025])
def test_transforms_and_matrix_agree(nodes: int) -> None:
    x = np.linspace(-1e-3, 1.1e-3, nodes)
    dense, fast = HalfSpace(BODY, x), HalfSpaceFFT(BODY, x)
    pressure = np.random.default_rng(1).normal(size=nodes) * 1e5
    scale = np.max(np.abs(dense.matrix())) * np.sum(np.abs(pressure))
    assert np.max(np.abs(dense.deflection(pressure) - fast.deflection(pressure))) < 1e-13 * scale
    assert np.max(np.abs(dense.matrix() - fast.matrix())) < 1e-11 * np.max(np.abs(dense.matrix()))
    assert dense.widths == pytest.approx(fast.widths)
    assert dense.widths.sum() == pytest.approx(2.1e-3)


def test_deflection_is_the_matrix_product() -> None:
    x = np.linspace(-1e-3, 1e-3, 65)
    pressure = np.cos(np.arange(65.0))
    for space in (HalfSpace(BODY, x), HalfSpaceFFT(BODY, x)):
        assert space.deflection(pressure) == pytest.approx(space.matrix() @ pressure, rel=1e-9, abs=1e-22)


def test_bad_nodes_are_refused() -> None:
    with pytest.raises(ValueError, match="ascending"):
        HalfSpace(BODY, np.array([0.0, 2.0, 1.0]))
    with pytest.raises(ValueError, match="at least three"):
        HalfSpace(BODY, np.array([0.0, 1.0]))
    with pytest.raises(ValueError, match="evenly spaced"):
        HalfSpaceFFT(BODY, np.array([0.0, 1.0, 3.0]))
