"""The one way in which loops over the grid are compiled.

The loops hold no branches: conditions are 0/1 numbers, so that the compiler turns them into vector instructions.
Sums may be reordered for the same reason; they run along a row in the arrays' precision and over the rows in
float64. Infinities and NaN keep their meaning.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numba

compiled: Callable[[Callable[..., Any]], Callable[..., Any]] = numba.njit(
    cache=True, error_model="numpy", fastmath={"reassoc", "contract", "nsz", "arcp", "afn"}
)
