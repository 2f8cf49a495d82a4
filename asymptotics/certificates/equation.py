"""The equation of a certificate: x'' + k x + sum of e sgn(x')|x'|^a = 0 with rational numbers, or why there is none.

>>> from asymptotics.law import Law, Oscillator
>>> Equation.read(Oscillator({"3/2": "1/10"}, mass="3/2", stiffness=30, x0="1/5"))
Equation(terms=((Fraction(3, 2), Fraction(1, 15)),), stiffness=Fraction(20, 1), x0=Fraction(1, 5), v0=Fraction(0, 1))
>>> Equation.read(Oscillator({"sqrt(2)": 1}))
Traceback (most recent call last):
    ...
asymptotics.errors.InputError: argument certificate: the exponent sqrt(2) is not rational, ... (accepted: ...)
"""

from dataclasses import dataclass
from fractions import Fraction
from math import lcm

from asymptotics.errors import InputError
from asymptotics.law import Oscillator
from asymptotics.numbers.exact import ExactReal
from asymptotics.terms import Scaled

SERVED = "powers of the velocity with rational exponents and strengths beside the linear spring, a rational start"
MOST = 1250
"""Of the numerator and of the denominator of an exponent: what the checker takes."""


@dataclass(frozen=True)
class Equation:
    """Exponents with strengths in order, the stiffness over the mass, and the start; all of them rational."""

    terms: tuple[tuple[Fraction, Fraction], ...]
    stiffness: Fraction
    x0: Fraction
    v0: Fraction

    @classmethod
    def read(cls, oscillator: Oscillator) -> "Equation":
        """The equation of an oscillator divided by its mass; InputError by name for what has no certificate."""
        for term in oscillator.law.terms:
            if not term.is_power_of_velocity:
                reason = f"beside {term.shape()} two motions may part, and the lemma of the certificate fails"
                raise InputError("certificate", reason, SERVED)
        oscillator.law.require_dissipative("certificate")
        mass = _rational(oscillator.mass, "the mass")
        terms = []
        for term in oscillator.law.terms:
            a = _rational(term.velocity, "the exponent")
            if max(a.numerator, a.denominator) > MOST:
                raise InputError("certificate", f"the exponent {a} is too long", f"p/q with p and q up to {MOST}")
            if isinstance(term.strength, Scaled):
                raise InputError("certificate", f"the strength {term.strength} is not rational", SERVED)
            if not term.strength.is_zero:
                terms.append((a, _rational(term.strength, "the strength") / mass))
        stiffness = _rational(oscillator.stiffness, "the stiffness") / mass
        return cls(tuple(terms), stiffness, _rational(oscillator.x0, "x0"), _rational(oscillator.v0, "v0"))

    @property
    def root(self) -> int:
        """The common denominator q of the exponents: next to rest the motion is a series in s^(1/q)."""
        return lcm(*(a.denominator for a, _ in self.terms))

    @property
    def friction(self) -> Fraction:
        """What dry friction holds: the strengths of the exponent 0 together."""
        return sum((e for a, e in self.terms if a == 0), Fraction(0))

    def exact_place(self, number: int) -> Fraction | None:
        """The place of a turning point where rational arithmetic has it: under dry friction alone, from rest."""
        if self.v0 != 0 or any(a != 0 for a, _ in self.terms):
            return None
        size = abs(self.x0) - 2 * number * self.friction / self.stiffness
        return size if (number % 2 == 0) == (self.x0 > 0) else -size

    def holds(self, place: Fraction) -> bool:
        """Whether a mass at rest there stays."""
        return self.stiffness * abs(place) <= self.friction


def _rational(value: ExactReal, name: str) -> Fraction:
    if not value.is_rational:
        raise InputError("certificate", f"{name} {value} is not rational, and no polynomial ends exactly", SERVED)
    return value.rational
