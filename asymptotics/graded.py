"""Power series by degree: each homogeneous part is a mapping of exponents, and every degree needs only lower ones.

A recurrence in the local strengths knows its series degree by degree, so that a product, a power or a sum is asked for
at one degree n at a time.  The coefficients are of any ring: rationals, balls, polynomials, functions on a grid.

>>> f = [{(0,): 1}, {(1,): 2}, {(2,): 3}]                       # 1 + 2 d + 3 d^2
>>> product_part(f, f, 2), summed(f[1], f[1])
({(2,): 10}, {(1,): 4})
>>> from flint import fmpq
>>> power_part(f, [{(0,): fmpq(1)}, {(1,): fmpq(1)}], fmpq(1, 2), 2)     # the square root is 1 + d + d^2 + ...
{(2,): 1}
"""

from collections.abc import Iterable, Sequence
from itertools import accumulate as accumulated
from operator import mul
from typing import Any

from asymptotics.series import Key, accumulate

Part = dict[Key, Any]


def summed(*parts: Part) -> Part:
    """The sum of parts."""
    total = dict(parts[0])
    for part in parts[1:]:
        for k, x in part.items():
            total[k] = total[k] + x if k in total else x
    return total


def product_part(left: Sequence[Part], right: Sequence[Part], n: int) -> Part:
    """Degree n of a product."""
    total: Part = {}
    for j in range(n + 1):
        accumulate(total, left[j].items(), right[n - j].items())
    return total


def power_part(g: Sequence[Part], power: Sequence[Part], a: Any, n: int) -> Part:
    """Degree n of g^a from n y_n = sum_(j=1..n) (a j - (n - j)) g_j y_(n-j), g_0 = 1; a g_j that is not there is 0."""
    total: Part = {}
    for j, part in enumerate(g[1 : n + 1], 1):
        accumulate(total, [(k, x * (a * j - (n - j))) for k, x in part.items()], power[n - j].items())
    return {k: x / n for k, x in total.items()}


class WholePowers:
    """The powers 0, 1, ... of a factor by degree, each through the degree at which a member of the forces needs it."""

    def __init__(self, one: Any, base: Any, zero: Key, used: Iterable[tuple[int, int]], order: int) -> None:
        """``base``: the factor at degree 0; ``used``: the exponent and the degree of each member, up to ``order``."""
        pairs = [*used]
        top = max([1, *(e for e, _ in pairs)])
        # The power k stands in the members whose exponent is at least k; with a
        # strength of degree n in front a member needs it through ``order`` - n.
        self._need = [order - min((n for e, n in pairs if e >= k), default=order) for k in range(top + 1)]
        leading = accumulated([base] * top, mul, initial=one)
        self.parts: list[list[Part]] = [[{zero: x}] for x in leading]

    def extend(self, newest: Part) -> None:
        """Append the next degree, of which the factor itself has ``newest``."""
        first = self.parts[1]
        n = len(first)
        first.append(newest)
        self.parts[0].append({})
        for k in range(2, len(self.parts)):
            # A list that is not needed further simply ends: nobody asks for its later degrees.
            if n <= self._need[k]:
                self.parts[k].append(product_part(self.parts[k - 1], first, n))


def monomial_part(X: WholePowers, m: int, Y: WholePowers, v: int, n: int) -> Part:
    """Degree n of X^m Y^v."""
    if not m or not v:
        return (X.parts[m] if m else Y.parts[v])[n]
    return product_part(X.parts[m], Y.parts[v], n)
