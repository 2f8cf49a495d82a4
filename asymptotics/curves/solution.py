"""The multiple-scale solution of one law as functions of time: A(tau), phi(tau), x(tau) through order N.  Two
scales suffice: the fast phase psi, and through delta the slow time epsilon tau in which A and phi are explicit.

    x = A [cos psi + sum_(0<k<N) delta^k x_k(psi)],   psi = tau + phi,   delta = epsilon A^(alpha-1),

A and phi explicit in the slow time (``envelopes.slow_time``), x_k the waveforms of the hierarchy on 0 < psi < pi, and
X(psi + pi) = -X(psi).  Start at rest: x(0) = 1.  At fixed slow time epsilon tau the error is O(epsilon^N);
``proved`` tells what is proved of it for all times, ``bound`` for one.

>>> from asymptotics.curves.solve import solution
>>> air = solution({2: "1/10"}, order=3)
>>> print(air)
x'' + x + epsilon x'|x'| = 0, x(0) = 1, x'(0) = 0: through order 3, turning-point gauge
D       = 1/(4*epsilon*tau/(3*pi) + 1)
A_0     = 1/(4*epsilon*tau/(3*pi) + 1)
A       = A_0*(epsilon**2*(D**2/90 - D/90) + 1)
phi     = epsilon*(pi*D/8 - pi/8)
x       = A*(cos(psi) + delta*x_1(psi) + delta**2*x_2(psi)), psi = tau + phi, delta = A*epsilon, on 0 < psi < pi
x_1     = 4*psi*cos(psi)/(3*pi) + cos(psi)**2/3 - 2*cos(psi)/3 + 1/3
x_2     = 16*psi**2*cos(psi)/(9*pi**2) + 8*psi*cos(psi)**2/(9*pi) - 16*psi*cos(psi)/(9*pi) + 8*psi/(9*pi) + ...
X(psi + pi) = -X(psi)
epsilon = 1/10
valid   for every tau >= 0 (alpha >= 1)
error   O(epsilon**3) at fixed epsilon*tau; not certified
proved  |x - x_3| <= 0.000043 for every tau >= 0 (x_0 = 1, before rounding)
>>> point = air.at(7, digits=10)
>>> point.x, air.bound(7)                                   # the second is proved
('0.6004602446', '0.000015')
>>> A, phi, x = air.functions()                             # NumPy: the strength is an argument where it is not given
>>> import numpy as np
>>> x(np.array([0.0, 7.0]), 0.1).round(10).tolist()
[1.0, 0.6004602446]
"""

from dataclasses import dataclass, field, replace
from typing import Any

import mpmath
import sympy
from sympy import Add, Eq, Expr, Function, Integer, Piecewise, Pow, Symbol, cos, exp, floor, pi

from asymptotics.bounds.explicit import explicit_bound
from asymptotics.bounds.motion import proved_bound
from asymptotics.bounds.reach import Theorem
from asymptotics.curves.definitions import definitions_of
from asymptotics.curves.evaluated import chi, delta, digits_of_turns, functions, numbers, strength_of, tau
from asymptotics.curves.motions import times_of
from asymptotics.curves.proved_curve import ProvedCurve
from asymptotics.curves.shown_solution import (
    SolutionPoint,
    document,
    latex_lines,
    rounded_point,
    text_of,
    text_of_x,
    x_by_name,
)
from asymptotics.curves.slow_formulas import slow_formulas
from asymptotics.curves.started import DIGITS, start_in_motion
from asymptotics.curves.waves import Waveforms, waveforms
from asymptotics.envelopes.slow_time import (
    D,
    epsilon,
    leading_amplitude,
)
from asymptotics.errors import InputError, require_choice, require_flag
from asymptotics.expansions.multiple_scales.orders import a, psi
from asymptotics.expansions.multiple_scales.symbolic import MultipleScales
from asymptotics.expansions.multiple_scales.turning import TurningHierarchy
from asymptotics.frames import Frame
from asymptotics.gauges import TURNING_POINT
from asymptotics.law import Oscillator, of_unit_start
from asymptotics.law_given import require_oscillator
from asymptotics.motions.certify import time_of
from asymptotics.numbers.bridge import expression, to_sympy
from asymptotics.numbers.context import cached_property, ctx
from asymptotics.numbers.decimal_context import workdps
from asymptotics.numbers.decimals import bits_for
from asymptotics.numbers.policy import Number, exact_double, exact_integer, require_one
from asymptotics.present.shown import Page
from asymptotics.running.budget import seconds_left
from asymptotics.running.public import public

# Limits of what is offered: 12 is the order through which open hierarchies go, 300 digits what ``motion`` serves too.
MAX_ORDER, MAX_DIGITS = 12, 300
# With the turns of a phase, of which ``evaluated`` takes so many decimals at most.
MAX_REFINED = 3000
UNITS = ("epsilon", "kappa", "SI")
A_0, A, a_0, epsilon_0 = sympy.symbols("A_0 A a_0 epsilon_0", positive=True)
phi_0 = Symbol("phi_0", real=True)
kappa, m, k, b, x_0, t = sympy.symbols("kappa m k b x_0 t", positive=True)
Array = Any
# Bits beyond those of the decimals in which time and length are handed on: their balls must be narrower still.
_GUARD = 28


@dataclass(frozen=True, repr=False)
class Solution(ProvedCurve):
    """A(tau), phi(tau), x(tau) of one law through ``order``; ``waves``: x_1, ..., x_(N-1), None if open.

    ``oscillator`` is None where no strength was given; ``relative`` and ``slow_phase`` are A/A_0 and phi in D.
    ``start``: A(0) and phi(0) in epsilon for a start in motion, in units of its radius sqrt(x0^2 + m v0^2/k); None at
    rest.  A motion begun with A(0) is that from rest with the strength epsilon A(0)^(alpha-1), later by phi(0).
    """

    alpha: Expr
    order: int
    p_1: Expr
    relative: Expr
    slow_phase: Expr
    waves: tuple[Expr | None, ...]
    scales: MultipleScales = field(hash=False)
    oscillator: Oscillator | None
    notes: tuple[str, ...] = field(default=(), compare=False)
    start: tuple[Expr, Expr] | None = None
    frame: Frame = field(kw_only=True, compare=False)
    symbolic: bool = False

    @cached_property
    def formulas(self) -> "Solution":
        """The same with letters where a strength was given: epsilon, and those of a start in motion."""
        return self if self.symbolic else replace(self, symbolic=True)

    def _put(self, found: Expr) -> Expr:
        """The expression with the strength put in, unless it shall stay a letter or none was given."""
        if self.symbolic or self.oscillator is None:
            return found
        # Letters of the start first, the last of which is a formula in another; then the strength in all of it.
        for letter, value in reversed(self.letters.items()):
            found = found.subs(letter, value)
        return found.subs(epsilon, self.strength)

    @cached_property
    def leading(self) -> tuple[Expr, Expr]:
        """(A_0, D) in tau and epsilon."""
        if self.alpha == 1:
            return exp(-self.p_1 * epsilon * tau), Integer(1)
        return leading_amplitude(self.alpha, self.p_1, epsilon, tau)

    @cached_property
    def amplitude(self) -> Expr:
        """A in tau, and in epsilon and ``letters`` where no strength was given or it is ``symbolic``; 1 from rest."""
        # D, not tau, is the variable of the series: A_0 and D hold all of the dependence on time.
        A_0, slow = self.leading
        found = A_0 * self.relative.subs(D, slow)
        return self._put(found if self.start is None else a_0 * self.with_start_strength(found))

    @cached_property
    def phase(self) -> Expr:
        """phi in the same letters, from ``first_phase`` on."""
        found = self.slow_phase.subs(D, self.leading[1])
        return self._put(self.first_phase + self.with_start_strength(found))

    @property
    def first_phase(self) -> Expr:
        """phi(0): the letter of a start in motion, at rest 0, or pi where x0 < 0."""
        if self.start is not None:
            return phi_0
        return pi if self.mirrored else Integer(0)

    @property
    def letters(self) -> dict[Expr, Expr]:
        """What a_0 = A(0), phi_0 = phi(0) and the local strength epsilon_0 at a start in motion are, in epsilon."""
        if self.start is None:
            return {}
        return {a_0: self.start[0], phi_0: self.start[1], epsilon_0: epsilon * a_0 ** (self.alpha - 1)}

    def with_start_strength(self, found: Expr) -> Expr:
        """The same with epsilon_0, the local strength at the start, in the place of epsilon."""
        return expression(found, "found").subs({} if self.start is None else {epsilon: epsilon_0})

    @property
    def local_strength(self) -> Expr:
        """delta = epsilon A^(alpha-1) in A."""
        return epsilon * Pow(A, self.alpha - 1)

    @property
    def has_formulas(self) -> bool:
        """Whether ``sample`` has x by formulas, and not by a table of open waveforms."""
        return isinstance(self.scales.kernel, TurningHierarchy) or self.order == 1

    @property
    def is_closed(self) -> bool:
        """Whether every waveform that x needs has a closed form."""
        return all(w is not None for w in self.waves)

    @cached_property
    def x(self) -> Expr:
        """x in the letters of ``amplitude``, for all tau; an open integral stands as x_n(psi), see ``definitions``.

        >>> from asymptotics.curves.solve import solution
        >>> solution({2: "1/10"}, order=1).x, solution({2: "1/10"}, order=1, symbolic=True).x
        (cos(tau)/(2*tau/(15*pi) + 1), cos(tau)/(4*epsilon*tau/(3*pi) + 1))
        """
        # X(psi + pi) = -X(psi): the waveforms are known on one half-swing, and (-1)^swings continues them.
        turned = tau + self.phase
        swings = floor(turned / pi)
        local = self._put(self.local_strength)
        shape = self.shape(chi).subs({delta: local}).subs({A: self.amplitude, chi: turned - pi * swings})
        return (-1) ** swings * self.amplitude * shape

    def shape(self, phase: Expr) -> Expr:
        """cos psi + sum delta^k x_k(psi) with ``delta``, at a phase in (0, pi)."""
        phase = expression(phase, "phase")
        # An open waveform stands as an undefined function of its name, which ``definitions`` explains.
        waves = ((n, Function(f"x_{n}")(psi) if w is None else w) for n, w in enumerate(self.waves, start=1))
        return cos(phase) + Add(*[delta**n * w.subs(psi, phase) for n, w in waves])

    @property
    def valid_until(self) -> Expr:
        """tau until which delta < 1 can be hoped for: infinity for alpha >= 1, else where A_0 makes delta = 1."""
        if self.alpha.is_number and bool(self.alpha >= 1):
            return sympy.oo
        # Below 1 delta = epsilon D grows as A falls: epsilon D = 1 solved for tau.  It is no bound, the letter of the
        # series becomes 1 there.
        end = self._put(self.with_start_strength((1 - epsilon) / ((1 - self.alpha) * self.p_1 * epsilon)))
        return end if self.alpha.is_number else Piecewise((end, self.alpha < 1), (sympy.oo, True))

    @public
    def in_units(self, units: str = "epsilon", *, max_seconds: Number = 60) -> tuple[Expr, Expr]:
        """(A, phi) in tau and epsilon, in tau and Lancaster's kappa = M_(alpha+1) epsilon, or in t, m, k, b, x_0.

        Letters all of them, also where a strength was given; x_0 > 0 is |x(0)|, of a start in motion its radius.
        """
        require_choice(units, "units", UNITS)
        amplitude, phase = self.formulas.amplitude, self.formulas.phase
        if units == "epsilon":
            return amplitude, phase
        if units == "kappa":
            change: dict[Expr, Expr] = {epsilon: kappa / self.p_1}
            return amplitude.subs(change), phase.subs(change)
        # Both at once, so that what stands for one letter is not searched for the other.
        change = {epsilon: self.strength_in_SI, tau: sympy.sqrt(k / m) * t}
        amplitude, phase = (e.subs(change, simultaneous=True) for e in (amplitude, phase))
        return x_0 * amplitude, phase

    @property
    def strength_in_SI(self) -> Expr:  # noqa: N802 (the units)
        """epsilon in m, k, b, x_0."""
        return b * sympy.sqrt(k / m) ** self.alpha * x_0 ** (self.alpha - 1) / k

    @property
    def strength(self) -> Expr:
        """The number epsilon, exact or to 40 digits; InputError where none was given."""
        return strength_of(self._given(), 40)

    @public
    def functions(self, strength: Any = None, *, max_seconds: Number = 60) -> tuple[Any, Any, Any]:
        """(A, phi, x) as NumPy functions of tau and epsilon, or of tau alone with a ``strength``; x(0) = 1."""
        return functions(self, None if strength is None else exact_double(strength, "strength"))

    @public
    def sample(self, times: Any, *, max_seconds: Number = 60) -> tuple[Array, Array, Array]:
        """(A, phi, x) at an array of tau, in doubles and units of |x_0|; InputError without a strength."""
        A, phi, x = functions(self, float(self.strength))
        given = times_of(times)
        return A(given), phi(given), x(given)

    @public
    def at(self, time: Number, *, digits: Any = 30, max_seconds: Number = 60) -> SolutionPoint:
        """A, phi and x at one tau >= 0 to ``digits`` digits, by mpmath; not certified.

        InputError without a strength.
        """
        require_one(time, "time", "sample(times)")
        number, D = to_sympy(time_of(time)), exact_integer(digits, "digits", 1, MAX_DIGITS)
        return rounded_point(*numbers(self, number, D), D)

    @public
    def refined(self, digits: int, *, max_seconds: Number = 60) -> "Solution":
        """The same with rates and start to that many digits where they do not all close: closed ones of high order are
        long products of gamma functions, slow to evaluate."""
        digits = exact_integer(digits, "digits", 1, MAX_REFINED)
        if self.is_exact:
            return self
        # Fifteen digits more than are shown, as ``evaluated.numbers`` works with, and never fewer than the form at hand
        # has.
        relative, phase = slow_formulas(self.scales, self.alpha, self.order, max(digits + 15, DIGITS + 1))
        start = self.start
        if start is not None:
            start = start_in_motion(self._given(), self.scales, digits=digits + 15)
        return replace(self, relative=relative, slow_phase=phase, start=start)

    @property
    def is_exact(self) -> bool:
        """Whether A and phi hold no number that is rounded."""
        return not any(e.has(sympy.Float) for e in (self.relative, self.slow_phase, *(self.start or ())))

    @property
    def waveforms(self) -> Waveforms:
        """x_1, ..., x_(N-1) as numbers: certified at a phase, arrays, integrals by name; InputError for a symbol."""
        if not self.alpha.is_number:
            raise InputError("alpha", "a symbolic exponent has no numbers", "an exponent that is a number")
        return waveforms(self.alpha, order=max(1, self.order - 1))

    @public
    def at_time(self, oscillator: Oscillator, time: Number, digits: int, *, max_seconds: Number = 60) -> SolutionPoint:
        """The same at a time t of an oscillator with this law, in its units: A and x in m, phi in rad."""
        require_oscillator(oscillator)
        digits = exact_integer(digits, "digits", 1, MAX_DIGITS)
        # The oscillator's numbers are balls of FLINT and the formulas mpmath's: both precisions are set for what is
        # shared.
        with ctx.workprec(64):
            rough = time_of(time).ball() * oscillator.omega_0()
            # Thirty decimals more than are shown, and those of the turns of the phase.
            known = digits + 30 + digits_of_turns(sympy.Float(rough.str(15, radius=False), 15))
        with ctx.workprec(bits_for(known, _GUARD)), workdps(known):
            scaled, length = time_of(time).ball() * oscillator.omega_0(), oscillator.length()
            size, lag, x = numbers(self, sympy.Float(scaled.str(known, radius=False), known), digits)
            unit = mpmath.mpf(length.str(known, radius=False))
            # Made for another start at rest (the formulas for a strength alone, say), it is on the side of that one.
            if self.start is None and self.mirrored != bool(oscillator.x0 < 0):
                lag, x = lag + (mpmath.pi if oscillator.x0 < 0 else -mpmath.pi), -x
            return rounded_point(size * unit, lag, x * unit, digits)

    @public
    def bound(self, time: Number, *, digits: Any = 30, max_seconds: Number = 60) -> str:
        """A proved bound, rounded up, of |x(tau) - x_N| for the decimal x_N that ``at`` gives, in units of x_0."""
        if self.start is not None:
            raise InputError("v0", "a bound in units of the radius of the start is not served", "at_time, proved_bound")
        # The bound is of the printed decimal, so that its rounding is inside: an enclosure of the true motion beside
        # it, whatever way the decimal was found.
        dimensionless = of_unit_start(self._given().dimensionless, x0=-1 if self.mirrored else 1)
        return proved_bound(dimensionless, self.at(time, digits=digits).x, time, max_seconds=seconds_left())

    def _theorem(self) -> Theorem:
        if self.start is not None:
            raise InputError("v0", "for a start in motion no bound for all times is proved", "v0 = 0, proved_bound")
        # Of the mirror image too: every force is odd.
        oscillator = of_unit_start(self._given().dimensionless)
        return lambda until: explicit_bound(oscillator, self.order, until=until)

    def latex(self, *, standalone: bool = False) -> str:
        """The formulas as LaTeX: a fragment, or a document that compiles with pdflatex."""
        require_flag(standalone, "standalone")
        body = "\n".join(rf"\[ {line} \]" for line in latex_lines(self.formulas))
        return document(body) if standalone else body

    def shown_waves(self) -> list[Expr]:
        """x_n as the hierarchy has it, the open ones as integrals, at a = 1."""
        return [one.solution.rhs.subs(a, 1) for one in self.scales.orders[1 : self.order] if one.solution is not None]

    def definitions(self) -> list[Eq]:
        """What the letters of the open integrals mean: X_j, f_j, g_j, K_j, L_j, V_j, and p_j, Omega_j by name."""
        return [] if self.is_closed else definitions_of(self)

    def _page(self) -> Page:
        title, *rest = str(self).splitlines()
        return Page(title, (*rest, *self.notes))

    def _formula(self) -> str:
        return r"\displaystyle \begin{gathered}" + r" \\ ".join(latex_lines(self.formulas)) + r"\end{gathered}"

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready: SymPy text in tau and letters; ``where`` says what they are."""
        letters = self.formulas
        head = {"alpha": str(self.alpha), "order": self.order, "gauge": TURNING_POINT}
        rest: dict[str, Any] = {
            "amplitude": str(letters.amplitude),
            "phase": str(letters.phase),
            "x": text_of_x(letters),
        }
        rest |= {"x_by_name": x_by_name(letters)}
        begin = [f"{letter} = {value}" for letter, value in self.letters.items()]
        begin += [] if self.oscillator is None else [f"epsilon = {self.strength}"]
        begin += ["x_0 = |x(0)|"] if self.mirrored else []
        rest["where"] = [*begin, *(f"{e.lhs} = {e.rhs}" for e in self.definitions())]
        return {**head, **rest, **letters.validity, "certified": False}

    def __str__(self) -> str:
        return text_of(self.formulas)

    def __repr__(self) -> str:
        return f"Solution(alpha = {self.alpha}, order {self.order})"
