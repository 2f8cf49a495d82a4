"""Until when |x - x_N| is proved to stay below a size that the user states: a theorem for all times, asked by time.

The bound up to ``until`` grows with ``until``, hence bisection; every time that is handed out was itself proved.

>>> drag = uniform_theorem(Oscillator({"2": "1/10"}), 3)
>>> reach_within(drag, "1/1000"), reach_within(drag, "1/10000000")
(|x - x_N| <= 1/1000 for ever: proved, |x - x_N| <= 1/10000000 for 0 <= t <= 0: not proved)
"""

from collections.abc import Callable
from fractions import Fraction
from typing import NamedTuple

from asymptotics.bounds.uniform import uniform_bound
from asymptotics.errors import InputError, LimitError, UndecidedError
from asymptotics.law import Oscillator
from asymptotics.numbers.exact import parse_rational
from asymptotics.numbers.policy import Number, exact_number
from asymptotics.present.shown import Page, Shown

# Twelve bisections are three digits of a time; the bound at the end that is stated was computed itself.
_STEPS = 12


class _Ends(NamedTuple):
    until: str
    size: str
    label: str


class Reach(Shown, _Ends):
    """|x - x_N| <= ``size`` for 0 <= t <= ``until`` ("oo": for ever; "0": nothing proved), in the motion's units."""

    __slots__ = ()

    def _page(self) -> Page:
        end = "for ever" if self.until == "oo" else f"for 0 <= t <= {self.until}"
        return Page(f"|x - x_N| <= {self.size} {end}: {self.label}")

    def _formula(self) -> str:
        end = r"\infty" if self.until == "oo" else self.until
        return rf"|x - x_{{n}}| \le {self.size},\quad 0 \le t \le {end}\ \text{{({self.label})}}"


Theorem = Callable[[Number | None], Reach]


def uniform_theorem(oscillator: Oscillator, order: int) -> Theorem:
    """The theorem of ``uniform``, for x_N of the truncated equations."""

    def theorem(until: Number | None) -> Reach:
        found = uniform_bound(oscillator, order, until=until)
        return Reach(found.until or "oo", found.bound, "proved")

    return theorem


def reach_within(theorem: Theorem, size: Number) -> Reach:
    """How long x_N, before rounding, is proved within ``size`` by a theorem; InputError for a size <= 0."""
    wanted = exact_number(size, "within")
    if not wanted > 0:
        raise InputError("within", f"{wanted} is no size", "a number > 0 in the units of x")
    end = _until(theorem, wanted)
    return Reach(end or "0", str(wanted), "proved" if end else "not proved")


def _until(theorem: Theorem, wanted: Number) -> str | None:
    """The latest time found, "oo" for ever; None for none."""

    def proved(until: Fraction | None) -> str | None:
        """The time up to which this bound, small enough, was proved."""
        try:
            found = theorem(until)
        except (LimitError, UndecidedError):
            return None
        return found.until if parse_rational(found.size, "bound") <= wanted else None

    if (end := proved(None)) is not None:
        return end
    low, high = Fraction(0), Fraction(1)
    # A million units of time and no end: a bisection finds the last power of two that is proved.
    while high < 2**20 and proved(high):
        low, high = high, 2 * high
    for _ in range(_STEPS):
        middle = (low + high) / 2
        low, high = (middle, high) if proved(middle) else (low, middle)
    return str(low) if low else None
