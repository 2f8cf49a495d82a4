"""Exact motion with dry friction (alpha = 0): harmonic about a shifted centre on each half-swing, until it sticks.

At x' = 0 the force is any value in [-b, b]: a differential inclusion with a monotone right-hand side, whose solution is
unique (Filippov, Differential Equations with Discontinuous Righthand Sides, 1988).

m x'' + k x + b sign(x') = 0.  With c = b/k the half-swing towards smaller s x (s = +-1) is

    s x = c + R cos(omega_0 (t - t_n)),      from s x = r_n, R = r_n - c,  to  -s x = r_(n+1) = r_n - 2 c.

The mass sticks at the first turning point with r_n <= h = max(c, h_s), where h_s = F_s/k is the reach of a static
friction force F_s (Lelas 2024, section 2, has F_s = b): r_n may be negative, on the side it came from, and is off
centre in general.  A start with v0 != 0 joins its half-swing in the middle, R^2 = (s x0 - c)^2 + (v0/omega_0)^2.

Certified: balls, and the number of half-swings until rest is decided exactly when r_0, c and h are rational.

>>> from asymptotics.law import Law
>>> mass = Oscillator(Law({"0": "3"}), mass=1, stiffness=10, x0=1)               # c = 3/10
>>> [(m.x, m.v) for m in (coulomb_motion(mass, t, 10) for t in ("1", "5"))]
[('-0.3999786073', '0.006540706969'), ('-0.2000000000', '0')]
>>> stop = coulomb_stop(mass, 10)
>>> stop.x, stop.t, stop.half_swings
('-0.2000000000', '1.986917653', 2)
>>> coulomb_stop(mass, 10, static="5").x                       # h_s = 1/2: it sticks at the first turning point
'-0.4000000000'
"""

from collections.abc import Callable
from dataclasses import dataclass

from flint import arb

from asymptotics.errors import InputError, UndecidedError
from asymptotics.law import Oscillator
from asymptotics.motions.certify import Pair, certified_point, certified_values, time_of
from asymptotics.motions.point import MotionPoint
from asymptotics.motions.state_route import StateRoute, alone, require_alone
from asymptotics.numbers.context import ctx
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.policy import Number, exact_number
from asymptotics.turning.dry_friction import amplitude_in_motion, half_swings_until

METHOD = "exact: dry friction, certified balls"


@dataclass(frozen=True)
class Stop:
    """Where and when the mass comes to rest for good (SI units), after how many half-swings."""

    x: str
    t: str
    half_swings: int

    def to_dict(self) -> dict[str, object]:
        """The stop as a JSON-ready mapping: decimals are strings."""
        return {"x": self.x, "t": self.t, "half_swings": self.half_swings}


@dataclass(frozen=True)
class _DryMotion:
    """The motion as balls: sign s, R and start t_0 of the first half-swing, their number, the last r_n if exact."""

    sign: int
    centre: arb
    amplitude: arb
    begin: arb
    omega: arb
    half_swings: int
    rest: ExactReal | None

    def place(self, t: arb) -> tuple[arb, arb]:
        """(x, v) at a time before the stop."""
        # A ball about a turning point holds two whole numbers; more bits tell them apart, unless the time is one
        # exactly.
        turns = ((t - self.begin) * self.omega / arb.pi()).floor().unique_fmpz()
        if turns is None:
            raise UndecidedError("the half-swing of this time is undecided")
        n = int(turns)
        R = self.amplitude - 2 * n * self.centre
        angle = (t - self.begin) * self.omega - n * arb.pi()
        side = self.sign * (-1) ** n
        return side * (self.centre + R * angle.cos()), -side * R * self.omega * angle.sin()

    def stop(self) -> tuple[arb | ExactReal, arb]:
        """(x, t) of the stop; an exact x as such: it may be 0, or a tie between two decimals."""
        n, side = self.half_swings, self.sign * (-1) ** self.half_swings
        t = self.begin + n * arb.pi() / self.omega
        if self.rest is not None:
            return side * self.rest, t
        return side * (self.amplitude + self.centre * (1 - 2 * n)), t


def coulomb_motion(oscillator: Oscillator, t: Number, digits: int = 30, *, static: Number | None = None) -> MotionPoint:
    """x and v at the time t >= 0, all digits correctly rounded; ``static``: the static friction force (N), >= b.

    InputError for another law, b < 0, a static force below b, or t < 0.
    """
    moment = time_of(t)
    oscillator = require_alone(oscillator, 0, "dry friction")
    hold = _hold(oscillator, static)

    def evaluate() -> Pair:
        motion = _dry_motion(oscillator, hold)
        if motion is None:
            return oscillator.x0, arb(0)
        x, end = motion.stop()
        now = moment.ball()
        if now >= end:
            return x, arb(0)
        if not now < end:
            raise UndecidedError("whether the mass has come to rest is undecided")
        return motion.place(now)

    # t = 0 is the start itself, exactly.
    if not moment > 0:
        return certified_point(lambda: (oscillator.x0, oscillator.v0), digits, METHOD)
    return certified_point(evaluate, digits, METHOD)


def coulomb_stop(oscillator: Oscillator, digits: int = 30, *, static: Number | None = None) -> Stop:
    """Where and when the mass sticks for good, all digits correctly rounded; InputError as in `coulomb_motion`."""
    oscillator = require_alone(oscillator, 0, "dry friction")
    hold = _hold(oscillator, static)
    found: list[int] = []

    def evaluate() -> Pair:
        motion = _dry_motion(oscillator, hold)
        if motion is None:
            found[:] = [0]
            return oscillator.x0, arb(0)
        found[:] = [motion.half_swings]
        return motion.stop()

    x, t = certified_values(evaluate, digits)
    return Stop(x, t, found[0])


def _hold(oscillator: Oscillator, static: Number | None) -> ExactReal:
    b = oscillator.law.terms[0].b
    force = b if static is None else exact_number(static, "static")
    if force < b:
        raise InputError("static", f"{force} is below the kinetic friction {b}", "a force >= b, in N")
    return force


def _dry_motion(oscillator: Oscillator, hold: ExactReal) -> _DryMotion | None:
    """The motion at the current precision, or None if the mass never starts."""
    b, k = oscillator.law.terms[0].b, oscillator.stiffness
    x0, v0, omega, c = oscillator.x0.ball(), oscillator.v0.ball(), oscillator.omega_0(), b.ball() / k.ball()
    h = hold.ball() / k.ball()
    if not (oscillator.v0 < 0 or oscillator.v0 > 0):
        sign = -1 if oscillator.x0 < 0 else 1
        # Ties (r_n = h) are met by ordinary input such as x0 = 1, c = 1/5: exact numbers decide wherever they can.
        exact = _exact_count(oscillator, hold, abs(oscillator.x0))
        n, rest = (_count(abs(x0), c, h), None) if exact is None else exact
        # n = 0: friction holds the mass where it is.
        return None if n == 0 else _DryMotion(sign, c, abs(x0) - c, arb(0), omega, n, rest)
    sign = -1 if oscillator.v0 > 0 else 1
    y, w = sign * x0 - c, abs(v0) / omega
    R = (y * y + w * w).sqrt()
    exact = _exact_count(oscillator, hold, _first_amplitude(oscillator, sign))
    n, rest = (_count(R - c, c, h), None) if exact is None else exact
    # The arc began before t = 0, at theta = 0; the first turning point ends the half-swing that was joined in the
    # middle.
    return _DryMotion(sign, c, R, -arb.atan2(w, y) / omega, omega, 1 + n, rest)


def exact_turning_points(oscillator: Oscillator) -> Callable[[int], ExactReal] | None:
    """n -> x_n in m, exactly, or None where the first amplitude is irrational and no multiple of the reach c.

    >>> from asymptotics.law import Law
    >>> place = exact_turning_points(Oscillator(Law({"0": "1/4"}), x0="1"))
    >>> [str(place(n)) for n in range(3)]
    ['1', '-1/2', '0']
    """
    c = oscillator.law.terms[0].b / oscillator.stiffness
    if oscillator.v0.is_zero:
        side, first = oscillator.x0.sign, abs(oscillator.x0)
    else:
        side, amplitude = oscillator.v0.sign, _first_amplitude(oscillator, -oscillator.v0.sign)
        if amplitude is None:
            return None
        first = amplitude
    try:
        first - c
    except InputError:  # two roots: their difference is no tie
        return None
    return lambda n: side * (-1) ** n * (first - 2 * n * c)


def _first_amplitude(oscillator: Oscillator, sign: int) -> ExactReal | None:
    """R - c, the first turning point of a start with v0 != 0, where it is rational, as m, k, b and x0 are."""
    b, k, m = oscillator.law.terms[0].b, oscillator.stiffness, oscillator.mass
    if not all(q.is_rational for q in (oscillator.x0, b, k, m)):
        return None
    return amplitude_in_motion(sign * oscillator.x0, b / k, oscillator.v0 * oscillator.v0 * (m / k))


def _exact_count(oscillator: Oscillator, hold: ExactReal, first: ExactReal | None) -> tuple[int, ExactReal] | None:
    """The smallest n with r = first - 2 n c <= h, and that r, exactly; None where a number is irrational."""
    b, k = oscillator.law.terms[0].b, oscillator.stiffness
    if first is None or not all(q.is_rational for q in (first, b, k, hold)):
        return None
    n = half_swings_until(first, b / k, hold / k)
    return n, first - 2 * n * (b / k)


def _count(r: arb, c: arb, h: arb) -> int:
    """The smallest n >= 0 with r - 2 n c <= h, from balls."""
    if r <= h:
        return 0
    n = ((r - h) / (2 * c)).ceil().unique_fmpz()
    if n is None:
        raise UndecidedError(f"whether the mass sticks is undecided at {ctx.prec} bits: it may be a tie")
    return max(0, int(n))


def _state(oscillator: Oscillator, t: ExactReal, digits: int, static: Number | None) -> MotionPoint | None:
    bare = alone(oscillator, 0)
    return None if bare is None else coulomb_motion(bare, t, digits, static=static)


ROUTE = StateRoute(("dry",), _state)
