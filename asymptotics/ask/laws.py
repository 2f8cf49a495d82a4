"""The kinds that several options make: terms without strengths, a law, and what moves (a law with units and start).

>>> TERMS.read({3: "1/2"}, "law").names, TERMS.read("3/2", "law").known
(["x'^3"], False)
>>> str(MOVES.read({2: "1/10"}, "law").oscillator.law), MOVES.read({2: "1/10"}, "law").frame.time
("1/10 x'|x'|", 'tau')
"""

import argparse
from collections.abc import Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Any

from asymptotics.ask.forces import FORMS_FROM_0, GivenTerms, law_pairs, read_alpha, read_law, read_terms
from asymptotics.ask.kinds import Kind, Option
from asymptotics.ask.moving import QUANTITIES, is_physical, read_moving, read_oscillator, unit_pairs
from asymptotics.ask.pairs import excludes, needs
from asymptotics.expansions.equations.given import terms_of
from asymptotics.law import Law, Oscillator
from asymptotics.law_given import Given, given_at_unit_start, law_of
from asymptotics.numbers.exact import ExactReal, parse_real
from asymptotics.numbers.policy import exact_number
from asymptotics.terms import Term

SYMBOLIC = "symbolic"
LAW_FEEDS: Mapping[str, tuple[str, ...]] = MappingProxyType({  # a parameter of the library: options that may set it
    "alpha": ("law", "alpha"), "alphas": ("law", "alpha"), "law": ("law", "alpha"),
    "strength": ("law", "damping", "epsilon"), "epsilon": ("law", "epsilon", "damping"), "spring": ("spring",),
    "amplitude": ("amplitude", "x0"), "x0": ("x0",), "v0": ("v0",), "mass": ("mass",), "stiffness": ("stiffness",),
})  # fmt: skip


def law_options(
    meaning: str = "its strength: what delta is at the amplitude A", *, springs: bool = True
) -> tuple[Option, ...]:
    """--alpha, --epsilon, --law and (unless there are no ``springs``) --spring."""
    spring = "a spring c x|x|^(P-1) beside the linear one, repeated; P,Q:C has |x'|^Q as well; pendulum: sin x for x"
    return (
        Option("alpha", "A", f"the exponent of the damping law, A >= 0: {FORMS_FROM_0}", "the law"),
        Option("epsilon", "E", meaning, "the law"),
        Option(
            "law", "A[,M]:E", "one term of a sum, repeated: its exponent and its strength; A,M:E has the factor |x|^M",
            "the law", repeated=True,
        ),
        *([Option("spring", "P[,Q]:C", spring, "the law", repeated=True)] if springs else []),
    )  # fmt: skip


def unit_options() -> tuple[Option, ...]:
    """--damping, --mass, --stiffness: each of them makes everything SI."""
    return (
        Option("damping", "B", "b in N (s/m)^alpha: SI units", "the law"),
        *(
            Option(name, letter, f"{text} (default {default}): SI units", "the law")
            for name, (letter, default, text) in QUANTITIES.items()
            if name in ("mass", "stiffness")
        ),
    )


def start_options(*names: str) -> tuple[Option, ...]:
    """--x0 and --v0."""
    return tuple(
        Option(name, letter, f"{text} (default {default})", "the start")
        for name, (letter, default, text) in QUANTITIES.items()
        if name in names
    )


def _terms(value: Any, _name: str, spring: Any = None) -> GivenTerms | str:
    if isinstance(value, str) and value.strip() == SYMBOLIC:
        return SYMBOLIC
    terms, strengths, _, notes = terms_of(value, spring)
    return GivenTerms(terms, notes, known=strengths is not None)


def _terms_of_options(options: argparse.Namespace) -> GivenTerms | str:
    return SYMBOLIC if options.alpha == SYMBOLIC else read_terms(options)


TERMS = Kind(
    "LAW",
    _terms,
    options=law_options(),
    assemble=_terms_of_options,
    feeds=LAW_FEEDS,
    group="the law",
    beside=("spring",),
    pairs=(
        *law_pairs("epsilon"),
        excludes("spring", "alpha=symbolic", "cannot be combined with a symbolic exponent", "one law, in closed form"),
    ),
    word="alpha",
)
"""Terms whose strengths may be left out; ``SYMBOLIC`` for a symbol in the place of the exponent."""


@dataclass(frozen=True)
class TermsInUnits:
    """Terms, or ``SYMBOLIC`` with its springs and its strength; and the oscillator, where units were given."""

    terms: GivenTerms | str
    oscillator: Oscillator | None = None
    springs: tuple[Term, ...] = ()
    epsilon: ExactReal | None = None


def _in_units(value: Any, name: str, spring: Any = None) -> TermsInUnits:
    return TermsInUnits(_terms(value, name, spring), value if isinstance(value, Oscillator) else None)


def _in_units_of_options(options: argparse.Namespace) -> TermsInUnits:
    if options.alpha == SYMBOLIC:
        # The reader of terms would take the word for a number: what is left for it are the springs.
        rest = argparse.Namespace(**{**vars(options), "alpha": None, "law": None, "epsilon": None})
        epsilon = None if options.epsilon is None else parse_real(options.epsilon, "--epsilon")
        return TermsInUnits(SYMBOLIC, None, read_terms(rest).terms if options.spring else (), epsilon)
    return TermsInUnits(read_terms(options), read_oscillator(options).oscillator if is_physical(options) else None)


TERMS_IN_UNITS = replace(
    TERMS,
    read=_in_units,
    assemble=_in_units_of_options,
    options=(*law_options(), *unit_options()),
    pairs=(*law_pairs("epsilon", "damping"), *unit_pairs()),
)
"""Terms whose strengths may be left out; in SI with --damping, --mass or --stiffness."""


def _law(value: Any, _name: str, spring: Any = None) -> Law:
    return law_of(value) if spring is None else Law(law_of(value), spring)


def law_with_strengths(meaning: str, *, negative: bool = False, springs: bool = True) -> Kind:
    """A law with its strengths; ``negative``: gains are laws too."""
    return Kind(
        "LAW", _law, beside=("spring",), options=law_options(meaning, springs=springs), feeds=LAW_FEEDS,
        assemble=lambda options: read_law(options, "epsilon", negative=negative), group="the law",
        pairs=law_pairs("epsilon"),
    )  # fmt: skip


MOVING_PAIRS = (*unit_pairs(), *law_pairs("epsilon", "damping"))


def _moving(value: Any, _name: str) -> Given:
    return given_at_unit_start(value)


def moving(
    meaning: str = "b omega_0^alpha x0^(alpha-1)/k: no units",
    *,
    springs: bool = True,
    start: tuple[str, ...] = ("x0", "v0"),
) -> Kind:
    """What moves, and from where: a law, with units where --damping, --mass or --stiffness is given, and its start."""
    options = (*law_options(meaning, springs=springs), *unit_options(), *start_options(*start))
    return Kind(
        "LAW", _moving, options=options, assemble=read_oscillator, feeds=LAW_FEEDS, group="the law",
        pairs=MOVING_PAIRS,
    )  # fmt: skip


MOVES = moving()
MOVES_OR_RESTS = replace(MOVES, assemble=read_moving)
"""The same, or in the shell what rests: x0 = 0 and v0 = 0."""


def _moving_or_formulas(value: Any, name: str) -> Given | ExactReal | str:
    if isinstance(value, Law | Oscillator | Mapping):
        return _moving(value, name)
    return SYMBOLIC if isinstance(value, str) and value.strip() == SYMBOLIC else exact_number(value, "alpha")


def _moving_or_formulas_of_options(options: argparse.Namespace) -> Given | ExactReal | str:
    # One exponent without any number is the symbolic case; a sum without strengths has no explicit solution to show.
    alone = options.alpha is not None and options.law is None and options.spring is None
    if alone and options.epsilon is None and not is_physical(options):
        return SYMBOLIC if options.alpha == SYMBOLIC else read_alpha(options.alpha, "--alpha")
    return read_oscillator(options, "epsilon")


_STRENGTHS = "epsilon damping mass stiffness"
MOVES_OR_FORMULAS = replace(
    MOVES,
    read=_moving_or_formulas,
    assemble=_moving_or_formulas_of_options,
    word="alpha",
    pairs=(
        *unit_pairs(),
        *law_pairs("epsilon", "damping"),
        excludes(
            "alpha=symbolic", f"{_STRENGTHS} spring", "a symbolic exponent has no numbers", "--alpha symbolic alone"
        ),
        needs("x0 v0", f"{_STRENGTHS} law spring", "formulas alone have no start in numbers", "--epsilon E with it"),
    ),
)
"""The same, or an exponent alone, or ``SYMBOLIC``, of which there are formulas and no numbers."""
