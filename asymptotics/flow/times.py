"""Times are added exactly, and the state at a time next to a turning point is enclosed.

A local expansion gives the place and the time in powers of the speed.  Its state at a given time s is found by
Newton's method in the speed, in midpoints: a choice.  What is left of the time, s - tau(w), is then a distance: the
motion moves at most that long at the rates which the expansion bounds (``moved``).

>>> from flint import ctx
>>> with ctx.workprec(60):
...     exact_sum(arb(2) ** 100, arb(2) ** -100) > arb(2) ** 100
True
"""

from typing import Protocol

from flint import arb

from asymptotics.errors import LimitError
from asymptotics.flow.balls import size_of
from asymptotics.numbers.context import ctx

_LONGEST = 2.0**24  # bits of a time: 2 megabytes, reached where w^alpha hardly depends on w
_GUARD = 160  # bits more than the two times are apart: a further step, short or long, is added exactly as well


class NearRest(Protocol):
    """A local expansion at a turning point, in powers of the speed up to ``reach``."""

    @property
    def reach(self) -> arb:
        """The largest speed at which the expansion is used."""

    @property
    def gathered(self) -> "NearRest":
        """The same, as is cheapest where many speeds are looked at, at the current precision."""

    def state(self, w: arb, /) -> tuple[arb, arb]:
        """(place, tau) at the speed 0 <= w <= reach."""

    def acceleration(self, place: arb, w: arb, /) -> arb:
        """dw/dt at a place and a speed."""

    def moved(self, wait: arb, /) -> tuple[arb, arb]:
        """How far place and speed move at most in the time |wait|."""


def at_time(expansion: NearRest, s: arb) -> tuple[arb, arb]:
    """(place, speed) at the time s (a ball) from the turning point of an expansion, within its reach."""
    expansion = expansion.gathered
    # Any w with tau(w) known would do; the nearer tau(w) is to s, the less the motion moves in what is left.
    w = _speed_at(expansion, s.mid())
    place, tau = expansion.state(w)
    # |s - tau| at the largest rates on both sides of the turning point, as s may lie on the other side of it.
    far, faster = expansion.moved(s - tau)
    return place + arb(0, far), w + arb(0, faster)


def _speed_at(expansion: NearRest, s: arb) -> arb:
    """w with tau(w) near s; a choice."""
    full, known = ctx.prec, 0
    rest, _ = expansion.state(arb(0))
    w = min(expansion.reach, abs(s * expansion.acceleration(rest, arb(0))).mid())
    while known < full:
        bits = min(full, max(30, 2 * known))
        with ctx.workprec(bits):
            # Newton's method: the derivative of tau by w is 1/acceleration.  Three steps from a guess that is right to
            # a few bits, then one for twice as many bits at a time.
            for _ in range(3 if known == 0 else 1):
                place, tau = expansion.state(w)
                step = (tau - s) * expansion.acceleration(place, w)
                w = abs((w - step).mid())
                # Beyond its reach the expansion has no bound; below 0 it has none either, and |w| is the mirrored
                # state.
                w = w if w < expansion.reach else expansion.reach
        known = bits if known else 20
    return w


def later(t: arb, length: arb) -> arb:
    """t + length of two exact numbers, exactly: a short step after a long time must not be lost.

    LimitError where the sum would have too many bits.
    """
    apart = max(0.0, size_of(t) - size_of(length))
    # A step 2^-(2^24) times as long as the time before it: the sum would fill megabytes.  It is met for exponents next
    # to 0 alone.
    if apart > _LONGEST:
        reason = f"a step next to rest would last 2^{size_of(length):.3g}: an exponent is too near 0"
        raise LimitError("alpha", reason, "larger exponents, or another strength")
    with ctx.workprec(_GUARD + int(apart) + t.bits()):
        return t + length


def exact_sum(a: arb, b: arb) -> arb:
    """a + b of two exact numbers of any signs and sizes, exactly."""
    if a == 0 or b == 0:
        return a if b == 0 else b
    # The bits of both, and of the gap between them: the sum of two dyadic numbers is exact in so many.
    with ctx.workprec(a.bits() + b.bits() + int(abs(size_of(a) - size_of(b))) + 8):
        return a + b
