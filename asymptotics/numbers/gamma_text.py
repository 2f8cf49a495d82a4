r"""Sums of rational multiples of products of Gamma(x)^n, x rational, as SymPy writes them in text and in LaTeX.

SymPy itself is not asked: it takes longer to load than most answers.  Gamma(1/2)^n is a power of pi.  The terms of a
sum stand by value.  SymPy takes doubles for that: where a Gamma is beyond them its order is an accident.

>>> terms = [(fmpq(4, 3), ((HALF, -2),)), (fmpq(1), ((HALF, -1), (fmpq(1, 4), 1)))]
>>> print(text(terms), latex(terms), sep="\n")
4/(3*pi) + gamma(1/4)/sqrt(pi)
\frac{4}{3 \pi} + \frac{\Gamma\left(\frac{1}{4}\right)}{\sqrt{\pi}}
"""

from collections.abc import Callable, Sequence
from typing import NamedTuple

from flint import arb, fmpq

from asymptotics.numbers.context import ctx

Monomial = tuple[tuple[fmpq, int], ...]
"""(x, n) for each Gamma(x)^n, n not 0: pi first, then by x."""
Term = tuple[fmpq, Monomial]
"""A rational factor that is not 0, and what it multiplies."""
HALF = fmpq(1, 2)
"""Where Gamma is the square root of pi."""


class _Style(NamedTuple):
    factor: Callable[[fmpq, fmpq], str]
    quotient: Callable[[str, list[str], bool], str]
    times: str
    minus: str


def text(terms: Sequence[Term]) -> str:
    """The sum as ``str`` of the SymPy expression."""
    return _sum(terms, _Style(_factor, _quotient, "*", "-"))


def latex(terms: Sequence[Term]) -> str:
    """The sum as ``sympy.latex`` of the expression."""
    return _sum(terms, _Style(_latex_factor, lambda above, below, _: _frac(above, " ".join(below)), " ", "- "))


def value(term: Term) -> arb:
    """An enclosure at the current working precision."""
    found = arb(term[0])
    for x, n in term[1]:
        # Of pi itself, and no power of its root, where there is none.
        found *= arb.pi() ** (n // 2) if x == HALF and n % 2 == 0 else arb(x).gamma() ** n
    return found


def _sum(terms: Sequence[Term], style: _Style) -> str:
    found = ""
    for term in _ordered(terms):
        # No space between the sign and a whole number.
        first = "-" if term[0].q == 1 and not term[1] else style.minus
        signs = (" - ", " + ") if found else (first, "")
        found += (signs[0] if term[0] < 0 else signs[1]) + _size(term, style)
    return found or "0"


def _ordered(terms: Sequence[Term]) -> list[Term]:
    """By value; but a positive rational, or pi, stays before a negative multiple of one power."""
    alone = [(q, powers) for q, powers in terms if not powers or (q == 1 and powers == ((HALF, 2),))]
    others = [t for t in terms if t not in alone]
    if len(alone) == len(others) == 1 and alone[0][0] > 0 > others[0][0] and len(others[0][1]) == 1:
        return alone + others
    # 64 bits tell apart whatever doubles do.
    with ctx.workprec(64):
        return sorted(terms, key=lambda term: value(term).mid())


def _size(term: Term, style: _Style) -> str:
    """A term without its sign: what stands above the line, and what stands below it."""
    q, powers = abs(term[0]), [(x, fmpq(n, 2) if x == HALF else fmpq(n)) for x, n in term[1]]
    above = [str(q.p)] * (q.p != 1) + [style.factor(x, n) for x, n in powers if n > 0]
    below = [str(q.q)] * (q.q != 1) + [style.factor(x, -n) for x, n in powers if n < 0]
    product = style.times.join(above) or "1"
    return style.quotient(product, below, term[0] < 0) if below else product


def _factor(x: fmpq, n: fmpq) -> str:
    base = "pi" if x == HALF else f"gamma({x})"
    if n == HALF:
        return f"sqrt({base})"
    return base if n == 1 else f"{base}**{n}" if n.q == 1 else f"{base}**({n})"


def _quotient(above: str, below: list[str], negative: bool) -> str:
    base, power, n = below[0].partition("**")
    # SymPy's product with 1 is the power itself: pi**(-2), but -1/pi**2.
    if above == "1" and len(below) == 1 and power and not negative:
        return f"{base}**(-{n.strip('()')})"
    return f"{above}/{below[0]}" if len(below) == 1 else f"{above}/({'*'.join(below)})"


def _latex_factor(x: fmpq, n: fmpq) -> str:
    if n == HALF:
        return r"\sqrt{\pi}"
    power = "" if n == 1 else f"^{{{_latex_rational(n)}}}"
    return rf"\pi{power}" if x == HALF else rf"\Gamma{power}\left({_latex_rational(x)}\right)"


def _latex_rational(q: fmpq) -> str:
    return str(q) if q.q == 1 else _frac(str(q.p), str(q.q))


def _frac(above: str, below: str) -> str:
    return rf"\frac{{{above}}}{{{below}}}"
