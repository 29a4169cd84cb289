"""Studies of surfaces and rough contacts: what is planned, counted by nodes, and what is refused."""

from __future__ import annotations

import copy
import math
import shutil
from pathlib import Path

import numpy as np
import pytest
import yaml

from softlub.study import StudyError, load, merge, plan

ROOT = Path(__file__).parents[2]
SURFACE = {
    "kind": "self_affine",
    "rms_roughness": 1e-6,
    "hurst": 0.8,
    "rolloff": 6.3e4,
    "cutoff": 1e6,
    "size": 4e-4,
    "points": 128,
}
CONTACT = {"kind": "rough_contact", "scene": {"surface": SURFACE}}
FILM = {
    "scene": {
        "body": {"shape": "table_3_1", "material": "table_3_1"},
        "surface": SURFACE,
        "contact_law": "boundary_element",
        "lubricant": "table_3_1",
    },
    "grid": {"load": 100, "speed": [1e-3, 1e-2, 0.1]},
}


def changed(block, changes):
    block = copy.deepcopy(block)
    for key, value in changes.items():
        *parents, last = key.split("/")
        place = block
        for parent in parents:
            place = place.setdefault(parent, {})
        if value is None:
            del place[last]
        else:
            place[last] = value
    return block


@pytest.fixture
def planned(tmp_path):
    def make(block, changes=None, name="one", **options):
        path = tmp_path / f"{name}.yaml"
        path.write_text(yaml.safe_dump(changed(block, changes or {}), sort_keys=False))
        return plan(load(path, config_dir=ROOT / "config", **options))

    return make


@pytest.fixture
def message(tmp_path):
    def make(block, changes, **options):
        path = tmp_path / "mine.yaml"
        path.write_text(yaml.safe_dump(changed(block, changes), sort_keys=False))
        with pytest.raises(StudyError) as caught:
            load(path, config_dir=ROOT / "config", **options)
        text = str(caught.value)
        assert str(path) in text
        assert "Traceback" not in text
        return text

    return make


def counts(of):
    return {kind: len(of.of_kind(kind)) for kind in ("topography", "law", "panel", "study", "figure")}


def keys(of, kind="law"):
    return [node.key for node in of.of_kind(kind)]


def test_a_film_over_rough_contact_reads_one_law(planned):
    made = planned(FILM)
    assert counts(made) == {"topography": 0, "law": 1, "panel": 1, "study": 1, "figure": 0}
    law, panel, _ = made.nodes
    assert law.path == f"law/{law.key}.nc"
    assert made.inputs(panel) == (law,)
    assert panel.spec["laws"] == [0]


def test_smooth_and_analytic_scenes_plan_no_law(planned):
    for law, surface in (("persson", SURFACE), ("none", SURFACE), (None, "smooth")):
        made = planned(FILM, {"scene/contact_law": law, "scene/surface": surface})
        assert counts(made) == {"topography": 0, "law": 0, "panel": 1, "study": 1, "figure": 0}


def test_pieces_of_a_surface_are_in_no_key_where_nobody_makes_them(planned):
    bare = {key: value for key, value in SURFACE.items() if key not in ("size", "points")}
    one = planned(FILM, {"scene/contact_law": "persson"})
    other = planned(FILM, {"scene/contact_law": "persson", "scene/surface": bare})
    assert keys(one, "panel") == keys(other, "panel")


def test_a_law_is_shared_by_all_studies_roughnesses_moduli_speeds_and_loads(planned):
    one = planned(FILM)
    others = [
        planned(FILM, {"scene/surface/rms_roughness": 3e-6}, "rougher"),
        planned(FILM, {"scene/body/material": "pdms"}, "softer"),
        planned(FILM, {"grid/speed": [1.0]}, "faster"),
        planned(FILM, {"scene/contact_law": {"name": "boundary_element", "pressure_factor": 0.25}}, "weaker"),
        planned(CONTACT, {}, "dry"),
        planned(CONTACT, {"scene/body": {"material": "pdms"}}, "material"),
    ]
    assert counts(merge([one, *others]))["law"] == 1
    swept = planned(FILM, {"grid/scene.surface.rms_roughness": [1e-6, 2e-6, 3e-6]})
    assert counts(swept)["law"] == 1
    assert swept.of_kind("panel")[0].spec["laws"] == [0, 0, 0]


@pytest.mark.parametrize(
    "change",
    [{"hurst": 0.7}, {"cutoff": 9e5}, {"size": 3.9e-4}, {"points": 130}, {"seed": 2}, {"realisations": 2}],
    ids=str,
)
def test_whatever_changes_the_heights_changes_the_law(planned, change):
    other = planned(FILM, {f"scene/surface/{key}": value for key, value in change.items()})
    assert keys(other) != keys(planned(FILM))


def test_every_swept_surface_has_a_law_and_each_scene_reads_its_own(planned):
    made = planned(
        FILM,
        {
            "grid/scene.surface.hurst": [0.5, 0.8],
            "grid/scene.contact_law": ["persson", "boundary_element"],
        },
    )
    assert counts(made)["law"] == 2
    (panel,) = made.of_kind("panel")
    assert [sweep["dimension"] for sweep in panel.spec["sweeps"]] == ["contact_law", "hurst"]
    assert panel.spec["laws"] == [None, None, 0, 1]


def test_a_sample_of_roughness_and_load_reads_one_law(planned, message):
    ranges = {
        "load": {"from": 1, "to": 10, "spacing": "log"},
        "scene.surface.rms_roughness": {"from": 1e-6, "to": 2e-6},
    }
    grid = {"speed": [1e-3], "sample": {"points": 8, "ranges": ranges}}
    assert counts(planned({**FILM, "grid": grid}))["law"] == 1
    ranges["scene.surface.hurst"] = {"from": 0.5, "to": 0.9}
    assert "a rough contact for every point of the sample" in message({**FILM, "grid": grid}, {})


def test_realisations_follow_the_accuracy_unless_the_study_says(planned):
    def realisations(points, accuracy, **further):
        surface = {**SURFACE, "points": points, **further}
        (law,) = planned(CONTACT, {"scene/surface": surface}, accuracy=accuracy).of_kind("law")
        return law.spec["surface"]["points"], law.spec["surface"]["realisations"]

    assert realisations(1024, "standard") == (1024, 3)
    assert realisations(2048, "standard") == (2048, 1)
    assert realisations(2048, "standard", realisations=2) == (2048, 2)
    assert realisations(2048, "source") == (2048, 3)
    assert realisations(2048, "draft") == (256, 3)


def test_a_draft_keeps_the_waves_that_fewer_points_carry(planned):
    surface = {**SURFACE, "points": 1024, "cutoff": 8e6}
    (law,) = planned(CONTACT, {"scene/surface": surface}, accuracy="draft").of_kind("law")
    assert law.spec["surface"]["cutoff"] == pytest.approx(math.pi * 256 / 4e-4)


def test_rows_too_large_for_the_accuracy_are_not_run_and_said_so(planned, message):
    rows = [{**SURFACE, "points": points, "label": str(points)} for points in (1024, 2048, 4096)]
    change = {"grid/scene.surface": rows, "scene": None}
    made = planned(CONTACT, change, accuracy="standard")
    assert counts(made)["law"] == 2
    study = made.node("study", "one").spec
    assert study["laws"] == [[0], [1], [None]]
    assert study["surfaces"][2]["made"] is None
    assert counts(planned(CONTACT, change, accuracy="source"))["law"] == 3
    alone = message(CONTACT, {"scene/surface/points": 4096}, accuracy="standard")
    assert "scene.surface.points = 4096" in alone
    assert "2048 at most" in alone
    assert "scene.surface.points" in message(FILM, {"scene/surface/points": 4096}, accuracy="standard")


def test_solvers_and_boundaries_have_laws_of_their_own(planned):
    made = planned(
        CONTACT,
        {
            "grid/solver": ["conjugate_gradients", {"name": "polonsky_keer", "tolerance": 1e-4}],
            "grid/scene.boundary": ["periodic", "free"],
        },
    )
    assert counts(made)["law"] == 4
    study = made.node("study", "one").spec
    assert study["laws"] == [[0, 1], [2, 3]]
    assert study["solvers"] == ["conjugate_gradients", "polonsky_keer"]


def test_pressures_and_thresholds_are_those_of_the_scaled_surface(planned):
    (law,) = planned(
        CONTACT,
        {
            "scene/body": {"material": {"young_modulus": 3e6, "poisson_ratio": 0.5}},
            "grid/pressure": ["0.1 MPa", "0.4 MPa"],
            "gap_thresholds": ["1 nm"],
        },
    ).of_kind("law")
    assert law.spec["pressures"]["over"] == "modulus"
    assert law.spec["pressures"]["values"] == pytest.approx([0.1 / 4 * 1e6, 0.4 / 4 * 1e6])
    assert law.spec["gap_thresholds"] == pytest.approx([1e-3])


def test_topographies_are_planned_where_somebody_needs_them(planned):
    assert counts(planned(CONTACT))["topography"] == 0
    drawn = planned(CONTACT, {"figures": ["spectra_and_heights"]})
    assert counts(drawn)["topography"] == 3
    alone = planned({**CONTACT, "kind": "surface"}, {"scene/surface/realisations": 2})
    assert counts(alone) == {"topography": 2, "law": 0, "panel": 0, "study": 1, "figure": 0}
    assert [node.spec["surface"]["seed"] for node in alone.of_kind("topography")] == [1, 2]


def test_heights_and_maps_are_kept_where_somebody_asks(planned):
    def heights(**changes):
        made = planned({**CONTACT, "kind": "surface"}, changes)
        return [node.spec["heights"] for node in made.of_kind("topography")]

    assert heights() == [False, False, False]
    assert heights(figures=["topography_map"]) == [True, False, False]
    assert heights(outputs=["heights"]) == [True, False, False]
    assert "maps" not in planned(CONTACT).of_kind("law")[0].spec
    assert planned(CONTACT, {"outputs": ["maps"]}).of_kind("law")[0].spec["maps"]
    assert planned(CONTACT, {"figures": ["contact_lines"]}).of_kind("law")[0].spec["maps"]


def test_a_deflection_is_one_job(planned):
    made = plan(load(ROOT / "config" / "studies" / "ch4-dcfft.yaml"))
    assert counts(made) == {"topography": 0, "law": 0, "panel": 0, "study": 1, "figure": 1}


def heights_file(path, seed=1, bad=None):
    heights = np.random.default_rng(seed).normal(size=(24, 24))
    if bad is not None:
        heights[3, 4] = bad
    np.savetxt(path, heights, header="Width: 20 um\nHeight: 20 um\nValue units: um")
    return path


MEASURED = {"kind": "measured", "file": "area.txt"}


def test_a_measured_surface_is_known_by_what_is_in_its_file(planned, tmp_path):
    heights_file(tmp_path / "area.txt")
    shutil.copy(tmp_path / "area.txt", tmp_path / "copy.txt")
    film = {"scene/surface": MEASURED, "scene/contact_law": None}
    one = planned(FILM, film)
    assert counts(one)["law"] == 1
    (law,) = one.of_kind("law")
    assert law.files == (str((tmp_path / "area.txt").resolve()),)
    assert str(tmp_path) not in str(law.spec)
    assert keys(planned(FILM, {**film, "scene/surface": {**MEASURED, "file": "copy.txt"}})) == keys(one)
    assert keys(planned(FILM, {**film, "scene/surface": {**MEASURED, "form": "curvature"}})) != keys(one)
    heights_file(tmp_path / "area.txt", seed=2)
    assert keys(planned(FILM, film)) != keys(one)


@pytest.mark.parametrize(
    ("changes", "parts"),
    [
        ({"file": "nowhere.txt"}, ["scene.surface.file", "nowhere.txt", "no such file"]),
        ({"file": "broken.di"}, ["scene.surface.file", "broken.di", "cannot be read"]),
        ({"file": "cut.nc"}, ["scene.surface.file", "cut.nc", "cannot be read"]),
        ({"file": "missing.txt"}, ["missing.txt", "1 of 576 points are missing", "missing: fill"]),
        ({"file": "infinite.txt"}, ["infinite.txt", "points are missing"]),
        ({"file": "flat.txt"}, ["flat.txt", "all heights are equal"]),
        ({"channel": "phase"}, ["area.txt", "no channel 'phase'"]),
        ({"waviness_wavelength": 1e-7}, ["waviness wavelength"]),
        ({"form": "plane"}, ["scene.surface.form", "tilt"]),
        ({"tapered_fraction": 2}, ["tapered_fraction", "at most 1"]),
    ],
    ids=lambda part: str(part)[:30],
)
def test_a_measured_surface_that_cannot_be_used_is_refused_by_name(message, tmp_path, changes, parts):
    heights_file(tmp_path / "area.txt")
    heights_file(tmp_path / "missing.txt", bad=np.nan)
    heights_file(tmp_path / "infinite.txt", bad=np.inf)
    np.savetxt(tmp_path / "flat.txt", np.ones((8, 8)), header="Width: 20 um\nHeight: 20 um\nValue units: um")
    (tmp_path / "broken.di").write_bytes(b"\\*File list\r\n" + bytes(100))
    (tmp_path / "cut.nc").write_bytes(b"CDF\x01" + bytes(40))
    for block in (CONTACT, FILM):
        contact = {"scene/contact_law": None} if block is FILM else {}
        text = message(block, {"scene/surface": {**MEASURED, **changes}, **contact})
        for part in parts:
            assert part in text


@pytest.mark.parametrize(
    ("changes", "parts"),
    [
        ({"scene/surface/cutoff": 6e4}, ["cutoff", "rolloff"]),
        ({"scene/surface/long_cutoff": 1e5}, ["long_cutoff", "rolloff"]),
        ({"scene/surface/cutoff": 1.0067e6}, ["Nyquist", "more than 0.1%"]),
        ({"scene/surface/hurst": 0}, ["scene.surface.hurst", "above 0 and at most 1"]),
        ({"scene/surface/hurst": 1.01}, ["scene.surface.hurst"]),
        ({"scene/surface/points": 1}, ["scene.surface.points", "at least 2"]),
        ({"scene/surface/points": 12.5}, ["scene.surface.points", "whole number"]),
        ({"scene/surface/points": None}, ["surface.points"]),
        ({"scene/surface/size": None}, ["surface.size"]),
        ({"scene/surface/realisations": 0}, ["scene.surface.realisations", "at least 1"]),
        ({"scene/surface": "smooth"}, ["scene.surface", "self_affine, measured"]),
        ({"scene/boundary": "open"}, ["scene.boundary", "periodic, free"]),
        ({"grid/normalised_pressure": [-0.1]}, ["grid.normalised_pressure", "above 0"]),
        ({"grid/pressure": ["1 MPa"]}, ["grid.pressure", "scene.body.material"]),
        ({"grid/pressure": [1.0], "grid/normalised_pressure": [0.1]}, ["pressures are given twice"]),
        ({"grid/speed": [1.0]}, ["grid.speed", "unknown key"]),
        ({"solver": "spectral"}, ["solver", "conjugate_gradients, polonsky_keer"]),
        ({"solver": "polonsky_keer", "grid/solver": ["polonsky_keer"]}, ["solver is given twice"]),
        ({"grid/solver": ["polonsky_keer", "polonsky_keer"]}, ["polonsky_keer twice"]),
        ({"figures": ["stribeck"]}, ["stribeck", "of this kind: "]),
        ({"outputs": ["friction"]}, ["outputs", "maps"]),
        ({"kind": "rough_contakt"}, ["kind", "did you mean rough_contact?"]),
        ({"kind": "benchmark"}, ["kind", "not yet built"]),
    ],
    ids=lambda part: str(part)[:40],
)
def test_a_mistake_gets_one_clear_message(message, changes, parts):
    text = message(CONTACT, changes)
    for part in parts:
        assert part in text


def test_a_cutoff_that_was_rounded_is_taken(planned):
    nyquist = math.pi * 128 / 4e-4
    assert counts(planned(CONTACT, {"scene/surface/cutoff": nyquist * 1.0009}))["law"] == 1


def test_what_a_film_needs_of_its_surface_is_said(message):
    assert "surface.size" in message(FILM, {"scene/surface/size": None})
    text = message(FILM, {"scene/contact_law": "persson", "grid/scene.surface.points": [128, 256]})
    assert "no contact_law of the study makes any" in text


def test_a_measured_surface_has_no_spectrum_for_an_analytic_law(message, tmp_path):
    heights_file(tmp_path / "area.txt")
    text = message(FILM, {"scene/surface": MEASURED, "scene/contact_law": "persson"})
    assert "needs a spectrum" in text


def test_a_size_that_will_not_fit_is_refused_with_the_estimate(message, monkeypatch):
    from softlub.study import contact_checks

    monkeypatch.setattr(contact_checks, "machine_memory", lambda: 1e9)
    text = message(CONTACT, {"scene/surface/points": 8192}, accuracy="source")
    assert "scene.surface.points = 8192" in text
    assert "this machine has 1.0 GB" in text


def test_a_study_of_nothing_is_refused(message):
    assert "holds nothing" in message({"kind": "surface", "scene": {}}, {})


def test_an_even_number_of_points_has_none_on_the_axis(message):
    block = yaml.safe_load((ROOT / "config" / "studies" / "ch4-dcfft.yaml").read_text())
    assert "no point would lie on the axis" in message(block, {"grid/points": 128})
