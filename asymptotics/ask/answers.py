"""What an answer offers, declared once: text, JSON, LaTeX, table, picture; what it lacks is refused with the reason.

``Offers`` stands in the declaration of a question.  Each part is a function of the result and of the ``Request``,
which has the values that were read and the options as they were typed.  A part without a function is what the result
itself says: ``str``, ``to_dict``, ``latex``, ``to_csv``, ``plot``.
"""

import argparse
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from asymptotics.ask.kinds import Option
from asymptotics.ask.pairs import Pair, demands, needs, typed_value
from asymptotics.numbers.integers import parse_integer
from asymptotics.present.drawn import KINDS
from asymptotics.present.figures import DPI, SIZE
from asymptotics.present.shown import Shown

MAX_POINTS, DEFAULT_POINTS = 100_000, 1000
"""A thousand rows draw a smooth curve of some twenty periods; the limit is a refusal."""
CERTIFICATE = (
    "a certificate of what is printed: python check_certificate.py FILE proves every digit with nothing but Python (a"
    " half-swing of 20 digits takes 4 to 15 kB, 20 of them 1 s to make and 0.3 s to check; up to 100 digits and 1000"
    " half-swings); the checker is written beside it"
)
# What every question offers or says why not: the options that mean the same everywhere.
COMMON = ("csv", "digits", "gauge", "json", "latex", "plot", "points", "quiet")
FLAGS = ("latex", "json", "quiet")


@dataclass(frozen=True)
class Request:
    """What was asked in the shell: the values that were read, and the options as they were typed."""

    values: Mapping[str, Any]
    options: argparse.Namespace

    def __getitem__(self, name: str) -> Any:
        """A value, by the name of its parameter."""
        return self.values[name]

    def typed(self, name: str) -> Any:
        """An option as it was typed; None where it was not given, or there is none."""
        return typed_value(self.options, name)

    @property
    def has_files(self) -> bool:
        """Whether a picture or a table of a curve is asked for."""
        return any(self.typed(name) is not None for name in ("plot", "csv"))

    @property
    def has_latex(self) -> bool:
        """Whether LaTeX is printed instead of text; ``fragment``: its formulas alone."""
        return any(self.typed(name) is not None for name in ("latex", "fragment"))

    @property
    def points(self) -> int:
        """How many intervals the table of a curve has."""
        return read_points(self.options)


def read_points(options: argparse.Namespace) -> int:
    """The value of --points; InputError outside 1 ... ``MAX_POINTS``."""
    return DEFAULT_POINTS if options.points is None else parse_integer(options.points, "--points", 1, MAX_POINTS)


Part = Callable[[Any, Request], Any]


@dataclass(frozen=True)
class Again:
    """How a table of a question is held against the same question at more digits (``again``).

    ``keys``: columns by which a row is found; ``not_judged``: bounds and remarks, of which more digits say nothing.
    ``at``: the point at which it is asked again; ``rows``: what is right in the place of a row.  Of a sweep: ``judged``
    columns (none: all), and the ``route`` that judges them.  ``exact``: what it says is proved, though no field says
    so.  ``compared``: an own way, of the words of the header, the head, the rows, the digits and the errors that
    columns of doubles may have; ``words``: what such a header has besides the options.
    """

    keys: tuple[str, ...] = ("part", "series", "k", "quantity", "n", "i")
    not_judged: frozenset[str] = frozenset(("remark", "low", "high"))
    at: Callable[[Mapping[str, str], int], dict[str, str]] = lambda point, digits: {**point, "digits": str(digits)}
    rows: Callable[[list[tuple[str, ...]], tuple[str, ...]], list[tuple[str, ...]]] = lambda rows, _: rows
    judged: tuple[str, ...] = ()
    route: str = ""
    exact: bool = False
    compared: Callable[..., Any] | None = None
    words: tuple[str, ...] = ()


@dataclass(frozen=True)
class Offers:
    """The parts of an answer; each function takes the result and the ``Request``.

    ======================  ==========================================================================================
    latex, table, picture   the help of --latex, --csv, --plot; empty where there is none
    curve, overlay          --points chooses the rows; the help of --overlay
    from_rest               the oscillator in the header of a file says the whole request, beside the linear spring
    oscillator_alone        it says all that such a file can be held against, springs and starts too
    always_files            JSON lists the files even where there are none, and they stand below LaTeX too
    own_latex               the data say the LaTeX themselves, or never
    data, text, as_latex,   what is shown; without a function what the result says: to_dict, str, latex, to_csv,
    as_csv, drawn, style    itself on the axes, with these options
    besides                 text that stands below, LaTeX or not
    typed                   refuses options that were typed and would have no effect
    failed                  whether a check has failed (exit code 1)
    of_shell                what the shell calls with the ``Request`` in the place of the function
    more, instead           options of the shell alone; (data, text) in the place of an answer, without computing
    show                    an own way to show and write: refuses before the work, then makes (data, text) of the result
    certificate             what --certificate writes: something with to_json() (certificates.of_results)
    missing                 (rows done, what is missing) of what was done when the work was cut short
    shown                   the results that stand on the page of --html, each as it shows itself; the text of others
    formula                 the formulas on that page; without it those of --latex, else the result's own
    equation                the equation of motion on that page; without it that of the law, where there is one
    letters                 what letters of these formulas mean, where that is not what they mean everywhere; None
                            where the lines say it themselves
    page                    what --html writes, in the place of the page that all have (``ask.page``); None: that page
    reads                   the parameter whose words are files that are read: no file is written over one of them
    again                   how a table is held against its own request; None: its header does not name the request
    rows_done               (text, rows, what is missing) of the table, of the rows that were done when making it was
                            cut short; None of what is no such row
    inverse                 another ``Question``, asked in the place of this one where its first option is given
    lacks                   a common option, or one of other commands, that means nothing here -> why, or what is meant
    ======================  ==========================================================================================
    """

    latex: str = ""
    table: str = ""
    picture: str = ""
    curve: bool = False
    overlay: str = ""
    from_rest: bool = False
    oscillator_alone: bool = False
    always_files: bool = False
    own_latex: bool = False
    data: Part = lambda found, _: found.to_dict()
    text: Part = lambda found, _: str(found)
    as_latex: Part = lambda found, _: found.latex()
    as_csv: Part = lambda found, _: found.to_csv()
    drawn: Part = lambda found, _: [found]
    style: Part = lambda found, _: {}
    typed: Callable[[Request], None] = lambda _: None
    failed: Part = lambda found, _: False
    besides: Part = lambda found, _: ""
    of_shell: Callable[[Request], Any] | None = None
    more: tuple[Option, ...] = ()
    instead: Callable[[Request], tuple[dict[str, Any], str] | None] = lambda _: None
    show: Callable[[Request], Callable[[Any], tuple[dict[str, Any], str]]] | None = None
    certificate: Part | None = None
    shown: Part = lambda found, _: [found]
    formula: Part | None = None
    equation: Part | None = None
    letters: Part = lambda found, _: found._letters() if isinstance(found, Shown) else {}
    page: Part | None = None
    reads: str = ""
    again: Again | None = Again()
    missing: Callable[[Any, Request], tuple[int, str]] | None = None
    rows_done: Callable[[Any, Request], tuple[str, int, str] | None] | None = None
    inverse: Any = None
    lacks: Mapping[str, str] = field(default_factory=dict)

    def record(
        self, found: Any, request: Request, latex: str = "", written: Sequence[str] | None = None
    ) -> dict[str, Any]:
        """The answer as JSON, with its LaTeX and the files that were written."""
        data = dict(self.data(found, request))
        if latex and not self.own_latex:
            data["latex"] = latex
        if written or self.always_files:
            data["files"] = [*(written or ())]
        return data

    def formula_of(self, found: Any, request: Request) -> str:
        """The formulas of the page, as LaTeX."""
        if self.formula is not None:
            return str(self.formula(found, request))
        if self.latex:
            return str(self.as_latex(found, request))
        return found._formula() if isinstance(found, Shown) else ""

    def pairs(self) -> tuple[Pair, ...]:
        """Which of these options need another one."""
        table, picture = ("csv",) if self.table else (), ("plot",) if self.picture else ()
        found = []
        if picture:
            found.append(needs("size dpi", "plot", "there is no picture", "--plot FILE with it"))
        if self.overlay:
            found.append(needs("overlay", "plot", "there is no picture", "--plot FILE with it"))
        if self.curve:
            drawn, accepted = " ".join((*picture, *table)), "a time > 0 with --plot or --csv"
            found.append(needs("points", "csv", "there is no table to give rows to", "--points with --csv"))
            found.append(demands(drawn, "time", accepted, "there is no stretch of time to draw"))
        return tuple(found)

    def options(self) -> tuple[Option, ...]:
        """The options of the shell that these parts make."""
        found = []
        if self.latex:
            found.append(Option("latex", "", self.latex, "output"))
        if self.picture:
            wide, high = SIZE
            suffixes = f"{', '.join(k[1:].upper() for k in KINDS[:-1])} or {KINDS[-1][1:].upper()}"
            found += [
                Option("plot", "FILE", f"{self.picture}: {suffixes}", "output"),
                Option("size", "WxH", f"the size of the picture in inches (default {wide:g}x{high:g})", "output"),
                Option("dpi", "DPI", f"its resolution, for PNG (default {DPI})", "output"),
            ]
        if self.overlay:
            found.append(Option("overlay", "LAW", self.overlay, "output", repeated=True))
        page = "one page: the answer, its formulas typeset, its picture, provenance"
        if self.page is not None:
            page = "one page: verdict, pictures, laws, data, provenance"
        found.append(Option("html", "FILE", page, "output"))
        if self.table:
            found.append(Option("csv", "FILE", f"{self.table}, as a table of columns", "output"))
        if self.certificate is not None:
            found.append(Option("certificate", "FILE", CERTIFICATE, "output"))
        if self.curve:
            text = f"the table has POINTS + 1 rows (1 to {MAX_POINTS}; default {DEFAULT_POINTS})"
            found.append(Option("points", "POINTS", text, "output"))
        return (
            *self.more,
            *found,
            Option("json", "", "print JSON (numbers are strings, never floats)", "output"),
            Option("quiet", "", "no progress on stderr", "output"),
        )
