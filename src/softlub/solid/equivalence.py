"""The hyperelastic material that stands for a viscoelastic one in a given motion (section 5.6.3).

The viscoelastic body ends its steps in one shape of the contact edge; a hyperelastic one with the constants of
equations 5-17 and 5-18 ends the same steps in another. The equivalence coefficient α is where the two differ least
by equation 5-16. That is an area, of which a small value says little: a body that does not deform at all scores the
mean squared displacement. Divided by this, the difference is 0 for equal shapes and 1 for a rigid body.

Only a run of the finite elements gives a shape, but shapes change smoothly with α, nearly like 1/α. So the bounded
minimisation searches polynomials in 1/α through the shapes known so far, each run is made where it ended, and
the search is done when it ends where it has been.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import ArrayLike
from scipy.optimize import minimize_scalar

from softlub.protocols import FloatArray

if TYPE_CHECKING:
    from softlub.solid.history import History

REMEMBERED = 4
"""Shapes that the polynomial goes through, those of least difference."""
CLOSE_BY = 0.2
"""Relative distance of two coefficients whose shapes tell how the shape changes between them."""
TRUSTED_FACTOR = 1.5
"""Farthest that a search goes from the best coefficient so far, either way, once three shapes are known."""


def shape_difference(one: ArrayLike, other: ArrayLike) -> float:
    """Mean squared distance of two shapes (equation 5-16).

    Parameters
    ----------
    one, other : array_like, shape (k, 2)
        Places or displacements of the same k nodes [m].

    Returns
    -------
    float
        ε_g [m²]; the source prints it without a unit, in mm².

    Raises
    ------
    ValueError
        If the shapes have different nodes.
    """
    first, second = np.asarray(one, dtype=float), np.asarray(other, dtype=float)
    if first.shape != second.shape or first.ndim != 2:
        raise ValueError(
            f"shapes of {first.shape} and {second.shape} cannot be compared: (k, 2) of the same nodes is needed"
        )
    return float(np.mean(np.sum((first - second) ** 2, axis=1)))


def normalised_shape_difference(displacement: ArrayLike, reference: ArrayLike) -> float:
    """Shape difference over the mean squared displacement of the reference.

    Parameters
    ----------
    displacement, reference : array_like, shape (k, 2)
        From the undeformed shape, the holder at rest [m].

    Returns
    -------
    float
        0 for equal shapes, 1 for a body that does not deform.

    Raises
    ------
    ValueError
        If the shapes have different nodes or the reference does not deform.
    """
    scale = shape_difference(reference, np.zeros_like(np.asarray(reference, dtype=float)))
    if scale == 0:
        raise ValueError("the reference does not deform: there is nothing to be equivalent to; load it")
    return shape_difference(displacement, reference) / scale


def final_shape(history: History) -> FloatArray:
    """Displacement of the contact edge at the end of all steps.

    Parameters
    ----------
    history : History

    Returns
    -------
    ndarray, shape (k, 2)
        The holder at rest [m].

    Raises
    ------
    ValueError
        If a step was not completed, with its reason: half a motion has no equivalent.
    """
    if not history.converged:
        raise ValueError(f"no final shape: {history.failure}")
    return history.last.edge_displacement


@dataclass(frozen=True, eq=False)
class EquivalentModel:
    """What a fit found.

    Parameters
    ----------
    coefficient : float
        α of the run with the least difference.
    shape_difference : float
        Of that run (equation 5-16) [m²].
    normalised : float
        The same over the mean squared displacement of the reference.
    coefficients, differences : ndarray, shape (runs,)
        Every run's α and difference [m²], in order.
    at_bound : {"lower", "upper"} or None
        The bound that stopped the search: the true minimum may lie beyond.
    converged : bool
        Whether a run lies within the tolerance of the minimum.
    """

    coefficient: float
    shape_difference: float
    normalised: float
    coefficients: FloatArray
    differences: FloatArray
    at_bound: Literal["lower", "upper"] | None
    converged: bool

    @property
    def runs(self) -> int:
        """Runs of the hyperelastic model that it took."""
        return self.coefficients.size


def fit_coefficient(
    reference: FloatArray,
    shape: Callable[[float], FloatArray],
    bounds: tuple[float, float] = (0.5, 5.0),
    start: float = 1.0,
    tolerance: float = 1e-4,
    most_runs: int = 12,
) -> EquivalentModel:
    """Fit the equivalence coefficient α.

    Parameters
    ----------
    reference : ndarray, shape (k, 2)
        Final displacement of the viscoelastic body's edge [m].
    shape : callable
        α -> final displacement of the hyperelastic body's edge [m], shape (k, 2).
    bounds : tuple of float
        Least and largest α.
    start : float
        First α.
    tolerance : float
        Relative change of α below which the search ends.
    most_runs : int
        Runs after which to stop, unconverged.

    Returns
    -------
    EquivalentModel

    Raises
    ------
    ValueError
        If the bounds do not enclose the start, a shape does not fit the reference's nodes or is not finite, or the
        reference does not deform.
    """
    lower, upper = bounds
    if not 0 < lower < upper < np.inf or not lower <= start <= upper:
        raise ValueError(f"start = {start:g} must lie within bounds = ({lower:g}, {upper:g}), both above 0")
    normalised_shape_difference(reference, reference)  # refuses a reference that does not deform
    tried: list[float] = []
    shapes: list[FloatArray] = []
    wanted, converged = start, False
    while not converged and len(tried) < most_runs:
        shapes.append(_checked_shape(shape, wanted, reference))
        tried.append(wanted)
        wanted = _next(tried, shapes, reference, bounds, tolerance)
        apart = np.sort(np.abs(np.array(tried) / wanted - 1))
        if len(tried) > 1 and apart[0] <= tolerance:
            # Where the search has been; how the shape changes there must come from close by.
            converged = bool(apart[1] <= CLOSE_BY)
            wanted = _beside(wanted, bounds)
    return replace(_best(tried, shapes, reference, bounds, tolerance), converged=converged)


def _best(
    tried: Sequence[float],
    shapes: Sequence[FloatArray],
    reference: FloatArray,
    bounds: tuple[float, float],
    tolerance: float,
) -> EquivalentModel:
    """The run with the least difference, not known to lie at the minimum."""
    differences = np.array([shape_difference(found, reference) for found in shapes])
    best = int(np.argmin(differences))
    return EquivalentModel(
        coefficient=tried[best],
        shape_difference=float(differences[best]),
        normalised=normalised_shape_difference(shapes[best], reference),
        coefficients=np.array(tried),
        differences=differences,
        at_bound=_bound(tried[best], bounds, tolerance),
        converged=False,
    )


def _checked_shape(
    shape: Callable[[float], FloatArray], coefficient: float, reference: FloatArray
) -> FloatArray:
    """One run's shape; refused where it is not finite or has other nodes than the reference."""
    found = np.asarray(shape(coefficient), dtype=float)
    if not np.all(np.isfinite(found)):
        raise ValueError(
            f"the hyperelastic run at α = {coefficient:g} gave no finite shape; narrow the bounds"
        )
    shape_difference(found, reference)
    return found


def _beside(coefficient: float, bounds: tuple[float, float]) -> float:
    """Half as far away as counts as close by, within the bounds."""
    larger = coefficient * (1 + CLOSE_BY / 2)
    return larger if larger <= bounds[1] else max(coefficient * (1 - CLOSE_BY / 2), bounds[0])


def _bound(
    coefficient: float, bounds: tuple[float, float], tolerance: float
) -> Literal["lower", "upper"] | None:
    if coefficient <= bounds[0] * (1 + 2 * tolerance):
        return "lower"
    return "upper" if coefficient >= bounds[1] * (1 - 2 * tolerance) else None


def _next(
    tried: Sequence[float],
    shapes: Sequence[FloatArray],
    reference: FloatArray,
    bounds: tuple[float, float],
    tolerance: float,
) -> float:
    """Where the shapes known so far promise the least difference."""
    if len(tried) == 1:
        return _beside(tried[0], bounds)
    differences = [shape_difference(found, reference) for found in shapes]
    nearest = np.argsort(differences)[:REMEMBERED]
    places = 1 / np.array(tried)[nearest]
    known = np.array([shapes[k] for k in nearest])

    def difference(place: float) -> float:
        weights = [
            np.prod((place - np.delete(places, i)) / (p - np.delete(places, i))) for i, p in enumerate(places)
        ]
        return shape_difference(np.tensordot(weights, known, axes=1), reference)

    least, largest = 1 / bounds[1], 1 / bounds[0]
    if len(tried) > 2:
        # A line is trusted everywhere, a curve only about the shapes that it goes through.
        least, largest = max(least, places[0] / TRUSTED_FACTOR), min(largest, places[0] * TRUSTED_FACTOR)
    found = minimize_scalar(
        difference,
        bounds=(least, largest),
        method="bounded",
        options={"xatol": 0.1 * tolerance / bounds[1]},
    )
    return 1 / float(found.x)
