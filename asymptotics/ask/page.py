"""The page of --html, the same for every question: what was asked, formulas, the answer, its picture, provenance."""

import platform
from collections.abc import Sequence
from typing import Any

from asymptotics import __version__
from asymptotics.ask.answers import Request
from asymptotics.ask.question import Question
from asymptotics.errors import InputError
from asymptotics.law_given import Given
from asymptotics.made_by import line as made_by_line
from asymptotics.present.drawn import Drawn, pictured
from asymptotics.present.html import block
from asymptotics.present.letters import defined
from asymptotics.present.mathml import mathml
from asymptotics.present.page import displayed, figure, page, paragraphs, table, text
from asymptotics.present.shown import Shown
from asymptotics.present.signs import signs


def page_of(question: Question, request: Request, found: Any, words: Sequence[str]) -> str:
    """The page; ``words``: the command as it was typed.  InputError where latex2mathml is not installed."""
    offers = question.offers
    equation = _equation(request) if offers.equation is None else str(offers.equation(found, request))
    formula = offers.formula_of(found, request)
    own = offers.letters(found, request)
    where = "" if own is None else defined(f"{equation} {formula}", own)
    parts = [
        f"<h1>{_in_signs(question.page.partition(chr(10))[0].rstrip(':.'))}</h1>",
        displayed(equation) if equation else "",
        displayed(formula) if formula else "",
        _where(where),
        "<h2>Answer</h2>",
        _answer(question, request, found),
        _picture(question, request, found),
        "<h2>Provenance</h2>",
        table(("", ""), _provenance(words)),
    ]
    return page(f"asymptotics {question.name}", "\n".join(part for part in parts if part))


def _in_signs(words: str) -> str:
    """Text with its mathematics in signs."""
    return signs(text(words))


def _equation(request: Request) -> str:
    """The equation of motion as LaTeX, where the law with its strengths is what was asked about."""
    given = request.values.get("law")
    return given.oscillator._formula() if isinstance(given, Given) else ""


def _where(defined_letters: str) -> str:
    """What the letters mean, each set as it stands in the formula."""
    if not defined_letters:
        return ""
    parts = defined_letters.split("$")  # words and letters in turn
    shown = [mathml(part) if i % 2 else _in_signs(part) for i, part in enumerate(parts)]
    return f'<p class="small">where {"".join(shown)}</p>'


def _answer(question: Question, request: Request, found: Any) -> str:
    """The pages of the results, with all their rows; the text of what shows none."""
    offers = question.offers
    results = offers.shown(found, request)
    if not all(isinstance(result, Shown) for result in results):
        return paragraphs(f"{offers.text(found, request)}\n{offers.besides(found, request)}".splitlines())
    pages = [result._page() for result in results]
    return "\n".join(block(each.title, each.lines, each.head, each.rows) for each in pages)


def _picture(question: Question, request: Request, found: Any) -> str:
    offers = question.offers
    curves = offers.drawn(found, request) if offers.picture else []
    if not curves or not all(isinstance(curve, Drawn) for curve in curves):
        return ""
    try:
        svg = pictured(curves, "svg", **offers.style(found, request)).decode()
    except InputError as error:  # the answer stands without it, and the page says why
        return f"<p>No picture: {text(error.reason)}.</p>"
    return figure(svg, offers.picture)


def _provenance(words: Sequence[str]) -> list[tuple[str, str]]:
    return [
        ("command", " ".join(words)),
        ("program", f"power-law-oscillator {__version__}"),
        ("run by", f"Python {platform.python_version()}"),
        ("made by", made_by_line()),
    ]
