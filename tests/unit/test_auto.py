from dataclasses import replace

import numpy as np
import pytest
from made_up_contact import Returning, contact, problem

from softlub.contact.laws.persson import PerssonLaw
from softlub.lubrication.film import Lubricant
from softlub.lubrication.problem import HalfSpaceCylinder, Problem
from softlub.lubrication.solvers.auto import Auto
from softlub.lubrication.solvers.finite_volume import FiniteVolume
from softlub.lubrication.solvers.spectral import Spectral
from softlub.surfaces.spectrum import SelfAffine

MODULUS = 1.3e7
SURFACE = SelfAffine(1e-6, hurst=0.8, rolloff=1e4, cutoff=7.8e9)
ROUGH = Problem(
    body=HalfSpaceCylinder(0.01, MODULUS),
    law=PerssonLaw(SURFACE, MODULUS),
    lubricant=Lubricant(0.1),
    load=100.0,
    speed=0.01,
    rms_roughness=1e-6,
)
SPEEDS = [1e-3, 1e-2, 0.1]
UNREACHABLE = Spectral(tolerance=1e-30)
"""No residual in double precision is that small."""


def conserving(one):
    return replace(one, lubricant=replace(one.lubricant, cavitation="mass_conserving"))


def test_spectral_elements_come_first():
    assert [one.solver for one in Auto().sweep(ROUGH, SPEEDS)] == ["spectral"] * 3
    assert Auto().solve(ROUGH).solver == "spectral"


def test_finite_volumes_solve_what_spectral_elements_leave():
    auto = Auto(spectral=UNREACHABLE, finite_volume=FiniteVolume(nodes=129))
    found = auto.sweep(ROUGH, SPEEDS)
    assert [one.solver for one in found] == ["finite_volume"] * 3
    assert all(one.converged for one in found)
    assert [one.speed for one in found] == SPEEDS
    exact = Spectral().sweep(ROUGH, SPEEDS)
    np.testing.assert_allclose(
        [one.separation_min for one in found], [one.separation_min for one in exact], rtol=2e-2
    )


def test_a_single_point_falls_back_too():
    found = Auto(spectral=UNREACHABLE, finite_volume=FiniteVolume(nodes=129)).solve(ROUGH)
    assert found.solver == "finite_volume"
    assert found.converged


def test_only_the_unsolved_speeds_are_solved_again_first_at_a_higher_order():
    first = [contact(solver="first", converged=good) for good in (True, False, True, False)]
    finer = Returning(contact(solver="finer", converged=False), contact(solver="finer", speed=4.0))
    second = Returning(contact(solver="second", speed=2.0))
    auto = Auto(spectral=Returning(*first, finer=finer), finite_volume=second)
    found = auto.sweep(problem(), [1.0, 2.0, 3.0, 4.0])
    assert finer.asked == [(100.0, [2.0, 4.0])]
    assert second.asked == [(100.0, [2.0])]
    assert [one.solver for one in found] == ["first", "second", "first", "finer"]
    assert [one.speed for one in found[1::2]] == [2.0, 4.0]


def test_a_solved_sweep_asks_nobody_else():
    second = Returning()
    Auto(spectral=Returning(contact()), finite_volume=second).sweep(problem(), [1.0])
    assert second.asked == []


def test_a_point_that_both_leave_stays_flagged_with_the_first_iterate():
    finer = Returning(contact(solver="finer", converged=False))
    first = Returning(contact(solver="first", converged=False), finer=finer)
    second = Returning(contact(solver="second", converged=False))
    (found,) = Auto(spectral=first, finite_volume=second).sweep(problem(), [1.0])
    assert not found.converged
    assert found.solver == "first"


@pytest.mark.parametrize("way", ["solve", "sweep"])
def test_mass_conserving_films_go_to_finite_volumes_at_once(way):
    first, second = Returning(), Returning(contact(solver="second"))
    auto, asked = Auto(spectral=first, finite_volume=second), conserving(problem())
    found = auto.solve(asked) if way == "solve" else auto.sweep(asked, [1.0])[0]
    assert found.solver == "second"
    assert first.asked == []


def test_both_solvers_are_refined():
    finer = Auto(Spectral(order=6), FiniteVolume(nodes=129)).refined()
    assert finer.spectral.order == 8
    assert finer.finite_volume.nodes == 257


def test_each_contact_is_corrected_by_a_finer_copy_of_the_solver_that_found_it():
    finer = Returning(contact(iterations=4), order=12)
    first = Returning(contact(iterations=1), order=10, finer=finer)
    second = Returning(contact(iterations=2), contact(iterations=3))
    asked = [
        contact(solver="finite_volume", speed=1.0),
        contact(solver="spectral", speed=2.0, breaks=range(0, 81, 8)),
        contact(solver="finite_volume", speed=3.0),
        contact(solver="spectral", speed=4.0, breaks=range(0, 81, 10)),
    ]
    corrected = Auto(spectral=first, finite_volume=second).correct(problem(), asked)
    assert first.asked == [(100.0, [2.0])]
    assert second.asked == [(100.0, [1.0, 3.0])]
    assert finer.asked == [(100.0, [4.0])]
    assert [one.iterations for one in corrected] == [2, 1, 3, 4]


def test_corrections_estimate_the_errors_of_both_solvers():
    auto = Auto(spectral=UNREACHABLE, finite_volume=FiniteVolume(nodes=129))
    mixed = [Auto().solve(ROUGH.at(speed=1e-3)), auto.solve(ROUGH.at(speed=0.1))]
    exact = Spectral(12).sweep(ROUGH, [1e-3, 0.1])
    for before, after, true in zip(mixed, Auto().refined().correct(ROUGH, mixed), exact, strict=True):
        assert after.converged
        assert after.solver == before.solver
        estimate = abs(after.separation_min - before.separation_min)
        assert estimate == pytest.approx(abs(true.separation_min - before.separation_min), rel=0.5)


def test_mistakes_are_raised_not_repaired():
    with pytest.raises(ValueError, match="speeds must be positive"):
        Auto().sweep(ROUGH, [0.1, -1.0])
