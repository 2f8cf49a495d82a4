"""The generating functions G_i(z) = sum_n C_i^n z^n in closed form, for every i: rational(z) + rational(z) atan(z).

With z = tan(theta) the function H_i = sin(theta)^i G_i obeys (derivation ``smith-generating-functions``)

    H_i' = 2 sin^2 cos H_(i-1)' - 2 (i-1) sin cos^2 H_(i-1),     H_0 = theta,     H_i(0) = 0,

and therefore, by induction, H_i = theta P_i(c) + sin(theta) R_i(c) with c = cos(theta) and P_i, R_i in Q[c]:

    P_i'                        = 2 c (1-c^2) P_(i-1)' + 2 (i-1) c^2 P_(i-1)
    P_i + c R_i - (1-c^2) R_i'  = 2 c (1-c^2) (P_(i-1) + c R_(i-1) - (1-c^2) R_(i-1)') - 2 (i-1) c^2 (1-c^2) R_(i-1).

P_i has the parity of i and R_i the opposite one, so G_i is rational in z apart from atan(z).  Smith's text says that
from i = 2 on the sums are no recognisable functions; they all are.

>>> g = generating_function(2)
>>> g.in_z()
(3*z**4 - 8*z**2 - 3)/(18*z*(z**2 + 1)**2) + (z**2 + 1)*atan(z)/(6*z**2)
>>> g.limit
pi/6
"""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import sympy
from flint import arb, fmpq, fmpq_poly

from asymptotics.errors import InputError, shown
from asymptotics.numbers.bridge import to_sympy
from asymptotics.numbers.context import inside
from asymptotics.numbers.integers import require_integer
from asymptotics.numbers.policy import Number
from asymptotics.present.shown import Page, Shown
from asymptotics.running.public import public

Z, THETA = sympy.Symbol("z"), sympy.Symbol("theta")
MAX_I = 1000
_C = fmpq_poly([0, 1])
_S2 = fmpq_poly([1, 0, -1])


@dataclass(frozen=True, repr=False)
class GeneratingFunction(Shown):
    """G_i through sin^i(theta) G_i = theta P(c) + sin(theta) R(c), c = cos(theta), z = tan(theta)."""

    i: int
    P: fmpq_poly
    R: fmpq_poly

    @property
    def limit(self) -> sympy.Expr:
        """The limit of sin^i(theta) G_i at theta = pi: pi P(-1)."""
        return to_sympy(self.P(fmpq(-1))) * sympy.pi

    @public
    def in_angle(self, *, max_seconds: Number = 60) -> sympy.Expr:
        """G_i as a function of theta in (0, pi), continuous through theta = pi/2.

        >>> generating_function(1).in_angle()
        2/3 - 2*cos(theta)**2/3
        """
        c, s = sympy.cos(THETA), sympy.sin(THETA)
        numerator = THETA * _expression(self.P, c) + s * _expression(self.R, c)
        # From i = 2 on an expansion would hide the common denominator.
        return sympy.expand(numerator / s**self.i) if self.i < 2 else numerator / s**self.i

    @public
    def in_z(self, *, max_seconds: Number = 60) -> sympy.Expr:
        """G_i as a function of z: A(z) atan(z) / z^i + B(z) / (z^k (1 + z^2)^m), for all real z and for |z| < 1.

        >>> generating_function(0).in_z(), generating_function(1).in_z()
        (atan(z), 2*z**2/(3*z**2 + 3))
        """
        i, m = self.i, max(0, (self.R.degree() + 2 - self.i) // 2)
        with_atan = _fraction(_homogenised(self.P, i), Z**i)
        rest = _homogenised(self.R, 2 * m + i - 1)  # sin(theta) c^j / sin(theta)^i = z (1+z^2)^((i-1-j)/2) / z^i
        return with_atan * sympy.atan(Z) + _fraction(rest, Z ** (i - 1) * (1 + Z**2) ** m)

    @inside
    def scaled_at(self, theta: arb) -> arb:
        """sin^i(theta) G_i at an angle in [0, pi], a ball, as a ball; finite at pi."""
        if not isinstance(theta, arb):
            raise InputError("theta", f"{shown(theta)} is no ball", "an arb")
        c, s = theta.cos(), theta.sin()
        return theta * _value(self.P, c) + s * _value(self.R, c)

    def to_dict(self) -> dict[str, Any]:
        """i, the expression in z, its LaTeX and the limit, as strings."""
        expression = self.in_z()
        return {
            "i": self.i,
            "expression": str(expression),
            "angle_expression": str(self.in_angle()),
            "latex": sympy.latex(expression),
            "limit": str(self.limit),
        }

    def __repr__(self) -> str:
        return f"G_{self.i}(z), exact"

    def _page(self) -> Page:
        limit = f"limit of sin^{self.i}(theta) G_{self.i} at theta = pi, z = tan(theta): {self.limit}"
        return Page(f"G_{self.i}(z) = {self.in_z()}", ("exact", limit))

    def _letters(self) -> dict[str, str]:
        return {"z": "w/(w^2 - u) of Smith 2012", "G": "the sum of C_i^n z^n over n"}

    def _formula(self) -> str:
        return f"G_{{{self.i}}}(z) = {sympy.latex(self.in_z())}"


def generating_function(i: int) -> GeneratingFunction:
    """The closed form of G_i for any i >= 0.

    >>> [generating_function(i).limit for i in range(5)]
    [pi, 0, pi/6, -2*pi/9, 49*pi/144]
    """
    require_integer(i, "i", 0, MAX_I)
    return next(g for g in generating_functions() if g.i == i)


def generating_functions() -> Iterator[GeneratingFunction]:
    """Yield G_0, G_1, G_2, ... by the two polynomial recurrences of the module's docstring."""
    g = GeneratingFunction(0, fmpq_poly([1]), fmpq_poly([]))
    while True:
        yield g
        g = _next(g)


def _next(g: GeneratingFunction) -> GeneratingFunction:
    i, dP, dR = g.i + 1, g.P.derivative(), g.R.derivative()
    P = (2 * _C * _S2 * dP + 2 * (i - 1) * _C**2 * g.P).integral()
    right = 2 * _C * _S2 * (g.P + _C * g.R - _S2 * dR) - 2 * (i - 1) * _C**2 * _S2 * g.R - P
    R, constant = _solve(right)
    # P_i has the parity of i, so that for odd i no constant can be left.
    if i % 2 and constant:
        raise ArithmeticError(f"P_{i} would lose its parity: the induction of smith-generating-functions fails")
    return GeneratingFunction(i, P + constant, R)


def _solve(right: fmpq_poly) -> tuple[fmpq_poly, fmpq]:
    """The polynomial R and the constant k with k + c R - (1 - c^2) R' = right, from the top coefficient down."""
    rest = [right[j] for j in range(right.degree() + 1)] or [fmpq(0)]
    R = [fmpq(0)] * len(rest)
    for m in range(len(rest) - 2, -1, -1):  # c R - (1-c^2) R' maps c^m to (m+1) c^(m+1) - m c^(m-1)
        R[m] = rest[m + 1] / (m + 1)
        if m:
            rest[m - 1] += m * R[m]
    return fmpq_poly(R), rest[0]


def _homogenised(p: fmpq_poly, degree: int) -> fmpq_poly:
    """sum_j p_j (1+z^2)^((degree-j)/2): c^j rewritten over c^degree, for p of the parity of ``degree``."""
    one_plus_z2, total = fmpq_poly([1, 0, 1]), fmpq_poly([])
    for j in range(p.degree(), -1, -1):
        if p[j]:
            total += p[j] * one_plus_z2 ** ((degree - j) // 2)
    return total


def _fraction(p: fmpq_poly, denominator: sympy.Expr) -> sympy.Expr:
    """p(z) / denominator with integer coefficients on top and common powers of z and 1 + z^2 cancelled."""
    if not p:
        return sympy.Integer(0)
    top = sympy.Poly([int(c) for c in reversed(list(p.numer()))], Z)
    quotient = sympy.cancel(top.as_expr() / denominator)
    top, bottom = sympy.fraction(quotient)
    return top / (to_sympy(fmpq(p.denom(), 1)) * sympy.factor(bottom))


def _value(p: fmpq_poly, x: arb) -> arb:
    total = arb(0)
    for c in reversed(list(p)):
        total = total * x + arb(c)
    return total


def _expression(p: fmpq_poly, x: sympy.Expr) -> sympy.Expr:
    return sympy.Add(*[to_sympy(c) * x**j for j, c in enumerate(p) if c])
