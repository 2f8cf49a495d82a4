"""A formula as MathML in which bars close, primes are signs and functions stand apart."""

import re

from asymptotics.present.mathml import to_mathml

SET = {
    '<mo stretchy="false">&#x0007C;</mo>': '<mo stretchy="false" lspace="0" rspace="0">&#x0007C;</mo>',
    "<mi>&#x02032;</mi>": "<mo>&#x02032;</mo>",
}

SPACE = '<mspace width="0.167em"/>'
FUNCTION = re.compile(r"(<msu[bp]>)?<mi>(sin|cos|tan|cot|ln|log|exp|arctan)</mi>(?!\s*<mo[^>]*>(?:\(|&#x00028;))")


def _apart(match):
    """A function with a thin space before it, and behind it unless it carries a power or an index."""
    after = "" if match[1] else SPACE
    return f"{match[1] or ''}<mrow>{SPACE}<mi>{match[2]}</mi>{after}</mrow>"


def well_set(latex, *, display):
    formula = to_mathml(latex, display=display)
    for plain, better in SET.items():
        formula = formula.replace(plain, better)
    return FUNCTION.sub(_apart, formula)
