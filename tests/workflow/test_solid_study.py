"""Finite-element bodies through the whole workflow: a study of them, of equivalents, and a film on one."""

import numpy as np
import pytest
import xarray as xr
from test_own_study import jobs_run

BODY = "{shape: {kind: triangle}, material: MATERIAL, mesh: {edge_nodes: 65, rows: 8, flank_columns: 14}STIFFNESS}"
SOFT = "{kind: neo_hookean, c10: 0.6 MPa, d1: 0.001 1/MPa}"
RELAXING = (
    f"{{kind: viscoelastic, hyperelastic: {SOFT}, "
    "prony: {normalised: long_term, times: [1 ms], terms: [0.5]}}"
)
SOLID = f"""
kind: solid
scene:
  body: {BODY.replace("MATERIAL", SOFT).replace("STIFFNESS", "")}
grid:
  load: 17 N/m
  scene.friction: [0, 0.4]
compare: [reduced, half_space]
datum: [1 mm, 10 mm]
outputs: [mesh, history]
"""
EQUIVALENCE = f"""
kind: equivalence
scene:
  body: {BODY.replace("MATERIAL", RELAXING).replace("STIFFNESS", "")}
  friction: 0.4
  steps: {{in_contact: 1 ms, loading: 1 ms, sliding: 1 ms, increments: 4}}
grid: {{load: 17 N/m, coefficient: [1]}}
"""
FILM = f"""
scene:
  body: {BODY.replace("MATERIAL", SOFT).replace("STIFFNESS", ", stiffness: initial")}
  surface: {{kind: self_affine, rms_roughness: 0.3 um, hurst: 0.8, rolloff: 1e5 1/m, cutoff: 1e8 1/m}}
  lubricant: {{viscosity: 1 mPa s}}
grid: {{load: 17 N/m, speed: [1e-3 m/s, 0.1 m/s]}}
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


def test_a_solid_study_compares_finite_elements_with_what_stands_for_them(workspace, opened):
    run(workspace, SOLID)
    assert len(workspace.made("state/*.nc")) == 2
    assert len(workspace.made("stiffness/*.nc")) == 1
    dataset = opened("studies/tiny.nc")
    assert dataset["displacement"].dims == ("friction", "load", "method", "node", "component")
    assert bool((dataset["converged"] == 1).all())
    assert bool((dataset["stop_reason"] == "").all())
    # The nodal forces are the load, and friction's share of it.
    carried = dataset["nodal_force"].sum("node")
    np.testing.assert_allclose(carried.sel(component="y"), [[17], [17]], rtol=1e-9)
    np.testing.assert_allclose(carried.sel(component="x"), [[0], [6.8]], rtol=1e-9, atol=1e-9)
    reduced = dataset.sel({"method": "reduced"})
    assert bool((reduced["displacement_error"] < 0.02).all())
    assert bool((dataset["displacement_half_space_error"] > reduced["displacement_error"]).all())
    # The half-space's datum shifts it as a whole.
    shift = dataset["displacement_half_space"].diff("datum").sel(component="y").squeeze("datum")
    np.testing.assert_allclose(shift, shift.mean("node").broadcast_like(shift), rtol=1e-9)
    assert dataset["mesh_displacement"].dims == ("friction", "load", "mesh_node", "component")
    assert dataset["displacement_history"].sizes["increment"] == 3
    assert dataset["displacement"].attrs["units"] == "m"

    heavier = run(workspace, SOLID.replace("17 N/m", "20 N/m"), "--dry-run")
    assert "stiffness" not in jobs_run(heavier)
    assert jobs_run(heavier)["state"] == 2
    assert "state" not in jobs_run(run(workspace, SOLID.replace("reduced, ", ""), "--dry-run"))


def test_an_equivalent_body_takes_the_shape_of_a_viscoelastic_one(workspace, opened):
    run(workspace, EQUIVALENCE)
    dataset = opened("studies/tiny.nc").squeeze("load")
    assert list(dataset["model"].values) == ["viscoelastic", "fitted", "alpha=1"]
    assert bool((dataset["converged"] == 1).all())
    # Relaxation takes as long as the steps: stiffer than at rest, softer than at once.
    assert 1 < float(dataset["coefficient"].sel(model="fitted")) < 1.5
    difference = dataset["shape_difference"]
    assert (
        difference.sel(model="fitted") < difference.sel(model="alpha=1") < dataset["shape_difference_rigid"]
    )
    reduced = dataset["displacement_reduced_error"]
    assert reduced.sel(model="fitted") < reduced.sel(model="alpha=1")


def test_a_film_reads_the_stiffness_which_a_changed_load_leaves_as_it_is(workspace, opened):
    run(workspace, FILM)
    dataset = opened("studies/tiny.nc")
    assert bool((dataset["converged"] == 1).all())
    slow, fast = dataset["load_share_solid"].squeeze("load").values
    assert slow > fast
    heavier = run(workspace, FILM.replace("17 N/m", "20 N/m"), "--dry-run")
    assert "stiffness" not in jobs_run(heavier)
    assert jobs_run(heavier)["panel"] == 1


def test_a_body_that_cannot_be_meshed_is_refused_before_any_job(workspace):
    workspace.study.write_text(SOLID.replace("{kind: triangle}", "{kind: triangle, edge_width: 8 mm}"))
    refused = workspace.run()
    said = refused.stderr + refused.stdout
    assert refused.returncode != 0
    assert "narrower" in said
    assert "Traceback" not in said
    assert not workspace.made("**/*.nc")
