"""Power series put into the force, one coefficient after the other; on a line of exponents or on a simplex.

A ``ExponentLine`` numbers the powers of one variable, and the k-th coefficient of a product is a convolution.  A
``Simplex`` numbers monomials z^n of several variables (``keys_of``), and the product runs over pairs of keys.
``ComposedSeries`` keeps a series u with all powers of u that the force needs, and sin(r u) and cos(r u) by

    k S_k = r sum_f f u_f C_(k-f),    k C_k = -r sum_f f u_f S_(k-f)

(on a simplex f and k are total degrees: Euler's operator is a derivation there as well).

>>> curve = ComposedSeries(ExponentLine(()), arb(1), {3}, arb(0))
>>> for c in (1, 0, 0):
...     curve.append(arb(c))
>>> [c.str(5, radius=False) for c in curve.power[3]], [c.str(5, radius=False) for c in curve.sine]
(['0', '0', '0', '1.0000'], ['0', '1.0000', '0', '-0.16667'])
"""

from collections.abc import Iterable, Iterator
from itertools import islice
from operator import mul
from typing import Protocol

from flint import arb

from asymptotics.numbers.context import lru_cache

Key = tuple[int, ...]
_NONE = arb(0)


@lru_cache(maxsize=256)
def keys_of(weights: Key, top: int) -> tuple[Key, ...]:
    """All n >= 0 with sum n_i weights_i < top, by ascending weight.

    >>> keys_of((2, 3), 5)
    ((0, 0), (1, 0), (0, 1), (2, 0))
    """
    # By ascending weight the factors of a monomial come before it, so that a series can be found key by key.
    return tuple(n for n, left in sorted(below(weights, top), key=lambda found: -found[1]))


def below(weights: Key, top: int) -> Iterator[tuple[Key, int]]:
    """All n >= 0 with sum n_i weights_i < top, and what is left to ``top``."""
    if not weights:
        yield (), top
        return
    for k in range(-(-top // weights[0])):
        for rest, left in below(weights[1:], top - k * weights[0]):
            yield (k, *rest), left


class ExponentGrid(Protocol):
    """The exponents of a series, numbered; number 0 is the constant term."""

    def back(self, k: int, i: int) -> int | None:
        """The number of the k-th monomial divided by z_i, or None."""

    def degree(self, k: int) -> int:
        """A weight for which multiplication by it is a derivation."""

    def product(self, A: list[arb], B: list[arb]) -> arb:
        """The last coefficient of the product of two series known equally far."""

    def product_from_1(self, A: list[arb], B: list[arb]) -> arb:
        """The next coefficient of (A - A_0) B, where B is known one coefficient less far."""


class ExponentLine:
    """Powers of one variable; ``shifts``: which powers the z_i are."""

    def __init__(self, shifts: tuple[int, ...]) -> None:
        self.shifts = shifts

    def back(self, k: int, i: int) -> int | None:
        """k less the power of z_i."""
        return k - self.shifts[i] if k >= self.shifts[i] else None

    def degree(self, k: int) -> int:
        """The exponent k, as Euler's operator multiplies x^k by it."""
        return k

    def product(self, A: list[arb], B: list[arb]) -> arb:
        """The last coefficient of a product on a line is a convolution."""
        return sum(map(mul, A, reversed(B)), _NONE)

    def product_from_1(self, A: list[arb], B: list[arb]) -> arb:
        """The convolution that leaves A_0 out."""
        return sum(map(mul, islice(A, 1, None), reversed(B)), _NONE)


class Simplex:
    """Monomials of several variables with weights below ``top``."""

    def __init__(self, weights: Key, top: int) -> None:
        self.keys = keys_of(weights, top)
        self._back, self._pairs = _tables(weights, top)

    def back(self, k: int, i: int) -> int | None:
        """The key with one z_i less."""
        return self._back[k][i]

    def degree(self, k: int) -> int:
        """The total degree of the k-th monomial."""
        return sum(self.keys[k])

    def product(self, A: list[arb], B: list[arb]) -> arb:
        """The sum over all pairs of keys that add up to the last one."""
        return sum((A[i] * B[j] for i, j in self._pairs[len(B) - 1]), _NONE)

    def product_from_1(self, A: list[arb], B: list[arb]) -> arb:
        """The sum over the pairs without A_0, for the next key."""
        # B is one coefficient short of the key that is asked for, so its length is the number of that key; i = 0 would
        # be A_0 times the coefficient of B that is still unknown.
        return sum((A[i] * B[j] for i, j in self._pairs[len(B)] if i), _NONE)


@lru_cache(maxsize=64)
def _tables(weights: Key, top: int) -> tuple[list[list[int | None]], list[list[tuple[int, int]]]]:
    keys = keys_of(weights, top)
    number = {key: k for k, key in enumerate(keys)}
    units = [tuple(int(i == j) for j in range(len(weights))) for i in range(len(weights))]
    back = [[number.get(tuple(map(int.__sub__, key, unit))) for unit in units] for key in keys]
    pairs = []
    for key in keys:
        rests = ((i, tuple(map(int.__sub__, key, f))) for i, f in enumerate(keys))
        # A part of a key below the top has a smaller weight and is a key as well: ``number`` holds every rest.
        pairs.append([(i, number[rest]) for i, rest in rests if min(rest) >= 0])
    return back, pairs


class ComposedSeries:
    """A series u with its powers and, for a pendulum, the sine and cosine of r u; ``append`` adds a coefficient."""

    def __init__(self, grid: ExponentGrid, rate: arb | None, powers: Iterable[int], start: arb) -> None:
        self.grid, self.rate = grid, rate
        self.u = [start]
        self.power: dict[int, list[arb]] = {n: [start**n] for n in sorted(_chain(powers))} | {1: self.u}
        # The coefficients of degree times r u, Euler's operator applied to the argument of the sine.
        self._drift = [_NONE]
        self.sine: list[arb] = []
        self.cosine: list[arb] = []
        if rate is not None:
            sine, cosine = (rate * start).sin_cos()
            self.sine, self.cosine = [sine], [cosine]

    def append(self, coefficient: arb) -> None:
        """The next coefficient of u, and of everything made of it."""
        k = len(self.u)
        self.u.append(coefficient)
        # Ascending n: u^n is the product of u^(n//2) and u^(n-n//2), which have their k-th coefficient already.  u
        # itself, n = 1, got it above, and u^0 = 1 has none beyond the first.
        for n, series in self.power.items():
            if n == 0:
                series.append(_NONE)
            elif n > 1:
                series.append(self.grid.product(self.power[n // 2], self.power[n - n // 2]))
        if self.rate is not None:
            degree = self.grid.degree(k)
            self._drift.append(self.rate * coefficient * degree)
            # Both products are formed before either result is appended: each takes the other series one coefficient
            # short.
            sine = self.grid.product_from_1(self._drift, self.cosine) / degree
            cosine = -self.grid.product_from_1(self._drift, self.sine) / degree
            self.sine.append(sine)
            self.cosine.append(cosine)

    def restoring(self, powers: list[tuple[arb, int]]) -> arb:
        """The last coefficient of s_0(u), given its ``restoring_powers`` beside u itself or sin(r u)/r."""
        linear = self.u[-1] if self.rate is None else self.sine[-1] / self.rate
        return sum((c * self.power[n][-1] for c, n in powers), linear) if powers else linear


def _chain(powers: Iterable[int]) -> set[int]:
    """The powers, and those that lead to them by products of two."""
    found: set[int] = set()
    waiting = list(powers)
    while waiting:
        n = waiting.pop()
        if n not in found:
            found.add(n)
            # Halving takes about 2 log2(n) powers for the largest one, as by repeated squaring.
            waiting += [n // 2, n - n // 2] if n > 1 else []
    return found
