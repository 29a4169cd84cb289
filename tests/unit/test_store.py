"""One format, written whole or not at all."""

import json
import os
import subprocess
import sys

import numpy as np
import pytest
import xarray as xr

from softlub.datasets import store
from softlub.datasets.variables import FLAGS, VARIABLES


@pytest.fixture
def dataset():
    speed = np.geomspace(1e-5, 1, 4)
    return xr.Dataset(
        {
            "friction_coefficient": (("load", "speed"), [[0.3, 0.1, np.nan, 0.2]]),
            "converged": (("load", "speed"), [[True, True, False, True]]),
            "flags": (("load", "speed"), np.array([[0, 2, 1, 12]], dtype=np.int32)),
            "my_own_quantity": ("speed", np.arange(4.0), {"units": "K"}),
        },
        {"load": [100.0], "speed": speed},
    )


def test_round_trip(dataset, tmp_path):
    path = tmp_path / "new folder" / "panel.nc"
    store.write(dataset, path)
    found = store.read(path)
    xr.testing.assert_equal(found, dataset)
    assert found["converged"].dtype == bool
    assert found["flags"].dtype == np.int32


def test_variables_get_their_units_and_equation(dataset, tmp_path):
    store.write(dataset, tmp_path / "panel.nc")
    found = store.read(tmp_path / "panel.nc")
    assert found["speed"].attrs["units"] == "m/s"
    assert found["friction_coefficient"].attrs["source_equation"] == "3-38"
    assert found["my_own_quantity"].attrs == {"units": "K"}
    assert list(found["flags"].attrs["flag_masks"]) == list(FLAGS.values())
    assert found["flags"].attrs["flag_meanings"].split() == list(FLAGS)


def test_describing_and_writing_leave_the_dataset_alone(dataset, tmp_path):
    before = dataset.copy(deep=True)
    store.describe(dataset)
    store.write(dataset, tmp_path / "panel.nc", {"title": "elsewhere"})
    xr.testing.assert_identical(dataset, before)


def test_an_attribute_of_one_s_own_wins(dataset):
    dataset["friction_coefficient"].attrs["long_name"] = "as measured"
    described = store.describe(dataset)
    assert described["friction_coefficient"].attrs["long_name"] == "as measured"
    assert described["friction_coefficient"].attrs["units"] == "1"


def test_attributes_that_netcdf_refuses_travel_as_json(dataset, tmp_path):
    attributes = {
        "stand_in": True,
        "seed": None,
        "study": {"scene": {"loads": [1.0, 2.0], "smooth": False}},
        "title": "Stribeck",
        "count": 3,
    }
    store.write(dataset, tmp_path / "panel.nc", attributes)
    found = store.read(tmp_path / "panel.nc").attrs
    assert json.loads(found["stand_in"]) is True
    assert json.loads(found["seed"]) is None
    assert json.loads(found["study"]) == attributes["study"]
    assert found["title"] == "Stribeck"
    assert found["count"] == 3


def test_fields_are_compressed(tmp_path):
    fields = xr.Dataset({"fluid_pressure": (("speed", "node"), np.zeros((50, 1000)))})
    store.write(fields, tmp_path / "fields.nc")
    with xr.open_dataset(tmp_path / "fields.nc", engine="netcdf4") as stored:
        assert stored["fluid_pressure"].encoding["zlib"]
    assert (tmp_path / "fields.nc").stat().st_size < 0.2 * fields.nbytes


def test_scalars_are_written_too(tmp_path):
    """netCDF compresses no scalar: asking for it would be refused."""
    store.write(xr.Dataset({"friction_coefficient": 0.25, "converged": True}), tmp_path / "point.nc")
    found = store.read(tmp_path / "point.nc")
    assert float(found["friction_coefficient"]) == 0.25
    assert bool(found["converged"]) is True


def test_a_failed_write_leaves_the_old_file_and_nothing_else(dataset, tmp_path):
    path = tmp_path / "panel.nc"
    store.write(dataset, path)
    before = path.read_bytes()
    unwritable = dataset.assign(friction_coefficient=("speed", np.array([{}, {}, {}, {}], dtype=object)))
    with pytest.raises((TypeError, ValueError)):
        store.write(unwritable, path)
    assert path.read_bytes() == before
    assert os.listdir(tmp_path) == ["panel.nc"]


KILLED_WRITE = """
import os, signal, sys
import numpy as np, xarray as xr
from softlub.datasets import store

def killed(*_):
    os.kill(os.getpid(), signal.SIGKILL)

os.replace = killed
store.write(xr.Dataset({"speed": ("speed", np.ones(3))}), sys.argv[1])
"""


def test_a_killed_write_leaves_no_file_that_looks_finished(tmp_path):
    path = tmp_path / "panel.nc"
    done = subprocess.run([sys.executable, "-c", KILLED_WRITE, str(path)], check=False)
    assert done.returncode == -9
    assert not path.exists()
    assert not list(tmp_path.glob("*.nc"))
    store.write(xr.Dataset({"speed": ("speed", np.ones(3))}), path)
    assert store.read(path).sizes == {"speed": 3}


def test_every_variable_says_what_it_is():
    assert all(variable.units and variable.long_name for variable in VARIABLES.values())


def test_flags_are_distinct_bits():
    bits = list(FLAGS.values())
    assert all(bit > 0 and bit & (bit - 1) == 0 for bit in bits)
    assert len(set(bits)) == len(bits)
