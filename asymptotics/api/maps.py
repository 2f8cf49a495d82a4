"""The half-swing: the map from one turning point to the next, as series in the local strengths or at given ones.

>>> series = half_swing(2, order=3)
>>> series.log_ratio["1"].exact, series.duration["2"].exact
('-4/3', 'pi/6')
>>> at = half_swing("3/2", delta="1/10", digits=12)
>>> at.amplitude, at.certified
('0.870193291989', True)
"""

from dataclasses import replace
from typing import Any

from asymptotics.equations.build import terms_of
from asymptotics.errors import InputError
from asymptotics.half_swings.finite_result import HalfSwingAt, half_swing_at
from asymptotics.law import Law
from asymptotics.normal_form.coefficients import half_swing_coefficients
from asymptotics.normal_form.results import HalfSwingCoefficients
from asymptotics.numbers.policy import exact_integer, exact_number, float_notes

MAX_ORDER, MAX_DIGITS = 200, 1000


def half_swing(
    law: Any, *, order: Any = 4, digits: Any = 30, delta: Any = None, spring: Any = None, exact: bool = False
) -> HalfSwingCoefficients | HalfSwingAt:
    """L, F, T and the flow U, V, W through delta^order; with ``delta`` the certified numbers at that local strength.

    ``law`` as in ``expand``; ``delta`` is a number, or a list of one for each term.  InputError for what cannot be
    read, LimitError with the estimate, UndecidedError where balls cannot decide.
    """
    D = exact_integer(digits, "digits", 1, MAX_DIGITS)
    terms, _, _, notes = terms_of(law, spring)
    if delta is None:
        found = half_swing_coefficients(terms, exact_integer(order, "order", 1, MAX_ORDER), D, exact_only=exact)
        return replace(found, notes=notes)
    if exact:
        raise InputError("exact", "cannot be combined with delta", "delta alone: certified digits")
    given = delta if isinstance(delta, list | tuple) else [delta]
    notes = (*notes, *(note for d in given for note in float_notes(delta=d)))
    at = half_swing_at(Law.from_terms(terms).alphas, [exact_number(d, "delta") for d in given], D)
    return replace(at, notes=notes)
