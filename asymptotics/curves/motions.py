"""x(t) and v(t) as objects one can sample, plot, differentiate and ask for events: asymptotic and reference alike.

>>> osc = Oscillator({"3/2": "1/10"}, mass="3/2", stiffness=30, x0="1/5")
>>> asymptotic, truth = motion(osc, order=3), reference(osc)
>>> asymptotic.at(7).x, truth.at(7, digits=8).x
('0.16385309', '0.16385308')
>>> asymptotic.sample([0.0, 7.0]).x.round(8).tolist()
[0.2, 0.16385309]
>>> events = asymptotic.events(until=1.5)                          # turning points and passages through 0
>>> events.turning.round(6).tolist(), events.zeros.round(6).tolist()
([0.702503, 1.405005], [0.352506, 1.054996])
"""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from asymptotics.bounds.motion import proved_bound
from asymptotics.bounds.uniform import UniformBound, uniform_bound
from asymptotics.costs import require_affordable
from asymptotics.curves.events import Events, events_of
from asymptotics.curves.proved_states import ProvedStates
from asymptotics.errors import InputError
from asymptotics.frames import Frame, require_frame
from asymptotics.gauges import TURNING_POINT
from asymptotics.law import LawLike, Oscillator
from asymptotics.law_given import given_of, require_oscillator
from asymptotics.motions.asymptotic import MAX_ORDER, AsymptoticMotion
from asymptotics.motions.coulomb import coulomb_motion, coulomb_stop
from asymptotics.motions.point import MotionPoint
from asymptotics.motions.reference import estimated_seconds, reference_motion, reference_states
from asymptotics.motions.result import MotionSamples
from asymptotics.motions.state_route import alone
from asymptotics.numbers.arrays import real_array
from asymptotics.numbers.context import cached_property
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.policy import Number, exact_integer, exact_number, float_notes, require_one
from asymptotics.present.drawn import Drawn, below
from asymptotics.present.shown import Page
from asymptotics.running.budget import Unasked, seconds_left
from asymptotics.running.public import public

Array = Any
# 15 digits of the reference are what a double shows; 120 s (the estimates are good to a factor of three) bound the work
# of a curve.  They refuse, they decide no digit.
DIGITS, MAX_SECONDS = 15, Unasked(120)
# Points of a drawing: an expansion costs microseconds a point, a reference a certified step or more.
POINTS, ERROR_POINTS, REFERENCE_POINTS = 4001, 241, 401


@dataclass(frozen=True, repr=False)
class Motion(Drawn):
    """The asymptotic motion at ``order`` in ``gauge``: formal, with an error estimate at each time."""

    oscillator: Oscillator
    order: int
    gauge: str
    notes: tuple[str, ...] = field(default=(), compare=False)
    frame: Frame = field(kw_only=True, compare=False)

    def __post_init__(self) -> None:
        require_oscillator(self.oscillator)
        require_frame(self.frame)
        object.__setattr__(self, "order", exact_integer(self.order, "order", 1, MAX_ORDER))
        # Made once for its refusals; ``_motion`` makes its own when it is first asked.
        AsymptoticMotion.of(self.oscillator, self.order, self.gauge)

    @public
    def at(self, t: Number, *, digits: int | None = None, max_seconds: Number = 60) -> MotionPoint:
        """x, v, A and phi at one time ``t`` in s (tau of a law alone), to ``digits`` digits of the expansion.

        Without ``digits`` every value is rounded to the error estimate of x, which ``error`` has.
        """
        require_one(t, "t", "sample(t)")
        time, notes = exact_number(t, "t"), (*self.notes, *float_notes(t=t))
        if digits is not None:
            return self._with_frame(self._motion.at(time, exact_integer(digits, "digits", 1, 300)), notes)
        # Thirty digits of an expansion that is right to five would mislead: they are asked for by ``digits``.
        return self._with_frame(self._motion.at(time).rounded_to_error(), notes)

    def _with_frame(self, point: MotionPoint, notes: tuple[str, ...]) -> MotionPoint:
        return replace(point.with_notes(notes), frame=self.frame)

    @public
    def bound(self, t: Number, *, digits: int = 30, max_seconds: Number = 60) -> str:
        """A proved bound, rounded up, of |x(t) - x_N| in m, x_N being ``at(t, digits=digits).x``; ``t`` in s, or tau.

        LimitError where no enclosure of x(t) is within a minute's reach.
        """
        digits = exact_integer(digits, "digits", 1, 300)
        return proved_bound(self.oscillator, self.at(t, digits=digits).x, t, max_seconds=seconds_left())

    @public
    def uniform_bound(self, *, until: Number | None = None, max_seconds: Number = 60) -> UniformBound:
        """Proved bounds of |x - x_N| and |x' - x_N'| for every t >= 0 at once, or for t <= ``until`` (s).

        For powers of the velocity in the turning-point gauge; with an exponent below 1 the bound ends at a stated time
        (derivation ``uniform-bound``).  InputError for other forces and gauges, LimitError where the local strength
        leaves the range of the theorem.
        """
        # The waveform of the theorem is that of the gauge in which v vanishes at psi = n pi to every order.
        if self.gauge != TURNING_POINT:
            raise InputError("gauge", f"no such theorem is known in the gauge {self.gauge}", TURNING_POINT)
        return replace(uniform_bound(self.oscillator, self.order, until=until), frame=self.frame)

    @public
    def sample(self, t: ArrayLike, *, max_seconds: Number = 60) -> MotionSamples:
        """Arrays x, v, amplitude and phase of the shape of the times ``t`` (s, or tau), in doubles."""
        return replace(self._motion.sample(times_of(t)), frame=self.frame)

    @public
    def sol(self, t: ArrayLike, *, max_seconds: Number = 60) -> Array:
        """The dense solution: array [x, v] at the times ``t`` (s, or tau), as the ``sol`` of SciPy's ``solve_ivp``."""
        found = self.sample(t)
        return np.array([found.x, found.v])

    @public
    def events(self, until: Number, *, max_seconds: Number = 60) -> Events:
        """Turning points, zeros and the stop in 0 < t <= ``until`` (s, or tau)."""
        return events_of(self, until, None)

    def _heading(self) -> str:
        return f"{self.oscillator}: order {self.order}, {self.gauge} gauge"

    def _curve(self, axes: Any, **style: Any) -> None:
        """x and +-A; with ``errors=True`` |x - x_reference| on axes below."""
        errors = style.pop("errors", False)
        until = time_of_curve(self.oscillator, style.pop("until", None))
        found = self.sample(np.linspace(0.0, until, POINTS))
        axes_of_motion(axes, self.frame)
        axes.plot(found.t, found.x, **{"label": "x", **style})
        envelope_lines(axes, found.t, found.amplitude)
        if errors:
            t = np.linspace(0.0, until, ERROR_POINTS)
            # Fewer points than the curve: each is a point of the certified reference.  The start has the error 0, and a
            # logarithm none below 1e-17, under the rounding of doubles.
            error = np.abs(self.sample(t).x - Reference(self.oscillator, frame=self.frame).sample(t).x)
            lower = below(axes)
            lower.semilogy(t[1:], np.maximum(error[1:], 1e-17), color="#15803d")
            lower.set_ylabel(self.frame.axis("|x - reference|"))

    @cached_property
    def _motion(self) -> AsymptoticMotion:
        return AsymptoticMotion.of(self.oscillator, self.order, self.gauge, self.frame)

    def _page(self) -> Page:
        worth = f"order {self.order}, gauge {self.gauge}: an estimate; .bound(t) and .uniform_bound() are proved"
        return Page(f"x(t) of {self.oscillator}", (worth, self.frame.in_words, *self.notes))

    def _formula(self) -> str:
        return self.oscillator._formula()

    def __repr__(self) -> str:
        return f"Motion({self.oscillator}, order {self.order}, gauge {self.gauge}, formal)"


@dataclass(frozen=True, repr=False)
class Reference(ProvedStates, Drawn):
    """The motion without expansion: exact solutions where there are any, else certified or high-precision steps."""

    oscillator: Oscillator
    static: Number | None = None
    notes: tuple[str, ...] = field(default=(), compare=False)
    frame: Frame = field(kw_only=True, compare=False)

    def __post_init__(self) -> None:
        require_oscillator(self.oscillator).law.require_dissipative("reference motion to rest")
        require_frame(self.frame)
        static = None if self.static is None else exact_number(self.static, "static")
        object.__setattr__(self, "static", static)

    @public
    def at(self, t: Number, *, digits: int = 30, max_seconds: Number = 60) -> MotionPoint:
        """x and v at one time ``t`` in s (of a law alone tau), to ``digits`` significant digits, 1 to 1000.

        ``certified`` and ``method`` say what they are worth.
        """
        require_one(t, "t", "sample(t)")
        point = reference_motion(
            self.oscillator,
            exact_number(t, "t"),
            exact_integer(digits, "digits", 1, 1000),
            static=self.static,
            max_seconds=seconds_left(),
        )
        return replace(point.with_notes((*self.notes, *float_notes(t=t))), frame=self.frame)

    @public
    def sample(self, t: ArrayLike, *, max_seconds: Number = 60) -> MotionSamples:
        """Arrays x and v of the shape of the times ``t`` (s, or tau), in doubles; NaN stays in its place."""
        times = times_of(t)
        missing = np.isnan(times)
        if np.any(times < 0):
            raise InputError("time", "a time is negative", "times >= 0, in s, of a law alone in 1/omega_0")
        # NaN is computed at the start, t = 0, and put back afterwards.
        x, v = self._values(np.where(missing, 0.0, times).ravel())
        x, v = (np.where(missing, np.nan, values.reshape(times.shape)) for values in (x, v))
        notes = (*self.notes, *([f"NaN times: {missing.sum()}"] if missing.any() else []))
        lost = int(missing.sum())
        return MotionSamples(times, x, v, None, None, None, None, lost, 0, None, notes, self.frame)

    @public
    def sol(self, t: ArrayLike, *, max_seconds: Number = 60) -> Array:
        """The dense solution: array [x, v] at the times ``t`` (s, or tau), as the ``sol`` of SciPy's ``solve_ivp``."""
        found = self.sample(t)
        return np.array([found.x, found.v])

    @public
    def events(self, until: Number, *, max_seconds: Number = 60) -> Events:
        """Turning points, zeros and the stop in 0 < t <= ``until`` (s, or tau)."""
        stop = None
        if self.is_dry:
            stop = float(coulomb_stop(self.oscillator, DIGITS, static=self.static).t)
        return events_of(self, until, stop)

    @property
    def is_dry(self) -> bool:
        """Whether dry friction acts alone, which has closed forms with sticking."""
        return alone(self.oscillator, 0) is not None

    def _heading(self) -> str:
        return f"{self._name}: reference"

    def _curve(self, axes: Any, **style: Any) -> None:
        """x; with ``velocity=True`` v on axes below."""
        velocity = style.pop("velocity", False)
        until, points = time_of_curve(self.oscillator, style.pop("until", None)), style.pop("points", REFERENCE_POINTS)
        found = self.sample(np.linspace(0.0, until, points))
        axes_of_motion(axes, self.frame)
        axes.plot(found.t, found.x, **{"label": "x", **style})
        if velocity:
            lower = below(axes)
            lower.plot(found.t, found.v, color="#15803d")
            lower.set_ylabel(self.frame.axis("v"))

    def _values(self, times: Array) -> tuple[Array, Array]:
        # The times of an array are binary fractions; their shortest decimals would be other times.
        exact = [ExactReal(Fraction(float(t))) for t in times]  # the doubles, exactly
        if self.is_dry:
            # A closed form on each half-swing, sticking included, so that each time stands by itself.
            points = [coulomb_motion(self.oscillator, t, DIGITS, static=self.static) for t in exact]
            return np.array([float(p.x) for p in points]), np.array([float(p.v) for p in points])
        if self.static is not None:
            raise InputError("static", "it belongs to dry friction alone", "the law alpha = 0")
        self._require_size(exact)
        states = reference_states(self.oscillator, exact, DIGITS, max_seconds=seconds_left())
        return np.array([float(x) for x in states.x]), np.array([float(v) for v in states.v])

    def _require_size(self, times: Sequence[ExactReal]) -> None:
        last = max(times, default=ExactReal(0))
        # The states are found along one orbit, so that the latest time decides the cost.
        seconds = estimated_seconds(self.oscillator, last, DIGITS)
        require_affordable(seconds, MAX_SECONDS, "time", f"the time {last}")

    def _page(self) -> Page:
        worth = "without expansion: .at(t) says its digits and whether they are certified; curves are doubles"
        return Page(f"x(t) of {self._name}", (worth, self.frame.in_words, *self.notes))

    def _formula(self) -> str:
        return self.oscillator._formula()

    @property
    def _name(self) -> str:
        """The oscillator, and the static friction that it has not of itself."""
        if self.static is None:
            return str(self.oscillator)
        force = "N m" if self.frame.x == "rad" else "N"
        return f"{self.oscillator}, static friction {self.static}" + (f" {force}" if self.frame else "")

    def __repr__(self) -> str:
        return f"Reference({self._name})"


@public
def motion(law: LawLike, *, order: int = 3, gauge: str = TURNING_POINT, max_seconds: Number = 60) -> Motion:
    """The asymptotic motion x(t), v(t) of any law, as a function of time: formal, with an error estimate at each time.

    x = A cos(psi) + sum_k delta^k x_k(psi), where A and psi solve the equations of ``expand`` through ``order``; order
    1 is Lancaster (2020), (13). ``bound`` and ``uniform_bound`` of what is returned are proved.

    Parameters
    ----------
    law
        a mapping exponent -> strength (epsilon, where m = k = x0 = 1), a ``Law``, or an ``Oscillator`` (b, in SI)
    order
        of the expansion, 1 to 12
    gauge
        what A and psi are: "turning-point", "averaging" or "no-first-harmonic"
    max_seconds
        the time the call may take, in s

    Returns
    -------
    Motion
        ``at`` a time, ``sample`` for arrays of times, ``events``, ``plot``; in s and m, of a law alone in 1/omega_0 and
        x0

    Raises
    ------
    InputError
        for an unknown gauge, an order out of range and anti-damping, before anything is computed

    Examples
    --------
    >>> found = motion(Oscillator({"3/2": "1/10"}, mass="3/2", stiffness=30, x0="1/5"))
    >>> found.at(7).x, found.bound(7)[:4]                                # the second is proved
    ('0.16385309', '3.2e')
    """
    given = given_of(law)
    return Motion(given.oscillator, order, gauge, given.oscillator.notes, frame=given.frame)


@public
def reference(law: LawLike, *, static: Number | None = None, max_seconds: Number = 60) -> Reference:
    """The reference motion x(t), v(t) of any law: without expansion, its digits certified wherever that can be done.

    Closed forms where there are any (dry friction with sticking, viscous damping), else enclosures of the return map
    and of Taylor steps in balls; ``certified`` and ``method`` of each value say which.

    Parameters
    ----------
    law
        a mapping exponent -> strength (epsilon, where m = k = x0 = 1), a ``Law``, or an ``Oscillator`` (b, in SI)
    static
        a static friction force in N, not below the sliding one; for dry friction alone
    max_seconds
        the time the call may take, in s

    Returns
    -------
    Reference
        ``at`` a time, ``sample`` for arrays of times, ``events``, ``plot``; in s and m, of a law alone in 1/omega_0 and
        x0

    Raises
    ------
    InputError
        for anti-damping, and a static force that is none or has no dry friction beside it

    Examples
    --------
    >>> point = reference({"3/2": "1/10"}).at(7, digits=20)
    >>> point.x, point.certified
    ('0.58239509739652164137', True)
    """
    given = given_of(law)
    return Reference(given.oscillator, static, given.oscillator.notes, frame=given.frame)


def time_of_curve(oscillator: Oscillator, until: Any) -> float:
    """Where a curve ends, in s: ``until``, or after ten periods; InputError for no stretch of time."""
    if until is None:
        return float(20 * np.pi / float(oscillator.omega_0().mid()))
    end = float(exact_number(until, "until").ball().mid())
    if not 0 < end < np.inf:
        raise InputError("until", f"{end:g} leaves nothing to draw", "a time > 0")
    return end


def axes_of_motion(axes: Any, frame: Frame) -> None:
    """The names of the axes of x against time, with their units."""
    axes.set(xlabel=frame.axis("t"), ylabel=frame.axis("x"))


def envelope_lines(axes: Any, t: Array, amplitude: Array) -> None:
    """+-A in the colour of the line drawn before, thin and dashed."""
    color, named = axes.lines[-1].get_color(), "±A" in axes.get_legend_handles_labels()[1]
    for sign, label in ((1, None if named else "±A"), (-1, None)):
        axes.plot(t, sign * amplitude, color=color, linewidth=1.0, linestyle="--", label=label)


def times_of(t: Any) -> Array:
    """An array of doubles; InputError for what is none."""
    times = real_array(t, "time")
    if np.any(np.isinf(times)):
        raise InputError("time", "a time is infinite", "times, in s, of a law alone in 1/omega_0")
    return times
