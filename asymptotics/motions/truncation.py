"""The expansion of one oscillator at one order in one gauge, in midpoints of balls: start, state and waveform.

    x - i v/omega_0 = A e^(i psi) (1 + sum_(1<=n<N) delta^n Z_n(psi)),    s = -ln A,    lengths in units of the start.

The slow equations are those of the gauge (``envelopes.slow_flow``); the waveform is that of the turning-point gauge
(``waveform``), reached through c(delta).  The start (s, psi) solves the equation above at t = 0.  Heuristic
arithmetic: only midpoints are kept, at the precision of the context.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

from flint import acb, arb

from asymptotics.envelopes.slow_flow import ExponentialSum, SlowLaw
from asymptotics.errors import UndecidedError
from asymptotics.expansions.half_swings.certified import quarter_swing
from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.expansions.half_swings.grading import LOSS
from asymptotics.expansions.normal_form.expansion import Expansion, expansion_of
from asymptotics.expansions.normal_form.flow import Flow
from asymptotics.gauges import TURNING_POINT
from asymptotics.law import Oscillator
from asymptotics.motions.waveform import waveform_at
from asymptotics.numbers.context import ctx
from asymptotics.series import Key


class Guess(NamedTuple):
    """(s, psi) of the turning-point gauge at t = 0 in doubles, and the derivatives of ln(A e^(i psi) Z) there."""

    begin: tuple[float, float]
    jacobian: tuple[tuple[float, float], tuple[float, float]]


@dataclass(frozen=True)
class State:
    """s = -ln A and psi in the gauge of the frame."""

    s: arb
    psi: arb

    def turning_point(self, frame: "Truncation") -> tuple[arb, arb]:
        """(s, psi) in the turning-point gauge."""
        return self.s - frame.back_modulus(self.s), self.psi + frame.back_argument(self.s)

    def point(self, frame: "Truncation") -> acb:
        """The state as one number X - i X', of modulus e^(-s) |Z|."""
        s, psi = self.turning_point(frame)
        Z = sum(frame.terms(self).values(), acb(1))
        return (-s).exp() * (acb(0, 1) * psi).exp() * Z


@dataclass(frozen=True)
class Truncation:
    """Everything that order and gauge fix at the current precision, in units of length and tau."""

    order: int
    target: acb
    epsilons: tuple[arb, ...]
    flow: Flow
    forces: Forces
    law: SlowLaw
    modulus: ExponentialSum
    argument: ExponentialSum
    back_modulus: ExponentialSum
    back_argument: ExponentialSum

    @classmethod
    def of(cls, oscillator: Oscillator, order: int, gauge: str) -> "Truncation":
        """From the certified expansion through ``order``; only midpoints are used."""
        # Certified coefficients, of which the midpoints are kept: the truncation is the error that counts, and it is
        # estimated.
        expansion = _expansion(oscillator, order, gauge)
        epsilons = tuple(e.mid() for e in oscillator.epsilons())

        def sums(series: Any, top: int) -> ExponentialSum:
            return ExponentialSum.of(series, epsilons, expansion.flow.grading, top)

        law = SlowLaw(sums(expansion.p, order), sums(expansion.Omega, order))
        there, back = expansion.gauge_map, expansion.gauge_map.inverse()
        # To the degree of the waveform: c(delta) is multiplied with it.
        maps = [sums(f, order - 1) for m in (there, back) for f in (m.log_modulus, m.argument)]
        length, omega = oscillator.length(), oscillator.omega_0()
        target = acb(oscillator.x0.ball() / length, -oscillator.v0.ball() / (omega * length))
        flow = expansion.turning_point_flow() if gauge != TURNING_POINT else expansion.flow
        forces = Forces.of(oscillator.law.terms, order)
        return cls(order, acb(target.real.mid(), target.imag.mid()), epsilons, flow, forces, law, *maps)

    def terms(self, state: State) -> dict[Key, acb]:
        """delta^n Z_n(psi) for 1 <= |n| < order."""
        if self.order == 1:
            return {}
        s, psi = state.turning_point(self)
        found = {}
        for key, (p, q) in waveform_at(self.flow, self.forces, psi, self.order - 1).items():
            found[key] = acb(p, q) * self.monomial(key, s)
        return found

    def monomial(self, key: Key, s: arb) -> arb:
        """delta^key at A = e^-s."""
        value = arb(1)
        for n, e, weight in zip(key, self.epsilons, self.flow.grading.weights):
            if n:
                value = value * (e * (-weight * s).exp()) ** n
        return value

    def start(self, guess: Callable[[], Guess] | None, near: State | None = None) -> State:
        """(s, psi) at t = 0 in the gauge: A e^(i psi) Z = X_0 - i X'_0, by Newton's method from doubles."""
        # At rest psi is 0 or pi and A = 1 in the turning-point gauge, exactly.
        if self.target.imag == 0:
            s, psi = arb(0), (arb(0) if self.target.real > 0 else arb.pi().mid())
        elif guess is not None:
            s, psi = self._refined(guess())
        else:
            s, psi = self._iterated(near)
        return State((s - self.modulus(s)).mid(), (psi + self.argument(s)).mid())

    def _refined(self, guess: Guess) -> tuple[arb, arb]:
        """Newton's method with the Jacobian from doubles: seven digits or so at each step."""
        s, psi = (arb(x) for x in guess.begin)
        (a, b), (c, d) = guess.jacobian
        for i in range(ctx.prec // 16 + 8):
            # A step with a Jacobian of doubles gains about seven digits, 23 bits: what it cannot gain need not be
            # computed.
            with ctx.workprec(min(ctx.prec, 90 + 28 * i)):
                miss = self._miss(s, psi)
            determinant = a * d - b * c
            s = (s + (d * miss.real - b * miss.imag) / determinant).mid()
            psi = (psi + (a * miss.imag - c * miss.real) / determinant).mid()
            if abs(miss) < arb(2) ** (10 - ctx.prec):
                return s, psi
        raise UndecidedError("the start of the expansion was not found by Newton's method")

    def _iterated(self, near: State | None) -> tuple[arb, arb]:
        """Fixed-point steps from a start nearby, to the two digits of the change that an estimate needs."""
        s, psi = (near.s, near.psi) if near is not None else (arb(0), self.target.log().imag)
        first = None
        for _ in range(12):
            with ctx.workprec(64):
                miss = self._miss(s, psi)
            s, psi = (s - miss.real).mid(), (psi + miss.imag).mid()
            first = abs(miss) if first is None else first
            if abs(miss) <= first / 100:
                break
        return s, psi

    def _miss(self, s: arb, psi: arb) -> acb:
        """ln target - ln(A e^(i psi) Z) in the turning-point gauge."""
        none = ExponentialSum(())
        # In the turning-point gauge, where the waveform is known: without the maps between the gauges.
        free = replace(self, modulus=none, argument=none, back_modulus=none, back_argument=none)
        value = self.target / State(s, psi).point(free)
        return acb(value.log().real.mid(), value.log().imag.mid())

    def turning_point(self, turn: int, near: arb, start: State) -> tuple[arb, State | None]:
        """The time of the turning point psi = turn pi near ``near``, and the state there; X is stationary there.

        The state is None when the amplitude vanishes just there: x0 may be a multiple of 2 eps_0.
        """
        tau, last = near, None
        for _ in range(2 * ctx.prec.bit_length() + 4):
            state = self.state(tau, start)
            if state is None:
                return tau, None
            miss = state.turning_point(self)[1] - turn * arb.pi()
            # Newton's method first, then secants: the phase is nearly linear in the time.
            rate = 1 + self.law.Omega(state.s) if last is None else ((miss - last[1]) / (tau - last[0])).mid()
            last, tau = (tau, miss), (tau - miss / rate).mid()
            if abs(miss) < arb(2) ** (-ctx.prec // 2):
                return tau, state
        raise UndecidedError("the last turning point of the expansion was not found by Newton's method")

    @property
    def reach(self) -> arb:
        """eps_0: friction holds the mass within this distance, in units of length (springs aside)."""
        return sum((e for e, friction in zip(self.epsilons, self._frictions) if friction), arb(0))

    def neglected(self, radius: arb) -> arb:
        """The losses and springs beside dry friction, on an arc of this radius."""
        terms = zip(self.epsilons, self.flow.grading.weights, self._frictions)
        return sum((e * radius ** (weight + 1) for e, weight, f in terms if not f), arb(0))

    @property
    def _frictions(self) -> list[bool]:
        grading = self.flow.grading
        return [bool(w == -1) and sign == LOSS for w, sign in zip(grading.weights, grading.signs)]

    def state(self, tau: arb, start: State) -> State | None:
        """(s, psi) at the time tau, or None beyond the extinction."""
        found = self.law.solve(tau, start.s)
        return None if found is None else State(found[0], (start.psi + tau + found[1]).mid())


def _expansion(oscillator: Oscillator, order: int, gauge: str) -> Expansion:
    quarter = quarter_swing(oscillator.law.terms, order, moments=gauge != TURNING_POINT)
    return expansion_of(quarter, gauge, arithmetic="certified")
