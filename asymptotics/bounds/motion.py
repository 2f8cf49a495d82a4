"""|x - x_N| at a given time as a proved number: x is enclosed, x_N is the decimal that is printed.

What an expansion of order N, in whatever gauge, prints for x(t) is one decimal number; the motion itself is enclosed by
half-swings of which every error only adds (``swing``, ``half_swings.finite``), or, for one law with alpha > 1 and a
late time, by one jump to the turning point before it (``turning.far``): no iteration.  The distance of the decimal from
the far end of the enclosure is the bound, rounded up: it is hardly more than the error itself.

>>> from asymptotics.motions.asymptotic import AsymptoticMotion
>>> drag = Oscillator({"3/2": "1/10"}, mass="3/2", stiffness="30", x0="1/5")
>>> [proved_bound(drag, AsymptoticMotion.of(drag, order).at("7", 20).x, "7") for order in (1, 2, 3)]
['0.00013', '2.1e-8', '3.2e-9']
"""

from collections.abc import Iterator

from flint import arb, ctx

from asymptotics.budget import DEFAULT_SECONDS, budget
from asymptotics.errors import UndecidedError
from asymptotics.law import Law, Oscillator
from asymptotics.motions.certify import time_of
from asymptotics.motions.reference import reference_states
from asymptotics.numbers.decimals import bits_for, directed_decimal
from asymptotics.numbers.exact import ExactReal, parse_rational
from asymptotics.numbers.policy import Number
from asymptotics.numbers.rationals import bounds
from asymptotics.swing.damping import Damping
from asymptotics.swing.dense import states_from
from asymptotics.swing.sequence import Turning
from asymptotics.turning.routes import FAR, Plan

_DIGITS = 15


def proved_bound(oscillator: Oscillator, x: str, t: Number, *, max_seconds: float = DEFAULT_SECONDS) -> str:
    """A number >= |x(t) - ``x``| in m, two digits, rounded up, for any decimal ``x`` that an expansion gave.

    LimitError where an enclosure of x(t) would take longer than ``max_seconds``; UndecidedError where balls cannot tell
    how the motion goes on.
    """
    moment, printed, digits = time_of(t), parse_rational(x, "x"), _DIGITS
    while True:
        low, high = bounds(enclosure(oscillator, moment, digits, max_seconds=max_seconds))
        farthest = max(abs(low - printed), abs(high - printed))
        if 100 * (high - low) <= farthest or digits > len(x) + 5:
            return directed_decimal(farthest, 2, 1)
        digits *= 2


def enclosure(oscillator: Oscillator, t: ExactReal, digits: int, *, max_seconds: float = DEFAULT_SECONDS) -> arb:
    """x(t) in m as a ball whose radius is about 10^-``digits`` of the amplitude at that time."""
    law = oscillator.dimensionless
    with ctx.workprec(64):
        swings = (t.ball() * oscillator.omega_0() / arb.pi()).mid()
    alone = len(law.terms) == 1 and law.terms[0].is_power_of_velocity and oscillator.v0.is_zero
    if not (alone and law.terms[0].velocity > 1 and law.terms[0].strength.sign > 0 and swings > FAR):
        return reference_states(oscillator, (t,), digits, max_seconds=max_seconds).x[0]
    with budget(max_seconds):
        turns = int(float(swings.log()) / 0.69) + 1
        with ctx.workprec(bits_for(digits, 40) + 2 * turns):
            tau = t.ball() * oscillator.omega_0()
            X, _ = states_from(Damping.of_law(law), _before(law, tau), [tau])[0]
            return X * oscillator.x0.ball()


def _before(law: Law, tau: arb) -> Turning:
    """The last turning point before ``tau``: its index is counted with the lag tau_n - n pi of a first guess."""
    n = _floor(tau / arb.pi())
    for _ in range(8):
        here, there = (next(_from(law, index)) for index in (n, n + 1))
        if here.tau <= tau and tau < there.tau:
            return here
        n = _floor((tau - (here.tau - here.n * arb.pi())) / arb.pi()) if not here.tau <= tau else n + 1
    raise UndecidedError("the time is too near a turning point")


def _from(law: Law, start: int) -> Iterator[Turning]:
    plan = Plan.of(law, start, 2, ctx.prec)
    return plan.turnings()


def _floor(x: arb) -> int:
    return int(x.floor().mid().str(60, radius=False).split(".")[0])
