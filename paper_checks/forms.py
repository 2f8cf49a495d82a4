"""What a form must be before a check may look at it: finite, not empty, and of the shape of the statement's own forms.

A check answers for every form it is given, a corrupted one included.  ``not a == a`` is how NaN passes a comparison,
``all(())`` how an empty form passes a list of conditions; so both are refused here, once, for all checks.

>>> import sympy
>>> x = sympy.Symbol("x")
>>> defect(sympy.nan, [x]), defect((), [(1, 2)]), defect((1,), [(1, 2)]), defect("0", ["0.12"]), defect(2 * x, [x])
('not finite', 'empty', 'of another shape', 'another number of decimals', None)
"""

import re
from collections.abc import Iterable
from functools import wraps
from math import isfinite
from numbers import Real
from typing import Any

import sympy

from asymptotics.verdict import Outcome

DECIMAL = re.compile(r"[+-]?\d+(?:\.(\d+))?")
INFINITE = (sympy.oo, -sympy.oo, sympy.zoo)


def guarded(check: Any, own: Iterable[Any]) -> Any:
    """The check, answering REFUTED by itself for a form that has a defect beside the statement's ``own`` forms."""
    models = list(own)

    @wraps(check)
    def checked(form: Any) -> Outcome:
        return check(form) if defect(form, models) is None else Outcome.REFUTED

    return checked


def defect(form: Any, own: Iterable[Any]) -> str | None:
    """Why ``form`` cannot be a form of a statement whose forms are ``own``; None if it can."""
    models = list(own)
    if any(form is model for model in models):
        return None
    if not _finite(form, infinite=any(_infinite(model) for model in models)):
        return "not finite"
    if _size(form) == 0 and all(_size(model) != 0 for model in models):
        return "empty"
    if not any(_alike(form, model) for model in models):
        return "of another shape"
    places = {n for model in models for n in _decimals(model)}
    return None if set(_decimals(form)) <= places else "another number of decimals"


def _finite(form: Any, *, infinite: bool) -> bool:
    if isinstance(form, dict):
        return all(_finite(value, infinite=infinite) for value in form.values())
    if isinstance(form, tuple):
        return all(_finite(part, infinite=infinite) for part in form)
    if isinstance(form, sympy.Basic):
        return not form.has(sympy.nan, sympy.zoo) and (infinite or not form.has(*INFINITE))
    return not isinstance(form, Real) or isfinite(form)


def _infinite(form: Any) -> bool:
    parts = form.values() if isinstance(form, dict) else form if isinstance(form, tuple) else (form,)
    return any(isinstance(part, sympy.Basic) and part.has(*INFINITE) for part in parts)


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
    for kind, types in (("text", str), ("value", (Real, sympy.Basic)), ("tuple", tuple), ("dict", dict)):
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
