"""The amplitude and phase equations of any law, in one gauge: the result that every route to p_k and Omega_k returns.

    dA/dtau = -A p(delta),    dpsi/dtau = 1 + Omega(delta),    delta_i = epsilon_i A^w_i

with w_i the degree of term i less 1.  Dimensionless (m = k = x0 = 1) unless they were made from an oscillator: then A
is in metres, the time in seconds, delta_i = b_i omega_0^alpha_i A^w_i/k, and both right sides carry a factor omega_0.

The series are *formal*: no bound on what is cut off is claimed.  ``observables`` gives an estimate.

>>> from asymptotics.expansions.equations.build import expand
>>> eq = expand("3/2", order=4)
>>> print(eq)
dA/dtau   = -A (0.4576558581 d + 0.001614779202 d^3)
dpsi/dtau = 1 - 12/(25*pi) d^2 - 0.01999292675 d^4
d = epsilon A^(1/2)
alpha = 3/2, gauge turning-point, order 4, certified coefficients; formal: no bound on the remainder
>>> eq.p[1].exact, eq.Omega[4].value
('gamma(7/4)/(sqrt(pi)*gamma(9/4))', '-0.0199929267481898918345844307217')
>>> dA, dpsi = eq(A=0.5, epsilon=0.1)
>>> round(dA, 10), round(dpsi, 10)
(-0.0161808635, 0.9992355564)
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from asymptotics.errors import InputError, require_choice
from asymptotics.expansions.equations.comparison import EquationsComparison, compare_functions, compare_rows
from asymptotics.expansions.equations.observables import Observables, observables_at
from asymptotics.expansions.equations.row import CoefficientRow
from asymptotics.expansions.equations.strengths import Strengths
from asymptotics.expansions.normal_form import show
from asymptotics.gauges import TURNING_POINT
from asymptotics.law import Law, Oscillator
from asymptotics.numbers.policy import Number, exact_integer, exact_number
from asymptotics.numbers.value import Coefficient, coefficient_columns
from asymptotics.present.shown import Page, Rows
from asymptotics.running.public import public
from asymptotics.terms import Term

if TYPE_CHECKING:
    from sympy import Eq, Expr, Symbol

    from asymptotics.expansions.divergence.truncation import BestOrder


@dataclass(frozen=True, repr=False)
class Equations(Rows):
    """p_k (``p``) and Omega_k (``Omega``) of a law in one gauge through ``order``; see the module for the equations.

    ``terms``: the forces, losses first; with a symbolic exponent there is none, and ``symbol`` is the exponent.
    ``law``: the strengths epsilon when they are known; ``oscillator``: when the answer is to be in SI units.
    ``arithmetic``: "exact", "certified" or "symbolic", of the coefficients.
    """

    terms: tuple[Term, ...]
    gauge: str
    order: int
    arithmetic: str
    p: CoefficientRow
    Omega: CoefficientRow
    law: Law | None = None
    oscillator: Oscillator | None = None
    symbol: "Symbol | None" = None
    notes: tuple[str, ...] = field(default=(), compare=False)

    @property
    def formal(self) -> bool:
        """True: no bound on the remainder is claimed."""
        return True

    @property
    def strengths(self) -> Strengths:
        """What the delta_i are."""
        return Strengths(self.terms, self.law, self.oscillator, self.symbol)

    def __call__(self, A: Any, psi: Any = 0.0, epsilon: Any = None) -> tuple[Any, Any]:
        """(dA/dtau, dpsi/dtau) at an amplitude (number or array), in SI for an oscillator; doubles, heuristic.

        ``epsilon`` (a number, or one for each term) is needed when the law has no strengths.  The right sides do not
        depend on psi; the argument is there for integrators.
        """
        return self.lambdify(epsilon=epsilon)(A, psi)

    @public
    def lambdify(
        self, modules: str = "numpy", *, epsilon: Any = None, max_seconds: Number = 60
    ) -> Callable[..., tuple[Any, Any]]:
        """``f(A, psi) -> (dA/dtau, dpsi/dtau)``, as a function of numbers.

        ``modules``: "numpy", for arrays, or "mpmath", at the precision in force. ``epsilon``: the strength, one for
        each law; where none is known or given it is an argument of the function, ``f(A, psi, epsilon)``.

        >>> from asymptotics.expansions.equations.build import expand
        >>> expand(3, order=2).lambdify()(0.5, 0.0, 0.1) == expand({3: "1/10"}, order=2).lambdify()(0.5)
        True
        """
        require_choice(modules, "modules", ("numpy", "mpmath"))
        as_number: Callable[[Coefficient], Any] = float if modules == "numpy" else Coefficient.mpf
        from asymptotics.expansions.equations.rates import rates, strengths_in  # noqa: PLC0415 (NumPy, and mpmath)

        p, Omega = ([(k, as_number(c)) for k, c in row.keyed().items()] for row in (self.p, self.Omega))
        # A list of exponents has no strengths: then they are an argument of what is returned.
        if epsilon is None and self.law is None and self.terms:

            def of_strength(A: Any, psi: Any = 0.0, epsilon: Any = None) -> tuple[Any, Any]:
                return rates(p, Omega, strengths_in(modules, self.strengths, epsilon), modules)(A, psi)

            return of_strength
        return rates(p, Omega, strengths_in(modules, self.strengths, epsilon), modules)

    def rhs(self, t: float, y: Any) -> list[Any]:
        """The right side for ``scipy.integrate.solve_ivp``: the rates of ``y`` = (A, psi), at any ``t``."""
        from asymptotics.expansions.equations.rates import state_of  # noqa: PLC0415 (as above)

        return list(self(*state_of(y)))

    @public
    def to_sympy(self, *, max_seconds: Number = 60) -> "tuple[Expr, Expr]":
        """(dA/dtau, dpsi/dtau) in the symbols A and epsilon (epsilon_1, ... for several), SI numbers for an oscillator.

        Coefficients are exact where an exact form is known, Floats with all their digits elsewhere.
        """
        from asymptotics.expansions.equations.in_sympy import right_sides  # noqa: PLC0415 (SymPy: printing needs none)

        return right_sides(self.p, self.Omega, self.strengths)

    @public
    def odes(self, *, max_seconds: Number = 60) -> "tuple[Eq, Eq]":
        """The two equations for the functions A and psi of tau (of t for an oscillator), as SymPy equations."""
        from asymptotics.expansions.equations.in_sympy import TAU, T, odes  # noqa: PLC0415 (as above)

        return odes(self.to_sympy(), TAU if self.oscillator is None else T)

    @public
    def observables(self, A: Any = None, epsilon: Any = None, *, max_seconds: Number = 60) -> Observables:
        """Half period, decrement, Q and energy loss at the turning amplitude A (default: the start), any gauge.

        ``A``: in m for an oscillator, else in units of x0; ``epsilon``: the strengths, where the equations have none.
        """
        if not self.terms:
            raise InputError("alpha", "it is symbolic", "an exponent")
        strengths, weights, _ = self.strengths.numbers(epsilon)
        start = 1.0 if self.oscillator is None else float(self.oscillator.length().mid())
        amplitude = start if A is None else _amplitude(A)
        deltas = [s * amplitude**w for s, w in zip(strengths, weights)]
        return observables_at(self.terms, self.order, deltas, amplitude, self.oscillator)

    @public
    def compare(
        self,
        other: "Equations | Callable[..., Any]",
        A: Any = None,
        epsilon: Number | Sequence[Number] | None = None,
        *,
        max_seconds: Number = 60,
    ) -> EquationsComparison:
        """Against ``other`` equations of any gauge or order (observables), or a function (A, psi) -> rates in this one.

        ``A``, ``epsilon``: as for ``observables``.
        """
        if isinstance(other, Equations):
            names = (f"{eq.gauge} order {eq.order}" for eq in (self, other))
            return compare_rows(self.observables(A, epsilon), other.observables(A, epsilon), *names)
        if not callable(other):
            raise InputError("other", f"a {type(other).__name__}", "Equations, or a function of (A, psi)")
        return compare_functions(self.lambdify(epsilon=epsilon), other, 1.0 if A is None else _amplitude(A))

    @public
    def best_order(self, delta: Number, *, max_seconds: Number = 60) -> "BestOrder":
        """Where to stop at the local strength ``delta``, one law: |c_1| e^(-2 pi |c|/delta) beside the measured error.

        Also the errors with one and two exponentials added back; all in half-swings, against the turning points that
        follow, enclosed.  InputError for sums and springs (not treated); UndecidedError for a delta too large to
        enclose, LimitError with the estimate for one too small.  Source: derivation ``cauchy-heine``.
        """
        # The Abel function and its constants are those of one power of the velocity (``divergence``).
        if len(self.terms) != 1 or not self.terms[0].is_power_of_velocity:
            raise InputError("law", "the large orders are known for one law only", "one law without a spring")
        from asymptotics.expansions.divergence import truncation  # noqa: PLC0415 (mpmath: printing needs none)

        return truncation.best_truncation(self.terms[0].velocity, exact_number(delta, "delta"))

    def latex(self, digits: int = show.SHOWN_DIGITS) -> str:
        """The equations in LaTeX, coefficients to at most ``digits`` digits where they have no short exact form."""
        D = exact_integer(digits, "digits", 1, show.MAX_DIGITS)
        time, names = (r"\tau" if self.oscillator is None else "t"), self._names(r"\delta", "_{%d}")
        p, Omega = show.sum_latex(self.p.keyed(), names, "", D), show.sum_latex(self.Omega.keyed(), names, "1", D)
        factor = "" if self.oscillator is None else r"\omega_0"
        # omega_0 in front of a sum needs brackets around it.
        phase = Omega if not factor or Omega == "1" else rf"\left({Omega}\right)"
        right = f"{factor} {phase}".strip() if phase != "1" or not factor else factor
        left = f"-{factor} A".replace("- A", "-A")
        return rf"\frac{{dA}}{{d{time}}} = {left} \left({p}\right), \quad \frac{{d\psi}}{{d{time}}} = {right}"

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready: numbers are strings."""
        exponents = [str(t.velocity) for t in self.terms] or ["symbolic"]
        head = {"alpha": exponents[0] if len(exponents) == 1 else exponents, "gauge": self.gauge, "order": self.order}
        rows = {"amplitude": self.p.to_dict(), "frequency": self.Omega.to_dict()}
        terms = {"terms": [t.to_dict() for t in self.terms]} if self.law is not None else {}
        return {**head, "arithmetic": self.arithmetic, **rows, **terms, "formal": True, "notes": list(self.notes)}

    def __str__(self) -> str:
        names, time = self._names("d", "%d"), "tau" if self.oscillator is None else "t"
        p, Omega = show.sum_text(self.p.keyed(), names), show.sum_text(self.Omega.keyed(), names, "1")
        factor, phase = ("", Omega) if self.oscillator is None else ("omega_0 ", f"omega_0 ({Omega})")
        lines = [f"dA/d{time}   = -{factor}A ({p})", f"dpsi/d{time} = {phase}"]
        lines += [f"{name} = {text}" for name, text in zip(names, self.strengths.texts())]
        remark = f"{self.arithmetic} coefficients; formal: no bound on the remainder"
        return "\n".join([*lines, f"{self._subject()}, gauge {self.gauge}, order {self.order}, {remark}", *self.notes])

    def __repr__(self) -> str:
        return f"Equations({self._subject()}, gauge {self.gauge}, order {self.order}, {self.arithmetic}, formal)"

    def _page(self) -> Page:
        title, *rest = str(self).splitlines()
        rows = [(f"{name}_{key}", c, c.exact or "") for name, key, c in self._named()]
        return Page(title, tuple(rest), ("", "value", "exact"), tuple(rows))

    def _named(self) -> list[tuple[str, str, Coefficient]]:
        return [(name, k, c) for name, row in (("p", self.p), ("Omega", self.Omega)) for k, c in row.named().items()]

    def _table(self) -> dict[str, list[Any]]:
        named = self._named()
        return {"name": [n for n, _, _ in named], "key": [k for _, k, _ in named]} | coefficient_columns(
            [c for _, _, c in named]
        )

    def _letters(self) -> dict[str, str]:
        lines = " and ".join(text.partition(" and ")[0] for text in self.strengths.texts())
        phase = {} if self.gauge == TURNING_POINT else {r"\psi": f"phase, gauge {self.gauge}"}
        return {"A": f"slow amplitude, gauge {self.gauge}", r"\delta": f"local strength, {lines}", **phase}

    def _formula(self) -> str:
        return rf"\displaystyle {self.latex()}"

    def _subject(self) -> str:
        if not self.terms:
            return "alpha symbolic"
        if self.oscillator is not None:
            return str(self.oscillator)
        if self.law is not None:
            return f"law {self.law}"
        if all(t.is_power_of_velocity for t in self.terms):
            return "alpha = " + ", ".join(str(t.velocity) for t in self.terms)
        return "forces " + ", ".join(t.shape() for t in self.terms)

    def _names(self, symbol: str, index: str) -> tuple[str, ...]:
        count = self.strengths.count
        return (symbol,) if count == 1 else tuple(symbol + index % i for i in range(1, count + 1))


def _amplitude(A: Any) -> float:
    value = exact_number(A, "A")
    if not value > 0:
        raise InputError("A", f"{value} is not positive", "an amplitude > 0")
    return float(value.ball().mid())
