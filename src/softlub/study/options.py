"""Options of contact laws and solvers that a study file may set.

Their fields are the keyword arguments of the law or solver of the same name; a solver's option left out is set by the
study's `accuracy`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from softlub.units import Unit

Factor = Annotated[float, Unit("1", above=0)]
Order = Annotated[int, Unit("1", at_least=3, at_most=32)]
Nodes = Annotated[int, Unit("1", at_least=17, at_most=4097)]


@dataclass(frozen=True)
class NoContactOptions:
    """No asperity contact: the law of smooth surfaces."""


@dataclass(frozen=True)
class ExponentialOptions:
    """Exponential asperity law (equation 3-11), valid for separations above h_rms.

    Parameters
    ----------
    pressure_factor : float
        Multiplies the pressure.
    """

    pressure_factor: Factor = 1.0


@dataclass(frozen=True)
class PerssonOptions:
    """Persson's full integral of pressure over separation (equation 4-22).

    Parameters
    ----------
    gamma : float
        Weight γ of the elastic energy of the contacting asperities, in (0, 1].
    pressure_factor : float
        Multiplies the pressure.
    """

    gamma: Annotated[float, Unit("1", above=0, at_most=1)] = 1.0
    pressure_factor: Factor = 1.0


@dataclass(frozen=True)
class BoundaryElementOptions:
    """The law of the surface itself: a sweep of loads by boundary elements, averaged over realisations.

    Parameters
    ----------
    pressure_factor : float
        Multiplies the pressure.
    """

    pressure_factor: Factor = 1.0


@dataclass(frozen=True)
class ContactOptions:
    """A solver of rough contact.

    Parameters
    ----------
    tolerance : float
        Root mean square gap over the contact at convergence, over h_rms.
    """

    tolerance: Annotated[float, Unit("1", at_least=1e-12, at_most=1e-2)] = 1e-6


@dataclass(frozen=True)
class PolonskyKeerOptions:
    """The source's own algorithm (section 4.5).

    Parameters
    ----------
    tolerance : float
        As in `ContactOptions`; 0 to stop on `change` alone.
    change : float
        Relative change of the pressure at which it stops (equation 4-47); 0 to stop on `tolerance` alone.
    iterations : int
        Iterations after which a load is given back as not converged.
    """

    tolerance: Annotated[float, Unit("1", at_least=0, at_most=1e-2)] = 1e-6
    change: Annotated[float, Unit("1", at_least=0, at_most=1e-2)] = 0.0
    iterations: Annotated[int, Unit("1", at_least=1, at_most=1_000_000)] = 10_000


@dataclass(frozen=True)
class SpectralOptions:
    """Spectral elements with the rupture point as an unknown.

    Parameters
    ----------
    order : int, optional
        Polynomial order of the elements.
    """

    order: Order | None = None


@dataclass(frozen=True)
class FiniteVolumeOptions:
    """Finite volumes with semi-smooth complementarity.

    Parameters
    ----------
    nodes : int, optional
        Nodes of the grid.
    """

    nodes: Nodes | None = None


@dataclass(frozen=True)
class AutoOptions:
    """Spectral elements, with finite volumes for the points they leave unsolved.

    Parameters
    ----------
    order, nodes : int, optional
        Of the spectral elements and of the finite volumes.
    """

    order: Order | None = None
    nodes: Nodes | None = None


@dataclass(frozen=True)
class ModuleOptions:
    """One of the source's modules: relaxed sweeps, stopped by true residuals or by their number.

    Parameters
    ----------
    nodes : int, optional
        Nodes of the grid.
    """

    nodes: Nodes | None = None


@dataclass(frozen=True)
class MixedModuleOptions(ModuleOptions):
    """The source's MEHL module.

    Parameters
    ----------
    sweep : {"gauss_seidel", "newton_raphson"}
        How the fluid pressure is swept.
    """

    sweep: Literal["gauss_seidel", "newton_raphson"] = "gauss_seidel"
