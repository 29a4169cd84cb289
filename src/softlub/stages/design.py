"""Designed samples: Sobol points over stated ranges, made where they are used, from the seed in the spec."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np


def sample_points(sample: Mapping[str, Any]) -> dict[str, np.ndarray]:
    """The chunk of a scrambled Sobol design that a panel is to solve.

    Parameters
    ----------
    sample : mapping
        ``seed``, ``first`` and ``size`` of the chunk, and ``ranges``: path -> {from, to, spacing}.

    Returns
    -------
    dict of str to ndarray, shape (size,)
        Values in SI by path, drawn evenly in the value (``linear``) or its logarithm (``log``).
    """
    from scipy.stats import qmc

    ranges = sample["ranges"]
    engine = qmc.Sobol(d=len(ranges), scramble=True, rng=sample["seed"])
    if sample["first"]:
        engine.fast_forward(sample["first"])
    # Chunks need not be powers of two: balance is the whole design's, which the chunks together make up.
    unit = engine.random(sample["size"])
    return {path: _spread(unit[:, column], ranges[path]) for column, path in enumerate(sorted(ranges))}


def _spread(unit: np.ndarray, bounds: Mapping[str, Any]) -> np.ndarray:
    low, high = bounds["from"], bounds["to"]
    if bounds["spacing"] == "log":
        return low * (high / low) ** unit
    return low + (high - low) * unit
