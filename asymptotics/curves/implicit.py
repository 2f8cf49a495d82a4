"""The multiple-scale solution of several laws, or of losses beside springs: tau and phi as functions of the amplitude.
The amplitude equation dA/dtau = -A p(A) is autonomous and of one variable, so both are quadratures by separation.

    tau(A) = int_A^1 du/(u p(u)),      phi(A) = int_A^1 Omega(u)/(u p(u)) du,

p and Omega through order N of the hierarchy.  A(tau) has no explicit form; the inverse is numeric.  At first order two
losses have tau(A) closed (logarithms, arctangents, or 2F1: ``envelopes.hypergeometric``).

>>> from asymptotics.frames import BARE
>>> two = implicit_solution(Oscillator({1: "1/10", 2: "1/20"}), 2, BARE)
>>> two.time_of_amplitude, two.formulas.time_of_amplitude
(Integral(60/(u*(4*u/pi + 3)), (u, A, 1)), Integral(6/(u*(3*epsilon_0 + 8*epsilon_1*u/pi)), (u, A, 1)))
>>> implicit_solution(Oscillator({1: "1/10", 2: "1/20"}), 1, BARE).formulas.time_of_amplitude
2*log(1 + 3*pi*epsilon_0/(8*A*epsilon_1))/epsilon_0 - 2*log(3*pi*epsilon_0/(8*epsilon_1) + 1)/epsilon_0
>>> two.at(7, digits=8).x
'0.50456439'
"""

from dataclasses import dataclass, field, replace
from typing import Any

import sympy
from sympy import Expr, Integer, Integral, Symbol, latex

from asymptotics.bounds.reach import Theorem, uniform_theorem
from asymptotics.curves.evaluated import strength_of_term
from asymptotics.curves.motions import times_of
from asymptotics.curves.proved_curve import ProvedCurve
from asymptotics.curves.shown_solution import SolutionPoint, document, proved_lines
from asymptotics.curves.started import start_in_motion
from asymptotics.envelopes.hypergeometric import time_of_amplitude
from asymptotics.envelopes.symbolic import amplitude_symbol
from asymptotics.errors import InputError, require_flag
from asymptotics.expansions.moments.symbolic import moment
from asymptotics.expansions.multiple_scales.hierarchy import multiple_scales, ordered
from asymptotics.expansions.multiple_scales.orders import a
from asymptotics.expansions.multiple_scales.symbolic import MultipleScales
from asymptotics.frames import Frame
from asymptotics.gauges import TURNING_POINT
from asymptotics.law import Oscillator, of_unit_start
from asymptotics.law_given import require_oscillator
from asymptotics.motions.asymptotic import AsymptoticMotion
from asymptotics.motions.point import MotionPoint
from asymptotics.numbers.bridge import to_sympy
from asymptotics.numbers.context import cached_property
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.policy import Number, require_one
from asymptotics.present.shown import Page
from asymptotics.running.public import public

u, a_0 = Symbol("u", positive=True), Symbol("a_0", positive=True)


@dataclass(frozen=True, repr=False)
class ImplicitSolution(ProvedCurve):
    """tau(A) and phi(A) with A in units of the start, through ``order``, and the motion by the numeric inverse."""

    order: int
    scales: MultipleScales = field(hash=False)
    oscillator: Oscillator
    notes: tuple[str, ...] = field(default=(), compare=False)
    start: tuple[Expr, Expr] | None = None
    frame: Frame = field(kw_only=True, compare=False)
    symbolic: bool = False

    @cached_property
    def formulas(self) -> "ImplicitSolution":
        """The same with the letters of the strengths, and a_0 of a start in motion."""
        return self if self.symbolic else replace(self, symbolic=True)

    def _put(self, found: Expr) -> Expr:
        """The expression with the strengths, and the amplitude at the start, in the place of their letters."""
        if self.symbolic:
            return found
        values = dict(zip(self.scales.symbols, (strength_of_term(t, 40) for t in self._terms)))
        # What a_0 is has the strengths in it.
        return (found if self.start is None else found.subs(a_0, self.start[0])).subs(values)

    @property
    def _terms(self) -> tuple[Any, ...]:
        return tuple(ordered(self.oscillator.dimensionless.terms, self.scales))

    @property
    def loss(self) -> Expr:
        """u p(u) = -dA/dtau at the amplitude u."""
        return self._put(-self.scales.amplitude_rate.subs(a, u))

    @property
    def detuning(self) -> Expr:
        """Omega(u) = dphi/dtau at the amplitude u."""
        return self._put(self.scales.phase_rate.subs(a, u) - 1)

    @property
    def time_of_amplitude(self) -> Expr:
        """tau(A), closed at first order for two losses, else a named integral."""
        terms = self.oscillator.law.terms
        # Beyond the first order p(u) is a sum of more than two powers of u, and beside |x|^m or from A(0) = a_0 the
        # forms of ``envelopes.hypergeometric`` (two powers of the velocity, A(0) = 1) do not apply.
        if self.start is None and self.order == 1 and len(terms) == 2 and all(t.is_power_of_velocity for t in terms):
            # epsilon_i is numbered as in the hierarchy, whose order of the terms need not be that of the law.
            kappas = zip(ordered(terms, self.scales), self.scales.symbols)
            found = time_of_amplitude({to_sympy(t.velocity): moment(to_sympy(t.velocity) + 1) * e for t, e in kappas})
            if found is not None:
                return self._put(found)
        # Common factors in front leave an integrand that can be read; they do not change its value.
        return Integral(1 / sympy.factor_terms(self.loss), (u, amplitude_symbol, self._put(self.first)))

    @property
    def phase_of_amplitude(self) -> Expr:
        """phi(A), less phi(0) for a start in motion or at x0 < 0."""
        limits = u, amplitude_symbol, self._put(self.first)
        return Integral(self.detuning / sympy.factor_terms(self.loss), limits)

    @property
    def first(self) -> Expr:
        """The amplitude at tau = 0: 1, or the letter a_0 of a start in motion, whose value is ``start``."""
        return Integer(1) if self.start is None else a_0

    @cached_property
    def _motion(self) -> AsymptoticMotion:
        return AsymptoticMotion.of(_dimensionless(self.oscillator), self.order, TURNING_POINT)

    @public
    def at(self, time: Number, *, digits: int = 30, max_seconds: Number = 60) -> MotionPoint:
        """A, phi and x at one tau >= 0, in units of |x_0|, by the numeric inverse; not certified."""
        require_one(time, "time", "sample(times)")
        return self._motion.at(time, digits)

    @public
    def at_time(self, oscillator: Oscillator, time: Number, digits: int, *, max_seconds: Number = 60) -> SolutionPoint:
        """A, phi and x at a time t of the oscillator, in its units."""
        require_oscillator(oscillator)
        found = AsymptoticMotion.of(oscillator, self.order, TURNING_POINT).at(time, digits)
        return SolutionPoint(found.amplitude or "0", found.phase, found.x)

    @public
    def sample(self, times: Any, *, max_seconds: Number = 60) -> tuple[Any, Any, Any]:
        """(A, phi, x) at an array of tau, in doubles."""
        found = self._motion.sample(times_of(times))
        return found.amplitude, found.phase, found.x

    def _double_errors(self, times: Any) -> tuple[Any, Any, Any]:
        """How far the doubles of ``sample`` are from the truncated equations: estimates."""
        found = self._motion.double_errors(times)
        return found["amplitude"], found["phase"], found["x"]

    # The bound of the truncated equations holds here as it is: tau(A) and phi(A) solve them exactly, by quadrature.
    def _theorem(self) -> Theorem:
        return uniform_theorem(_dimensionless(self.oscillator), self.order)

    @property
    def strengths(self) -> dict[str, str]:
        """The values of the symbols."""
        return {str(s): str(t.strength) for s, t in zip(self.scales.symbols, self._terms)}

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready; ``amplitude``, ``phase`` and ``x`` are null: there is no explicit form."""
        head = {"order": self.order, "gauge": TURNING_POINT, "amplitude": None, "phase": None, "x": None}
        made = self.formulas
        forms = {"time_of_amplitude": str(made.time_of_amplitude), "phase_of_amplitude": str(made.phase_of_amplitude)}
        forms |= {"phi_0": "pi"} if self.mirrored else {}
        forms |= {} if self.start is None else dict(zip(("a_0", "phi_0"), map(str, self.start)))
        return {**head, **forms, "strengths": self.strengths, **made.validity, "certified": False}

    def latex(self, *, standalone: bool = False) -> str:
        """The formulas as LaTeX: a fragment, or a document that compiles with pdflatex."""
        require_flag(standalone, "standalone")
        first = self._first_phase(r"\varphi_{0}", r"\pi")
        rows = [
            rf"\tau(A) = {latex(self.formulas.time_of_amplitude)}",
            rf"\varphi(A) = {latex(self.formulas.phase_of_amplitude)}{first}",
        ]
        if self.start is not None:
            rows += [f"a_{{0}} = {latex(self.start[0])}", rf"\varphi_{{0}} = {latex(self.start[1])}"]
        body = "\n".join(rf"\[ {row} \]" for row in rows)
        return document(body) if standalone else body

    def _first_phase(self, letter: str, half_turn: str) -> str:
        """What is added to the integral: phi(0), where it is not 0."""
        if self.start is not None:
            return f" + {letter}"
        return f" + {half_turn}" if self.mirrored else ""

    def _page(self) -> Page:
        title, *rest = str(self).splitlines()
        return Page(title, tuple(rest))

    def _formula(self) -> str:
        made, first = self.formulas, self._first_phase(r"\varphi_{0}", r"\pi")
        return rf"\tau(A) = {latex(made.time_of_amplitude)},\quad \varphi(A) = {latex(made.phase_of_amplitude)}{first}"

    def __str__(self) -> str:
        forces = " + ".join(f"{s} {shape}" for s, shape in zip(self.scales.symbols, self.scales.shapes))
        place = f"x(0) = {-1 if self.mirrored else 1}, x'(0) = 0" if self.start is None else "x(0)**2 + x'(0)**2 = 1"
        lines = [f"x'' + x + {forces} = 0, {place}: through order {self.order}, turning-point gauge"]
        phi_0 = self._first_phase("phi_0", "pi")
        lines += [f"tau(A) = {self.formulas.time_of_amplitude}", f"phi(A) = {self.formulas.phase_of_amplitude}{phi_0}"]
        lines += [] if self.start is None else [f"a_0 = {self.start[0]}", f"phi_0 = {self.start[1]}"]
        lines += [f"{name} = {value}" for name, value in self.strengths.items()]
        unit = "|x(0)|, 0 < A <= 1" if self.mirrored else "x(0), 0 < A <= 1"
        unit = unit if self.start is None else "the radius of the start, 0 < A <= a_0"
        lines += [f"A in units of {unit}; A(tau) has no explicit form", "x: numerically, by the inverse"]
        lines.append(f"error   O(epsilon**{self.order}) at fixed epsilon*tau; not certified")
        return "\n".join([*lines, *proved_lines(self), *self.notes])

    def __repr__(self) -> str:
        return f"ImplicitSolution({', '.join(self.scales.shapes)}, order {self.order})"


def implicit_solution(oscillator: Oscillator, order: int, frame: Frame) -> ImplicitSolution:
    """The solution of a sum through ``order``, from rest or in motion; InputError without losses."""
    if not oscillator.law.losses:
        raise InputError("law", "nothing is lost: A is constant", "a loss; multiple_scales has the phase of springs")
    scales = multiple_scales(oscillator, order=order, gauge=TURNING_POINT)
    start = None if oscillator.v0.is_zero else start_in_motion(oscillator, scales)
    return ImplicitSolution(order, scales, oscillator, scales.notes, start, frame=frame)


def _dimensionless(given: Oscillator) -> Oscillator:
    """The same motion in units of 1/omega_0 and of the radius of the start."""
    # Strengths without units belong to a start at distance 1, from rest or in motion: only the place on that circle is
    # left to say.
    law = given.dimensionless
    if given.v0.is_zero:
        return of_unit_start(law, x0=-1 if given.x0 < 0 else 1)
    numbers = (given.mass, given.stiffness, given.x0, given.v0)
    # x0/radius and its speed are square roots of rationals if all four numbers are rational; a root under the root has
    # no place in ExactReal, and a rounded start would not be the one whose bound is asked for.
    if any(n.offset or (n.coefficient and not n.is_rational) for n in numbers):
        raise InputError("v0", "the start divided by its radius is not exact", "rational mass, stiffness, x0 and v0")
    m, k, x0, v0 = (n.rational for n in numbers)
    radius = x0**2 + m * v0**2 / k
    # ExactReal(+-1, q) is +-sqrt(q), exactly.
    place, speed = ((1 if n > 0 else -1, square / radius) for n, square in ((x0, x0**2), (v0, m * v0**2 / k)))
    return of_unit_start(law, x0=ExactReal(*place) if x0 else 0, v0=ExactReal(*speed))
