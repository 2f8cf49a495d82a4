"""The half-swing, as series in the local strengths or at given ones: a return map (Poincare) on the turning points.

>>> series = half_swing(2, order=3)
>>> series.log_ratio["1"].exact, series.duration["2"].exact
('-4/3', 'pi/6')
>>> at = half_swing("3/2", delta="1/10", digits=12)
>>> at.amplitude, at.certified
('0.870193291989', True)
"""

from collections.abc import Sequence
from dataclasses import replace

from asymptotics.errors import InputError, require_flag
from asymptotics.expansions.equations.given import terms_of
from asymptotics.expansions.half_swings.half_swing_value import HalfSwingAt
from asymptotics.expansions.normal_form.coefficients import half_swing_coefficients
from asymptotics.expansions.normal_form.results import HalfSwingCoefficients
from asymptotics.law import LawLike, SpringLike
from asymptotics.numbers.policy import Number, exact_integer, exact_number, float_notes
from asymptotics.public import public
from asymptotics.turning.half_swing import half_swing_of_terms

# As ``expand`` has them: the work is estimated from order and exponents before it begins, and refused by that.
MAX_ORDER, MAX_DIGITS = 200, 1000


@public
def half_swing(
    law: LawLike,
    *,
    order: int = 4,
    digits: int = 30,
    delta: Number | Sequence[Number] | None = None,
    spring: SpringLike | None = None,
    exact: bool = False,
    max_seconds: Number = 60,
) -> HalfSwingCoefficients | HalfSwingAt:
    """L, F, T and the flow U, V, W through delta^order; with ``delta`` the certified numbers at that local strength.

    ``law`` as in ``expand``; ``delta`` is a number, or a list of one for each term.  InputError for what cannot be
    read, LimitError with the estimate, UndecidedError where balls cannot decide.
    """
    D = exact_integer(digits, "digits", 1, MAX_DIGITS)
    require_flag(exact, "exact")
    terms, _, _, notes = terms_of(law, spring)
    if delta is None:
        # The coefficients depend on the exponents alone: strengths that were given with the law are not used.
        found = half_swing_coefficients(terms, exact_integer(order, "order", 1, MAX_ORDER), D, exact_only=exact)
        return replace(found, notes=notes)
    if exact:
        raise InputError("exact", "cannot be combined with delta", "delta alone: certified digits")
    given = delta if isinstance(delta, list | tuple) else [delta]
    notes = (*notes, *(note for d in given for note in float_notes(delta=d)))
    at = half_swing_of_terms(terms, [exact_number(d, "delta") for d in given], D)
    return replace(at, notes=notes)
