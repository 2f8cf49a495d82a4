"""Polynomials in theta, sin(theta), cos(theta) over Q: closed under products and under integration from 0.

An element is sum_j theta^j (P_j(c) + s Q_j(c)) with c = cos(theta), s = sin(theta), s^2 = 1 - c^2.

>>> (SINE * SINE).integral()                       # theta/2 - s c/2
theta^0 (0 + s ((-1/2)*x)) + theta^1 (1/2 + s (0))
>>> (THETA * COSINE).integral().at_quarter()       # int_0^(pi/2) theta cos(theta) = pi/2 - 1
-1 + pi/2
"""

from dataclasses import dataclass
from typing import Any

from flint import fmpq, fmpq_poly

from asymptotics.expansions.half_swings.pi_ring import PiNumber

_ZERO = fmpq_poly([])
_SINE_SQUARED = fmpq_poly([1, 0, -1])


@dataclass(frozen=True, repr=False, eq=False)
class ThetaTrig:
    """sum_j theta^j (P_j(c) + s Q_j(c)); ``parts[j]`` is the pair (P_j, Q_j)."""

    parts: tuple[tuple[fmpq_poly, fmpq_poly], ...]

    def __add__(self, other: Any) -> "ThetaTrig":
        a, b = self.parts, _lift(other).parts
        if len(a) < len(b):
            a, b = b, a
        head = tuple((p + q[0], r + q[1]) for (p, r), q in zip(a, b))
        return ThetaTrig(_trimmed(head + a[len(b) :]))

    __radd__ = __add__

    def __neg__(self) -> "ThetaTrig":
        return self * -1

    def __sub__(self, other: Any) -> "ThetaTrig":
        return self + (-_lift(other))

    def __mul__(self, other: Any) -> "ThetaTrig":
        if not isinstance(other, ThetaTrig):
            return ThetaTrig(_trimmed(tuple((p * other, q * other) for p, q in self.parts)))
        total = [[_ZERO, _ZERO] for _ in range(len(self.parts) + len(other.parts))]
        for i, (p, q) in enumerate(self.parts):
            for j, (u, v) in enumerate(other.parts):
                total[i + j][0] += p * u + _SINE_SQUARED * (q * v)
                total[i + j][1] += p * v + q * u
        return ThetaTrig(_trimmed(tuple((p, q) for p, q in total)))

    __rmul__ = __mul__

    def __truediv__(self, n: int) -> "ThetaTrig":
        return ThetaTrig(tuple((p / n, q / n) for p, q in self.parts))

    def __eq__(self, other: object) -> bool:
        b = _lift(other).parts
        return len(self.parts) == len(b) and all(p == u and q == v for (p, q), (u, v) in zip(self.parts, b))

    __hash__ = None  # type: ignore[assignment]

    def integral(self) -> "ThetaTrig":
        """The antiderivative in theta that vanishes at theta = 0, power by power of theta from the top by parts."""
        result = [[_ZERO, _ZERO] for _ in range(len(self.parts) + 1)]
        carry_p, carry_q = _ZERO, _ZERO
        for j in range(len(self.parts) - 1, -1, -1):
            p, q = self.parts[j][0] + carry_p, self.parts[j][1] + carry_q
            # From the highest power down: by parts theta^j F' = (theta^j
            # F)' - j theta^(j-1) F, and the last term is carried on.
            mean, sine_part = _integrate_cosine(p)
            cosine_part = -q.integral()  # d/d theta of -int Q dc is s Q
            result[j + 1][0] += mean / (j + 1)
            result[j][0] += cosine_part
            result[j][1] += sine_part
            carry_p, carry_q = -j * cosine_part, -j * sine_part
        antiderivative = ThetaTrig(_trimmed(tuple((p, q) for p, q in result)))
        return antiderivative - antiderivative._at_zero()

    def _at_zero(self) -> fmpq:
        return self.parts[0][0](fmpq(1)) if self.parts else fmpq(0)

    def at_quarter(self) -> PiNumber:
        """The value at theta = pi/2."""
        values = [(p[0] + q[0]) / fmpq(2) ** j for j, (p, q) in enumerate(self.parts)]
        return PiNumber.normal(fmpq_poly(values), 0)

    def at_half(self) -> PiNumber:
        """The value at theta = pi."""
        return PiNumber.normal(fmpq_poly([p(fmpq(-1)) for p, _ in self.parts]), 0)

    def __repr__(self) -> str:
        return " + ".join(f"theta^{j} ({p.str()} + s ({q.str()}))" for j, (p, q) in enumerate(self.parts)) or "0"


def _integrate_cosine(p: fmpq_poly) -> tuple[fmpq, fmpq_poly]:
    """(a, B) with int P(cos) d theta = a theta + s B(c): from d(s c^(m-1)) = (m c^m - (m-1) c^(m-2)) d theta."""
    rest = list(p.coeffs())
    found = [fmpq(0)] * max(len(rest) - 1, 0)
    for m in range(len(rest) - 1, 0, -1):
        found[m - 1] = rest[m] / m
        if m >= 2:
            rest[m - 2] += rest[m] * (m - 1) / m
    return (rest[0] if rest else fmpq(0)), fmpq_poly(found)


def _trimmed(parts: tuple[tuple[fmpq_poly, fmpq_poly], ...]) -> tuple[tuple[fmpq_poly, fmpq_poly], ...]:
    end = len(parts)
    while end and not parts[end - 1][0].length() and not parts[end - 1][1].length():
        end -= 1
    return parts[:end]


def _lift(x: Any) -> ThetaTrig:
    if isinstance(x, ThetaTrig):
        return x
    return ThetaTrig(_trimmed(((fmpq_poly([x]), _ZERO),)))


ONE = ThetaTrig(((fmpq_poly([1]), _ZERO),))
COSINE = ThetaTrig(((fmpq_poly([0, 1]), _ZERO),))
SINE = ThetaTrig(((_ZERO, fmpq_poly([1])),))
THETA = ThetaTrig(((_ZERO, _ZERO), (fmpq_poly([1]), _ZERO)))


def sine_power(n: int) -> ThetaTrig:
    """sin(theta)^n for an integer n >= 0."""
    return power_product(n, 0)


def power_product(n: int, m: int) -> ThetaTrig:
    """sin(theta)^n cos(theta)^m for integers n, m >= 0."""
    even = _SINE_SQUARED ** (n // 2) * fmpq_poly([0, 1]) ** m
    return ThetaTrig(((even, _ZERO),)) if n % 2 == 0 else ThetaTrig(((_ZERO, even),))
