"""|x - x_N| at a given time as a proved number: x is enclosed, x_N is the decimal that is printed.

What an expansion of order N, in whatever gauge, prints for x(t) is one decimal number; the motion itself is enclosed by
half-swings of which every error only adds (``flow``), or at late times, if all exponents are at least 1, by one jump
to a turning point before it (``late``): no iteration.  The distance of the decimal from the far end of the enclosure is
the bound, rounded up: it is hardly more than the error itself.

A time that no route reaches within the seconds that are allowed (a creep for alpha < 1, or a linear term too strong for
the jump) still has an answer: |x| is bounded by the energy of the latest state that is reached.

>>> from asymptotics.motions.asymptotic import AsymptoticMotion
>>> drag = Oscillator({"3/2": "1/10"}, mass="3/2", stiffness="30", x0="1/5")
>>> [proved_bound(drag, AsymptoticMotion.of(drag, order).at("7", 20).x, "7") for order in (1, 2, 3)]
['0.00013', '2.1e-8', '3.2e-9']
"""

from contextlib import suppress
from dataclasses import replace

from flint import arb

from asymptotics.bounds.late import late_state
from asymptotics.errors import LimitError
from asymptotics.flow.damping import Damping
from asymptotics.flow.linear_spring.linear_spring import LinearSpring
from asymptotics.flow.sequence import first_from
from asymptotics.flow.turning import TurningState, at_rest
from asymptotics.law import Oscillator
from asymptotics.motions.certify import time_of
from asymptotics.motions.reference import reference_states
from asymptotics.numbers.context import ctx
from asymptotics.numbers.decimals import bits_for, directed_decimal
from asymptotics.numbers.exact import ExactReal, parse_printed
from asymptotics.numbers.policy import Number
from asymptotics.numbers.rationals import bounds
from asymptotics.return_map.panels import panels_of
from asymptotics.running.budget import DEFAULT_SECONDS, budget

# Up to there half-swings are followed, some tens of microseconds each by interpolation; the jump costs the coefficients
# of its order once.
LATE = 20_000
"""Half-swings beyond which the motion is reached by a jump, where every exponent is at least 1."""
_DIGITS = 15


def proved_bound(oscillator: Oscillator, x: str, t: Number, *, max_seconds: float = DEFAULT_SECONDS) -> str:
    """A number >= |x(t) - ``x``| in m, two digits, rounded up, for any decimal ``x`` that an expansion gave.

    UndecidedError where balls cannot tell how the motion goes on; LimitError beside a spring, or with losses that
    depend on the place, where an enclosure of x(t) would take longer than ``max_seconds``.

    Digits are doubled here, and the precision in ``enclosure``, by the one loop: any enclosure gives a bound, and where
    the printed decimal is so near that more digits would only show its own rounding, the last one is taken.
    """
    moment, printed, digits = time_of(t), parse_printed(x, "x"), _DIGITS
    while True:
        low, high = bounds(enclosure(oscillator, moment, digits, max_seconds=max_seconds))
        farthest = max(abs(low - printed), abs(high - printed))
        # The width of the enclosure is in the bound: below a hundredth it does not change two digits.
        if 100 * (high - low) <= farthest or digits > len(x) + 5:
            return directed_decimal(farthest, 2, 1)
        digits *= 2


def enclosure(oscillator: Oscillator, t: ExactReal, digits: int, *, max_seconds: float = DEFAULT_SECONDS) -> arb:
    """x(t) in m as a ball whose radius is about 10^-``digits`` of the amplitude at that time, where that can be had.

    Where no route reaches t in ``max_seconds``, the energy of the latest state that is reached in half of them bounds
    x: it never grows.
    """
    with ctx.workprec(64):
        late = bool(t.ball() * oscillator.omega_0() > LATE * arb.pi())
    acting = [term for term in oscillator.law.terms if term.strength.sign > 0]
    try:
        if late and acting and oscillator.law.is_pure and all(term.velocity >= 1 for term in acting):
            with budget(max_seconds):
                return _jumped(oscillator, t, digits)
    except LimitError:  # out of the range of the theorem: there are other ways
        pass
    try:
        return reference_states(oscillator, (t,), digits, max_seconds=max_seconds).x[0]
    except LimitError:
        if not oscillator.law.is_pure:
            raise
        return _by_energy(oscillator, t, max_seconds / 2)


def _jumped(oscillator: Oscillator, t: ExactReal, digits: int) -> arb:
    """By ``late``, after twenty half-swings for each digit."""
    # 1/delta grows by a constant in each half-swing: after 20 digits of them delta is some 1/(20 digits), and the
    # truncated equations of ``late`` lack its ninth power, or its fifth.
    law, lead = oscillator.dimensionless, 20 * digits
    with ctx.workprec(64):
        # log2 of the time: the whole turns that the phase takes off its digits.
        turns = int(float((t.ball() * oscillator.omega_0()).log()) / 0.69) + 1
    bits = bits_for(digits, 40)
    with ctx.workprec(bits + 2 * turns):
        tau, damping = t.ball() * oscillator.omega_0(), Damping.of_law(law)
    with ctx.workprec(bits):
        omega, length = oscillator.omega_0(), oscillator.length()
        first: TurningState | str = at_rest(arb(1))
        if oscillator.x0 < 0:
            first = replace(at_rest(arb(1)), side=-1)
        if not oscillator.v0.is_zero:
            first = first_from(
                LinearSpring(damping), oscillator.x0.ball() / length, oscillator.v0.ball() / (omega * length)
            )
        if isinstance(first, str):
            raise LimitError("time", f"the motion {first}", "a motion that turns")
        return late_state(damping, first, tau, lead, panels_of(law, bits)) * length


def _by_energy(oscillator: Oscillator, t: ExactReal, max_seconds: float) -> arb:
    """0 +- sqrt(x^2 + v^2/omega_0^2) at the latest of the times ... t/16, t/4 that is reached."""
    with ctx.workprec(64):
        omega, speed = oscillator.omega_0(), oscillator.v0.ball()
        energy = oscillator.x0.ball() ** 2 + (speed / omega) ** 2
        latest, _ = bounds(t.ball())  # no double: 1e400 is a time too
        # ln 4 = 1.39: how many factors of 4 lead back to the start.
        steps = int(float((t.ball() * omega + 1).log()) / 1.39)
    with suppress(LimitError), budget(max_seconds):
        # From the earliest time on, each kept: the last one that is reached within the seconds bounds all later
        # displacements, since friction only takes energy.
        for k in range(steps, 0, -1):
            found = reference_states(oscillator, (ExactReal(latest / 4**k),), _DIGITS, max_seconds=max_seconds)
            energy = found.x[0] ** 2 + (found.v[0] / omega) ** 2
    return arb(0, arb(energy.upper()).sqrt().upper())
