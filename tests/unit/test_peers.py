"""The comparison with other projects' contact solvers, by our two solvers on a tiny grid; no peer is needed."""

import ast
import importlib
import sys
from pathlib import Path

import numpy as np
import pytest

from softlub.datasets import store
from softlub.figures.save import table

BENCHMARKS = Path(__file__).resolve().parents[2] / "benchmarks"
sys.path.insert(0, str(BENCHMARKS))
import contact_errors  # noqa: E402
import contact_solvers  # noqa: E402
import peer_solvers  # noqa: E402
import peers  # noqa: E402
import peers_area  # noqa: E402
import peers_drawing  # noqa: E402
import peers_fine  # noqa: E402
import peers_ratios  # noqa: E402
import peers_size  # noqa: E402
import peers_sweep  # noqa: E402

sys.path.remove(str(BENCHMARKS))
POINTS = 64


@pytest.fixture(scope="module")
def topography():
    return contact_errors.surface(POINTS)


@pytest.fixture(scope="module")
def joined(tmp_path_factory):
    solvers = contact_solvers.our_solvers()
    sizes = [peers_size.compare(solvers, contact_errors.surface(points)) for points in (POINTS, 2 * POINTS)]
    parts = [*sizes, peers_sweep.compare(solvers, POINTS, (0.5, 0.1, 0.02))]
    folder = tmp_path_factory.mktemp("parts")
    return stored(folder, peers.measure([stored(folder, part) for part in parts]))


def stored(folder, dataset):
    """What a job that follows finds of a dataset."""
    store.write(dataset, folder / "part.nc")
    return store.read(folder / "part.nc")


def test_the_surface_has_the_slope_that_normalises_the_loads(topography):
    points = topography.heights.shape[0]
    waves = np.fft.rfft2(topography.heights)
    frequency = (
        2 * np.pi * np.hypot(np.fft.fftfreq(points, 1 / points)[:, None], np.fft.rfftfreq(points, 1 / points))
    )
    slopes = np.stack([frequency * waves.real, frequency * waves.imag])
    weights = np.where(np.arange(waves.shape[1]) % (points // 2) == 0, 1, 2)
    assert np.sqrt((weights * slopes**2).sum()) / points**2 == pytest.approx(1)


@pytest.mark.parametrize("waves", [1, 3])
def test_the_gap_under_a_wave_of_pressure_is_that_of_the_half_space(waves):
    x = np.arange(POINTS) / POINTS
    wave = np.cos(2 * np.pi * waves * x)[:, None] * np.ones(POINTS)
    # u = 2 p / (E* |q|), E* = 1; the mean over the load vanishes by convention
    amplitude = 2 / (2 * np.pi * waves)
    gap = contact_errors.gap_of(np.zeros((POINTS, POINTS)), 1 + wave)
    np.testing.assert_allclose(gap - gap.mean(), amplitude * wave, atol=1e-14)
    assert np.sum(gap * (1 + wave)) == pytest.approx(0, abs=1e-10)


def test_errors_are_those_put_in(topography):
    pressure = np.full(topography.heights.shape, 2.0)
    reference = contact_errors.Reference.of(topography.heights, pressure)
    assert reference.errors(pressure) == (0, 0)
    x = np.arange(POINTS) / POINTS
    small = 1e-6
    area, gap = reference.errors(pressure + small * np.cos(2 * np.pi * 4 * x))
    assert area == 0
    amplitude = 2 * small / (2 * np.pi * 4)
    assert gap == pytest.approx(amplitude / np.sqrt(2) / topography.heights.std(), rel=1e-3)
    pressure[:2, :3] = 0
    assert reference.errors(pressure)[0] == pytest.approx(6 / POINTS**2)


def test_the_finest_surface_holds_waves_of_two_points():
    heights = contact_errors.surface(POINTS, shortest_wave=2).heights
    waves = np.abs(np.fft.rfft2(heights))
    assert waves[0, POINTS // 2 - 1] > 0
    assert (
        np.abs(np.fft.rfft2(contact_errors.surface(POINTS).heights))[0, POINTS // 8 + 1] < 1e-12 * waves.max()
    )


def test_a_constant_added_to_the_heights_is_no_error(topography):
    contact = contact_errors.Reference.at(topography, 0.1)
    pressure = np.maximum(topography.heights, 0)
    lifted = contact._replace(heights=contact.heights + 1)
    assert lifted.errors(pressure)[1] == pytest.approx(contact.errors(pressure)[1], rel=1e-9)


def test_both_our_solvers_keep_the_limits_where_they_are_asked_to(joined):
    assert not joined["gap_error"].isnull().sel(solver=contact_solvers.OURS).any()
    tightest = joined.sel(solver=contact_solvers.OURS).isel(step=-1)
    assert (tightest["gap_error"] <= 1e-7).all()
    assert (tightest["area_error"] == 0).all()
    independent = joined.sel(solver="Polonsky–Keer (softlub)").isel(step=3)
    assert (independent["gap_error"] <= 3e-7).all()


def test_the_source_s_algorithm_takes_several_times_the_convolutions(joined):
    counted = peers_ratios.measure([joined])["convolutions"].sel(points=2 * POINTS)
    assert (
        counted.sel(solver="Polonsky–Keer (softlub)") > 2 * counted.sel(solver=contact_solvers.OURS)
    ).all()


def test_the_quickest_run_within_the_limits_is_chosen(joined):
    found = contact_errors.quickest(joined)
    assert (found["gap_error"] <= contact_errors.LARGEST_GAP_ERROR).all()
    assert (found["area_error"] <= contact_errors.LARGEST_AREA_ERROR).all()
    within = contact_errors.meets(joined["area_error"], joined["gap_error"])
    least = joined["cpu_time"].where(within).min("step")
    np.testing.assert_array_equal(found["cpu_time"], least)


def test_a_solver_that_always_misses_has_no_time(joined):
    missing = joined.assign(gap_error=joined["gap_error"] + 1)
    assert contact_errors.quickest(missing)["cpu_time"].isnull().all()
    ratios = peers_ratios.measure([missing.assign(sweep_gap_error=joined["sweep_gap_error"] + 1)])
    assert not ratios["sweep_within_limits"].any()
    assert (ratios["sweep_gap_error"] > 1).all()


def test_ratios_are_over_our_time(joined, tmp_path):
    ratios = stored(tmp_path, peers_ratios.measure([joined]))
    assert (ratios["cpu_time_ratio"].sel(solver=contact_solvers.OURS) == 1).all()
    assert float(ratios["sweep_cpu_time_ratio"].sel(solver=contact_solvers.OURS)) == 1
    assert ratios["sweep_within_limits"].all()


@pytest.fixture
def slow():
    solver = contact_solvers.our_solvers()["Polonsky–Keer (softlub)"]
    return solver._replace(ladder_to=POINTS // 2, loads_to=POINTS // 2, largest=POINTS)


def references(topography):
    return {load: contact_errors.Reference.at(topography, load) for load in (1.0, peers_size.ONE_LOAD)}


def test_a_slow_solver_is_run_at_one_load_until_it_keeps_the_limits(slow, topography):
    runs = peers_size.table({"slow": peers_size.climb(slow, topography, references(topography))})
    seconds = runs["cpu_time"].squeeze("solver")
    assert seconds.notnull().any("step").values.tolist() == [
        load == peers_size.ONE_LOAD for load in peers_size.LOADS
    ]
    kept = contact_errors.meets(runs["area_error"], runs["gap_error"]).sum()
    assert int(kept) == 1


def test_a_slow_solver_is_left_out_on_large_grids(slow, topography):
    left_out = slow._replace(largest=POINTS // 2)
    assert np.isnan(peers_size.climb(left_out, topography, references(topography))).all()


def test_a_follower_runs_at_the_tolerance_that_its_leader_needs(slow, topography):
    judged = references(topography)
    leader = peers_size.table({"leader": peers_size.climb(slow, topography, judged)})
    chosen = float(contact_errors.quickest(leader)["tolerance"].sel(load=peers_size.ONE_LOAD).squeeze())
    runs = peers_size.follow(slow, topography, judged, leader)
    assert np.nanmax(runs[0]) == np.nanmin(runs[0]) == chosen


def test_a_quick_sequence_is_timed_three_times_from_cold():
    begun = []

    def begin():
        begun.append([])

        def solve(pressure):
            begun[-1].append(pressure)
            return peer_solvers.Found(np.full((2, 2), pressure), len(begun[-1]))

        return solve

    seconds, found = peer_solvers.timed(begin, [2.0, 1.0])
    assert begun == [[2.0, 1.0]] * peer_solvers.CALLS
    assert seconds.shape == (2,)
    assert [one.convolutions for one in found] == [1, 2]


def test_a_peer_that_fails_is_named_with_what_it_said(topography):
    run = contact_solvers.peer("no_such_peer", sys.executable)
    with pytest.raises(RuntimeError, match=r"no_such_peer at tolerance 1e-06 failed(.|\n)*KeyError"):
        run(topography, [[0.1]], 1e-6)


def test_the_peers_file_needs_nothing_of_softlub():
    tree = ast.parse((BENCHMARKS / "peer_solvers.py").read_text(encoding="utf-8"))
    names = [
        alias.name for node in ast.walk(tree) if isinstance(node, ast.Import) for alias in node.names
    ] + [str(node.module) for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)]
    assert not {name.split(".")[0] for name in names} & {"softlub", "xarray", "numba", "pyfftw"}


def test_every_solver_can_be_run_and_drawn():
    solvers = contact_solvers.all_solvers("somewhere/bin/python")
    assert {"ASPHER", "ASPHER, native build", "tamaas, wheel", "ContactMechanics"} <= set(solvers)
    assert set(solvers) <= set(peers_drawing.LOOKS)
    for solver in solvers.values():
        assert list(solver.tolerances) == sorted(solver.tolerances, reverse=True)
        assert solver.settled < len(solver.tolerances)
        assert solver.ladder_to <= max(peers_size.ALL_LOADS_TO, solver.loads_to)


def test_figures_show_every_run_and_say_what_was_not_run(joined, monkeypatch, tmp_path):
    monkeypatch.setattr(peers_drawing, "DRAWN_LOADS", (1.0, 0.05))
    left_out = joined.copy()
    left_out["cpu_time"] = joined["cpu_time"].where(
        (joined["solver"] == contact_solvers.OURS) | (joined["points"] == POINTS)
    )
    figure = peers.draw(left_out)
    assert f"Polonsky–Keer (softlub) beyond N = {POINTS}" in figure.notes[0]
    drawn = sum(series.x.size for series in figure.series)
    assert drawn == int(left_out["cpu_time"].sel(load=[1.0, 0.05]).notnull().sum())
    assert all("(" in axes.get_xlabel() for axes in figure.axes[-2:])
    rows = table(peers_area.draw(stored(tmp_path, peers_area.measure([joined])))).splitlines()
    assert rows[0] == "panel,series,cpu_time [s],area_error [1]"
    fine = peers_fine.draw(peers_fine.with_ratios(joined.isel(points=[0])))
    assert len({series.panel for series in fine.series}) == 2
    names = {series.series for series in peers_ratios.draw(peers_ratios.measure([joined])).series}
    assert names == set(contact_solvers.our_solvers())


@pytest.mark.parametrize(
    "name", ["peers", "peers_area", "peers_fine", "peers_ratios", "peers_size", "peers_sweep"]
)
def test_every_part_measures(name):
    assert callable(importlib.import_module(name).measure)
