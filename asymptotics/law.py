"""Damping laws sum_i b_i x'|x'|^(alpha_i - 1), and the oscillator they act in, with units in and out.

    m x'' + k x + sum_i b_i x'|x'|^(alpha_i - 1) = 0        [b_i] = N (s/m)^alpha_i = kg m^(1-alpha_i) s^(alpha_i-2)

Dimensionless, with omega_0^2 = k/m, X = x/x0 and tau = omega_0 t, the strengths are

    epsilon_i = b_i omega_0^alpha_i x0^(alpha_i-1)/k,
    delta_i = epsilon_i A^(alpha_i-1),   kappa_i = M_(alpha_i+1) epsilon_i.

alpha = 0 is Coulomb friction: x'/|x'| is the sign of x', and any value in [-1, 1] at rest (so the mass can stick).
alpha = 1 is linear: delta = epsilon for all time; under-, critically or over-damped for epsilon below, at or above 2.

>>> law = Law.of([("1/10", "3/2"), ("1/5", "2"), ("1/10", "3/2")])
>>> print(law)
1/5 x'|x'|^(3/2 - 1) + 1/5 x'|x'|^(2 - 1)
>>> law.notes
('equal exponents merged: alpha = 3/2',)
>>> oscillator = Oscillator.of(law, mass="3/2", stiffness="30", x0="1/5")
>>> [e.str(10) for e in oscillator.epsilons()]
['[0.02819656703 +/- ...]', '[0.02666666667 +/- ...]']
"""

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction

import sympy
from flint import arb

from asymptotics.errors import InputError
from asymptotics.moments.certified import moment
from asymptotics.numbers.bridge import to_sympy
from asymptotics.numbers.exact import REAL_FORMS, ExactReal, parse_real

Number = str | int | Fraction | ExactReal


def exact_number(value: Number, argument: str) -> ExactReal:
    """Text, int, Fraction or ExactReal as an exact number; InputError for a float, which is not what was meant.

    >>> exact_number(1.5, "alpha")
    Traceback (most recent call last):
        ...
    asymptotics.errors.InputError: argument alpha: 1.5 is a float, not an exact number (accepted: text such as ...)
    """
    if isinstance(value, ExactReal):
        return value
    if isinstance(value, str):
        return parse_real(value, argument)
    if isinstance(value, bool) or not isinstance(value, int | Fraction):
        kind = f"a {type(value).__name__}"
        raise InputError(argument, f"{value!r} is {kind}, not an exact number", "text such as 3/2 or 1.5")
    return ExactReal(Fraction(value))


@dataclass(frozen=True)
class Term:
    """One term b x'|x'|^(alpha - 1), alpha >= 0; b in N (s/m)^alpha, or epsilon when m = k = x0 = 1."""

    b: ExactReal
    alpha: ExactReal

    def __str__(self) -> str:
        known = {"0": "sign(x')", "1": "x'", "3": "x'^3"}
        shape = known.get(str(self.alpha), f"x'|x'|^({self.alpha} - 1)")
        return f"{self.b} {shape}"

    def latex(self) -> str:
        """The term in LaTeX."""
        b, a = sympy.latex(to_sympy(self.b)), self.alpha
        if str(a) == "0":
            return rf"{b}\,\operatorname{{sgn}}\dot x"
        if str(a) == "1":
            return rf"{b}\,\dot x"
        return rf"{b}\,\dot x|\dot x|^{{{sympy.latex(to_sympy(a) - 1)}}}"


@dataclass(frozen=True)
class Law:
    """A finite sum of terms with distinct exponents, in the order given; ``notes`` says what was changed on the way."""

    terms: tuple[Term, ...]
    notes: tuple[str, ...] = ()

    @classmethod
    def of(cls, pairs: Iterable[tuple[Number, Number]]) -> "Law":
        """A law from (b, alpha) pairs; equal exponents are merged.

        Raises InputError for no term, a negative exponent, and numbers that are not exact.  b may be 0 or negative.
        """
        merged: list[Term] = []
        notes: list[str] = []
        for b, alpha in pairs:
            term = Term(exact_number(b, "b"), _exponent(alpha))
            place = next((i for i, t in enumerate(merged) if t.alpha == term.alpha), None)
            if place is None:
                merged.append(term)
            else:
                merged[place] = Term(_sum(merged[place].b, term.b), term.alpha)
                notes.append(f"equal exponents merged: alpha = {term.alpha}")
        if not merged:
            raise InputError("law", "there is no term", "at least one pair of strength and exponent")
        return cls(tuple(merged), tuple(dict.fromkeys(notes)))

    @property
    def alphas(self) -> tuple[ExactReal, ...]:
        """The exponents."""
        return tuple(t.alpha for t in self.terms)

    @property
    def integer_alphas(self) -> tuple[int, ...] | None:
        """The exponents as integers, or None if one of them is not an integer: then there is no exact arithmetic."""
        if all(a.is_rational and a.rational.denominator == 1 for a in self.alphas):
            return tuple(a.rational.numerator for a in self.alphas)
        return None

    @property
    def is_dissipative(self) -> bool:
        """Whether no strength is negative."""
        return not any(t.b < 0 for t in self.terms)

    def require_dissipative(self, purpose: str) -> None:
        """InputError by name if a strength is negative (anti-damping): the formal series exist, ``purpose`` does not.

        >>> Law.of([("-1", "2")]).require_dissipative("a sequence of turning points to rest")
        Traceback (most recent call last):
            ...
        asymptotics.errors.InputError: argument b: -1 is negative: anti-damping has no ... (accepted: b >= 0)
        """
        for t in self.terms:
            if t.b < 0:
                raise InputError("b", f"{t.b} is negative: anti-damping has no {purpose}", "b >= 0")

    def to_dict(self) -> dict[str, object]:
        """JSON-ready: numbers are strings."""
        return {"terms": [{"b": str(t.b), "alpha": str(t.alpha)} for t in self.terms], "notes": list(self.notes)}

    def __str__(self) -> str:
        return " + ".join(str(t) for t in self.terms)

    def _repr_latex_(self) -> str:
        return "$" + " + ".join(t.latex() for t in self.terms) + "$"


@dataclass(frozen=True)
class Oscillator:
    """m x'' + k x + law = 0 with x(0) = x0, x'(0) = v0 (SI units, exact numbers).

    The unit of length is |x0| when v0 = 0, else the radius sqrt(x0^2 + m v0^2/k) of the starting point.
    """

    law: Law
    mass: ExactReal
    stiffness: ExactReal
    x0: ExactReal
    v0: ExactReal

    @classmethod
    def of(
        cls, law: Law, *, mass: Number = 1, stiffness: Number = 1, x0: Number = 1, v0: Number = 0
    ) -> "Oscillator":
        """From exact numbers; the defaults make b_i = epsilon_i.  InputError for m <= 0, k <= 0, or rest at 0."""
        values = [exact_number(v, n) for v, n in ((mass, "mass"), (stiffness, "stiffness"), (x0, "x0"), (v0, "v0"))]
        for value, name in zip(values[:2], ("mass", "stiffness")):
            if not value > 0:
                raise InputError(name, f"{value} is not positive", "a positive number")
        if all(not (v < 0 or v > 0) for v in values[2:]):
            raise InputError("x0", "with x0 = 0 and v0 = 0 nothing moves", "a start away from rest at the origin")
        return cls(law, *values)

    def omega_0(self) -> arb:
        """sqrt(k/m) in rad/s, as a ball."""
        return (self.stiffness.ball() / self.mass.ball()).sqrt()

    def length(self) -> arb:
        """The unit of length in m, as a ball."""
        if not (self.v0 < 0 or self.v0 > 0):
            return abs(self.x0.ball())
        return (self.x0.ball() ** 2 + (self.v0.ball() / self.omega_0()) ** 2).sqrt()

    def epsilons(self) -> tuple[arb, ...]:
        """epsilon_i = b_i omega_0^alpha_i length^(alpha_i - 1)/k, as balls."""
        return tuple(
            t.b.ball() * _power(self.omega_0(), t.alpha, 0) * _power(self.length(), t.alpha, 1) / self.stiffness.ball()
            for t in self.law.terms
        )

    def deltas(self, amplitude: arb) -> tuple[arb, ...]:
        """delta_i = epsilon_i A^(alpha_i - 1) at the slow amplitude A > 0, in units of ``length``; InputError else."""
        if not amplitude > 0:
            raise InputError("amplitude", f"{amplitude.str(5)} is not certainly positive", "a positive number")
        return tuple(e * _power(amplitude, t.alpha, 1) for e, t in zip(self.epsilons(), self.law.terms))

    def kappas(self) -> tuple[arb, ...]:
        """Lancaster's kappa_i = M_(alpha_i+1) epsilon_i (Lancaster 2020, below (8)), as balls."""
        return tuple(moment(t.alpha.ball() + 1) * e for e, t in zip(self.epsilons(), self.law.terms))

    def to_si(self, X: arb, tau: arb) -> tuple[arb, arb]:
        """Dimensionless displacement and time -> (x in m, t in s)."""
        return X * self.length(), tau / self.omega_0()

    def to_dict(self) -> dict[str, object]:
        """JSON-ready: numbers are strings."""
        names = ("mass", "stiffness", "x0", "v0")
        return {"law": self.law.to_dict(), **{n: str(getattr(self, n)) for n in names}}

    def __str__(self) -> str:
        return f"{self.mass} x'' + {self.stiffness} x + {self.law} = 0, x(0) = {self.x0}, x'(0) = {self.v0}"

    def _repr_latex_(self) -> str:
        m, k = (sympy.latex(to_sympy(v)) for v in (self.mass, self.stiffness))
        terms = " + ".join(t.latex() for t in self.law.terms)
        return rf"${m}\,\ddot x + {k}\,x + {terms} = 0$"


def _exponent(alpha: Number) -> ExactReal:
    value = exact_number(alpha, "alpha")
    if value < 0:
        raise InputError("alpha", f"{value} is negative", f"alpha >= 0: {REAL_FORMS}")
    return value


def _power(base: arb, alpha: ExactReal, less: int) -> arb:
    """base^(alpha - less): an integer exponent stays one, so that exact powers stay exact."""
    if alpha.is_rational and alpha.rational.denominator == 1:
        return base ** (alpha.rational.numerator - less)
    return (base.log() * (alpha.ball() - less)).exp()


def _sum(a: ExactReal, b: ExactReal) -> ExactReal:
    """a + b; InputError when the sum is not rational or a rational multiple of one root."""
    if a.radicand == b.radicand:
        total = a.coefficient + b.coefficient
        return ExactReal(total, a.radicand if total else Fraction(1))
    raise InputError("b", f"{a} + {b} for equal exponents is not a single root", "strengths that add up exactly")
