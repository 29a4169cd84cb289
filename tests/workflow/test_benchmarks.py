"""The benchmarks are not run by the tests; what they share with the rest is."""

import importlib
import re
from pathlib import Path

import numpy as np
import pytest

from softlub.datasets.variables import FLAGS
from softlub.study import load, plan

ROOT = Path(__file__).resolve().parents[2]
NAMES = re.findall(
    r'^    "(\w+)",$', (ROOT / "workflow" / "rules" / "benchmarks.smk").read_text(), re.MULTILINE
)


@pytest.fixture
def module(monkeypatch):
    monkeypatch.syspath_prepend(str(ROOT / "benchmarks"))
    return importlib.import_module


def test_some_benchmarks_are_listed():
    assert "work_precision" in NAMES


@pytest.mark.parametrize("name", NAMES)
def test_every_listed_benchmark_measures_and_draws(module, name):
    benchmark = module(name)
    assert callable(benchmark.measure)
    assert callable(benchmark.draw)


@pytest.fixture
def stressed(module):
    """One family of the stress test whose first point is declared a failure."""
    part = module("stress_chunk").measure(chunk=0, families=1)
    part["flags"][0] = FLAGS["not_converged"]
    return part, module("stress").measure([part, part])


def test_the_stress_test_counts_what_failed(stressed):
    part, joined = stressed
    assert joined.attrs["points"] == 20
    assert joined.attrs["points"] - joined.attrs["converged"] == 2
    assert joined.attrs["checked"] == 2
    assert joined.attrs["not_a_number_unflagged"] == 0
    assert joined.sizes["point"] == 2 * part.sizes["point"]


def test_an_unflagged_nan_and_a_wrong_point_are_counted(module, stressed):
    part, _ = stressed
    part["friction_coefficient"][1] = np.nan
    part["true_error_separation"][2] = 1.0
    joined = module("stress").measure([part])
    assert joined.attrs["not_a_number_unflagged"] == 1
    assert joined.attrs["silently_wrong"] == 1


def test_a_failed_point_becomes_a_study_file_that_can_be_read(module, stressed, tmp_path):
    part, joined = stressed
    module("stress").write_failures(joined, tmp_path)
    paths = sorted(tmp_path.glob("*.yaml"))
    assert len(paths) == 2
    study = load(paths[0], config_dir=ROOT / "config")
    (panel,) = [node for node in plan(study).nodes if node.kind == "panel"]
    assert panel.spec["speed"] == pytest.approx([float(part["speed"][0])])
    assert panel.spec["load"] == pytest.approx([float(part["load"][0])])
    material = panel.spec["scene"]["body"]["material"]
    assert material["young_modulus"] == pytest.approx(float(part["young_modulus"][0]))
