"""The quarter swing of one law with an even exponent, exactly, by the reciprocal of its local strength.

With u the local strength at the angle theta, Q = delta/u = e^(-eta R), eta = alpha - 1 (see ``quarter`` for s, c, Y),

    Q' = eta delta s^(alpha+1) (1 + c Y),    Q Q' = delta s^alpha (c Q' + eta s Q)   (derivation ``one-law-quarter``),

so the left side is (Q²)'/2: order by order a square, each pair of factors once, and the time d tau/d theta = 1 + c Y is
linear in Q.  For alpha even these are polynomials in c: (Q²)_c/2 = delta s^alpha (c Q_c - eta Q) and 1 + c Y =
-Q_c/(eta delta s^alpha), a division without remainder.  Any other exponent: ``nodes``.

>>> R, T = even_quarter(2, 3)
>>> R[1], R[2], T[1], T[2]
(-2/3, 1/18, 1/3, -2/9 + pi/12)
"""

from collections.abc import Sequence
from typing import Any

from flint import fmpq, fmpq_poly, fmpq_series

from asymptotics.expansions.half_swings.pi_ring import PI, PiNumber
from asymptotics.numbers.context import ctx
from asymptotics.running.budget import tick


def even_quarter(alpha: int, order: int) -> tuple[list[fmpq], list[PiNumber]]:
    """R_n and T_n for n = 0 … ``order``, exactly; alpha even and not negative (T_0 = pi/2)."""
    eta, c, sines = fmpq(alpha - 1), fmpq_poly([0, 1]), fmpq_poly([1, 0, -1]) ** (alpha // 2)
    q = [fmpq_poly([1])]
    for n in range(1, order + 2):
        tick(f"order {n} of the quarter swing")
        last = q[n - 1]
        # The integral of the right side; Q = 1 at the turning point, so that it starts at c = 1.
        primitive = (sines * (c * last.derivative() - eta * last)).integral()
        q.append(primitive - primitive(fmpq(1)) - _half_of_the_square(q, n))
    T = [PI / 2]
    for f in q[2:]:
        rate, rest = divmod(f.derivative(), -eta * sines)
        # Exact arithmetic: a remainder would contradict the derivation.
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
