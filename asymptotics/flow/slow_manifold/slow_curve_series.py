"""The slow curve of a creeping motion as a sum of powers of the speed, cut off, and what the cut leaves.

A formal (divergent) series of the slow manifold; what is left out is a residual of finitely many powers.

With epsilon and alpha those of the least exponent alpha < 1, N(w) = epsilon w^alpha (1 + R) and R = sum_i r_i w^(d_i),
d_i = alpha_i - alpha, over the other laws, the slow curve is y = N(w) - epsilon w^alpha B with

    A B = w^(2-2 alpha)/epsilon^2,    A = alpha + sum_i alpha_i r_i w^(d_i) - sum_j (alpha + e_j) b_j w^(e_j)

for B = sum_j b_j w^(e_j), a divergent series in products of w^(2-2 alpha) and the w^(d_i) (derivation ``slow-curve``).

>>> from fractions import Fraction
>>> root = truncated(Damping.of([(arb(1), ExactReal(Fraction(1, 2)))]), 0, 3)
>>> [(b.str(6, radius=False), e.str(3, radius=False)) for b, e in root.b]
[('2.00000', '1.00'), ('12.0000', '2.00'), ('192.000', '3.00')]
"""

from dataclasses import dataclass
from itertools import product
from math import ceil
from operator import add, mul, sub
from typing import Any

from flint import arb

from asymptotics.flow.balls import upper
from asymptotics.flow.damping import Damping
from asymptotics.numbers.context import ctx, lru_cache
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.extremes import least

# The residual takes the product of each with each, 40,000 of them.  A series of more is refused, and the motion goes on
# by steps.
MOST = 200  # powers of a curve

Power = tuple[arb, arb]  # coefficient and exponent
Key = tuple[int, ...]  # how often w^(2-2 alpha) and the w^(d_i) are factors


@dataclass(frozen=True)
class Truncated:
    """``others``: the r_i and d_i; ``b``: the powers of B below w^``cut``; ``neglected``: those that
    A B - w^(2-2 alpha)/epsilon^2 has from there on, with the absolute values of their coefficients."""

    epsilon: arb
    alpha: arb
    others: tuple[Power, ...]
    b: tuple[Power, ...]
    cut: arb
    neglected: tuple[Power, ...]


def summed(powers: tuple[Power, ...] | list[Power], log_w: arb) -> arb:
    """The sum of all c w^e of the powers (c, e)."""
    return sum((c * (e * log_w).exp() for c, e in powers), arb(0))


def truncated(damping: Damping, leading: int, order: int) -> Truncated | None:
    """B to the power ``order`` of w^(2-2 alpha), at the current precision; None if that takes too many powers."""
    # Exact keys for the cache: balls are equal if both their numbers are.
    strengths = tuple((e.mid().man_exp(), e.rad().man_exp()) for e in damping.strengths)
    return _truncated(damping.alphas, strengths, leading, order, ctx.prec)


@lru_cache(maxsize=64)
def _truncated(
    alphas: tuple[ExactReal, ...], strengths: tuple[Any, ...], leading: int, order: int, bits: int
) -> Truncated | None:
    with ctx.workprec(bits):
        a, e = [alpha.ball() for alpha in alphas], [arb(arb(mid), arb(rad)) for mid, rad in strengths]
        beside = [i for i in range(len(a)) if i != leading]
        steps = [2 - 2 * a[leading], *(a[i] - a[leading] for i in beside)]
        # Which powers are kept is a choice in doubles; every other power that their product makes is counted as
        # neglected below.
        keys = lower_set(tuple(abs(float(d.mid())) for d in steps), order)
        if keys is None:
            return None
        exponent = {key: sum(map(mul, steps, key), arb(0)) for key in keys}
        others = {unit(i, len(steps)): a[j] * e[j] / e[leading] for i, j in enumerate(beside, start=1)}
        b = _solved(keys, exponent, a[leading], others, 1 / e[leading] ** 2)
        A = {**others, **{key: -(a[leading] + exponent[key]) * b[key] for key in keys}}
        left: dict[Key, arb] = {}
        for (i, c), (j, d) in product(A.items(), b.items()):
            key = tuple(map(add, i, j))
            # The powers of the kept keys cancel exactly, as B solves for them; the others remain.
            if key not in b:
                left[key] = left.get(key, arb(0)) + c * d
        powers = tuple((upper(c), sum(map(mul, steps, key), arb(0))) for key, c in left.items())
        # E just below the least neglected power: all of them are then w^E times powers >= 0, which is the hypothesis of
        # ``one_way``, also where their balls overlap.
        first = least(d.lower() for _, d in powers) if alphas[leading] < 1 else -least(-d for _, d in powers).lower()
        cut = first * (1 - arb(2) ** -40)
        return Truncated(
            e[leading],
            a[leading],
            tuple((e[j] / e[leading], steps[i]) for i, j in enumerate(beside, start=1)),
            tuple((b[key], exponent[key]) for key in keys),
            cut.mid(),
            powers,
        )


def _solved(
    keys: list[Key], exponent: dict[Key, arb], alpha: arb, others: dict[Key, arb], first: arb
) -> dict[Key, arb]:
    """The coefficients of B, key by key: alpha b_j is what the smaller ones leave of the power j of A B."""
    b: dict[Key, arb] = {}
    for key in keys:
        total = first if key == unit(0, len(key)) else arb(0)
        for before, c in others.items():
            total -= c * b.get(tuple(map(sub, key, before)), arb(0))
        for smaller, c in b.items():
            other = b.get(tuple(map(sub, key, smaller)))
            if other is not None:
                total += (alpha + exponent[smaller]) * c * other
        b[key] = total / alpha
    return b


def unit(i: int, size: int) -> Key:
    """One factor of the kind i alone."""
    return tuple(int(j == i) for j in range(size))


def lower_set(steps: tuple[float, ...], order: int) -> list[Key] | None:
    """All keys with a factor w^(2-2 alpha) whose power is below the (order+1)-th of it, the small ones first."""
    # Just below, so that the rounding of doubles does not let the (order+1)-th power in.
    top = steps[0] * (order + 1) * (1 - 1e-9)
    if order > 20 * MOST or any(order * top > 20 * MOST * d for d in steps[1:]):  # a step may be 0 at this precision
        return None
    # How often each of the other steps fits below the top; a lower set, so that all parts of a key are keys.
    counts = [range(ceil(top / d)) for d in steps[1:]]
    found = [
        (k, *more)
        for more in product(*counts)
        for k in range(1, order + 1)
        if k * steps[0] + sum(map(mul, steps[1:], more)) < top
    ]
    return sorted(found, key=sum) if len(found) <= MOST else None
