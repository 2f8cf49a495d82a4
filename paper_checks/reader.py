r"""The printed LaTeX tied to the form: a small reader for the formulas of the papers, and a ledger for the rest.

>>> import sympy
>>> u = sympy.Symbol("u_0", positive=True)
>>> read(r"u_0 - \frac{\ln(2u_0+1)}{2}", {"u_0": u})
u_0 - log(2*u_0 + 1)/2
>>> tied(r"u_f = u_0 - \frac{\ln(2u_0+1)}{2}", u - sympy.log(2 * u + 1) / 2)
True
>>> tied(r"u_f = u_0 - \frac{\ln(3u_0+1)}{2}", u - sympy.log(2 * u + 1) / 2)
False

A formula is tied if each expression of the form is identically one of its members, read; ``readings`` says which
letters stand for what.  What the reader does not know (sums over components, forms that are a sign or an interval) has
been compared by hand, twice, and is listed in ``compared.json``.  For every numbered equation, read or not, that ledger
has a digest of LaTeX and form, written by ``python -m paper_checks --compared`` after the comparison: a change of
either fails the test until they are compared again.
"""

import hashlib
import inspect
import json
import re
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from asymptotics.verdict import Outcome
from paper_checks.forms import DECIMAL
from paper_checks.identities import vanishes
from paper_checks.readings import PAPERS, READINGS, Reading
from paper_checks.registry import Statement

LEDGER = Path(__file__).parent / "compared.json"
TOKEN = re.compile(r"\\tan\^\{-1\}|\\[A-Za-z]+'?|\\.|[0-9]+|[A-Za-z]'?|\S")
MEMBERS = re.compile(r"\\simeq|\\approx|\\sim|\\ll|\\gg|\\propto|\\ge|\\to|[=<>]")
MODULUS = re.compile(r"\|([^|]+)\|")
LIMITS = re.compile(
    r"\\int(?:_\{[^{}]*(?:\{[^{}]*\})?[^{}]*\}|_[a-z0-9])?(?:\^\{[^{}]*(?:\{[^{}]*\})?[^{}]*\}|\^[a-z0-9])?"
)
BOUNDARY = re.compile(r"(?:\\Big\||\\bigg\||\\right\|)_\{[^{}]*\}\^(?:\{[^{}]*\}|[a-z])|\\left\.")
WORDS = re.compile(r"\\text\{[^{}]*\}")
TAIL = re.compile(r",? *\\qquad.*|, \\quad.*")
ARROW = re.compile(r"\\xrightarrow\{(.*?) \\gg 1\}")
BETA = re.compile(r"B\\left[(\[](.*?),(.*?)\\right[)\]]")
MARK = sympy.Symbol("mark", positive=True)  # stands for an integral sign, or what a reading puts in its place
IGNORED = {r"\left", r"\right", r"\,", r"\quad", r"\qquad", r"\;", r"\ "}
FUNCTIONS = {
    r"\sgn": sympy.sign,
    r"\abs": sympy.Abs,
    r"\sin": sympy.sin,
    r"\cos": sympy.cos,
    r"\ln": sympy.log,
    r"\tan^{-1}": sympy.atan,
    r"\exp": sympy.exp,
}
SAME = {"M": "m", "E": "E_n", "K": "kappa", "fdot": "f'"}  # names of letters in the code and in print
GAMMA, SPEED, OMEGA = sympy.symbols("gamma v omega", positive=True)
W, ZERO = GAMMA * SPEED / OMEGA, sympy.S.Zero  # the variable of the polynomials (60)
CLOSING = {"(": ")", "[": "]", "{": "}"}


class UnreadableError(ValueError):
    """The reader does not know this notation."""


def tied(latex: str, form: Any, key: str = "") -> bool | None:
    """Whether the printed formula holds every expression and number of the form; None if that cannot be told."""
    reading = READINGS.get(key, Reading())
    wanted = _expressions(form, reading.parts)
    if not wanted and isinstance(form, int | sympy.Number if reading.unit else sympy.Number):
        wanted = [sympy.Rational(form)]
    texts = _texts(form)
    if not wanted and not texts:
        return None
    if not all(re.search(rf"(?<![\d.]){re.escape(text)}(?![\d.])", latex) for text in texts):
        return False
    letters = {s for part in wanted for s in part.free_symbols}
    symbols = {SAME.get(str(s), str(s)): s for s in letters}
    found = _all_read(latex, key, reading, symbols)
    missing = [part for part in wanted if not any(_equal(part, value) for value in found)]
    if not missing:
        return True
    return False if any(part.free_symbols == value.free_symbols for part in missing for value in found) else None


def _equal(part: sympy.Expr, value: sympy.Expr) -> bool:
    try:
        return part.free_symbols == value.free_symbols and vanishes(value - part) == Outcome.CONFIRMED
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
    """v(x) as v, its derivative as v_x; f(n) and its derivative df(n) as f_n and g_n."""
    functions = form.atoms(AppliedUndef)
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
    """Known letters, and every other as a letter of its own."""

    def __contains__(self, name: object) -> bool:
        return True

    def __missing__(self, name: str) -> sympy.Symbol:
        self[name] = _letter_of(name)
        return self[name]


def _members(latex: str, key: str, reading: Reading) -> Iterator[list[str]]:
    """The members of a formula, once for the upper and once for the lower of its double signs."""
    text = MODULUS.sub(r"\\abs{\1}", BOUNDARY.sub("", latex).replace(r"\left|", "|").replace(r"\right|", "|"))
    text = text.replace("(t)", "").replace(r"\mathrm{sgn}", r"\sgn").replace(r"\cdot", "")
    for before, after in (*PAPERS.get(key.partition(":")[0], ()), *reading.letters):
        text = re.sub(" +", " ", text.replace(before, f" {after}"))
    text = ARROW.sub(r"= \1 =", TAIL.sub("", LIMITS.sub(r"\\int ", WORDS.sub("=", text))))
    text = BETA.sub(r"\\B{\1}{\2}", text)
    text = re.sub(r"\\begin\{cases\}|\\end\{cases\}|\\\\", "=", re.sub(r",? *&.*?(?=\\\\|\\end)", "", text))
    for upper, lower in (("-", "+"), ("+", "-")):
        signed = text.replace(r"\mp", upper).replace(r"\pm", lower)
        yield [member.strip().rstrip(",;") for member in MEMBERS.split(signed)]


def read(latex: str, symbols: dict[str, sympy.Symbol]) -> sympy.Expr:
    """The expression in these symbols; UnreadableError if the notation or a letter is not known."""
    latex = latex.replace("(t)", "").replace(r"\dot{x}", "v").replace(r"\hat{S}", "S").strip().rstrip(",.")
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
    if tokens[:2] == ["!", "!"]:
        base, tokens = sympy.factorial2(base), tokens[2:]
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
    if head == r"\int":
        return MARK, rest
    if head == r"\B":
        first, rest = _argument(rest, symbols)
        second, rest = _argument(rest, symbols)
        return sympy.gamma(first) * sympy.gamma(second) / sympy.gamma(first + second), rest
    if head == "d" and rest and re.fullmatch("[vxt]'?", rest[0]):
        return symbols.get("d" + rest[0], sympy.S.One), rest[1:]
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
    return all(tied(latex, form, entry.id) for latex, form in pairs)


def digest(entry: Statement) -> str:
    """What was compared by hand: the two formulas and the two forms."""
    forms = [inspect.getsource(f) if inspect.isfunction(f) else str(f) for f in (entry.printed, entry.corrected)]
    return hashlib.sha256("\n".join([entry.latex, str(entry.corrected_latex), *forms]).encode()).hexdigest()[:16]


READ, BY_HAND = "read", "compared by hand"


def ledger() -> dict[str, dict[str, str]]:
    """The digests of what was compared, under READ for what the reader ties, under BY_HAND for the rest."""
    return dict(json.loads(LEDGER.read_text(encoding="utf-8")))


def written(entries: Iterable[Statement]) -> str:
    """The ledger for the numbered equations."""
    known: dict[str, dict[str, str]] = {READ: {}, BY_HAND: {}}
    for entry in filter(numbered, entries):
        known[READ if read_by_machine(entry) else BY_HAND][entry.id] = digest(entry)
    return json.dumps(known, indent=1) + "\n"
