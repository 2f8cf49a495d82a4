"""Any spring with quadratic drag and dry friction: turning points from one closed primitive of the energy equation.

The return map is given implicitly and grows with the amplitude, so a change of sign encloses the next turning point
(intermediate value theorem), and the hull of two images holds the image of a ball.

    x'' + V'(x) + eps_0 sgn x' + eps_2 x'|x'| = 0,    V'(x) = x + sum_j c_j x|x|^(p_j-1), or with sin x in place of x.

On a swing to the left v < 0, and u = v^2/2 obeys the *linear* equation du/dx = -V'(x) + eps_0 + 2 eps_2 u, so that
from rest at x = a > 0

    u(x) e^(-2 eps_2 x) = int_x^a (V'(y) - eps_0) e^(-2 eps_2 y) dy,

and the next turning point -q is the next zero of the right side, an elementary function.  For the pendulum in air
(cos x + 2 eps_2 sin x) e^(-2 eps_2 x) has equal values at x = a and x = -q: with x in place of sin x and 1 in place of
cos x this is the equation of the linear spring, which the Lambert W function solves (``quadratic_map``).

*In balls.*  V' is convex or concave with V'(0) = 0, so V' > eps_0 holds from one place x* on: the integral grows from a
down to x*, falls from there on (on both sides of the centre), and has one zero.  A guess q is enclosed by its signs at
q - eta and q + eta.  q(a) grows with a, since dq/da = (V'(a) - eps_0) e^(-2 eps_2 a)/((V'(q) + eps_0) e^(2 eps_2 q)),
so the image of a ball is the hull of the images of its ends.  V(q) <= V(a): the orbit stays in its well.

>>> from itertools import islice
>>> with ctx.workprec(120):
...     pendulum = PrimitiveWell.of(Law({2: "1/5"}, spring="pendulum"))
...     found = [x.str(10) for x, _ in islice(swings(pendulum, arb(2), 60), 3)]
>>> found
['2.000000000', '[-1.203804096 +/- ...]', '[0.8918968686 +/- ...]']
"""

from collections.abc import Iterator
from dataclasses import dataclass

from flint import arb

from asymptotics.errors import InputError
from asymptotics.flow.wells.force import WellForce
from asymptotics.law import Law
from asymptotics.numbers.context import ctx
from asymptotics.running.budget import tick
from asymptotics.terms import Term


@dataclass(frozen=True)
class PrimitiveWell:
    """The force in balls, and the strengths eps_0 (dry friction) and eps_2 (drag) of its losses: it has no others."""

    force: WellForce
    dry: arb
    drag: arb

    @classmethod
    def of(cls, law: Law) -> "PrimitiveWell":
        """At the current precision; InputError by name for a force that this method cannot take."""
        for t in _without_primitive(law):
            known = "alpha = 0 and 2 with springs c x|x|^(P-1) or a pendulum; expand takes every force"
            raise InputError("law", f"{t.shape()}: with a nonlinear spring there is no exact swing", known)
        _require_one_branch(law)
        force = WellForce.of(law.terms)
        return cls(force, force.dry_friction(arb(0)), sum((loss.strength for loss in force.losses), arb(0)))

    def work(self, low: arb, high: arb) -> arb:
        """int_low^high (V'(y) - eps_0) e^(-2 eps_2 y) dy; ``low`` may be negative, ``high`` >= 0."""
        if low >= 0:
            return self._primitive(high, 1) - self._primitive(low, 1)
        # V' is odd, given by powers of |x|: the primitive is taken on either side of the centre by itself.
        return self._primitive(high, 1) - self._primitive(arb(0), 1) + self._other_side(-low)

    def _other_side(self, q: arb) -> arb:
        """int_-q^0: with y = -z, int_0^q (-V'(z) - eps_0) e^(2 eps_2 z) dz."""
        return self._primitive(q, -1) - self._primitive(arb(0), -1)

    def _primitive(self, x: arb, side: int) -> arb:
        """A primitive of (side V'(x) - eps_0) e^(-2 side eps_2 x), x >= 0."""
        # Beyond the centre y = -z: V' and the exponent change their signs, eps_0 does not.
        k = 2 * side * self.drag
        r = self.force.rate
        powers = [(side * c, p) for c, p in self.force.springs] + [(-self.dry, 0)]
        if r is None:
            powers.append((arb(side), 1))
        total = sum((c * _power_primitive(x, p, k) for c, p in powers), start=arb(0))
        if r is not None:
            sine, cosine = (r * x).sin_cos()
            total -= side * (-(k * x)).exp() * (r * cosine + k * sine) / (r * (r * r + k * k))
        return total


def primitive_serves(law: Law) -> bool:
    """Whether these forces have their closed primitive, on one branch; the linear spring alone is one of them."""
    return not _without_primitive(law) and not _has_two_branches(law)


def _without_primitive(law: Law) -> list[Term]:
    """The terms that are no spring of the place (the linear one is not among them), quadratic drag or dry friction."""
    springs = [t for t in law.springs if not (t.family or t.velocity.is_zero)]
    losses = [t for t in law.losses if not (t.is_power_of_velocity and (t.velocity == 2 or t.velocity.is_zero))]
    return springs + losses


def _has_two_branches(law: Law) -> bool:
    pendulum = any(t.family for t in law.springs)
    signs = {t.strength.sign for t in law.springs if not t.family} | ({-1} if pendulum else set())
    dry = any(t.velocity.is_zero and t.strength.sign > 0 for t in law.losses)
    return dry and {-1, 1} <= signs


def _require_one_branch(law: Law) -> None:
    """InputError for dry friction in a well whose force may cross eps_0 more than once on the way to the centre.

    V' with V'(0) = 0 is convex if all c >= 0 without a pendulum, and concave (up to x = pi) if all c <= 0: V' > eps_0
    then holds exactly from one place on.
    """
    if _has_two_branches(law):
        raise InputError("spring", "dry friction with springs of both signs is undecided", "springs of one sign")


def _power_primitive(x: arb, p: int, k: arb) -> arb:
    """A primitive of x^p e^(-k x): -e^(-k x) sum_j p!/(p-j)! x^(p-j)/k^(j+1), or x^(p+1)/(p+1) at k = 0."""
    # No drag, exactly; for a small one the division by k^(p+1) cancels, and the caller works with twice the bits.
    if k == 0:
        return x ** (p + 1) / (p + 1)
    total, factor = arb(0), 1 / k
    for j in range(p + 1):
        total += factor * x ** (p - j)
        factor = factor * (p - j) / k
    return -(-(k * x)).exp() * total


def swings(well: PrimitiveWell, x: arb, bits: int) -> Iterator[tuple[arb, bool | None]]:
    """(x_n, whether the mass sticks there, None if undecided) for n = 0, 1, ...; ends where balls cannot go on."""
    side = 1 if x > 0 else -1
    a = side * x
    while True:
        tick()
        # At a < 0 the mass has stopped before the centre, on the side it came from; only its distance counts for what
        # holds it.
        pull = abs(well.force.spring_force(a))
        stays = True if pull <= well.dry else False if pull > well.dry and a > 0 else None
        yield side * a, stays
        if stays is not False:
            return
        # q(a) grows: the hull of the images of both ends holds the image of the ball.
        low, high = (_next(well, end, bits) for end in (a.lower(), a.upper()))
        if low is None or high is None:
            return
        a, side = low.union(high), -side


def _next(well: PrimitiveWell, a: arb, bits: int) -> arb | None:
    """The next turning distance q from a dyadic a with V'(a) > eps_0; negative q if it stops before the centre."""
    q = _guess(well, a)
    if q is None:
        return None
    # 24 bits less than the target leaves the signs clear of rounding, as the work is computed with twice the bits; too
    # small an eta leaves them undecided, too large a one costs digits.
    eta = abs(q) * arb(2) ** (24 - bits)
    inner, outer = well.work(-(q - eta), a), well.work(-(q + eta), a)
    # The work falls through 0 once from x* on: a change of sign encloses the only zero.
    return arb(q, eta.upper()) if inner > 0 and outer < 0 else None


def _guess(well: PrimitiveWell, a: arb) -> arb | None:
    """Bisection in doubles' width, then Newton's method on midpoints: a choice, not a claim."""
    low, high = _falling_from(well, a), a
    # Forty halvings are right to 12 digits, and twelve steps of Newton's method lead from there to 10^4.
    for _ in range(40):
        middle = ((low + high) / 2).mid()
        low, high = (middle, high) if well.work(-middle, a).mid() > 0 else (low, middle)
    q = low
    for _ in range(12):
        slope = (well.force.spring_force(q) + well.dry) * (2 * well.drag * q).exp()
        if not abs(slope.mid()) > 0:
            return None
        step = (well.work(-q, a) / slope).mid()
        q = (q + step).mid()
        if abs(step) < abs(q) * arb(2) ** (8 - ctx.prec):
            break
    return q if q.is_finite() and q <= a else None


def _falling_from(well: PrimitiveWell, a: arb) -> arb:
    """-x at the place x > 0 where V' = eps_0: from there on the integral falls; 0 without dry friction."""
    if well.dry == 0:
        return arb(0)
    low, high = arb(0), a
    for _ in range(60):
        middle = ((low + high) / 2).mid()
        low, high = (low, middle) if well.force.spring_force(middle) > well.dry else (middle, high)
    return -high
