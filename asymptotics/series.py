"""Truncated power series in one or several local strengths delta_i, over any coefficient ring.

A series keeps the monomials of total degree <= ``order``; every operation is exact modulo higher degrees.  The ring
is whatever the coefficients are: ``fmpq`` or numbers of Q[pi, 1/pi] (exact), ``arb`` or ``acb`` (balls: enclosures of
the coefficients come out because every step is a ring operation), polynomials.  They must multiply with ``int``.

>>> from flint import fmpq
>>> x = Series.variable(0, 1, 4, fmpq(1))
>>> (x * 2).exp()
1 + 2*d + 2*d^2 + 4/3*d^3 + 2/3*d^4 + O(5)
>>> ((x * 2).exp().log() - x * 2).coefficients
{}
>>> a, b = (Series.variable(i, 2, 2, fmpq(1)) for i in (0, 1))
>>> (1 - a - b).inverse()
1 + 1*d1 + 1*d0 + 1*d1^2 + 2*d0*d1 + 1*d0^2 + O(3)
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from itertools import product
from typing import Any

from flint import fmpq

from asymptotics.numbers.context import cached_property
from asymptotics.running.budget import tick

Key = tuple[int, ...]


def monomials(variables: int, degree: int) -> list[Key]:
    """All exponents of total degree ``degree``, in lexicographic order.

    >>> monomials(2, 2)
    [(0, 2), (1, 1), (2, 0)]
    """
    if variables == 1:
        return [(degree,)]
    heads = product(range(degree + 1), repeat=variables - 1)
    return [(*head, degree - sum(head)) for head in heads if sum(head) <= degree]


@dataclass(frozen=True, repr=False)
class Series:
    """A power series in ``variables`` variables, known through total degree ``order``; absent monomials are zero."""

    coefficients: Mapping[Key, Any]
    variables: int
    order: int

    @classmethod
    def constant(cls, value: Any, variables: int, order: int) -> "Series":
        """The constant series ``value``."""
        return cls({(0,) * variables: value}, variables, order)

    @classmethod
    def variable(cls, i: int, variables: int, order: int, one: Any = 1) -> "Series":
        """The series delta_i, with the ring's ``one`` as coefficient."""
        key = unit_key(i, variables)
        return cls({key: one} if order else {}, variables, order)

    @classmethod
    def from_list(cls, values: Iterable[Any], order: int | None = None) -> "Series":
        """A series in one variable from its list of coefficients."""
        items = list(values)
        top = len(items) - 1 if order is None else order
        return cls({(n,): c for n, c in enumerate(items[: top + 1])}, 1, top)

    @cached_property
    def parts(self) -> tuple[tuple[tuple[Key, Any], ...], ...]:
        """The homogeneous parts: ``parts[d]`` holds the (exponent, coefficient) pairs of total degree d."""
        # By degree, so that a product meets only the pairs that the order keeps.
        found: list[list[tuple[Key, Any]]] = [[] for _ in range(self.order + 1)]
        for key in sorted(self.coefficients):
            if sum(key) <= self.order:
                found[sum(key)].append((key, self.coefficients[key]))
        return tuple(tuple(part) for part in found)

    def __getitem__(self, key: int | Key) -> Any:
        """The coefficient of a monomial (an int will do for one variable); 0 if absent, IndexError beyond the order."""
        k = (key,) if isinstance(key, int) else key
        # An absent coefficient is 0 below the order and unknown above it: the two must not look alike.
        if sum(k) > self.order:
            raise IndexError(f"the coefficient of {k} is beyond the order {self.order}")
        return self.coefficients.get(k, 0)

    @property
    def constant_term(self) -> Any:
        """The coefficient of degree 0."""
        return self[(0,) * self.variables]

    def without_constant(self) -> "Series":
        """The same series with its constant term removed."""
        return self.with_coefficients({k: c for k, c in self.coefficients.items() if any(k)})

    def truncate(self, order: int) -> "Series":
        """The same series through a lower order."""
        return Series({k: c for k, c in self.coefficients.items() if sum(k) <= order}, self.variables, order)

    def extend(self, order: int) -> "Series":
        """The same polynomial, read as a series through a higher order."""
        return Series(self.coefficients, self.variables, order)

    def map(self, f: Callable[[Any], Any]) -> "Series":
        """Apply a ring map to every coefficient."""
        return self.with_coefficients({k: f(c) for k, c in self.coefficients.items()})

    def map_keys(self, f: Callable[[Key, Any], Any]) -> "Series":
        """Apply ``f(exponent, coefficient)`` to every coefficient."""
        return self.with_coefficients({k: f(k, c) for k, c in self.coefficients.items()})

    def weighted(self, weights: tuple[Any, ...]) -> "Series":
        """sum_i w_i delta_i d/d delta_i: each coefficient times sum_i n_i w_i."""
        return self.map_keys(lambda k, c: c * sum((n * w for n, w in zip(k, weights)), start=0))

    def shift(self, i: int) -> "Series":
        """delta_i times this series, through one order more."""
        raised = {(*k[:i], k[i] + 1, *k[i + 1 :]): c for k, c in self.coefficients.items()}
        return Series(raised, self.variables, self.order + 1)

    def with_coefficients(self, coefficients: dict[Key, Any]) -> "Series":
        """A series with the same variables and order."""
        return Series(coefficients, self.variables, self.order)

    def at(self, values: tuple[Any, ...]) -> Any:
        """The truncated sum at numbers delta_i = values[i]: no claim about what was cut off."""
        total: Any = 0
        for key, c in self.coefficients.items():
            # From exact numbers or balls alike: an enclosure of the polynomial, and of nothing that was cut off.
            for v, n in zip(values, key):
                c = c * v**n
            total = total + c
        return total

    def _lift(self, other: Any) -> "Series":
        if isinstance(other, Series):
            return other
        return Series.constant(other, self.variables, self.order)

    def __neg__(self) -> "Series":
        return self.map(lambda c: -c)

    def __add__(self, other: Any) -> "Series":
        b = self._lift(other)
        order = min(self.order, b.order)
        total = {k: c for k, c in self.coefficients.items() if sum(k) <= order}
        for k, c in b.coefficients.items():
            if sum(k) <= order:
                total[k] = total[k] + c if k in total else c
        return Series(_without_exact_zeros(total), self.variables, order)

    __radd__ = __add__

    def __sub__(self, other: Any) -> "Series":
        return self + (-self._lift(other))

    def __rsub__(self, other: Any) -> "Series":
        return (-self).__add__(other)

    def __mul__(self, other: Any) -> "Series":
        if not isinstance(other, Series):
            return self.map(lambda c: c * other)
        # A product may take long where the coefficients are long: the time is asked for at each.
        tick()
        order = min(self.order, other.order)
        total: dict[Key, Any] = {}
        for d, left in enumerate(self.parts[: order + 1]):
            for right in other.parts[: order + 1 - d]:
                accumulate(total, left, right)
        return Series(_without_exact_zeros(total), self.variables, order)

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> "Series":
        if isinstance(other, Series):
            return self * other.inverse()
        return self.map(lambda c: divided(c, other))

    def __pow__(self, n: int) -> "Series":
        result = self._lift(1)
        for _ in range(n):
            result = result * self
        return result

    def inverse(self) -> "Series":
        """1/self; the constant term must be a unit of the ring."""
        # A constant term 1 is its own inverse, also in a ring without division (polynomials in time).
        unit = self.constant_term if self.constant_term == 1 else divided(1, self.constant_term)
        rest = -(self.without_constant() * unit)
        # (1 - rest) y = unit: y_d = sum rest_j y_(d-j), a divisor of 1.
        return self._solve_by_degree({(0,) * self.variables: unit}, rest, lambda d, j: 1)

    def exp(self) -> "Series":
        """exp(self) for a series without constant term, by E exp(a) = exp(a) E a with the Euler operator E."""
        self._require_no_constant("exp")
        # E multiplies degree d by d, so that d y_d = sum_j (j a_j) y_(d-j): divisions by whole numbers alone.
        scaled = self.map_keys(lambda k, c: c * sum(k))
        return self._solve_by_degree({(0,) * self.variables: 1}, scaled, lambda d, j: d)

    def log(self) -> "Series":
        """log(self) for a series with constant term exactly 1: E log(a) = E a / a."""
        if not self.constant_term == 1:  # noqa: SIM201 - for a ball, != would be false as well
            raise ValueError(f"log needs the constant term 1, not {self.constant_term}")
        derivative = self.map_keys(lambda k, c: c * sum(k)).without_constant()
        return (derivative * self.inverse()).map_keys(lambda k, c: divided(c, sum(k)))

    def cos_sin(self) -> tuple["Series", "Series"]:
        """(cos(self), sin(self)) for a series without constant term."""
        self._require_no_constant("cos_sin")
        scaled = self.map_keys(lambda k, c: c * sum(k)).parts
        cosine: list[dict[Key, Any]] = [{(0,) * self.variables: 1}]
        sine: list[dict[Key, Any]] = [{}]
        for d in range(1, self.order + 1):
            new_cosine: dict[Key, Any] = {}
            new_sine: dict[Key, Any] = {}
            for j in range(1, d + 1):
                accumulate(new_cosine, scaled[j], sine[d - j].items())
                accumulate(new_sine, scaled[j], cosine[d - j].items())
            cosine.append({k: divided(-c, d) for k, c in new_cosine.items()})
            sine.append({k: divided(c, d) for k, c in new_sine.items()})
        return self.with_coefficients(_merged(cosine)), self.with_coefficients(_merged(sine))

    def compose(self, images: tuple["Series", ...]) -> "Series":
        """The series at delta_i = images[i], none of which has a constant term; the order is that of the images."""
        return compose_all((self,), images)[0]

    def _solve_by_degree(self, start: dict[Key, Any], a: "Series", divisor: Callable[[int, int], int]) -> "Series":
        """y with y_d = (1/divisor) sum_(j=1..d) a_j y_(d-j) and y_0 = start."""
        known: list[dict[Key, Any]] = [start]
        for d in range(1, self.order + 1):
            tick()
            total: dict[Key, Any] = {}
            for j in range(1, d + 1):
                accumulate(total, a.parts[j], known[d - j].items())
            n = divisor(d, 0)
            known.append({k: divided(c, n) for k, c in total.items()} if n != 1 else total)
        return self.with_coefficients(_without_exact_zeros(_merged(known)))

    def _require_no_constant(self, name: str) -> None:
        if not is_exact_zero(self.constant_term):
            raise ValueError(f"{name} needs a series without constant term, not {self.constant_term}")

    def __repr__(self) -> str:
        terms = [_coefficient_text(c) + _monomial_text(k) for part in self.parts for k, c in part]
        return " + ".join([*terms, f"O({self.order + 1})"])


def compose_all(series: tuple[Series, ...], images: tuple[Series, ...]) -> list[Series]:
    """Several series at the same delta_i = images[i]: the monomials in the images are computed once."""
    variables, order = images[0].variables, min(s.order for s in images)
    powers: dict[Key, Series] = {(0,) * len(images): Series.constant(1, variables, order)}
    results = [Series({}, variables, order) for _ in series]
    for degree in range(order + 1):
        for key in monomials(len(images), degree):
            if degree:
                # Each monomial of the images from one of the degree below, which is kept until the next degree is done.
                i = next(i for i, n in enumerate(key) if n)
                powers[key] = powers[(*key[:i], key[i] - 1, *key[i + 1 :])] * images[i]
            for s, one in enumerate(series):
                if degree <= one.order and key in one.coefficients:
                    results[s] = results[s] + powers[key] * one.coefficients[key]
        # Lower degrees are not needed again: the memory holds one degree at a time.
        powers = {k: p for k, p in powers.items() if sum(k) == degree}
    return [r.truncate(min(order, s.order)) for r, s in zip(results, series)]


def unit_key(i: int, size: int) -> Key:
    """The exponent of the variable i alone.

    >>> unit_key(1, 3)
    (0, 1, 0)
    """
    return tuple(int(j == i) for j in range(size))


def is_exact_zero(c: Any) -> bool:
    """Whether a coefficient is certainly zero; a ball around 0 is not, so it stays (``ball != 0`` would drop it).

    >>> from flint import arb
    >>> is_exact_zero(arb(0)), is_exact_zero(arb(0, 1)), arb(0, 1) != 0
    (True, False, False)
    """
    return bool(c == 0)


def divided(x: Any, n: Any) -> Any:
    """x/n in the ring; two Python integers give an exact rational, never a float.

    >>> divided(1, 3)
    1/3
    """
    return fmpq(x, n) if isinstance(x, int) and isinstance(n, int) else x / n


def accumulate(total: dict[Key, Any], left: Iterable[tuple[Key, Any]], right: Iterable[tuple[Key, Any]]) -> None:
    """Add the product of two sets of (exponent, coefficient) pairs to ``total``, in place."""
    second = list(right)
    for i, x in left:
        for j, y in second:
            # The innermost loop of all expansions: for one variable it goes without a generator.
            key = (i[0] + j[0],) if len(i) == 1 else tuple(p + q for p, q in zip(i, j))
            total[key] = total[key] + x * y if key in total else x * y


def _merged(parts: list[dict[Key, Any]]) -> dict[Key, Any]:
    return {k: c for part in parts for k, c in part.items()}


def _without_exact_zeros(coefficients: dict[Key, Any]) -> dict[Key, Any]:
    """Drop what is certainly zero; a ball around zero stays, because ``ball == 0`` holds for the exact zero only."""
    return {k: c for k, c in coefficients.items() if not is_exact_zero(c)}


def _coefficient_text(c: Any) -> str:
    return f"({c})" if " " in str(c) else str(c)


def _monomial_text(key: Key) -> str:
    names = ["d"] if len(key) == 1 else [f"d{i}" for i in range(len(key))]
    return "".join(f"*{name}" + (f"^{n}" if n > 1 else "") for name, n in zip(names, key) if n)
