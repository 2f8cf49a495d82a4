"""Where dry friction ends the motion, as the expansion sees it.

With a term of exponent 0 the mass sticks at the first turning point whose amplitude is at most eps_0, the reach of the
friction in units of length: every other loss vanishes at rest, and the spring cannot overcome it.  The expansion in
the turning-point gauge gives the amplitudes A_n at psi = n pi, so that the stop is part of it: n is the first with
A_n <= eps_0, and from then on X = (-1)^n A_n.

The truncated amplitude may vanish before that turning point (it does whenever A_(n-1) < 2 eps_0, about every second
time: the motion then ends on the side it came from).  No expansion in delta_0 = eps_0/A reaches such a half-swing; but
there friction is the largest loss, and with friction alone it is an arc about the centre s eps_0,

    s X = eps_0 + R cos(tau - tau_b + beta),      held from tau - tau_b + beta = pi on at s X = eps_0 - R,

which starts at the last turning point (or at t = 0).  The other losses, of size sum_i eps_i R^alpha_i, are neglected
there and enter the error estimate.  For dry friction alone all of this is exact from order 2 on.

>>> from math import cos
>>> arc = LastSwing.of(0.0, (0.46, 0.0), 0.3)                  # 0.46 -> 0.3 - 0.16 = 0.14, on the same side
>>> round(arc.hold, 12), round(arc.end, 6), round(float(arc.at(np.array([1.0]))[0][0]) - 0.3 - 0.16 * cos(1), 12)
(0.14, 3.141593, 0.0)
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import atan2, ceil, hypot, pi
from typing import Any, Protocol

import numpy as np
from flint import acb, arb

from asymptotics.envelopes.slow_flow import SlowTable

Array = Any
# Three half-swings more of the table for each try: the stop may lie beyond the time asked for, and must be known to
# tell an arc from a swing.
_STEP, _TRIES = 10.0, 60
_CLOSE = 1e-7
"""The amplitudes of the tables are good to a few 1e-9; what is nearer than this to a tie is decided in balls."""


class FlowInDoubles(Protocol):
    """What is asked of the expansion in doubles (``motions.doubles``)."""

    @property
    def frame(self) -> Any:
        """Strengths, grading and start (``motions.truncation``)."""

    def slow(self, tau_max: float) -> SlowTable:
        """The table of the slow flow."""

    def turning_point(self, table: SlowTable, tau: Array) -> tuple[Array, Array]:
        """(s, psi) in the turning-point gauge."""


@dataclass(frozen=True)
class LastSwing:
    """The end of the motion: from ``begin`` an arc of friction alone, from ``end`` on rest at ``hold``.

    ``radius`` is that of the arc, and 0 when the expansion itself reaches the last turning point (begin = end).
    ``turn`` is the number of the turning point at ``begin``, None at the start of the motion.  ``doubt`` is how far the
    expansion and the arc differ in ``hold`` where delta_0 is large there, or where a loss with 0 < alpha < 1 brings
    negative powers of the amplitude.
    """

    begin: float
    end: float
    side: float
    centre: float
    radius: float
    beta: float
    hold: float
    turn: int | None
    doubt: float = 0.0

    @classmethod
    def of(cls, begin: float, state: tuple[float, float], centre: float, turn: int | None = None) -> "LastSwing":
        """The arc from (X, X') at the time ``begin``."""
        side, radius, beta = arc(*state, centre)
        # At rest within the reach of friction: the mass stays.
        if radius <= 0 or (not state[1] and abs(state[0]) <= centre):
            return cls(begin, begin, side, centre, 0.0, 0.0, state[0], turn)
        return cls(begin, begin + pi - beta, side, centre, radius, beta, side * (centre - radius), turn)

    def is_close(self, reach: float) -> bool:
        """Whether the turning point at ``begin`` is as far out as friction holds, as far as the tables in doubles know.

        >>> LastSwing(9.4, 12.6, -1.0, 0.2, 4e-10, 0.0, -0.2, 3).is_close(0.2)
        True
        """
        size = self.centre + self.radius if self.radius else abs(self.hold)
        return abs(size - reach) < _CLOSE

    def decided(self, begin: float, place: float, beyond: float) -> "LastSwing":
        """The same where |x| is ``beyond`` what friction holds at the turning point at ``begin``.

        >>> LastSwing(9.4, 12.6, -1.0, 0.2, 4e-10, 0.0, -0.2, 3).decided(9.42, -0.2, 0.0).end
        9.42
        """
        if beyond <= 0:
            return LastSwing(begin, begin, 1.0, 0.0, 0.0, 0.0, place, self.turn, self.doubt)
        side, centre = (1.0 if place > 0 else -1.0), abs(place) - beyond
        return LastSwing(begin, begin + pi, side, centre, beyond, 0.0, side * (centre - beyond), self.turn, self.doubt)

    def at(self, tau: Array) -> tuple[Array, Array]:
        """(X, X') from ``begin`` on."""
        angle = np.minimum(tau - self.begin + self.beta, pi)
        moving = tau < self.end
        X = np.where(moving, self.side * (self.centre + self.radius * np.cos(angle)), self.hold)
        return X, np.where(moving, -self.side * self.radius * np.sin(angle), 0.0)


def arc(X: float, V: float, centre: float) -> tuple[float, float, float]:
    """(s, R, beta) of the arc s X = centre + R cos(tau + beta), s X' = -R sin(tau + beta), through (X, V)."""
    side = (1.0 if V < 0 else -1.0) if V else (1.0 if X >= 0 else -1.0)
    return side, hypot(side * X - centre, V), atan2(-side * V, side * X - centre)


def friction_arc(z: acb, centre: arb, elapsed: arb) -> tuple[arb, arb, bool]:
    """(X, X', whether it has come to rest) on the arc that starts from X - i X' = z, in balls (midpoints)."""
    X, V = z.real, -z.imag
    side = (1 if V < 0 else -1) if V != 0 else (1 if X > 0 else -1)
    y = side * X - centre
    radius, beta = (y * y + V * V).sqrt(), arb.atan2(-side * V, y)
    angle = (elapsed + beta).mid()
    if not angle < arb.pi():
        return (side * (centre - radius)).mid(), arb(0), True
    return (side * (centre + radius * angle.cos())).mid(), (-side * radius * angle.sin()).mid(), False


def last_swing(flow: FlowInDoubles, tau_max: float) -> LastSwing | None:
    """How the motion ends if it ends before ``tau_max``; None without dry friction, or when it lasts longer."""
    reach = friction(flow.frame)
    if not reach:
        return None
    for extra in range(_TRIES):
        path = _Path(flow, flow.slow(tau_max + extra * _STEP))
        begin, extinct = path.first(lambda s, _: reach - np.exp(-s)), bool(np.isfinite(path.table.extinction))
        # A > eps_0 all the way: the spring still wins everywhere up to tau_max.
        if begin is None and not extinct:
            return None
        psi = path.at(path.table.tau[-1] if begin is None else begin)[1]
        # The first turning point at or after the place where A = eps_0; 1e-9 is for the rounding of psi in the tables.
        turn = ceil(psi / pi - 1e-9)
        end = path.turn(turn)
        if end is not None:
            hold = path.hold(turn, end)
            doubt = abs(hold - _arc_from(path, turn - 1, reach).hold) if _is_doubtful(flow.frame, hold, reach) else 0.0
            return LastSwing(end, end, 1.0, 0.0, 0.0, 0.0, hold, turn, doubt)
        if extinct:
            return _arc_from(path, turn - 1, reach)
    return None


def _is_doubtful(frame: Any, hold: float, reach: float) -> bool:
    between = any(-1 < float(w) < 0 and e != 0 for e, w in zip(frame.epsilons, frame.flow.grading.weights))
    # delta_0 = eps_0/A > 4 at the stop, or powers of A below 0: there expansion and arc are compared.
    return between or abs(hold) < reach / 4


def friction(frame: Any) -> float:
    """How far friction holds the mass, in units of length: A + sum_j eps_j A^(p_j) = eps_0 (springs j); 0 without."""
    grading = frame.flow.grading
    terms = [(float(e), float(w), sign) for e, w, sign in zip(frame.epsilons, grading.weights, grading.signs)]
    eps_0 = sum((e for e, w, sign in terms if w == -1.0 and sign < 0), 0.0)
    springs = [(e, w + 1) for e, w, sign in terms if sign > 0 and e]
    if not springs or not eps_0:
        return eps_0
    balance = np.linspace(0.0, 1.0, 4097)
    # By 4096 places: an estimate of where the mass stops, three digits of it.
    held = balance + sum(e * balance**p for e, p in springs) <= eps_0
    return float(balance[int(np.argmin(held))]) if not held.all() else 1.0


@dataclass(frozen=True)
class _Path:
    """s and psi of the turning-point gauge along one table."""

    flow: FlowInDoubles
    table: SlowTable

    def at(self, tau: float) -> tuple[float, float]:
        """(s, psi) at one time."""
        one = np.array([tau])
        s, psi = self.flow.turning_point(self.table, one)
        return float(s[0]), float(psi[0])

    def first(self, rises: Callable[[Array, Array], Array]) -> float | None:
        """The first time at which ``rises(s, psi)`` is no longer negative, or None."""
        from scipy.optimize import brentq  # noqa: PLC0415 (slow to load; most motions never stop)

        tau = self.table.tau
        over = rises(*self.flow.turning_point(self.table, tau)) >= 0
        if not over.any():
            return None
        i = int(np.argmax(over))
        low, high = (float(tau[max(i - 1, 0)]), float(tau[i]))
        if i == 0 or not rises(*self.at(low)) < 0 <= rises(*self.at(high)):
            return high
        return float(brentq(lambda t: rises(*self.at(t)), low, high, xtol=1e-13 * (1 + high)))

    def turn(self, number: int) -> float | None:
        """The time of a turning point, or None when the amplitude vanishes before it (or it lies before the start)."""
        if number * pi < self.at(0.0)[1] - 1e-9:
            return None
        return self.first(lambda _, psi: psi - (number * pi - 1e-12 * (1 + abs(number))))

    def hold(self, number: int, tau: float) -> float:
        """X at a turning point."""
        return float(np.exp(-self.at(tau)[0])) * (1 if number % 2 == 0 else -1)


def _arc_from(path: _Path, turn: int, reach: float) -> LastSwing:
    """The arc of friction alone from the turning point number ``turn``, or from the start if there was none."""
    begin = path.turn(turn)
    if begin is None:
        target = path.flow.frame.target
        return LastSwing.of(0.0, (float(target.real), -float(target.imag)), reach)
    return LastSwing.of(begin, (path.hold(turn, begin), 0.0), reach, turn)
