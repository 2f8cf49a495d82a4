"""A certificate: made of an oscillator and of what was printed of it, checked as a stranger would check it, and kept.

>>> claim = {"kind": "turning point", "number": 1, "digits": 12, "x": "-0.870193291989", "t": "3.14608217222"}
>>> made = certificate(Oscillator({"3/2": "1/10"}), [claim])
>>> print(*made.proved, sep="\\n")
x'' + 1 x + 1/10 sgn(x')|x'|^(3/2) = 0, x(0) = 1, x'(0) = 0
turning point 1: x = -0.870193291989 (known to 1e-16) t = 3.14608217222 (known to 1e-16)
>>> len(made.content[0]["pieces"]) < 10 and len(made.to_json()) < 10_000
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
from asymptotics.errors import InputError, LimitError
from asymptotics.law import Oscillator
from asymptotics.numbers.context import ctx
from asymptotics.numbers.precision import TooWideError, at_growing_precision
from asymptotics.present.files import target_file, write_all
from asymptotics.present.shown import Page, Shown
from asymptotics.running.budget import DEFAULT_SECONDS, budget
from asymptotics.testing import check_certificate
from asymptotics.testing.check_certificate import FORMAT, RefusedError, check

CHECKER = Path(check_certificate.__file__)
_NOISE = 26  # bits that the second derivatives of rounded coefficients lose, about
_SPARE = 64  # bits more in the series than in the coefficients
_DEGREE = 0.45  # powers of the time for a bit of the error allowed: a choice
_LOG2_10 = log2(10)
MOST_TOGETHER = 1000
"""Equations in one file: what the checker takes."""


@dataclass(frozen=True, repr=False)
class Certificate(Shown):
    """What is in a certificate's file, and what the checker says: equations with their starts, a line for each claim.

    ``content``: an object for each equation; ``left``: what was printed beside and is not claimed, with the reason.
    """

    content: tuple[dict[str, Any], ...] = field(hash=False)
    proved: tuple[str, ...]
    left: tuple[str, ...] = ()

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready: the content of the file, what was proved, and what is left."""
        return {"content": self._whole(), "proved": list(self.proved), "left": list(self.left)}

    def to_json(self) -> str:
        """The file: compact JSON."""
        return json.dumps(self._whole(), separators=(",", ":"))

    def _whole(self) -> Any:
        # A list is what the checker takes for several equations.
        return self.content[0] if len(self.content) == 1 else list(self.content)

    def save(self, path: str | Path) -> None:
        """Write the file, and ``check_certificate.py`` beside it: ``python check_certificate.py FILE`` proves it."""
        file = target_file(str(path), "path")
        write_all(
            {file: self.to_json() + "\n", file.with_name(CHECKER.name): CHECKER.read_text(encoding="utf-8")}, "path"
        )

    def _page(self) -> Page:
        claims = sum(len(each["claims"]) for each in self.content)
        left = tuple(f"not in it: {line}" for line in self.left)
        title = (
            f"a certificate of {claims} claims, {len(self.to_json()) / 1000:.0f} kB: "
            "proved, for check_certificate.py accepts it"
        )
        return Page(title, left, ("proved",), tuple((line,) for line in self.proved))


def together(made: Sequence[Certificate], left: Iterable[str] = ()) -> Certificate:
    """One file for all of them, and what is left; InputError for none, with the reasons.

    >>> together([], ["the law 1:sqrt(2): its strength is not rational"])
    Traceback (most recent call last):
        ...
    asymptotics.errors.InputError: argument certificate: the law 1:sqrt(2): its strength is not rational ...
    """
    reasons = (*(line for one in made for line in one.left), *left)
    if not made:
        reason = "; ".join(reasons) or "nothing in it is a turning point, a time or a state"
        raise InputError("certificate", reason, "certified turning points and states at times")
    content = tuple(each for one in made for each in one.content)
    if len(content) > MOST_TOGETHER:
        raise LimitError("certificate", f"{len(content)} equations are too many", f"{MOST_TOGETHER} in one file")
    return Certificate(content, tuple(line for one in made for line in one.proved), reasons)


def certificate(
    oscillator: Oscillator, claims: Sequence[Claim], *, max_seconds: float = DEFAULT_SECONDS
) -> Certificate:
    """A certificate of claims about a motion in the units of the oscillator, accepted by the checker.

    InputError for what is not served, LimitError for more than ``max_seconds``, UndecidedError with the checker's
    reason where no precision tried makes it accept.
    """
    equation = Equation.read(oscillator)
    claims, left = _that_bounds_tell(equation, claims)
    with budget(max_seconds):
        allowed = error_allowed(claims, float(equation.stiffness))
        known = _known(oscillator, equation, claims, allowed)

        def attempt(bits: int) -> Certificate:
            content = _content(oscillator, equation, known, claims, bits)
            try:
                return Certificate((content,), tuple(check(content)), tuple(left))
            except RefusedError as reason:
                raise TooWideError(f"the checker refuses: {reason}", lacking=32) from None

        bits = int(-allowed) + _NOISE + int(log2(8 + 8 * len(known.points)))
        return at_growing_precision(attempt, max(1, int(-allowed / _LOG2_10)), bits, max_bits=2 * bits + 300)


def _that_bounds_tell(equation: Equation, claims: Sequence[Claim]) -> tuple[list[Claim], list[str]]:
    """The claims without places that are 0 and stops on the very edge of what friction holds, and these in words."""
    kept, left = list[Claim](), list[str]()
    for claim in claims:
        place = equation.exact_place(claim["number"]) if claim.get("number", 0) > 0 else None
        if claim["kind"] == "turning point" and place == 0:
            left.append(f"turning point {claim['number']}: x = 0 exactly, which no bound tells")
            claim = {**claim, "x": None}
        if claim["kind"] == "rest" and place is not None and equation.stiffness * abs(place) == equation.friction:
            left.append(f"turning point {claim['number']}: friction just holds the mass there, which no bound tells")
            continue
        kept.append(claim)
    return kept, left


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
