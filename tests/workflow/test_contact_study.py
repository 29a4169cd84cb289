"""Rough contact through the whole workflow: a study of it, and a film that reads its law."""

import numpy as np
import pytest
import xarray as xr
from test_own_study import jobs_run

SURFACE = (
    "{kind: self_affine, rms_roughness: 1 um, hurst: 0.8, rolloff: 6.3e4 1/m, cutoff: 9e5 1/m, "
    "size: 0.2 mm, points: 64, realisations: 2}"
)
DRY = f"""
kind: rough_contact
scene:
  surface: {SURFACE}
  body: {{material: {{young_modulus: 3 MPa, poisson_ratio: 0.5}}}}
grid:
  scene.surface.hurst: [0.5, 0.8]
  normalised_pressure: {{from: 1e-2, to: 1, points: 6, spacing: log}}
outputs: [maps]
figures: [area_and_separation]
"""
FILM = """
scene:
  body: {shape: {kind: cylinder, radius: 10 mm}, material: {young_modulus: 3 MPa, poisson_ratio: 0.5}}
  surface: SURFACE
  contact_law: boundary_element
  lubricant: {viscosity: 0.1 Pa s}
grid: {load: 100 N/m, speed: [1e-4 m/s, 1e-2 m/s, 1 m/s], scene.surface.rms_roughness: [1 um, 2 um]}
"""


@pytest.fixture
def opened(workspace):
    def read(pattern):
        (path,) = workspace.made(pattern)
        with xr.open_dataset(path) as dataset:
            return dataset.load()

    return read


def run(workspace, text, *arguments):
    workspace.study.write_text(text)
    result = workspace.run(*arguments)
    assert result.returncode == 0, result.stderr[-3000:]
    return result


def test_a_rough_contact_gives_curves_maps_and_figure(workspace, opened):
    run(workspace, DRY)
    dataset = opened("studies/tiny.nc")
    assert dict(dataset.sizes) == {"hurst": 2, "realisation": 2, "load_step": 6, "x": 64, "y": 64}
    assert bool((dataset["converged"] == 1).all())
    assert dataset["mean_separation"].attrs["units"] == "m"
    area, gap = dataset["contact_area_ratio"], dataset["mean_separation"]
    assert bool((area.diff("load_step") > 0).all())
    assert bool((gap.diff("load_step") < 0).all())
    # In SI: the modulus is 4 MPa, and the maps carry the load.
    np.testing.assert_allclose(dataset["pressure"], 4e6 * dataset["reduced_pressure"])
    carried = dataset["contact_pressure"].astype(float).mean(["x", "y"])
    np.testing.assert_allclose(carried, dataset["pressure"].isel(realisation=0), rtol=1e-4)
    np.testing.assert_allclose(dataset["rms_roughness"], 1e-6)
    assert {path.suffix for path in workspace.made("figures/tiny/*")} >= {".pdf", ".png", ".svg", ".csv"}


def test_a_film_reads_the_law_which_a_changed_speed_leaves_as_it_is(workspace, opened):
    run(workspace, FILM.replace("SURFACE", SURFACE))
    assert len(workspace.made("law/*.nc")) == 1
    dataset = opened("studies/tiny.nc")
    assert bool((dataset["converged"] == 1).all())
    np.testing.assert_allclose(dataset["rms_roughness"], [1e-6, 2e-6])
    slow, fast = (dataset["load_share_solid"].sel(speed=speed) for speed in (1e-4, 1.0))
    assert bool((slow > 0.3).all())
    assert bool((fast < 0.1).all())

    faster = run(workspace, FILM.replace("SURFACE", SURFACE).replace("1 m/s]", "2 m/s]"), "--dry-run")
    assert "law" not in jobs_run(faster)
    assert jobs_run(faster)["panel"] == 1


def test_a_measured_surface_is_read_where_it_lies_and_again_when_it_changes(workspace, opened):
    rng = np.random.default_rng(1)
    path = workspace.folder / "area.txt"

    def write():
        heights = np.cumsum(np.cumsum(rng.normal(size=(32, 32)), axis=0), axis=1)
        np.savetxt(path, heights, header="Width: 20 um\nHeight: 20 um\nValue units: nm")

    write()
    measured = FILM.replace("SURFACE", "{kind: measured, file: area.txt, tapered_fraction: 0.5}")
    measured = measured.replace(", scene.surface.rms_roughness: [1 um, 2 um]", "")
    run(workspace, measured)
    dataset = opened("studies/tiny.nc")
    assert bool((dataset["converged"] == 1).all())
    assert 0 < float(dataset["rms_roughness"]) < 1e-6
    write()
    assert jobs_run(run(workspace, measured, "--dry-run"))["law"] == 1
