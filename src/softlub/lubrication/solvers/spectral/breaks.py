"""Where the elements end: graded towards the edges of a Hertz-like contact, or towards the rupture of a thick film.

All in Hertz units. A Hertz-like contact has two edge layers of width d around X = ∓1, in which the pressure turns
from the inlet's into Hertz's; a thick or rough film has one scale w, the width √(2H) of the parabola.
"""

from __future__ import annotations

import numpy as np
from numba import njit

from softlub.lubrication.solvers.spectral.basis import FloatArray
from softlub.lubrication.solvers.spectral.vectors import reverse

INLET_GROWTH = 5.5
CONTACT_GROWTH = 3.4
GAP_FACTOR = 3.0
FILM_GROWTH = 2.2
# What is left between the breaks from both ends, in units of the element placed last, must be more than this.
REST_SHARE = 0.6


@njit(cache=True)
def is_hertzian(approach: float, film_min: float, speed_number: float, roughness: float) -> bool:
    """Whether the contact has distinct edge layers."""
    return approach <= 0.5 and edge_scale(film_min, speed_number, roughness) <= 0.8


@njit(cache=True)
def edge_scale(film_min: float, speed_number: float, roughness: float) -> float:
    """Separation that sets the width of the edge layers: the rough one while asperities carry, or the film's."""
    return max(min(roughness, GAP_FACTOR * film_min), 0.446 * speed_number**0.6)


@njit(cache=True)
def element_breaks(
    rupture: float,
    approach: float,
    film_min: float,
    speed_number: float,
    roughness: float,
    layer: float,
    start: float,
    end: float,
) -> tuple[FloatArray, int]:
    """Ends of the elements from the inlet to where the solid pressure has died out.

    Parameters
    ----------
    rupture : float
        b.
    approach : float
        H_c.
    film_min : float
        Smallest separation.
    speed_number : float
        λ.
    roughness : float
        s_h = h_rms R/a².
    layer : float
        Width of the layer before the rupture.
    start, end : float
        -L, and where the solid pressure has died out (b or less: no outlet elements).

    Returns
    -------
    breaks : ndarray
        Ascending.
    inlet : int
        Number of elements up to b.
    """
    found = np.empty(400)
    if is_hertzian(approach, film_min, speed_number, roughness):
        scale = min(edge_scale(film_min, speed_number, roughness) ** (2 / 3), 0.6)
        inside = rupture < 1 - scale
        count = _hertzian_inlet(
            found, rupture, scale, max(scale, min(layer, 0.6)) if inside else scale, start
        )
        inlet = count - 1
        if inside:
            count = _dry_exit(found, count, scale)
            rupture = 1.0
        outlet, growth = max(1 + scale - rupture, 0.3 * scale), INLET_GROWTH
    else:
        # A film so thick that the domain starves it has the domain's scale.
        scale = min(0.6 * np.sqrt(2 * max(approach, 0.7 * roughness) + 1), 0.25 * (rupture - start))
        count = _film_inlet(found, rupture, scale, start)
        inlet = count - 1
        outlet, growth = scale, FILM_GROWTH
    # Elements stretched by a moved rupture point may have reached beyond the domain.
    while found[count - 1] < min(end, -start):
        found[count] = min(rupture + outlet, -start)
        outlet *= growth
        count += 1
    return found[:count].copy(), inlet


@njit(cache=True)
def _film_inlet(found: FloatArray, rupture: float, scale: float, start: float) -> int:
    """Breaks of a thick film left of the rupture: b - w {1, 2.2, 4.6, 10, …}."""
    found[0] = start
    count = 1
    distance = scale
    while rupture - distance > start + 0.5 * distance:
        found[count] = rupture - distance
        distance *= FILM_GROWTH
        count += 1
    reverse(found, 1, count)
    found[count] = rupture
    return count + 1


@njit(cache=True)
def _dry_exit(found: FloatArray, count: int, scale: float) -> int:
    """Breaks between a rupture inside the contact and the exit edge at 1."""
    rupture = found[count - 1]
    first = count
    distance = 0.9 * scale
    while 1 - distance > rupture + 0.3 * distance:
        found[count] = 1 - distance
        distance *= CONTACT_GROWTH
        count += 1
    reverse(found, first, count)
    return count


@njit(cache=True)
def _hertzian_inlet(found: FloatArray, rupture: float, scale: float, layer: float, start: float) -> int:
    """Breaks around the entry edge at -1, both ways, and towards the rupture, with a layer of given width there."""
    found[0] = start
    count = 1
    distance = scale
    while -1 - distance > start + 0.3 * distance:
        found[count] = -1 - distance
        distance *= INLET_GROWTH
        count += 1
    reverse(found, 1, count)
    # From both ends inwards, the finer side first, as long as what is left makes an element of its own.
    left, right = scale, 0.9 * layer
    last = found.size
    low, high = -1.0 - scale, rupture
    while True:
        if left <= right:
            if high + 1 - left < REST_SHARE * (left - 1 - low):
                break
            low = left - 1
            found[count] = low
            left *= CONTACT_GROWTH
            count += 1
        else:
            if rupture - right - low < REST_SHARE * (high - rupture + right):
                break
            high = rupture - right
            last -= 1
            found[last] = high
            right *= CONTACT_GROWTH
    for k in range(last, found.size):
        found[count] = found[k]
        count += 1
    found[count] = rupture
    return count + 1
