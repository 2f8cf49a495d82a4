"""The turning points of an equation as they are known beforehand, to many digits: what the polynomials are fitted to.

>>> from asymptotics.law import Oscillator
>>> known = known_turning_points(Oscillator({2: 1}, x0=2), 2, 12)
>>> [(p.place.str(8, radius=False), p.time) for p in known.points][0], known.points[1].place.str(8, radius=False)
(('2.0000000', Fraction(0, 1)), '-0.48255712')
"""

from dataclasses import dataclass
from fractions import Fraction

from flint import arb

from asymptotics.certificates.layout import Landing, landing
from asymptotics.errors import LimitError, UndecidedError
from asymptotics.law import Oscillator
from asymptotics.numbers.context import ctx
from asymptotics.numbers.decimals import bits_for
from asymptotics.numbers.digits import ball_of
from asymptotics.numbers.exact import ExactReal, square_root
from asymptotics.running.budget import seconds_left
from asymptotics.turning.choose import turning_points


@dataclass(frozen=True)
class Known:
    """Turning points from number 0 on; ``sticks``: the number of the one at which dry friction holds the mass."""

    points: tuple[Landing, ...]
    sticks: int | None


def known_before(oscillator: Oscillator, t: Fraction, count: int, digits: int) -> Known:
    """At most so many, up to the first one after the time t, as far as they are found: the next one may be far off."""
    try:
        return known_turning_points(oscillator, count, digits)
    except (LimitError, UndecidedError):
        with ctx.workprec(bits_for(digits, 64)):
            start = landing(arb(0), oscillator.x0.ball(), 1)
        known = Known((start,) if oscillator.v0.is_zero else (), None)
    # One more each time, until the time is passed or the next one is refused.
    for more in range(1, count + 1):
        if known.points and known.points[-1].time > t:
            break
        try:
            known = known_turning_points(oscillator, more, digits)
        except (LimitError, UndecidedError):
            break
    return known


def known_turning_points(oscillator: Oscillator, count: int, digits: int) -> Known:
    """At most so many, with times since the start, in the units of the oscillator."""
    (x0, v0), seconds = unit_start(oscillator), min(seconds_left(), 1e9) / 3
    law = oscillator.dimensionless
    found = turning_points(law, count, digits, times=True, x0=x0, v0=v0, max_seconds=seconds)
    bits = bits_for(digits, 64)
    with ctx.workprec(bits):
        omega, length, first = oscillator.omega_0(), oscillator.length(), arb(0)
        if found.first is not None:
            length, first = length * ball_of(found.first["amplitude"]), ball_of(found.first["tau"])
        elif oscillator.x0 < 0:
            length = -length
        points = []
        for p in found.points:
            x = arb(1 if p.x.startswith("1") else -1) if p.n == 0 else ball_of(p.x)
            tau = arb(0) if p.n == 0 or p.tau is None else ball_of(p.tau)
            points.append(landing((first + tau) / omega, x * length, bits))
    ended = found.ended or {}
    return Known(tuple(points), ended["n"] if ended.get("reason") == "sticks" else None)


def unit_start(oscillator: Oscillator) -> tuple[ExactReal, ExactReal]:
    """The start in units of the radius sqrt(x0^2 + v0^2/omega_0^2), one at rest on the right."""
    x0, v0 = oscillator.x0, oscillator.v0
    if v0.is_zero:
        return ExactReal(1), v0
    ratio = oscillator.mass / oscillator.stiffness
    square = (x0 * x0 + ratio * v0 * v0).rational
    return x0 / square_root(square), v0 * square_root(ratio.rational / square)
