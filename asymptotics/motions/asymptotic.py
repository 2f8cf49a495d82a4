"""x(t) and v(t) from the expansion: amplitude, phase and waveform at order N, any law and spring, any start.

Order N: dA/d tau and d psi/d tau with p_k and Omega_k for k <= N, and the waveform through delta^(N-1),

    x - i v/omega_0 = A e^(i psi) (1 + sum_(1<=n<N) delta^n Z_n(psi)),     psi = omega_0 t + phi.

Order 1 is Lancaster (13), x = x0 A(t) cos(omega_0 t).  The start is part of the expansion: A(0) and phi(0) solve this
equation at t = 0.  In another gauge than the turning-point gauge the slow equations are those of the gauge, and the
waveform is reached through c(delta) (theory page ``gauges``: at fixed psi nothing else may be expanded).

``error`` is an estimate, not a bound: twice what the orders N + 1 and N + 2 change in amplitude, phase and waveform.
It is at most what the energy allows, |x| + the unit of length, and exactly that for delta > 1 at the start, with a
note: the series says nothing there.  With springs the phase is shifted from the first order on; what is not served
beside them is in ``admission``.  With dry friction the motion ends where the expansion ends it (``stopping``).
Without it, if some alpha < 1, the averaged amplitude vanishes at a fictitious extinction time; from then on x = v = 0
is returned and said to be so.

>>> from asymptotics.law import Law
>>> drag = Oscillator(Law({"3/2": "1/10"}), mass="3/2", stiffness="30", x0="1/5")
>>> first = AsymptoticMotion.of(drag, order=1).at("7", 8)
>>> first.x, first.amplitude                         # Lancaster (13): 0.2 A cos(7 sqrt(20))
('0.16397652', '0.16499144')
>>> third = AsymptoticMotion.of(drag, order=3)
>>> third.at("7", 12).x, third.at("7", 12).error
('0.163853086570', '1.2e-8')
>>> [f"{x:.10f}" for x in third.sample([0, 7, float("nan")]).x]
['0.2000000000', '0.1638530866', 'nan']
>>> duffing = Oscillator({2: "1/10"}, spring={3: "1/2"})
>>> point = AsymptoticMotion.of(duffing, order=3).at("7", 12)
>>> point.x, point.error
('-0.0478528565936', '0.016')
"""

from dataclasses import dataclass
from math import log
from typing import Any

import numpy as np
from flint import acb, arb

from asymptotics.errors import InputError, LimitError
from asymptotics.frames import Frame, frame_of
from asymptotics.gauges import TURNING_POINT, require_gauge
from asymptotics.law import Oscillator
from asymptotics.motions.admission import local_strength, require_served
from asymptotics.motions.certify import half_unit
from asymptotics.motions.doubles import Doubles
from asymptotics.motions.point import MotionPoint
from asymptotics.motions.result import MotionSamples
from asymptotics.motions.stopping import LastSwing, friction, friction_arc, last_swing
from asymptotics.motions.truncation import State, Truncation
from asymptotics.numbers.context import cached_property, ctx
from asymptotics.numbers.decimals import bits_for, decimal_of_ball
from asymptotics.numbers.policy import Number, exact_integer, exact_number

MAX_ORDER, MAX_DIGITS = 12, 300
SMALL = 1
"""The sum of the |delta_i| at the start above which the series is not asked for an error."""
METHOD = "asymptotic expansion"
# Bits beyond the digits for what midpoints lose, which no ball records: 16 more for each order are added below.
_GUARD = 64
_TIE_BITS = 240
# Far beyond any unit, and well inside the doubles of the tables, their powers of the order included.
_LARGEST = arb(10) ** 100
# From there on neighbouring doubles are a radian or more apart.
_NO_PHASE = 2.0**53
# A limit of what is worth printing: amplitudes of 10^-86859 of the start.
_FAINTEST = 200_000
Array = Any


@dataclass(frozen=True, eq=False)
class AsymptoticMotion:
    """The motion of ``oscillator`` at ``order`` in ``gauge``; build it with ``of``."""

    oscillator: Oscillator
    order: int
    gauge: str
    frame: Frame

    @classmethod
    def of(
        cls, oscillator: Oscillator, order: int = 3, gauge: str = TURNING_POINT, frame: Frame | None = None
    ) -> "AsymptoticMotion":
        """Check the input; InputError for an unknown gauge, an order out of range, anti-damping.

        ``frame``: what times are told in, by default the units of the oscillator.
        """
        require_gauge(gauge)
        order = exact_integer(order, "order", 1, MAX_ORDER)
        oscillator.law.require_dissipative("amplitude that falls")
        _require_sizes(oscillator)
        require_served(oscillator, order)
        return cls(oscillator, order, gauge, frame_of(oscillator) if frame is None else frame)

    def at(self, t: Number, digits: int = 30) -> MotionPoint:
        """The motion at the time t >= 0 (exact number, s), each value to ``digits`` significant digits.

        InputError for t < 0, digits out of range, or a law whose truncated amplitude equation has lost its sign.
        """
        moment = exact_number(t, "time")
        _require_time(bool(moment < 0), str(moment))
        digits = exact_integer(digits, "digits", 1, MAX_DIGITS)
        with ctx.workprec(64):
            # The size decides the precision, so it is found first, in few bits.
            size = (moment.ball() * self.oscillator.omega_0()).mid()
        if size > _LARGEST:
            raise LimitError("time", f"{self.frame.time_text(moment)} is too many swings", "omega_0 t <= 1e100")
        swings = int(float((size + 1).log()) / log(2))  # bits that the whole turns of the phase take
        with ctx.workprec(bits_for(digits, _GUARD) + 16 * self.order + swings):
            return self._point((moment.ball() * self.oscillator.omega_0()).mid(), digits)

    def sample(self, t: Array) -> MotionSamples:
        """The motion at an array of times (s, doubles).  NaN stays in its place; a negative time is an InputError."""
        times, missing, flat = self._taus(t)
        omega, length = (float(x) for x in (self.oscillator.omega_0(), self.oscillator.length()))
        columns = self._doubles.evaluate(flat)
        latest = float(flat.max(initial=0.0))
        last, extinction = self._last(latest), self._doubles.slow(latest).extinction
        if last is not None:
            # Friction ends the motion, and not the averaged law: what comes after the last half-swing is no fictitious
            # time.
            extinction = np.inf
        gone = flat >= extinction
        columns *= np.array([length, length * omega, length, 1.0])[:, None]
        columns[:, missing.ravel()] = np.nan
        x, v, a, phi = columns.reshape((4, *times.shape))
        notes = (*self.oscillator.law.notes, *self._notes(int(missing.sum()), int(gone.sum()), extinction / omega))
        if last is not None and np.any(flat >= last.end):
            notes = (*notes, self._held_note(last))
        end = extinction / omega if np.isfinite(extinction) else None
        lost = int(missing.sum()), int(gone.sum())
        return MotionSamples(times, x, v, a, phi, self.order, self.gauge, *lost, end, notes, self.frame)

    def phases(self, t: Array) -> Array:
        """phi of the slow flow at an array of times t >= 0 in s, which knows no end by friction; doubles."""
        times, missing, flat = self._taus(t)
        return np.where(missing, np.nan, self._doubles.phases(flat).reshape(times.shape))

    def _taus(self, t: Array) -> tuple[Array, Array, Array]:
        """The times, which are NaN, and omega_0 t of each in one row; InputError where doubles have no phase."""
        times, missing = _times(t)
        omega, flat = float(self.oscillator.omega_0()), np.where(missing, 0.0, times).ravel()
        if flat.max(initial=0.0) > _NO_PHASE / omega:
            latest = self.frame.time_text(f"{flat.max():g}")
            raise InputError("time", f"{latest}: a double has no phase there", "omega_0 t < 2^53, or at(t)")
        return times, missing, flat * omega

    def double_errors(self, t: Array) -> dict[str, Array]:
        """How far the doubles of ``sample`` are from the expansion, by the names of its columns; estimates."""
        omega, length = (float(x) for x in (self.oscillator.omega_0(), self.oscillator.length()))
        rows = self._doubles.errors(np.ravel(t) * omega)
        return dict(
            zip(("x", "v", "amplitude", "phase"), rows * np.array([length, length * omega, length, 1.0])[:, None])
        )

    def _last(self, latest: float) -> LastSwing | None:
        """How the motion ends before ``latest``; where doubles do not tell whether friction just holds, by balls."""
        last = last_swing(self._doubles, latest)
        if last is None or last.turn is None or not last.is_close(friction(self._doubles.frame)):
            return last
        with ctx.workprec(_TIE_BITS):
            frame = Truncation.of(self.oscillator, self.order, self.gauge)
            begin, state = frame.turning_point(last.turn, arb(last.begin), frame.start(self._doubles.guess))
            if state is None:
                return last
            place = state.point(frame).real.mid()
            beyond = (abs(place) - frame.reach).mid()
            # Equal to half of the bits: a tie, of numbers that make one.
            beyond = arb(0) if abs(beyond) < arb(2) ** (-_TIE_BITS // 2) else beyond
        return last.decided(float(begin), float(place), float(beyond))

    def _held_note(self, last: LastSwing) -> str:
        end = self.frame.time_text(f"{last.end / float(self.oscillator.omega_0()):.6g}")
        return f"dry friction holds the mass from {end} on"

    def _notes(self, missing: int, extinct: int, end: float) -> tuple[str, ...]:
        notes = [f"NaN times: {missing}; NaN is kept in their places"] if missing else []
        if extinct:
            moment = self.frame.time_text(f"{end:.6g}")
            notes.append(
                f"times beyond the fictitious extinction time {moment} of the averaged law: {extinct}; x = v = 0 there,"
                " while the true motion sticks or creeps"
            )
        return tuple(notes)

    @cached_property
    def _doubles(self) -> Doubles:
        with ctx.workprec(120):
            return Doubles.of(Truncation.of(self.oscillator, self.order, self.gauge))

    def _point(self, tau: arb, digits: int) -> MotionPoint:
        frame = Truncation.of(self.oscillator, self.order, self.gauge)
        start = frame.start(self._doubles.guess)
        last = self._last(float(tau))
        if last is not None and float(tau) >= last.begin:
            return self._ended(tau, frame, start, last, digits)
        # None: the averaged amplitude of a law with alpha < 1 has vanished before.
        state = frame.state(tau, start)
        if state is None:
            with ctx.workprec(120):
                end = self._doubles.slow(float(tau)).extinction / float(self.oscillator.omega_0())
            return self._shown([arb(0)] * 3, None, arb(1), self._notes(0, 1, end), digits)
        if state.s > _FAINTEST:
            size = f"the amplitude is e^-{float(state.s):.3g} of its unit there"
            raise LimitError("time", size, f"amplitudes above e^-{_FAINTEST}")
        z = state.point(frame)
        values = [z.real, -z.imag, (-state.s).exp()]
        return self._shown(values, state.psi - tau, self._estimate(tau, frame, start, state), (), digits)

    def _ended(self, tau: arb, frame: Truncation, start: State, last: LastSwing, digits: int) -> MotionPoint:
        """The last half-swing, and rest: friction holds the mass (``stopping``)."""
        z, begin, error = frame.target, arb(0), arb(0)
        if last.turn is not None:
            begin, state = frame.turning_point(last.turn, arb(last.begin), start)
            # Twice, as in every estimate: how far expansion and arc differ, the error of the turning point, and the
            # losses that the arc neglects.
            error = 2 * arb(last.doubt)
            z = acb(0) if state is None else acb(state.point(frame).real.mid(), 0)
            if state is not None:
                error += 2 * self._estimate(begin, frame, start, state)
        X, V, held = friction_arc(z, frame.reach, tau - begin) if last.radius else (z.real, arb(0), True)
        if last.radius:
            error += 2 * frame.neglected(arb(last.radius))
        notes = (self._held_note(last),) if held else ()
        return self._shown([X, V, abs(X)], None, error, notes, digits)

    def _shown(
        self, values: list[arb], phase: arb | None, estimate: arb, notes: tuple[str, ...], digits: int
    ) -> MotionPoint:
        """X, X', A and phi in decimals and SI units; the estimate is clipped to what the energy allows."""
        oscillator = self.oscillator
        length, omega = oscillator.length(), oscillator.omega_0()
        delta = local_strength(oscillator)
        most = 1 + abs(values[0])  # |X| <= 1: friction only takes energy, and ``admission`` keeps the start in the well
        # Above 1 the terms of the series grow from the first on, and their differences say nothing: what the energy
        # allows takes their place.
        if delta > SMALL:
            estimate, notes = most, (*notes, f"delta = {float(delta):.3g} at the start is not small")
        elif not estimate < most:
            estimate = most
        sizes = [values[0] * length, values[1] * length * omega, values[2] * length]
        x, v, amplitude = (decimal_of_ball(value.mid(), digits) or "0" for value in sizes)
        error = decimal_of_ball((estimate * length + arb(half_unit(x, digits))).mid(), 2) or "0"
        shown = None if phase is None else decimal_of_ball(phase.mid(), digits) or "0"
        notes = (*oscillator.law.notes, *notes)
        worth = (self.order, self.gauge, METHOD, error, False)
        return MotionPoint(x, v, amplitude, shown, *worth, notes, self.frame)

    def _estimate(self, tau: arb, frame: Truncation, start: State, state: State) -> arb:
        """2 A (|change of ln A| + |change of psi| + |next terms of the waveform|), the change from N to N + 2."""
        # Two orders more, since p has odd and Omega even degrees only: N + 1 alone would change one of them.
        finer = Truncation.of(self.oscillator, self.order + 2, self.gauge)
        try:
            better = finer.state(tau, finer.start(None, start))
        except InputError:  # the law of order N + 2 breaks down before: nothing is known beyond the amplitude itself
            better = None
        if better is None:
            return 2 * (-state.s).exp()
        with ctx.workprec(64):
            terms = finer.terms(better)
        # The waveform's terms of degree N and N + 1, which order N leaves out.
        rest = sum((abs(z) for k, z in terms.items() if sum(k) >= self.order), arb(0))
        (s, psi), (s_next, psi_next) = state.turning_point(frame), better.turning_point(finer)
        return 2 * (-state.s).exp() * (abs(s - s_next) + abs(psi - psi_next) + rest)


def _require_sizes(oscillator: Oscillator) -> None:
    """The tables are doubles: refuse strengths and units that those cannot hold."""
    units = {"x0": oscillator.length(), "stiffness": oscillator.omega_0()}
    strengths = [("law", abs(e)) for e in oscillator.epsilons() if e != 0]
    for name, value in [*units.items(), *strengths]:
        if not (value < _LARGEST and value > 1 / _LARGEST):
            meaning = {"x0": "the length", "stiffness": "omega_0", "law": "epsilon"}[name]
            raise LimitError(name, f"{meaning} = {value.str(3, radius=False)} is out of range", "1e-100 to 1e100")


def _times(t: Array) -> tuple[Array, Array]:
    """The times as doubles and where they are NaN; InputError for what is no array of finite times >= 0."""
    try:
        times = np.asarray(t, dtype=float)
    except (TypeError, ValueError, OverflowError):
        raise InputError(
            "time", f"{type(t).__name__} is no array of times", "numbers >= 0, in s, of a law alone in 1/omega_0"
        ) from None
    bad = times[(times < 0) | np.isinf(times)]
    _require_time(bool(bad.size), f"{bad[0]} (and {bad.size - 1} more)" if bad.size > 1 else str(bad.sum()))
    return times, np.isnan(times)


def _require_time(negative: bool, shown: str) -> None:
    if negative:
        reason = f"{shown} is not a time after the start: the state is given at t = 0, and backwards damping is driving"
        raise InputError("time", reason, "a time >= 0, in s, of a law alone in 1/omega_0")
