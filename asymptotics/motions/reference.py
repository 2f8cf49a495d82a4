"""Reference motion: any alpha >= 0, any sum of laws, any start, to any number of digits, with a tested error.

* One law with alpha = 0, 1, or 2 (from rest), and no damping at all, have exact routes: certified.
* Every other law is integrated half-swing by half-swing with the sign of v fixed inside (``turning.swing``), at
  two working precisions; step sizes and the lengths of all series differ between them.  ``error`` is ten times the
  difference of the two, and half a unit of the last digit.  Strong evidence, not a proof: ``certified`` is False.

Against a naive |v|, measured: heyoka without an event is wrong in the third digit, mpmath.odefun in the fourth.

>>> from asymptotics.law import Law
>>> drag = Oscillator(Law({"3/2": "1/10"}), mass="3/2", stiffness="30", x0="1/5")
>>> point = reference_motion(drag, "7", 25)
>>> point.x, point.v, point.certified
('0.1638530834465485203993630', '0.08231344544936238811035480', False)
"""

from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass

from flint import arb, ctx

from asymptotics.errors import InputError, LimitError, UndecidedError
from asymptotics.law import Oscillator, PhysicalLaw
from asymptotics.motions.certify import half_unit, time_of
from asymptotics.motions.coulomb import coulomb_motion
from asymptotics.motions.linear import linear_motion
from asymptotics.motions.quadratic import quadratic_is_feasible, quadratic_motion
from asymptotics.motions.result import MotionPoint
from asymptotics.numbers.decimals import bits_for, decimal_of_ball
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.policy import Number
from asymptotics.turning.local_expansion import Damping
from asymptotics.turning.swing import orbit

METHOD = "reference: half-swing by half-swing, two precisions compared"
MAX_DIGITS = 1000
MAX_SECONDS = 600
_TRIES = 4

State = tuple[arb, arb]


@dataclass(frozen=True)
class States:
    """(x, v) in SI units at several times, and the largest difference of x between the two precisions."""

    x: tuple[arb, ...]
    v: tuple[arb, ...]
    difference: arb
    bits: int


def reference_motion(
    oscillator: Oscillator, t: Number, digits: int = 30, *, static: Number | None = None
) -> MotionPoint:
    """x and v at the time t >= 0 to ``digits`` significant digits; ``static``: a static friction force (alpha = 0).

    InputError for t < 0 or anti-damping, LimitError for too much work, UndecidedError if the precisions disagree.
    """
    moment = time_of(t)
    oscillator.law.require_pure("the reference motion")
    oscillator.law.require_dissipative("reference motion to rest")
    exact = _exact(oscillator, moment, digits, static)
    if exact is not None:
        return exact
    if static is not None:
        raise InputError("static", "it belongs to dry friction alone", "the law alpha = 0")
    _require_size(oscillator, moment, digits)
    states = reference_states(oscillator, (moment,), digits)
    with ctx.workprec(states.bits):
        x, v = (decimal_of_ball(value, digits) or "0" for value in (states.x[0], states.v[0]))
        error = 10 * states.difference + arb(half_unit(x, digits))
        text = decimal_of_ball(error.mid(), 2) or "0"
    return MotionPoint(x, v, None, None, None, None, METHOD, text, False, oscillator.law.notes)


def reference_states(oscillator: Oscillator, times: Sequence[ExactReal], digits: int) -> States:
    """(x, v) at several times, agreeing at two precisions to ``digits`` digits (x absolutely where it is small)."""
    bits, step = bits_for(digits, 48), bits_for(digits // 4, 40)
    coarse = _states(oscillator, times, bits)
    for _ in range(_TRIES):
        bits += step
        fine = _states(oscillator, times, bits)
        with ctx.workprec(bits):
            gaps = [abs(a[0] - b[0]).mid() for a, b in zip(coarse, fine)]
            close = arb(10) ** -(digits + 2)
            scales = (oscillator.length(), oscillator.length() * oscillator.omega_0())
            if all(_near(a, b, close, scales) for a, b in zip(coarse, fine)):
                x, v = zip(*fine)
                return States(x, v, _largest(gaps), bits)
        coarse = fine
    raise UndecidedError(f"{bits - step} and {bits} bits do not agree in {digits} digits")


def _near(a: State, b: State, close: arb, scales: State) -> bool:
    """Relative agreement, down to 10^-20 of the motion's own scale: below that the mass is at rest, up to rounding."""
    floor = arb(10) ** -20
    return all(bool(abs(p - q) <= close * (abs(q) + floor * s)) for p, q, s in zip(a, b, scales))


def _largest(values: list[arb]) -> arb:
    best = arb(0)
    for value in values:
        best = value if value > best else best
    return best


def _states(oscillator: Oscillator, times: Sequence[ExactReal], bits: int) -> list[State]:
    """(x, v) at the times, integrated at one precision."""
    with ctx.workprec(bits):
        omega, length = oscillator.omega_0(), oscillator.length()
        damping = Damping.of(list(zip(oscillator.epsilons(), oscillator.law.alphas)))
        taus = sorted((t.ball() * omega).mid() for t in times)
        X, V = (oscillator.x0.ball() / length).mid(), (oscillator.v0.ball() / (omega * length)).mid()
        found: list[State] = []
        for piece in orbit(damping, X, V):
            while len(found) < len(taus) and (piece.end is None or taus[len(found)] <= piece.end):
                x, v = piece.at(taus[len(found)])
                found.append(((x * length).mid(), (v * length * omega).mid()))
            if len(found) == len(taus):
                break
        order = [bisect_right(taus, (t.ball() * omega).mid()) - 1 for t in times]
        return [found[i] for i in order]


def _exact(oscillator: Oscillator, t: ExactReal, digits: int, static: Number | None) -> MotionPoint | None:
    acting = tuple(term for term in oscillator.law.terms if term.strength.sign > 0)
    if len(acting) > 1 or (acting and not acting[0].velocity.is_rational):
        return None
    law = PhysicalLaw.from_terms(acting or oscillator.law.terms[:1], oscillator.law.notes)
    alone = oscillator.with_law(law)
    alpha = acting[0].velocity.rational if acting else 1
    if alpha == 0:
        return coulomb_motion(alone, t, digits, static=static)
    if alpha == 1:
        return linear_motion(alone, t, digits)
    if alpha == 2 and not (oscillator.v0 < 0 or oscillator.v0 > 0) and quadratic_is_feasible(alone, digits):
        return quadratic_motion(alone, t, digits)
    return None


def estimated_seconds(oscillator: Oscillator, t: ExactReal, digits: int) -> float:
    """The expected time, good to a factor of about three for weak damping; stiff motions have their own limit."""
    with ctx.workprec(64):
        swings = float((t.ball() * oscillator.omega_0() / arb.pi()).mid()) + 1
    dense = 1 + 5 * sum(not (a.is_rational and a.rational.denominator <= 20) for a in oscillator.law.alphas)
    seconds: float = 2.5 * swings * 0.04 * (bits_for(digits, 48) / 150) ** 2.5 * dense * len(oscillator.law.terms)
    return seconds


def _require_size(oscillator: Oscillator, t: ExactReal, digits: int) -> None:
    if not 1 <= digits <= MAX_DIGITS:
        raise InputError("digits", f"{digits} is out of range", f"an integer from 1 to {MAX_DIGITS}")
    seconds = estimated_seconds(oscillator, t, digits)
    if seconds > MAX_SECONDS:
        reason = f"{t} s with {digits} digits would take about {seconds:.0f} s"
        raise LimitError("time", reason, f"work of at most {MAX_SECONDS} s: a shorter time or fewer digits")
