"""The quarter swing of one law alone, by the reciprocal of its local strength: half as many products as for sums.

With u the local strength at the angle theta, Q = delta/u = e^(-eta R), eta = alpha - 1 (see ``quarter`` for s, c, Y),

    Q' = eta delta s^(alpha+1) (1 + c Y),    Q Q' = delta s^alpha (c Q' + eta s Q)   (derivation ``one-law-quarter``),

so the left side is (Q²)'/2: order by order a square, each pair of factors once, and the time d tau/d theta = 1 + c Y is
linear in Q.  Two arithmetics:

* **alpha even**: polynomials in c, exactly: (Q²)_c/2 = delta s^alpha (c Q_c - eta Q) and 1 + c Y = -Q_c/(eta delta
  s^alpha), a division without remainder.
* **any other alpha > 0**: Q_n = theta^(n alpha) q_n(t) with power series q_n in t = (2 theta/pi)², as in
  ``certified_orders``; with D q = (n alpha + 2j) q_j, I its inverse, and g = theta s,

      q_n = I[sigma^alpha (c D q_(n-1) + eta g q_(n-1))] - 1/2 sum_(0<m<n) q_m q_(n-m),
      [c Y]_n = D q_(n+1)/(eta g sigma^alpha).

  The first K coefficients are computed without error of truncation.  What the sums at t = 1 lack is bounded as there,
  by B varrho^(-K)/(2K (1 - 1/varrho)): B_n of ``certified`` for T_n, and as q_n = eta I[g sigma^alpha (1 + c Y)_(n-1)]

      B = kappa^(n alpha) |eta| |g| |sigma^alpha| |c| |y_(n-1)|     for Q_n   (1 in the place of |c| |y_0|).

>>> from asymptotics.numbers.exact import parse_real
>>> R, T = even_quarter(2, 3)
>>> R[1], R[2], T[1], T[2]
(-2/3, 1/18, 1/3, -2/9 + pi/12)
>>> R, T = real_quarter(parse_real("3/2", "alpha"), 2, 60, 1.0)
>>> R[1].str(12), T[1].str(12)
('[-0.718884140841 +/- ...]', '[0.400000000000 +/- ...]')
"""

from collections.abc import Sequence
from math import log2
from typing import Any

from flint import arb, arb_poly, arb_series, fmpq, fmpq_poly, fmpq_series

from asymptotics.budget import tick
from asymptotics.half_swings.certified import RADIUS, enclose
from asymptotics.half_swings.certified_orders import (
    bound_ring,
    elementary_series,
    indices,
    order_series,
    sine_ratio_power,
)
from asymptotics.half_swings.forces import Forces
from asymptotics.half_swings.pi_ring import PI, PiNumber
from asymptotics.numbers.context import ctx
from asymptotics.numbers.exact import ExactReal

BOUND_BITS, GUARD = 64, 64
Bounds = dict[tuple[int, ...], arb]


def even_quarter(alpha: int, order: int) -> tuple[list[fmpq], list[PiNumber]]:
    """R_n and T_n for n = 0 … ``order``, exactly; alpha even and not negative (T_0 = pi/2)."""
    eta, c, sines = fmpq(alpha - 1), fmpq_poly([0, 1]), fmpq_poly([1, 0, -1]) ** (alpha // 2)
    q = [fmpq_poly([1])]
    for n in range(1, order + 2):
        tick(f"order {n} of the quarter swing")
        last = q[n - 1]
        primitive = (sines * (c * last.derivative() - eta * last)).integral()
        q.append(primitive - primitive(fmpq(1)) - _half_of_the_square(q, n))
    T = [PI / 2]
    for f in q[2:]:
        rate, rest = divmod(f.derivative(), -eta * sines)
        if rest:
            raise ArithmeticError("the rate of the time is no polynomial")
        T.append(_over_the_quarter(rate))
    with ctx.workcap(order + 1):
        log_Q = fmpq_series([f(fmpq(0)) for f in q[: order + 1]]).log()
        return [-log_Q[n] / eta for n in range(order + 1)], T


def _half_of_the_square(q: Sequence[Any], n: int) -> Any:
    """1/2 sum_(0<m<n) q_m q_(n-m), each pair once."""
    pairs = sum((q[m] * q[n - m] for m in range(1, (n + 1) // 2)), start=0 * q[0])
    return pairs if n % 2 or n == 0 else pairs + q[n // 2] * q[n // 2] * fmpq(1, 2)


def _over_the_quarter(p: fmpq_poly) -> PiNumber:
    """int_0^(pi/2) p(cos theta) d theta by Wallis' integrals."""
    wallis: list[PiNumber] = [PI / 2, PiNumber.rational(fmpq(1))]
    while len(wallis) < p.length():
        k = len(wallis)
        wallis.append(wallis[k - 2] * fmpq(k - 1, k))
    return sum((w * x for w, x in zip(wallis, p.coeffs(), strict=False)), start=PiNumber.rational(fmpq(0)))


def real_quarter(alpha: ExactReal, order: int, bits: int, small: float) -> tuple[list[arb], list[arb]]:
    """R_n and T_n for n = 0 … ``order`` in balls, good to 2^-``bits`` or so at |delta| = ``small``; alpha not 1."""
    with ctx.workprec(BOUND_BITS):
        (Q_bounds, T_bounds), sizes = (_bounds(alpha, order + 1, radius) for radius in (RADIUS, 1))
    terms = int((bits + _largest((Q_bounds, T_bounds), small)) / log2(RADIUS)) + 8
    with ctx.workprec(bits + GUARD + int(_largest(sizes, small))):
        a, kappa = alpha.ball(), arb.pi() / 2
        q, rates = _orders(a, order + 1, terms + 1)
        Q: Bounds = {(n,): kappa ** (n * a) * _sum(f) for n, f in enumerate(q)}
        T: Bounds = {(n,): kappa ** (n * a + 1) * _sum(f, n * a + 1) for n, f in enumerate(rates)}
        Q, T = enclose(Q, Q_bounds, RADIUS, terms), enclose(T, T_bounds, RADIUS, terms)
        with ctx.workcap(order + 1):
            R = arb_series([Q[(n,)] for n in range(order + 1)]).log() / (1 - a)
            return [R[n] for n in range(order + 1)], [T[(n,)] for n in range(order + 1)]


def _bounds(alpha: ExactReal, order: int, radius: int) -> tuple[Bounds, Bounds]:
    """B for Q_n and for T_n, n >= 1, with the functions on |t| < ``radius``."""
    ring = bound_ring(Forces.read([alpha], order), radius)
    y = order_series(ring, indices(1, order))
    kappa, a, slope = arb.pi() / 2, ring.velocities[0], abs(ring.slopes[0])
    rates = [arb(1), *(ring.cosine * y[(n,)] for n in range(1, order + 1))]
    Q: Bounds = {
        (n,): kappa ** (n * a) * slope * ring.turn * ring.powers[0] * rates[n - 1] for n in range(1, order + 1)
    }
    return Q, {(n,): kappa ** (n * a + 1) * rates[n] for n in range(1, order + 1)}


def _largest(bounds: tuple[Bounds, ...], small: float) -> float:
    """The largest log2 of B small^n, in floats: it chooses the number of terms and bits."""
    size = log2(small)
    return max(0.0, *(float(b.log() / arb(2).log()) + n * size for part in bounds for (n,), b in part.items()))


def _orders(a: arb, order: int, terms: int) -> tuple[list[arb_poly], list[arb_poly]]:
    """q_0 … q_order and [1 + c Y]_0 … [1 + c Y]_(order-1), in t, the latter with a coefficient less."""
    cosine, sine_ratio = elementary_series(terms)
    sines, eta = sine_ratio_power(a, terms), a - 1

    def cut(f: arb_poly) -> arb_poly:
        return f.truncate(terms)

    turn = cut((((arb.pi() / 2) ** 2) * sine_ratio).left_shift(1))
    swing, lift = cut(sines * cosine), eta * cut(sines * turn)
    q = [arb_poly([1])]
    for n in range(1, order + 1):
        tick(f"order {n} of {order} of the quarter swing")
        grown = cut(swing * _times(q[-1], (n - 1) * a)) + cut(lift * q[-1])
        q.append(_divided(grown, n * a) - cut(_half_of_the_square(q, n)))
    inverse = sine_ratio_power(-1 - a, terms - 1) * (1 / (eta * (arb.pi() / 2) ** 2))
    rates = [(inverse * _times(f, n * a).right_shift(1)).truncate(terms - 1) for n, f in enumerate(q) if n]
    return q, rates


def _times(f: arb_poly, exponent: arb | int) -> arb_poly:
    """D: the coefficient of t^j times ``exponent`` + 2j."""
    return arb_poly([(exponent + 2 * j) * x for j, x in enumerate(f.coeffs())])


def _divided(f: arb_poly, exponent: arb) -> arb_poly:
    """I: the coefficient of t^j divided by ``exponent`` + 2j; none at j = 0."""
    return arb_poly([arb(0)] + [x / (exponent + 2 * j) for j, x in enumerate(f.coeffs()[1:], 1)])


def _sum(f: arb_poly, exponent: arb | None = None) -> arb:
    """f at t = 1, or the integral of theta^(exponent - 1) f there (without theta^exponent)."""
    coefficients = f.coeffs() if exponent is None else [x / (exponent + 2 * j) for j, x in enumerate(f.coeffs())]
    return sum(coefficients, arb(0))
