"""Studies of surfaces, some of which were too large to be made."""

import numpy as np
import xarray as xr

from softlub.stages.surface_study import swept


def made(wavevectors):
    density = xr.DataArray(np.ones(len(wavevectors)), dims="wavevector")
    return xr.Dataset({"power_spectrum": density, "size": 1e-4}, coords={"wavevector": wavevectors})


def test_a_surface_that_was_not_made_has_no_spectrum():
    rows = [made([1.0, 2.0]), xr.Dataset({"size": 2e-4}), made([1.0, 3.0])]
    joined = swept(rows, [{"dimension": "surface", "labels": ["a", "b", "c"]}])
    assert list(joined["size"].values) == [1e-4, 2e-4, 1e-4]
    assert list(joined["wavevector"].values) == [1.0, 2.0, 3.0]
    assert list(
        np.isfinite(joined["power_spectrum"].transpose("surface", "wavevector").values).sum(axis=1)
    ) == [2, 0, 2]
