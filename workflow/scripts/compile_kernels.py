"""Compile every solver's kernels once, so that no job of the first run has to: numba keeps them beside the sources."""

from softlub.contact import sweep as contact_sweep
from softlub.contact.laws.persson import PerssonLaw
from softlub.lubrication import HalfSpaceCylinder, Lubricant, Problem
from softlub.lubrication.solvers import SOLVERS, finer, make_solver
from softlub.surfaces import SelfAffine, synthesize

MODULUS = 13.3e6
SURFACE = SelfAffine(rms_roughness=1e-6, hurst=0.8, rolloff=1e4, cutoff=7.8e9)
PROBLEM = Problem(
    HalfSpaceCylinder(radius=0.01, modulus=MODULUS),
    PerssonLaw(SURFACE, MODULUS),
    Lubricant(viscosity=0.1),
    load=100.0,
    speed=0.1,
    rms_roughness=SURFACE.rms_roughness,
    half_domain=1e-3,
)

for solver in (*map(make_solver, SOLVERS), make_solver("mehl", reynolds_sweep="newton_raphson")):
    contacts = solver.sweep(PROBLEM, [0.1])
    corrector = finer(solver)
    if corrector is not None:
        corrector.correct(PROBLEM, contacts)

rough = synthesize(SelfAffine(rms_roughness=1e-6, hurst=0.8, rolloff=2e5, cutoff=2e6), 64e-6, 64, seed=1)
contact_sweep(rough, MODULUS, [0.01 * MODULUS, 0.1 * MODULUS])
