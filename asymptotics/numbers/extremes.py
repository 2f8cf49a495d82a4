"""The greatest and the least of several balls, as balls: a double may not choose what enters a bound.

The midpoints of two balls may be the same double, or in the wrong order, while the numbers differ; arb's own maximum
holds the maximum of every choice of numbers in the balls.

>>> from asymptotics.numbers.context import ctx
>>> with ctx.workprec(200):
...     near = [arb(1), 1 + arb(10) ** -40]
...     max(near, key=float) == near[0], bool(greatest(near) > 1), least(near) == near[0]
(True, True, True)
>>> greatest([]), greatest([arb(3, 1), arb(3)]).contains(4)
(0, True)
"""

from collections.abc import Iterable
from functools import reduce

from flint import arb


def greatest(values: Iterable[arb]) -> arb:
    """The ball of the greatest of ``values`` >= 0; 0 without any."""
    return reduce(arb.max, values, arb(0))


def least(values: Iterable[arb]) -> arb:
    """The ball of the least; infinite without any."""
    return reduce(arb.min, values, arb.pos_inf())
