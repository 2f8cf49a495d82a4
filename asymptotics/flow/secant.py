"""The turning point that an orbit runs into, nearly: the secant method in growing precision (a guess, proves nothing).

The slope through two misses of relative size 2^-j and 2^-k, j < k, is right to j bits, and with p bits to p - j, as its
noise is 2^(j-p).  The next guess is right to k + min(j, p - j) bits; its own miss is worth as many, and k more for the
slope after it.  The order is the golden ratio, and all steps together cost little more than the last.

>>> with ctx.workprec(200):
...     root = secant(lambda y: y * y - 2, arb("1.5"), arb("1.4"))
...     abs(root - arb(2).sqrt()) < arb(2) ** -195
True
"""

from collections.abc import Callable
from typing import TypeVar

from flint import arb

from asymptotics.flow.balls import size_of
from asymptotics.flow.times import NearRest
from asymptotics.numbers.context import ctx

# Starts in 53 bits, below which nothing gets cheaper.  With the order 1.6 ten steps lead from one bit to 100 and twenty
# to 10^4; after forty the last guess is handed over, however good it is.
_FIRST, _MOST = 53, 40
_NOISE = 25
"""Bits by which a miss is computed beyond its own size, at least."""


Expansion = TypeVar("Expansion", bound=NearRest)


def through(ending: Callable[[arb], Expansion], goal: arb, w: arb, first: arb) -> Expansion:
    """``ending`` at the turning point, near ``first``, whose orbit nearly passes ``goal`` at the speed w."""
    # The expansion is made anew at the final guess, so that what is returned encloses its own orbit: the miss that is
    # left is computed from it by the caller (derivation ``arrival``).
    return ending(secant(lambda turn: ending(turn).state(w)[0] - goal, goal, first))


def secant(miss: Callable[[arb], arb], start: arb, first: arb) -> arb:
    """A dyadic y with ``miss(y)`` = 0 to about the working precision, near ``first``; the slope is about 1.

    ``start`` is another place: its distance from ``first`` says how far the second guess may lie from the first.
    """
    full, bits = ctx.prec, min(_FIRST, ctx.prec)
    with ctx.workprec(bits):
        a, size = first.mid(), max(size_of(start), size_of(first))
        miss_a = miss(a).mid()
        # A step with the slope 1, and a little farther: the slope from two misses is lost in noise, 2^-53 of the size,
        # if they are too near, and in the curvature if they are too far apart.  2^-18 decides how many steps are taken,
        # and nothing else.
        b = (a - miss_a - abs(a - start) * arb(2) ** -18).mid()
    slope, worth, noise_a = arb(1), 1.0, size - bits
    for _ in range(_MOST):
        with ctx.workprec(bits):
            miss_b, noise = miss(b).mid(), size - bits
            # How many bits of a slope from these two would be right: what the noise leaves of the misses, and what the
            # curvature leaves, as in the module's docstring.  It replaces a slope that is worth less.
            larger = max(size_of(miss_a), size_of(miss_b))
            said = min(larger - max(noise, noise_a), size - larger)
            if miss_b != miss_a and a != b and said > worth:
                slope, worth = ((miss_b - miss_a) / (b - a)).mid(), said
            following = (b - miss_b / slope).mid()
        # So many bits of the guess b are right, since the slope is about 1; the next guess has those of the slope more.
        right = min(size - size_of(miss_b), bits)
        a, b, miss_a, noise_a = b, following, miss_b, noise
        if bits == full and (miss_b == 0 or right + worth > full):
            break
        # Enough for the next miss to be seen at its own size, with as many bits again for the slope after it.
        bits = int(min(full, max(bits, right + worth + max(_NOISE, right))))
    with ctx.workprec(full + 4):
        return (b + 0).mid()
