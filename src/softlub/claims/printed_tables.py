"""Which study runs the surfaces of which of the source's tables; imports nothing, since the workflow reads it."""

from __future__ import annotations

STUDIES = {
    "table_4_1": "ch4-continuum",
    "table_4_2": "ch4-continuum",
    "table_4_3": "ch4-thermodynamic",
    "table_4_4": "ch4-fractal",
    "table_4_5": "ch4-hurst",
}
"""Table -> study."""


def tables_of(study: str) -> tuple[str, ...]:
    """Tables that are written beside a study.

    Parameters
    ----------
    study : str

    Returns
    -------
    tuple of str
    """
    return tuple(table for table, name in STUDIES.items() if name == study)
