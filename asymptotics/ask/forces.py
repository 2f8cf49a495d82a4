"""The one reader of forces on the command line: losses and springs, with their strengths or without.

    --alpha A --epsilon E     epsilon x'|x'|^(A-1)                 (--damping B in ``motion``)
    --law A:E                 the same as one term of a sum, repeated
    --law A,M:E               epsilon |x|^M x'|x'|^(A-1)
    --spring P:C              c x|x|^(P-1), repeated
    --spring P,Q:C            c x|x|^(P-1) |x'|^Q
    --spring pendulum         sin x in place of x, the amplitude in rad

Where a command needs no strengths, ``:E`` and ``:C`` may be left out.  M and P are integers, A and Q any real numbers.

>>> given = {"alpha": None, "epsilon": None, "law": ["0:1/20", "3/2,2:0.1"], "spring": ["3:-1/6"]}
>>> print(read_law(argparse.Namespace(**given), "epsilon"))
1/20 sign(x') + 1/10 x^2 x'|x'|^(1/2) - 1/6 x^3
>>> given = {"alpha": "2", "epsilon": None, "law": None, "spring": ["pendulum"]}
>>> [str(t) for t in read_terms(argparse.Namespace(**given)).terms]
["x'|x'|", '(sin x - x)']
"""

import argparse
from dataclasses import dataclass

from asymptotics.ask.pairs import Pair, demands, excludes
from asymptotics.errors import InputError
from asymptotics.law import Law
from asymptotics.numbers.exact import REAL_FORMS, ExactReal, parse_real
from asymptotics.numbers.integers import parse_integer
from asymptotics.terms import MAX_POSITION, Term
from asymptotics.terms_given import PENDULUM

# The work grows like the monomials of so many strengths; an exponent above 1000 is a wall, not a law.  Refusals.
MAX_FORCES, MAX_ALPHA = 4, 1000
_LAW_FORMS = "A:E or A,M:E, such as 3/2:0.1 or 1,2:0.1 for |x|^2 x'"
_SPRING_FORMS = f"P:C or P,Q:C, such as 3:-1/6 for x^3, or {PENDULUM}"


FORMS_FROM_0 = REAL_FORMS.replace("-", "", 1)
"""The forms of a number that is not negative."""


@dataclass(frozen=True)
class GivenTerms:
    """The terms of a sum, all different, losses before springs, in the order given; ``notes`` says what was merged.

    Strengths that were left out are 1; ``known``: whether all of them were given, and the merged ones have exact sums.
    """

    terms: tuple[Term, ...]
    notes: tuple[str, ...] = ()
    known: bool = False

    @property
    def shown(self) -> str | list[str]:
        """The exponent of the one loss, or the list of all, as text."""
        texts = [str(t.velocity) for t in self.terms if t.sign < 0]
        return texts[0] if len(texts) == 1 else texts

    @property
    def names(self) -> list[str]:
        """The forces without their strengths, as text."""
        return [t.shape() for t in self.terms]

    def to_list(self) -> list[dict[str, str | int]]:
        """The terms as JSON data, without strengths."""
        return [{k: v for k, v in t.to_dict().items() if k != "strength"} for t in self.terms]


def law_pairs(*strengths: str) -> tuple[Pair, ...]:
    """One law has an exponent and a strength, a sum terms: not both, and no strength without its exponent.

    ``strengths``: the options of one, the usual one first.
    """
    beside = [excludes(name, "law", "belongs to --alpha", law_forms(name)) for name in strengths]
    alone = [demands(name, "alpha", law_forms(name)) for name in strengths]
    return (excludes("alpha", "law", accepted=law_forms(strengths[0])), *beside, *alone)


def law_forms(strength: str) -> str:
    """How a law is given; ``strength``: the option of one term's strength."""
    letter = "B" if strength == "damping" else "E"
    return f"either --alpha A and --{strength} {letter}, or --law A:{letter} once for each term"


def read_law(options: argparse.Namespace, strength: str, *, negative: bool = False) -> Law:
    """The law with its strengths; InputError for a missing half, too many terms, or bad numbers.

    Both forms at once are refused before (``law_pairs``).

    ``negative``: whether losses may be negative (anti-damping).
    """
    terms = [*_losses(options, strength, needed=True, negative=negative), *_springs(options, needed=True)]
    law = Law.from_terms(terms)
    _require_few(len(law.terms))
    return law


def read_terms(options: argparse.Namespace) -> GivenTerms:
    """The terms of a command that needs no strengths; they are read, and may be negative or left out."""
    terms: dict[object, Term] = {}
    notes, known = [], _strengths_given(options)
    for t in (*_losses(options, "epsilon", needed=False, negative=True), *_springs(options, needed=False)):
        # Two strengths before one function of (x, v) are one force: their delta would be the sum, so one index has to
        # do.
        if t.key in terms:
            name = f"exponents merged: alpha = {t.velocity}" if t.sign < 0 else f"springs merged: {t.shape()}"
            notes.append(f"equal {name} (its delta is the sum of the strengths)")
            try:
                t = terms[t.key].plus(t) if known else terms[t.key]
            except InputError:  # two roots: their sum is no exact number, and stays a letter
                t, known = terms[t.key], False
        terms[t.key] = t
    _require_few(len(terms))
    return GivenTerms(tuple(terms.values()), tuple(dict.fromkeys(notes)), known)


def _strengths_given(options: argparse.Namespace) -> bool:
    texts = [*(options.law or []), *(getattr(options, "spring", None) or [])]
    return options.epsilon is not None or bool(texts) and all(":" in text for text in texts)


def _require_few(count: int) -> None:
    if count > MAX_FORCES:
        raise InputError("--law", f"{count} different exponents are too many", f"at most {MAX_FORCES} terms")


def _losses(options: argparse.Namespace, strength: str, *, needed: bool, negative: bool) -> list[Term]:
    value = getattr(options, strength)
    if options.law:
        return [_loss(text, needed, negative) for text in options.law]
    if options.alpha is None:
        # Springs alone are a sum without losses, which the commands of series serve.
        if value is None and getattr(options, "spring", None):
            return []
        raise InputError("--alpha", "is missing", law_forms(strength))
    if value is None and needed:
        raise InputError(f"--{strength}", "is missing", law_forms(strength))
    number = ExactReal(1) if value is None else _strength(value, f"--{strength}", negative)
    return [Term(number, read_alpha(options.alpha, "--alpha"))]


def _loss(text: str, needed: bool, negative: bool) -> Term:
    powers, strength = _split(text, "--law", needed, _LAW_FORMS)
    alpha, _, position = powers.partition(",")
    m = parse_integer(position, "--law", 0, MAX_POSITION) if position or "," in powers else 0
    return Term(_strength(strength, "--law", negative), read_alpha(alpha, "--law"), m)


def _springs(options: argparse.Namespace, *, needed: bool) -> list[Term]:
    return [_spring(text, needed) for text in getattr(options, "spring", None) or []]


def _spring(text: str, needed: bool) -> Term:
    if text == PENDULUM:
        # The family sin x - x, by its leading power x^3; its strength is that of the linear spring, hence no number.
        return Term(1, 0, 3, "position", "pendulum")
    powers, strength = _split(text, "--spring", needed, _SPRING_FORMS)
    position, comma, velocity = powers.partition(",")
    p = _spring_power(position)
    q = read_alpha(velocity, "--spring") if comma else ExactReal(0)
    return Term(parse_real(strength, "--spring"), q, p, "position")


def _spring_power(text: str) -> int:
    """P of x|x|^(P-1): an integer, because x^P must be a power series where the orbit passes x = 0."""
    value = parse_real(text, "--spring")
    if not value.is_integer or value < 1 or value > MAX_POSITION:
        reason = f"the power {value} is not an integer >= 1: only such springs have a power series at the passage x = 0"
        raise InputError("--spring", reason, f"{_SPRING_FORMS}; P from 1 to {MAX_POSITION}, odd in x: x|x|^(P-1)")
    return int(value.rational)


def _split(text: str, option: str, needed: bool, forms: str) -> tuple[str, str]:
    """The powers and the strength of a term; "1" where the strength may be left out."""
    powers, colon, strength = text.partition(":")
    if not colon and needed:
        raise InputError(option, f"{text[:60]!r} has no colon", forms)
    return powers, strength if colon else "1"


def read_alpha(text: str, argument: str) -> ExactReal:
    """An exponent: a real number from 0 to 1000, given exactly."""
    alpha = parse_real(text, argument)
    if alpha < 0 or alpha > MAX_ALPHA:
        raise InputError(argument, f"{alpha} is out of range", f"a real number from 0 to {MAX_ALPHA}: {REAL_FORMS}")
    return alpha


def _strength(text: str, argument: str, negative: bool) -> ExactReal:
    value = parse_real(text, argument)
    if value < 0 and not negative:
        raise InputError(argument, f"{value} is negative: anti-damping", "a strength >= 0")
    return value
