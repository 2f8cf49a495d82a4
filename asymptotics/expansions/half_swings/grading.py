"""Weights and signs: all that the series in the local strengths know of the forces they belong to.

A force that is homogeneous of degree d in (x, v) has the local strength delta = epsilon A^(d-1).  Its *weight* is
d - 1: when ln A grows by L, delta is multiplied by e^((d-1) L), and a monomial delta^n by e^(a_n L) with

    a_n = sum_i n_i (d_i - 1).

Its *sign* says what the reversal of time does to it: a loss, odd in the velocity, changes sign (-1); a spring, even in
the velocity, does not (+1).  S denotes the reversal, delta_i -> sign_i delta_i, and l(n), the *loss degree*, the number
of losses in delta^n counted with multiplicity, so that S delta^n = (-1)^l(n) delta^n.  Parity always means that of l.

>>> duffing = Grading.of((2, 3), signs=(LOSS, SPRING))         # quadratic loss, cubic spring
>>> duffing.weight((1, 1)), duffing.loss_degree((1, 1))
(3, 1)
>>> duffing.flip(Series({(1, 0): 5, (0, 1): 7, (2, 1): 9}, 2, 3)).coefficients
{(1, 0): -5, (0, 1): 7, (2, 1): 9}
"""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from flint import acb, arb

from asymptotics.errors import UndecidedError
from asymptotics.series import Key, Series

LOSS, SPRING = -1, 1


def loss_degree(signs: tuple[int, ...], key: Key) -> int:
    """l(n): how many losses a monomial contains, counted with multiplicity."""
    return sum(n for n, sign in zip(key, signs) if sign == LOSS)


@dataclass(frozen=True)
class Grading:
    """``weights``: d_i - 1 in the coefficient ring; ``signs``: LOSS or SPRING; one of each for every variable."""

    weights: tuple[Any, ...]
    signs: tuple[int, ...]

    @classmethod
    def of(cls, degrees: Iterable[Any], signs: tuple[int, ...] | None = None) -> "Grading":
        """From the degrees d_i of homogeneity; all of them losses unless ``signs`` says otherwise."""
        weights = tuple(d - 1 for d in degrees)
        return cls(weights, (LOSS,) * len(weights) if signs is None else signs)

    @property
    def variables(self) -> int:
        """The number of local strengths."""
        return len(self.weights)

    @property
    def degrees(self) -> tuple[Any, ...]:
        """The degrees d_i of homogeneity: of a loss v|v|^(alpha-1), its exponent."""
        return tuple(w + 1 for w in self.weights)

    def weight(self, key: Key) -> Any:
        """a_n: the power of the amplitude that a monomial carries."""
        return sum((n * w for n, w in zip(key, self.weights)), start=0)

    def loss_degree(self, key: Key) -> int:
        """l(n): how many losses a monomial contains."""
        return loss_degree(self.signs, key)

    def flip(self, series: Series) -> Series:
        """f(S delta): every loss with its sign changed."""
        return series.map_keys(lambda k, c: -c if self.loss_degree(k) % 2 else c)

    def reversed(self, images: Iterable[Series]) -> tuple[Series, ...]:
        """S applied to a tuple of local strengths: sign_i times each."""
        return tuple(-f if sign == LOSS else f for f, sign in zip(images, self.signs))

    def weighted(self, series: Series) -> Series:
        """sum_i (d_i - 1) delta_i d/d delta_i: each coefficient times a_n."""
        return series.weighted(self.weights)

    def strengths(self, log_ratio: Series) -> tuple[Series, ...]:
        """delta_i e^((d_i - 1) log_ratio), through the order of ``log_ratio``: the local strengths further on."""
        # delta_i has one degree of its own: the exponential is wanted through one order less.
        below = log_ratio.truncate(log_ratio.order - 1) if log_ratio.order else log_ratio
        return tuple((below * w).exp().shift(i).truncate(log_ratio.order) for i, w in enumerate(self.weights))

    def of_parity(self, series: Series, parity: int) -> Series:
        """Keep the monomials of one parity; the others vanish by reversibility, which is checked, not assumed.

        Raises UndecidedError for a coefficient that should vanish and is neither zero nor a ball around zero.
        """
        for key, c in series.coefficients.items():
            if self.loss_degree(key) % 2 != parity and not may_vanish(c):
                raise UndecidedError(f"the coefficient of degree {key} should vanish by reversibility and is {c}")
        return series.with_coefficients(
            {k: c for k, c in series.coefficients.items() if self.loss_degree(k) % 2 == parity}
        )


def may_vanish(c: Any) -> bool:
    """Whether a coefficient is an exact zero, or a ball that contains 0."""
    return bool(c.contains(0)) if isinstance(c, arb | acb) else bool(c == 0)
