"""What was given for a law, an exponent, a list of them, a law or an oscillator, as terms: no engine is loaded for it.

>>> terms, strengths, oscillator, notes = terms_of([1, 1.5])
>>> [str(t.velocity) for t in terms], strengths, oscillator, notes
(['1', '3/2'], None, None, ('alpha: the float 1.5 was read as 3/2',))
"""

from collections.abc import Mapping
from typing import Any

from asymptotics.errors import InputError
from asymptotics.law import Law, Oscillator
from asymptotics.numbers.policy import float_notes
from asymptotics.terms import Term

# A limit of size: M_(alpha+1) and the series exist for every exponent.
MAX_ALPHA = 1000
_FORMS = 'an exponent >= 0, a list of them, a Law, an Oscillator, a mapping exponent -> strength, or "symbolic"'


def terms_of(law: Any, spring: Any = None) -> tuple[tuple[Term, ...], Law | None, Oscillator | None, tuple[str, ...]]:
    """(terms, strengths if known, oscillator if there are units, notes)."""
    if isinstance(law, Oscillator):
        if spring is not None:
            raise InputError("spring", "the oscillator has its springs", "Oscillator(law, spring=...)")
        made = law.dimensionless
        return made.terms, made, law, law.notes
    if isinstance(law, Mapping) or hasattr(law, "terms"):
        made = Law.read(law) if spring is None else Law(Law.read(law), spring)
        return made.terms, made, None, made.notes
    exponents = law if isinstance(law, list | tuple) else [law]
    if not exponents and spring is None:
        raise InputError("alpha", "no exponent is given", _FORMS)
    # Read as an exponent it would be refused as well, but without a word of the other forms that are accepted.
    if law is None:
        raise InputError("alpha", "None is not an exponent", _FORMS)
    bare = Law.from_terms([*[Term(1, a) for a in exponents], *_springs(spring)], float_notes_of(exponents))
    for t in bare.terms:
        if t.velocity > MAX_ALPHA:
            raise InputError("alpha", f"{t.velocity} is out of range", f"a real number from 0 to {MAX_ALPHA}")
    return bare.terms, None, None, bare.notes


def _springs(spring: Any) -> tuple[Term, ...]:
    return () if spring is None else Law({}, spring).terms


def float_notes_of(exponents: Any) -> tuple[str, ...]:
    """What the floats among the exponents were read as."""
    return tuple(note for a in exponents for note in float_notes(alpha=a))
