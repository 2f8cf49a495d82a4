"""Which letters of a form a check varies: a formula in alpha that is looked at for alpha = 2 alone is not checked.

Each letter of the confirmed form is given to the check with an ear on it (a function that is its argument, and notes
what that is).  A letter that has two values is varied.  For the others the form is frozen: where a check confirms the
form with a number in the place of the letter, it would confirm any formula that agrees there.

>>> import sympy
>>> from paper_checks.identities import vanishes
>>> a, b = sympy.symbols("a b", positive=True)
>>> heard(lambda form: form.subs({a: 2, b: 1}) + form.subs({a: 3, b: 1}), a + b)
{'a': {2, 3}, 'b': {1}}
>>> frozen(lambda form: vanishes(form.subs(a, 2) - 2 * b), a * b)
{'a': 2}
"""

import inspect
from collections.abc import Callable, Iterator
from typing import Any

import sympy

from paper_checks.forms import STOPS, UNABLE
from paper_checks.registry import Statement, confirmed_form
from paper_checks.verdict import Outcome

Values = dict[str, set[Any]]
USUAL = tuple(map(sympy.Rational, ("0", "1/2", "1", "3/2", "2", "3")))  # where a formula is likely to be looked at
_heard: Values = {}


def frozen_letters(entry: Statement) -> dict[str, Any]:
    """The letters that the check of a statement does not vary in the form that it confirms, each with its number."""
    return frozen(inspect.unwrap(entry.check), confirmed_form(entry)) if entry.check else {}


def frozen(check: Callable[[Any], Outcome], form: Any) -> dict[str, Any]:
    """The letters in whose place a number does as well, each with the number."""
    still = {name: values for name, values in heard(check, form).items() if len(values) < 2}
    found = {}
    for symbol in sorted(_symbols(form), key=str):
        for value in dict.fromkeys([*still[str(symbol)], *USUAL]) if str(symbol) in still else ():
            other = _replaced(form, {symbol: sympy.S.Zero + value})
            if other != form and _outcome(check, other) == Outcome.CONFIRMED:
                found[str(symbol)] = value
                break
    return found


def _outcome(check: Callable[[Any], Outcome], form: Any) -> Outcome:
    """What the check says of a form that may be none."""
    try:
        return check(form)
    except (*STOPS, *UNABLE):
        return Outcome.UNDECIDED


def heard(check: Callable[[Any], Any], form: Any) -> Values:
    """The values that each letter of the form has while the check looks at it."""
    _heard.clear()
    _heard.update({str(symbol): set() for symbol in _symbols(form)})
    _outcome(check, _replaced(form, {symbol: _ear(symbol)(symbol) for symbol in _symbols(form)}))
    return {name: set(values) for name, values in sorted(_heard.items())}


def note(name: str, value: Any) -> Any:
    """The value, noted: what a compiled form calls in the place of a letter."""
    _heard.setdefault(name, set()).update([value] if not hasattr(value, "ravel") else value.ravel().tolist())
    return value


def _ear(symbol: sympy.Symbol) -> Any:
    """A function that is its argument, as long as that is no number; each letter of each run has its own."""

    class Ear(sympy.Function):  # type: ignore[misc]
        @classmethod
        def eval(cls, value: sympy.Expr) -> sympy.Expr | None:
            return note(str(symbol), value) if value.is_number else None

        def _eval_is_positive(self) -> bool | None:
            positive = self.args[0].is_positive  # True, False or None: handed on as it is
            return positive  # noqa: RET504 (assigned, so that a walk sees that it stays three-valued)

        def fdiff(self, argindex: int = 1) -> sympy.Expr:
            return sympy.S.One

        def _pythoncode(self, printer: Any) -> str:
            return f"__import__('paper_checks.letters').letters.note({str(symbol)!r}, {printer._print(self.args[0])})"

        _numpycode = _mpmathcode = _pythoncode

    return Ear


def _symbols(form: Any) -> set[sympy.Symbol]:
    if isinstance(form, sympy.Basic):
        return set(form.free_symbols)
    return {symbol for part in _parts(form) for symbol in _symbols(part)}


def _parts(form: Any) -> Iterator[Any]:
    yield from form.values() if isinstance(form, dict) else form if isinstance(form, tuple) else ()


def _replaced(form: Any, others: dict[sympy.Symbol, sympy.Expr]) -> Any:
    if isinstance(form, tuple):
        return tuple(_replaced(part, others) for part in form)
    if isinstance(form, dict):
        return {key: _replaced(part, others) for key, part in form.items()}
    return form.xreplace(others) if isinstance(form, sympy.Basic) else form
