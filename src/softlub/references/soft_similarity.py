"""The film of a smooth soft contact at low speed: isoviscous, elastic, on a parabola.

In Hertz units (x by a, p by p₀, u by a²/R) the one number of the problem is λ = 6ηvR²/(a³p₀). As λ -> 0 the pressure
tends to Hertz's, and the film is set in an inlet of width δ a at x = -a: there p ~ √δ, so that the Reynolds equation
√δ/δ = λ/u² and the elastic gap u ~ δ^(3/2) of the contact's edge give δ = λ^(2/5), u = const λ^(3/5). The flat film
keeps that thickness up to a neck of the same two scales at the outlet (K. Herrebrugh, J. Lubr. Technol. 90 (1968) 262;
J. H. Snoeijer, J. Eggers, C. H. Venner, Phys. Fluids 25 (2013) 101705).

The two constants belong to the similarity problems of inlet and outlet, which have no closed form. The first is the
solution of the inlet's problem, both are the limit of whole contacts as λ -> 0, which they approach like λ^(2/5); the
tests compute both.
"""

from __future__ import annotations

CENTRAL_FILM = 0.4458
"""u(0) R/a² λ^(-3/5) as λ -> 0."""
SMALLEST_FILM = 0.3550
"""u_min R/a² λ^(-3/5) as λ -> 0, at the neck of the outlet."""


def speed_number(
    radius: float, half_width: float, peak_pressure: float, viscosity: float, speed: float
) -> float:
    """λ = 6ηvR²/(a³p₀).

    Parameters
    ----------
    radius : float
        R [m].
    half_width : float
        Dry Hertz half-width a [m].
    peak_pressure : float
        Dry Hertz peak pressure p₀ [Pa].
    viscosity : float
        η [Pa s].
    speed : float
        v of the one moving wall [m/s].
    """
    return 6 * viscosity * speed * radius**2 / (half_width**3 * peak_pressure)


def central_film(radius: float, half_width: float, speed_number: float) -> float:
    """u(0) [m], for small λ."""
    return CENTRAL_FILM * speed_number**0.6 * half_width**2 / radius


def smallest_film(radius: float, half_width: float, speed_number: float) -> float:
    """u_min [m], for small λ."""
    return SMALLEST_FILM * speed_number**0.6 * half_width**2 / radius
