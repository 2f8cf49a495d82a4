"""Where orbits of the half-swing stay in a petal, and how far the Abel functions are from z there: four numbers.

The petals of a parabolic fixed point (Leau-Fatou flower: Milnor, Dynamics in One Complex Variable, § 10), with numbers
in the place of "small enough".

For |z| >= Y (that is |delta| <= r = |c|/Y < rho, x = r/rho) let |g| <= b/|z|^2 and |T - pi| <= b_T/|z|^2:

    b = c^2 (sum_(2<=m<=M) |gamma_m| r^(m-2) + Gamma r^-2 x^(M+1)/(1 - x)),   Gamma = |c eta| gain + 1 >= |g|

(Cauchy's inequality on the circle of the majorant), b_T likewise.  With lambda = 1 - b/Y^2 > 0 and

    s = b (pi/(lambda Y) + 1/Y^2),      Y_0 = Y + 2 s + 2 b/Y^2,

orbits from Im z <= -(Y + s) keep |z_j| >= Y and their real parts grow by lambda at least, both ways of time, so that
|Phi_+ - z|, |Phi_- - z| <= s and |theta_+|, |theta_-| <= s_T; and w = (Phi_+ + Phi_-)/2 takes each value with
Im w <= -Y_0 exactly once (Rouche).  There D = Phi_+ - Phi_- is a series sum c_k q^k, q = e^(-2 pi i w), with
|c_k| <= 2 s e^(2 pi k Y_0); |d_k| <= 2 s_T e^(2 pi k Y_0) for theta_+ - theta_-.  (Derivation ``abel-petal``.)

>>> from asymptotics.numbers.exact import parse_real
>>> from asymptotics.expansions.divergence.germ import germ
>>> drag = petal(germ(parse_real("2", "alpha"), 24, 100, 0.3))
>>> drag.Y_0 < arb("3.3"), drag.s < arb("0.4")
(True, True)
"""

from dataclasses import dataclass

from flint import arb

from asymptotics.errors import UndecidedError
from asymptotics.expansions.divergence.germ import Germ
from asymptotics.numbers.context import ctx

BITS = 64
# Heights from 1.05 to 3.95 times the least one: each that is proved is a petal, and the lowest Y_0 is the most useful.
_TRIED = 60


@dataclass(frozen=True, eq=False)
class Petal:
    """Y, b, lambda, s, s_T and Y_0 of the module's first paragraph, upper bounds all (lambda: a lower one)."""

    Y: arb
    b: arb
    lam: arb
    s: arb
    s_T: arb
    Y_0: arb

    def tail(self, size: arb, heights: int, v: arb) -> arb:
        """A bound of sum_(k>n) |c_k| e^(-2 pi k v) where |c_k| <= 2 ``size`` e^(2 pi k Y_0); v > Y_0."""
        # |c_k| e^(-2 pi k v) <= 2 size Q^k: a geometric series from k = n + 1 on.
        Q = (2 * arb.pi() * (self.Y_0 - v)).exp()
        if not Q < 1:
            raise UndecidedError("the point is not in the half-plane in which the series of D converges")
        return arb((2 * size * Q ** (heights + 1) / (1 - Q)).upper())


def petal(g: Germ) -> Petal:
    """The petal with the smallest Y_0 among a few; UndecidedError if there is none."""
    with ctx.workprec(BITS):
        rho = float(g.half.radii[0])
        least = float(abs(g.c)) / rho
        found = [p for k in range(1, _TRIED) if (p := _petal(g, least * (1 + 0.05 * k))) is not None]
    if not found:
        raise UndecidedError("no petal was proved: the law is too near alpha = 1")
    return min(found, key=lambda p: float(p.Y_0))


def _petal(g: Germ, height: float) -> Petal | None:
    Y = arb(height)
    r = abs(g.c) / Y
    x = r / g.half.radii[0]
    if not x < 1:
        return None
    # Upper bounds are rounded up, lambda down, so that each number
    # may stand in the inequalities of the module docstring.
    b, b_T = (
        (g.c**2 * quadratic_bound(f, size, r, x)).upper()
        for f, size in ((g.gamma, abs(g.c * g.eta) * g.half.gains[0] + 1), (g.tau, g.half.excess))
    )
    lam = (1 - b / Y**2).lower()
    if not lam > 0:
        return None
    total = arb.pi() / (lam * Y) + 1 / Y**2
    s, s_T = (b * total).upper(), (b_T * total).upper()
    return Petal(Y, b, lam, s, s_T, (Y + 2 * s + 2 * b / Y**2).upper())


def quadratic_bound(f: tuple[arb, ...], size: arb, r: arb, x: arb) -> arb:
    """A bound of |f(delta)/delta^2| on |delta| <= r for f = O(delta^2) with |f| <= ``size`` on |delta| <= r/x."""
    # Degrees 0 and 1 are zero by theorem; the next ones as they are, then Cauchy on the circle of the majorant, r/x.
    total = sum((abs(f[m]) * r ** (m - 2) for m in range(2, len(f))), arb(0))
    return arb((total + size * x ** len(f) / ((1 - x) * r**2)).upper())
