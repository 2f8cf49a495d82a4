"""Exact motion with linear damping (alpha = 1): under-, critically and over-damped by one formula.

m x'' + b x' + k x = 0 with gamma = b/(2m) and D = k/m - gamma^2:

    x = e^(-gamma t) [x0 C + (v0 + gamma x0) t S],   v = e^(-gamma t) [v0 C - (gamma v0 + (k/m) x0) t S],
    C = cos sqrt(D t^2),   S = sinc sqrt(D t^2):

entire functions of D t^2, so D > 0, = 0, < 0 need no distinction (cosh and sinh come by themselves).  Certified balls.

>>> from asymptotics.law import Law
>>> critical = Oscillator(Law({"1": "2"}))                                    # x = (1 + t) e^-t
>>> found = linear_motion(critical, "1", 12)
>>> found.x, found.notes
('0.735758882343', ('critically damped',))
"""

from flint import acb, arb

from asymptotics.errors import InputError, LimitError
from asymptotics.law import Oscillator
from asymptotics.motions.certify import Pair, certified_point, time_of
from asymptotics.motions.point import MotionPoint
from asymptotics.motions.state_route import StateRoute, alone
from asymptotics.numbers.context import ctx
from asymptotics.numbers.decimals import MAX_EXPONENT
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.policy import Number

METHOD = "exact: linear damping, certified balls"


def linear_motion(oscillator: Oscillator, t: Number, digits: int = 30) -> MotionPoint:
    """x and v at the time t >= 0, all digits correctly rounded; a note says how it is damped, if b > 0.

    InputError for another law, or t < 0.

    A value that is exactly 0 at an irrational moment cannot be rounded: UndecidedError.
    """
    moment = time_of(t)
    _require_linear(oscillator)
    _require_printable(oscillator, moment)

    def evaluate() -> Pair:
        if not moment > 0:
            return oscillator.x0, oscillator.v0
        now, x0, v0 = moment.ball(), oscillator.x0.ball(), oscillator.v0.ball()
        gamma = oscillator.law.terms[0].b.ball() / (2 * oscillator.mass.ball())
        stiffness = oscillator.stiffness.ball() / oscillator.mass.ball()
        # cos and sinc of a root are entire in its square: either branch will do, also for a ball about 0.
        root = acb((stiffness - gamma**2) * now**2).sqrt()
        C, S, decay = root.cos().real, now * root.sinc().real, (-gamma * now).exp()
        x = decay * (x0 * C + (v0 + gamma * x0) * S)
        return x, decay * (v0 * C - (gamma * v0 + stiffness * x0) * S)

    found = certified_point(evaluate, digits, METHOD)
    return found.with_notes((regime(oscillator),)) if oscillator.law.terms[0].b > 0 else found


def _require_printable(oscillator: Oscillator, t: ExactReal) -> None:
    """LimitError where the displacement is certainly too small to be written down."""
    # So that a critical damping is told from its neighbours in most of what may be typed.
    with ctx.workprec(4096):
        gamma = oscillator.law.terms[0].b.ball() / (2 * oscillator.mass.ball())
        stiffness = oscillator.stiffness.ball() / oscillator.mass.ball()
        over = (gamma**2 - stiffness).nonnegative_part()
        # The smaller rate gamma - (gamma^2 - k/m)^(1/2) of overdamping, without cancellation.
        slowest = stiffness / (gamma + over.sqrt()) if over > 0 else gamma
        halvings = slowest * t.ball() / arb.const_log2()
        if halvings > MAX_EXPONENT:
            reason = f"the displacement has halved {halvings.str(3, radius=False)} times"
            raise LimitError("time", reason, f"at most {MAX_EXPONENT} times: a shorter time")


def regime(oscillator: Oscillator) -> str:
    """ "underdamped", "critically damped" or "overdamped", decided exactly for rational b, m, k; else by balls."""
    _require_linear(oscillator)
    b, m, k = oscillator.law.terms[0].b, oscillator.mass, oscillator.stiffness
    if b.is_rational and m.is_rational and k.is_rational:
        excess = b.rational**2 - 4 * m.rational * k.rational
        return "critically damped" if excess == 0 else "overdamped" if excess > 0 else "underdamped"
    with ctx.workprec(1000):
        ball = b.ball() ** 2 - 4 * m.ball() * k.ball()
    return "overdamped" if ball > 0 else "underdamped" if ball < 0 else "critically damped to 300 digits"


def _require_linear(oscillator: Oscillator) -> None:
    oscillator.law.require_pure("the exact solution")
    terms = oscillator.law.terms
    moving = [t for t in terms if t.b > 0 or t.b < 0]
    if any(not t.velocity.is_rational or t.velocity.rational != 1 for t in moving):
        raise InputError("law", f"{oscillator.law} is not linear damping alone", "alpha = 1")
    if moving and moving[0] is not terms[0]:
        raise InputError("law", "the linear term stands after a term of strength 0", "the linear term alone")


def _state(oscillator: Oscillator, t: ExactReal, digits: int, static: Number | None) -> MotionPoint | None:
    bare = alone(oscillator, 1)
    return None if bare is None or static is not None else linear_motion(bare, t, digits)


ROUTE = StateRoute(("linear",), _state)
