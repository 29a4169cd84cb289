"""The one look of all figures: sizes, type, colours, markers."""

from __future__ import annotations

import re
from typing import Any

COLUMN = 3.5
"""Width of a journal's column [inch]."""
PAGE = 7.2
"""Width of a journal's page [inch]."""

# Okabe and Ito's palette, told apart with every common colour blindness.
BLACK = "#000000"
ORANGE = "#E69F00"
SKY = "#56B4E9"
GREEN = "#009E73"
BLUE = "#0072B2"
VERMILION = "#D55E00"
PURPLE = "#CC79A7"
GREY = "#7F7F7F"
SLATE = "#444444"
"""For what stands for no colour in particular, beside black and grey that do."""

CYCLE = (BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY, BLACK)
LINE_STYLES: tuple[Any, ...] = (
    "-",
    "--",
    ":",
    "-.",
    (0, (5, 1, 1, 1, 1, 1)),
    (0, (8, 2)),
    (0, (1, 3)),
    (0, (8, 2, 1, 2)),
)
MARKERS = ("o", "s", "^", "D", "v", "P")

FLUID, SOLID, SEPARATION = BLUE, GREEN, VERMILION
"""Colours of the three fields of a contact, as in the source: blue, green, red."""

SOLVER_MARKERS = {"bml": "s", "mehl": "o", "ehl": "^"}
SOLVER_COLOURS = {"bml": ORANGE, "mehl": GREEN, "ehl": BLUE}
NEWTON_SOLVERS = ("auto", "spectral", "finite_volume")
"""Solvers that find the Newton solution, drawn as the line that the modules are held against."""
NAMES = {
    "auto": "Newton",
    "spectral": "Newton",
    "finite_volume": "Newton, finite volumes",
    "bml": "BML",
    "mehl": "MEHL",
    "ehl": "EHL",
    "persson": "Persson integral",
    "exponential": "exponential law 3-11",
    "boundary_element": "boundary elements",
    "gauss_seidel": "Gauss–Seidel sweep",
    "newton_raphson": "Newton–Raphson sweep",
    "reynolds": "Reynolds cavitation",
    "mass_conserving": "mass-conserving cavitation",
}
"""How a name of a study file reads in a figure."""

SOLVERS_EXPLAINED = (
    "Newton solves film, asperities and elasticity at once by Newton's method; BML, MEHL and EHL are the source's "
    "modules for boundary, mixed and full-film lubrication, which go through the same equations in turn until nothing "
    "changes."
)
"""What the names of solvers mean, for captions."""

FAILED_MARKER = "x"
"""Mark of a point that did not converge, on the edge of its panel; the curve has a gap there."""

RC: dict[str, Any] = {
    "font.family": "sans-serif",
    "font.sans-serif": ["DejaVu Sans"],
    "font.size": 8,
    "axes.labelsize": 8,
    "axes.titlesize": 8,
    "legend.fontsize": 7,
    "xtick.labelsize": 7,
    "ytick.labelsize": 7,
    "axes.linewidth": 0.6,
    "lines.linewidth": 1.2,
    "lines.markersize": 4,
    "xtick.direction": "in",
    "ytick.direction": "in",
    "xtick.top": True,
    "ytick.right": True,
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
    "legend.frameon": False,
    "legend.handlelength": 2.4,
    "axes.grid": False,
    "figure.facecolor": "white",
    "savefig.facecolor": "white",
    "svg.fonttype": "path",
    "svg.hashsalt": "softlub",
    "pdf.fonttype": 42,
    "mathtext.fontset": "dejavusans",
    "axes.formatter.use_mathtext": True,
}
"""Settings in force while a figure is made and saved; DejaVu comes with matplotlib, so every machine draws alike."""


def power(value: float) -> str:
    """A number as print shows it: 0.12, 0.0015, but 10⁻⁵."""
    text = f"{value:.4g}"
    if "e" not in text:
        return text
    mantissa, _, exponent = text.partition("e")
    factor = "" if mantissa == "1" else rf"{mantissa}\times "
    return rf"${factor}10^{{{int(exponent)}}}$"


def plain(text: str) -> str:
    r"""Text without the marks of mathematical type: ``"$h_\mathrm{rms}$ = 1 µm"`` becomes ``"h_rms = 1 µm"``.

    Parameters
    ----------
    text : str

    Returns
    -------
    str
    """
    return re.sub(r"\$([^$]*)\$", lambda found: _plain_formula(found.group(1)), text)


def _plain_formula(formula: str) -> str:
    # 10^{-5}, with or without a factor before it, is a number, written here as programs write it.
    number = re.fullmatch(r"(?:([\d.]+)\\times )?10\^\{(-?\d+)\}", formula)
    if number:
        return f"{float(number.group(1) or 1) * 10.0 ** int(number.group(2)):g}"
    words = re.sub(r"\\math[a-z]*\{([^}]*)\}", r"\1", formula)
    return re.sub(r"[{}]|\\(?=[a-z])", "", words.replace(r"\times", "×"))


def signed(value: float) -> str:
    """A small number with its sign, as print shows it: +0.12, −0.03."""
    return f"{value:+.2f}".replace("-", "−")


def solver_of(label: str) -> str:
    """First word of a solver's label: the solver's name without its options."""
    return label.replace(",", " ").replace("(", " ").split()[0]


def readable(label: str) -> str:
    """A study file's label as a reader of the figure expects it."""
    if label in NAMES:
        return NAMES[label]
    words = label.replace("(", " ").replace(")", " ").replace(",", " ").split()
    return ", ".join([NAMES.get(words[0], words[0]), *(_option(word) for word in words[1:])])


def _option(word: str) -> str:
    name, equals, value = word.partition("=")
    if not equals:
        return NAMES.get(word, word.replace("_", " "))
    symbol = {"gamma": "γ", "pressure_factor": "pressure factor", "reynolds_sweep": "", "sweep": ""}.get(
        name, name.replace("_", " ")
    )
    # A label holds no blanks within an option; print separates number and unit.
    value = re.sub(r"(\d)([a-zµ]+)$", r"\1 \2", value)
    return f"{symbol} = {value}" if symbol else NAMES.get(value, value)
