"""A user's Prony series from a CSV file.

# normalised: long_term
relaxation_time [s],term
1e-3,2.5
1e-1,0.4
"""

from __future__ import annotations

from pathlib import Path
from typing import get_args

from softlub.solid.materials.columns import NUMBERS, TIMES, read_columns
from softlub.solid.materials.prony import Normalised, PronySeries

COLUMNS = {"relaxation_time": TIMES, "term": NUMBERS}


def read_prony(path: str | Path) -> PronySeries:
    """Read a Prony series.

    Parameters
    ----------
    path : str or Path
        CSV file with the columns ``relaxation_time [s]`` and ``term`` and, above them, a line
        ``# normalised: long_term`` or ``# normalised: instantaneous`` that says which modulus the terms are relative
        to.

    Returns
    -------
    PronySeries

    Raises
    ------
    ValueError
        If the file is not of this form, says not what its terms are relative to, or holds terms or times that
        `PronySeries` refuses. The message names the file.
    FileNotFoundError
        If there is no such file.
    """
    table = read_columns(path, COLUMNS)
    normalised = table.settings.get("normalised")
    if normalised is None:
        raise ValueError(
            f"{path}: says nowhere what the terms are relative to; put a line '# normalised: long_term' or "
            "'# normalised: instantaneous' above the header"
        )
    allowed: dict[str, Normalised] = {word: word for word in get_args(Normalised)}
    if normalised not in allowed:
        raise ValueError(f'{path}: normalised = "{normalised}" is unknown; allowed: {", ".join(allowed)}')
    times, terms = table.columns["relaxation_time"], table.columns["term"]
    try:
        return PronySeries(tuple(times.tolist()), tuple(terms.tolist()), allowed[normalised])
    except ValueError as error:
        raise ValueError(f"{path}: {error}") from None
