"""Sums as one writes them by hand: signs between the terms, no 1 in front of a power, exact numbers where short.

>>> from sympy import Rational, pi
>>> row = {(1,): Coefficient("0.5", Rational(1, 2)), (3,): Coefficient("-0.01", Rational(-1, 100))}
>>> print(sum_text(row, ("d",)), "or", sum_latex(row, (r"\\delta",)))
1/2 d - 1/100 d^3 or \\frac{1}{2} \\delta - \\frac{1}{100} \\delta^{3}
>>> sum_text({(2,): Coefficient("-0.16666666666666666667", None)}, ("d",), lead="1")
'1 - 0.1666666667 d^2'
"""

from collections.abc import Mapping, Sequence

from asymptotics.numbers.value import Coefficient, rounded
from asymptotics.series import Key

# What is shown; all digits stay in the coefficient.
SHOWN_DIGITS, MAX_DIGITS = 10, 10_000
_LONGEST_EXACT = 24  # a longer exact form hides the equation it stands in


def sum_text(row: Mapping[Key, Coefficient], names: Sequence[str], lead: str = "") -> str:
    """The sum of c times a monomial in ``names``, after ``lead``; "0" when nothing is left."""
    return _joined([(_number(c), _monomial(k, names, "^", "")) for k, c in _ordered(row) if not c.is_zero], lead)


def sum_latex(row: Mapping[Key, Coefficient], names: Sequence[str], lead: str = "", digits: int = SHOWN_DIGITS) -> str:
    """The same in LaTeX."""
    return _joined(
        [(_latex(c, digits), _monomial(k, names, "^{", "}")) for k, c in _ordered(row) if not c.is_zero], lead
    )


def _ordered(row: Mapping[Key, Coefficient]) -> list[tuple[Key, Coefficient]]:
    """By degree, and within one degree the first strength first."""
    return sorted(row.items(), key=lambda item: (sum(item[0]), [-n for n in item[0]]))


def _joined(terms: list[tuple[str, str]], lead: str) -> str:
    text = lead
    for number, power in terms:
        sign, size = ("-", number[1:].lstrip()) if number.startswith("-") else ("+", number)
        term = size if not power else power if size == "1" else f"{size} {power}"
        text += f" {sign} {term}" if text else term if sign == "+" else f"-{term}"
    return text or "0"


def _monomial(key: Key, names: Sequence[str], opened: str, closed: str) -> str:
    return " ".join(name + (f"{opened}{n}{closed}" if n > 1 else "") for name, n in zip(names, key) if n)


def _number(c: Coefficient) -> str:
    exact = c.exact
    if exact is not None and (c.value is None or len(exact) <= _LONGEST_EXACT):
        return f"({exact})" if c.is_sum else exact
    return rounded(c.text(), SHOWN_DIGITS)


def _latex(c: Coefficient, digits: int) -> str:
    exact = c.exact
    if exact is not None and (c.value is None or len(exact) <= _LONGEST_EXACT):
        return rf"\left({c._formula()}\right)" if c.is_sum else c._formula()
    mantissa, e, exponent = rounded(c.text(), digits).partition("e")
    return mantissa + (rf" \cdot 10^{{{int(exponent)}}}" if e else "")
