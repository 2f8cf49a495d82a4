"""The envelope of a pendulum or Duffing oscillator in SI units: first order in the loss, exact in the spring.
Averaging in the action-angle variables of the conservative motion, which is given by Jacobi's elliptic functions.

A(t) is the turning amplitude, psi(t) = omega_0 t + phi(t) the phase (n pi at the n-th turning point), and with the
modulus k of the well at A

    pendulum:  theta = 2 arcsin(k cd(u, k)),  u = Theta psi;      Duffing:  x = A cn(u, mu),  u = Theta sqrt(B) psi.

Digits are certified for this slow flow (``envelopes.large``), which reaches an amplitude at a phase and time that are
right to O(eps^2) relative, O(eps) absolute.  Arrays are doubles.

>>> from asymptotics.law import Oscillator
>>> air = SpringEnvelope.of(Oscillator({2: "1/20"}, spring="pendulum", x0="5/2"))
>>> air.amplitude(40, digits=12), air.phase(40, digits=8), air.period("5/2", digits=10)
('0.784624230235', '-4.7321741', '10.32316287')
>>> air.sample([0.0, 40.0]).x.round(6).tolist()
[2.5, -0.598221]
"""

from dataclasses import dataclass, field
from functools import partial
from typing import Any

import numpy as np
from flint import arb
from numpy.typing import ArrayLike

from asymptotics.curves.motions import POINTS, axes_of_motion, envelope_lines, time_of_curve
from asymptotics.curves.slow_numbers import SlowNumbers
from asymptotics.envelopes.first_order import exact_kappa, start_phase
from asymptotics.envelopes.large import SlowFlow
from asymptotics.errors import InputError, LimitError, UndecidedError
from asymptotics.expansions.straightening.wells import Loss, Well
from asymptotics.frames import Frame
from asymptotics.law import LawLike, Oscillator
from asymptotics.law_given import given_of
from asymptotics.motions.result import MotionSamples
from asymptotics.numbers.arrays import real_array
from asymptotics.numbers.decimals import certified_decimal
from asymptotics.numbers.double_error import STEP, of_rounding
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.policy import Number, exact_integer, exact_number, require_one
from asymptotics.numbers.precision import at_growing_precision
from asymptotics.present.drawn import Drawn
from asymptotics.present.shown import Page
from asymptotics.running.public import public
from asymptotics.terms import Term

# Refusals alone: each step of a Newton iteration integrates hypergeometric functions to all digits, and at omega_0 t =
# 10^100 the number of turns itself has a hundred.
MAX_DIGITS, MAX_TAU = 200, 1e100
_STEPS = 1024  # roundings of a table, whose sums lose half a last place at each of 2048 panels
Array = Any
NOTE = "first order in the loss, exact in the spring"


@dataclass(frozen=True, repr=False)
class SpringEnvelope(SlowNumbers, Drawn):
    """A(t), phi(t) and the motion of an oscillator with the spring x^3 or of a pendulum; build it with ``of``."""

    oscillator: Oscillator
    averaging: str = "mean"
    notes: tuple[str, ...] = field(default=(), compare=False)
    formula: None = None
    time_formula: None = None
    frame: Frame = field(kw_only=True, compare=False)

    @classmethod
    def of(cls, law: LawLike) -> "SpringEnvelope":
        """InputError for other springs, anti-damping, a start with a velocity, and a start outside the well."""
        given = given_of(law)
        oscillator = given.oscillator
        forces = oscillator.law
        forces.require_dissipative("amplitude that falls")
        springs = [t for t in forces.springs if not t.b.is_zero]
        known = "one spring c x^3, or the pendulum"
        if len(springs) != 1 or not (springs[0].family or (springs[0].position == 3 and springs[0].velocity.is_zero)):
            shown = " + ".join(t.shape() for t in springs) or "the linear spring"
            raise InputError("spring", f"no envelope exact in the spring is known for {shown}", known)
        if springs[0].family:
            for t in forces.losses:
                if t.position and not t.b.is_zero:
                    reason = f"{t.shape()} depends on the angle: no closed form is known beside the pendulum"
                    raise InputError("law", reason, "losses x'|x'|^(alpha-1), or |x|^m x'|x'|^(alpha-1) beside x^3")
        if not oscillator.v0.is_zero:
            raise InputError("v0", "the envelope exact in the spring starts at a turning point", "v0 = 0")
        found = cls(oscillator, notes=(*oscillator.notes, NOTE), frame=given.frame)
        try:
            # The start is 1 in its own unit; a start on the separatrix is not certainly inside and is refused with
            # those beyond.  A number of a thousand digits, the longest that is read, is told from it in 4096 bits.
            at_growing_precision(lambda _: found._flow().well.xi(arb(1)), 1, 64, max_bits=1 << 12)
        except (InputError, UndecidedError):  # they speak of x in units of x0
            inside = "less than pi rad" if springs[0].family else "1 + c A^2 > 0"
            raise InputError("x0", f"{oscillator.x0} is not certainly inside the well", inside) from None
        return found

    @public
    def amplitude(self, t: Number, *, digits: int = 30, max_seconds: Number = 60) -> str:
        """The turning amplitude A(t) in m, correctly rounded; "0" from the extinction time on."""
        require_one(t, "t", "amplitudes(t)")

        def metres(seconds: ExactReal) -> arb | ExactReal:
            # At t = 0 the amplitude is x0 itself, exact, and may be a tie or have few digits: a ball would not round.
            if seconds.is_zero:
                return abs(self.oscillator.x0)
            return self._flow().amplitude(self._tau(seconds)) * self._length()

        return self._decimal(metres, t, digits)

    @public
    def phase(self, t: Number, *, digits: int = 30, max_seconds: Number = 60) -> str:
        """phi(t) = psi - omega_0 t in rad; phi(0) is 0, or pi where x0 < 0."""
        require_one(t, "t", "phases(t)")
        return self._decimal(
            lambda seconds: start_phase(self.oscillator) + self._flow().phase(self._tau(seconds)), t, digits
        )

    @public
    def time(self, amplitude: Number, *, digits: int = 30, max_seconds: Number = 60) -> str:
        """The time in s at which the turning amplitude falls to ``amplitude`` (m)."""
        metres = exact_number(amplitude, "amplitude")
        if not 0 < metres <= abs(self.oscillator.x0):
            raise InputError(
                "amplitude", f"{self.frame.with_unit('x', metres)} is not on the way", "0 < amplitude <= A(0)"
            )
        # Decided exactly: the integral from A(0) to A(0) in balls is a ball around 0, which has no first digit.
        if metres == abs(self.oscillator.x0):
            return "0"

        def seconds() -> arb:
            flow = self._flow()
            return flow.time(flow.well.xi(metres.ball() / self._length())) / self.oscillator.omega_0()

        return certified_decimal(seconds, exact_integer(digits, "digits", 1, MAX_DIGITS))

    @public
    def period(self, amplitude: Number, *, digits: int = 30, max_seconds: Number = 60) -> str:
        """The period in s of the motion without loss at a turning amplitude in m: exact, an elliptic integral."""
        metres = exact_number(amplitude, "amplitude")

        def seconds() -> arb:
            well = self._flow().well
            theta = arb(well.turn(well.xi(metres.ball() / self._length())))
            return 2 * arb.pi() * theta / self.oscillator.omega_0()

        return certified_decimal(seconds, exact_integer(digits, "digits", 1, MAX_DIGITS))

    @public
    def extinction_time(self, *, digits: int = 30, max_seconds: Number = 60) -> str | None:
        """When the averaged amplitude reaches 0 in s (a loss of degree below 1), or None: not the end of the motion."""
        D = exact_integer(digits, "digits", 1, MAX_DIGITS)
        losses = [t for t in self.oscillator.dimensionless.losses if not t.strength.is_zero]
        # Decided by the exact exponents: in balls of the precision in force 1 - 10^-20 may be 1.
        if not any(t.velocity < 1 - t.position for t in losses):
            return None
        # ``_flow`` is made anew at every precision: its strengths are balls of the precision in force.  There is an
        # extinction here, so that ``or`` never acts: it is for the type.
        return certified_decimal(lambda: (self._flow().extinction_time() or arb(0)) / self.oscillator.omega_0(), D)

    @public
    def kappas(self, *, digits: int = 30, max_seconds: Number = 60) -> tuple[str, ...]:
        """kappa_i = <|cos|^m |sin|^(alpha+1)> epsilon_i of the losses in their order: rates at small amplitude."""
        D = exact_integer(digits, "digits", 1, MAX_DIGITS)
        losses = self.oscillator.dimensionless.losses
        exact = [ExactReal(0) if t.strength.is_zero else exact_kappa(t) for t in losses]

        def rate(i: int) -> arb | ExactReal:
            known, loss = exact[i], _loss(losses[i])
            return loss.epsilon * loss.mean if known is None else known

        return tuple(certified_decimal(partial(rate, i), D) for i in range(len(exact)))

    @public
    def amplitudes(self, t: ArrayLike, *, max_seconds: Number = 60) -> Array:
        """A in m at an array of times in s: doubles; NaN stays NaN, extinct is 0."""
        return self.sample(t).amplitude

    @public
    def phases(self, t: ArrayLike, *, max_seconds: Number = 60) -> Array:
        """phi in rad at an array of times in s: doubles; NaN where there is no amplitude."""
        return self.sample(t).phase

    @public
    def sample(self, t: ArrayLike, *, max_seconds: Number = 60) -> MotionSamples:
        """x, v, A, phi at many times in s: doubles."""
        return self._sampled(t, halved=False)

    def _double_errors(self, t: Array) -> tuple[Array, Array]:
        """How far the doubles of A and phi are from the slow flow, by half the knots of their table; estimates."""
        found, coarse, earlier = self.sample(t), self._sampled(t, halved=True), self.sample(np.asarray(t) * (1 - STEP))
        A, phi = (
            np.abs(fine - half) / 3 + of_rounding(fine, before, _STEPS)
            for fine, half, before in zip(*((s.amplitude, s.phase) for s in (found, coarse, earlier)))
        )
        return A, phi

    def _sampled(self, t: ArrayLike, *, halved: bool) -> MotionSamples:
        times = real_array(t, "time")
        if np.any(times < 0) or np.any(np.isinf(times)):
            raise InputError("time", "a time is negative or infinite", "times >= 0, in s, of a law alone in 1/omega_0")
        omega, length = float(self.oscillator.omega_0().mid()), float(self._length().mid())
        # NaN and extinct times are computed at a harmless place and overwritten: the table is for 0 <= tau before the
        # end.
        missing = np.isnan(times)
        tau = np.where(missing, 0.0, times) * omega
        _require_near(bool(np.all(tau <= MAX_TAU)))
        # initial=1: a table has to have some length even for no times at all.
        table = self._flow().table(float(np.max(tau, initial=1.0)))
        table = table.halved() if halved else table
        gone = tau >= table.extinction
        s, phi = table.at(np.where(gone, 0.0, tau))
        xi = np.exp(-s)
        X, V = self._wave(xi, tau + phi)
        A = self._flow().well.amplitude(xi)
        # Springs and losses are odd: from -x0 the mirror image.
        side = length * self.oscillator.x0.sign
        rows = (X * side, V * side * omega, A * length)
        x, v, A = (np.where(missing, np.nan, np.where(gone, 0.0, row)) for row in rows)
        # psi + pi is on the other side, and the wave at psi with its sign changed the same without a rounding.
        phase = np.where(missing | gone, np.nan, phi + float(start_phase(self.oscillator).mid()))
        extinction = None if np.isinf(table.extinction) else table.extinction / omega
        return MotionSamples(times, x, v, A, phase, 1, "turning-point", int(missing.sum()),
                             int((gone & ~missing).sum()), extinction, self.notes,
                             self.frame)  # fmt: skip

    @public
    def columns(
        self, t: ArrayLike, *, order: int | None = None, max_seconds: Number = 60
    ) -> tuple[Array, Array, Array]:
        """Arrays t, A, phi at times in s, in doubles; there is no other order than the first."""
        if order is not None:
            raise InputError("order", "it is not known beside a spring", "one law alone")
        found = self.sample(t)
        return found.t, found.amplitude, found.phase

    def _heading(self) -> str:
        return f"{self.oscillator}: envelope, {NOTE}"

    def _curve(self, axes: Any, **style: Any) -> None:
        until = time_of_curve(self.oscillator, style.pop("until", None))
        # Asked of no times, for the refusal of an order alone.
        self.columns([], order=style.pop("order", None))
        found = self.sample(np.linspace(0.0, until, POINTS))
        axes_of_motion(axes, self.frame)
        axes.plot(found.t, found.x, **{"label": "x", **style})
        envelope_lines(axes, found.t, found.amplitude)

    def _wave(self, xi: Array, psi: Array) -> tuple[Array, Array]:
        """X and X' of the conservative motion at the straightened amplitude xi and the phase psi."""
        from scipy.special import ellipj  # noqa: PLC0415 (slow to load; the curve alone needs it)

        well, g = self._flow().well, float(self._flow().well.strength.mid())
        theta = np.asarray(well.theta(-np.log(xi)))
        if well.kind == "pendulum":
            # g = theta_0^2 for x in units of the start theta_0, so that k = sin(A/2) with A in rad; theta = sqrt(g) X.
            # Slow changes of k are left out of X', as in x = A cos psi with v = -omega A sin psi.
            k = np.sqrt(g) * xi / 2
            sn, cn, dn, _ = ellipj(theta * psi, k * k)
            return 2 * np.arcsin(k * cn / dn) / np.sqrt(g), -2 * k * np.sqrt(1 - k * k) * sn / dn / np.sqrt(g)
        # xi = sqrt(2 V): B = 1 + g A^2, the square of the frequency of cn; mu = g A^2/(2 B) is its parameter k^2.
        B = np.sqrt(1 + 2 * g * xi * xi)
        A, mu, fast = well.amplitude(xi), (B - 1) / (2 * B), np.sqrt(B)
        u = theta * fast * psi
        # A soft spring has mu < 0, where SciPy's ellipj is not defined.  For a negative parameter
        # cn(u|-m) = cd(u sqrt(1+m) | m/(1+m)) (Abramowitz and Stegun, section 16.10).
        if g >= 0:
            sn, cn, dn, _ = ellipj(u, mu)
            return A * cn, -A * fast * sn * dn
        stretch, other = np.sqrt(1 - mu), -mu / (1 - mu)  # cn of a negative parameter is cd of a positive one
        sn, cn, dn, _ = ellipj(u * stretch, other)
        return A * cn / dn, -A * fast * stretch * (1 - other) * sn / dn**2

    def _decimal(self, value: Any, t: Number, digits: Any) -> str:
        seconds = exact_number(t, "time")
        _require_near(bool(self._tau(seconds) < MAX_TAU))
        return certified_decimal(lambda: value(seconds), exact_integer(digits, "digits", 1, MAX_DIGITS))

    def _tau(self, seconds: ExactReal) -> arb:
        return seconds.ball() * self.oscillator.omega_0()

    def _length(self) -> arb:
        return self.oscillator.length()

    def _losses(self) -> tuple[Loss, ...]:
        return tuple(_loss(t) for t in self.oscillator.dimensionless.losses if not t.strength.is_zero)

    def _flow(self) -> SlowFlow:
        """The flow with balls of the current precision."""
        # Not cached: the caller's precision decides how wide its balls are.
        springs = [t for t in self.oscillator.dimensionless.springs if not t.strength.is_zero]
        strength = springs[0].strength.ball()
        well = Well.pendulum(strength) if springs[0].family else Well.duffing(strength)
        return SlowFlow(well, self._losses(), arb(1))

    @public
    def to_dict(self, *, max_seconds: Number = 60) -> dict[str, object]:
        """JSON-ready: the oscillator, the rates at small amplitude, the period at the start, the extinction."""
        start = abs(self.oscillator.x0)
        numbers = {"kappas": list(self.kappas()), "period": self.period(start), "extinction": self.extinction_time()}
        return {
            "oscillator": self.oscillator.to_dict(),
            "averaging": self.averaging,
            **numbers,
            "notes": list(self.notes),
        }

    def __str__(self) -> str:
        kappas = ", ".join(f"kappa_{i} = {k}" for i, k in enumerate(self.kappas(digits=10), start=1))
        return f"{NOTE}\n{kappas}" if kappas else f"{NOTE}\nno loss"

    def __repr__(self) -> str:
        return f"SpringEnvelope({self.oscillator})"

    def _page(self) -> Page:
        title, *rest = str(self).splitlines()
        rows = tuple((f"kappa_{i}", k) for i, k in enumerate(self.kappas(digits=12), start=1))
        rows += (
            (
                "period at the start, without loss",
                self.frame.with_unit("period", self.period(abs(self.oscillator.x0), digits=12)),
            ),
        )
        worth = "certified digits of the averaged law"
        return Page(title, (*rest, worth, f"{self.oscillator}"), ("", "value"), rows)

    def _formula(self) -> str:
        return r"A(\tau)\ \text{by}\ {}_2F_1\text{, exact in the spring}"

    def _letters(self) -> dict[str, str]:
        return {"A": "turning amplitude", "F": "the hypergeometric function"}


def _loss(term: Term) -> Loss:
    return Loss(term.strength.ball(), term.velocity.ball(), term.position)


def _require_near(near: bool) -> None:
    if not near:
        raise LimitError("time", "it is too many swings", f"omega_0 t <= {MAX_TAU:g}")
