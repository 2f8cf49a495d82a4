"""The motion as a power series, from rest in s^(1/q) or in motion in s, with the powers of its speed.

With z = s^(1/q), the place P = sum y_n z^n and |P'| = z^m v(z): m = q from rest (y_n = 0 for 0 < n < 2 q), where the
exponents of z in v and in the powers w = v^a are those that 2 q and the numbers q a generate; m = 0, q = 1 in motion.

    y_n n (n - q)/q^2 = -k y_(n-2q) -+ sum of e w_(n-2q-ma),    j v_0 w_j = sum over l of (a l - (j - l)) v_l w_(j-l)

Midpoints of balls, no claim: the checker finds out how good the series are.

>>> from asymptotics.certificates.equation import Equation
>>> free = Equation((), Fraction(1), Fraction(1), Fraction(0))
>>> cosine = from_rest(free, arb(1), -1, -1, 6)
>>> [(n, c.str(5)) for n, c in cosine.y.items()]
[(0, '1.0000'), (2, '-0.50000'), (4, '[0.041667 +/- 3.34e-7]'), (6, '[-0.0013889 +/- 1.12e-8]')]
"""

from dataclasses import dataclass
from fractions import Fraction

from flint import arb

from asymptotics.certificates.equation import Equation
from asymptotics.errors import LimitError
from asymptotics.numbers.rationals import to_fmpq
from asymptotics.running.budget import tick

Powers = dict[int, arb]
MOST = 1200
"""Terms of a series: a second for each law with a power of its own."""


@dataclass(frozen=True)
class PowerSeries:
    """P and the powers of its speed in z = s^(1/``root``), |P'| = z^``lead`` v(z); an empty power for a = 0 and 1."""

    root: int
    lead: int
    y: Powers
    v: Powers
    powers: tuple[Powers, ...]

    def at(self, s: arb) -> tuple[arb, arb]:
        """(P, P') at the time s, in motion."""
        place = speed = arb(0)
        for n in range(max(self.y), -1, -1):
            place, speed = place * s + self.y[n], speed * s + (n * self.y[n] if n else 0) if n else speed
        return place.mid(), speed.mid()


def from_rest(equation: Equation, place: arb, sign: int, forward: int, degree: int) -> PowerSeries:
    """From rest at a place, to s^degree: ``sign`` of P', ``forward`` the sign of the true speed."""
    return _grown(equation, equation.root, equation.root, {0: place}, sign, forward, degree)


def in_motion(equation: Equation, place: arb, speed: arb, degree: int) -> PowerSeries:
    """From a place and a speed that is not 0, to s^degree."""
    sign = 1 if speed > 0 else -1
    return _grown(equation, 1, 0, {0: place, 1: speed}, sign, sign, degree)


def _generated(steps: set[int], last: int) -> list[int]:
    """The sums of the steps, with repetition, up to ``last``."""
    found = {0}
    for n in range(1, last + 1):
        if any(n - step in found for step in steps):
            found.add(n)
    return sorted(found)


def _grown(
    equation: Equation, q: int, m: int, y: Powers, sign: int, forward: int, degree: int
) -> PowerSeries:  # fmt: skip
    shifts = [int(m * a) for a, _ in equation.terms]
    strengths = [forward * arb(to_fmpq(e)) for _, e in equation.terms]
    steps = {2 * q, *(s for s in shifts if s)} if m else {1}
    stiffness = arb(to_fmpq(equation.stiffness))
    v: Powers = {} if m else {0: sign * y[1]}
    powers: list[Powers] = [{} for _ in equation.terms]
    orders = _generated(steps, q * degree - 2 * q)
    if len(orders) > MOST:
        reason = f"next to rest the motion is a series in s^(1/{q}) of {len(orders)} terms"
        raise LimitError("certificate", reason, f"{MOST} terms: exponents of smaller denominators, or fewer digits")
    for k in orders:
        tick("a series of the certificate")
        force = stiffness * y[k] if k in y else arb(0)
        for (a, _), shift, e, w in zip(equation.terms, shifts, strengths, powers):
            if k - shift == 0 or (a != 0 and k - shift in v):
                force += e * _power(a, v, w, k - shift)
        y[k + 2 * q] = (-force * q * q / ((k + 2 * q) * (k + q))).mid()
        v[k + q - m] = (sign * y[k + 2 * q] * (k + 2 * q) / q).mid()
    # The powers to the same order as the speed.
    for (a, _), w in zip(equation.terms, powers):
        if a not in (0, 1):
            for j in v:
                _power(a, v, w, j)
    return PowerSeries(q, m, y, v, tuple({} if a in (0, 1) else w for (a, _), w in zip(equation.terms, powers)))


def _power(a: Fraction, v: Powers, w: Powers, j: int) -> arb:
    """The coefficient j of v^a, kept in ``w``: coefficients are asked for in order."""
    if a == 0:
        return arb(1 if j == 0 else 0)
    if a == 1:
        return v[j]
    if j not in w:
        if j == 0:
            w[0] = (v[0] ** arb(to_fmpq(a))).mid()
        else:
            p, r = a.numerator, a.denominator
            total = sum(((p * i - r * (j - i)) * (c * w[j - i]) for i, c in v.items() if i and j - i in w), arb(0))
            w[j] = (total / (r * j * v[0])).mid()
    return w[j]
