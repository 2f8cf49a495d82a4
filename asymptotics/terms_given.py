"""The terms of what is given for a law: losses and springs of mappings, equal exponents merged, floats told.

>>> [str(t) for t in merged([*losses_of({1: "1/50", "1": "1/50"}), *springs_of({3: "-1/6"})])[0]]
["1/25 x'", '-1/6 x^3']
"""

from collections.abc import Iterable, Mapping
from typing import Any

from asymptotics.errors import InputError, shown
from asymptotics.numbers.policy import exact_number, float_notes
from asymptotics.terms import Term

PENDULUM = "pendulum"
FORMS = 'exponent -> strength, such as {"3/2": "1/10"} or {(1, 2): "1/10"} for |x|^2 x\''
SPRING_FORMS = f'power -> strength, such as {{3: "1/10"}}, or "{PENDULUM}"'


def terms_of(given: Any) -> list[Term]:
    """Terms, of one or of several; InputError for anything else."""
    terms = []
    # Looked at one by one: what is endless, or longer than the memory, ends at what is no term.
    for t in given if isinstance(given, Iterable) else [given]:
        if not isinstance(t, Term):
            raise InputError("terms", f"{shown(t)} is no term", "terms")
        terms.append(t)
    return terms


def losses_of(law: Any) -> Iterable[Term]:
    """The losses of a mapping exponent -> strength."""
    if not isinstance(law, Mapping):
        raise InputError("law", f"{type(law).__name__} is neither a law nor a mapping", FORMS)
    for key, strength in law.items():
        velocity, position = key if isinstance(key, tuple) and len(key) == 2 else (key, 0)
        yield Term(exact_number(strength, "strength"), velocity, position)


def springs_of(spring: Any) -> Iterable[Term]:
    """The springs of a mapping power -> strength, of "pendulum", or none."""
    if spring is None:
        return
    if isinstance(spring, str) and spring == PENDULUM:
        # The first term of sin x - x gives the weight 2; the strength 1 is in units of one radian squared.
        yield Term(1, 0, 3, "position", "pendulum")
        return
    if not isinstance(spring, Mapping):
        raise InputError("spring", f"{shown(spring)} is no spring", SPRING_FORMS)
    for key, strength in spring.items():
        position, velocity = key if isinstance(key, tuple) and len(key) == 2 else (key, 0)
        yield Term(exact_number(strength, "strength"), velocity, position, "position")


def merged(terms: Iterable[Term]) -> tuple[tuple[Term, ...], list[str]]:
    """Losses before springs, equal exponents added; InputError when a sum of strengths is not one exact number."""
    found: dict[object, Term] = {}
    notes = []
    # A stable sort: within losses and within springs the order given stays.
    for t in sorted(terms, key=lambda t: t.sign):
        if t.key in found:
            name = "alpha" if t.sign < 0 else "spring"
            notes.append(f"equal exponents merged: {name} = {t.velocity if t.sign < 0 else t.position}")
            t = t.plus(found[t.key])
        found[t.key] = t
    return tuple(found.values()), notes


def notes_of_floats(mapping: Any, name: str) -> tuple[str, ...]:
    """What a mapping has of floats, which are read as decimals; ``name`` is that of its keys."""
    if not isinstance(mapping, Mapping):
        return ()
    # A key may be a pair of powers: each of the two may be a float.
    keys = [k for key in mapping for k in (key if isinstance(key, tuple) else (key,))]
    of_keys = (float_notes(**{name: k}) for k in keys)
    return tuple(n for notes in (*of_keys, *(float_notes(strength=s) for s in mapping.values())) for n in notes)
