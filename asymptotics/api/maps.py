"""The half-swing, as series in the local strengths or at given ones, and the cycle that a law of negative damping has.
The half-swing is a return map (Poincare) on the turning points, a limit cycle a fixed point of it in the amplitude.

>>> series = half_swing(2, order=3)
>>> series.log_ratio["1"].exact, series.duration["2"].exact
('-4/3', 'pi/6')
>>> at = half_swing("3/2", delta="1/10", digits=12)
>>> at.amplitude, at.certified
('0.870193291989', True)
>>> van_der_pol = limit_cycle({1: -1, (1, 2): 1}, order=4)
>>> van_der_pol.amplitude["2"].exact, van_der_pol.frequency["2"].exact
('1/96', '-1/16')
"""

from collections.abc import Sequence
from dataclasses import replace

from asymptotics.budget import budget
from asymptotics.errors import InputError, require_flag
from asymptotics.expansions.equations.given import terms_of
from asymptotics.expansions.half_swings.half_swing_value import HalfSwingAt
from asymptotics.expansions.normal_form.coefficients import half_swing_coefficients
from asymptotics.expansions.normal_form.results import HalfSwingCoefficients
from asymptotics.law import Law, LawLike, SpringLike
from asymptotics.limit_cycles.result import LimitCycle
from asymptotics.limit_cycles.result import limit_cycle as of_law
from asymptotics.numbers.policy import Number, exact_integer, exact_number, exact_seconds, float_notes
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


@public
def limit_cycle(
    law: LawLike,
    *,
    order: int = 8,
    digits: int = 30,
    mu: Number | None = None,
    spring: SpringLike | None = None,
    near: Number | None = None,
    max_seconds: Number = 60,
) -> LimitCycle:
    """Amplitude, frequency and multiplier of the limit cycle of x'' + x + mu (law) = 0 as series in mu.

    With a number ``mu`` also a certified fixed point of the half-swing; beside springs (x^p x'^q, not multiplied by mu)
    that alone.  ``near``: the amplitude of the cycle that is meant.  InputError for a law without a limit cycle, with
    several and no ``near``, or that is no polynomial; LimitError after ``max_seconds``.

    >>> limit_cycle({1: -1, (1, 2): 1}, mu=1, spring={3: "1/2"}, digits=12).at.amplitude
    '1.95363409607'
    """
    # mu multiplies the losses alone, so that springs must not be read as part of what grows with it.
    made = Law.read(law) if spring is None else Law(Law.read(law), spring)
    N, D = exact_integer(order, "order", 1, MAX_ORDER), exact_integer(digits, "digits", 1, MAX_DIGITS)
    place = None if near is None else exact_number(near, "near")
    if place is not None and not place > 0:
        raise InputError("near", f"{place} is not positive", "an amplitude > 0")
    number = None if mu is None else exact_number(mu, "mu")
    with budget(exact_seconds(max_seconds)):
        # ``near`` only chooses among cycles that are then proved: a double is enough.
        return of_law(made, N, D, number, None if place is None else float(place.ball()))
