"""Jobs of finite-element bodies: what they write when all goes well, and when a body meets its limit."""

from __future__ import annotations

import numpy as np
import pytest

from softlub.datasets import store
from softlub.references.half_plane import surface_displacement
from softlub.references.hertz_line import HertzLineContact
from softlub.solid.body import Body
from softlub.solid.history import Failure, History, StepEnd
from softlub.solid.reduced_stiffness import ReducedStiffness
from softlub.stages import (
    equivalence_fit,
    equivalence_study,
    reduced_stiffness,
    solid_bodies,
    solid_state,
    solid_study,
    solid_tables,
)

SOFT = {"kind": "neo_hookean", "c10": 0.6e6, "d1": 1e-9}
BODY = {
    "shape": {"kind": "triangle"},
    "material": SOFT,
    "element": "mean_dilatation",
    "mesh": {"edge_nodes": 33, "rows": 6, "flank_columns": 10, "first_height": None},
}
HARD = {"name": "hard", "penalty": 1e13}
IN_CONTACT = {"name": "in_contact", "overlap": 2e-6}


def made(tmp_path, stage, spec, **inputs):
    path = tmp_path / "made.nc"
    stage.run(spec, inputs, [path])
    return store.read(path)


def steps(load):
    return [IN_CONTACT, {"name": "loading", "load": load}]


def test_a_state_records_every_increment_and_its_end(tmp_path):
    state = made(tmp_path, solid_state, {"body": BODY, "contact": HARD, "steps": steps(17.0)})
    assert list(state["step"].values) == ["in-contact", "loading"]
    assert list(state["step_number"].values) == [0, 1]
    assert int(state["completed"]) == 1
    assert str(state["stop_reason"].item()) == ""
    force = state["nodal_force"].sum("node")
    np.testing.assert_allclose(force.sel(component="y"), state["applied_load"], rtol=1e-9)
    edge = state["mesh_displacement"].values[state["mesh_edge"].values]
    np.testing.assert_array_equal(edge, state["displacement"].isel(increment=-1))
    assert state["stress_von_mises"].min() > 0


def test_a_body_that_meets_its_limit_keeps_what_it_reached(tmp_path):
    state = made(tmp_path, solid_state, {"body": BODY, "contact": HARD, "steps": steps(1e5)})
    assert int(state["completed"]) == 0
    assert "step loading stopped" in str(state["stop_reason"].item())
    assert 0 < state["applied_load"].values[-1] < 1e5
    end = solid_tables.final(state, [])
    assert not bool(end["converged"])
    assert bool(np.isfinite(end["displacement"]).all())


def test_a_contact_wider_than_its_edge_is_told_of(tmp_path):
    narrow = {
        **BODY,
        "shape": {"kind": "triangle", "edge_width": 0.05e-3},
        "mesh": {**BODY["mesh"], "rows": 12},
    }
    for body, beyond in ((BODY, 0), (narrow, 1)):
        state = made(tmp_path, solid_state, {"body": body, "contact": HARD, "steps": steps(17.0)})
        assert int(state["completed"]) == 1
        assert int(solid_tables.final(state, [])["reaches_edge_end"]) == beyond


def test_a_body_that_never_starts_has_no_displacement_to_tell(tmp_path):
    body = solid_bodies.make_body(BODY)
    nowhere = StepEnd("in-contact", 0.0, np.zeros_like(body.mesh.points))
    history = History((), (nowhere,), Failure("in-contact", 1, 0.0, "too hard"), 7, 30)
    state = solid_state.state(body, history).assign(solver_seconds=1.0)
    end = solid_tables.final(state, ["history"])
    assert bool(np.isnan(end["displacement"]).all())
    assert int(end["increments"]) == 0
    assert int(end["reaches_edge_end"]) == 0
    study = {"compare": ["reduced"], "datum": [], "keep": [], "load": [1.0], "sweeps": []}
    stiffness = made(tmp_path, reduced_stiffness, {"body": BODY})
    store.write(stiffness, tmp_path / "stiffness.nc")
    store.write(state, tmp_path / "state.nc")
    spec = {**study, "states": [[0]], "stiffnesses": [0], "penalties": [1e13], "materials": [SOFT]}
    whole = made(
        tmp_path, solid_study, spec, state=[tmp_path / "state.nc"], stiffness=[tmp_path / "stiffness.nc"]
    )
    assert bool(np.isnan(whole["displacement_error"]).all())


def test_a_fit_without_a_shape_to_fit_says_why(tmp_path):
    timed = {"duration": 1e-3, "increments": 2}
    relaxing = {
        "kind": "viscoelastic",
        "hyperelastic": SOFT,
        "prony": {"normalised": "long_term", "times": [1e-3], "terms": [0.5]},
    }
    lost = [{**step, **timed} for step in steps(1e5)]
    spec = {"body": {**BODY, "material": relaxing}, "contact": HARD, "steps": lost}
    store.write(made(tmp_path, solid_state, spec), tmp_path / "state.nc")
    fit = {"body": BODY, "contact": HARD, "steps": steps(17.0), "bounds": [0.5, 5.0]}
    found = made(tmp_path, equivalence_fit, fit, state=[tmp_path / "state.nc"])
    assert np.isnan(found["coefficient"])
    assert int(found["fit_converged"]) == 0
    assert "step" in str(found["stop_reason"].item())
    store.write(found, tmp_path / "fit.nc")
    stiffness = made(tmp_path, reduced_stiffness, {"body": BODY}, equivalence=[tmp_path / "fit.nc"])
    store.write(stiffness, tmp_path / "stiffness.nc")
    row = {"viscoelastic": 0, "fitted": 0, "given": [], "stiffness_fitted": 0, "stiffness_given": []}
    spec = {"rows": [[row]], "coefficients": [], "keep": [], "load": [17.0], "sweeps": []}
    kinds = {"state": "state.nc", "equivalence": "fit.nc", "stiffness": "stiffness.nc"}
    whole = made(
        tmp_path, equivalence_study, spec, **{kind: [tmp_path / name] for kind, name in kinds.items()}
    )
    assert bool(np.isnan(whole["shape_difference"]).all())


def test_a_kept_constraint_stiffens_the_apex_alone():
    body = Body(solid_bodies.make_mesh(BODY), solid_bodies.make_material(SOFT))
    reduced = ReducedStiffness.of(body)
    apex = int(np.argmin(reduced.base_gap))
    added = solid_study.constrained(reduced, 1e13).stiffness - reduced.stiffness
    assert added[2 * apex + 1, 2 * apex + 1] == pytest.approx(1e13 * reduced.widths[apex], rel=1e-9)
    assert np.count_nonzero(added) == 1


def test_a_frequency_stiffens_and_an_instantaneous_material_is_taken_at_rest(tmp_path):
    relaxing = {
        "kind": "viscoelastic",
        "hyperelastic": SOFT,
        "prony": {"normalised": "long_term", "times": [1e-3], "terms": [1.0]},
    }

    def stiffness(material, **further):
        spec = {"body": {**BODY, "material": material}, **further}
        return made(tmp_path, reduced_stiffness, spec)["stiffness"].values

    rest = stiffness(SOFT)
    np.testing.assert_allclose(stiffness(relaxing), rest, rtol=1e-9)
    # Far above the one relaxation frequency, G is doubled and K as it was.
    fast = stiffness({**SOFT, "c10": 1.2e6})
    np.testing.assert_allclose(stiffness(relaxing, frequency=1e7), fast, rtol=1e-6, atol=1e-6 * fast.max())
    halved = stiffness({**relaxing, "constants": "instantaneous"})
    soft = stiffness({**SOFT, "c10": 0.3e6})
    np.testing.assert_allclose(halved, soft, rtol=1e-9, atol=1e-9 * soft.max())


def test_the_half_plane_takes_the_parabola_of_hertz():
    contact = HertzLineContact(radius=0.01, modulus=1e7 / 0.75, load=100.0)
    a = contact.half_width
    ends = np.linspace(-a, a, 2001)
    middles = (ends[1:] + ends[:-1]) / 2
    pressure = contact.pressure(middles)
    x = np.linspace(-0.8, 0.8, 33) * a
    moved = surface_displacement(ends, pressure, np.zeros_like(pressure), 1e7, 0.5, 1e-3, x)
    np.testing.assert_allclose(moved[:, 1] - moved[16, 1], -(x**2) / (2 * 0.01), atol=1e-4 * a**2 / 0.01)
    # Incompressible: pressure moves nothing along the surface. Shear does what pressure does, turned by a right angle.
    np.testing.assert_allclose(moved[:, 0], 0, atol=1e-12 * moved[16, 1])
    sheared = surface_displacement(ends, np.zeros_like(pressure), pressure, 1e7, 0.5, 1e-3, x)
    np.testing.assert_allclose(sheared[:, 0], moved[:, 1], rtol=1e-12)


def test_the_half_plane_lies_at_zero_at_its_datum_and_follows_poisson():
    ends, one = np.array([-1e-6, 1e-6]), np.ones(1)
    far = surface_displacement(ends, one, 0 * one, 1.0, 0.3, 0.1, np.array([-0.1, 0.1]))
    np.testing.assert_allclose(far[:, 1], 0, atol=1e-12)
    # A line load draws the surface towards itself: (1 - 2 nu)(1 + nu)/(2E) P on either side.
    np.testing.assert_allclose(far[:, 0], [0.26 * 2e-6, -0.26 * 2e-6], rtol=1e-9)


def test_an_asperity_law_is_that_of_the_body_at_rest():
    surface = {"kind": "self_affine", "rms_roughness": 1e-6, "hurst": 0.8, "rolloff": 1e5, "cutoff": 1e8}
    surface["long_cutoff"] = None
    contact = {"name": "persson", "gamma": 1.0, "pressure_factor": 1.0, "surface": surface}
    law = solid_bodies.make_law({**contact, "material": SOFT}, ())
    stiffer = solid_bodies.make_law({**contact, "material": {**SOFT, "c10": 1.2e6}}, ())
    gap = np.array([1e-6, 2e-6])
    pressure, stiffness = law.pressure_and_stiffness(gap)
    assert pressure[0] > pressure[1] > 0
    assert stiffness.min() > 0
    ratio = stiffer.pressure_and_stiffness(gap)[0] / pressure
    np.testing.assert_allclose(ratio, 2, rtol=1e-2)
