r"""LaTeX to MathML, for pages that need no network and no script: as latex2mathml reads it, set as Chromium needs it.

Bars close, primes are signs, functions stand apart from what is before them, and brackets about what is low do not
grow: Chromium leaves about one that may grow the width of its largest size.

>>> mathml("x^2")
'<math ...><msup><mi>x</mi><mn>2</mn></msup></mrow></math>'
>>> mathml("b|v|").count('rspace="0"'), mathml(r"a\cos x")
(2, '...<mi>a</mi><mrow><mspace width="0.167em"/><mi>cos</mi><mspace width="0.167em"/></mrow><mi>x</mi>...')
>>> [mathml(each).count('stretchy="true"') for each in (r"a \cos{\left(\psi \right)}", r"\left(\frac{a}{2}\right)")]
[0, 2]
>>> 'stretchy="false">&#x000AF;' in mathml(r"\bar{x}")    # one letter wide, in every browser
True
>>> [name for name in ("prefix", "postfix") if f'{name}" stretchy="true"' in mathml(r"\big\langle -x\big\rangle/2")]
['prefix', 'postfix']
>>> whole("($x$), or --order".replace("$x$", "<math><mi>x</mi></math>"))
'<span class="whole">(<math><mi>x</mi></math>),</span> or --order'
"""

import re
from collections.abc import Callable
from functools import lru_cache
from importlib import import_module
from typing import Any

from asymptotics.errors import InputError

_BAR = '<mo stretchy="false" lspace="0" rspace="0">&#x0007C;</mo>'
_SET = {
    '<mo stretchy="false">&#x0007C;</mo>': _BAR,
    "<mo>&#x0007C;</mo>": _BAR,  # \lvert, \rvert
    "<mi>&#x0007C;</mi>": _BAR,  # \vert
    "<mi>&#x0007E;</mi>": "<mo>&#x0223C;</mo>",  # \sim is a relation
    "<mo>&#x02026;</mo>": "<mi>&#x02026;</mi>",
    "<mi>&#x02032;</mi>": "<mo>&#x02032;</mo>",
    "<mo>&#x0002F;</mo>": '<mo lspace="0" rspace="0">&#x0002F;</mo>',
    'stretchy="true">&#x000AF;': 'stretchy="false">&#x000AF;',
    "<mo>sign</mo>": "<mi>sign</mi>",  # a function: \\operatorname leaves the room of a sign about it
}
_SPACE = '<mspace width="0.167em"/>'
_NAMES = "sin|cos|tan|cot|ln|log|exp|arctan|sign"
_FUNCTION = re.compile(rf"(<msu[bp]>)?<mi>({_NAMES})</mi>(?!(?:</msu[bp]>)?(?:<mrow>)*<mo[^>]*>(?:\(|&#x00028;))")
_BEFORE_A_CALL = re.compile(rf"(?<=</mi>|</mn>)(?=<mi>(?:{_NAMES})</mi>)|(?<=</msub>|</msup>)(?=<mi>(?:{_NAMES})</mi>)")
_LARGE = re.compile(r'<mo (minsize="[\d.]+em" maxsize="[\d.]+em")>([^<]*)</mo>')
_GROWING = 'stretchy="true" fence="true"'
_SHUT = re.compile(
    rf'<mo {_GROWING} form="prefix">([^<]*)</mo>((?:(?!{_GROWING}).)*?)<mo {_GROWING} form="postfix">([^<]*)</mo>'
)
_TALL = re.compile('<(?:mfrac|msqrt|mroot|munder|mover|munderover|mtable)\\b|stretchy="true"')
_COMMANDS = {r"\langle": "&#x027E8;", r"\rangle": "&#x027E9;", r"\{": "{", r"\}": "}", r"\vert": "|"}
_OPENING = {"(", "[", "{", "&#x027E8;"}
_SIGNED = re.compile(  # behind what leaves nothing to add to: an opening bracket, a relation, a comma
    r"(<mo[^>]*>(?:&#x00028;|&#x0005B;|&#x0007B;|&#x027E8;|[(\[{,=<>]|&#x0003D;|&#x0002C;|&#x02264;|&#x02265;|&#x02248;)</mo>"
    r"(?:<mspace[^>]*>)*)<mo>(&#x02212;|&#x0002B;|&#x000B1;|&#x02213;)</mo>"
)
_WHOLE = re.compile(r"(\(?)(<math\b(?:(?!<math\b).)*?</math>)((?:-th\b|[),.;:?])*)", re.DOTALL)


def _apart(match: re.Match[str]) -> str:
    """A function with a thin space before it, and behind it unless it carries a power or an index."""
    after = "" if match[1] else _SPACE
    return f"{match[1] or ''}<mrow>{_SPACE}<mi>{match[2]}</mi>{after}</mrow>"


def _brackets(formula: str) -> str:
    """Brackets of a size that was asked for: each knows on which side it stands, of bars every second one closes."""
    bars = 0

    def bracket(match: re.Match[str]) -> str:
        nonlocal bars
        sign = _COMMANDS.get(match[2], match[2])
        bars += sign == "|"
        opens = bars % 2 == 1 if sign == "|" else sign in _OPENING
        return f'<mo form="{"prefix" if opens else "postfix"}" stretchy="true" symmetric="true" {match[1]}>{sign}</mo>'

    return _LARGE.sub(bracket, formula)


def _low(formula: str) -> str:
    """Brackets about what is no taller than a letter do not grow: innermost first, those about them after."""

    def pair(match: re.Match[str]) -> str:
        left, inside, right = match.groups()
        kind = f'fence="true" stretchy="{"true" if _TALL.search(inside) else "false"}"'
        return f'<mo {kind} form="prefix">{left}</mo>{inside}<mo {kind} form="postfix">{right}</mo>'

    while _SHUT.search(formula):
        formula = _SHUT.sub(pair, formula)
    return formula


def mathml(latex: str, *, display: bool = False) -> str:
    """The formula as a MathML element; InputError where latex2mathml, of the extra report, is not installed."""
    try:
        convert = import_module("latex2mathml.converter").convert  # an extra, which pages alone need
    except ModuleNotFoundError as error:
        accepted = "an installation with the extra report: pip install '.[report]' in a clone"
        raise InputError("html", "formulas are set by latex2mathml, which is not installed", accepted) from error
    return _typeset(convert, str(latex), "block" if display else "inline")


@lru_cache(maxsize=4096)
def _typeset(convert: Callable[..., Any], latex: str, display: str) -> str:
    formula = str(convert(latex.replace("---", "\N{EM DASH}"), display=display))
    for plain, better in _SET.items():
        formula = formula.replace(plain, better)
    formula = _SIGNED.sub(r'\1<mo form="prefix">\2</mo>', _low(_brackets(formula)))
    return _BEFORE_A_CALL.sub(_SPACE, _FUNCTION.sub(_apart, formula))


def whole(page: str) -> str:
    """The page with each formula in a line and the bracket or punctuation that touches it kept on one line."""
    return _WHOLE.sub(_kept, page)


def _kept(match: re.Match[str]) -> str:
    before, formula, after = match.groups()
    if not before and not after or 'display="block"' in formula[: formula.find(">")]:
        return match[0]
    return f'<span class="whole">{before}{formula}{after}</span>'
