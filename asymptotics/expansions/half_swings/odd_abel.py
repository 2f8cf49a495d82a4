"""The odd Laurent series whose increment under the half-swing is given: c_0/delta + c_1 delta + c_2 delta^3 + ….

F is reversible, F(-F(delta)) = -delta: f(F) - f = 1 and f(F) - f = T have one odd solution each, found power by power
(delta^(2k-1) grows by (2k-1) F_2 delta^(2k) + …), and the odd powers of the increment cancel by themselves.  The
complete series diverge; cut off after c_(K-1) each leaves a defect O(delta^(2K)) that is analytic near 0.

>>> F = [arb(0), arb(1), arb(-1), arb(1), arb(-1), arb(1)]             # delta/(1 + delta): 1/delta grows by 1
>>> [[str(c) for c in part] for part in odd_solution(F, [arb(1)], 2)]
[['1.00000000000000', '0'], []]
"""

from collections.abc import Sequence

from flint import arb, arb_series

from asymptotics.numbers.context import ctx
from asymptotics.running.budget import tick


def odd_solution(F: Sequence[arb], rise: Sequence[arb], terms: int) -> tuple[list[arb], list[arb]]:
    """(c_0, …, c_(terms-1); the coefficients of f(F) - f - ``rise`` from delta^(2 ``terms``) on, as far as F is known).

    ``F`` from delta^0 on.  ArithmeticError if an odd power is left: the map is not reversible.
    """
    length = len(F) - 1
    with ctx.workcap(length):
        ratio = arb_series(list(F[1:]), length)
        power, square = ratio.inv(), ratio * ratio
        rest = arb_series([-x for x in rise[:length]], length)
        found: list[arb] = []
        for k in range(terms):
            tick(f"order {k} of {terms} of the Abel function")
            # f = delta^(2k-1) grows by delta^(2k-1) ((F/delta)^(2k-1) - 1), beginning with (F/delta)^(-1).
            grown = [power[i] - (i == 0) for i in range(length)]
            shifted = grown[1:] if k == 0 else [arb(0)] * (2 * k - 1) + grown
            # The lowest even power that is left is cancelled by the next odd power of delta: its growth begins there.
            found.append(-rest[2 * k] / shifted[2 * k])
            rest = rest + arb_series(shifted[:length], length) * found[-1]
            # By reversibility the odd power has gone with it; a ball off zero means that F is not what it should be.
            if k and not rest[2 * k - 1].contains(0):
                raise ArithmeticError("the increments leave an odd power: the map is not reversible")
            power = power * square
        return found, [rest[m] for m in range(2 * terms, length - 1)]
