"""ln r and the time at an angle theta of the quarter swing, order by order in the local strengths, with proved balls.

The quarter swing of ``certified_orders`` stopped at 0 < theta <= pi/2, X = r cos theta, X' = -r sin theta: with
t = (2 theta/pi)^2 in the place of 1,

    R_n = -theta^(n.v) sum_j [g y_n]_j t^j/(n.v + 2j),      tau_n = theta^(n.v+1) sum_j [c y_n]_j t^j/(n.v + 1 + 2j),

and the tails of ``certified`` hold as they stand: t <= 1.

>>> R, tau = arc(Forces.losses((2,)), 2, arb.pi() / 2)
>>> R[1].overlaps(-arb(2) / 3), tau[1].overlaps(arb(1) / 3)          # -(pi/2) M_3, 1/(alpha+1)
(True, True)
"""

from flint import arb

from asymptotics.expansions.half_swings.certified import BOUND_BITS, RADIUS, enclose, tail_constants, terms_needed
from asymptotics.expansions.half_swings.certified_moments import Orders, duration_orders
from asymptotics.expansions.half_swings.certified_orders import dot, indices, order_series, power_series_ring
from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.numbers.context import ctx
from asymptotics.series import Series


def arc(forces: Forces, order: int, theta: arb) -> tuple[Series, Series]:
    """(R, tau) at theta through ``order`` at the current precision; R(0) = 0, tau = theta + ...."""
    with ctx.workprec(BOUND_BITS):
        bounds = tail_constants(forces, order, RADIUS, moments=False)
    kept = terms_needed(bounds, RADIUS, ctx.prec)
    ring = power_series_ring(forces, kept)
    y = order_series(ring, indices(forces.variables, order))
    t = (2 * theta / arb.pi()) ** 2
    R: Orders = {}
    T: Orders = {(0,) * forces.variables: theta}
    for n, tau in duration_orders(ring, y).items():
        e = dot(n, ring.velocities)
        R[n] = -ring.integrate(ring.cut(ring.turn * y[n]), e)(t) * theta**e
        T[n] = tau(t) * theta ** (e + 1)
    # t <= 1 and theta <= pi/2: the tails at the passage, powers of pi/2 in front, are larger than those here.
    found = (enclose(s, b, RADIUS, kept) for s, b in zip((R, T), bounds))
    log_radius, time = (Series(c, forces.variables, order) for c in found)
    return log_radius, time
