"""The value of one half-swing at finite strength: correctly rounded digits, enclosures, and how they were found."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from math import inf, nextafter
from typing import Any

from flint import arb

from asymptotics.errors import InputError
from asymptotics.numbers.decimals import bits_for, decimal_of_ball, directed_decimal
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.precision import at_growing_precision
from asymptotics.numbers.rationals import bounds
from asymptotics.numbers.value import Coefficient, number_of
from asymptotics.present.shown import Page, Rows


@dataclass(frozen=True)
class HalfSwingValue:
    """One half-swing: L = ln(q/p), amplitude = q/p and duration as balls; how they were found.

    ``terms``: the number of pieces; ``tail``: the largest bound of what was cut off in L.
    """

    log_ratio: arb
    amplitude: arb
    duration: arb
    route: str
    terms: int
    tail: arb


Evaluate = Callable[[int], HalfSwingValue]
# A route is asked for 32 bits less than are set, for it loses some; after two doublings it is given up as undecided.
_TRIES, _GUARD = 3, 32


@dataclass(frozen=True, repr=False)
class HalfSwingAt(Rows):
    """A'/A (``amplitude``), L = ln(A'/A) (``log_ratio``) and the duration T of one half-swing, in units of 1/omega_0.

    ``forces``: the terms in words where one of them is a spring or depends on the place, in the order of ``delta``.
    ``enclosures``: for each of the three a pair of decimals that hold the number between them; ``terms``: what the
    route counts; ``tail``: the bound of what was cut off in L, rounded up.
    """

    alphas: tuple[str, ...]
    delta: tuple[str, ...]
    digits: int
    log_ratio: str
    amplitude: str
    duration: str
    enclosures: dict[str, tuple[str, str]]
    route: str
    terms: int
    tail: str
    certified: bool
    forces: tuple[str, ...] = ()
    notes: tuple[str, ...] = field(default=(), compare=False)

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready: numbers are strings."""
        one = len(self.alphas) == 1
        numbers = {n: {"value": getattr(self, n), "enclosure": list(self.enclosures[n])} for n in self.enclosures}
        head = {
            "alpha": self.alphas[0] if one else list(self.alphas),
            "delta": self.delta[0] if one else list(self.delta),
        }
        rest = {"route": self.route, "terms": self.terms, "tail": self.tail, "certified": self.certified}
        named = {"forces": list(self.forces)} if self.forces else {}
        return {**head, **named, "digits": self.digits, **numbers, **rest}

    def __repr__(self) -> str:
        law, strength = ", ".join(self.alphas), ", ".join(self.delta)
        status = "certified" if self.certified else "not certified"
        numbers = f"A'/A = {self.amplitude}, T = {self.duration} ({status})"
        if self.forces:
            return f"half-swing of {', '.join(self.forces)} at delta = {strength}: {numbers}"
        return f"half-swing of alpha = {law} at delta = {strength}: {numbers}"

    def number(self, name: str = "amplitude") -> Coefficient:
        """``amplitude``, ``log_ratio`` or ``duration`` as a number: mpf, interval, ball."""
        return number_of(self, name)

    def _page(self) -> Page:
        named = (("A'/A", "amplitude"), ("L = ln(A'/A)", "log_ratio"), ("T omega_0", "duration"))
        rows = tuple((text, getattr(self, name), *self.enclosures[name]) for text, name in named)
        worth = f"{'certified' if self.certified else 'not certified'}, {self.digits} digits ({self.route})"
        return Page(repr(self), (worth, *self.notes), ("", "value", "at least", "at most"), rows)

    def _table(self) -> dict[str, list[Any]]:
        names = ("amplitude", "log_ratio", "duration")
        ends = [[float(Fraction(self.enclosures[n][i])) for n in names] for i in (0, 1)]
        # float() takes the nearest double, which may lie within: one step outward does not.
        outward = [[nextafter(x, side) for x in row] for row, side in zip(ends, (-inf, inf))]
        texts = [str(getattr(self, n)) for n in names]
        return {"name": list(names), "value": ends[0], "value_low": outward[0],
                "value_high": outward[1], "value_digits": texts}  # fmt: skip

    def _formula(self) -> str:
        return rf"A'/A = {self.amplitude},\quad T = {self.duration}"

    def _letters(self) -> dict[str, str]:
        return {"A": "turning amplitude, A' the next one", "T": "duration, in units of 1/omega_0"}


def require_strengths(alphas: Sequence[ExactReal], delta: Sequence[ExactReal]) -> None:
    """InputError unless there is one strength >= 0 for each law."""
    if len(delta) != len(alphas):
        raise InputError("delta", f"{len(delta)} strengths for {len(alphas)} laws", "one strength for each law")
    for d in delta:
        if d < 0:
            raise InputError("delta", f"{d} is negative: anti-damping", "strengths >= 0")


def certified_swing(
    alphas: Sequence[ExactReal], delta: Sequence[ExactReal], digits: int, evaluate: Evaluate
) -> HalfSwingAt:
    """The result of a route: ``evaluate(bits)`` is called at growing precision until all digits are decided."""

    def attempt(bits: int) -> HalfSwingAt | None:
        swing = evaluate(bits - _GUARD)
        balls = {"log_ratio": swing.log_ratio, "amplitude": swing.amplitude, "duration": swing.duration}
        L, q, T = (decimal_of_ball(ball, digits) for ball in balls.values())
        if L is None or q is None or T is None:
            return None
        enclosures = {name: enclosure(ball, digits) for name, ball in balls.items()}
        law, strength, tail = tuple(map(str, alphas)), tuple(map(str, delta)), rounded_up(swing.tail)
        return HalfSwingAt(law, strength, digits, L, q, T, enclosures, swing.route, swing.terms, tail, True)

    bits = bits_for(digits, 24) + _GUARD + _faint(delta)
    return at_growing_precision(attempt, digits, bits, max_bits=bits << (_TRIES - 1))


def enclosure(ball: arb, digits: int) -> tuple[str, str]:
    """Two decimals with the ball between them, ``digits`` + 5 significant digits each, rounded outwards.

    >>> enclosure(arb(1) / 3, 3)
    ('0.33333333', '0.33333334')
    """
    low, high = bounds(ball)
    return directed_decimal(low, digits + 5, -1), directed_decimal(high, digits + 5, 1)


def rounded_up(x: arb, digits: int = 2) -> str:
    """A decimal of ``digits`` digits that is at least every |number| of the ball.

    >>> rounded_up(arb("0.0123")), rounded_up(arb(0))
    ('0.013', '0')
    """
    return directed_decimal(max(abs(end) for end in bounds(x)), digits, 1)


def _faint(delta: Sequence[ExactReal]) -> int:
    """Bits of 1 that the largest strength, and so L, lies below."""
    sizes = [abs(d.ball()).mid().man_exp() for d in delta if not d.is_zero]
    return max(0, -max((int(mantissa.bit_length() + exponent) for mantissa, exponent in sizes), default=0))
