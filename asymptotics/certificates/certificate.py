"""A certificate: made of an oscillator and of what was printed of it, checked as a stranger would check it, and kept.

>>> claim = {"kind": "turning point", "number": 1, "digits": 12, "x": "-0.870193291989", "t": "3.14608217222"}
>>> made = certificate(Oscillator({"3/2": "1/10"}), [claim])
>>> made.proved
('turning point 1: x = -0.870193291989 (known to 1e-16) t = 3.14608217222 (known to 1e-16)',)
>>> len(made.to_dict()["pieces"]) < 10 and len(made.to_json()) < 10_000
True
"""

import json
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from math import log2
from pathlib import Path
from typing import Any

from asymptotics.certificates.claims import Claim, error_allowed, exact_time, last_number
from asymptotics.certificates.equation import Equation
from asymptotics.certificates.known import Known, known_before, known_turning_points
from asymptotics.certificates.layout import Landing, Plan, swing
from asymptotics.errors import InputError
from asymptotics.law import Oscillator
from asymptotics.numbers.context import ctx
from asymptotics.numbers.precision import TooWideError, at_growing_precision
from asymptotics.running.budget import DEFAULT_SECONDS, budget
from asymptotics.testing.check_certificate import FORMAT, RefusedError, check

_NOISE = 26  # bits that the second derivatives of rounded coefficients lose, about
_SPARE = 64  # bits more in the series than in the coefficients
_DEGREE = 0.45  # powers of the time for a bit of the error allowed: a choice
_LOG2_10 = log2(10)


@dataclass(frozen=True)
class Certificate:
    """The content of a certificate's file, and what the checker proved of it, a line for each claim."""

    content: dict[str, Any] = field(repr=False)
    proved: tuple[str, ...]

    def to_dict(self) -> dict[str, Any]:
        """The content of the file."""
        return self.content

    def to_json(self) -> str:
        """The file: compact JSON."""
        return json.dumps(self.content, separators=(",", ":"))

    def save(self, path: str | Path) -> None:
        """Write the file, to be checked by ``python check_certificate.py FILE``."""
        Path(path).write_text(self.to_json() + "\n", encoding="utf-8")


def certificate(
    oscillator: Oscillator, claims: Sequence[Claim], *, max_seconds: float = DEFAULT_SECONDS
) -> Certificate:
    """A certificate of claims about a motion in the units of the oscillator, accepted by the checker.

    InputError for what is not served, LimitError for more than ``max_seconds``, UndecidedError with the checker's
    reason where no precision tried makes it accept.
    """
    equation = Equation.read(oscillator)
    _require_bounds_enough(equation, claims)
    with budget(max_seconds):
        allowed = error_allowed(claims, float(equation.stiffness))
        known = _known(oscillator, equation, claims, allowed)

        def attempt(bits: int) -> Certificate:
            content = _content(oscillator, equation, known, claims, bits)
            try:
                return Certificate(content, tuple(check(content)))
            except RefusedError as reason:
                raise TooWideError(f"the checker refuses: {reason}", lacking=32) from None

        bits = int(-allowed) + _NOISE + int(log2(8 + 8 * len(known.points)))
        return at_growing_precision(attempt, max(1, int(-allowed / _LOG2_10)), bits, max_bits=2 * bits + 300)


def _require_bounds_enough(equation: Equation, claims: Sequence[Claim]) -> None:
    """InputError where a place is printed on the very edge of what friction holds, or at 0: no bound tells that."""
    for claim in claims:
        if claim["kind"] == "turning point" and claim["number"] > 0 and claim["x"] is not None:
            place = equation.stiffness * abs(Fraction(claim["x"]))
            if place in (0, equation.friction):
                where = f"turning point {claim['number']} is exactly where friction just holds the mass, or at 0"
                raise InputError("certificate", f"{where}: a bound proves no exact place", "another start or strength")


def _known(oscillator: Oscillator, equation: Equation, claims: Sequence[Claim], allowed: float) -> Known:
    """The turning points that the claims need, to so many digits that nothing is lost by them."""
    last = max((exact_time(claim) for claim in claims if claim["kind"] == "state"), default=Fraction(0))
    turns = float(last) * float(equation.stiffness) ** 0.5
    number = last_number(claims)
    digits = int(-allowed / _LOG2_10) + 12 + len(str(int(turns) + number + 1))
    # No half-swing is shorter than pi.
    count = int(turns / 3) + 1
    return (
        known_before(oscillator, last, count, digits)
        if count > number
        else known_turning_points(oscillator, number + 1, digits)
    )


def _content(
    oscillator: Oscillator, equation: Equation, known: Known, claims: Sequence[Claim], bits: int
) -> dict[str, Any]:
    tolerance = -(bits - _NOISE) - 4.0
    plan = Plan(bits, int(-_DEGREE * tolerance) + 8, tolerance)
    with ctx.workprec(bits + _SPARE):
        pieces = list(_pieces(equation, known, claims, plan))
    return {
        "format": FORMAT,
        "law": [[str(a), str(e)] for a, e in equation.terms],
        "stiffness": str(equation.stiffness),
        "start": [str(equation.x0), str(equation.v0)],
        "bits": bits,
        "root": equation.root,
        "pieces": pieces,
        "claims": list(claims),
    }


def _pieces(equation: Equation, known: Known, claims: Sequence[Claim], plan: Plan) -> Iterable[dict[str, Any]]:
    """Half-swing by half-swing, as far as the claims reach."""
    moments = sorted({exact_time(claim) for claim in claims if claim["kind"] == "state"} - {Fraction(0)})
    last = last_number(claims)
    points: list[Landing | None] = list(known.points) if equation.v0 == 0 else [None, *known.points]
    towards = -(points[0].side if points[0] else -1 if equation.v0 > 0 else 1)
    number = 0 if equation.v0 == 0 else -1  # of the turning point before
    if points[0] is not None and equation.holds(equation.x0):
        return
    for begin, end in zip(points, [*points[1:], None]):
        since = begin.time if begin else Fraction(0)
        wanted = number < last or any(end is not None and t > end.time for t in moments)
        cuts = [t for t in moments if since < t and (end is None or t < end.time)]
        if number == known.sticks or not (wanted or cuts):
            return
        yield from swing(equation, plan, begin, end if wanted else None, cuts, towards)
        towards, number = -towards, number + 1
