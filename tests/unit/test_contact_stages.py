"""Stages of surfaces and rough contacts: what their datasets hold, in SI, whatever was swept or left out."""

from __future__ import annotations

import copy
from importlib import import_module
from pathlib import Path

import numpy as np
import pytest
import yaml

from softlub.datasets import store
from softlub.datasets.variables import FLAGS
from softlub.references.hertz_point import HertzPoint
from softlub.stages import law as law_stage
from softlub.stages.deflection_study import deflections
from softlub.stages.topography import height_density
from softlub.study import load, plan
from softlub.surfaces.spectrum import SelfAffine
from softlub.surfaces.synthesis import synthesize

CONFIG = Path(__file__).parents[2] / "config"
SURFACE = {
    "kind": "self_affine",
    "rms_roughness": 1e-6,
    "hurst": 0.8,
    "rolloff": 1.3e5,
    "cutoff": 4.9e5,
    "size": 2e-4,
    "points": 32,
    "realisations": 1,
}
LOADS = [0.05, 0.2, 0.6]
CONTACT = {
    "kind": "rough_contact",
    "scene": {"surface": SURFACE, "body": {"material": {"young_modulus": 3e6, "poisson_ratio": 0.5}}},
    "grid": {"normalised_pressure": LOADS},
}


@pytest.fixture
def computed(tmp_path):
    """The dataset of a study, all its stages run in this process."""

    def compute(block, accuracy="standard", **changes):
        path = tmp_path / "mine.yaml"
        path.write_text(yaml.safe_dump({**copy.deepcopy(block), **changes}, sort_keys=False))
        made = plan(load(path, accuracy=accuracy, config_dir=CONFIG))
        for node in made.nodes:
            if node.kind == "figure":
                continue
            inputs: dict[str, list[Path]] = {"files": [Path(file) for file in node.files]}
            for other in made.inputs(node):
                inputs.setdefault(other.kind, []).append(tmp_path / other.path)
            stage = import_module(f"softlub.stages.{node.spec['stage']}")
            stage.run(spec=node.spec, inputs=inputs, outputs=[tmp_path / node.path])
        return store.read(tmp_path / made.nodes[-1].path)

    return compute


def grid(**entries):
    return {**CONTACT["grid"], **entries}


def test_a_single_surface_has_its_loads_alone(computed):
    dataset = computed(CONTACT)
    assert dict(dataset.sizes) == {"load_step": 3}
    assert dataset["converged"].values.all()
    np.testing.assert_allclose(dataset["reduced_pressure"] / dataset["rms_slope_spectral"], LOADS)
    np.testing.assert_allclose(dataset["pressure"], 4e6 * dataset["reduced_pressure"])
    np.testing.assert_allclose(dataset["kappa"] * LOADS, dataset["contact_area_ratio"])
    assert float(dataset["rms_roughness"]) == pytest.approx(1e-6)
    assert {"units", "long_name"} <= set(dataset["kappa"].attrs)


def test_heights_separations_and_pressures_grow_with_the_roughness_and_areas_stay(computed):
    rough = computed(CONTACT, grid=grid(**{"scene.surface.rms_roughness": [1e-6, 3e-6]}))
    one, three = (rough.isel(rms_roughness=index) for index in (0, 1))
    for name in ("mean_separation", "mean_separation_persson", "reduced_pressure", "rms_slope_forward"):
        np.testing.assert_allclose(three[name], 3 * one[name], rtol=1e-12)
    for name in ("contact_area_ratio", "contact_area_ratio_pixel", "kappa", "kappa_local", "kurtosis"):
        np.testing.assert_allclose(three[name], one[name], rtol=1e-12)


def test_surfaces_of_unequal_number_and_those_not_run_stand_side_by_side(computed):
    rows = [
        {**SURFACE, "realisations": 2, "label": "two"},
        {**SURFACE, "label": "one"},
        {**SURFACE, "points": 4096, "label": "large"},
    ]
    dataset = computed(CONTACT, scene={}, grid=grid(**{"scene.surface": rows}))
    assert dict(dataset.sizes) == {"surface": 3, "realisation": 2, "load_step": 3}
    assert dataset["realisations"].values.tolist() == [2, 1, 0]
    assert dataset["points"].values.tolist() == [32, 32, 4096]
    known = np.isfinite(dataset["mean_separation"].values).all(axis=2)
    assert known.tolist() == [[True, True], [True, False], [False, False]]
    assert dataset["converged"].values.all(axis=2).tolist() == known.tolist()
    attempted = (dataset["flags"].values & FLAGS["not_attempted"] == 0).all(axis=2)
    assert attempted.tolist() == known.tolist()
    np.testing.assert_array_equal(dataset["kappa"].values[0, 0], dataset["kappa"].values[1, 0])


def test_solvers_and_boundaries_are_dimensions(computed):
    solvers = ["conjugate_gradients", {"name": "polonsky_keer", "tolerance": 1e-7}]
    dataset = computed(CONTACT, grid=grid(solver=solvers, **{"scene.boundary": ["periodic", "free"]}))
    assert dict(dataset.sizes) == {"boundary": 2, "solver": 2, "load_step": 3}
    ours, theirs = (dataset.sel(solver=name) for name in ("conjugate_gradients", "polonsky_keer"))
    assert dataset["converged"].values.all()
    np.testing.assert_allclose(ours["mean_separation"], theirs["mean_separation"], atol=1e-4 * 1e-6)
    periodic, free = (ours["mean_separation"].sel(boundary=name) for name in ("periodic", "free"))
    assert np.all(np.abs(periodic - free) > 1e-3 * 1e-6)


def test_a_load_beyond_full_contact_is_solved_and_said_so(computed):
    dataset = computed(CONTACT, grid=grid(normalised_pressure=[0.1, 10.0]))
    assert dataset["full_contact"].values.tolist() == [0, 1]
    assert dataset["converged"].values.all()
    assert float(dataset["contact_area_ratio"][1]) == 1
    assert float(dataset["mean_separation"][1]) == pytest.approx(0, abs=1e-15)


def test_points_are_counted_below_gaps_in_metres(computed):
    dataset = computed(CONTACT, gap_thresholds=[1e-9, 1e-6, 1e-3])
    assert dataset["threshold"].values.tolist() == [1e-9, 1e-6, 1e-3]
    counted = dataset["contact_area_ratio_gap"].transpose("load_step", "threshold").values
    assert np.all(np.diff(counted, axis=1) >= 0)
    assert np.all(counted[:, 2] == 1)
    np.testing.assert_allclose(counted[:, 0], dataset["contact_area_ratio_pixel"], atol=0.01)


def test_a_law_that_will_not_fit_stops_before_any_surface_is_made(tmp_path, monkeypatch):
    from softlub.contact import memory

    monkeypatch.setattr(memory, "available_bytes", lambda: 1e6)
    monkeypatch.setattr(law_stage, "make", lambda *_: pytest.fail("a surface was made"))
    spec = {"surface": {**SURFACE, "points": 8192, "seed": 1}, "boundary": None}
    with pytest.raises(MemoryError, match=r"8192 x 8192 points needs about \d"):
        law_stage.run(spec, {}, [tmp_path / "law.nc"])
    assert not (tmp_path / "law.nc").exists()


def test_a_surface_and_a_line_stand_in_one_dataset(computed):
    line = {
        "kind": "self_affine_line",
        "rms_roughness": 1e-6,
        "hurst": 0.8,
        "rolloff": 3e4,
        "cutoff": 1e6,
        "length": 1e-3,
        "points": 500,
        "rise": 1e-5,
        "waviness_wavelength": 2e-4,
    }
    dataset = computed(
        {"kind": "surface", "scene": {"surface": SURFACE, "line": line}, "outputs": ["heights"]}
    )
    assert dict(dataset["height"].sizes) == {"x": 32, "y": 32}
    assert float(dataset["height"].std()) == pytest.approx(1e-6, rel=1e-5)
    assert dataset.sizes["position"] == 500
    raw, without_form, roughness = (
        float(dataset[f"profile_{stage}"].std()) for stage in ("raw", "form_removed", "roughness")
    )
    assert raw > 2 * without_form > 2 * roughness > 0


def test_swept_surfaces_share_the_coordinates_that_they_have_in_common(computed):
    block = {"kind": "surface", "scene": {"surface": {**SURFACE, "realisations": 2}}}
    dataset = computed(block, grid={"scene.surface.wavevectors": ["linear", "exponential"]})
    assert set(dataset["power_spectrum"].dims) == {"wavevectors", "realisation", "wavevector"}
    assert np.isfinite(dataset["power_spectrum"]).all()
    assert dataset["rms_roughness"].sizes == {"wavevectors": 2, "realisation": 2}


def test_height_density_is_a_density_on_common_bins():
    surface = synthesize(SelfAffine(1.01e-6, 0.8, 1.3e5, 4.9e5), 2e-4, 64, seed=1)
    other = synthesize(SelfAffine(0.97e-6, 0.8, 1.3e5, 4.9e5), 2e-4, 64, seed=2)
    bins, density = height_density(surface)
    assert np.sum(density) * 1e-7 == pytest.approx(1)
    assert bins == pytest.approx(np.rint(bins / 1e-7) * 1e-7, abs=1e-18)
    shorter = min((bins, height_density(other)[0]), key=len)
    assert np.isin(shorter[3:-3], bins).all()


def test_hertz_deflection_is_that_of_the_approach_and_smooth_at_the_edge():
    hertz = HertzPoint(0.01, 4.4e6, 1.3)
    a = hertz.contact_radius
    assert float(hertz.deflection(0.0)) == pytest.approx(hertz.approach)
    inside = np.linspace(0, a, 11)
    np.testing.assert_allclose(hertz.deflection(inside), hertz.approach - inside**2 / 0.02, rtol=1e-12)
    assert float(hertz.deflection(a * (1 + 1e-9))) == pytest.approx(float(hertz.deflection(a)), rel=1e-6)
    far = 100 * a
    assert float(hertz.deflection(far)) == pytest.approx(1.3 / (np.pi * 4.4e6 * far), rel=1e-3)


def test_summation_and_transforms_agree_and_converge_to_hertz():
    hertz = HertzPoint(0.01, 4.4e6, 1.3)
    errors = []
    for points in (33, 129):
        dataset = deflections(hertz, points)
        direct, fast = (dataset["deflection"].sel(method=name) for name in ("direct", "dc_fft"))
        np.testing.assert_allclose(direct, fast, rtol=1e-12)
        errors.append(float(abs(fast / dataset["deflection_hertz"] - 1).max()))
    assert errors[1] < errors[0] / 4
    assert errors[1] < 5e-3
