"""x at a late time, any exponents >= 1, without passing the half-swings between: the theorem read the other way round.

The theorem is that of ``turning``: matching of a certified head of the orbit with its asymptotic tail.

What bounds the error of an expansion bounds the motion as well.  From a certified turning point M on, where the local
strengths are small, the truncated equations of order K lead to turning point n at once (``flow``); the theorem says how
far the motion may be from there (``turning``), and one or two half-swings in balls lead to the time itself.  With
delta_M = O(1/M) the error is O(delta_M^K): a few hundred half-swings, and K = 5, reach every later one.

>>> from asymptotics.numbers.exact import parse_real
>>> with ctx.workprec(100):
...     law = Damping.of([(arb(1) / 10, parse_real("2", "--alpha"))])
...     late_state(law, TurningState(0, 1, arb(1), arb(0), arb(0), arb(0)), arb(10) ** 9, 30).str(8)
'[2.0232092e-8 +/- 8.49e-17]'
"""

from collections.abc import Iterator

from flint import arb

from asymptotics.bounds.flow import TruncatedFlow
from asymptotics.bounds.local import BITS
from asymptotics.bounds.turning import turning_bounds
from asymptotics.errors import LimitError
from asymptotics.flow.balls import size_of, upper
from asymptotics.flow.damping import Damping
from asymptotics.flow.dense import states_from
from asymptotics.flow.linear_spring.linear_spring import LinearSpring
from asymptotics.flow.sequence import sequence
from asymptotics.flow.turning import TurningState
from asymptotics.numbers.context import ctx
from asymptotics.return_map.panels import Panels
from asymptotics.return_map.sequence import Interpolated
from asymptotics.running.budget import tick

# A higher order is better at small strengths and has more coefficients, which sums multiply.  At the time 10^6, from
# half-swing 40 on, two orders more of one law give 11 or 10 bits for no measurable time, one more of two laws 7 bits
# for a sixth (``benchmarks/constants.json``): a free choice, and the theorem bounds the error at any of them.
ORDERS = {1: 9, 2: 5}
"""The order K of the jump, by the number of laws; 3 for more than two."""


def late_state(damping: Damping, first: TurningState, tau: arb, lead: int, panels: Panels | None = None) -> arb:
    """X at the time ``tau``, far beyond ``lead`` half-swings from ``first``, a turning point of the motion.

    LimitError as ``late_turning``.
    """
    there = late_turning(damping, first, tau, lead, panels)
    with ctx.workprec(_as_long_as(tau)):
        return states_from(LinearSpring(damping), there, [tau])[0][0]


def late_turning(
    damping: Damping, first: TurningState, tau: arb, lead: int, panels: Panels | None = None
) -> TurningState:
    """One of the last turning points before ``tau``.

    LimitError where the motion ends before, or the local strengths there are still out of the range of the theorem.
    """
    led = LinearSpring(damping) if panels is None else Interpolated(damping, panels, first.n + lead)
    here = _led(sequence(led, first), first.n + lead)
    a, order = here.amplitude, ORDERS.get(len(damping.alphas), 3)
    with ctx.workprec(_as_long_as(tau)):
        # The units of the theorem: A = 1 at the turning point from which it is applied, whose own error is ``start``.
        epsilons = [e * a ** (alpha - 1) for e, alpha in zip(damping.strengths, damping.exponents, strict=True)]
        # Rounded up to whole blocks, so that neighbouring precisions share the coefficients.
        bits = max(BITS, -(-ctx.prec // BITS) * BITS)  # a phase as long as the time needs such coefficients
        bounds = turning_bounds(damping.alphas, order, epsilons, -(1 - here.amplitude_error / a).log(), bits)
        flow = TruncatedFlow.of(bounds.local, epsilons)
        # One half-swing less than the estimate: the turning point that is found must come before the time, and
        # ``states_from`` follows the rest.
        n = max(0, flow.half_swings(tau - here.time) - 1)
        s, time = flow.turning_point(n)
        amplitude = a * (arb(0, bounds.log_amplitude(n)) - s).exp()
        moment = here.time + time + arb(0, upper(here.time_error + bounds.time(n)))
    side = here.side * (-1) ** n
    return TurningState(here.n + n, side, amplitude.mid(), moment.mid(), upper(amplitude.rad()), upper(moment.rad()))


def _as_long_as(tau: arb) -> int:
    """The bits of a time, of which those after the point count."""
    return int(ctx.prec + max(0, int(size_of(tau))) + 1)


def _led(turnings: Iterator[TurningState], last: int) -> TurningState:
    for here in turnings:
        tick(f"turning point {here.n}")
        if here.n >= last:
            return here
        if here.ended is not None:
            break
    raise LimitError("time", "the motion does not turn so often", "a time before its last turning point")
