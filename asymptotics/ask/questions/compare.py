"""Your own values beside certified ones: right digits, and what the errors look like."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any

from asymptotics.ask.against import GIVEN_INPUTS, OWN_UNITS, Beside, GivenInputs, beside
from asymptotics.ask.answers import Offers, Request
from asymptotics.ask.kinds import SECONDS, TEXT, Kind, digits
from asymptotics.ask.question import question
from asymptotics.decays.comparison.in_text import comparison_text
from asymptotics.decays.comparison.run import MAX_DIGITS, Comparison
from asymptotics.errors import InputError, shown
from asymptotics.law import LawLike
from asymptotics.numbers.policy import Number


def _source(file: Any, name: str) -> Path | Mapping[str, Any]:
    """A file by its name, or columns by theirs; a data frame has ``keys`` and columns as a mapping has."""
    if isinstance(file, str | Path):
        return Path(file)
    if isinstance(file, Mapping):
        return file
    # By its methods: pandas, an extra, need not be installed for a file to be compared.
    if hasattr(file, "columns") and hasattr(file, "to_dict"):
        found: dict[str, Any] = file.to_dict("list")
        return found
    raise InputError(name, f"a {type(file).__name__} is no file name", "a path, a mapping of columns, a data frame")


def _table(name: Any, argument: str) -> str:
    if not isinstance(name, str):
        raise InputError(argument, f"{shown(name)} is no name", "a name of table_names()")
    return name


SOURCE = Kind("FILE", _source, place=True, words=True)
INPUT = Kind("LIST", lambda value, _: value, in_shell=False)


def _held_against(request: Request) -> Beside:
    return beside(*(request[name] for name in ("file", "law", "table", "columns", "digits")))


def _named(found: Comparison, request: Request) -> dict[str, Any]:
    return {"law" if request["table"] is None else "table": _held_against(request).description, **found.to_dict()}


@question(
    Offers(
        picture="digits lost against time",
        table="all rows",
        reads="file",
        again=None,
        certificate=lambda found, _: found.certificate(),
        data=_named,
        text=lambda found, request: comparison_text(found, _held_against(request).description),
        missing=lambda found, _: (len({row.line for row in found.rows}), found.summary["missing"]),
        lacks={
            "gauge": "what is observed is the same in every gauge",
            "latex": "the rows are text; `--csv` writes them",
            "points": "the points are those of FILE",
        },
    ),
    pairs=(OWN_UNITS,),
    example="{data} --alpha 2 --epsilon 1/10",
    rests="the certified side: what the command of the same numbers rests on",
)
def compare(
    file: Annotated[Any, SOURCE],
    law: Annotated[LawLike | None, GIVEN_INPUTS] = None,
    *,
    table: Annotated[str | None, TEXT.called(read=_table)] = None,
    columns: Annotated[str | None, TEXT.called(letter="LIST", group="the data")] = None,
    digits: Annotated[int | None, digits(MAX_DIGITS, "four more than yours")] = None,
    alpha: Annotated[Number | Sequence[Number] | None, INPUT] = None,
    epsilon: Annotated[Number | Sequence[Number] | None, INPUT] = None,
    max_seconds: Annotated[Number, SECONDS] = 60,
) -> Comparison:
    """One's own values beside certified ones: right digits, wrong digits marked, and what the errors look like.

      asymptotics compare mine.csv --alpha 2 --epsilon 1/10 --columns n,x,tau
      asymptotics compare motion.csv --law 0:1/20 --law 2:1/10 --columns tau=time,x=pos --plot lost.svg
      asymptotics compare table_one.csv --table smith2012.table1 --columns half_cycle,S_hat,u
      asymptotics compare exported.csv                     # a table of this program says itself what it is
      asymptotics compare points.csv                       # so does a file of --csv: its header has the oscillator
      asymptotics compare cycle.csv                        # and one of damping, envelope, stokes, smith or a sweep
      asymptotics compare series.csv --alpha 3/2                 # coefficients from expand --csv or half-swing --csv
      asymptotics compare lab.csv --alpha 3/2 --damping 1/10 --mass 3/2 --stiffness 30 --x0 1/5 --columns t,x

    FILE is CSV; an exported sweep may be JSON or Parquet.  A row is a turning point (n, with x, amplitude, tau or t),
    a moment (tau or t, with x or v) or a moment of an envelope (tau or t, with amplitude or phase: the averaged law).
    With --damping, --mass or --stiffness the file is in m, s and m/s, --law gives b, and --epsilon is still the
    dimensionless strength b omega_0^alpha x0^(alpha-1)/k; without them nothing has a unit (tau = omega_0 t): x is X.
    digits is -log10 of the relative error: 0 for a wrong sign, at most what the certified value has.

    Parameters
    ----------
    file
        a CSV file of values
    law
        epsilons, or an oscillator (the file is in SI then); of a table its law
    table
        compare with this table instead (asymptotics table --list)
    columns
        n,x,tau or n=index,x=pos: which column is what
    digits
        digits of the certified values
    alpha
        of a table: its exponents
    epsilon
        of a table: its strengths
    max_seconds
        the time the request may take, in seconds

    Raises
    ------
    InputError
        for what is missing or wrong, naming the line
    LimitError
        after ``max_seconds``; ``asymptotics.running.cut_short.done(error)`` hands over the rows that were done

    Notes
    -----
    ``file`` is a path, or columns by name: a mapping of sequences or arrays, a data frame.  A file that this program
    wrote needs nothing else: it is the same question at more digits.  Right digits are counted as -log10 of the
    relative error, against values of which every digit is proved.

    Examples
    --------
    >>> compare({"n": [1, 2], "x": [-0.4107197, 0.2635711]}, {2: 1}).rows[1].marked
    '0.26357[11]'
    """
    said = law if isinstance(law, GivenInputs) else GivenInputs(law, alpha=alpha, epsilon=epsilon, called=True)
    return beside(file, said, table, columns, digits).make()
