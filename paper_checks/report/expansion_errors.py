"""How good each order is, and what is proved about it: error, estimate and bound at one moment, as stored data.

    python -m paper_checks.report.expansion_errors

computes ``expansion_errors.json`` beside this file anew (a few minutes).  Laws of equal strengths epsilon/n, start at
rest at X = 1.  Per order N at tau = 20: the error |X - X_N| against certified digits of the motion, the estimate that
``motion`` prints, and the proved bound.  For all turning points at once, where every alpha >= 1: the bound of
|ln A_n - ln A^_n|; for alpha < 1 that of |A_n - A^_n| up to the n that is stated.  For all times at once: the bound of
|X - X_N| for every tau >= 0, with an exponent below 1 up to tau = 20.
"""

import json
from collections.abc import Iterator
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import Any

from flint import arb

from asymptotics import __version__
from asymptotics.bounds.motion import proved_bound
from asymptotics.bounds.turning import turning_bounds
from asymptotics.bounds.turning_sequence import turning_sequence_bounds
from asymptotics.bounds.uniform import uniform_bound
from asymptotics.errors import LimitError
from asymptotics.law import Oscillator
from asymptotics.made_by import made_by
from asymptotics.motions.asymptotic import AsymptoticMotion
from asymptotics.motions.reference import reference_motion
from asymptotics.numbers.decimals import directed_decimal
from asymptotics.numbers.exact import ExactReal, parse_real
from asymptotics.numbers.rationals import bounds
from asymptotics.present.files import write_atomically

STORED = Path(__file__).with_name("expansion_errors.json")
LAWS = (("1/2",), ("3/2",), ("2",), ("5/2",), ("3",), ("0", "1"), ("1", "2"), ("1", "3"))
EPSILONS, ORDERS, TIME = ("1/100", "1/50", "1/20", "1/10"), range(1, 7), 20


def row(laws: tuple[str, ...], epsilon: str, order: int) -> dict[str, str]:
    """One row of the table, as text."""
    share = Fraction(epsilon) / len(laws)
    oscillator = Oscillator(dict.fromkeys(laws, share))
    point = AsymptoticMotion.of(oscillator, order).at(TIME, 20)
    error = abs(Fraction(point.x) - Fraction(reference_motion(oscillator, TIME, 30).x))
    return {
        "alpha": ", ".join(laws),
        "epsilon": epsilon,
        "order": str(order),
        "error": f"{Decimal(float(error)):.1e}",
        "estimate": _short(point.error),
        "bound": _short(proved_bound(oscillator, point.x, TIME)),
        "all turning points": _everywhere([parse_real(a, "alpha") for a in laws], order, share),
        "all times": _always(oscillator, order),
    }


def _always(oscillator: Oscillator, order: int) -> str:
    """The proved bound of |X - X_N| for every tau >= 0, for alpha < 1 up to ``TIME``."""
    growing = any(term.velocity < 1 for term in oscillator.law.terms)
    try:
        found = uniform_bound(oscillator, order, until=TIME if growing else None)
    except LimitError:
        return "out of range"
    return _short(found.bound) + (f", tau up to {TIME}" if growing else "")


def _everywhere(alphas: list[ExactReal], order: int, share: Fraction) -> str:
    """The proved bound of the amplitude at all turning points, or up to the last one that the theorem reaches."""
    each = [arb(share.numerator) / share.denominator] * len(alphas)
    try:
        if all(a >= 1 for a in alphas):
            found = turning_bounds(alphas, order, each)
            whole = found.log_amplitude(None)
            return _up(whole) if whole.is_finite() else f"{_up(found.log_amplitude(1))} n"
        *_, last = turning_sequence_bounds(alphas, order, each)
    except LimitError:
        return "out of range"
    return f"{_up(last.amplitude)}, n up to {last.n}" if last.n else "out of range"


def _up(x: arb) -> str:
    return _short(directed_decimal(max(bounds(x)), 2, 1))


def _short(text: str) -> str:
    """Two digits stay two digits: nothing is rounded here."""
    return f"{Decimal(text):.1e}"


def rows() -> Iterator[dict[str, str]]:
    """All rows, computed."""
    for laws in LAWS:
        for epsilon in EPSILONS:
            for order in ORDERS:
                yield row(laws, epsilon, order)


def stored() -> list[dict[str, str]]:
    """The rows of the file; a test computes a sample of them again."""
    found: list[dict[str, str]] = json.loads(STORED.read_text(encoding="utf-8"))["rows"]
    return found


def main() -> None:
    """Write the file."""
    made = list(rows())
    origin: dict[str, Any] = {
        "made by": "python -m paper_checks.report.expansion_errors",
        "version": __version__,
        **made_by(),
    }
    lines = ",\n".join(json.dumps(r, ensure_ascii=False) for r in made)
    write_atomically(STORED, f'{{"origin": {json.dumps(origin)},\n"rows": [\n{lines}\n]}}\n')


if __name__ == "__main__":
    main()
