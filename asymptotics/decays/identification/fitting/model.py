"""What a law says of one run: turning points, turning times and passages with their derivatives, and their noise.

Unknown beside the law: ln of the first amplitude, the offset of the rest position, and (with times) ln omega_0 and the
start of the clock.
"""

from dataclasses import dataclass

import numpy as np

from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.forward.pendulum import PendulumHalfSwing, angle, well
from asymptotics.decays.identification.forward.quadrature import TooStrongError
from asymptotics.decays.identification.forward.sequence import TurningSequence, turning_sequence
from asymptotics.decays.identification.forward.swing import HalfSwingModel
from asymptotics.decays.identification.measuring.observations import Observations
from asymptotics.decays.records.units import UNITS

KINDS = ("x", "t", "passage")
"""Turning points, turning times, passages."""
_WILD = 300.0
"""The largest |ln omega_0| of a step of the search: e^300 is still a double, and belongs to no clock."""
_FLOOR = 1e-9
"""Residuals below this share of the first amplitude (or of 1/omega_0) are the arithmetic's, not the data's."""


@dataclass(frozen=True)
class Noise:
    """Standard deviations of turning points, turning times and passages, as far as they are known."""

    x: float | None = None
    t: float | None = None
    passage: float | None = None


class Model:
    """Residuals of one law for one run, with their derivatives, as functions of the parameter vector.

    ``pendulum``: x is an angle and the spring sin x; A stands for 2 sin(x/2) then (``pendulum``).

    The vector: ln(A_0/A_ref), the strengths s_i = epsilon_i A_ref^(w_i), the exponent if it is free, the offset, and
    (with times) ln omega_0 and t_0.
    """

    alternating = True
    absorbed = 0
    """Linear unknowns that stand in no vector of parameters, but are fitted beside every law."""

    def __init__(self, swing: HalfSwingModel, seen: Observations, offset: bool = True, pendulum: bool = False) -> None:
        self.angle = UNITS.get(seen.unit, 1.0) if pendulum else None
        self.reference = seen.reference if self.angle is None else float(well(seen.reference, self.angle))
        if self.angle is not None:
            # The turning point before the first sample, or before the first that counts, may be the largest.
            largest = float(np.abs(seen.x).max()) * self.angle
            swing = PendulumHalfSwing(swing.elements, seen.reference * self.angle, largest=largest, coarse=swing.coarse)
        self.swing, self.seen = swing, seen
        # Of fewer turning points an offset takes a parameter that the law needs more. A choice.  Peaks of one side know
        # none: it would be any loss that falls with the amplitude.
        self.offset = offset and len(seen.n) >= 8 and bool((seen.n % 2 != seen.n[0] % 2).any())
        self.law = slice(1, 1 + swing.parameters)
        self.after = 1 + swing.parameters
        self.size = self.after + self.offset + 2 * seen.has_times
        counts = [len(seen.x), len(seen.t), len(seen.passage_t)]
        self.groups = [slice(sum(counts[:i]), sum(counts[: i + 1])) for i in range(3) if counts[i]]
        self.kinds = [kind for kind, count in zip(KINDS, counts) if count]
        self.data = np.concatenate([seen.x, seen.t, seen.passage_t])
        sigmas = [seen.sigma_x, seen.sigma_t, seen.sigma_passage]
        # Known errors give the weights within a kind; their common size is found with the fit.
        shapes = [s / np.sqrt(np.mean(s**2)) if len(s) else np.ones(c) for s, c in zip(sigmas, counts) if c]
        self.shape = np.concatenate(shapes)
        self._known: tuple[Array, TurningSequence] | None = None
        self.predicted: tuple[tuple[bytes, float], tuple[Array, Array]] | None = None
        """The last prediction of a fit, and the parameters and the tolerance to which it belongs."""

    def _sequence(self, theta: Array) -> TurningSequence:
        """The turning points, sought from where the last ones lead by their derivatives."""
        law = theta[: self.after]
        guess = None
        if self._known is not None:
            before, run = self._known
            # The linear prediction by the derivatives that are there; a guess changes the work, never the sequence.
            guess = run.a + np.clip((law - before) @ run.d_a, -1.0, 1.0)
        run = turning_sequence(self.swing, self.seen.last, law, guess)
        self._known = law.copy(), run
        return run

    def _found_sequence(self, theta: Array) -> TurningSequence:
        """The turning points of a law that was fitted: beside the edge of its domain, where the last amplitude is
        nearly 0, a guess from another law may lead out of it, and none is needed."""
        try:
            return self._sequence(theta)
        except TooStrongError:
            self._known = None
            return self._sequence(theta)

    def amplitudes(self, theta: Array) -> tuple[Array, Array]:
        """The amplitudes at the turning points 0 ... last, about the rest position, in the unit of the data, and their
        derivatives by the first amplitude and the law."""
        run = self._found_sequence(theta)
        radius = self.reference * np.exp(run.a)
        size, stretch = (radius, np.ones(1)) if self.angle is None else angle(radius, self.angle)
        return size, radius * stretch * run.d_a

    def turning_times(self, theta: Array) -> Array:
        """The times of the turning points 0 ... last, where there are times."""
        return np.asarray(theta[-1] + np.exp(-theta[-2]) * self._found_sequence(theta).tau)

    def periods(self, theta: Array) -> tuple[Array, Array]:
        """Twice the time from each turning point to the next, and its derivatives (half-swings, parameters)."""
        run, rate = self._found_sequence(theta), np.exp(-theta[-2])
        slopes = 2 * np.diff(self._time_slopes(rate, run.tau, run.d_tau), axis=0)
        return 2 * rate * np.diff(run.tau), slopes

    def predict(self, theta: Array) -> tuple[Array, Array]:
        """The predicted data and their derivatives (data, parameters); TooStrongError outside the model's domain."""
        seen, after = self.seen, self.after
        if seen.has_times and not abs(theta[-2]) < _WILD:
            raise TooStrongError("the frequency leaves every bound")
        run = self._sequence(theta)
        radius = self.reference * np.exp(run.a[seen.n])
        size, stretch = (radius, np.ones(1)) if self.angle is None else angle(radius, self.angle)
        values = [seen.sign * size + (theta[after] if self.offset else 0.0)]
        slopes = [np.zeros((len(seen.x), self.size))]
        radius = radius * stretch
        slopes[0][:, :after] = (seen.sign * radius * run.d_a[:, seen.n]).T
        if self.offset:
            slopes[0][:, after] = 1.0
        if seen.has_times:
            rate = np.exp(-theta[-2])
            late, by = self._lateness(run, theta)
            tau, by = run.tau[seen.n] + late, run.d_tau[:, seen.n] + by
            values.append(theta[-1] + rate * tau)
            slopes.append(self._time_slopes(rate, tau, by))
        if len(seen.passage_t):
            tau, by = run.passage[seen.passage_n], run.d_passage[:, seen.passage_n]
            values.append(theta[-1] + rate * tau)
            slopes.append(self._time_slopes(rate, tau, by))
            if self.offset:
                # About an offset the passage is late by offset over speed, to first order in the offset; the sign of
                # the motion alternates with the half-swings.
                first = seen.sign[0] * np.where((seen.n[0] + seen.passage_n) % 2, -1.0, 1.0)
                ease = first * rate * np.exp(-run.log_speed[seen.passage_n]) / self.reference
                late = theta[after] * ease
                values[-1] = values[-1] + late
                slopes[-1][:, :after] -= (late * run.d_log_speed[:, seen.passage_n]).T
                slopes[-1][:, after] += ease
                slopes[-1][:, -2] -= late
        return np.concatenate(values), np.concatenate(slopes)

    def _lateness(self, run: TurningSequence, theta: Array) -> tuple[Array, Array]:
        """By what angle the local fits find each turning point too late (``late_extremes``), and its derivatives."""
        window, n = self.seen.window, self.seen.n
        late, by = np.zeros(len(n)), np.zeros((self.after, len(n)))
        if window is None:
            return late, by
        a, free = run.a[n], self.swing.free
        for i, element in enumerate(self.swing.elements):
            if element.kind != "loss":
                continue
            exponent = float(theta[self.after - 1]) if free and i == 0 else element.velocity
            weight = exponent + element.position - 1
            size = np.exp(weight * a)
            share = theta[1 + i] * window.lateness(exponent, element.position) * size
            late += share
            by += weight * share * run.d_a[:, n]
            by[1 + i] += window.lateness(exponent, element.position) * size
            if free and i == 0:
                by[-1] += a * share + theta[1] * window.by_exponent(exponent, element.position) * size
        return late, by

    def neglected(self, theta: Array) -> float:
        """What the series lacks in ln(amplitude), all swings together, as they were at the last prediction."""
        return 0.0 if self._known is None else self.swing.neglected(self._known[1].a[:-1], theta[self.law])

    def _time_slopes(self, rate: float, tau: Array, by: Array) -> Array:
        slopes = np.zeros((len(tau), self.size))
        slopes[:, : self.after] = rate * by.T
        slopes[:, -2], slopes[:, -1] = -rate * tau, 1.0
        return slopes

    @property
    def units(self) -> int:
        """How many swings stand beside each other: what a bootstrap draws."""
        return len(self.seen.n)

    def smooth_columns(self) -> dict[str, tuple[Array, Array]]:
        """For each kind of data, the variable of which it is a smooth function (up to alternating signs), and the
        data."""
        seen = self.seen
        return {
            "x": (seen.n.astype(float), seen.x),
            "t": (seen.n.astype(float), seen.t),
            "passage": (seen.passage_n.astype(float), seen.passage_t),
        }

    def scale_vector(self, scales: dict[str, float]) -> Array:
        """The standard deviation of each datum."""
        sigma = self.shape.copy()
        for kind, group in zip(self.kinds, self.groups):
            sigma[group] *= scales[kind]
        return sigma

    def floor(self, kind: str, theta: Array) -> float:
        """The smallest noise that is believed: of a sampled record, what the local polynomials of extraction leave."""
        return max(self.seen.floor, _FLOOR) * (self.seen.reference if kind == "x" else float(np.exp(-theta[-2])))
