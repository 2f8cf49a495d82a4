"""V, p and Omega of one law in the turning-point gauge to high order, from the Abel function and its time.

dPhi/dpsi = 1/pi and W = d tau/d psi make (derivation ``large-orders``)

    V = 1/(pi Phi'),     W = 1 + V theta',     p = -V/((alpha - 1) delta W),     Omega = 1/W,

In the law of each (``large_orders``) the factor 1 + g_1/n + g_2/(n (n-1)) + … is that of one exponential:
with x = 1/y at z = -iy, delta^2 = -c^2 x^2, eps_n = e_n c^n, the numbers g_j = (2 pi)^j a_j belong to

    sum a_j x^j = exp(2 pi (eps_1 x - eps_3 x^3 + …)) times V/(V_2 delta^2), p/(p_1 delta W) or
    (1 - (pi c_1/d_1) (W - 1))/W^2,                                              for V, p and Omega.

The odd coefficients e_n, t_n of Phi and theta follow from the half-swing alone and give all rows in balls.  It is
a second route to the coefficients of ``normal_form``, and for any exponent a fast one: alpha = 3/2 to order 60 takes
two seconds.

>>> from asymptotics.numbers.exact import parse_real
>>> rows = rows_of(parse_real("2", "alpha"), 5)
>>> rows.p[1].str(10), rows.p[3].str(10), rows.Omega[2].str(10)
('[0.4244131816 +/- ...]', '[0.004715702018 +/- ...]', '[-0.1666666667 +/- ...]')
"""

from dataclasses import dataclass

from flint import arb, arb_series

from asymptotics.expansions.divergence.germ import germ, majorants
from asymptotics.expansions.half_swings.odd_abel import odd_solution
from asymptotics.numbers.context import ctx
from asymptotics.numbers.exact import ExactReal


@dataclass(frozen=True, eq=False)
class SeriesRows:
    """The coefficients of delta^0, delta^1, … of V, W, p and Omega; e_1, e_3, … and t_1, t_3, … of Phi and theta."""

    V: tuple[arb, ...]
    W: tuple[arb, ...]
    p: tuple[arb, ...]
    Omega: tuple[arb, ...]
    c: arb
    Phi: tuple[arb, ...]
    theta: tuple[arb, ...]


def rows_of(alpha: ExactReal, order: int, bits: int = 100) -> SeriesRows:
    """All rows through ``order``, to about ``bits`` relative bits or somewhat fewer; alpha > 0, not 1."""
    terms = order // 2 + 1
    length = order + 3
    radius = float(majorants(alpha)[0].radii[0])
    with ctx.workprec(bits + 4 * length):
        g = germ(alpha, 2 * terms + 4, bits + 4 * length, radius)
        Phi, theta = (odd_solution(g.F, rise, terms + 1)[0][1:] for rise in ([arb(1)], g.tau))
        with ctx.workcap(length):
            slope = [arb(0)] * length  # delta^2 Phi'
            late = [arb(0)] * length  # theta'
            slope[0] = -g.c
            for k, (e, t) in enumerate(zip(Phi, theta, strict=True)):
                for row, place, value in ((slope, 2 * k + 2, e), (late, 2 * k, t)):
                    if place < length:
                        row[place] = (2 * k + 1) * value
            quotient = arb_series(slope, length).inv() / arb.pi()  # V/delta^2
            V = arb_series([0, 0, 1], length) * quotient
            W = 1 + V * arb_series(late, length)
            p = -arb_series([0, 1], length) * quotient / W / g.eta
            Omega = W.inv()
        rows = [tuple(f[n] for n in range(order + 1)) for f in (V, W, p, Omega)]
    return SeriesRows(rows[0], rows[1], rows[2], rows[3], g.c, tuple(Phi), tuple(theta))


def corrections(rows: SeriesRows, row: str, c_1: arb, d_1: arb, count: int) -> tuple[arb, ...]:
    """g_1 … g_count of ``row`` "V", "p" or "Omega"; as many as ``rows`` has orders less two at most.

    >>> from asymptotics.numbers.exact import parse_real
    >>> rows = rows_of(parse_real("2", "alpha"), 6)
    >>> [x.str(8) for x in corrections(rows, "V", arb(0), arb(0), 2)]            # f = 2 pi^2/5
    ['[3.9478418 +/- ...]', '[3.8448855 +/- ...]']
    """
    with ctx.workcap(count + 1):

        def along(f: tuple[arb, ...], first: int) -> arb_series:
            """f/delta^first at z = -iy, by x."""
            even = [f[first + n] * rows.c**n * (-1) ** (n // 2) if n % 2 == 0 else arb(0) for n in range(count + 1)]
            return arb_series(even, count + 1)

        W = along(rows.W, 0)
        if row == "Omega":
            shape = (1 - (W - 1) * (arb.pi() * c_1 / d_1)) / (W * W)
        else:
            shape = along(rows.V, 2) / rows.V[2] if row == "V" else along(rows.p, 1) / rows.p[1] / W
        exponent = [arb(0)] * (count + 1)
        for j, e in enumerate(rows.Phi[: (count + 1) // 2]):
            exponent[2 * j + 1] = 2 * arb.pi() * (-1) ** j * e * rows.c ** (2 * j + 1)
        found = arb_series(exponent, count + 1).exp() * shape
        return tuple((2 * arb.pi()) ** j * found[j] for j in range(1, count + 1))
