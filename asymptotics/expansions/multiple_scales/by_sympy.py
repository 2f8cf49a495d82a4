"""The whole ansatz run by SymPy alone, order by order: nothing of our rings, series or engines.

    X'' + X + epsilon X'|X'|^(alpha-1) = 0,    X = X_0 + eps X_1 + ...,    d/d tau = D_0 + eps D_1 + ...,
    X_0 = a cos psi,    D_0 = d/d psi,    D_n = f_n d/da + g_n d/d psi,

with e^(i psi) = q, so that waves are polynomials in q, 1/q and, for alpha = 2, psi.  At order n what is known of
sum D_i D_j X_k + (the force at order n - 1) is expanded, then f_n, g_n and X_n follow

* for odd alpha from the first harmonic, gauge no-first-harmonic: what remains is divided by 1 - m^2;
* for alpha = 2, on 0 < psi < pi where V < 0, by variation of parameters from rest at psi = 0; that X_n and V_n vanish
  at psi = pi, two linear equations that SymPy solves, gives f_n and g_n, gauge turning-point.

>>> two = ansatz(3, 2)
>>> two.rates, two.waves[1]
(((0, 1), (-3*a**3/8, 0), (0, 9*a**4/256)), a**3*sin(3*psi)/32)
>>> ansatz(2, 1).rates[1]
(-4*a**2/(3*pi), 0)
"""

from dataclasses import dataclass

import sympy
from sympy import Expr, I, Integer, Symbol, cos, diff, exp, expand, pi, sin, symbols

from asymptotics.errors import InputError
from asymptotics.expansions.multiple_scales.orders import a, psi
from asymptotics.gauges import NO_FIRST_HARMONIC, TURNING_POINT
from asymptotics.numbers.integers import require_integer
from asymptotics.running.budget import tick

MAX_ODD, MAX_QUADRATIC = 6, 4
"""Orders that SymPy reaches by itself in about a minute."""

q = Symbol("q", positive=True)
f, g = symbols("f g", real=True)
Rate = tuple[Expr, Expr]


@dataclass(frozen=True)
class Ansatz:
    """What SymPy found: X_n in sines and cosines of multiples of psi, and (D_n a, D_n psi), n = 0, ..., N."""

    alpha: int
    gauge: str
    waves: tuple[Expr, ...]
    rates: tuple[Rate, ...]

    def differences(self, waves: tuple[Expr, ...], rates: tuple[Rate, ...]) -> tuple[str, ...]:
        """Where another derivation of the same order and gauge differs, term by term; empty if it is equal."""
        found = [f"X_{n}" for n, pair in enumerate(zip(self.waves, waves, strict=True)) if _differ(*pair)]
        for n, pair in enumerate(zip(self.rates, rates, strict=True)):
            found += [f"D_{n} {letter}" for letter, one, two in zip(("a", "psi"), *pair) if _differ(one, two)]
        return tuple(found)


def ansatz(alpha: int, order: int) -> Ansatz:
    """Run it; InputError unless alpha is odd and order at most 6, or alpha is 2 and order at most 4."""
    require_integer(alpha, "alpha", 1, 99)
    if alpha % 2 == 0 and alpha != 2:
        raise InputError("alpha", f"{alpha} is not run by SymPy alone", "odd exponents, and 2")
    require_integer(order, "order", 0, MAX_QUADRATIC if alpha == 2 else MAX_ODD)
    run = _Run(alpha)
    for n in range(1, order + 1):
        tick()
        run.solve(n)
    gauge = TURNING_POINT if alpha == 2 else NO_FIRST_HARMONIC
    return Ansatz(alpha, gauge, tuple(map(_in_waves, run.X)), tuple(run.rates))


class _Run:
    """The orders that are solved: X_n in q and psi, the fields D_n, the velocities V_n."""

    def __init__(self, alpha: int) -> None:
        self.alpha = alpha
        self.X = [a * (q + 1 / q) / 2]
        self.rates: list[Rate] = [(Integer(0), Integer(1))]
        self.V = [self.D(0, self.X[0])]

    def D(self, n: int, wave: Expr) -> Expr:
        """D_n of a wave; d/d psi of q = e^(i psi) is i q."""
        rate, turn = self.rates[n]
        return expand(rate * diff(wave, a) + turn * (diff(wave, psi) + I * q * diff(wave, q)))

    def solve(self, n: int) -> None:
        """Order n: D_0 V_n + X_n = -sum_(i>0) D_i V_(n-i) - force, V_n = D_0 X_n + sum_(i>0) D_i X_(n-i)."""
        self.rates.append((f, g))
        self.X.append(Integer(0))  # D_0 X_n is added when it is known
        slow = expand(sum(self.D(i, self.X[n - i]) for i in range(1, n + 1)))
        right = -sum(self.D(i, self.V[n - i]) for i in range(1, n + 1)) - self.D(0, slow) - self.force(n - 1)
        right = expand(right)
        wave, rates = self.from_rest(right, slow) if self.alpha == 2 else self.harmonics(right, n)
        self.rates[n], self.X[n] = (rates[f], rates[g]), expand(wave.subs(rates))
        self.V.append(expand(self.D(0, self.X[n]) + slow.subs(rates)))

    def force(self, n: int) -> Expr:
        """The coefficient of eps^n in V|V|^(alpha-1): V^alpha, and -V^2 for alpha = 2, where V < 0."""
        powers = [Integer(1)] + [Integer(0)] * n
        for _ in range(self.alpha):
            tick()
            powers = [expand(sum(powers[k - j] * self.V[j] for j in range(k + 1))) for k in range(n + 1)]
        return -powers[n] if self.alpha == 2 else powers[n]

    def harmonics(self, right: Expr, n: int) -> tuple[Expr, dict[Expr, Expr]]:
        """No first harmonic on the right, none in X_n; none is above 1 + n (alpha - 1)."""
        highest = 1 + n * (self.alpha - 1)
        found = {m: right.coeff(q, m) for m in range(-highest, highest + 1)}
        rates = sympy.solve([expand(found[1] + found[-1]), expand((found[1] - found[-1]) / I)], [f, g], dict=True)[0]
        return sympy.Add(*(c * q**m / (1 - m**2) for m, c in found.items() if abs(m) != 1)), rates

    def from_rest(self, right: Expr, slow: Expr) -> tuple[Expr, dict[Expr, Expr]]:
        """X_n(0) = V_n(0) = 0 by variation of parameters; X_n(pi) = V_n(pi) = 0 for f and g."""
        up, down = (_integral(expand(right * q**-m)) for m in (1, -1))
        start = -_at(slow, 0)  # D_0 X_n at psi = 0
        wave = expand((q * up - down / q) / (2 * I) + start * (q - 1 / q) / (2 * I))
        velocity = expand(diff(wave, psi) + I * q * diff(wave, q) + slow)
        rates = sympy.solve([_at(wave, 1), _at(velocity, 1)], [f, g], dict=True)[0]
        return wave, {letter: expand(value) for letter, value in rates.items()}


def _at(wave: Expr, turns: int) -> Expr:
    """At psi = 0 or pi."""
    return expand(wave.subs({q: (-1) ** turns, psi: turns * pi}))


def _integral(wave: Expr) -> Expr:
    """From 0 to psi, of a sum of c psi^k q^m: by SymPy, each wave as an exponential."""
    total = Integer(0)
    for term in sympy.Add.make_args(wave):
        factor, m = term.as_coeff_exponent(q)
        number, k = factor.as_coeff_exponent(psi)
        total += number * _power(int(k), int(m))
    return expand(total)


def _power(k: int, m: int) -> Expr:
    """The integral of s^k e^(ims) from 0 to psi, in q = e^(i psi)."""
    s = Symbol("s", real=True)
    primitive = sympy.integrate(s**k * exp(I * m * s), s)
    return expand(primitive.subs(exp(I * m * s), q**m).subs(s, psi) - primitive.subs(s, 0))


def _in_waves(wave: Expr) -> Expr:
    """q^m = cos(m psi) + i sin(m psi)."""
    parts = []
    for term in sympy.Add.make_args(expand(wave)):
        factor, m = term.as_coeff_exponent(q)
        parts.append(factor * (cos(m * psi) + I * sin(m * psi)))
    return expand(sympy.Add(*parts))


def _differ(one: Expr, two: Expr) -> bool:
    """Whether two waves differ: as polynomials in e^(i psi), where equal ones are alike."""
    return bool(expand(expand((one - two).rewrite(exp)), power_exp=False) != 0)
