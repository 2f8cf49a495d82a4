"""What a form must be before a check may look at it: finite, not empty, and of the shape of the statement's own forms.

A check answers for every form it is given, a corrupted one included.  ``not a == a`` is how NaN passes a comparison,
``all(())`` how an empty form passes a list of conditions; so both are refused here, once, for all checks.

>>> import sympy
>>> x = sympy.Symbol("x")
>>> defect(sympy.nan, [x]), defect((), [(1, 2)]), defect((1,), [(1, 2)]), defect("0", ["0.12"]), defect(2 * x, [x])
('not finite', 'empty', 'of another shape', 'another number of decimals', None)
"""

import re
from collections.abc import Callable, Iterable
from functools import cache, wraps
from math import isfinite
from numbers import Real
from typing import Any

import sympy
from sympy.core.function import PoleError
from sympy.polys.polyerrors import PolynomialError

from asymptotics.errors import LimitError, UndecidedError
from paper_checks.units import UnitsError
from paper_checks.verdict import Outcome

DECIMAL = re.compile(r"[+-]?\d+(?:\.(\d+))?")
STOPS = (ArithmeticError, AttributeError, LookupError, StopIteration, TypeError, ValueError)
UNABLE = (LimitError, UndecidedError, NotImplementedError, PolynomialError, PoleError)
INFINITE = (sympy.oo, -sympy.oo, sympy.zoo)


def guarded(
    check: Any,
    own: Iterable[Any],
    premises: tuple[int, ...] = (),
    impossible: Callable[[Any], bool] = lambda form: False,
) -> Any:
    """The check, answering REFUTED by itself for a form that has a defect beside the statement's ``own`` forms.

    So is what is ``impossible``: a form of another dimension than the true one.

    A foreign form at which the check cannot even be evaluated (a name that does not exist, a division by zero) is
    refuted as well; one on which a tool gives up (no polynomial, no algorithm) stays UNDECIDED.  With the statement's
    own forms either would be an error in the check, and it is raised; but a value that depends on the units refutes
    any form.
    """
    models = list(own)

    @wraps(check)
    def checked(form: Any) -> Outcome:
        stops: tuple[type[Exception], ...] = STOPS
        unable: tuple[type[Exception], ...] = UNABLE
        if any(form is model for model in models):
            stops, unable = (UnitsError,), ()
        elif defect(form, models, premises) is not None or impossible(form):
            return Outcome.REFUTED
        try:
            return check(form)
        except unable:
            return Outcome.UNDECIDED
        except stops:
            return Outcome.REFUTED

    return checked


def defect(form: Any, own: Iterable[Any], premises: tuple[int, ...] = ()) -> str | None:
    """Why ``form`` cannot be a form of a statement whose forms are ``own``; None if it can."""
    models = list(own)
    allowed = {end for model in models for end in _infinities(model)}
    if not _finite(form, allowed):
        return "not finite"
    if _size(form) == 0 and all(_size(model) != 0 for model in models):
        return "empty"
    if not any(_alike(form, model) for model in models):
        return "of another shape"
    if any(form[i] not in {model[i] for model in models} for i in premises):
        return "about something else"
    places = {n for model in models for n in _decimals(model)}
    return None if set(_decimals(form)) <= places else "another number of decimals"


def _finite(form: Any, allowed: set[Any]) -> bool:
    """No NaN, and no infinity but those that the statement itself speaks of."""
    if isinstance(form, dict):
        return all(_finite(value, allowed) for value in form.values())
    if isinstance(form, tuple):
        return all(_finite(part, allowed) for part in form)
    if isinstance(form, str):
        return form.lower().lstrip("+-") not in ("nan", "inf", "infinity")
    if isinstance(form, sympy.Basic):
        return not form.has(sympy.nan) and set(_infinities(form)) <= allowed
    return not isinstance(form, Real) or isfinite(form)


def _infinities(form: Any) -> Iterable[Any]:
    if isinstance(form, dict | tuple):
        for part in form.values() if isinstance(form, dict) else form:
            yield from _infinities(part)
    elif isinstance(form, sympy.Basic):
        yield from (end for end in INFINITE if form.has(end))


def _size(form: Any) -> int:
    if isinstance(form, tuple | dict | str | sympy.Tuple):
        return len(form)
    return 0 if form is sympy.S.EmptySet else 1


def _alike(form: Any, model: Any) -> bool:
    """Whether two forms are nested alike, numbers and expressions counting as one kind."""
    if isinstance(form, tuple) and isinstance(model, tuple):
        return len(form) == len(model) and all(map(_alike, form, model))
    if isinstance(form, dict) and isinstance(model, dict):
        return form.keys() == model.keys()
    return _kind(form) == _kind(model)


def _kind(form: Any) -> str:
    kinds = (("text", str), ("tuple", tuple | sympy.Tuple), ("value", (Real, sympy.Basic)), ("dict", dict))
    for kind, types in kinds:
        if isinstance(form, types):
            return kind
    return "nothing" if form is None else "rule"


def _decimals(form: Any) -> Iterable[int]:
    """How many decimals each printed number in the form has."""
    if isinstance(form, tuple):
        for part in form:
            yield from _decimals(part)
    elif isinstance(form, str) and (found := DECIMAL.fullmatch(form)):
        yield len(found[1] or "")


_SIGNS = {"dxdv": r"\frac{dx}{dv}", "sine": r"\sin"}  # symbols of the code that stand for more than a letter


@cache
def tex(expression: sympy.Basic) -> str:
    r"""LaTeX in the letters of the papers: a primed Greek letter and eps have their signs, a derivative its fraction.

    >>> tex(sympy.Symbol("alpha'") + sympy.Symbol("eps")), tex(2 * sympy.Symbol("dxdv"))
    ("\\alpha' + \\varepsilon", '2 \\frac{dx}{dv}')
    """
    found = {s: s.name.replace("eps", "varepsilon") for s in expression.free_symbols if re.search("eps$|'$", str(s))}
    names = {s: sympy.latex(sympy.Symbol(n.rstrip("'"))) + "'" * n.count("'") for s, n in found.items()}
    names |= {s: _SIGNS[s.name] for s in expression.free_symbols if s.name in _SIGNS}
    return str(sympy.latex(expression, symbol_names=names))
