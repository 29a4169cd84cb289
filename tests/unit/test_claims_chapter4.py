"""Chapter 4's claims: every row judged, verdicts that follow the data, and tables beside the source's."""

import csv
import io
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
from synthetic_contact import deflections, maps, synthesis, table, validation

from softlub.claims import chapter4_theory, surface_table
from softlub.claims.caption import caption
from softlub.claims.chapter4 import SURFACE
from softlub.claims.evaluate import evaluate
from softlub.claims.printed_surfaces import PRINTED, find, rows
from softlub.claims.table import read_claims, studies_of
from softlub.contact.laws.persson import PerssonLaw
from softlub.pressure_table import evaluate as at

ROOT = Path(__file__).parents[2]
CLAIMS = [claim for claim in read_claims(ROOT / "config" / "claims.csv") if claim.chapter in (4, 8)]
HURST = [2.7, 2.5, 2.3, 2.1]


def studies(**changes):
    """All of chapter 4 as it should come out if the source were right, but for what is changed."""
    whole = {
        "ch4-continuum": table("table_4_2", pixel_excess=0.0),
        "ch4-thermodynamic": table("table_4_3", kurtosis=[2.5, 2.8, 2.95], pixel_excess=0.0),
        "ch4-fractal": table("table_4_4", kappa=[2.62, 2.4, 2.2, 2.08], pixel_excess=0.0),
        "ch4-hurst": table("table_4_5", kappa=HURST, gap=[1.3, 1.2, 1.1, 1.0]),
        "ch4-synthesis": synthesis(),
        "ch4-dcfft": deflections(),
        "ch4-maps": maps(),
        "ch4-validation": validation(),
        "ch4-patch": validation().isel(solver=0),
        "ch4-benchmarks": validation().isel(boundary=0),
    }
    return whole | {name.replace("_", "-"): dataset for name, dataset in changes.items()}


WHOLE = studies()


def verdict(row, **changes):
    (claim,) = (claim for claim in CLAIMS if claim.id == row)
    named = WHOLE | {name.replace("_", "-"): dataset for name, dataset in changes.items()}
    return evaluate([claim], named.get)[0].verdict


@pytest.fixture(scope="module")
def without_data():
    return evaluate(CLAIMS, lambda study: None)


def test_every_row_has_a_check_and_a_reason(without_data):
    assert len(without_data) == 97
    assert [j.claim.id for j in without_data if j.verdict.verdict == "missing"] == []
    assert all(j.verdict.reason for j in without_data)


def test_without_datasets_only_closed_forms_decide(without_data):
    decided = {j.claim.id for j in without_data if j.verdict.verdict == "reproduced"}
    assert decided == {
        *("eq_4_15", "eq_4_23", "eq_4_47", "claim_4_04", "claim_4_06", "claim_4_28", "claim_8_04"),
    }


def test_misprints_of_equations_are_found_by_computing(without_data):
    misprints = [
        "eq_4_4_unit",
        "eq_4_5",
        "eq_4_5_qL",
        "eq_4_6",
        "eq_4_7",
        "eq_4_zeta",
        "eq_4_13",
        "eq_4_14",
        "eq_4_18",
        "eq_4_21",
        "eq_4_22",
        "eq_4_24",
        "eq_4_26",
        "eq_4_29",
        "eq_4_35",
        "eq_4_46",
        "eq_4_tfc",
        "eq_4_qL_ratio",
    ]
    verdicts = {j.claim.id: j.verdict for j in without_data}
    assert [row for row in misprints if verdicts[row].verdict != "differs"] == []
    assert [row for row in misprints if not verdicts[row].value] == ["eq_4_21"]


def test_rows_name_studies_that_exist_or_none():
    named = {name for claim in CLAIMS for name in studies_of(next(iter(claim.figures), ""), [claim])}
    known = set(WHOLE) | {"ch4-topography", "ch4-persson"}
    assert named <= known


def test_the_kernel_of_the_separation_is_that_of_the_law():
    """Right kernel of eq_4_22 against the law's own table, γ = 1 and 0.45."""
    scale = SURFACE.rolloff * SURFACE.rms_roughness
    for gamma in (1.0, 0.45):
        pressure = 0.005 * SURFACE.rms_slope / scale
        separation = chapter4_theory._separation(SURFACE, pressure, gamma, printed=False)
        law = PerssonLaw(SURFACE, 1.0, gamma=gamma).table
        found = at(law, np.array([separation * SURFACE.rms_roughness]))[0][0]
        assert found == pytest.approx(pressure * scale, rel=1e-3)


# tables


def test_printed_surfaces_agree_with_the_table_of_claims():
    for printed in PRINTED:
        (claim,) = (claim for claim in CLAIMS if claim.id == printed.row)
        height, slope = (float(value) for value in claim.value.split(";"))
        assert (height, slope) == (printed.rms_roughness, printed.rms_slope)


def test_a_surface_is_found_by_its_inputs_and_no_other():
    dataset = table("table_4_4")
    for printed in rows("table_4_4")[:4]:
        assert int(find(dataset, printed)["points"]) == printed.points
    assert find(dataset, rows("table_4_4")[4]) is None
    assert find(dataset, rows("table_4_5")[0]) is None


def test_tables_are_reproduced_within_the_tolerance_and_not_beyond():
    assert verdict("table_4_2_row_1").verdict == "reproduced"
    assert verdict("table_4_2_row_1", ch4_continuum=table("table_4_2", slope=1.11)).verdict == "reproduced"
    assert verdict("table_4_2_row_1", ch4_continuum=table("table_4_2", slope=1.13)).verdict == "differs"
    assert verdict("table_4_5_row_1", ch4_hurst=table("table_4_5", slope=0.75)).verdict == "reproduced"
    assert verdict("table_4_5_row_2", ch4_hurst=table("table_4_5", slope=0.75)).verdict == "differs"


def test_a_row_that_was_not_run_is_not_computed():
    ours = verdict("table_4_2_row_3")
    assert ours.verdict == "not computed"
    assert "4096" in ours.reason


def test_the_misprinted_height_differs_by_ten():
    ours = verdict("table_4_3_row_3", ch4_thermodynamic=table("table_4_3", roughness=9.63e-7))
    assert ours.verdict == "differs"
    assert "0.1 times" in ours.reason


def test_the_misprinted_wavelength_is_named():
    assert "6.25e-07 m" in verdict("table_4_4_row_1").reason


def test_table_beside_the_source():
    read = list(csv.DictReader(io.StringIO(surface_table.text("table_4_2", WHOLE["ch4-continuum"]))))
    assert [row["state"] for row in read] == ["run", "run", surface_table.NOT_RUN, surface_table.NOT_RUN]
    assert [float(row["rms_slope_printed [1]"]) for row in read] == [0.2066, 0.2071, 0.2079, 0.2085]
    assert float(read[0]["kappa_corrected_area [1]"]) == pytest.approx(2.08, abs=0.02)
    assert float(read[0]["rms_slope_spectral [1]"]) == pytest.approx(1.1 * 0.2066, rel=1e-5)
    assert read[2]["rms_roughness [m]"] == ""
    assert float(read[2]["rms_roughness_printed [m]"]) == 9.63e-7


def test_a_table_without_enough_loads_says_so():
    failed = table("table_4_2", 1024)
    failed["converged"][:] = False
    (row, *_) = csv.DictReader(io.StringIO(surface_table.text("table_4_2", failed)))
    assert row["state"].startswith("run; no kappa")
    assert row["kappa_corrected_area [1]"] == ""


def test_every_printed_table_is_written_beside_its_study(tmp_path):
    from softlub.claims.printed_tables import STUDIES, tables_of
    from softlub.datasets import store
    from softlub.stages.surface_table import run

    assert {printed.row.partition("_row")[0] for printed in PRINTED} == set(STUDIES)
    assert tables_of("ch4-continuum") == ("table_4_1", "table_4_2")
    store.write(WHOLE["ch4-hurst"], tmp_path / "ch4-hurst.nc")
    path = tmp_path / "tables" / "table_4_5.csv"
    run({"table": "table_4_5"}, {"study": [tmp_path / "ch4-hurst.nc"]}, [path])
    assert path.read_text() == surface_table.text("table_4_5", WHOLE["ch4-hurst"])


def test_an_unknown_table_is_refused():
    with pytest.raises(ValueError, match="table_9_9"):
        surface_table.text("table_9_9", WHOLE["ch4-continuum"])


# verdicts follow the data

AS_THE_SOURCE_HAS_IT = [
    "claim_4_02",
    "claim_4_03",
    "claim_4_05",
    "claim_4_08",
    "claim_4_09",
    "claim_4_10",
    "claim_4_11",
    "claim_4_12",
    "claim_4_13",
    "claim_4_16",
    "claim_4_17",
    "claim_4_18",
    "claim_4_19",
    "claim_4_20",
    "claim_4_22",
    "claim_4_25",
    "claim_4_26",
    "claim_4_27",
    "claim_4_29",
    "claim_4_30",
    "claim_4_31",
    "claim_4_32",
    "claim_4_33",
    "claim_4_34",
    "claim_8_05",
    "claim_8_07",
]


@pytest.mark.parametrize("row", AS_THE_SOURCE_HAS_IT)
def test_statements_hold_where_the_data_say_so(row):
    ours = verdict(row)
    assert ours.verdict == "reproduced", ours


def rougher_spectrum():
    return table("table_4_2", gap=[1.0, 1.4])


CONTRADICTIONS = {
    "claim_4_02": {"ch4_synthesis": synthesis(tilt=0.0)},
    "claim_4_03": {"ch4_synthesis": synthesis().assign(rms_roughness=("wavevectors", [2e-6, 2e-6]))},
    "claim_4_05": {"ch4_continuum": table("table_4_2", kappa=1.5)},
    "claim_4_08": {"ch4_dcfft": deflections(seconds=(0.2, 0.06))},
    "claim_4_09": {"ch4_dcfft": deflections(1e-6)},
    "claim_4_11": {"ch4_dcfft": deflections(0.05)},
    "claim_4_10": {"ch4_benchmarks": validation(iterations=420).isel(boundary=0)},
    "claim_4_12": {"ch4_patch": validation(difference=0.1).isel(solver=0)},
    "claim_4_13": {"ch4_maps": maps().assign(gap=maps()["gap"].isel(load_step=slice(None, None, -1)))},
    "claim_4_16": {"ch4_continuum": table("table_4_2", kappa=1.9)},
    "claim_4_17": {"ch4_continuum": table("table_4_2")},
    "claim_4_18": {"ch4_continuum": table("table_4_2", pixel_excess=0.3)},
    "claim_4_19": {"ch4_continuum": rougher_spectrum()},
    "claim_4_20": {"ch4_thermodynamic": table("table_4_3", kurtosis=[2.9, 2.9, 2.9])},
    "claim_4_22": {"ch4_thermodynamic": table("table_4_3", kappa=[2.1, 2.4, 2.5])},
    "claim_4_25": {"ch4_fractal": table("table_4_4", kappa=2.1)},
    "claim_4_26": {"ch4_fractal": table("table_4_4", kappa=2.1)},
    "claim_4_27": {"ch4_fractal": table("table_4_4", gap=[1.0, 1.0, 1.0, 1.2])},
    "claim_4_29": {"ch4_hurst": table("table_4_5", kappa=2.1)},
    "claim_4_30": {"ch4_hurst": table("table_4_5", kappa=HURST[::-1])},
    "claim_4_31": {"ch4_hurst": table("table_4_5", gap=[0.5, 0.6, 0.7, 0.8])},
    "claim_4_32": {"ch4_thermodynamic": table("table_4_3", kappa=[2.1, 2.8, 3.4])},
    "claim_4_33": {"ch4_continuum": rougher_spectrum()},
    "claim_4_34": {"ch4_thermodynamic": table("table_4_3", kurtosis=3.5)},
    "claim_8_05": {"ch4_continuum": table("table_4_2")},
    "claim_8_07": {"ch4_hurst": table("table_4_5", kappa=2.1)},
}


@pytest.mark.parametrize("row", CONTRADICTIONS)
def test_statements_fall_where_the_data_contradict(row):
    ours = verdict(row, **CONTRADICTIONS[row])
    assert ours.verdict == "differs", ours


def test_every_statement_that_can_hold_can_fall():
    assert set(CONTRADICTIONS) == set(AS_THE_SOURCE_HAS_IT)


def test_size_without_a_plateau():
    """Surfaces of L/λ_L = 2 and 8 without a plateau, that stay as far from Gauss or not."""
    (row,) = (row for row in rows("table_4_3") if row.points == 512)
    large = row._replace(size=8e-4, points=2048)
    from synthetic_contact import surface, with_axes

    def pair(kurtosis):
        return xr.concat(
            [with_axes(surface(row, kurtosis=2.5)), with_axes(surface(large, kurtosis=kurtosis))],
            dim="surface",
            join="outer",
        )

    assert verdict("claim_4_21", ch4_thermodynamic=pair(2.5)).verdict == "reproduced"
    assert verdict("claim_4_21", ch4_thermodynamic=pair(2.95)).verdict == "differs"


def test_logarithmic_law():
    """A gap that bends over under light loads, the less the wider the plateau; then one that never bends."""
    bent = table("table_4_3")
    for index, strength in enumerate((1.0, 0.5, 0.1)):
        pressure = bent["reduced_pressure"][index]
        logarithm = np.log(0.1 / pressure)
        gap = 0.5 * (logarithm - 0.04 * strength * logarithm**2)
        bent["mean_separation"][index] = (bent["rms_roughness"][index] * gap).values
    assert verdict("claim_4_24", ch4_thermodynamic=bent).verdict == "reproduced"
    straight = bent.copy(deep=True)
    straight["mean_separation"][:] = (
        bent["rms_roughness"] * 0.5 * np.log(0.1 / bent["reduced_pressure"])
    ).values
    assert verdict("claim_4_24", ch4_thermodynamic=straight).verdict == "differs"


def test_gap_under_light_loads():
    assert verdict("claim_4_23").verdict == "differs"
    wide = table("table_4_3", gap=[1.0, 1.1, 1.2])
    assert verdict("claim_4_23", ch4_thermodynamic=wide).verdict == "reproduced"


def test_thresholds():
    assert verdict("claim_4_15", ch4_validation=validation(below=(1.0, 1.01))).verdict == "reproduced"
    assert verdict("claim_4_15", ch4_validation=validation(below=(0.4, 1.0))).verdict == "differs"


def test_two_solvers_are_compared_where_the_third_is_not_at_hand():
    ours = verdict("claim_4_14", ch4_validation=validation(difference=1e-3))
    assert ours.verdict == "not decidable"
    assert "1e-03 h_rms" in ours.value


def test_kappa_states_its_window_slopes_and_estimator():
    for row in ("claim_4_05", "claim_4_16", "claim_4_22", "claim_4_25", "claim_4_26", "claim_4_29"):
        reason = verdict(row).reason
        assert "up to A/A0 = 0.2" in reason
        assert "spectral h'rms" in reason
        assert "local slope" in reason
        assert "forward-difference h'rms" in reason


def test_a_table_of_one_surface_decides_nothing_about_grids():
    assert verdict("claim_4_17", ch4_continuum=table("table_4_2", 1024)).verdict == "not computed"


def test_caption_holds_the_numbers_and_the_verdicts():
    text = caption("fig_4_12", "Contact.", WHOLE["ch4-continuum"], CLAIMS, WHOLE.get)
    assert "line 1709" in text
    assert verdict("claim_4_16").value[1:] in text
    assert "**Reproduced.**" in text
