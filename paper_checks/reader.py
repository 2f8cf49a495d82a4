r"""The printed LaTeX tied to the form: a small reader for the formulas of the papers, and a ledger for the rest.

>>> u = sympy.Symbol("u_0", positive=True)
>>> tie(r"u_f = u_0 - \frac{\ln(2u_0+1)}{2}", u - sympy.log(2 * u + 1) / 2, "smith2012:46c")
<Tie.WHOLE: 'wholly read'>
>>> tie(r"u_f = u_0 - \frac{\ln(3u_0+1)}{2}", u - sympy.log(2 * u + 1) / 2, "smith2012:46c")
<Tie.BROKEN: 'contradicted'>
>>> tie(r"u_g = u_0 - \frac{\ln(2u_0+1)}{2}", u - sympy.log(2 * u + 1) / 2, "smith2012:46c")
<Tie.PART: 'read in part'>

A formula is *read in part* if each expression of the form is identically one of its members, read; ``readings`` says
which letters stand for what.  It is *wholly read* if moreover nothing is left over: ``members`` says what stands beside
the form.  What the reader does not know (sums over components, forms that are a sign or an interval, words) has been
compared by hand, twice, and is listed in ``compared.json``.  For every statement, read or not, that ledger has a digest
of all that is shown (LaTeX, title, conditions, notes, methods, near misses in words) and of the forms, written by
``python -m paper_checks --compared`` after the comparison: until they are compared again, a change of any of them fails
the test, and the run of the check reports the statement as open.  The numbers in notes are computed as well, in
``quoted``.
"""

import hashlib
import inspect
import json
import re
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from enum import StrEnum
from functools import cache
from pathlib import Path
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from paper_checks.displays import Display, displays_of
from paper_checks.forms import DECIMAL
from paper_checks.grammar import HYPERGEOMETRIC, MARK, UnreadableError, read
from paper_checks.identities import vanishes
from paper_checks.members import MEMBERS, Members
from paper_checks.near_misses import LEFT, WORDS
from paper_checks.readings import READINGS, Reading
from paper_checks.registry import FOLLOW_UPS, IDENTIFIERS, PAPERS, Statement
from paper_checks.verdict import Outcome

LEDGER = Path(__file__).parent / "compared.json"
GAMMA, SPEED, OMEGA = sympy.symbols("gamma v omega", positive=True)
W, ZERO = GAMMA * SPEED / OMEGA, sympy.S.Zero  # the variable of the polynomials (60)


CORRECTED = " corrected"  # after the id: the formula that is true instead


class Tie(StrEnum):
    """How far the reader ties a printed formula to its form."""

    WHOLE = "wholly read"
    PART = "read in part"
    NONE = "not read"
    BROKEN = "contradicted"


def tie(latex: str, form: Any, key: str = "") -> Tie:
    """How far the printed formula is tied to the form.

    PART: every expression and number of the form is one of its members.  WHOLE: moreover every member, every limit of
    an integral or a sum, every relation sign and every word is accounted for, by the form or by the reading.
    """
    reading = _of(READINGS, key, Reading())
    wanted = _expressions(form, reading.parts)
    if not wanted and isinstance(form, int | sympy.Rational if reading.unit else sympy.Rational):
        wanted = [sympy.Rational(form)]
    texts = _texts(tuple(form[i] for i in reading.parts) if reading.parts and isinstance(form, tuple) else form)
    if not wanted and not texts:
        return Tie.NONE
    if not all(re.search(rf"(?<![\d.]){re.escape(text)}(?![\d.])", latex) for text in texts):
        return Tie.BROKEN
    symbols = {reading.name(s): s for part in wanted for s in part.free_symbols}
    found = _all_read(latex, key, reading, symbols)
    missing = [part for part in wanted if not any(_equal(part, value) for value in found)]
    if missing:
        told = any(part.free_symbols == value.free_symbols for part in missing for value in found)
        return Tie.BROKEN if told else Tie.NONE
    return Tie.PART if unaccounted(latex, wanted, texts, key) else Tie.WHOLE


def _of(table: dict[str, Any], key: str, default: Any) -> Any:
    """What a table says of a formula; of a corrected one what it says of the printed one, if nothing else."""
    return table.get(key, table.get(key.removesuffix(CORRECTED), default))


def tied(latex: str, form: Any, key: str = "") -> bool:
    """Whether the printed formula holds every expression and number of the form.

    >>> x = sympy.Symbol("x", positive=True)
    >>> tied("F = 2x", 2 * x), tied("F = 3x", 2 * x), tie("F = 2x", 2 * x)
    (True, False, <Tie.PART: 'read in part'>)
    """
    return tie(latex, form, key) in (Tie.WHOLE, Tie.PART)


def unaccounted(latex: str, wanted: list[sympy.Expr], texts: list[str], key: str) -> list[str]:
    """What a formula has beside the expressions and numbers of its form and its MEMBERS, or what it lacks of these."""
    reading, members = _of(READINGS, key, Reading()), _of(MEMBERS, key, Members())
    letters = _Letters({reading.name(s): s for part in wanted for s in part.free_symbols})
    unit = read(reading.unit, letters) if reading.unit else sympy.S.One
    displays = list(displays_of(latex, key, reading))
    if members.display:
        models = [model for line in members.display for model in displays_of(line, "", Reading())]
        return _apart(displays, models, _Sides(letters, unit, wanted, texts))
    also = [read(member, letters) for member in members.also]
    left, used = [], set()
    for parts, signs in displays:
        for member in filter(None, (text for text, _ in parts)):
            for part in _parts(member, letters):
                same = [k for k in (*wanted, *also) if _equal(k, part) or _equal(k, sympy.expand(part / unit))]
                left += [] if same or member in texts else [str(part)]
                used |= set(same)
        beside = [piece for _, pieces in parts for piece in pieces]
        said, found = Counter(members.beside), Counter(beside)
        left += list((found - said) + (said - found)) + [sign for sign in signs if sign != "="]
        left += [piece for piece in beside if piece.startswith(("&", ",&"))]  # the conditions of cases: in order
    return left + [str(value) for value in also if value not in used]


@dataclass(frozen=True)
class _Sides:
    """What the members of a display are compared with."""

    letters: dict[str, sympy.Symbol]
    unit: sympy.Expr
    wanted: list[sympy.Expr]
    texts: list[str]

    def hold(self, member: str, model: str) -> bool:
        """Whether a member is the model; ``#12`` are the first and the second expression of the form."""
        if model == "#":
            return member in self.texts
        found = _parts(member, self.letters)
        if model.startswith("#"):
            asked = [self.wanted[int(digit) - 1] for digit in model[1:]]
            found = (
                found
                if any(_equal(a, f) for a, f in zip(asked, found))
                else [sympy.expand(f / self.unit) for f in found]
            )
            return len(asked) == len(found) and all(map(_equal, asked, found))
        asked = _parts(model, self.letters)
        return len(asked) == len(found) and all(map(_equal, asked, found))


def _apart(displays: list[Display], models: list[Display], sides: _Sides) -> list[str]:
    """Where the chains of members and signs differ from those that are expected, in their order."""
    left = [] if len(displays) == len(models) else ["another number of displays"]
    for (parts, signs), (expected, wanted_signs) in zip(displays, models):
        left += [] if signs == wanted_signs else [f"{signs} for {wanted_signs}"]
        for (member, beside), (model, pieces) in zip(parts, expected):
            left += [] if beside == pieces else [f"{beside} for {pieces}"]
            left += [] if member == model == "" or sides.hold(member, model) else [member]
    return left


def _parts(member: str, letters: dict[str, sympy.Symbol]) -> list[sympy.Expr]:
    """A member, read and split at a mark; what cannot be read is a letter of its own."""
    try:
        return _components(read(member, letters))
    except UnreadableError:
        return [sympy.Symbol(member.replace(" ", ""))]


def _components(value: sympy.Expr) -> list[sympy.Expr]:
    """What stands beside a mark, and what is multiplied by it."""
    if not value.has(MARK):
        return [value]
    value = sympy.expand(value)
    return [part for part in (value.coeff(MARK, 0), value.coeff(MARK, 1)) if part not in (0, 1)]


def _equal(part: sympy.Expr, value: sympy.Expr) -> bool:
    try:
        return part == value or part.free_symbols == value.free_symbols and vanishes(value - part) == Outcome.CONFIRMED
    except (TypeError, ValueError):  # nothing of this kind has an enclosure, or a value
        return False


def _expressions(form: Any, parts: tuple[int, ...]) -> list[sympy.Expr]:
    """The expressions of a form, functions written as letters; a polynomial given as {power: coefficient} as one."""
    if isinstance(form, tuple) and len(form) == 2 and isinstance(form[1], dict):
        return [sum((sympy.Rational(c.numerator, c.denominator) * W**power for power, c in form[1].items()), ZERO)]
    if isinstance(form, tuple):
        chosen = [form[i] for i in parts] if parts else form
        return [expression for part in chosen for expression in _expressions(part, ())]
    return [_plain(form)] if isinstance(form, sympy.Expr) and not form.is_Number else []


def _plain(form: sympy.Expr) -> sympy.Expr:
    """v(x) as v, its derivative as v_x; f(n) and its derivative df(n) as f_n and g_n; 2F1 as it is."""
    functions = {f for f in form.atoms(AppliedUndef) if f.func != HYPERGEOMETRIC}
    indexed = {"f": "f", "df": "g"}
    letters = {d: _letter_of(f"{d.expr.func}_{d.variables[0]}") for d in form.atoms(sympy.Derivative)}
    for function in functions:
        name = str(function.func)
        index = str(function.args[0]).replace(" ", "")
        by_index = name in indexed and len(function.args) == 1
        letters[function] = _letter_of(f"{indexed[name]}_{index}" if by_index else name)
    return form.subs(letters) if letters else form


def _letter_of(name: str) -> sympy.Symbol:
    return sympy.Symbol(name, positive=True)


def _texts(form: Any) -> list[str]:
    """The printed numbers in a form."""
    if isinstance(form, tuple):
        return [text for part in form for text in _texts(part)]
    return [form] if isinstance(form, str) and DECIMAL.fullmatch(form) else []


def _all_read(latex: str, key: str, reading: Reading, symbols: dict[str, sympy.Symbol]) -> list[sympy.Expr]:
    """The values of all members that can be read: both signs of a double sign, all cases, with and without a mark."""
    letters = dict(symbols)
    unit = sympy.S.One
    if reading.unit:
        letters = _Letters(symbols)
        unit = read(reading.unit, letters)
    found: list[sympy.Expr] = []
    for members in _members(latex, key, reading):
        for member in members:
            try:
                value = sympy.expand(read(member, letters) / unit) if reading.unit else read(member, letters)
            except UnreadableError:
                continue
            rest, beside = value.subs(MARK, 0), sympy.expand(value).coeff(MARK, 1)
            if not value.has(MARK):
                found.append(value)
                continue
            found += [rest, beside] + ([sympy.cancel(-rest / beside)] if "0" in members and beside != 0 else [])
    return found


class _Letters(dict[str, sympy.Symbol]):
    """Known letters, and every other as a letter of its own: v is not the v of a form that is printed as v_1."""

    def __contains__(self, name: object) -> bool:
        return True

    def __missing__(self, name: str) -> sympy.Symbol:
        taken = any(str(symbol) == name for symbol in self.values())
        self[name] = _letter_of(f"{name} in print" if taken else name)
        return self[name]


def _members(latex: str, key: str, reading: Reading) -> Iterator[list[str]]:
    """The members of a formula, once for the upper and once for the lower of its double signs."""
    return ([text for text, _ in parts] for parts, _ in displays_of(latex, key, reading))


def numbered(entry: Statement) -> bool:
    """Whether a statement is a numbered equation."""
    return entry.id.partition(":")[2][0].isdigit()


def how_read(entry: Statement) -> Tie:
    """How far the reader ties the printed and the corrected LaTeX to their forms: the lesser of the two."""
    ties = [tie(entry.latex, entry.printed, entry.id)]
    if entry.corrected_latex is not None:
        ties.append(tie(entry.corrected_latex, entry.corrected, entry.id + CORRECTED))
    return next((t for t in (Tie.BROKEN, Tie.NONE, Tie.PART) if t in ties), Tie.WHOLE)


def digest(entry: Statement) -> str:
    """What was compared by hand: all that is shown of a statement, and its forms."""
    forms = (_said(form) for form in (entry.printed, entry.corrected, entry.near_miss))
    said = (
        entry.latex,
        str(entry.corrected_latex),
        entry.title,
        entry.conditions,
        entry.note,
        entry.slip,
        entry.variables,
        entry.extent,
        f"{entry.digits} {entry.order}",
        WORDS.get(entry.id, ""),
        LEFT.get(entry.id, ""),
        *entry.methods,
    )
    return _digest(*said, *forms)


def references() -> dict[str, str]:
    """Digests of the references to the papers, of their identifiers, and of the later papers that are named."""
    return {
        "papers": _digest(repr(PAPERS)),
        "identifiers": _digest(repr(IDENTIFIERS)),
        "later": _digest(repr(FOLLOW_UPS)),
    }


def _digest(*texts: str) -> str:
    return hashlib.sha256("\n".join(texts).encode()).hexdigest()[:16]


def _said(form: Any) -> str:
    if isinstance(form, tuple):
        return f"({', '.join(map(_said, form))})"
    return inspect.getsource(form) if inspect.isfunction(form) else repr(form)


BY_HAND, REFERENCES = "compared by hand", "references"
SORTS = (Tie.WHOLE, Tie.PART, BY_HAND)


@cache
def ledger() -> dict[str, dict[str, str]]:
    """The digests of what was compared: WHOLE and PART for what the reader ties, BY_HAND for the rest."""
    return dict(json.loads(LEDGER.read_text(encoding="utf-8")))


def compared(entry: Statement) -> bool:
    """Whether a statement stands as it was when LaTeX, text and forms were compared; one of no paper has not been.

    >>> from dataclasses import replace
    >>> from paper_checks.registry import load
    >>> tau = load("lelas2024")["lelas2024:value.tau-a"]
    >>> compared(tau), compared(replace(tau, latex=tau.latex.replace("12.9", "12.8")))
    (True, False)
    """
    known = next((sort[entry.id] for sort in ledger().values() if entry.id in sort), None)
    return known is None or known == digest(entry)


def written(entries: Iterable[Statement]) -> str:
    """The ledger for the statements."""
    known: dict[str, dict[str, str]] = {str(sort): {} for sort in SORTS}
    for entry in entries:
        sort = how_read(entry)
        known[str(sort) if sort in SORTS else BY_HAND][entry.id] = digest(entry)
    known[REFERENCES] = references()
    return json.dumps(known, indent=1) + "\n"
