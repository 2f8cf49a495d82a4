"""Polynomials in psi, sin psi, cos psi over Q[pi, 1/pi]: where the hierarchy of integer exponents lives.

An element is pi^shift (A + s B) with A, B in Q[y, pi, c], y = psi - pi/2, c = cos psi, s = sin psi, s^2 = 1 - c^2: the
phase is counted from the passage because reversal, psi -> pi - psi, is then y -> -y, c -> -c and halves the terms.

Closed under products, derivatives and integrals from 0: by parts from the highest power of y, with
int B(c) s dpsi = -int B dc and int c^m dpsi = mean_m y + s S_m(c), m c^m = (m-1) c^(m-2) + d(s c^(m-1))/dpsi.

>>> x = SINE * SINE * SINE
>>> x.integral().at_pi()                                      # int_0^pi sin^3
4/3
>>> (x.integral().derivative() - x).is_zero, (PSI * COSINE).integral().to_sympy()
(True, psi*sin(psi) + cos(psi) - 1)
"""

from dataclasses import dataclass
from typing import Any

import sympy
from flint import arb, fmpq, fmpq_mpoly, fmpq_mpoly_ctx, fmpq_poly

from asymptotics.expansions.half_swings.pi_ring import PiNumber

_RING = fmpq_mpoly_ctx.get(("y", "pi", "c"))
_Y, _PI, _C = _RING.gens()
_ZERO, _ONE = _RING.constant(0), _RING.constant(1)
_SINE_SQUARED = 1 - _C**2
psi = sympy.Symbol("psi", real=True)


@dataclass(frozen=True, repr=False, eq=False)
class Wave:
    """pi^shift (even + sin psi * odd), ``even`` and ``odd`` polynomials in y = psi - pi/2, pi and cos psi."""

    even: fmpq_mpoly
    odd: fmpq_mpoly
    shift: int = 0

    @classmethod
    def number(cls, c: PiNumber) -> "Wave":
        """A constant of Q[pi, 1/pi]."""
        low = min(c.terms, default=0)
        return cls(_RING.from_dict({(0, n - low, 0): q for n, q in c.terms.items()}), _ZERO, low)

    @property
    def is_zero(self) -> bool:
        """Whether the function vanishes identically: pi, psi, sin psi are algebraically independent."""
        return not len(self.even) and not len(self.odd)

    @property
    def terms(self) -> int:
        """How many monomials the function has."""
        return len(self.even) + len(self.odd)

    def _raised(self, shift: int) -> tuple[fmpq_mpoly, fmpq_mpoly]:
        power = _PI ** (self.shift - shift)
        return self.even * power, self.odd * power

    def __add__(self, other: "Wave") -> "Wave":
        # The common case, in which no power of pi has to be multiplied in.
        if self.shift == other.shift:
            return Wave(self.even + other.even, self.odd + other.odd, self.shift)
        shift = min(self.shift, other.shift)
        (a, b), (c, d) = self._raised(shift), other._raised(shift)
        return Wave(a + c, b + d, shift)

    def __neg__(self) -> "Wave":
        return Wave(-self.even, -self.odd, self.shift)

    def __sub__(self, other: "Wave") -> "Wave":
        return self + (-other)

    def __mul__(self, other: Any) -> "Wave":
        if isinstance(other, PiNumber):
            other = Wave.number(other)
        if not isinstance(other, Wave):
            return Wave(self.even * other, self.odd * other, self.shift)
        even = self.even * other.even
        # s^2 = 1 - c^2 brings the product of the odd parts back to the even one.
        if len(self.odd) and len(other.odd):
            even += _SINE_SQUARED * (self.odd * other.odd)
        return Wave(even, self.even * other.odd + self.odd * other.even, self.shift + other.shift)

    def derivative(self) -> "Wave":
        """d/dpsi: y' = 1, c' = -s, s' = c."""
        a, b = self.even, self.odd
        even = a.derivative("y") + _C * b - _SINE_SQUARED * b.derivative("c")
        return Wave(even, b.derivative("y") - a.derivative("c"), self.shift)

    def integral(self) -> "Wave":
        """The integral from 0 to psi."""
        # At psi = 0, y = -pi/2, c = 1 and s = 0: the even part alone has a value there, which is taken off.
        even, odd = _primitive(_by_power_of_y(self.even), _by_power_of_y(self.odd))
        return Wave(even - even.compose(-_PI / 2, _PI, _ONE), odd, self.shift).lowered()

    def at_pi(self) -> PiNumber:
        """The value at psi = pi."""
        return self._value(_PI / 2, -_ONE)

    def at_zero(self) -> PiNumber:
        """The value at psi = 0."""
        return self._value(-_PI / 2, _ONE)

    def _value(self, y: fmpq_mpoly, c: fmpq_mpoly) -> PiNumber:
        found = self.even.compose(y, _PI, c).to_dict()
        size = max((n for _, n, _ in found), default=0) + 1
        values = [found.get((0, n, 0), fmpq(0)) for n in range(size)]
        return PiNumber.normal(fmpq_poly(values), self.shift)

    def at(self, psi: arb) -> arb:
        """The value at any phase as a ball at the current precision; exactly 0 where the function is."""
        # A product of balls would only hold 0.
        if self.is_zero:
            return arb(0)
        y, c, values = psi - arb.pi() / 2, psi.cos(), []
        for p in (self.even, self.odd):
            terms = (arb(q) * y ** int(i) * arb.pi() ** int(n) * c ** int(m) for (i, n, m), q in p.to_dict().items())
            values.append(sum(terms, arb(0)))
        return arb((values[0] + psi.sin() * values[1]) * arb.pi() ** self.shift)

    def mirrored(self) -> "Wave":
        """The function f(pi - psi) of psi."""
        even, odd = (p.compose(-_Y, _PI, -_C) for p in (self.even, self.odd))
        return Wave(even, odd, self.shift)

    def lowered(self) -> "Wave":
        """The same with common powers of pi moved to the shift."""
        powers = [m[1] for p in (self.even, self.odd) for m in p.monoms()]
        if not (low := min(powers, default=0)):
            return self
        even, odd = (_RING.from_dict({(i, n - low, m): q for (i, n, m), q in p.to_dict().items()}) for p in
                     (self.even, self.odd))  # fmt: skip
        return Wave(even, odd, self.shift + low)

    def coefficients(self) -> dict[tuple[int, int, int], PiNumber]:
        """(power of psi, of sin psi, of cos psi) -> coefficient, without zeros: the polynomial as it is displayed."""
        found: dict[tuple[int, int, int], dict[int, fmpq]] = {}
        for power, p in ((0, self.even), (1, self.odd)):
            for (i, n, m), q in p.compose(_Y - _PI / 2, _PI, _C).to_dict().items():
                found.setdefault((i, power, m), {})[int(n)] = q
        return {k: _pi_number(row, self.shift) for k, row in sorted(found.items())}

    def to_sympy(self) -> sympy.Expr:
        """The function as a SymPy expression in psi."""
        s, c = sympy.sin(psi), sympy.cos(psi)
        return sympy.Add(*[q.to_sympy() * psi**i * s**j * c**m for (i, j, m), q in self.coefficients().items()])


def _pi_number(row: dict[int, fmpq], shift: int) -> PiNumber:
    return PiNumber.normal(fmpq_poly([row.get(n, fmpq(0)) for n in range(max(row) + 1)]), shift)


Rows = list[dict[int, fmpq_poly]]


def _by_power_of_y(p: fmpq_mpoly) -> Rows:
    """p = sum_i y^i sum_m c^m (polynomial in pi)."""
    found: dict[int, dict[int, dict[int, fmpq]]] = {}
    for (i, n, m), q in p.to_dict().items():
        found.setdefault(int(i), {}).setdefault(int(m), {})[int(n)] = q
    rows: Rows = [{} for _ in range(max(found, default=-1) + 1)]
    for i, row in found.items():
        rows[i] = {m: fmpq_poly([c.get(n, fmpq(0)) for n in range(max(c) + 1)]) for m, c in row.items()}
    return rows


def _primitive(even: Rows, odd: Rows) -> tuple[fmpq_mpoly, fmpq_mpoly]:
    """An antiderivative of sum_i y^i (even_i + s odd_i), power by power of y from the top by parts."""
    found: tuple[dict[Any, Any], dict[Any, Any]] = ({}, {})
    carry: tuple[dict[int, fmpq_poly], dict[int, fmpq_poly]] = ({}, {})
    for i in range(max(len(even), len(odd)) - 1, -1, -1):
        a, b = (_sum(rows[i] if i < len(rows) else {}, c) for rows, c in zip((even, odd), carry))
        # y^i F' = (y^i F)' - i y^(i-1) F: what is left is carried on to the next lower power of y.
        mean, sine = _integrated_cosines(a)
        cosine = {m + 1: -q / (m + 1) for m, q in b.items()}
        _put(found[0], i + 1, {0: mean / (i + 1)})
        _put(found[0], i, cosine)
        _put(found[1], i, sine)
        carry = ({m: -i * q for m, q in cosine.items()}, {m: -i * q for m, q in sine.items()})
    return _RING.from_dict(found[0]), _RING.from_dict(found[1])


def _integrated_cosines(a: dict[int, fmpq_poly]) -> tuple[fmpq_poly, dict[int, fmpq_poly]]:
    """(mean, S) with int sum a_m c^m dpsi = mean y + s sum S_m c^m."""
    zero, rest, sine = fmpq_poly([]), dict(a), {}
    for m in range(max(rest, default=0), 0, -1):
        if m in rest:
            sine[m - 1] = rest[m] / m
            if m >= 2:
                rest[m - 2] = rest.get(m - 2, zero) + rest[m] * (m - 1) / m
    return rest.get(0, zero), sine


def _sum(a: dict[int, fmpq_poly], b: dict[int, fmpq_poly]) -> dict[int, fmpq_poly]:
    return {m: a[m] + b[m] if m in a and m in b else a.get(m, b.get(m)) for m in {*a, *b}}  # type: ignore[misc]


def _put(found: dict[Any, Any], i: int, row: dict[int, fmpq_poly]) -> None:
    for m, q in row.items():
        for n, c in enumerate(q.coeffs()):
            if c != 0:
                found[i, n, m] = found.get((i, n, m), fmpq(0)) + c


ZERO = Wave(_ZERO, _ZERO)
ONE = Wave(_ONE, _ZERO)
COSINE = Wave(_C, _ZERO)
SINE = Wave(_ZERO, _ONE)
PSI = Wave(_Y + _PI / 2, _ZERO)
