"""Sentences about the points of a dataset; captions are made of them."""

import numpy as np
import xarray as xr

from softlub.datasets.state import convergence, failures, flag_meanings, flagged
from softlub.datasets.variables import FLAG_EXPLANATIONS, FLAGS


def points(flags, **coords):
    values = np.array(flags, dtype=np.int32)
    dimensions = [*coords, "speed"][-values.ndim :]
    bad = FLAGS["not_converged"] | FLAGS["not_attempted"]
    return xr.Dataset(
        {"flags": (dimensions, values), "converged": (dimensions, ((values & bad) == 0).astype(np.int8))},
        coords={"speed": [0.1, 1.0, 10.0], **coords},
    )


def test_points_without_fault():
    dataset = points([0, 0, 0])
    assert convergence(dataset) == "All 3 points converged."
    assert failures(dataset) == 0
    assert flagged(dataset) == flag_meanings(dataset) == ""


def test_points_not_asked_for_are_no_failures():
    dataset = points([FLAGS["not_attempted"], FLAGS["not_converged"], 0])
    assert convergence(dataset) == "1 of 2 points did not converge."
    assert failures(dataset) == 1
    assert flagged(dataset) == ""


def test_solvers_are_told_apart():
    dataset = points([[0, 0, 0], [0, FLAGS["not_converged"], 0]], solver=["bml", "ehl"])
    assert convergence(dataset) == "1 of 6 points did not converge (bml: 0 of 3; ehl: 1 of 3)."


def test_flags_are_counted_where_they_are():
    both = FLAGS["inaccurate_area"] | FLAGS["percolates"]
    dataset = points([both, FLAGS["inaccurate_area"], FLAGS["not_converged"]])
    assert flagged(dataset) == (
        "2 of 2 converged points are flagged: percolates 1 (v = 0.1 m/s), inaccurate_area 2 (v from 0.1 to 1 m/s)."
    )
    assert FLAG_EXPLANATIONS["percolates"] in flag_meanings(dataset)
    assert FLAG_EXPLANATIONS["not_converged"] not in flag_meanings(dataset)


def test_datasets_without_points_say_nothing():
    assert convergence(xr.Dataset()) == flagged(xr.Dataset()) == flag_meanings(xr.Dataset()) == ""
    assert failures(xr.Dataset()) == 0


def test_nothing_asked_for_says_nothing():
    dataset = points([FLAGS["not_attempted"]] * 3)
    assert convergence(dataset) == ""
    assert failures(dataset) == 0


def test_bodies_not_asked_for_are_not_counted():
    dataset = xr.Dataset(
        {
            "converged": ("load", [True, False]),
            "flags": ("load", [0, FLAGS["not_attempted"]]),
            "stop_reason": ("load", ["", ""]),
        }
    )
    assert convergence(dataset) == "The body got to the end of its steps."
