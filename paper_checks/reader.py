r"""The printed LaTeX tied to the form: a small reader for the formulas of the papers, and a ledger for the rest.

>>> import sympy
>>> u = sympy.Symbol("u_0", positive=True)
>>> read(r"u_0 - \frac{\ln(2u_0+1)}{2}", {"u_0": u})
u_0 - log(2*u_0 + 1)/2
>>> tied(r"u_f = u_0 - \frac{\ln(2u_0+1)}{2}", u - sympy.log(2 * u + 1) / 2)
True
>>> tied(r"u_f = u_0 - \frac{\ln(3u_0+1)}{2}", u - sympy.log(2 * u + 1) / 2)
False

A formula is tied if one of its members, read, is identically the form.  What the reader does not know (sums, cases,
integrals, forms that are a sign or a number) has been compared by hand, twice.  For every numbered equation, read or
not, ``compared.json`` has a digest of LaTeX and form, written by ``python -m paper_checks --compared`` after that
comparison: a change of either fails the test until they are compared again.
"""

import hashlib
import inspect
import json
import re
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import sympy

from asymptotics.verdict import Outcome
from paper_checks.identities import vanishes
from paper_checks.registry import Statement

LEDGER = Path(__file__).parent / "compared.json"
TOKEN = re.compile(r"\\tan\^\{-1\}|\\[A-Za-z]+|\\.|[0-9]+|[A-Za-z]'?|\S")
MEMBERS = re.compile(r"\\simeq|\\ll|\\propto|=")
IGNORED = {r"\left", r"\right", r"\,", r"\quad", r"\qquad", r"\;", r"\ "}
FUNCTIONS = {r"\sin": sympy.sin, r"\cos": sympy.cos, r"\ln": sympy.log, r"\tan^{-1}": sympy.atan, r"\exp": sympy.exp}
SAME = {"M": "m", "E": "E_n", "K": "kappa", "fdot": "f'"}  # names of letters in the code and in print
GAMMA, SPEED, OMEGA = sympy.symbols("gamma v omega", positive=True)
W, ZERO = GAMMA * SPEED / OMEGA, sympy.S.Zero  # the variable of the polynomials (60)
CLOSING = {"(": ")", "[": "]", "{": "}"}


class UnreadableError(ValueError):
    """The reader does not know this notation."""


def tied(latex: str, form: Any) -> bool | None:
    """Whether a member of the printed formula is the form; None if none of them can be read."""
    if isinstance(form, tuple) and len(form) == 2 and isinstance(form[1], dict):
        form = sum((sympy.Rational(c.numerator, c.denominator) * W**power for power, c in form[1].items()), ZERO)
    if isinstance(form, tuple) and form and all(isinstance(part, sympy.Expr) for part in form):
        answers = [tied(latex, part) for part in form]
        return None if None in answers else all(answers)
    if not isinstance(form, sympy.Expr):
        return None
    symbols = {SAME.get(str(symbol), str(symbol)): symbol for symbol in form.free_symbols}
    found: bool | None = None
    for member in MEMBERS.split(latex):
        try:
            value = read(member, symbols)
        except UnreadableError:
            continue
        if value.free_symbols == form.free_symbols:
            found = bool(found) or vanishes(value - form) == Outcome.CONFIRMED
    return found


def read(latex: str, symbols: dict[str, sympy.Symbol]) -> sympy.Expr:
    """The expression in these symbols; UnreadableError if the notation or a letter is not known."""
    latex = latex.replace("(t)", "").replace(r"\dot{x}", "v").replace(r"\hat", "").strip().rstrip(",.")
    tokens = [token for token in TOKEN.findall(latex) if token not in IGNORED]
    value, rest = _sum(tokens, symbols)
    if rest:
        raise UnreadableError(rest[0])
    return value


Read = tuple[sympy.Expr, list[str]]


def _sum(tokens: list[str], symbols: dict[str, sympy.Symbol]) -> Read:
    total, sign = sympy.S.Zero, 1
    while True:
        if tokens[:1] in (["+"], ["-"]):
            sign, tokens = (-1 if tokens[0] == "-" else 1), tokens[1:]
        term, tokens = _product(tokens, symbols)
        total += sign * term
        if tokens[:1] not in (["+"], ["-"]):
            return total, tokens


def _product(tokens: list[str], symbols: dict[str, sympy.Symbol]) -> Read:
    total, tokens = _power(tokens, symbols)
    while tokens and tokens[0] not in ("+", "-", ")", "]", "}"):
        if tokens[0] == "/":
            factor, tokens = _power(tokens[1:], symbols)
            total /= factor
        else:
            factor, tokens = _power(tokens, symbols)
            total *= factor
    return total, tokens


def _power(tokens: list[str], symbols: dict[str, sympy.Symbol]) -> Read:
    base, tokens = _atom(tokens, symbols)
    if tokens[:1] == ["^"]:
        exponent, tokens = _argument(tokens[1:], symbols)
        return base**exponent, tokens
    return base, tokens


def _argument(tokens: list[str], symbols: dict[str, sympy.Symbol]) -> Read:
    """What stands after ^ or a command: a group, or one sign."""
    if tokens[:1] == ["{"]:
        return _group(tokens, symbols)
    if tokens and tokens[0].isdigit():  # x^23 is x^2 times 3
        return sympy.Integer(tokens[0][0]), ([tokens[0][1:]] if tokens[0][1:] else []) + tokens[1:]
    return _atom(tokens, symbols)


def _group(tokens: list[str], symbols: dict[str, sympy.Symbol]) -> Read:
    value, rest = _sum(tokens[1:], symbols)
    if rest[:1] != [CLOSING[tokens[0]]]:
        raise UnreadableError(tokens[0])
    return value, rest[1:]


def _atom(tokens: list[str], symbols: dict[str, sympy.Symbol]) -> Read:
    if not tokens:
        raise UnreadableError("the end")
    head, rest = tokens[0], tokens[1:]
    if head in CLOSING:
        return _group(tokens, symbols)
    if head == r"\frac":
        top, rest = _argument(rest, symbols)
        bottom, rest = _argument(rest, symbols)
        return top / bottom, rest
    if head == r"\sqrt":
        inside, rest = _argument(rest, symbols)
        return sympy.sqrt(inside), rest
    if head in FUNCTIONS:
        return _function(head, rest, symbols)
    if head.isdigit():
        return sympy.Integer(head), rest
    if head == r"\pi":
        return sympy.pi, rest
    if head == "e" and rest[:1] == ["^"]:
        exponent, rest = _argument(rest[1:], symbols)
        return sympy.exp(exponent), rest
    return _letter(head, rest, symbols)


def _function(head: str, rest: list[str], symbols: dict[str, sympy.Symbol]) -> Read:
    power = sympy.S.One
    if rest[:1] == ["^"]:
        power, rest = _argument(rest[1:], symbols)
    if rest[:1] and rest[0] in CLOSING:
        inside, rest = _group(rest, symbols)
        return FUNCTIONS[head](inside) ** power, rest
    raise UnreadableError(head)


def _letter(head: str, rest: list[str], symbols: dict[str, sympy.Symbol]) -> Read:
    name = head.lstrip("\\")
    if rest[:1] == ["_"]:
        if len(rest) < 2 or (rest[1] == "{" and "}" not in rest):
            raise UnreadableError(name)
        index = rest[1] if rest[1] != "{" else "".join(rest[2 : rest.index("}")])
        rest = rest[2:] if rest[1] != "{" else rest[rest.index("}") + 1 :]
        name += "_" + index
    if name not in symbols:
        raise UnreadableError(name)
    return symbols[name], rest


def numbered(entry: Statement) -> bool:
    """Whether a statement is a numbered equation."""
    return entry.id.partition(":")[2][0].isdigit()


def read_by_machine(entry: Statement) -> bool:
    """Whether both the printed and the corrected LaTeX are tied to their forms by the reader."""
    pairs = [(entry.latex, entry.printed)]
    if entry.corrected_latex is not None:
        pairs.append((entry.corrected_latex, entry.corrected))
    return all(tied(latex, form) for latex, form in pairs)


def digest(entry: Statement) -> str:
    """What was compared by hand: the two formulas and the two forms."""
    forms = [inspect.getsource(f) if inspect.isfunction(f) else str(f) for f in (entry.printed, entry.corrected)]
    return hashlib.sha256("\n".join([entry.latex, str(entry.corrected_latex), *forms]).encode()).hexdigest()[:16]


def ledger() -> dict[str, str]:
    """The digests of what was compared."""
    return dict(json.loads(LEDGER.read_text(encoding="utf-8")))


def written(entries: Iterable[Statement]) -> str:
    """The ledger for the numbered equations."""
    known = {e.id: digest(e) for e in entries if numbered(e)}
    return json.dumps(known, indent=1) + "\n"
