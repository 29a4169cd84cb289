"""Checks of tables 4-1 to 4-5: rms roughness and rms slope of the surfaces, and the parameters printed with them."""

from __future__ import annotations

import numpy as np

from softlub.claims.printed_surfaces import PRINTED, PrintedSurface, find, rows
from softlub.claims.printed_tables import STUDIES
from softlub.claims.verdict import Check, Datasets, NotComputed, Verdict, check, judge
from softlub.datasets.contact_curves import inputs

TOLERANCE = 0.12
"""Relative difference of the slope up to which a row is reproduced: no recipe gives all rows of the tables."""
WIDE_TOLERANCE = {"table_4_3_row_1": 0.26, "table_4_5_row_1": 0.26}
"""For rows whose few long waves or many short ones leave more to chance and to the estimator."""
SAME = 0.01
"""Relative difference of h_rms, which is an input of ours."""


def _check(printed: PrintedSurface) -> Check:
    def row(datasets: Datasets) -> Verdict:
        study = STUDIES[printed.row.partition("_row")[0]]
        surface = find(datasets(study), printed)
        if surface is None:
            raise NotComputed(f"this surface of {printed.points}² points was not run at this accuracy")
        known = inputs(surface)
        roughness, forward = known["rms_roughness"], known["rms_slope_forward"]
        tolerance = WIDE_TOLERANCE.get(printed.row, TOLERANCE)
        height = roughness / printed.rms_roughness - 1
        slope = forward / printed.rms_slope - 1
        return judge(
            abs(height) <= SAME and abs(slope) <= tolerance,
            f"rms roughness {roughness * 1e6:.3f} µm, rms slope {forward:.4f} by forward differences, "
            f"{known['rms_slope_spectral']:.4f} spectral",
            _reason(printed, height, slope, tolerance),
        )

    return row


def _reason(printed: PrintedSurface, height: float, slope: float, tolerance: float) -> str:
    parts = [
        f"the slope by forward differences is off by {100 * slope:+.1f} %, reproduced within {100 * tolerance:.0f} %"
    ]
    if abs(height) > SAME:
        parts.append(
            f"h_rms is {1 + height:.2g} times the printed one, whose slope would then be "
            f"{printed.rms_slope / (1 + height):.2g}: a misprint of the table"
        )
    else:
        parts.append("h_rms is an input, taken from the table")
    if printed.printed_shortest is not None:
        per_wave = printed.printed_shortest / (printed.size / printed.points)
        parts.append(
            f"lambda_s is taken as {printed.shortest:g} m: of the printed {printed.printed_shortest:g} m a wave would "
            f"have {per_wave:.1g} points"
        )
    return "; ".join(parts)


for _printed in PRINTED:
    check(_printed.row)(_check(_printed))


@check("eq_4_5_qL")
def lower_cutoff(datasets: Datasets) -> Verdict:
    """q_L of the tables over 2π/L."""
    ratios = sorted({printed.size / printed.longest for printed in PRINTED})
    return judge(
        ratios == [1.0],
        f"side over longest wave: {', '.join(f'{ratio:g}' for ratio in ratios)}",
        "by the tables' own columns q_L is 2 pi/lambda_L, which is not 2 pi/L",
    )


@check("eq_4_tfc")
def continuum_limit(datasets: Datasets) -> Verdict:
    """Spacing over shortest wavelength along table 4-2, whose grids go towards the limit."""
    ratios = [row.size / row.points / row.shortest for row in rows("table_4_2")]
    return judge(
        bool(np.all(np.diff(ratios) > 0)),
        f"table 4-2: {', '.join(f'{ratio:.3g}' for ratio in ratios)}",
        "as the grid is refined spacing over shortest wave goes to 0, not to infinity",
    )


@check("eq_4_qL_ratio")
def finite_size_measure(datasets: Datasets) -> Verdict:
    """Power of the length in L/q_L: its change when a surface is scaled by 2."""
    size, lower = 4e-4, 2 * np.pi / 2e-4
    power = float(np.log2((2 * size / (lower / 2)) / (size / lower)))
    return judge(
        abs(power) < 1e-9, f"m^{power:.0f}", "a measure of finite size has no unit: L/lambda_L is meant"
    )
