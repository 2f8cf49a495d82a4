"""The same frame for arrays of times, in doubles: tables of the waveform, and of the slow flow as far as it is asked.

Heuristic floats throughout: nothing here is an enclosure.
"""

from dataclasses import dataclass, replace
from functools import reduce
from typing import Any

import numpy as np

from asymptotics.envelopes.slow_flow import SlowTable
from asymptotics.errors import InputError
from asymptotics.motions.stopping import last_swing
from asymptotics.motions.truncation import Guess, Truncation
from asymptotics.motions.waveform import WaveformTable
from asymptotics.numbers.double_error import EPS, STEP, of_rounding

# Rows of the table for 4096 times fit into the cache; the value changes the speed alone.
_CHUNK = 1 << 12
_STEPS, _WAVEFORM = 1024, 3e-13
"""Roundings of the slow table, whose sums lose half a last place at each of 2048 panels (equal ones all to one side);
what ``WaveformTable`` loses."""
FAR = 2.0
"""The amplitude at the start is the radius of the starting point up to O(delta): a factor e^2 is no correction."""
Array = Any


def out_of_reach() -> InputError:
    """delta is too large for the waveform or the gauge."""
    return InputError("order", "the start is outside the reach of the waveform series", "a lower order")


@dataclass(frozen=True, eq=False)
class Doubles:
    """The same frame for arrays: tables of the waveform, and of the slow flow as far as it is asked for."""

    frame: Truncation
    table: WaveformTable
    begin: tuple[float, float]
    reached: list[tuple[float, SlowTable]]

    @classmethod
    def of(cls, frame: Truncation) -> "Doubles":
        """The tables of a frame; InputError if the waveform series does not reach the start."""
        table = WaveformTable.of(frame.flow, frame.forces, frame.order - 1)
        found = cls(frame, table, (0.0, 0.0), [])
        return cls(frame, table, found._begin(), [])

    def _begin(self) -> tuple[float, float]:
        """(s, psi) in the turning-point gauge at t = 0, by iterating (s, psi) = -conj ln(target/Z(s, psi)).

        InputError if that does not converge, or far away: then the series does not describe the start.
        """
        target = complex(float(self.frame.target.real), float(self.frame.target.imag))
        # At rest the start is a turning point, and in this gauge Z = 1 there.
        if target.imag == 0:
            return 0.0, 0.0 if target.real > 0 else float(np.pi)
        s, psi, step = 0.0, float(np.angle(target)), np.inf
        with np.errstate(all="ignore"):  # a series that does not reach the start runs away; that is caught below
            for _ in range(500):
                ratio = np.log(target / self._wave(s, psi))
                step = max(abs(-ratio.real - s), abs(ratio.imag - psi))
                # The logarithm knows the phase up to whole turns: the nearest one is taken.
                s, psi = -ratio.real, psi + (ratio.imag - psi + np.pi) % (2 * np.pi) - np.pi
                if step < 1e-15 or not abs(s) < FAR or not np.isfinite(psi):
                    break
        # The iteration contracts by about delta a step; 1e-12 where the rounding of the table does not allow 1e-15.
        if not (step < 1e-12 and abs(s) < FAR):
            raise out_of_reach()
        return s, psi

    def _wave(self, s: float, psi: float) -> complex:
        """The waveform Z = P + i Q at one place (s, psi)."""
        P, Q = self.waveform(np.array([s]), np.array([psi]))
        return complex(P[0], Q[0])

    def jacobian(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """Derivatives of (Re, Im) of -s + i psi + ln Z with respect to s and psi, by central differences."""
        s, psi = self.begin
        # For central differences of a table that is good to 1e-13: eight digits or so, and Newton's method in balls
        # needs few.
        h = 1e-5
        by_s = (np.log(self._wave(s + h, psi)) - np.log(self._wave(s - h, psi))) / (2 * h)
        by_psi = (np.log(self._wave(s, psi + h)) - np.log(self._wave(s, psi - h))) / (2 * h)
        return (by_s.real - 1, by_psi.real), (by_s.imag, by_psi.imag + 1)

    def guess(self) -> Guess:
        """Where Newton's method for the start in balls begins."""
        return Guess(self.begin, self.jacobian())

    def start(self) -> tuple[float, float]:
        """(s, psi) at t = 0 in the gauge."""
        s, psi = self.begin
        at = np.array([s])
        change = float(self.frame.modulus.array(at)[0])
        if not abs(change) < FAR:
            raise out_of_reach()
        return s - change, psi + float(self.frame.argument.array(at)[0])

    def slow(self, tau_max: float) -> SlowTable:
        """The table of the slow flow, through ``tau_max`` at least; the last one is kept."""
        tau_max = max(tau_max, 1.0)
        if not self.reached or self.reached[-1][0] < tau_max:
            # A table to a later time serves all earlier ones.
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

    def turning_point(self, table: SlowTable, tau: Array) -> tuple[Array, Array]:
        """(s, psi) in the turning-point gauge at times inside a table of the slow flow."""
        s, phi = table.at(tau)
        psi = tau + phi + self.start()[1]
        if not self.frame.back_argument.terms:
            return s, psi
        return s - self.frame.back_modulus.array(s), psi + self.frame.back_argument.array(s)

    def evaluate(self, tau: Array) -> Array:
        """Rows X, X', A, phi at an array of times; zero (phi: NaN) beyond the extinction.

        Where dry friction stops the mass it stays: X held, X' = 0 from the stop on.  From the last turning point on,
        where friction alone acts (``stopping``), A = |X| and phi is NaN: the slow flow is not asked any more.
        """
        with np.errstate(all="ignore"):
            out = self._evaluated(tau)
        if not np.isfinite(out[:3]).all():
            bad = float(tau[int(np.argmin(np.isfinite(out[:3]).all(axis=0)))])
            reason = f"the series of this order overflows at omega_0 t = {bad:.6g}: delta is too large for it"
            raise InputError("order", reason, "a lower order, or the reference motion")
        return out

    def errors(self, tau: Array) -> Array:
        """How far the doubles of ``evaluate`` are from what they stand for, in its rows: estimates, not bounds.

        Of the slow table what half its knots change, and its rounding; X and X' have the turns of the phase and the
        table of the waveform too, and one error for all times.
        """
        table = self.slow(float(tau.max(initial=0.0)))
        half = replace(self, reached=[(np.inf, table.halved())])
        with np.errstate(all="ignore"):
            found, coarse, earlier = self._expanded(tau), half._expanded(tau), self._expanded(tau * (1 - STEP))
            # A third: the coarse table is off by four times what the fine one is, or more, and the two are compared.
            errors = np.abs(found - coarse) / 3 + of_rounding(found, earlier, _STEPS)
            lost = np.nan_to_num(errors[2] / found[2]) + np.nan_to_num(errors[3])
        wave = _WAVEFORM if self.table.keys else 0.0
        errors[:2] = np.max(found[2] * (lost + 8 * EPS * (1 + tau) + wave), initial=0.0)
        if (last := last_swing(self, float(tau.max(initial=0.0)))) is not None:
            errors[2] = np.where(tau >= last.begin, errors[0], errors[2])  # A = |X| there
        return errors

    def phases(self, tau: Array) -> Array:
        """phi of the slow flow at an array of times, wherever friction ends the motion; NaN beyond the extinction."""
        with np.errstate(all="ignore"):
            return self._expanded(tau)[3]

    def _evaluated(self, tau: Array) -> Array:
        out = self._expanded(tau)
        last = last_swing(self, float(tau.max(initial=0.0)))
        if last is not None:
            over = tau >= last.begin
            out[0, over], out[1, over] = last.at(tau[over])
            out[2, over], out[3, over] = np.abs(out[0, over]), np.nan
        return out

    def _expanded(self, tau: Array) -> Array:
        """The rows without the end that dry friction makes."""
        table, psi_0 = self.slow(float(tau.max(initial=0.0))), self.start()[1]
        out = np.empty((4, tau.size))
        for low in range(0, tau.size, _CHUNK):
            part = tau[low : low + _CHUNK]
            # Beyond its end, the extinction, the table has no value; those places are set to 0 below.
            s, phi = table.at(np.minimum(part, table.tau[-1]))
            here, psi = s, part + phi + psi_0
            if self.frame.back_argument.terms:
                here, psi = s - self.frame.back_modulus.array(s), psi + self.frame.back_argument.array(s)
            P, Q = self.waveform(here, psi)
            A, cosine, sine = np.exp(-here), np.cos(psi), np.sin(psi)
            rows = out[:, low : low + _CHUNK]
            rows[0], rows[1] = A * (P * cosine - Q * sine), -A * (P * sine + Q * cosine)
            rows[2], rows[3] = A if here is s else np.exp(-s), phi + psi_0
            gone = part >= table.extinction
            rows[:3, gone], rows[3, gone] = 0.0, np.nan
        return out
