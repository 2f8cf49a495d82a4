"""x(t) and v(t) from the expansion: amplitude, phase and waveform at order N, any law, any start.

Order N: dA/d tau and d psi/d tau with p_k and Omega_k for k <= N, and the waveform through delta^(N-1),

    x - i v/omega_0 = A e^(i psi) (1 + sum_(1<=n<N) delta^n Z_n(psi)),     psi = omega_0 t + phi.

Order 1 is Lancaster (13), x = x0 A(t) cos(omega_0 t).  The start is part of the expansion: A(0) and phi(0) solve this
equation at t = 0.  In another gauge than the turning-point gauge the slow equations are those of the gauge, and the
waveform is reached through c(delta) (theory page ``gauges``: at fixed psi nothing else may be expanded).

``error`` is an estimate, not a bound: twice what the orders N + 1 and N + 2 change in amplitude, phase and waveform;
for delta > 1 at the start at least the whole unit of length, with a note.
If some alpha < 1 the averaged amplitude vanishes at a fictitious extinction time; from then on x = v = 0 is returned
and said to be so.

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
"""

from dataclasses import dataclass
from functools import cached_property, reduce
from math import log
from typing import Any

import numpy as np
from flint import acb, arb, ctx

from asymptotics.errors import InputError, LimitError
from asymptotics.gauges import TURNING_POINT, require_gauge
from asymptotics.half_swings.certified import quarter_swing
from asymptotics.law import Oscillator
from asymptotics.motions.certify import half_unit
from asymptotics.motions.result import MotionPoint, MotionSamples
from asymptotics.motions.slow_flow import ExponentialSum, SlowLaw, SlowTable
from asymptotics.motions.waveform import WaveformTable, waveform_at
from asymptotics.normal_form.expansion import Expansion, expansion_of
from asymptotics.normal_form.flow import Flow
from asymptotics.numbers.decimals import bits_for, decimal_of_ball
from asymptotics.numbers.policy import Number, exact_number
from asymptotics.series import Key

MAX_ORDER, MAX_DIGITS = 12, 300
METHOD = "asymptotic expansion"
_CHUNK = 1 << 12
_GUARD = 64
_LARGEST = arb(10) ** 100
Array = Any


@dataclass(frozen=True, eq=False)
class AsymptoticMotion:
    """The motion of ``oscillator`` at ``order`` in ``gauge``; build it with ``of``."""

    oscillator: Oscillator
    order: int
    gauge: str

    @classmethod
    def of(cls, oscillator: Oscillator, order: int = 3, gauge: str = TURNING_POINT) -> "AsymptoticMotion":
        """Check the input; InputError for an unknown gauge, an order out of range, anti-damping."""
        require_gauge(gauge)
        if not 1 <= order <= MAX_ORDER:
            raise InputError("order", f"{order} is out of range", f"an integer from 1 to {MAX_ORDER}")
        oscillator.law.require_dissipative("amplitude that falls")
        _require_sizes(oscillator)
        return cls(oscillator, order, gauge)

    def at(self, t: Number, digits: int = 30) -> MotionPoint:
        """The motion at the time t >= 0 (exact number, s), each value to ``digits`` significant digits.

        InputError for t < 0, digits out of range, or a law whose truncated amplitude equation has lost its sign.
        """
        moment = exact_number(t, "time")
        _require_time(bool(moment < 0), str(moment))
        if not 1 <= digits <= MAX_DIGITS:
            raise InputError("digits", f"{digits} is out of range", f"an integer from 1 to {MAX_DIGITS}")
        with ctx.workprec(64):
            size = (moment.ball() * self.oscillator.omega_0()).mid()
        if size > _LARGEST:
            raise LimitError("time", f"{moment} s is too many swings", "omega_0 t <= 1e100")
        swings = int(float((size + 1).log()) / log(2))  # bits that the whole turns of the phase take
        with ctx.workprec(bits_for(digits, _GUARD) + 16 * self.order + swings):
            return self._point((moment.ball() * self.oscillator.omega_0()).mid(), digits)

    def sample(self, t: Array) -> MotionSamples:
        """The motion at an array of times (s, doubles).  NaN stays in its place; a negative time is an InputError."""
        times = np.asarray(t, dtype=float)
        missing = np.isnan(times)
        if np.any(times < 0) or np.any(np.isinf(times)):
            bad = times[(times < 0) | np.isinf(times)]
            _require_time(True, f"{bad[0]} (and {bad.size - 1} more)" if bad.size > 1 else str(bad[0]))
        omega, length = (float(x) for x in (self.oscillator.omega_0(), self.oscillator.length()))
        flat = np.where(missing, 0.0, times).ravel() * omega
        columns = self._doubles.evaluate(flat)
        extinction = self._doubles.slow(float(flat.max(initial=0.0))).extinction
        gone = flat >= extinction
        scale = np.array([length, length * omega, length, 1.0])[:, None]
        columns *= scale
        if np.any(missing):
            columns[:, missing.ravel()] = np.nan
        values = columns.reshape((4, *times.shape))
        notes = self.oscillator.law.notes + _notes(int(missing.sum()), int(gone.sum()), extinction / omega)
        end = extinction / omega if np.isfinite(extinction) else None
        x, v, a, phi = values
        return MotionSamples(
            times, x, v, a, phi, self.order, self.gauge, int(missing.sum()), int(gone.sum()), end, notes
        )

    @cached_property
    def _doubles(self) -> "_Doubles":
        with ctx.workprec(120):
            return _Doubles.of(_Frame.of(self.oscillator, self.order, self.gauge))

    def _point(self, tau: arb, digits: int) -> MotionPoint:
        frame = _Frame.of(self.oscillator, self.order, self.gauge)
        start = frame.start(self._doubles)
        state = frame.state(tau, start)
        length = self.oscillator.length()
        if state is None:
            with ctx.workprec(120):
                end = self._doubles.slow(float(tau)).extinction / float(self.oscillator.omega_0())
            error = decimal_of_ball(length.mid(), 2) or "0"
            notes = self.oscillator.law.notes + _notes(0, 1, end)
            return MotionPoint("0", "0", "0", None, self.order, self.gauge, METHOD, error, False, notes)
        z = state.point(frame)
        velocity = -z.imag * length * self.oscillator.omega_0()
        values = (z.real * length, velocity, (-state.s).exp() * length, state.psi - tau)
        x, v, amplitude, phase = (decimal_of_ball(value.mid(), digits) or "0" for value in values)
        estimate, notes = self._estimate(tau, frame, start, state), self.oscillator.law.notes
        delta = sum(frame.epsilons, arb(0))
        if delta > 1:  # the terms of the series grow from the start: their differences say nothing
            estimate, notes = estimate.max(arb(1)), (*notes, f"delta = {float(delta):.3g} at the start is not small")
        error = decimal_of_ball((estimate * length + arb(half_unit(x, digits))).mid(), 2) or "0"
        return MotionPoint(x, v, amplitude, phase, self.order, self.gauge, METHOD, error, False, notes)

    def _estimate(self, tau: arb, frame: "_Frame", start: "_State", state: "_State") -> arb:
        """2 A (|change of ln A| + |change of psi| + |next terms of the waveform|), the change from N to N + 2."""
        finer = _Frame.of(self.oscillator, self.order + 2, self.gauge)
        try:
            better = finer.state(tau, finer.start(None, start))
        except InputError:  # the law of order N + 2 breaks down before: nothing is known beyond the amplitude itself
            better = None
        if better is None:
            return 2 * (-state.s).exp()
        with ctx.workprec(64):
            terms = finer.terms(better)
        rest = sum((abs(z) for k, z in terms.items() if sum(k) >= self.order), arb(0))
        (s, psi), (s_next, psi_next) = state.turning_point(frame), better.turning_point(finer)
        return 2 * (-state.s).exp() * (abs(s - s_next) + abs(psi - psi_next) + rest)


@dataclass(frozen=True)
class _State:
    """s = -ln A and psi in the gauge of the frame."""

    s: arb
    psi: arb

    def turning_point(self, frame: "_Frame") -> tuple[arb, arb]:
        """(s, psi) in the turning-point gauge."""
        return self.s - frame.back_modulus(self.s), self.psi + frame.back_argument(self.s)

    def point(self, frame: "_Frame") -> acb:
        """X - i X'."""
        s, psi = self.turning_point(frame)
        Z = sum(frame.terms(self).values(), acb(1))
        return (-s).exp() * (acb(0, 1) * psi).exp() * Z


@dataclass(frozen=True)
class _Frame:
    """Everything that order and gauge fix at the current precision, in units of length and tau."""

    order: int
    target: acb
    epsilons: tuple[arb, ...]
    flow: Flow
    law: SlowLaw
    modulus: ExponentialSum
    argument: ExponentialSum
    back_modulus: ExponentialSum
    back_argument: ExponentialSum

    @classmethod
    def of(cls, oscillator: Oscillator, order: int, gauge: str) -> "_Frame":
        """From the certified expansion through ``order``; only midpoints are used."""
        expansion = _expansion(oscillator, order, gauge)
        epsilons = tuple(e.mid() for e in oscillator.epsilons())

        def sums(series: Any, top: int) -> ExponentialSum:
            return ExponentialSum.of(series, epsilons, expansion.flow.grading, top)

        law = SlowLaw(sums(expansion.p, order), sums(expansion.Omega, order))
        there, back = expansion.gauge_map, expansion.gauge_map.inverse()
        maps = [sums(f, order - 1) for m in (there, back) for f in (m.log_modulus, m.argument)]
        length, omega = oscillator.length(), oscillator.omega_0()
        target = acb(oscillator.x0.ball() / length, -oscillator.v0.ball() / (omega * length))
        flow = expansion.turning_point_flow() if gauge != TURNING_POINT else expansion.flow
        return cls(order, acb(target.real.mid(), target.imag.mid()), epsilons, flow, law, *maps)

    def terms(self, state: _State) -> dict[Key, acb]:
        """delta^n Z_n(psi) for 1 <= |n| < order."""
        if self.order == 1:
            return {}
        s, psi = state.turning_point(self)
        found = {}
        for key, (p, q) in waveform_at(self.flow, psi, self.order - 1).items():
            found[key] = acb(p, q) * self.monomial(key, s)
        return found

    def monomial(self, key: Key, s: arb) -> arb:
        """delta^key at A = e^-s."""
        value = arb(1)
        for n, e, weight in zip(key, self.epsilons, self.flow.grading.weights):
            if n:
                value = value * (e * (-weight * s).exp()) ** n
        return value

    def start(self, doubles: "_Doubles | None", near: _State | None = None) -> _State:
        """(s, psi) at t = 0 in the gauge: A e^(i psi) Z = X_0 - i X'_0, by Newton's method from doubles."""
        if self.target.imag == 0:
            s, psi = arb(0), (arb(0) if self.target.real > 0 else arb.pi().mid())
        elif doubles is not None:
            s, psi = self._refined(doubles)
        else:
            s, psi = self._iterated(near)
        return _State((s - self.modulus(s)).mid(), (psi + self.argument(s)).mid())

    def _refined(self, doubles: "_Doubles") -> tuple[arb, arb]:
        """Newton's method with the Jacobian from doubles: seven digits or so at each step."""
        s, psi = (arb(x) for x in doubles.begin)
        (a, b), (c, d) = doubles.jacobian()
        for i in range(ctx.prec // 16 + 8):
            with ctx.workprec(min(ctx.prec, 90 + 28 * i)):  # what a step cannot gain need not be computed
                miss = self._miss(s, psi)
            determinant = a * d - b * c
            s = (s + (d * miss.real - b * miss.imag) / determinant).mid()
            psi = (psi + (a * miss.imag - c * miss.real) / determinant).mid()
            if abs(miss) < arb(2) ** (10 - ctx.prec):
                break
        return s, psi

    def _iterated(self, near: _State | None) -> tuple[arb, arb]:
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
        free = _Frame(self.order, self.target, self.epsilons, self.flow, self.law, *[ExponentialSum(())] * 4)
        value = self.target / _State(s, psi).point(free)
        return acb(value.log().real.mid(), value.log().imag.mid())

    def state(self, tau: arb, start: _State) -> _State | None:
        """(s, psi) at the time tau, or None beyond the extinction."""
        found = self.law.solve(tau, start.s)
        return None if found is None else _State(found[0], (start.psi + tau + found[1]).mid())


@dataclass(frozen=True, eq=False)
class _Doubles:
    """The same frame for arrays: tables of the waveform, and of the slow flow as far as it is asked for."""

    frame: _Frame
    table: WaveformTable
    begin: tuple[float, float]
    reached: list[tuple[float, SlowTable]]

    @classmethod
    def of(cls, frame: _Frame) -> "_Doubles":
        table = WaveformTable.of(frame.flow, frame.order - 1)
        found = cls(frame, table, (0.0, 0.0), [])
        return cls(frame, table, found._begin(), [])

    def _begin(self) -> tuple[float, float]:
        """(s, psi) in the turning-point gauge at t = 0, by iterating (s, psi) = -conj ln(target/Z(s, psi))."""
        target = complex(float(self.frame.target.real), float(self.frame.target.imag))
        if target.imag == 0:
            return 0.0, 0.0 if target.real > 0 else float(np.pi)
        s, psi = 0.0, float(np.angle(target))
        for _ in range(500):
            ratio = np.log(target / self._wave(s, psi))
            step = max(abs(-ratio.real - s), abs(ratio.imag - psi))
            s, psi = -ratio.real, psi + (ratio.imag - psi + np.pi) % (2 * np.pi) - np.pi
            if step < 1e-15:
                break
        if not step < 1e-12:
            raise InputError("order", "the start is outside the reach of the waveform series", "a lower order")
        return s, psi

    def _wave(self, s: float, psi: float) -> complex:
        """Z at one place."""
        P, Q = self.waveform(np.array([s]), np.array([psi]))
        return complex(P[0], Q[0])

    def jacobian(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """Derivatives of (Re, Im) of -s + i psi + ln Z with respect to s and psi, by central differences."""
        s, psi = self.begin
        h = 1e-5
        by_s = (np.log(self._wave(s + h, psi)) - np.log(self._wave(s - h, psi))) / (2 * h)
        by_psi = (np.log(self._wave(s, psi + h)) - np.log(self._wave(s, psi - h))) / (2 * h)
        return (by_s.real - 1, by_psi.real), (by_s.imag, by_psi.imag + 1)

    def start(self) -> tuple[float, float]:
        """(s, psi) at t = 0 in the gauge."""
        s, psi = self.begin
        at = np.array([s])
        return s - float(self.frame.modulus.array(at)[0]), psi + float(self.frame.argument.array(at)[0])

    def slow(self, tau_max: float) -> SlowTable:
        """The table of the slow flow, through ``tau_max`` at least; the last one is kept."""
        tau_max = tau_max or 1.0  # a table has at least two nodes
        if not self.reached or self.reached[-1][0] < tau_max:
            self.reached[:] = [(tau_max, self.frame.law.table(self.start()[0], tau_max))]
        return self.reached[-1][1]

    def waveform(self, s: Array, psi: Array) -> tuple[Array, Array]:
        """Re and Im of Z at (s, psi) in the turning-point gauge."""
        P, Q = np.ones_like(psi), np.zeros_like(psi)
        if self.table.keys:
            rows = self.table.at(np.mod(psi, np.pi))
            weights = (float(w) for w in self.frame.flow.grading.weights)
            deltas = [float(e) * np.exp(-w * s) for e, w in zip(self.frame.epsilons, weights)]
            for j, key in enumerate(self.table.keys):
                factor = reduce(np.multiply, [d for d, n in zip(deltas, key) for _ in range(n)])
                P += factor * rows[2 * j]
                Q += factor * rows[2 * j + 1]
        return P, Q

    def evaluate(self, tau: Array) -> Array:
        """Rows X, X', A, phi at an array of times; zero (phi: its last value) beyond the extinction."""
        table, psi_0 = self.slow(float(tau.max(initial=0.0))), self.start()[1]
        out = np.empty((4, tau.size))
        for low in range(0, tau.size, _CHUNK):
            part = tau[low : low + _CHUNK]
            s, phi = table.at(np.minimum(part, table.tau[-1]))
            phi += psi_0
            here, psi = s, part + phi
            if self.frame.back_argument.terms:
                here, psi = s - self.frame.back_modulus.array(s), psi + self.frame.back_argument.array(s)
            P, Q = self.waveform(here, psi)
            A, cosine, sine = np.exp(-here), np.cos(psi), np.sin(psi)
            rows = out[:, low : low + _CHUNK]
            rows[0], rows[1] = A * (P * cosine - Q * sine), -A * (P * sine + Q * cosine)
            rows[2], rows[3] = A if here is s else np.exp(-s), phi
            rows[:3, part >= table.extinction] = 0.0
        return out


def _expansion(oscillator: Oscillator, order: int, gauge: str) -> Expansion:
    quarter = quarter_swing(oscillator.law.alphas, order, moments=gauge != TURNING_POINT)
    return expansion_of(quarter, gauge, arithmetic="certified")


def _require_sizes(oscillator: Oscillator) -> None:
    """The tables are doubles: refuse strengths and units that those cannot hold."""
    units = {"x0": oscillator.length(), "stiffness": oscillator.omega_0()}
    strengths = [("law", e) for e in oscillator.epsilons() if e > 0]
    for name, value in [*units.items(), *strengths]:
        if not (value < _LARGEST and value > 1 / _LARGEST):
            meaning = {"x0": "the length", "stiffness": "omega_0", "law": "epsilon"}[name]
            raise LimitError(name, f"{meaning} = {value.str(3, radius=False)} is out of range", "1e-100 to 1e100")


def _require_time(negative: bool, shown: str) -> None:
    if negative:
        reason = f"{shown} is not a time after the start: the state is given at t = 0, and backwards damping is driving"
        raise InputError("time", reason, "a time >= 0 in seconds")


def _notes(missing: int, extinct: int, end: float) -> tuple[str, ...]:
    notes = []
    if missing:
        notes.append(f"NaN times: {missing}; NaN is kept in their places")
    if extinct:
        notes.append(
            f"times beyond the fictitious extinction time {end:.6g} s of the averaged law: {extinct}; x = v = 0 there,"
            " while the true motion sticks or creeps"
        )
    return tuple(notes)
