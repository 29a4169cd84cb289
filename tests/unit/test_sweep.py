import numpy as np
import pytest
from made_up_contact import HALF_DOMAIN, LOAD, SPEED, VISCOSITY, Returning, contact, problem

from softlub.datasets.variables import FLAGS, VARIABLES
from softlub.lubrication.observables import contact_width, observe
from softlub.lubrication.speed_sweep import (
    FRICTION_ERROR_LIMIT,
    SEPARATION_ERROR_LIMIT,
    WIDTH_ERROR_LIMIT,
    stack,
    sweep,
    sweep_arrays,
)

STATE = {"converged", "iterations", "residual", "load_error", "flags"}


def solid(width=1e-4, pressure=1e5, nodes=201):
    """Asperity pressure on a few nodes about the middle."""
    x = np.linspace(-HALF_DOMAIN, HALF_DOMAIN, nodes)
    return np.where(np.abs(x) <= 0.5 * width, pressure, 0.0)


def errors(coarse, finer):
    return {name: values[0, 0] for name, values in _swept(coarse, finer).items()}


def _swept(coarse, finer):
    return sweep_arrays(problem(), [LOAD], [SPEED], Returning(coarse), Returning(finer))


def test_couette_friction_of_a_parallel_gap():
    found = observe(contact(), problem())
    assert found["friction_coefficient_couette"] == pytest.approx(
        VISCOSITY * SPEED / 1e-5 * 2 * HALF_DOMAIN / LOAD
    )
    assert found["friction_coefficient_poiseuille"] == 0
    assert found["friction_coefficient_fluid"] == found["friction_coefficient_couette"]


def test_poiseuille_friction_of_a_constant_gradient():
    found = observe(contact(fluid_pressure_gradient=np.full(201, 1e6)), problem())
    assert found["friction_coefficient_poiseuille"] == pytest.approx(
        0.5 * 1e-5 * 1e6 * 2 * HALF_DOMAIN / LOAD
    )


def test_solid_share_and_real_contact_width():
    found = observe(contact(solid_pressure=solid(width=1.9e-3)), problem())
    carried = 1e5 * 1.9e-3  # 19 nodes, 0.1 mm apart
    assert found["load_share_solid"] == pytest.approx(carried / LOAD)
    assert found["real_contact_width"] == pytest.approx(carried / 1e6)
    assert found["contact_area_ratio_max"] == pytest.approx(0.1)


def test_centroid_of_a_shifted_pressure():
    fluid = np.zeros(201)
    fluid[120] = 1e6
    found = observe(contact(fluid_pressure=fluid), problem())
    assert found["pressure_centroid"] == pytest.approx(1e6 * 1e-4 * 2e-3 / LOAD)


def test_width_of_a_triangle_lies_between_the_nodes():
    x = np.array([-2.0, -1.0, 0.0, 1.0, 2.0])
    assert contact_width(x, np.array([0.0, 0.0, 1.0, 0.0, 0.0])) == pytest.approx(2 * 0.999)


def test_width_of_a_pressure_that_fills_the_domain():
    assert contact_width(np.array([0.0, 1.0, 2.0]), np.ones(3)) == 2.0


def test_width_of_no_pressure_is_unknown():
    assert np.isnan(contact_width(np.array([0.0, 1.0, 2.0]), np.zeros(3)))


def test_a_good_point_raises_no_flag():
    assert observe(contact(), problem())["flags"] == 0


@pytest.mark.parametrize(
    ("flag", "changes", "radius"),
    [
        ("not_converged", {"converged": False}, 0.1),
        ("outside_half_space", {}, 1e-3),
        ("percolates", {"solid_pressure": solid(pressure=5e5)}, 0.1),
        ("law_extrapolated", {"separation_min": 0.9e-6}, 0.1),
        ("domain_truncates", {"fluid_pressure": np.full(201, 1e4)}, 0.1),
    ],
    ids=lambda value: value if isinstance(value, str) else "",
)
def test_each_flag_has_its_cause_and_stands_alone(flag, changes, radius):
    assert observe(contact(**changes), problem(radius))["flags"] == FLAGS[flag]


def test_an_unconverged_point_keeps_its_state_and_nothing_else():
    found = observe(contact(converged=False, residual=0.5), problem())
    assert found["residual"] == 0.5
    assert all(np.isnan(value) for name, value in found.items() if name not in STATE)


def test_every_observable_is_in_the_table_of_variables():
    assert observe(contact(), problem()).keys() <= VARIABLES.keys()


def test_error_estimates_are_the_differences():
    finer = contact(separation=np.full(201, 1.0001e-5), separation_min=1.0002e-5)
    found = errors(contact(), finer)
    friction = VISCOSITY * SPEED * 2 * HALF_DOMAIN / LOAD
    assert found["friction_coefficient_fluid_error"] == pytest.approx(
        friction * (1e5 - 1 / 1.0001e-5), rel=1e-9
    )
    assert found["separation_min_error"] == pytest.approx(0.0002 / 1.0002, rel=1e-9)
    assert found["flags"] == 0


@pytest.mark.parametrize("side", [0.9, 1.1], ids=["below", "above"])
def test_friction_is_inaccurate_above_its_limit(side):
    change = side * FRICTION_ERROR_LIMIT / (0.5 * 1e-5 * 2 * HALF_DOMAIN / LOAD)
    found = errors(contact(), contact(fluid_pressure_gradient=np.full(201, change)))
    assert found["flags"] == (FLAGS["inaccurate_friction"] if side > 1 else 0)


@pytest.mark.parametrize("side", [0.9, 1.1], ids=["below", "above"])
def test_separation_is_inaccurate_above_its_limit(side):
    found = errors(contact(separation_min=1e-5 * (1 + side * SEPARATION_ERROR_LIMIT)), contact())
    assert found["flags"] == (FLAGS["inaccurate_separation"] if side > 1 else 0)


@pytest.mark.parametrize("side", [0.9, 1.1], ids=["below", "above"])
def test_real_contact_is_inaccurate_above_its_limit(side):
    coarse = contact(solid_pressure=solid(pressure=1e5 * (1 + side * WIDTH_ERROR_LIMIT)))
    found = errors(coarse, contact(solid_pressure=solid(pressure=1e5)))
    assert found["flags"] == (FLAGS["inaccurate_area"] if side > 1 else 0)


def test_a_trace_of_real_contact_need_not_be_accurate():
    found = errors(contact(solid_pressure=solid(pressure=20.0)), contact(solid_pressure=solid(pressure=10.0)))
    assert found["flags"] == 0
    assert found["real_contact_width_error"] > 0


def test_a_point_whose_finer_copy_failed_is_not_vouched_for():
    found = errors(contact(), contact(converged=False))
    assert np.isnan(found["friction_coefficient_fluid_error"])
    assert np.isfinite(found["friction_coefficient_fluid"])
    assert found["flags"] == sum(FLAGS[f"inaccurate_{name}"] for name in ("friction", "separation", "area"))


def test_a_failed_point_is_not_called_inaccurate_as_well():
    assert errors(contact(converged=False), contact())["flags"] == FLAGS["not_converged"]


def test_every_load_is_swept_over_all_speeds():
    solver = Returning(contact(), contact())
    arrays = sweep_arrays(problem(), [10.0, 20.0, 30.0], [0.1, 0.2], solver)
    assert solver.asked == [(10.0, [0.1, 0.2]), (20.0, [0.1, 0.2]), (30.0, [0.1, 0.2])]
    assert {values.shape for values in arrays.values()} == {(3, 2)}
    assert "friction_coefficient_fluid_error" not in arrays


def test_time_of_a_point_is_kept_or_shared_out():
    kept = sweep_arrays(problem(), [LOAD], [0.1, 0.2], Returning(contact(seconds=2.0), contact(seconds=3.0)))
    assert kept["solver_seconds"].tolist() == [[2.0, 3.0]]
    shared = sweep_arrays(problem(), [LOAD], [0.1, 0.2], Returning(contact(), contact()))["solver_seconds"]
    assert shared[0, 0] == shared[0, 1] >= 0


def test_fields_of_different_grids_are_padded():
    arrays = sweep_arrays(problem(), [LOAD], [0.1, 0.2], Returning(contact(201), contact(151)), fields=True)
    assert arrays["x"].shape == (1, 2, 201)
    assert np.isfinite(arrays["separation"][0, 0]).all()
    assert np.isfinite(arrays["separation"][0, 1, :151]).all()
    assert np.isnan(arrays["separation"][0, 1, 151:]).all()


def test_stacking_keeps_integers_and_truth_values():
    parts = [
        {"flags": np.array([1, 2]), "converged": np.array([True, False])},
        {"flags": np.array([4, 8]), "converged": np.array([False, True])},
    ]
    stacked = stack(parts)
    assert stacked["flags"].dtype.kind == "i"
    assert stacked["converged"].dtype == bool
    assert stacked["flags"].tolist() == [[1, 2], [4, 8]]


def test_stacking_pads_to_the_longest_with_nan():
    stacked = stack([{"x": np.ones((2, 3))}, {"x": np.ones((2, 5))}])["x"]
    assert stacked.shape == (2, 2, 5)
    assert np.isnan(stacked[0, :, 3:]).all()
    assert not np.isnan(stacked[1]).any()


def test_the_dataset_has_units_and_coordinates():
    dataset = sweep(problem(), [LOAD], [0.1, 0.2], Returning(contact(), contact()), fields=True)
    assert dict(dataset.sizes) == {"load": 1, "speed": 2, "node": 201}
    assert dataset["separation_min"].attrs["units"] == "m"
    assert dataset["x"].dims == ("load", "speed", "node")
    assert dataset["speed"].values.tolist() == [0.1, 0.2]
