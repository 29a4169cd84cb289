"""Figures: one pure function a sort of picture, from a study's dataset to a matplotlib figure.

Every drawing has the one signature ``draw(dataset, **options) -> DataFigure``; none touches pyplot. Matplotlib is
imported only when a drawing is asked for.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    import xarray as xr

    from softlub.figures.panel import DataFigure


class Drawing(NamedTuple):
    """Where a drawing lives and what it shows."""

    module: str
    shows: str


DRAWINGS: dict[str, Drawing] = {
    name: Drawing(f"softlub.figures.{name}", shows)
    for name, shows in {
        "stribeck": "Friction coefficient over Hersey number (viscosity times speed).",
        "load_share": "Load carried by the fluid and by asperities over Hersey number; the dashed line marks the "
        "minimum of friction.",
        "friction_and_separation": "Friction coefficient and smallest separation over Hersey number.",
        "profiles": "Fluid pressure, asperity pressure and separation along the sliding direction at one speed.",
        "sweep_comparison": "The same contact by different sweeps: profiles at one speed; sweeps needed, CPU time "
        "and convergence over speed.",
        "module_comparison": "The same contact by different modules at one speed, over the Newton solution.",
        "parameter_study": "Friction coefficient (a) and smallest separation (b) over Hersey number for several "
        "values of one input.",
        "regime_map": "Share of the load on asperities over the two numbers that scale the contact in Hertz "
        "units; lines show where the smallest separation is once and three times the rms roughness.",
        "sensitivity": "Share of the variance that each input explains by itself (first-order index), over speed.",
        "profile_stages": "A line as measured, without its form, and without its waviness; red lines are what is "
        "taken off next.",
        "topography_map": "A rough surface (a) and the distribution of its heights beside Gauss's curve (b).",
        "self_affine_spectrum": "Power spectrum of a self-affine surface with its roll-off and cut-offs.",
        "surface_spectra": "Radial autocorrelation (a); radial spectrum C(q) and spectrum of lines C1D+(q) (b), beside "
        "what follows from C(q) by the right factor and by the printed one.",
        "wavevector_spacing": "Spectra asked for and obtained by linear and by exponential wavevectors (a); the "
        "surface made of linear ones (b).",
        "persson_separation": "Pressure over mean separation: Persson's full integral, its exponential tail and the "
        "numerical contact.",
        "deflection": "Deflection under Hertz's pressure along the central line by each method, with its CPU time (a), "
        "and the error against the closed form (b).",
        "contact_lines": "Contact pressure (a) and gap (b) along the central line at rising loads.",
        "solver_comparison": "Mean separation (a) and area (b) over the load by several solvers, and the area that a "
        "threshold of the gap would count.",
        "area_and_separation": "Real contact area up to a fifth of the nominal one (a), its ratio κ to the load (b), "
        "and mean separation to full contact (c). The load of (a) and (b) is normalised by the spectral rms slope, "
        "that of (c) by the modulus alone.",
        "spectra_and_heights": "Radial spectra over the asked ones (a) and height distributions beside Gauss's (b).",
        "mesh": "The mesh of a body with its contact edge and the nodes held (a), and its cells at the contact (b).",
        "deformed_mesh": "The deformed body to scale, coloured by von Mises stress: all of it (a) and the contact (b).",
        "half_cylinder": "Mesh at rest (a) and under load (b); vertical displacement of the contact edge by finite "
        "elements and of a half-space under the same nodal forces (c).",
        "reduced_against_full": "Displacement of the contact edge away from the plate (a) and along it (b), the holder "
        "at rest: finite elements as lines, the reduced stiffness under the same nodal forces as markers; below, by "
        "how much the reduced stiffness differs (c, d).",
        "matrix_entries": "Entries of the reduced stiffness: its diagonal (a), and the root mean square of the row of "
        "the apex in classes of the distance from it (b).",
        "moduli": "Storage and loss modulus in tension (a) and loss factor (b) over the angular frequency.",
        "equivalent_shape": "Contact edge of the viscoelastic body and of hyperelastic ones with α times its "
        "constants: all of it (a), the contact (b), and the distance of each node from the viscoelastic "
        "body's (c).",
        "equivalent_against_full": "Displacement of the contact edge of the viscoelastic body away from the plate (a) "
        "and along it (b), by finite elements and by the reduced stiffness of hyperelastic bodies under its nodal "
        "forces; below, the differences (c, d).",
        "work_precision": "Error against CPU time.",
    }.items()
}
"""Every drawing a study may name."""


def draw(name: str, dataset: xr.Dataset, **options: Any) -> DataFigure:
    """Draw one picture of a dataset.

    Parameters
    ----------
    name : str
        A key of `DRAWINGS`.
    dataset : xarray.Dataset
        Dataset of a study.
    **options
        Options of that drawing.

    Returns
    -------
    DataFigure
        A matplotlib figure that also holds the data it shows.

    Raises
    ------
    ValueError
        If there is no drawing of that name.
    """
    if name not in DRAWINGS:
        raise ValueError(f"no drawing is called {name!r}; there are {', '.join(DRAWINGS)}")
    return import_module(DRAWINGS[name].module).draw(dataset, **options)
