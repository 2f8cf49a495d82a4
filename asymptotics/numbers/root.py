"""The root of a monotone function, enclosed about a point near it: by the mean value theorem.

Let f(s) differ from its target by at most D, and 1/f' lie in (0, S] on [s - h, s + h].  There f changes by h/S at least
to either side, so that D S <= h puts the root in that interval.

>>> s = arb(1.4142)                                             # f(s) = s^2 = 2
>>> root = verified_root(s, abs(s * s - 2), lambda x: 1 / (2 * x), [arb(1e-6), arb(1e-4)])
>>> root.contains(arb(2).sqrt().mid()), root.rad() > 9e-5
(True, True)
>>> verified_root(s, abs(s * s - 2), lambda x: 1 / (2 * x), [arb(1e-6)]) is None
True
"""

from collections.abc import Callable, Iterable

from flint import arb


def verified_root(s: arb, distance: arb, speed: Callable[[arb], arb], radii: Iterable[arb]) -> arb | None:
    """The first ball about s, of one of the ``radii``, that is proved to hold the root; or None.

    ``distance`` bounds |f(s) - target|, and ``speed`` encloses ds/df = 1/f' on a ball.
    """
    for half in radii:
        interval = arb(s, half)
        there = speed(interval)
        # S = ``there.upper()`` bounds 1/f' on the whole interval: f
        # moves by half/S >= distance to either side (mean value).
        if there > 0 and distance * there.upper() <= half:
            return interval
    return None
