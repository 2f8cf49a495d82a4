"""How a result shows itself: HTML and LaTeX for notebooks, a few lines of text, rows as a data frame, a picture.

A result type inherits from ``Shown`` and says what is to be shown in ``_page`` (the verdict or value first); its
formula, if it has one, in ``_formula``; its rows of numbers in ``_table``; its curve in ``_draw`` (``present.drawn``).
Everything else is made of these, here and in the same way for all: no symbol is shown that is not defined
(``present.letters``), all text is escaped, and nothing is computed that the result does not already know, but a curve.

>>> class Answer(Shown):
...     def _page(self):
...         return Page("x < 1", ("certified",), ("n", "x"), (("0", "1"),))
...     def _formula(self):
...         return "x_{n}"
>>> Answer()
x < 1
certified
>>> Answer()._repr_html_()
'<div><p><strong>x &lt; 1</strong></p><p>certified</p><table>...</table></div>'
>>> Answer()._repr_latex_()
'$x_{n}$ where $n$: a number that counts; $x$: displacement'
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields, is_dataclass
from importlib import import_module
from typing import Any

from asymptotics.errors import InputError
from asymptotics.present.html import block
from asymptotics.present.letters import defined

# What fits on a screen beside other cells of a notebook; nothing is lost, ``to_dataframe`` and ``to_dict`` have it all.
MAX_LINES, MAX_WIDTH, MAX_ROWS = 8, 160, 12


@dataclass(frozen=True)
class Page:
    """What is shown of a result: ``title`` (verdict or value), ``lines`` of text, a small table under ``head``."""

    title: str
    lines: tuple[str, ...] = ()
    head: tuple[str, ...] = ()
    rows: tuple[tuple[object, ...], ...] = ()


class Shown:
    """A result that shows itself; ``_page`` is all that a type must say."""

    def _page(self) -> Page:
        """By default its text, the first line as the title."""
        first, *rest = str(self).splitlines() or [type(self).__name__]
        return Page(first, tuple(rest))

    def _formula(self) -> str:
        """The formula of the result, LaTeX without dollars; by default its title as text."""
        return rf"\text{{{plain(self._page().title)}}}"

    def _letters(self) -> Mapping[str, str]:
        """What letters mean here, where that is not what they mean everywhere (``present.letters``)."""
        return {}

    def _table(self) -> Mapping[str, Sequence[Any]]:
        """The rows of the result by columns, numbers as numbers; empty for a result without rows."""
        return {}

    def _picture(self) -> str:
        """The picture as an HTML element, or nothing (``present.drawn``)."""
        return ""

    def _repr_html_(self) -> str:
        page = self._page()
        more = (("...", f"{len(page.rows) - MAX_ROWS} more rows: to_dataframe()"),) if len(page.rows) > MAX_ROWS else ()
        return block(page.title, page.lines, page.head, (*page.rows[:MAX_ROWS], *more), self._picture())

    def _repr_latex_(self) -> str:
        formula = self._formula()
        where = defined(formula, self._letters())
        return f"${formula}$" + (f" where {where}" if where else "")

    def __repr__(self) -> str:
        page = self._page()
        lines = [line for line in (page.title, *page.lines) if line]
        shown = [line if len(line) <= MAX_WIDTH else line[: MAX_WIDTH - 4] + " ..." for line in lines[:MAX_LINES]]
        return "\n".join([*shown, *(["..."] if len(lines) > MAX_LINES else [])])


class Rows(Shown):
    """A result that has rows."""

    def to_dataframe(self) -> Any:
        """The rows as a pandas DataFrame: numbers in columns of their own, both ends of an interval, all digits beside.

        InputError where pandas, an extra, is not installed.
        """
        return frame(self._table())


def frame(columns: Mapping[str, Sequence[Any]]) -> Any:
    """A pandas DataFrame; InputError where pandas is not installed."""
    try:
        pandas = import_module("pandas")  # an extra, and slow to load: only data frames need it
    except ModuleNotFoundError as error:  # any other ImportError is a fault, or want of memory
        accepted = "an installation with the extra pandas: pip install '.[pandas]' in a clone"
        raise InputError("pandas", "a data frame needs pandas, which is not installed", accepted) from error
    return pandas.DataFrame(dict(columns))


def fields_of(found: Any, units: Mapping[str, str] | None = None, skip: Sequence[str] = ("notes",)) -> Page:
    """A small record as a page: its name, and a table of what it holds, with units.

    >>> @dataclass
    ... class Point(Shown):
    ...     x: str
    ...     t: str | None
    >>> fields_of(Point("0.1", None), {"x": "m"}).rows
    (('x', '0.1 m'),)
    """
    # Records are dataclasses, or named tuples where they must stay tuples.
    names = [f.name for f in fields(found)] if is_dataclass(found) else list(found._fields)
    given = units or {}
    kept = [(n, getattr(found, n)) for n in names if n not in skip]
    rows = tuple((n, f"{value} {given.get(n, '')}".strip()) for n, value in kept if value is not None)
    return Page(", ".join(f"{n} = {text}" for n, text in rows[:3]), (), ("", "value"), rows)


def plain(text: str) -> str:
    r"""Words inside ``\text{}``: what TeX would read as a command is escaped.

    >>> plain("50 % of a_1")
    '50 \\% of a\\_1'
    """
    # A backslash, ^ and ~ have no short escape within \text{}, and no word of ours needs them: blanks.
    return "".join("\\" + c if c in "#$%&_{}" else " " if c in "\\^~" else c for c in text)
