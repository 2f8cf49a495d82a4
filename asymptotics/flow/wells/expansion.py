"""The motion next to a turning point u_0, as an enclosure: u and tau in powers of the speed, with a majorant.

A generalized power series (exponents 2 n_0 + sum alpha_i n_i), bounded by Cauchy's method of majorants.

With w as the variable, P = G(u, w) = P_0 (1 - r), P_0 = s_0(u_0), and Q = 1/P (coefficients by exponent e),

    du/dw = -w/P,    d tau/dw = 1/P,
    u_e = -Q_(e-2)/e,    Q_e = -(1/P_0) sum_(0<f<=e) P_f Q_(e-f),    tau_(e+1) = Q_e/(e+1),

P_e being the coefficient of G(u(w), w) (``composition``).  The same series serves both ends: P_0 > 0 where a
half-swing begins, P_0 < 0 where it ends (then tau <= 0).

*Majorant* (derivation ``wells-majorant``).  In z_0 = w^2, z_i = w^alpha_i every monomial of eta = u_0 - u has a
factor z_0, so its exponent is at least 2 and eta << (z_0/(2 |P_0|))/(1 - r).  With the absolute Taylor coefficients
of G,

    eta << H,  r << R,    H = a/(1 - R),    a = z_0/(2 |P_0|),
    R = [largest change of s_0 within H + sum_i epsilon_i (|u_0| + H)^m_i z_i]/|P_0|.

If numbers H, R < 1 fulfil a/(1 - R) <= H, the series converge absolutely there and are at most H and R.
Tail: with z_i made 2^(g_i) times larger and H*, R* there, the terms with sum n_i g_i >= G add up to at most 2^(-G)
H*.

>>> from asymptotics.law import Law
>>> with ctx.workprec(60):
...     force = WellForce.of(Law({"3/2": "1/10"}).terms)
...     start = WellExpansion.at(force, arb(1))
...     u, tau = start.state(arb("0.0625"))
...     u.str(12), tau.str(12)
('[0.998043212541 +/- ...]', '[0.0625799720549 +/- ...]')
"""

from dataclasses import dataclass
from fractions import Fraction
from math import ceil, gcd
from operator import mul

from flint import arb, arb_poly

from asymptotics.errors import UndecidedError
from asymptotics.flow.balls import dyadic, in_doubles, size_of, upper
from asymptotics.flow.composition import ComposedSeries, ExponentGrid, ExponentLine, Simplex, keys_of
from asymptotics.flow.linear_spring.kept_terms import KeptTerms, Key, plan_for
from asymptotics.flow.wells.force import WellForce
from asymptotics.numbers.context import ctx

# Strengths and speeds are rounded up to a quarter of a power of two, so that plans are shared; 40 bits for what is a
# choice.
_STEPS, _LOW = 4, 40
# A smaller share hands over at lower speeds, a larger one runs into the majorant's edge sooner.  Pendulums
# cost the same within a quarter from 0.3 to 0.9 (``benchmarks/constants.json``); a plan that is too bold is shrunk
# below, and none is trusted.
_SHARE = 0.6  # of P_0 that the spring may change within the scale
# Shares of the distance for which a plan is made, one after the other until one has a majorant; how many there are
# decides how early an expansion is refused.
_SHRINKING = (1.0, 0.7, 0.5, 0.3, 0.2, 0.1, 0.03, 0.01)


@dataclass(frozen=True)
class WellExpansion:
    """u(w) and tau(w)/w at the turning point ``u0`` for 0 <= w <= ``reach``, with the bounds of their tails.

    ``brake`` is P_0, ``slowness`` has the coefficients Q_e/(e+1) of tau/w.  On a line the variable is w^``step``; else
    ``keys`` are the monomials in w^2, w^alpha_i.
    """

    force: WellForce
    u0: arb
    brake: arb
    reach: arb
    step: Fraction
    keys: tuple[Key, ...]
    u: arb_poly
    slowness: arb_poly
    tail: arb
    time_tail: arb

    @classmethod
    def at(cls, force: WellForce, u0: arb, w: arb | None = None) -> "WellExpansion":
        """The expansion at a turning point u0, for speeds up to ``w`` (without it: up to what is cheapest).

        UndecidedError where the mass might rest there, or the majorant does not provably converge.
        """
        brake = force.restoring(u0)
        # P_0 divides in every coefficient; where its sign is open the mass might stay.
        if not (brake > 0 or brake < 0):
            raise UndecidedError("whether dry friction holds the mass here is undecided")
        plan, reach, (factor, H, R) = _planned(force, u0, brake, w)
        if plan.denominator:
            # Rational exponents: one variable w^step; else monomials in w^2 and the w^alpha_i.
            step, grid, count = _line(force, plan)
            exponents = [arb(k * step.numerator) / step.denominator for k in range(count)]
            keys: tuple[Key, ...] = ()
        else:
            grid, keys, step = Simplex(plan.weights, plan.top), keys_of(plan.weights, plan.top), Fraction(0)
            exponents = [sum((n * f.exponent for n, f in zip(k[1:], force.losses)), arb(2 * k[0])) for k in keys]
        u, slowness = _coefficients(force, u0, brake, grid, exponents)
        # The tails of eta and of 1/P without its constant term, at the stretched speed, times the factor 2^-G by which
        # all that is left out shrinks; tau_(e+1) = Q_e/(e+1) is no larger than Q_e.
        small, slow = upper(factor * H), upper(factor * R / (1 - R) / abs(brake))
        return cls(force, u0, brake, reach, step, keys, arb_poly(u), arb_poly(slowness), small, slow)

    @property
    def rate(self) -> arb:
        """A bound of |w'| within the reach, on both sides of the turning point.

        Where r < 1, |P| <= 2 |P_0|, and neither what grips nor what drags exceeds its value at u_0 by more than |P_0|;
        on the other side of the turning point they count twice against P.
        """
        return upper(6 * abs(self.brake) + 2 * self.force.dry_friction(self.u0))

    def speed(self, unit: arb) -> arb:
        """A bound of |(unit u', w')| within the reach, on both sides of the turning point."""
        return upper(self.rate + unit * self.reach)

    def acceleration(self, u: arb, w: arb) -> arb:
        """The acceleration dw/dt = G(u, w)."""
        return self.force.acceleration(u, w)

    def moved(self, wait: arb) -> tuple[arb, arb]:
        """How far u and w move at most in the time |wait|."""
        time = upper(wait)
        return upper(time * self.reach), upper(time * self.rate)

    @property
    def gathered(self) -> "WellExpansion":
        """Itself: it is on one line."""
        return self

    def state(self, w: arb) -> tuple[arb, arb]:
        """(u, tau) at the speed 0 <= w <= ``reach``; tau since (or, if negative, until) the turning point."""
        if w == 0:
            return self.u0, arb(0)
        if not w <= self.reach:
            raise ValueError("the speed is beyond the reach of the expansion")
        if self.keys:
            powers = _monomials(self.force, self.keys, w)
            u, slowness = (sum(map(mul, c.coeffs(), powers), arb(0)) for c in (self.u, self.slowness))
        else:
            s = w**self.step.numerator
            s = s if self.step.denominator == 1 else (s.log() / self.step.denominator).exp()
            u, slowness = self.u(s), self.slowness(s)
        return u + arb(0, self.tail), w * (slowness + arb(0, self.time_tail))


def reach_at(force: WellForce, u0: arb) -> arb | None:
    """The cheapest hand-over speed at a turning point, a choice; None where there can be none."""
    with ctx.workprec(_LOW):
        brake = force.restoring(u0.mid()).mid()
        if not (brake > 0 or brake < 0):
            return None
        plan, scale = _plan(force, u0.mid(), brake, None, 1.0)
        return dyadic(plan.omega + scale)


def _planned(force: WellForce, u0: arb, brake: arb, w: arb | None) -> tuple[KeptTerms, arb, tuple[arb, arb, arb]]:
    """A plan whose majorant provably converges: its reach, and 2^-G, H*, R*."""
    for shrink in _SHRINKING:
        plan, scale = _plan(force, u0, brake, w, shrink)
        reach = dyadic(plan.omega + scale) if w is None else w
        with ctx.workprec(max(ctx.prec, 64)):
            found = _majorant(force, u0, abs(brake), reach, plan)
        if found is not None:
            return plan, reach, found
    raise UndecidedError("the majorant of the expansion at a turning point does not provably converge")


def _plan(force: WellForce, u0: arb, brake: arb, w: arb | None, shrink: float) -> tuple[KeptTerms, float]:
    """A plan as beside a linear spring of the stiffness met within some distance; log2 of the unit of speed."""
    bits = ctx.prec
    with ctx.workprec(_LOW):
        size = abs(brake).mid()
        # Within this distance the spring changes by _SHARE P_0, as a linear one of the stiffness K = _SHARE
        # P_0/distance does; its unit of speed is P_0/K^(1/2).
        distance = (_distance(force, u0.mid(), size) * shrink).mid()
        scale = size_of((size * distance / _SHARE).sqrt())
        wide, unit = abs(u0).mid() + distance, dyadic(scale)
        # delta_i of the linear plan: the loss at the unit speed and at the farthest place, over P_0.
        powers = (loss.strength * wide**loss.place * (loss.exponent * unit.log()).exp() for loss in force.losses)
        deltas = tuple(ceil(size_of(power / size) * _STEPS) / _STEPS for power in powers)
        rational = tuple(a.rational if a.is_rational else None for a in force.alphas)
        alphas = in_doubles(loss.exponent for loss in force.losses)
        omega = None if w is None else ceil((size_of(w) - scale) * _STEPS) / _STEPS
        return plan_for(deltas, rational, alphas, bits, omega, shared=False), scale


def _distance(force: WellForce, u0: arb, size: arb) -> arb:
    """Where the spring has changed by a share of P_0; on one side of a kink."""
    high = size
    # From the distance at which a spring of stiffness 1 would have changed by all of P_0; doubled and then bisected
    # twelve times, three digits of a choice.
    while force.largest_change(u0, high) < _SHARE * size:
        high = 2 * high
    low = arb(0)
    for _ in range(12):
        middle = ((low + high) / 2).mid()
        low, high = (middle, high) if force.largest_change(u0, middle) < _SHARE * size else (low, middle)
    found = high
    # Beyond u = 0 the power series is not that of the force; the pieces check it, here the reach is kept off.
    return min(found, 0.9 * abs(u0)) if force.kinked else found


def _line(force: WellForce, plan: KeptTerms) -> tuple[Fraction, ExponentGrid, int]:
    """The variable w^step, the places of z_0 and z_i, and how many terms."""
    q = plan.denominator
    places = [2 * q, *(int(a.rational * q) for a in force.alphas)]
    common = gcd(*places)
    # The exponents are sums of 2q and the alpha_i q, so all are multiples of their common divisor; the count is rounded
    # up.
    return Fraction(common, q), ExponentLine(tuple(p // common for p in places)), -(-plan.count // common)


def _majorant(force: WellForce, u0: arb, size: arb, w: arb, plan: KeptTerms) -> tuple[arb, arb, arb] | None:
    """(2^-G, H*, R*): the factor of the first term left out, and the majorants at the stretched speed, in balls."""
    two, ln_w = arb(2), w.log()
    if plan.denominator:
        stretch = arb(plan.stretch[0])
        step, _, count = _line(force, plan)
        factor = two ** (-stretch * count * step.numerator / step.denominator)
        wider = [2 * stretch, *(f.exponent * stretch for f in force.losses)]
    else:
        # Integer weights in units of 2^-16 (``kept_terms``): left out is sum n_i weights_i >= top.
        factor, wider = two ** (-arb(plan.top) / (1 << 16)), [arb(g) for g in plan.stretch]
    a = w**2 * two ** wider[0] / (2 * size)
    z = [f.strength * (f.exponent * ln_w).exp() * two**g for f, g in zip(force.losses, wider[1:])]

    # All absolute Taylor coefficients of G about u_0, at the distance H and the stretched speed: spring by
    # ``largest_change``, losses with |u_0| + H.
    def R(H: arb) -> arb:
        drag = sum((c * (abs(u0) + H) ** f.place for c, f in zip(z, force.losses)), arb(0))
        return upper((force.largest_change(u0, H) + drag) / size)

    H = upper(a)
    # H_(j+1) = a/(1 - R(H_j)) increases to the least fixed point; a per cent from it the number H is made five per cent
    # larger, so that the inequality a/(1 - R(H)) <= H can hold with its rounding.  That last line is the hypothesis of
    # the derivation ``wells-majorant``.
    for _ in range(40):
        moved = R(H)
        if not moved < 1:
            return None
        following = upper(a / (1 - moved))
        if following <= H * arb(1.01):
            break
        H = following
    H = upper(H * arb(1.05))
    bound = R(H)
    return (factor, H, bound) if bound < 1 and a / (1 - bound) <= H else None


def _coefficients(
    force: WellForce, u0: arb, brake: arb, grid: ExponentGrid, exponents: list[arb]
) -> tuple[list[arb], list[arb]]:
    """Coefficients of u and tau/w."""
    side = 1 if u0 > 0 or not u0 < 0 else -1
    powers, losses = force.restoring_powers(side), force.loss_powers(side)
    curve = ComposedSeries(grid, force.rate, {n for _, n in powers} | {m for _, m, _ in losses}, u0)
    P, Q, scale, none = [brake], [1 / brake], -1 / brake, arb(0)
    for k in range(1, len(exponents)):
        # u_e = -Q_(e-2)/e: a factor z_0 = w^2 less; without one the coefficient is 0.
        before = grid.back(k, 0)
        curve.append(none if before is None else -Q[before] / exponents[k])
        total = curve.restoring(powers)
        for i, (c, m, _) in enumerate(losses, start=1):
            at = grid.back(k, i)
            if at is not None:
                # A loss c u^m z_i adds the coefficient of u^m that has one z_i less.
                total += c * curve.power[m][at]
        P.append(total)
        Q.append(scale * grid.product_from_1(P, Q))
    return curve.u, [c / (e + 1) for c, e in zip(Q, exponents)]


def _monomials(force: WellForce, keys: tuple[Key, ...], w: arb) -> list[arb]:
    ln_w = w.log()
    logs = [2 * ln_w, *(f.exponent * ln_w for f in force.losses)]
    return [sum((n * ln for n, ln in zip(key, logs)), arb(0)).exp() for key in keys]
