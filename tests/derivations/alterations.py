"""Structural alterations of a displayed expression: a sign, a factor, an exponent, a function, a number, a bound."""

from collections.abc import Iterator

import sympy

from derivations.steps import At, Coefficient, Solution, Taylor
from derivations.waiting import is_name

OTHER = {
    sympy.sin: sympy.cos,
    sympy.cos: sympy.sin,
    sympy.exp: lambda x: sympy.exp(-x),
    sympy.log: lambda x: sympy.log(x) + 1,
    sympy.gamma: lambda x: sympy.gamma(x + 1),
}
OPEN = {  # which arguments of an object that waits may be altered; all of any other's
    At: (0, 2),
    sympy.Subs: (0,),
    sympy.Derivative: (0,),
    sympy.Limit: (0,),
    Taylor: (0,),
    Coefficient: (0, 2),
    Solution: (0, 1),
}


def altered(node: sympy.Basic) -> Iterator[sympy.Basic]:
    """All expressions that differ from ``node`` at one place."""
    yield from _here(node)
    if is_name(node):
        return
    for place in OPEN.get(type(node), range(len(node.args))):
        if isinstance(node, sympy.Integral | sympy.Sum) and place > 0:
            others = _bounds(node.args[place])
        elif isinstance(node, sympy.Derivative) and place > 0:
            continue
        else:
            others = altered(node.args[place])
        for other in others:
            yield node.func(*node.args[:place], other, *node.args[place + 1 :])


def _bounds(limits: sympy.Tuple) -> Iterator[sympy.Basic]:
    letter, *ends = limits
    for k, end in enumerate(ends):
        for other in altered(end):
            yield sympy.Tuple(letter, *ends[:k], other, *ends[k + 1 :])


def _here(node: sympy.Basic) -> Iterator[sympy.Basic]:
    """The alterations of a node itself."""
    if isinstance(node, sympy.Add | sympy.Mul):
        inverse = (lambda x: -x) if isinstance(node, sympy.Add) else (lambda x: 1 / x)
        for k, part in enumerate(node.args):
            rest = node.args[:k] + node.args[k + 1 :]
            yield node.func(*rest)
            if part != -1:
                yield node.func(*rest, inverse(part))
    elif isinstance(node, sympy.Pow):
        yield node.base ** (node.exp + 1)
    elif isinstance(node, sympy.Number):
        yield node + 1
    elif isinstance(node, sympy.Symbol) or is_name(node):
        yield 2 * node
    elif node.func in OTHER:
        yield OTHER[node.func](node.args[0])
