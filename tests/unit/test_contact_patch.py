import numpy as np
import pytest

from softlub.solid.contact_patch import hertz_patch


@pytest.mark.parametrize("spacing", [0.31e-6, 2.7e-6])
def test_a_hertzian_pressure_gives_back_its_patch_whatever_the_nodes(spacing):
    x = np.arange(-60e-6, 60e-6, spacing)
    pressure = 0.36e6 * np.sqrt(np.maximum(1 - ((x - 3.3e-6) / 30.5e-6) ** 2, 0))
    patch = hertz_patch(x, pressure)
    assert patch.half_width == pytest.approx(30.5e-6, rel=1e-9)
    assert patch.peak_pressure == pytest.approx(0.36e6, rel=1e-9)
    assert patch.middle == pytest.approx(3.3e-6, rel=1e-6)


def test_too_few_nodes_and_a_pressure_highest_at_the_rim_have_no_patch():
    x = np.linspace(-1e-4, 1e-4, 41)
    assert np.isnan(hertz_patch(x, np.where(np.abs(x) < 0.6e-5, 1e5, 0.0))).all()
    punch = np.where(np.abs(x) < 5e-5, 1e5 / np.sqrt(1 - np.minimum(np.abs(x) / 6e-5, 0.99) ** 2), 0.0)
    assert np.isnan(hertz_patch(x, punch)).all()
