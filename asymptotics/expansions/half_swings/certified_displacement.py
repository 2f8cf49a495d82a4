"""The displacement x(tau) on the quarter swing at a fixed time, by orders in the local strengths, with proved balls.

From the turning point X = 1, X' = 0 on, while Y = -X' > 0, z = X - i X' obeys z' = i z - i S with S = sum_i delta^(k_i)
r_i X^(m_i) Y^(v_i) over the members of the forces (``forces``; r_i > 0 for a loss, < 0 for a spring).  With
w = e^(-i tau) z, s = sin tau, c = cos tau, order by order in delta

    w_n' = -(s + i c) S_n,      X_n = c Re w_n - s Im w_n,      Y_n = s Re w_n + c Im w_n.

In t = (2 tau/pi)^2, sigma = s/tau, g = tau s, with n.v the number of powers of the velocity in delta^n,

    S_n = tau^(n.v) s_n(t),   w_n = tau^(n.v+1) (tau a_n(t) + i b_n(t)),   X_n = tau^(n.v+2) (c a_n - sigma b_n),
    Y_n/s = tau^(n.v) y_n,    y_n = (g a_n + c b_n)/sigma,

a_n = -I[sigma s_n] and b_n = -I[c s_n], where I divides the coefficient of t^j by n.v + 2 + 2j and n.v + 1 + 2j.  The
power (Y/s)^v = (1 + sum y_n)^v follows from |n| q_n = sum_m (v |m| - |n-m|) y_m q_(n-m).  All is analytic in |t| < 4,
where sigma(t) = prod_k (1 - t/(4 k^2)) has no zero, and needed for 0 <= t <= 1.

*Bounds.*  In the supremum norm on |t| < varrho < 4, theta = (pi/2) sqrt(varrho): |sigma^v| <= (sinh theta/theta)^v,
|1/sigma| <= theta/sin theta, |c| <= cosh theta, |g| <= theta sinh theta (``certified_orders``), and I divides by
n.v + 2 and n.v + 1: the same recursion in numbers bounds X_n by B_n, its coefficients by B_n varrho^(-j), and what the
first K coefficients lack of tau^j d^j X_n/d tau^j, e = n.v + 2, by

    tau^e B_n (e + 2K + j)^j (t/varrho)^K/(1 - q),       q = (t/varrho) ((e + 2K + j + 2)/(e + 2K + j))^j.

>>> from asymptotics.expansions.half_swings.forces import Forces
>>> air = displacement_series(Forces.losses((2,)), 2, 53)
>>> air.slopes((1,), arb(1), 1)[0].overlaps((1 - arb(1).cos()) ** 2 / 3)        # X_1 of x'' + x = eps x'^2
True
"""

from dataclasses import dataclass
from math import log2
from typing import Any

from flint import arb, arb_poly

from asymptotics.errors import UndecidedError
from asymptotics.expansions.half_swings.certified_orders import (
    convolve,
    dot,
    elementary_series,
    indices,
    minus,
    sine_ratio_power,
)
from asymptotics.expansions.half_swings.forces import Forces, Member
from asymptotics.numbers.context import ctx
from asymptotics.series import Key

# Not 4 as in ``certified``: 1/sigma is among the functions here, and
# it has its pole at t = 4. 3 is worth 1.6 bits a term at the passage.
RADIUS = 3
_BOUND_BITS = 64
Parts = dict[Key, Any]


@dataclass(frozen=True, eq=False)
class DisplacementSeries:
    """X_n/tau^(n.v+2) as the first coefficients in t, and the suprema B_n on |t| < 3 that bound the rest."""

    exponents: dict[Key, arb]
    series: dict[Key, arb_poly]
    suprema: dict[Key, arb]
    terms: int

    def slopes(self, key: Key, tau: arb, count: int) -> list[arb]:
        """tau^j d^j X_n/d tau^j for j = 0, ..., count - 1, 0 < tau <= pi/2, at the current precision."""
        e, t = self.exponents[key] + 2, (2 * tau / arb.pi()) ** 2
        found, scale, series = [], tau**e, self.series[key].coeffs()
        steps = [e + 2 * i for i in range(len(series))]
        for j in range(count):
            total = arb_poly(series)(t)
            found.append(scale * (total + arb(0, self._rest(key, e, t, j).upper())))
            # tau^j d^j of tau^s has the factor s (s-1) ... (s-j+1), one more for each j.
            series = [c * (step - j) for c, step in zip(series, steps)]
        return found

    def _rest(self, key: Key, e: arb, t: arb, j: int) -> arb:
        """What the kept coefficients lack, over tau^e."""
        first, small = e + 2 * self.terms + j, t / RADIUS
        # The j factors of a coefficient are at most e + 2i + j in modulus. From one i to the next their bound grows by
        # less and less, so that the rest is below a geometric series with the first quotient.
        q = small * ((first + 2) / first) ** j
        if not q < 1:
            raise UndecidedError(f"the displacement is a series in t, and {t.str(5)} is not below {RADIUS}")
        return abs(self.suprema[key] * first**j * small**self.terms / (1 - q))


@dataclass(frozen=True, eq=False)
class _Ring:
    """The functions of the module docstring as series or as bounds; ``I(f, e)`` divides."""

    cosine: Any
    sine_ratio: Any
    inverse_ratio: Any
    turn: Any
    square: Any
    minus: int
    powers: tuple[Any, ...]
    cut: Any
    divide: Any


def displacement_series(forces: Forces, order: int, bits: int) -> DisplacementSeries:
    """X_n for 1 <= |n| <= ``order``, the tails below 2^-bits of the largest bound."""
    with ctx.workprec(_BOUND_BITS):
        suprema = _orders(_bounds(forces, order), forces, order)
        largest = max(_log2(b) for b in suprema.values())
    # Eight terms and sixteen bits more than the estimate: they cost little, and what they leave is in the radii.
    terms = int((bits + largest) / log2(RADIUS)) + 8
    with ctx.workprec(bits + int(largest) + 16):
        series = _orders(_series(forces, order, terms), forces, order)
        exponents = {n: dot(n, [v.ball() for v in forces.velocities]) for n in series}
    return DisplacementSeries(exponents, series, suprema, terms)


def _orders(ring: _Ring, forces: Forces, order: int) -> Parts:
    """X_n/tau^(n.v+2) in one of the two arithmetics."""
    members, velocities = forces.through(order), [v.ball() for v in forces.velocities]
    zero = (0,) * forces.variables
    one = 0 * ring.cosine + 1
    x: Parts = {zero: ring.cosine}
    y: Parts = {zero: one}
    waves: Parts = {}
    Q: list[Parts] = [{zero: one} for _ in members]
    X: list[list[Parts]] = [[x] * m.position for m in members]
    for n in indices(forces.variables, order)[1:]:
        force = 0 * ring.cosine
        for i, m in enumerate(members):
            rest = minus(n, m.key)
            if min(rest) >= 0:
                force = force + ring.cut(ring.powers[i] * _product(ring, [Q[i], *X[i]], rest))
        # First the wave of order n from forces that know lower
        # orders only, then the powers of the velocity that it makes.
        e = dot(n, velocities)
        a = ring.divide(ring.cut(ring.sine_ratio * force), e + 2)
        b = ring.divide(ring.cut(ring.cosine * force), e + 1)
        waves[n] = ring.cut(ring.cosine * a) - ring.minus * ring.cut(ring.sine_ratio * b)
        x[n] = ring.cut(ring.square * waves[n])
        y[n] = ring.cut(ring.inverse_ratio * (ring.cut(ring.turn * a) + ring.cut(ring.cosine * b)))
        for m, q in zip(members, Q):
            q[n] = _next_power(ring, m, y, q, n)
    return waves


def _product(ring: _Ring, factors: list[Parts], n: Key) -> Any:
    """The order n of a product."""
    first, *others = factors
    for f in others:
        orders = [k for k in first if all(i <= j for i, j in zip(k, n))]
        first = {k: ring.cut(convolve(first, f, k)) for k in orders}
    return first[n]


def _next_power(ring: _Ring, m: Member, y: Parts, q: Parts, n: Key) -> Any:
    """q_n of (1 + sum y_n)^v."""
    v, size, total = m.velocity.ball(), sum(n), 0 * ring.cosine
    for k, f in y.items():
        rest = minus(n, k)
        if any(k) and min(rest) >= 0:
            # Among bounds the weight counts by its size: nothing may cancel there.
            weight = v * sum(k) - sum(rest)
            total = total + (abs(weight) if ring.minus < 0 else weight) * ring.cut(f * q[rest])
    return total * (arb(1) / size)


def _series(forces: Forces, order: int, terms: int) -> _Ring:
    cosine, sine_ratio = elementary_series(terms)
    square = arb_poly([0, (arb.pi() / 2) ** 2])

    def cut(f: Any) -> Any:
        return (f + arb_poly()).truncate(terms)

    def divide(f: Any, e: arb) -> Any:
        return arb_poly([-c / (e + 2 * j) for j, c in enumerate(f.coeffs())])

    powers = tuple(sine_ratio_power(m.velocity.ball(), terms) * (arb(m.ratio) * m.side) for m in forces.through(order))
    return _Ring(
        cosine, sine_ratio, sine_ratio_power(arb(-1), terms), cut(square * sine_ratio), square, 1, powers, cut, divide
    )  # fmt: skip


def _bounds(forces: Forces, order: int) -> _Ring:
    # cos and sin/theta by the absolute values of their Taylor coefficients,
    # 1/sigma by its product, whose factors are least in modulus at t = varrho.
    theta = arb.pi() / 2 * arb(RADIUS).sqrt()
    cosine, ratio = theta.cosh(), theta.sinh() / theta
    powers = tuple(abs(arb(m.ratio)) * ratio ** m.velocity.ball() for m in forces.through(order))
    inverse, turn = theta / theta.sin(), theta * theta.sinh()
    return _Ring(cosine, ratio, inverse, turn, theta**2, -1, powers, arb, lambda f, e: f / e)


def _log2(x: arb) -> float:
    mantissa, exponent = arb(x.upper()).man_exp()
    return log2(int(mantissa)) + int(exponent) if mantissa else 0.0
