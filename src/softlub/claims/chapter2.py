"""Checks of chapter 2: what the studies of chapter 3 can decide."""

from __future__ import annotations

import numpy as np

from softlub.claims.reading import curve
from softlub.claims.verdict import Datasets, NotComputed, Verdict, check, judge

BOUNDARY_SHARE = 0.5
FULL_FILM_SHARE = 1e-3
"""Load shares of asperities above and below which nobody would doubt the regime."""


@check("claim_2_07")
def film_over_roughness(datasets: Datasets) -> Verdict:
    """Asperities carry most where lambda < 1 and nothing where lambda > 10."""
    newton = curve(datasets("ch3-stribeck"))
    known = np.isfinite(newton["lambda_ratio"].values)
    ratio = newton["lambda_ratio"].values[known]
    share = np.maximum(newton["load_share_solid"].values[known], np.finfo(float).tiny)
    if not (ratio.size and ratio.min() < 1 and ratio.max() > 10):
        raise NotComputed("the curve does not reach from lambda = 1 to 10")
    at_one, at_ten = (float(np.exp(np.interp(np.log(x), np.log(ratio), np.log(share)))) for x in (1.0, 10.0))
    return judge(
        at_one >= BOUNDARY_SHARE and at_ten <= FULL_FILM_SHARE,
        f"asperity share {at_one:.2g} at lambda = 1, {at_ten:.1g} at lambda = 10",
        f"lambda is the smallest separation over the rms roughness; "
        f"reproduced if asperities carry at least {BOUNDARY_SHARE:g} of the load at 1 "
        f"and at most {FULL_FILM_SHARE:g} at 10",
    )
