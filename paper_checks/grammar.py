r"""The grammar of the printed formulas: sums, products, powers, fractions, roots and functions of declared letters.

>>> u = sympy.Symbol("u_0", positive=True)
>>> read(r"u_0 - \frac{\ln(2u_0+1)}{2}", {"u_0": u})
u_0 - log(2*u_0 + 1)/2
"""

import re

import sympy

TOKEN = re.compile(r"\\tan\^\{-1\}|\\[A-Za-z]+'?|\\.|[0-9]+(?:\.[0-9]+)?|[A-Za-z]'?|\S")
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
    r"\Gamma": sympy.gamma,
}
HYPERGEOMETRIC = sympy.Function("F", positive=True)  # 2F1 of its four arguments, of which no value is taken
CLOSING = {"(": ")", "[": "]", "{": "}"}


class UnreadableError(ValueError):
    """The reader does not know this notation."""


def read(latex: str, symbols: dict[str, sympy.Symbol]) -> sympy.Expr:
    """The expression in these symbols; UnreadableError if the notation or a letter is not known."""
    latex = latex.replace("(t)", "").replace(r"\dot{x}", "v").strip().rstrip(",.")
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
    if head[0].isdigit():
        return sympy.Rational(head), rest
    if head == r"\pi":
        return sympy.pi, rest
    if head == r"\int":
        return MARK, rest
    if head == r"\B":
        first, rest = _argument(rest, symbols)
        second, rest = _argument(rest, symbols)
        return sympy.gamma(first) * sympy.gamma(second) / sympy.gamma(first + second), rest
    if head == r"\hyper":
        given = []
        for _ in range(4):
            argument, rest = _argument(rest, symbols)
            given.append(argument)
        return HYPERGEOMETRIC(*given), rest
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
