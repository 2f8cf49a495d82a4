"""The Stokes constants c_k (amplitude) and d_k (time) of the half-swing of one law, in balls.

On the lower half of the imaginary z-axis, z = -iy, reversibility and real coefficients give

    D = Phi_+ - Phi_- = 2 Re Phi_+,   w = i Im Phi_+,   theta_+ - theta_- = 2 Re theta_+    (derivation ``abel-petal``),

so with v = -Im Phi_+ and q = e^(-2 pi v) all is real: D = sum c_k q^k, 2 Re theta_+ = sum d_k q^k.  Each height y is
one equation; m heights are a linear system for c_1 … c_m, whose right side carries the tail

    |sum_(k>m) c_k q^k| <= 2 s Q^(m+1)/(1 - Q),   Q = e^(2 pi (Y_0 - v)),       (``petal``).

The first half of them is kept: c_n is then off by about 2 s e^(2 pi n Y_0) Q^(m+1-n), and needs Phi_+ to q^n times
that.

How high, how many terms and how many bits is estimated in floats: it decides how narrow the balls are, nothing else.

>>> from asymptotics.numbers.exact import parse_real
>>> c, d = stokes_balls(parse_real("2", "alpha"), 1, 12)
>>> c[0].str(12), d[0].str(12)
('[-0.0909280010378 +/- ...]', '[0.412525358564 +/- ...]')
"""

from dataclasses import dataclass
from math import ceil, log, log2, log10, pi

from flint import arb, arb_mat

from asymptotics.costs import node_seconds
from asymptotics.errors import LimitError, UndecidedError
from asymptotics.expansions.divergence.abel import at_height, odd_series
from asymptotics.expansions.divergence.germ import Germ, germ, majorants
from asymptotics.expansions.divergence.petal import Petal, petal
from asymptotics.numbers.context import ctx
from asymptotics.numbers.exact import ExactReal
from asymptotics.running.budget import Unasked, allowed, require_seconds, tick

ROUGH_ORDER, ROUGH_BITS = 24, 100
"""Of the first germ, from which the petal is taken."""
# From one height to the next q falls by e^(-pi/2) = 0.21. Closer heights are harder to tell apart, farther ones want
# more digits of Phi; the solution in balls says what has come of it.
SPACING = 0.25
# Limits of time: near alpha = 1 all grows like 1/|alpha - 1|.
MAX_ORDER = 400
MAX_SECONDS = Unasked(600)


@dataclass(frozen=True)
class Effort:
    """The heights y_0 < y_1 < …, the order of the germ, and the bits: floats that choose."""

    heights: tuple[float, ...]
    order: int
    bits: int
    small: float


def rough_petal(alpha: ExactReal) -> tuple[Germ, Petal]:
    """A germ of low order with its petal."""
    with ctx.workprec(ROUGH_BITS):
        # ``small`` says where the coefficients are wanted to these bits: at 0.3, or on the circle if that is smaller.
        g = germ(alpha, ROUGH_ORDER, ROUGH_BITS, min(0.3, float(majorants(alpha)[1].radii[0])))
        return g, petal(g)


def effort(g: Germ, p: Petal, count: int, digits: int, lift: float = 0.0) -> Effort:
    """What ``count`` constants to ``digits`` digits take, ``lift`` higher up than needed (for a second route)."""
    Y_0, size = float(p.Y_0), max(float(p.s), float(p.s_T))
    # The tail spoils the last unknowns most, so that as many again are solved for and dropped.
    m = 2 * count
    wanted = 2 * pi * count * Y_0 + log(2 * size + 1) + (digits + 4) * log(10)
    # The error of c_count in the module docstring, set to 10^-(digits + 4) and solved for v; 0.01 keeps the lowest
    # point inside the petal whatever the doubles have rounded.
    v = max(Y_0 + wanted / (2 * pi * (m + 1 - count)), float(p.Y + p.s)) + 0.01 + lift
    heights = tuple(v + SPACING * i for i in range(m))
    # c_count is read off q^count at the highest point, and the linear system takes about a digit a height.
    needed = count * 2 * pi * heights[-1] / log(10) + digits + 8 + m
    small = abs(float(g.c)) / (heights[0] - float(p.s))
    order = max(ROUGH_ORDER, ceil(needed / log10(float(g.quarter.radii[0]) / small)) + 4)
    return Effort(heights, order, ceil(needed * log2(10)) + 32, small)


def stokes_balls(
    alpha: ExactReal, count: int, digits: int, *, lift: float = 0.0, max_seconds: float = MAX_SECONDS
) -> tuple[list[arb], list[arb]]:
    """c_1 … c_count and d_1 … d_count, to about ``digits`` digits.

    LimitError where the estimated work is above ``max_seconds`` or the order above ``MAX_ORDER`` (alpha near 1: all
    grows like 1/|alpha - 1|); UndecidedError where a bound does not hold.
    """
    rough, p = rough_petal(alpha)
    plan = effort(rough, p, count, digits, lift)
    require_affordable(alpha, plan, max_seconds)
    with ctx.workprec(plan.bits):
        g = germ(alpha, plan.order, plan.bits, plan.small)
        series = odd_series(g)
        rows = []
        for y in plan.heights:
            tick(f"height {y:.1f} of {plan.heights[-1]:.1f}")
            Phi, theta = at_height(g, p, series, arb(y))
            v = -Phi.imag
            rows.append(((-2 * arb.pi() * v).exp(), 2 * Phi.real, 2 * theta.real, v))
        c, d = (_solved(p, [(r[0], r[1 + i], r[3]) for r in rows], size) for i, size in enumerate((p.s, p.s_T)))
    return c[:count], d[:count]


def _solved(p: Petal, rows: list[tuple[arb, arb, arb]], size: arb) -> list[arb]:
    """The first constants of D = sum c_k q^k from (q, D, v) at as many heights."""
    n, first = len(rows), rows[0][0]
    # With the tail as a radius the equations hold exactly for the true constants, so the solution in balls holds them.
    right = arb_mat(n, 1, [D + arb(0, p.tail(size, n, v)) for _, D, v in rows])
    # In units of the first q, so that the unknowns c_k first^k are solved for with entries of moderate size.
    powers = arb_mat(n, n, [(q / first) ** k for q, _, _ in rows for k in range(1, n + 1)])
    try:
        u = powers.solve(right, algorithm="precond")  # far narrower than elimination
    except ZeroDivisionError as singular:
        raise UndecidedError("the heights are not told apart: raise the precision") from singular
    return [u[k, 0] / first ** (k + 1) for k in range(n)]


def require_affordable(alpha: ExactReal, plan: Effort, max_seconds: float) -> None:
    """Refuse what is too large before it starts."""
    # log2(5.5) = 2.46 bits a node, on the widest of the ellipses of ``nodes``.
    seconds = node_seconds(plan.order, int(plan.bits / 2.4) + 10, plan.bits)
    told = f"the germ to order {plan.order} at {plan.bits} bits"
    max_seconds = allowed(max_seconds)
    if plan.order > MAX_ORDER or seconds > max_seconds:
        reason = f"{alpha} needs {told}, an estimated {seconds:.0f} s"
        raise LimitError("alpha", reason, f"order {MAX_ORDER} and {max_seconds:.0f} s: farther from 1, or fewer digits")
    require_seconds(seconds, told)
