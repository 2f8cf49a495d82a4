"""The quarter swing of one law in balls, order by order by its values at Chebyshev nodes: products are pointwise.

A collocation method with a proof: the interpolants are bounded on Bernstein ellipses (Trefethen 2013).

With v = sin(theta/2)^2, 0 <= v <= 1/2, P = e^(eta R), eta = alpha - 1, and C = P Y (see ``quarter`` for s, c, Y)

    s^2 = 4 v (1 - v),  c = 1 - 2v,   Y = delta s^alpha (P + c C),   dP/dv = -2 eta C,
    d tau = (1 + c Y) dv/sqrt(v (1 - v))                              (derivation ``one-law-quarter``).

For delta = b x, with a number b near the strengths that are wanted, P = sum x^n (2v)^(n alpha/2) p_n(v), Y and C alike:

    y_n = b (2 (1 - v))^(alpha/2) (p_(n-1) + c C_(n-1)),   C_n = sum_(m<n) p_m y_(n-m),   p_n = -2 eta v H C_n,
    tau_n(v = 1/2) = 2^(-1/2) H (1 - v)^(-1/2) c y_n,      H f(v) = int_0^1 u^(beta-1) f(u v) du,

beta = n alpha/2 + 1 for p_n, n alpha/2 + 1/2 for tau_n.  Products are taken at the nodes, where they err by nothing but
rounding; h = H f solves beta h + v h' = f, on polynomials in x = 4v - 1 by two recursions of Chebyshev coefficients.

*Bounds.*  All p_n, y_n, C_n are analytic in |v| < 1, so in each ellipse |x + sqrt(x^2 - 1)| < rho < 3 + sqrt(8).  With
a = (rho + 1/rho)/8 there |v| <= 1/4 + a, |1 - v| <= 3/4 + a, |1 - v| >= 3/4 - a, |c| <= 1/2 + 2a, and as the ellipse is
convex and holds v = 0, |H f| <= |f|/beta: the recursion in absolute values bounds |y_n| and |C_n|.  The interpolant
of f at K nodes differs from f on 0 <= v <= 1/2 by (Trefethen 2013, theorem 8.2)

    4 |f| rho^(1-K)/(rho - 1)     at most;   over beta that is the error of H f.

>>> from asymptotics.numbers.exact import parse_real
>>> R, T = node_quarter(parse_real("3/2", "alpha"), 2, 60, 1.0)
>>> R[1].str(12), T[1].str(12)
('[-0.718884140841 +/- ...]', '[0.400000000000 +/- ...]')
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil, inf, log
from operator import mul

from flint import arb, arb_series

from asymptotics.expansions.half_swings.node_transform import NodeTransform
from asymptotics.numbers.context import ctx
from asymptotics.numbers.exact import ExactReal
from asymptotics.running.budget import tick

# GUARD for the rounding of the recursion; fewer than SPARE lost bits are not worth a second pass. All of it is in the
# radii: none of the three can make a ball wrong.
BOUND_BITS, GUARD, SPARE = 64, 40, 8
# All below 3 + sqrt(8) = 5.83, where the ellipse reaches v = 1 and (1 - v)^(alpha/2) is no longer analytic.
ELLIPSES = ("5.5", "4", "3")
"""The parameters rho that are tried: the widest has the fastest error, the narrower ones the smaller bounds."""


def node_quarter(
    alpha: ExactReal, order: int, bits: int, small: float, foreseen: int = 0
) -> tuple[list[arb], list[arb]]:
    """R_n and T_n for n = 0 … ``order``, good to 2^-``bits`` or so at |delta| = ``small``; alpha > 0, not 1.

    ``foreseen``: the `lost_bits` to begin with, which spares a second pass.
    """
    ellipse, right = _suited(alpha, order, bits, foreseen, small), bits + foreseen
    ends, durations = _at_nodes(alpha, order, right, small, ellipse, ellipse.nodes(bits, foreseen))
    lost = _lost(bits, [*ends, *durations])
    if lost >= SPARE:  # small exponents alone: the radii grow by some bits an order
        right += lost
        ends, durations = _at_nodes(alpha, order, right, small, ellipse, ellipse.nodes(bits, foreseen + lost))
    with ctx.workprec(right + GUARD), ctx.workcap(order + 1):
        # P = e^(eta R) at v = 1/2, as a series in x = delta/small.
        scales, log_P = [arb(small) ** n for n in range(order + 1)], arb_series(ends, order + 1).log()
        R = [log_P[n] / (alpha.ball() - 1) / scale for n, scale in enumerate(scales)]
        return R, [t / scale for t, scale in zip(durations, scales, strict=True)]


def lost_bits(alpha: ExactReal, order: int, bits: int, small: float) -> int:
    """By how many bits the widest ball of a first pass is wider than 2^-``bits``."""
    ellipse = _suited(alpha, order, bits, 0, small)
    ends, durations = _at_nodes(alpha, order, bits, small, ellipse, ellipse.nodes(bits))
    return _lost(bits, [*ends, *durations])


def _suited(alpha: ExactReal, order: int, bits: int, foreseen: int, small: float) -> "_Ellipse":
    with ctx.workprec(BOUND_BITS):
        ellipses = [_Ellipse.of(alpha.ball(), arb(rho), order, arb(small)) for rho in ELLIPSES]
    # Doubles choose among three theorems, each of which holds.
    return min(ellipses, key=lambda e: e.nodes(bits, foreseen))


def _at_nodes(
    alpha: ExactReal, order: int, bits: int, small: float, ellipse: "_Ellipse", nodes: int
) -> tuple[list[arb], list[arb]]:
    with ctx.workprec(bits + GUARD):
        return _Orders(alpha.ball(), arb(small), ellipse, nodes).through(order)


@dataclass(frozen=True, eq=False)
class _Ellipse:
    """Upper bounds of |C_n| and of |(1 - v)^(-1/2) c y_n|, n = 0 … order, in the ellipse rho."""

    rho: arb
    C: tuple[arb, ...]
    rates: tuple[arb, ...]

    @classmethod
    def of(cls, alpha: arb, rho: arb, order: int, small: arb) -> "_Ellipse":
        """The recursion of the module docstring in absolute values."""
        # Each function by its largest modulus in the ellipse, which |v - 1/4| <= a holds, and H f by |f|/beta.
        a = (rho + 1 / rho) / 8
        cosine, near = arb(1) / 2 + 2 * a, 1 / (arb(3) / 4 - a).sqrt()
        force, slope = small * (2 * (arb(3) / 4 + a)) ** (alpha / 2), 2 * abs(alpha - 1) * (arb(1) / 4 + a)
        p, y, C = [arb(1)], [arb(0)], [arb(0)]
        for n in range(1, order + 1):
            y.append(force * (p[-1] + cosine * C[-1]))
            C.append(sum(map(mul, p, reversed(y)), arb(0)))
            p.append(slope * C[-1] / (n * alpha / 2 + 1))
        return cls(rho, tuple(C), tuple(near * cosine * x for x in y))

    def nodes(self, bits: int, lost: int = 0) -> int:
        """How many nodes make all errors less than 2^-``bits``, in floats: the choice moves the error only.

        ``lost``: the bits by which an error of the first order grows until the last one; a later one grows less.
        """
        shares = [lost * (1 - n / len(self.C)) * log(2) for n in range(len(self.C))]
        largest = max(s + float((1 + x).log()) for part in (self.C, self.rates) for s, x in zip(shares, part))
        # Six nodes more than the estimate of doubles; what they leave is ``gap``, an upper bound.
        return int((bits * log(2) + largest) / log(float(self.rho))) + 6

    def interpolation_error(self, nodes: int, bound: arb) -> arb:
        """How far a function of this bound is from its interpolant."""
        with ctx.workprec(BOUND_BITS):
            return arb((4 * bound * self.rho ** (1 - nodes) / (self.rho - 1)).upper())


class _Orders:
    """The recursion at the nodes: the values p_n(v_i), y_n(v_i), C_n(v_i) as balls."""

    def __init__(self, alpha: arb, small: arb, ellipse: _Ellipse, nodes: int) -> None:
        self.alpha, self.ellipse, self.nodes = alpha, ellipse, nodes
        self.transform = NodeTransform(nodes)
        self.v = [(1 + x) / 4 for x in self.transform.places]
        self.cosine = [1 - 2 * v for v in self.v]
        self.force = [small * (2 * (1 - v)) ** (alpha / 2) for v in self.v]
        self.weights = [c / (1 - v).sqrt() for c, v in zip(self.cosine, self.v, strict=True)]

    def through(self, order: int) -> tuple[list[arb], list[arb]]:
        """p_n and tau_n at v = 1/2, n = 0 … ``order``."""
        eta, bits = self.alpha - 1, ctx.prec
        p, C = [arb(1)] * self.nodes, [arb(0)] * self.nodes
        # A row for each node: the convolution at a node is a sum over its own two rows.
        all_p: list[list[arb]] = [[x] for x in p]
        all_y: list[list[arb]] = [[] for _ in p]
        ends = [arb(1)]
        for n in range(1, order + 1):
            tick(f"order {n} of {order} of the quarter swing")
            # The radii count the rounding, at however many bits.
            with ctx.workprec(_fewer(bits, C) if n > 1 else bits):  # what is small needs fewer right bits
                y = (f * (a + c * x) for f, a, c, x in zip(self.force, p, self.cosine, C, strict=True))
                for row, value in zip(all_y, y, strict=True):
                    row.append(value)
                C = [sum(map(mul, a, reversed(b)), arb(0)) for a, b in zip(all_p, all_y, strict=True)]
                means = [x for (x,) in self.transform.sums([[x] for x in C])]
                h, error = self.integral(means, n * self.alpha / 2 + 1, self.ellipse.C[n])
                # 2 v <= 1: this is at least 2 |eta| v times the error of H f, at the nodes and at the end.
                around = arb(0, (abs(eta) * error).upper())
                there = self.transform.values(h)
                p = [-2 * eta * v * x + around for v, x in zip(self.v, there, strict=True)]
                for row, value in zip(all_p, p, strict=True):
                    row.append(value)
                ends.append(-eta * sum(h, arb(0)) + around)
        return ends, [arb.pi() / 2, *self.durations(all_y)]

    def durations(self, all_y: Sequence[Sequence[arb]]) -> list[arb]:
        """tau_n at v = 1/2 from the y_n at the nodes, n = 1, 2, …."""
        rates = [[w * x for x in row] for w, row in zip(self.weights, all_y, strict=True)]
        found = []
        for n, means in enumerate(zip(*self.transform.sums(rates)), 1):
            tick("the durations of the quarter swing")
            h, error = self.integral(means, (n * self.alpha + 1) / 2, self.ellipse.rates[n])
            # T_k(1) = 1: at v = 1/2, x = 1, the sum of the coefficients
            # is the value, and the gap is added to its radius.
            found.append((sum(h, arb(0)) + arb(0, error.upper())) * arb("0.5").sqrt())
        return found

    def integral(self, means: Sequence[arb], beta: arb, bound: arb) -> tuple[list[arb], arb]:
        """Of H f from the sums of f T_k over the nodes: coefficients, and how far f and its interpolant are apart."""
        # Discrete orthogonality of the T_k: the coefficients of the interpolant.
        coefficients = [2 * x / self.nodes for x in means]
        return _solved(coefficients, beta), self.ellipse.interpolation_error(self.nodes, bound) / beta


def _solved(f: Sequence[arb], beta: arb) -> list[arb]:
    """h with beta h + (x + 1) h' = f, from f_0/2 + sum f_k T_k to sum h_k T_k; from the highest coefficient down.

    (x + 1) h' has the coefficients s_k + k h_k, where s_(k-1) = s_k + 2 k h_k; s_0 counts half.

    >>> [x.str(3) for x in _solved([arb(8), arb(3)], arb(2))]                # 4 + 3x = 2 (3/2 + x) + (x + 1)
    ['1.50', '1.00']
    """
    h, s = [arb(0)] * len(f), arb(0)
    for k in range(len(f) - 1, 0, -1):
        h[k] = (f[k] - s) / (beta + k)
        s = (s * (beta - k) + 2 * k * f[k]) / (beta + k)  # s + 2 k h_k with s once: the radii do not grow
    h[0] = (f[0] - s) / (2 * beta)
    return h


def _fewer(bits: int, values: Sequence[arb]) -> int:
    """``bits`` less what the largest value is below 1."""
    largest = max(float(abs(x).upper().log()) for x in values) / log(2)
    return max(BOUND_BITS, bits + min(0, int(largest)))


def _lost(bits: int, values: Sequence[arb]) -> int:
    """The bits by which the widest ball is wider than 2^-``bits``."""
    widest = max(float(x.rad().log()) if x.rad() > 0 else -inf for x in values)
    return ceil(max(0.0, widest / log(2) + bits))
