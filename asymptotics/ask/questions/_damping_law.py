"""The damping law behind a table of zeta, Q or decrement: what ``damping --from`` asks.

Its header holds the table itself, never the name of a file, so that it can be asked again.
"""

import argparse
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Any, cast

from asymptotics.ask.answers import Again, Offers, Request
from asymptotics.ask.forces import read_law
from asymptotics.ask.kinds import REAL, SECONDS, Kind
from asymptotics.ask.laws import law_options
from asymptotics.ask.pairs import excludes
from asymptotics.ask.question import question
from asymptotics.ask.typed import typed_options
from asymptotics.decays.comparison.cells import Cells, compared_cells
from asymptotics.decays.comparison.reading import as_double
from asymptotics.decays.comparison.run import Comparison
from asymptotics.decays.identification.damping_table import law_of_table
from asymptotics.decays.identification.found_law import DampingLaw
from asymptotics.errors import InputError
from asymptotics.law import SpringLike
from asymptotics.numbers.exact import ExactReal, parse_rational
from asymptotics.numbers.policy import Number
from asymptotics.present.inputs import csv_text, option_words, with_words
from asymptotics.running.cut_short import changed
from asymptotics.terms_given import PENDULUM


def _table_of_options(options: argparse.Namespace) -> str:
    path = Path(options.table)
    try:  # first: of a file that is not there no combination matters
        path.stat()
    except OSError as error:
        raise InputError("--from", f"cannot read {path.name[:80]}: {error.strerror}", "a file of data") from None
    return str(options.table)


TABLE = Kind("FILE", lambda table, _: table, option="from", group="the data", assemble=_table_of_options)
LAWS = Kind("LAW", lambda laws, _: laws, words=True, several=True)
_SPRING = next(o for o in law_options() if o.name == "spring")


def _springs_of_options(options: argparse.Namespace) -> Any:
    """The springs as a mapping, or the pendulum's name."""
    if options.spring is None:
        return None
    # The reader of laws wants a loss: one is put in, and only the springs are taken out again.
    terms = read_law(argparse.Namespace(**{**vars(options), "law": ["1:1"], "alpha": None}), "epsilon").springs
    if any(t.family for t in terms):
        return PENDULUM
    return {(t.position, t.velocity): t.strength for t in terms}


SPRINGS = Kind("SPRING", lambda spring, _: spring, options=(_SPRING,), assemble=_springs_of_options, group="the law")


STRENGTHS = ("law", "grade", "alpha", "low", "strength", "high")


def rows_of_strengths(found: DampingLaw) -> list[tuple[Any, ...]]:
    """A row for each strength of each law."""
    rows = [(c.name, c.grade_in_words(), s.alpha, s.low, s.estimate, s.high) for c in found.laws for s in c.strengths]
    # No interval is an empty cell.
    return [tuple("" if cell != cell else cell for cell in row) for row in rows]


def _csv(found: DampingLaw, request: Request) -> str:
    """The strengths, and in the header the request with the numbers of the table in the place of its file."""
    laws = ",".join("+".join(alphas) for alphas in found.problem.candidates)
    table = {name: ",".join(map(repr, column)) for name, column in found.table.items()}
    given = {name: request.typed(name) for name in ("spring", "mass", "stiffness")}
    words = ["damping-law", *option_words({**table, "laws": laws, **given})]
    return with_words(csv_text(STRENGTHS, rows_of_strengths(found)), words)


# What tells every double apart: the fit is one in doubles.
_COLUMNS, _DIGITS = (
    ("A", "zeta", "Q", "decrement", "force", "omega", "phase", "phase_resolution", "n", "cycles", "t", "resolution"),
    17,
)


def _again(request: dict[str, str], header: list[str], rows: list[tuple[int, list[str]]], *_: Any) -> Comparison:
    """The table in the header fitted again: one in doubles, so that nothing is certified.

    What is judged is whether the file says what its request gives.
    """
    table = {name: _numbers(request[name]) for name in _COLUMNS if name in request}
    given = {n: v for n, v in request.items() if n.partition(".")[0] in ("spring", "mass", "stiffness")}
    options = typed_options("damping", given)
    laws = request["laws"].split(",") if "laws" in request else None
    springs = _springs_of_options(options)
    found = damping_law(table, laws=laws, spring=springs, mass=options.mass, stiffness=options.stiffness)
    right = tuple((*map(str, row), "") for row in rows_of_strengths(found))
    method = "the table in the header fitted again, in doubles"
    cells = Cells((*STRENGTHS, "code"), right, ("law", "alpha"), frozenset({"code"}), method=method)
    return compared_cells(rows, header, cells, _DIGITS, certified=False)


def _numbers(text: str) -> list[float]:
    cells = text.split(",")
    for cell in cells:
        # Read by the grammar of numbers first: a header is foreign text.
        parse_rational(cell, "FILE")
    return list(map(as_double, cells))


# The law is what is looked for, so that nothing may say it beforehand.
_NOT_OF_A_TABLE = "alpha law epsilon damping x0 amplitudes unit order digits latex conversions quantity size dpi"


@question(
    Offers(
        as_csv=_csv,
        formula=lambda _, __: "",
        again=Again(words=(*_COLUMNS, "laws", "spring", "mass", "stiffness"), compared=_again),
    ),
    pairs=(
        excludes(_NOT_OF_A_TABLE, "from", accepted="the table, --laws, --resolution, --spring"),
        excludes("plot", "from", accepted="--csv, or asymptotics damping of the law found"),
    ),
)
def damping_law(
    table: Annotated[Any, TABLE],
    *,
    resolution: Annotated[Number | None, REAL.called(letter="S", group="the data")] = None,
    laws: Annotated[str | Sequence[str] | None, LAWS] = None,
    spring: Annotated[SpringLike | None, SPRINGS] = None,
    mass: Annotated[Number | None, REAL.called(letter="M", group="the law")] = None,
    stiffness: Annotated[Number | None, REAL.called(letter="K", group="the law")] = None,
    max_seconds: Annotated[Number, SECONDS] = 60,
) -> DampingLaw:
    """The damping law behind amplitudes and zeta, Q or decrement (ln(A_n/A_(n+2))): candidates with grades, intervals.

    Strengths are b in SI with ``mass`` and ``stiffness``, else epsilon.  First order; what it neglects is measured on
    the best law.

    Parameters
    ----------
    table
        columns A, zeta (Q, decrement; n, cycles, t of two amplitudes or more; or force), resolution: the law
    resolution
        with --from: the standard deviation of each value, in the unit of its column
    laws
        with --from: candidate laws, exponents: 1 1+2 0+2 ...
    spring
        as for ``Law``
    mass
        in kg
    stiffness
        in N/m
    max_seconds
        the time the request may take, in seconds

    Raises
    ------
    InputError
        by name, for a table without a column A or with two of zeta, Q, decrement, and for values that are not positive
    LimitError
        after ``max_seconds``

    Notes
    -----
    ``table`` is a file, a data frame or a mapping with a column A (amplitude, m or rad, or as its header says: A [deg],
    A [mm]; beside zeta also theta, phi, roll angle, x), one of zeta, Q, decrement (zeta [%] in per cent), and perhaps
    its resolution: the standard deviation of each, in a column of that name, or u(zeta), sd zeta, zeta_err.
    In their place the amplitudes of a decay themselves: n counts half-swings, cycles periods, t is the time in s
    (omega_0 t without ``mass`` and ``stiffness``); resolution is that of A then.  Two amplitudes tell the strength of
    each law of one term.  Or the force under which each amplitude was measured, in a column force, and its angular
    frequency in a column omega (omega_0 without one): resolution is that of A, and the law is that of the resonance
    (derivation ``driven-first-order``); with a column phase, the lag of x behind the force (rad, or phase [deg]), and
    phase_resolution beside it where that of A is known, the loss is force times sin(phase), whatever the detuning.
    Source: derivation ``equivalent-damping``.

    Examples
    --------
    >>> found = damping_law({"A": [0.1, 0.2, 0.4, 0.8], "zeta": [0.0120, 0.0141, 0.0178, 0.0261]}, resolution="0.0002")
    >>> found.laws[0].name, found.law("2").grade
    ('1+2', 'refuted')
    """
    with changed(lambda _: None):  # what is done on the way to a law is no row of amplitudes
        return law_of_table(
            table,
            resolution=cast("ExactReal | None", resolution),
            laws=laws,
            spring=spring,
            mass=cast("ExactReal | None", mass),
            stiffness=cast("ExactReal | None", stiffness),
        )
