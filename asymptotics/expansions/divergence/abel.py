"""The Abel function of the half-swing and its time at complex points: Phi_+ = lim (z_j - j), theta_+ = -sum (T_j - pi).

Phi_+ is the Fatou coordinate of a parabolic fixed point (Milnor, Dynamics in One Complex Variable, § 10).

The odd Laurent series c/delta + e_1 delta + e_3 delta^3 + … solves Phi(F) = Phi + 1 formally, and t_1 delta + t_3
delta^3 + … solves theta(F) = theta + T - pi; both diverge.  Cut off after delta^N each leaves a defect that is analytic
in the circle of the majorant,

    E = Phi_N(F) - Phi_N - 1 = sum_(m>N+1) E_m delta^m,     |E| <= C_N = |c eta| gain + 1 + sum |e_j| (S^j + rho^j)

on |delta| = rho.  Along an orbit with Re z_J >= X >= Y, where |delta_j| <= |c|/(X + (j-J) lambda),

    sum_(j>=J) |delta_j|^m <= |c|^m (X^(-m) + X^(1-m)/((m-1) lambda)),

so Phi_+(delta_0) = Phi_N(delta_J) - J up to a sum that is known: the next coefficients as they are, Cauchy's inequality
beyond.  The time likewise, with |T - pi| <= the excess of the majorant in C_N.

>>> from asymptotics.numbers.exact import parse_real
>>> from asymptotics.expansions.divergence.germ import germ
>>> from asymptotics.expansions.divergence.petal import petal
>>> with ctx.workprec(150):
...     drag = germ(parse_real("2", "alpha"), 40, 150, 0.1)
...     series = odd_series(drag)
...     Phi, theta = at_height(drag, petal(drag), series, arb(8))
>>> Phi.imag.str(8), abs(Phi.real) < 1e-20                                 # w = i Im Phi, D = 2 Re Phi
('[-7.9874981 +/- ...]', True)
"""

from dataclasses import dataclass

from flint import acb, arb, arb_poly

from asymptotics.errors import UndecidedError
from asymptotics.expansions.divergence.germ import Germ
from asymptotics.expansions.divergence.half_step import half_step
from asymptotics.expansions.divergence.petal import BITS, Petal
from asymptotics.expansions.half_swings.odd_abel import odd_solution
from asymptotics.numbers.context import ctx
from asymptotics.running.budget import tick

# A limit of time: an orbit that is not in the petal by then is undecided.
_MAX_STEPS = 20_000
_FOLLOWING = 0.35
"""The part of the known orders that is kept of the defect, as it is: what lies beyond falls fast enough then."""


@dataclass(frozen=True, eq=False)
class OddSeries:
    """The coefficients of delta^1, delta^3, … and those of the defect that they leave, from delta^0 on (zeros first).

    ``rise`` bounds |f(F) - f| wanted on the circle: of 1 - c/F + c/delta for Phi - c/delta, of T - pi for theta.
    """

    coefficients: tuple[arb, ...]
    defect: tuple[arb, ...]
    rise: arb


def odd_series(g: Germ) -> tuple[OddSeries, OddSeries]:
    """Phi - c/delta and theta, to as many odd orders as the germ allows.

    The first coefficients, c for Phi and 0 for theta, are known; ArithmeticError as in ``odd_solution``.
    """
    known = g.order - 1
    # Odd powers only, hence the half; the orders that they leave are those of the defect that are kept as they are.
    terms = int((1 - _FOLLOWING) * known / 2) + 1
    found = [odd_solution(g.F[: known + 1], rise, terms) for rise in ([arb(1)], g.tau)]
    rises = (abs(g.c * g.eta) * g.half.gains[0] + 1, g.half.excess)
    Phi, theta = (
        OddSeries(tuple(f[1:]), (arb(0),) * (2 * terms) + tuple(rest), r)
        for (f, rest), r in zip(found, rises, strict=True)
    )
    return Phi, theta


def at_height(g: Germ, p: Petal, series: tuple[OddSeries, OddSeries], y: arb) -> tuple[acb, acb]:
    """(Phi_+, theta_+) at z = -iy, y >= Y + s; UndecidedError outside the petal or where the balls become too wide."""
    if not y >= p.Y + p.s:
        raise UndecidedError("the point is not certainly in the petal")
    return at(g, p, series, acb(0, -y))


def at(g: Germ, p: Petal, series: tuple[OddSeries, OddSeries], z: acb) -> tuple[acb, acb]:
    """(Phi_+, theta_+) at any z whose orbit reaches the petal."""
    delta, theta, steps = g.c / z, acb(0), 0
    wanted = max(100.0, 16 * float(abs(z)), 3.0 * g.order)  # steps are cheap: few digits are lost to the defects
    while not (g.c / delta).real > wanted:
        tick(f"half-swing {steps} of about {wanted:.0f} into the petal")
        delta, tau = half_step(g, delta)
        theta, steps = theta - tau, steps + 1
        if steps > _MAX_STEPS:
            raise UndecidedError("the orbit was not followed into the petal: raise the precision")
    # Rounded down: a smaller X has larger bounds.
    X = arb((g.c / delta).real.lower())
    Phi, late = (delta * arb_poly(list(f.coefficients))(delta * delta) + later(g, p, f, X) for f in series)
    return g.c / delta + Phi - steps, theta + late


def later(g: Germ, p: Petal, f: OddSeries, X: arb) -> acb:
    """The sum of all defects from a point with Re z >= X on, as a disc around 0."""
    with ctx.workprec(BITS):
        # From here on |g| <= b/|z|^2 <= b/X^2, so that Re z gains at least lam a step and |delta_j| <= |c|/(X + j lam).
        lam, size, rho, S = 1 - p.b / X**2, abs(g.c) / X, g.half.radii[0], g.half.final(0)
        if not (X >= p.Y and lam > 0 and size < rho):
            raise UndecidedError("the orbit is not certainly in the petal")

        def along(m: int) -> arb:
            """A bound of sum_j |delta_j|^m."""
            # The first term, and the integral of (X + j lam)^(-m) over j for the others.
            return size**m * (1 + X / ((m - 1) * lam))

        known = sum((abs(c) * along(m) for m, c in enumerate(f.defect) if m > 1), arb(0))
        last = len(f.defect)
        # |E| on the circle: S bounds |F| there, so that this is |Phi_N(F)| + |Phi_N| beside the rise.
        circle = f.rise + sum(
            (abs(e) * (S ** (2 * k + 1) + rho ** (2 * k + 1)) for k, e in enumerate(f.coefficients)), arb(0)
        )
        # Cauchy's |E_m| <= circle rho^(-m), and the sum of |delta_j|^m falls by size at least from one m to the next.
        beyond = circle / (1 - size / rho) * along(last) / rho**last
        radius = arb((known + beyond).upper())
    # The square that holds the disc.
    return acb(arb(0, radius), arb(0, radius))
