"""c_1 and d_1 as functions of the exponent: certified decimals on a grid, as stored data, and their picture.

    python -m paper_checks.report.stokes_curve

computes ``stokes_curve.json`` beside this file anew (some minutes).  Every decimal is correctly rounded, so each row
encloses its two constants.  The grid is even in alpha away from 1, and even in 1/(alpha - 1) near 1, where the
constants beat.  Beside them stands what the page "Why the series diverge" expects as alpha -> 1, x = 1/(alpha - 1):

    c_1 -> cos(pi x)/pi,      d_1 -> sin(pi x) - cos(pi x).

>>> [grid()[k] for k in (0, 1, -1)], len(grid()) > 100
(['1/20', '1/10', '8'], True)
"""

import json
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np

import asymptotics as asy
from asymptotics import __version__
from asymptotics.made_by import made_by
from asymptotics.present.files import write_atomically

STORED = Path(__file__).with_name("stokes_curve.json")
DIGITS, NEAR, FAR = 12, 4, 16
"""Of each constant; the grid is even in 1/|alpha - 1| from NEAR to FAR."""


def grid() -> list[str]:
    """The exponents, increasing."""
    beats = [Fraction(k, 4) for k in range(4 * NEAR, 4 * FAR + 1)]
    even = [Fraction(k, 20) for k in range(1, 15)] + [Fraction(k, 20) for k in range(26, 40)]
    even += [Fraction(k, 4) for k in range(8, 33)]
    return [str(alpha) for alpha in sorted({*even, *(1 - 1 / x for x in beats), *(1 + 1 / x for x in beats)})]


def row(alpha: str) -> dict[str, str]:
    """One row, as text."""
    found = asy.stokes(alpha, digits=DIGITS, max_seconds=600)
    if not found.certified:
        raise ArithmeticError(f"alpha = {alpha}: not certified")
    return {"alpha": alpha, "c_1": found.constants[0], "d_1": found.time_constants[0]}


def stored() -> list[dict[str, str]]:
    """The rows of the file; a test computes a sample of them again."""
    found: list[dict[str, str]] = json.loads(STORED.read_text(encoding="utf-8"))["rows"]
    return found


def beats() -> tuple[Any, Any, Any]:
    """(1/(alpha - 1), c_1, d_1) of the rows near alpha = 1, in doubles."""
    rows = [r for r in stored() if abs(1 / (Fraction(r["alpha"]) - 1)) >= NEAR]
    x = [float(1 / (Fraction(r["alpha"]) - 1)) for r in rows]
    return np.array(x), *(np.array([float(r[name]) for r in rows]) for name in ("c_1", "d_1"))


def fitted(x: Any, values: Any, powers: int, step: float = 1 / 3) -> tuple[Any, Any, float]:
    """a_j, b_j of sum (a_j cos pi x + b_j sin pi x) |x|^(-j step) by least squares, and the largest residual.

    For one side of alpha = 1 at a time: x > 0 or x < 0.
    """
    columns = [
        wave * np.abs(x) ** (-j * step) for wave in (np.cos(np.pi * x), np.sin(np.pi * x)) for j in range(powers)
    ]
    matrix = np.stack(columns, axis=1)
    found = np.linalg.lstsq(matrix, values, rcond=None)[0]
    return found[:powers], found[powers:], float(np.max(np.abs(matrix @ found - values)))


def draw(axes: Any) -> None:
    """Against alpha on the left, against 1/(alpha - 1) on the right with what is expected there."""
    figure = axes.figure
    axes.remove()
    plain, beating = figure.subplots(1, 2)
    alpha = np.array([float(Fraction(r["alpha"])) for r in stored()])
    for name, colour in (("c_1", "#1d4ed8"), ("d_1", "#b91c1c")):
        values = np.array([float(r[name]) for r in stored()])
        for side in (alpha < 1, alpha > 1):
            plain.plot(alpha[side], values[side], ".-", color=colour, linewidth=0.7, markersize=3,
                       label=rf"${name}$" if alpha[side][0] > 1 else None)  # fmt: skip
    plain.axhline(0, color="#6b7280", linewidth=0.8)
    plain.set(xlabel=r"$\alpha$", ylabel="Stokes constant", ylim=(-3.3, 2.7))
    plain.legend(loc="lower right")
    x, c_1, _ = beats()
    line = np.linspace(NEAR, FAR, 600)
    for side, marker, name in ((x > 0, "o", r"$\alpha > 1$"), (x < 0, "s", r"$\alpha < 1$")):
        beating.plot(np.abs(x[side]), c_1[side], marker, markersize=3, label=name)
    beating.plot(line, np.cos(np.pi * line) / np.pi, color="#6b7280", linewidth=0.8, label=r"$\cos(\pi x)/\pi$")
    beating.axhline(0, color="#6b7280", linewidth=0.8)
    beating.set(xlabel=r"$x = 1/|\alpha - 1|$", ylabel=r"$c_1$")
    beating.legend(loc="lower center", bbox_to_anchor=(0.5, 1), ncols=3)


def main() -> None:
    """Write the file."""
    made = [row(alpha) for alpha in grid()]
    origin = {"made by": "python -m paper_checks.report.stokes_curve", "version": __version__, **made_by()}
    lines = ",\n".join(json.dumps(r) for r in made)
    write_atomically(STORED, f'{{"origin": {json.dumps(origin)},\n"rows": [\n{lines}\n]}}\n')


if __name__ == "__main__":
    main()
