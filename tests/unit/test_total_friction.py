"""What a study adds to its panels: friction's solid part, scales, and the attributes of every variable."""

import numpy as np
import pytest
import xarray as xr

from softlub.datasets.variables import VARIABLES
from softlub.lubrication import HalfSpaceCylinder, Lubricant, Problem, solve, sweep
from softlub.lubrication.total_friction import with_total_friction
from softlub.stages.study import shear_strength, with_scales


@pytest.fixture
def panel() -> xr.Dataset:
    """Two roughnesses, one load, three speeds, every variable with the attributes it has on disk."""
    dims, shape = ("rms_roughness", "load", "speed"), (2, 1, 3)
    results = ("friction_coefficient_fluid", "separation_min", "real_contact_width")
    errors = ("friction_coefficient_fluid_error", "real_contact_width_error")
    values = np.arange(1.0, 7.0).reshape(shape) * 1e-5
    dataset = xr.Dataset(
        dict.fromkeys((*results, *errors), (dims, values))
        | {"viscosity": ("rms_roughness", [0.1, 0.1]), "long_term_modulus": ("rms_roughness", [1e7, 1e7])},
        coords={"rms_roughness": [0.0, 1e-6], "load": [50.0], "speed": [1e-3, 1e-2, 1e-1]},
    )
    for name in dataset.variables:
        dataset[name].attrs = VARIABLES[str(name)].attributes
    return dataset


RULES = [
    {"modulus_fraction": 0.1},
    {"value": 1e6},
    {"table": {"over": "speed", "at": [1e-3, 1e-1], "value": [1e6, 2e6]}},
]


@pytest.mark.parametrize("rule", RULES, ids=["fraction", "value", "table"])
def test_every_variable_carries_its_own_attributes_whatever_it_was_computed_from(panel, rule):
    dataset = with_scales(with_total_friction(panel, shear_strength(panel, rule)))
    for name, variable in dataset.variables.items():
        assert {key: variable.attrs[key] for key in VARIABLES[name].attributes} == VARIABLES[name].attributes
        assert ("source_equation" in variable.attrs) == bool(VARIABLES[name].source_equation)


def test_solid_friction_is_strength_times_width_over_load(panel):
    dataset = with_total_friction(panel, shear_strength(panel, RULES[1]))
    np.testing.assert_allclose(dataset["friction_coefficient_solid"], 1e6 * panel["real_contact_width"] / 50)
    np.testing.assert_allclose(
        dataset["friction_coefficient"],
        dataset["friction_coefficient_fluid"] + dataset["friction_coefficient_solid"],
    )


def test_table_of_strengths_is_interpolated_in_the_logarithm(panel):
    strength = shear_strength(panel, RULES[2])
    np.testing.assert_allclose(strength, [1e6, 1.5e6, 2e6])


def test_smooth_surface_has_no_lambda_ratio(panel):
    dataset = with_scales(panel)
    assert dataset["lambda_ratio"].isel(rms_roughness=0).isnull().all()
    assert dataset["lambda_ratio"].isel(rms_roughness=1).notnull().all()


def test_solver_named_as_a_start_is_refused():
    from softlub.contact.laws.none import NoContact

    problem = Problem(HalfSpaceCylinder(0.01, 1e7), NoContact(), Lubricant(0.1), load=100.0, speed=1.0)
    with pytest.raises(TypeError, match="solver="):
        solve(problem, "spectral")
    with pytest.raises(ValueError, match="at least one"):
        sweep(problem, [], [1.0])
    with pytest.raises(ValueError, match="no solver is called 'nope'"):
        solve(problem, solver="nope")


@pytest.mark.parametrize("value", [-1.0, 0.0, float("nan"), float("inf")])
def test_impossible_parameters_are_refused_by_name(value):
    with pytest.raises(ValueError, match="HalfSpaceCylinder: radius"):
        HalfSpaceCylinder(value, 1e7)
    with pytest.raises(ValueError, match="Lubricant: viscosity"):
        Lubricant(value)
    with pytest.raises(ValueError, match="cavitation 'mass conserving'"):
        Lubricant(0.1, "mass conserving")
