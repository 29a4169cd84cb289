"""Chapter 5's claims: every row judged, and verdicts that follow the data."""

from pathlib import Path

import pytest
import yaml
from synthetic_solid import (
    constraint,
    elements,
    equivalence,
    half_cylinder,
    hyperelastic,
    linear,
    mesh,
    moduli,
)

from softlub.claims.caption import caption
from softlub.claims.chapter5_materials import L_H, Y_H
from softlub.claims.evaluate import evaluate
from softlub.claims.table import read_claims, studies_of

ROOT = Path(__file__).parents[2]
CLAIMS = [claim for claim in read_claims(ROOT / "config" / "claims.csv") if claim.chapter == 5]
WHOLE = {
    "ch5-half-cylinder": half_cylinder(),
    "ch5-linear": linear(),
    "ch5-hyperelastic": hyperelastic(),
    "ch5-elements": elements(),
    "ch5-mesh": mesh(),
    "ch5-constraint": constraint(),
    "ch5-moduli": moduli(),
    "ch5-equivalence": equivalence(),
}


def verdict(row, **changes):
    (claim,) = (claim for claim in CLAIMS if claim.id == row)
    named = WHOLE | {name.replace("_", "-"): dataset for name, dataset in changes.items()}
    return evaluate([claim], named.get)[0].verdict


@pytest.fixture(scope="module")
def without_data():
    return evaluate(CLAIMS, lambda study: None)


@pytest.fixture(scope="module")
def with_data():
    return {judgement.claim.id: judgement.verdict for judgement in evaluate(CLAIMS, WHOLE.get)}


def test_every_row_has_a_check_and_a_reason(without_data, with_data):
    assert len(without_data) == 52
    assert [j.claim.id for j in without_data if j.verdict.verdict == "missing"] == []
    assert all(j.verdict.reason for j in without_data)
    assert all(one.reason for one in with_data.values())


def test_without_datasets_only_closed_forms_decide(without_data):
    decided = {j.claim.id for j in without_data if j.verdict.verdict == "reproduced"}
    assert decided == {"table_5_1_row_1", "table_5_1_row_2", "eq_5_6", "eq_5_10", "claim_5_15"}


def test_misprints_of_equations_are_found_by_computing(without_data):
    misprints = ["eq_5_4", "eq_5_maxwell", "eq_5_16", "eq_5_18", "eq_5_alpha"]
    verdicts = {j.claim.id: j.verdict for j in without_data}
    assert [row for row in misprints if verdicts[row].verdict != "differs"] == []
    assert all(verdicts[row].value for row in misprints)


def test_with_all_datasets_only_sketches_are_not_computed(with_data):
    left = {row for row, one in with_data.items() if one.verdict == "not computed"}
    assert left == {"fig_5_2", "fig_5_3", "fig_5_6", "fig_5_11"}


def test_rows_name_studies_that_are_shipped():
    named = {name for claim in CLAIMS for name in claim.study.split("; ") if name}
    shipped = {path.stem for path in (ROOT / "config" / "studies").glob("ch5-*.yaml")}
    assert named <= shipped


def test_captions_read_the_studies_of_their_rows():
    assert studies_of("fig_5_9", CLAIMS) == ("ch5-mesh",)


def test_constants_are_those_of_the_shipped_materials():
    for name, material in (("L_H", L_H), ("Y_H", Y_H)):
        block = yaml.safe_load((ROOT / "config" / "materials" / f"{name}.yaml").read_text(encoding="utf-8"))
        assert float(block["c10"].split()[0]) * 1e6 == pytest.approx(material.c10)
        assert float(block["d1"].split()[0]) / 1e6 == pytest.approx(material.d1)


# the reduced stiffness against finite elements


def test_the_half_space_is_decided_only_if_no_datum_matters():
    assert verdict("claim_5_01").verdict == "not decidable"
    short = half_cylinder(half_space=0.5, datums=(1e-2, 2e-2))
    assert verdict("claim_5_01", ch5_half_cylinder=short).verdict == "reproduced"
    far = half_cylinder(half_space=2.0, datums=(1e-2, 2e-2))
    assert verdict("claim_5_01", ch5_half_cylinder=far).verdict == "differs"


def test_a_load_that_was_not_reached_is_passed_over():
    dataset = half_cylinder()
    dataset["converged"].loc[{"load": 6000.0}] = False
    assert "0.0014 mm" in verdict("claim_5_01", ch5_half_cylinder=dataset).value
    dataset["converged"].loc[{"load": 100.0}] = False
    assert verdict("claim_5_01", ch5_half_cylinder=dataset).verdict == "not computed"


def test_the_lateral_difference_counts_by_itself():
    assert verdict("claim_5_03").verdict == "differs"
    assert "lateral 11 %" in verdict("claim_5_03").value
    assert verdict("claim_5_03", ch5_linear=linear(laterals=(0.015, 0.01))).verdict == "reproduced"
    assert verdict("claim_5_05").verdict == "reproduced"
    assert verdict("claim_5_05", ch5_linear=linear(errors=(0.01, 0.03))).verdict == "differs"


def test_friction_matters_if_one_of_both_is_off():
    assert verdict("claim_5_04").verdict == "reproduced"
    assert verdict("claim_5_04", ch5_linear=linear(errors=(0.01, 0.03))).verdict == "differs"
    one = linear().isel(friction=[1])
    assert verdict("claim_5_04", ch5_linear=one).verdict == "not computed"


def test_the_linear_body_is_compared_as_it_is_and_strictly_linear():
    assert verdict("claim_5_07").verdict == "reproduced"
    assert verdict("claim_5_07").value.startswith("0 % of the largest displacement; 0.93 %")
    assert verdict("claim_5_07", ch5_hyperelastic=hyperelastic(linear_size=1.03)).verdict == "differs"


def test_the_half_space_gets_the_constants_that_fit_best():
    assert verdict("claim_5_08").verdict == "reproduced"
    exact = hyperelastic(half_space=1.0)
    exact["displacement_half_space"] = (
        exact["displacement"].sel({"method": "full"}, drop=True) + 1e-5 * exact["datum"]
    )
    assert verdict("claim_5_08", ch5_hyperelastic=exact).verdict == "differs"


def test_a_constraint_spoils_what_it_changes():
    assert verdict("claim_5_13").verdict == "reproduced"
    assert verdict("claim_5_13", ch5_constraint=constraint(constrained=0.02)).verdict == "differs"
    assert verdict("claim_5_13", ch5_constraint=linear().isel(friction=1)).verdict == "not computed"


def test_a_body_that_stopped_early_decides_nothing():
    dataset = hyperelastic().isel(load=0)
    dataset["converged"][:] = False
    dataset["stop_reason"] = ("material", ["sliding, increment 4: no convergence"] * 2)
    found = verdict("claim_5_06", ch5_hyperelastic=dataset)
    assert found.verdict == "not computed"
    assert "increment 4" in found.reason


# the matrix


def test_elements_are_compared_by_entries_and_displacements():
    assert verdict("claim_5_09").verdict == "reproduced"
    assert verdict("claim_5_09", ch5_elements=elements(second=0.05)).verdict == "differs"
    changed = elements()
    changed["stiffness_diagonal"].loc[{"element": "reduced_integration"}] *= 1.3
    assert verdict("claim_5_09", ch5_elements=changed).verdict == "differs"


def test_entries_of_the_finer_mesh():
    assert verdict("claim_5_10").verdict == "differs"
    assert verdict("claim_5_10").value.startswith("at the apex 1.04 (vertical)")
    assert verdict("claim_5_10", ch5_mesh=mesh(diagonal=0.9)).verdict == "reproduced"


def test_displacements_are_compared_at_the_same_places():
    found = verdict("claim_5_11")
    assert found.verdict == "reproduced"
    assert verdict("claim_5_11", ch5_mesh=mesh(size=1.1)).verdict == "differs"


def test_costs_follow_the_times():
    assert verdict("claim_5_12").verdict == "reproduced"
    assert verdict("claim_5_12", ch5_mesh=mesh(seconds=0.9)).verdict == "differs"
    assert verdict("claim_5_24").verdict == "reproduced"
    slow = mesh()
    slow["condensation_seconds"] = 10 * slow["condensation_seconds"]
    assert verdict("claim_5_24", ch5_mesh=slow).verdict == "differs"


def test_a_full_matrix_has_no_empty_entry():
    assert verdict("claim_5_02").verdict == "reproduced"
    holes = mesh()
    holes["stiffness_apex_row"][0, 3] = 0.0
    assert verdict("claim_5_02", ch5_mesh=holes).verdict == "differs"


# materials


def test_the_ends_of_the_moduli_are_looked_at():
    assert verdict("claim_5_14").verdict == "reproduced"
    short = moduli().isel(frequency=slice(0, 60))
    assert verdict("claim_5_14", ch5_moduli=short).verdict == "differs"


@pytest.mark.parametrize("row", ["claim_5_16", "claim_5_17", "claim_5_18"])
def test_what_the_series_was_made_for_is_no_verdict(row):
    found = verdict(row)
    assert found.verdict == "not decidable"
    assert found.value
    assert "synthetic" in found.reason


def test_a_frequency_must_stiffen_the_matrix():
    assert verdict("claim_5_19").verdict == "reproduced"
    assert verdict("claim_5_19", ch5_moduli=moduli(stiffened=False)).verdict == "differs"


# equivalents


def test_equivalents_are_judged_by_the_slowest_steps():
    assert verdict("claim_5_20").verdict == "differs"
    assert "fitted alpha 1 (1 s), 2.1 (1 µs)" in verdict("claim_5_20").value
    close = equivalence(source=(1e-4, 0.5))
    assert verdict("claim_5_20", ch5_equivalence=close).verdict == "reproduced"
    assert verdict("claim_5_22").verdict == "not decidable"
    assert "0.22 (1 µs)" in verdict("claim_5_22").value
    assert verdict("claim_5_23").verdict == "differs"
    assert verdict("claim_5_23", ch5_equivalence=equivalence(fitted=(1.3, 2.1))).verdict == "reproduced"
    assert verdict("claim_5_25").verdict == "differs"
    assert "fitted alpha 0.8 %" in verdict("claim_5_25").value
    assert verdict("claim_5_25", ch5_equivalence=equivalence(reduced=(0.05, 0.01))).verdict == "reproduced"


def test_the_bound_without_a_unit_decides_nothing():
    found = verdict("claim_5_21")
    assert found.verdict == "not decidable"
    assert "does not deform" in found.value


def test_a_fit_that_failed_decides_nothing():
    dataset = equivalence()
    dataset["coefficient"].loc[{"steps": "1 s", "model": "fitted"}] = float("nan")
    assert verdict("claim_5_23", ch5_equivalence=dataset).verdict == "not computed"


# captions


def test_a_caption_states_claim_and_numbers():
    text = caption("fig_5_4", "Displacement of the edge.", linear(), CLAIMS, WHOLE.get)
    assert "**Made up for ch5-linear.**" in text
    assert "**Differs.**" in text
    assert "lateral 11 %" in text
    assert "(claim_5_03, line 1911)" in text


def test_a_caption_counts_bodies_that_stopped_early():
    dataset = linear()
    dataset["converged"].loc[{"friction": 0.0}] = False
    assert "1 of 2 bodies did not get to the end of its steps" in caption("fig_5_4", "Edge.", dataset)
    assert "All 2 bodies got to the end of their steps" in caption("fig_5_4", "Edge.", linear())


def test_a_caption_tells_of_a_contact_wider_than_its_edge():
    dataset = linear()
    assert "contact edge" not in caption("fig_5_4", "Made up.", dataset)
    beyond = dataset.assign(reaches_edge_end=dataset["converged"].astype(int) * 0)
    assert "reaches an end" not in caption("fig_5_4", "Made up.", beyond)
    beyond["reaches_edge_end"].loc[{"friction": 0.4}] = 1
    assert "In 1 of 2 bodies the contact reaches an end" in caption("fig_5_4", "Made up.", beyond)
