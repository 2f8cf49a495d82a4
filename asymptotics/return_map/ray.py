"""What laws share one return map: those that differ in the unit of amplitude alone.

In units of A the half-swing depends on delta_i = epsilon_i A^(alpha_i - 1) alone.  With A = A'/u and
u^(alpha_1 - 1) = epsilon_1, alpha_1 the exponent next to 1, it is that of the strengths

    kappa_i = epsilon_i epsilon_1^(-(alpha_i - 1)/(alpha_1 - 1)),    kappa_1 = 1,    kappa_i = epsilon_i at alpha_i = 1.

* One exponent, beside linear damping of the same strength: every strength and every start has one map.
* Several exponents: the laws with the same kappa_i, where these are exact numbers, and otherwise every start of one
  oscillator, in the unit of length; 0 and alpha have one kappa, mu^(alpha-1) epsilon, and each its own map.
* Elsewhere each law is alone: the strengths are its own, and u = 1.

>>> from asymptotics.law import Law
>>> one, other = ray_of(Law({"3/2": "1/10", 2: "1/50"})), ray_of(Law({"3/2": "1/5", 2: "2/25"}))
>>> one[0] == other[0], one[0].strengths, ray_of(Law({"3/2": "1/10"}))[0] == ray_of(Law({"3/2": 7}))[0]
(True, (ExactReal('1'), ExactReal('2')), True)
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from flint import arb

from asymptotics.errors import InputError
from asymptotics.flow.balls import size_of
from asymptotics.law import Law
from asymptotics.numbers.context import ctx
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.powers import exact_power
from asymptotics.terms import Scaled, Strength, Term

# Choices, by which laws share more or fewer maps: larger powers make exact numbers long, and the plans of panels are
# made in doubles, whose range ends near 2^1000.
_MOST = 12  # |alpha_i - 1|/|alpha_1 - 1|
_LEAST = Fraction(1, 64)  # |alpha_1 - 1|
_RANGE = 800.0  # |log2 kappa_i|


@dataclass(frozen=True)
class Ray:
    """Exponents, and the strengths in the unit of amplitude of the ray, by exponent."""

    alphas: tuple[ExactReal, ...]
    strengths: tuple[Strength, ...]

    def terms(self) -> list[tuple[arb, ExactReal]]:
        """(strength, exponent) at the current precision."""
        return [(e.ball(), a) for e, a in zip(self.strengths, self.alphas, strict=True)]


LogUnit = Callable[[], arb]
"""ln u at the current precision, where A' = u A."""


def ray_of(law: Law) -> tuple[Ray, LogUnit]:
    """The ray of a law of powers of the velocity, and how its amplitudes are those of the ray."""
    terms = sorted((t for t in law.terms if t.strength.sign > 0), key=lambda t: t.velocity)
    alphas = tuple(t.velocity for t in terms)
    moving = [t for t in terms if t.velocity != 1]
    for strengths, log_unit in (_by_strength(terms, moving), _by_length(terms, moving)):
        if strengths is not None:
            return Ray(alphas, strengths), log_unit
    return Ray(alphas, tuple(t.strength for t in terms)), lambda: arb(0)


def _by_strength(terms: Sequence[Term], moving: Sequence[Term]) -> tuple[tuple[Strength, ...] | None, LogUnit]:
    """In the unit in which the strength of the exponent next to 1 is 1, so that the others are the larger powers."""
    lead = min(moving, key=lambda t: abs(t.velocity - 1), default=None)
    # Of several exponents: with one very near 1 the unit epsilon^(1/(alpha-1)) is out of all proportion.
    if lead is None or (len(moving) > 1 and abs(lead.velocity - 1) < _LEAST):
        return None, lambda: arb(0)
    kappas = [_relative(t, lead) for t in terms]
    made = None if any(k is None for k in kappas) else tuple(k for k in kappas if k is not None)
    return made, lambda: lead.strength.ball().log() / (lead.velocity - 1).ball()


def _by_length(terms: Sequence[Term], moving: Sequence[Term]) -> tuple[tuple[Strength, ...] | None, LogUnit]:
    """In the unit of length, where the strengths are those of an oscillator whose start is another one."""
    units = next((t.strength.units for t in terms if isinstance(t.strength, Scaled)), None)
    if units is None or len(moving) < 2:
        return None, lambda: arb(0)
    one, found = replace(units, x0=ExactReal(1), v0=ExactReal(0)), []
    for t in terms:
        if isinstance(t.strength, Scaled):
            found.append(one.scale(t.strength.b, t.strength.velocity, t.strength.weight))
        # A strength that is an exact number: so must the power of the length be.
        elif units.v0.is_zero and (power := exact_power(abs(units.x0), 1 - t.velocity)) is not None:
            found.append(t.strength * power)
        else:
            return None, lambda: arb(0)
    return tuple(found), lambda: units.length().log()


def _relative(term: Term, lead: Term) -> Strength | None:
    """kappa_i, None where it is no exact number or too large or small for the plans."""
    if term.velocity == 1:
        return term.strength
    if term is lead:
        return ExactReal(1)
    if not isinstance(term.strength, ExactReal) or not isinstance(lead.strength, ExactReal):
        return None
    try:
        share = (term.velocity - 1) / (lead.velocity - 1)
        power = exact_power(lead.strength, -share) if abs(share) <= _MOST else None
        kappa = None if power is None else term.strength * power
    except InputError:  # two roots
        return None
    return kappa if kappa is not None and _is_moderate(kappa) else None


def _is_moderate(number: ExactReal) -> bool:
    with ctx.workprec(64):
        return abs(size_of(number.ball())) < _RANGE
