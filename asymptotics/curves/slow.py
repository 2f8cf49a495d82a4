"""The first-order envelope A(t) and phase phi(t) of any law: numbers, arrays, and the formula where one is known.  The
averaged equation (Krylov and Bogoliubov; Bogoliubov and Mitropolsky, 1961) is solved in balls; x(t) itself is not.

>>> slow = envelope(Oscillator({"3/2": "1/10"}, mass="3/2", stiffness=30, x0="1/5"))
>>> slow.amplitude(7, digits=12), slow.formula
('0.164991444234', ClosedForm(family='power', expression=(kappa_1*tau/2 + 1)**(-2)))
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

import numpy as np
import sympy
from numpy.typing import ArrayLike

from asymptotics.curves.envelope_order import acting_term, amplitude_and_phase, end_of_series, require_rest
from asymptotics.curves.large import SpringEnvelope
from asymptotics.curves.motions import POINTS, axes_of_motion, envelope_lines, time_of_curve, times_of
from asymptotics.curves.slow_numbers import SlowNumbers
from asymptotics.curves.slow_series import MAX_ORDER as MAX_SERIES_ORDER
from asymptotics.curves.slow_series import EnvelopeSeries, envelope_series
from asymptotics.curves.slowness import SlowPart, slow_part
from asymptotics.curves.started import start_angle
from asymptotics.envelopes.explicit import ClosedForm, explicit_amplitude
from asymptotics.envelopes.first_order import FirstOrderEnvelope, start_phase
from asymptotics.envelopes.hypergeometric import time_of_amplitude
from asymptotics.envelopes.long_time import extinction, long_time
from asymptotics.envelopes.slow_time import epsilon
from asymptotics.envelopes.symbolic import MEAN, AveragedLaw, averaged_law, tau
from asymptotics.errors import InputError
from asymptotics.frames import Frame, require_frame
from asymptotics.gauges import TURNING_POINT
from asymptotics.law import Law, LawLike, Oscillator
from asymptotics.law_given import given_of, require_oscillator
from asymptotics.motions.asymptotic import AsymptoticMotion
from asymptotics.motions.certify import time_of
from asymptotics.motions.result import MotionSamples
from asymptotics.numbers.bridge import to_sympy
from asymptotics.numbers.context import cached_property
from asymptotics.numbers.double_error import EPS
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.policy import Number, exact_integer, require_one
from asymptotics.present.drawn import Drawn
from asymptotics.present.shown import Page
from asymptotics.running.public import public
from asymptotics.terms import Term

MAX_DIGITS = 1000


@dataclass(frozen=True, repr=False)
class Envelope(SlowNumbers, Drawn):
    """A(t) and phi(t) of dA/dtau = -sum kappa_i A^alpha_i, in SI units for an oscillator; x = A cos(omega_0 t + phi).

    phi(0) is 0 from rest at x0 > 0, pi at x0 < 0, and the angle of x - i v/omega_0 for a start in motion.

    Digits are certified for the averaged law; how far that is from the motion is what higher orders tell.
    """

    oscillator: Oscillator
    averaging: str
    notes: tuple[str, ...] = field(default=(), compare=False)
    frame: Frame = field(kw_only=True, compare=False)

    def __post_init__(self) -> None:
        require_oscillator(self.oscillator).law.require_pure("the first-order envelope")
        require_frame(self.frame)
        # Made once for its refusals: an envelope that exists can be asked.
        FirstOrderEnvelope(self.oscillator, self.averaging)

    @public
    def amplitude(self, t: Number, *, digits: int = 30, max_seconds: Number = 60) -> str:
        """A at the time ``t`` (s, or tau) in m, to ``digits``, correctly rounded; "0" once the law is extinct."""
        require_one(t, "t", "amplitudes(t)")
        return self._law.amplitude(t, exact_integer(digits, "digits", 1, MAX_DIGITS))

    @public
    def phase(self, t: Number, *, digits: int = 30, max_seconds: Number = 60) -> str:
        """phi at the time ``t`` (s, or tau) in rad, to ``digits``, correctly rounded; turning-point gauge."""
        require_one(t, "t", "phases(t)")
        self._require_phase()
        return self._law.phase(t, exact_integer(digits, "digits", 1, MAX_DIGITS))

    @public
    def time(self, amplitude: Number, *, digits: int = 30, max_seconds: Number = 60) -> str:
        """The time in s at which A falls to ``amplitude`` (m, or x0), to ``digits``, correctly rounded."""
        return self._law.time(amplitude, exact_integer(digits, "digits", 1, MAX_DIGITS))

    @public
    def extinction_time(self, *, digits: int = 30, max_seconds: Number = 60) -> str | None:
        """When the averaged amplitude is 0 (some alpha < 1), to ``digits``: the end of that law, not of the motion."""
        return self._law.extinction_time(exact_integer(digits, "digits", 1, MAX_DIGITS))

    @public
    def slow(self, eta: Number = "1/10", *, max_seconds: Number = 60) -> SlowPart:
        """Where |dA/dt| <= ``eta`` omega_0 A: times in s of one law, amplitudes in m of a sum; doubles."""
        return slow_part(self._law, eta, self.frame)

    @public
    def series(self, order: int = 4, *, digits: int = 30, max_seconds: Number = 60) -> EnvelopeSeries:
        """tau, phi and delta beyond the first order, for one law with alpha != 1; dimensionless and formal.

        ``order``: the last one; ``digits``: of its coefficients, correctly rounded.

        >>> print(envelope({2: "1/10"}).series(4))
        delta = epsilon A^(alpha-1), alpha = 2: through order 4, turning-point gauge, formal
        p_1 = 4/(3*pi)
        G(delta) = 1/delta + 1/90 delta
        H(delta) = -1/6 delta - 31/6480 delta^3
        delta(sigma) = sigma + 1/90 sigma^3
        """
        N, D = exact_integer(order, "order", 1, MAX_SERIES_ORDER), exact_integer(digits, "digits", 1, MAX_DIGITS)
        # The squaring trick of Lelas replaces the mean of |sin|^(alpha+1) by a power of the mean square: no expansion
        # has it as its first term, so that there is no second.
        if self.averaging != MEAN:
            raise InputError("averaging", f"{self.averaging} has no higher orders", MEAN)
        return envelope_series(acting_term(self.oscillator).velocity, N, D)

    @public
    def at_order(self, t: Number, order: int = 4, *, digits: int = 30, max_seconds: Number = 60) -> tuple[str, str]:
        """A and phi at the time ``t`` (s, or tau) of an ``order``, explicit in the slow time, to ``digits``.

        One law from rest; formal, not certified.

        >>> envelope({2: "1/10"}).at_order(7, 3, digits=9)
        ('0.770941859', '-0.00899449816')
        """
        require_one(t, "t", "columns(t, order=N)")
        series = self.series(order, digits=digits)
        return amplitude_and_phase(series, self.oscillator, time_of(t), exact_integer(digits, "digits", 1, MAX_DIGITS))

    @public
    def kappas(self, *, digits: int = 30, max_seconds: Number = 60) -> tuple[str, ...]:
        """kappa_i of this averaging (``envelope``), to ``digits`` significant digits, correctly rounded."""
        return self._law.kappas(exact_integer(digits, "digits", 1, MAX_DIGITS))

    @property
    def formula(self) -> ClosedForm | None:
        """A/A(0) as a function of tau = omega_0 t and the kappas, or None where no elementary form is known."""
        try:
            return explicit_amplitude(self._symbols())
        except InputError:
            return None

    @property
    def time_formula(self) -> sympy.Expr | None:
        """tau = omega_0 t as a function of A (in units of A(0)) and the kappas, for one law and any two; None beyond.

        Elementary where that is short, else by 2F1 (Lancaster 2020, footnote 22, or its companion).

        >>> envelope({1: "1/10", 2: "1/20"}).time_formula
        log(1 + kappa_1/(A*kappa_2))/kappa_1 - log(kappa_1/kappa_2 + 1)/kappa_1
        """
        return time_of_amplitude(self._symbols())

    @property
    def phase_formula(self) -> sympy.Expr | None:
        """phi as a function of tau and epsilon for one law, turning-point gauge, with phi(0); None for a sum.

        >>> envelope({3: "1/10"}).phase_formula, envelope({3: "1/10"}).total_lag
        (-15*epsilon/64 + 15*epsilon/(64*(3*epsilon*tau/4 + 1)), 15*epsilon/64)
        """
        alone = self._alone()
        return None if alone is None or self.averaging != MEAN else start_angle(self.oscillator) + alone.phase

    @property
    def total_lag(self) -> sympy.Expr | None:
        """phi(0) - phi at infinity, the same in every gauge: finite for one law with alpha > 1, None otherwise."""
        alone = self._alone()
        # dphi/dtau is of the size delta^2, and the integral of delta^2 over all time is finite where delta falls like
        # 1/tau: for alpha > 1.
        return alone.total_lag if alone is not None and self.averaging == MEAN and alone.alpha > 1 else None

    @property
    def extinction_formula(self) -> sympy.Expr | None:
        """omega_0 times the extinction time as a formula; None without one.

        >>> envelope({0: "1/10", 1: "1/20"}).extinction_formula
        log(1 + kappa_2/kappa_1)/kappa_2
        """
        return extinction(self._symbols())

    @property
    def long_time_formula(self) -> sympy.Expr | None:
        """The leading A/A(0) for tau -> infinity, ruled by the smallest exponent; None below 1, or where unknown.

        >>> envelope({1: "1/10", 2: "1/20"}).long_time_formula
        exp(-kappa_1*tau)/(1 + kappa_2/kappa_1)
        """
        return long_time(self._symbols())

    def _require_phase(self) -> None:
        """InputError for the squaring trick, which is one for the amplitude."""
        if self.averaging != MEAN:
            raise InputError("averaging", f"{self.averaging} gives an amplitude alone, without a phase", MEAN)

    def _alone(self) -> AveragedLaw | None:
        """The one law in closed form."""
        alphas = list(self._symbols())
        return averaged_law(alphas[0], self.averaging) if len(alphas) == 1 else None

    def _symbols(self) -> dict[sympy.Expr, sympy.Expr]:
        """Exponents and the letters of their strengths, numbered as in ``kappas``; a strength 0 is left out."""
        terms = enumerate(self.oscillator.law.terms, start=1)
        return {to_sympy(t.velocity): sympy.Symbol(f"kappa_{i}", positive=True) for i, t in terms if not t.b.is_zero}

    @public
    def sample(self, t: ArrayLike, *, max_seconds: Number = 60) -> MotionSamples:
        """A, phi, x = A cos(omega_0 t + phi) and v = -omega_0 A sin(omega_0 t + phi) at ``t`` (s, or tau): doubles.

        A and phi are ``amplitudes`` and ``phases``; from the extinction on x = v = 0.
        """
        self._require_phase()
        times = times_of(t)
        A, phi = self.amplitudes(times), self.phases(times)
        gone, omega = A == 0, float(self.oscillator.omega_0().mid())
        psi = omega * times + phi
        x, v = (np.where(gone, 0.0, row) for row in (A * np.cos(psi), -omega * A * np.sin(psi)))
        end = self.extinction_time(digits=17)
        lost = int(np.isnan(times).sum()), int(gone.sum())
        return MotionSamples(times, x, v, A, phi, 1, TURNING_POINT, *lost, None if end is None else float(end),
                             self.notes, self.frame)  # fmt: skip

    @public
    def amplitudes(self, t: ArrayLike, *, max_seconds: Number = 60) -> Any:
        """A in m at an array of times ``t`` (s, or tau): doubles; NaN stays NaN, extinct is 0."""
        return self._law.amplitudes(np.asarray(times_of(t)))

    @public
    def phases(self, t: ArrayLike, *, max_seconds: Number = 60) -> Any:
        """phi in rad at an array of times ``t`` (s, or tau), as ``phase``: doubles; NaN where it is not known."""
        if self.averaging != MEAN:
            return np.full_like(times_of(t), np.nan)
        motion, rate = self._turning
        phi = motion.phases(np.asarray(times_of(t)) * rate) - motion.phases(np.zeros(1))[0] + self._first_phase
        # From the extinction on there is no amplitude, and a phase of nothing is NaN, not the last value.
        return np.where(self.amplitudes(t) > 0, phi, np.nan)

    def _phase_errors(self, t: ArrayLike) -> Any:
        """How far the doubles of ``phases`` are from the averaged law, rad: estimates; NaN where there is no phase."""
        if self.averaging != MEAN:
            return np.full_like(times_of(t), np.nan)
        motion, rate = self._turning
        # The angle of the start is subtracted, and that of this law added.
        return motion.double_errors(np.asarray(times_of(t)) * rate)["phase"] + 4 * EPS * abs(self._first_phase)

    @property
    def _first_phase(self) -> float:
        return float(start_phase(self.oscillator).mid())

    def _roundings(self, A: Any) -> float:
        """How often the doubles of ``amplitudes`` are rounded, down to the least of an array of them."""
        start = np.max(A, initial=0.0)
        return self._law.numeric().roundings(float(np.min(A[A > 0], initial=start)) / start if start else 1.0)

    @cached_property
    def _turning(self) -> tuple[AsymptoticMotion, float]:
        """The motion of order 2, which is p_1 and Omega_2: this phase, and the rate of its time."""
        start, rate = self._at_rest()
        return AsymptoticMotion.of(start, 2), rate

    def _at_rest(self) -> tuple[Oscillator, float]:
        """The averaged law from rest at A(0), and the rate of its time; strengths in doubles for a start in motion,
        which the motion of order 2 would correct, as the averaged law does not."""
        if self.oscillator.v0.is_zero:
            return self.oscillator, 1.0
        terms = self.oscillator.dimensionless.terms
        law = Law.from_terms([Term(Fraction(float(t.strength.ball().mid())), t.velocity, t.position) for t in terms])
        return Oscillator(law), float(self.oscillator.omega_0().mid())

    @public
    def columns(self, t: ArrayLike, *, order: int | None = None, max_seconds: Number = 60) -> tuple[Any, Any, Any]:
        """Arrays t, A, phi at the times ``t`` (s, or tau), in doubles, of an ``order`` (``series``), else the first.

        From the extinction on A is 0 and phi NaN.
        """
        times = times_of(t)
        if order is None:
            return times, self.amplitudes(times), self.phases(times)
        oscillator = self.oscillator
        require_rest(oscillator)
        epsilon_, omega, length = (
            float(x.mid()) for x in (acting_term(oscillator).strength.ball(), oscillator.omega_0(), oscillator.length())
        )
        series = self.series(order)
        forms = (sympy.lambdify([tau, epsilon], e, "numpy", cse=True) for e in series.explicit)
        # Beyond the extinction the formulas are taken at the start, and overwritten.
        gone = times * omega >= end_of_series(series, ExactReal(Fraction(epsilon_)))
        # 0 times the times gives a constant the shape of the array.
        A, phi = (f(np.where(gone, 0.0, times) * omega, epsilon_) + 0.0 * times for f in forms)
        return times, np.where(gone, 0.0, A * length), np.where(gone, np.nan, phi + self._first_phase)

    def _heading(self) -> str:
        return self._headed({})

    def _headed(self, style: Mapping[str, Any]) -> str:
        order = style.get("order")
        return f"{self.oscillator}: envelope, {'first order' if order is None else f'order {order}'}, {self.averaging}"

    def _curve(self, axes: Any, **style: Any) -> None:
        order, until = style.pop("order", None), time_of_curve(self.oscillator, style.pop("until", None))
        t, A, phi = self.columns(np.linspace(0.0, until, POINTS), order=order)
        # Without an amplitude any phase draws the same curve; with the squaring trick, which has none, it is that of
        # the start.
        psi = t * float(self.oscillator.omega_0().mid()) + np.where(np.isnan(phi), self._first_phase, phi)
        axes_of_motion(axes, self.frame)
        named = r"$A\,\cos(\omega_0 t + \varphi)$" + ("" if order is None else f", order {order}")
        axes.plot(t, A * np.cos(psi), **{"label": named, **style})
        envelope_lines(axes, t, A)

    # Kept for its tables of doubles; the balls in it are made anew at each precision.
    @cached_property
    def _law(self) -> FirstOrderEnvelope:
        return FirstOrderEnvelope(self.oscillator, self.averaging)

    def to_dict(self) -> dict[str, object]:
        """JSON-ready: the oscillator, the formula where one is known, the rates, the extinction."""
        formula = None if self.formula is None else str(self.formula.expression)
        time = None if self.time_formula is None else str(self.time_formula)
        ends = {name: None if found is None else str(found) for name, found in self._ends().items()}
        numbers = {"kappas": list(self.kappas()), "extinction": self.extinction_time()}
        notes = list(self.notes)
        return {"oscillator": self.oscillator.to_dict(), "averaging": self.averaging, "formula": formula,
                "time_formula": time, **ends, **numbers, "notes": notes}  # fmt: skip

    def _ends(self) -> dict[str, sympy.Expr | None]:
        return {"phase_formula": self.phase_formula, "total_lag": self.total_lag,
                "extinction_formula": self.extinction_formula, "long_time_formula": self.long_time_formula}  # fmt: skip

    def __str__(self) -> str:
        shown = "no elementary form" if self.formula is None else f"A/A(0) = {self.formula.expression}"
        kappas = ", ".join(f"kappa_{i} = {k}" for i, k in enumerate(self.kappas(digits=10), start=1))
        return f"{shown}\ntau = omega_0 t, {kappas}"

    def __repr__(self) -> str:
        return f"Envelope({self.oscillator}, averaging {self.averaging})"

    def _page(self) -> Page:
        title, *rest = str(self).splitlines()
        rows = tuple((f"kappa_{i}", k) for i, k in enumerate(self.kappas(digits=12), start=1))
        end = self.extinction_time(digits=12)
        rows += () if end is None else (("extinct from", self.frame.with_unit("t", end)),)
        worth = "certified digits of the averaged law (first order); how far it is from the motion, motion() tells"
        return Page(title, (*rest, worth, f"{self.oscillator}", *self.notes), ("", "value"), rows)

    def _letters(self) -> dict[str, str]:
        own = {} if self.averaging == MEAN else {r"\kappa": "2^(-(alpha+1)/2) epsilon, the rate of the squaring trick"}
        return {"A": "slow amplitude; A(0) at the start", **own}

    def _formula(self) -> str:
        form = self.formula
        if form is None:
            return r"\frac{dA}{d\tau} = -\sum_{i} \kappa_{i} A^{\alpha_{i}}"
        return rf"A/A(0) = {sympy.latex(form.expression)}"


@public
def envelope(law: LawLike, *, averaging: str = MEAN, max_seconds: Number = 60) -> Envelope | SpringEnvelope:
    """The envelope A(t) and phase phi(t) of first order: of dA/dtau = -sum_i kappa_i A^alpha_i, solved in balls.

    kappa_i = M_(alpha_i+1) epsilon_i (Lancaster 2020, below (8)). Beside a spring c x^3, or for a pendulum, it is exact
    in the spring for any amplitude inside the well. ``series`` and ``at_order`` have the higher orders of one law.

    Parameters
    ----------
    law
        a mapping exponent -> strength (epsilon, where m = k = x0 = 1), a ``Law``, or an ``Oscillator`` (b, in SI)
    averaging
        "mean" (Lancaster 2020), or "squaring", with 2^(-(alpha+1)/2) in the place of M_(alpha+1) (Lelas 2024)
    max_seconds
        the time the call may take, in s

    Returns
    -------
    Envelope or SpringEnvelope
        ``amplitude`` and ``phase`` at a time, ``time`` of an amplitude, ``sample`` for arrays, ``formula`` where one is
        known

    Raises
    ------
    InputError
        for anti-damping, other springs, losses that depend on the place (but beside x^3), and an unknown averaging

    Examples
    --------
    >>> envelope(Oscillator({2: "1/20"}, spring="pendulum", x0=3)).period(3, digits=12)
    '16.1555393724'
    """
    given = given_of(law)
    oscillator = given.oscillator
    # A spring makes the phase, the period and the loss of a cycle depend on the amplitude, at any strength: another
    # averaged law, in another coordinate (``envelopes.large``).
    if any(not t.b.is_zero for t in oscillator.law.springs):
        if averaging != MEAN:
            raise InputError("averaging", f"{averaging!r:.40} knows the linear spring", MEAN)
        return SpringEnvelope.of(law)
    return Envelope(oscillator, averaging, oscillator.notes, frame=given.frame)
