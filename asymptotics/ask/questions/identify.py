"""Which damping law is it: from a measured decay to exponents, strengths and intervals."""

import argparse
from collections.abc import Mapping, Sequence
from datetime import UTC, datetime
from hashlib import sha256
from pathlib import Path
from typing import Annotated, Any

from asymptotics.ask.answers import Offers, Request
from asymptotics.ask.kinds import FLAG, POSITIVE, SECONDS, TEXT, Kind, Option, whole
from asymptotics.ask.pairs import excludes
from asymptotics.ask.question import question
from asymptotics.ask.questions._damping_law import STRENGTHS, rows_of_strengths
from asymptotics.decays.identification.damping_kind import DAMPING, is_damping, law_of_damping, opened_once
from asymptotics.decays.identification.examples import EXAMPLES, example
from asymptotics.decays.identification.forward.work import PATIENCE
from asymptotics.decays.identification.found_law import DampingLaw
from asymptotics.decays.identification.identify import identified
from asymptotics.decays.identification.telling.html_report import html_report
from asymptotics.decays.identification.telling.in_text import identification_text
from asymptotics.decays.identification.telling.result import Identification
from asymptotics.decays.records.columns import KINDS
from asymptotics.decays.records.sources import How
from asymptotics.decays.records.units import UNITS
from asymptotics.errors import InputError, require_choice, shown
from asymptotics.numbers.arrays import real_array
from asymptotics.numbers.policy import Number, exact_double
from asymptotics.present.inputs import csv_text

_DATA, _LAW = "the data", "the law"
MOST_SKIPPED = 100_000


def _range(value: Any, name: str) -> tuple[float, float]:
    """LOW:HIGH, or two numbers."""
    if isinstance(value, str):
        low, colon, high = value.partition(":")
        if not colon:
            raise InputError(name, f"{value[:40]!r} has no colon", "LOW:HIGH, such as 0.05:0.2")
        return exact_double(low, name), exact_double(high, name)
    values = real_array(value, name)
    if values.shape != (2,):
        raise InputError(name, f"its shape is {values.shape}", "two numbers: low, high")
    return float(values[0]), float(values[1])


def _kept(options: argparse.Namespace) -> bool:
    return not options.no_bootstrap


def _runs(data: Any, name: str, x: Any = None) -> Any:
    """The data as they are; with an array ``x`` beside an array of times the two are one record."""
    if x is None:
        return data
    columns = {}
    for argument, given in ((name, data), ("x", x)):
        if isinstance(given, str | Path | Mapping) or hasattr(given, "read"):
            reason = f"{shown(given)} is no column beside another one"
            raise InputError(argument, reason, "identify(t, x) of two arrays; identify([run, run]) of several runs")
        columns[argument] = real_array(given, argument)
        if columns[argument].ndim != 1:
            raise InputError(argument, f"its shape is {columns[argument].shape}", "a column of numbers")
    return tuple(columns.values())


def _files(options: argparse.Namespace) -> list[str]:
    """The files, or the one of an example."""
    if options.example is None:
        if not options.data:
            raise InputError("FILE", "is missing", f"a file of data; to try it, --example {', '.join(EXAMPLES)}")
        return list(options.data)
    return [str(example(options.example))]


_FILES = "a table of any layout, xlsx, parquet, npz, mat; several: several runs"
RUNS = Kind(
    "FILE", _runs, words=True, schema={"type": "string"}, beside=("x",), assemble=_files,
    options=(
        Option("data", "FILE", _FILES, place=True, several=True),
        Option("example", "NAME", f"a file of this program: {', '.join(EXAMPLES)}", _DATA, words=tuple(EXAMPLES)),
    ),
    pairs=(excludes("example", "data"),),
)  # fmt: skip
BESIDE = Kind("", lambda value, _: value, words=True, in_shell=False)
KIND = TEXT.called(
    letter="KIND", group=_DATA, suffix=f": {', '.join((*KINDS, DAMPING))}; default: found from the columns"
)
UNIT = TEXT.called(letter="U", group=_DATA, suffix=f": {', '.join(UNITS)}; with milliseconds: mm,ms")
WORDS = Kind("LAW", lambda words, _: words, words=True, several=True)
BOOTSTRAP = Kind(
    "", FLAG.read, assemble=_kept,
    options=(Option("no-bootstrap", "", "keep the intervals of correlated residuals"),),
)  # fmt: skip


def _csv(found: Identification | DampingLaw, _: Request) -> str:
    """All candidate laws, best first: a row for each strength, both ends of its interval as columns; then Q(A), T(A)
    and what else is told before any law."""
    if isinstance(found, DampingLaw):
        return csv_text(STRENGTHS, rows_of_strengths(found))
    columns = found._table() or dict.fromkeys(("law", "verdict", "parameter", "estimate", "low", "high"), [])
    bare = [[row.get(name, "") for name in columns] for row in found._bare_rows()]
    return csv_text(list(columns), [*zip(*columns.values()), *bare])


def _drawn(found: Identification | DampingLaw, request: Request) -> list[Any]:
    """The answer on its axes; nothing of a table, in which no decay stands."""
    if not isinstance(found, DampingLaw):
        return [found]
    if request.typed("plot"):
        raise InputError("--plot", "a table of damping has no decay", "--csv, or asymptotics damping of the law found")
    return []


def _page(found: Identification | DampingLaw, request: Request) -> str | None:
    """The page, with the digests of the files and the options that are not at their defaults."""
    if isinstance(found, DampingLaw):
        return None
    # The page is to be checked against its data years later: names change, digests do not.
    files = {name: f"SHA-256 {sha256(Path(name).read_bytes()).hexdigest()}" for name in request["data"]}
    names = "kind unit laws springs amplitudes amplitudes_only mass stiffness omega_0 noise columns decimal sheet rate"
    given = {name: request.typed(name) for name in (*names.split(), "modes", "no_bootstrap")}
    chosen = "; ".join(f"{n}: {' '.join(v) if isinstance(v, list) else v}" for n, v in given.items() if v)
    date = datetime.now(UTC).strftime("%Y-%m-%d %H:%M UTC")
    return html_report(found, {**files, "options": chosen or "none", "date": date})


@question(
    Offers(
        picture="decay, decrement plot, residuals, profiles",
        drawn=_drawn,
        style=lambda _, __: {"panels": True},
        page=_page,
        table="all candidate laws",
        as_csv=_csv,
        formula=lambda _, __: "",
        data=lambda found, _: {**({"kind": DAMPING} if isinstance(found, DampingLaw) else {}), **found.to_dict()},
        text=lambda found, _: str(found) if isinstance(found, DampingLaw) else identification_text(found),
        always_files=True,
        reads="data",
        again=None,
        lacks={
            "digits": "intervals carry as many digits as the data decide",
            "gauge": "what is observed is the same in every gauge",
            "latex": "the answer is a verdict in words; `--csv` has all candidate laws",
            "points": "the points are those of FILE",
        },
    ),
    example="{data} --laws 1 --no-bootstrap",
    rests="statistics in doubles; with a resolution of the data a certified set, in balls",
)  # fmt: skip
def identify(
    data: Annotated[Any, RUNS],
    x: Annotated[Any, BESIDE] = None,
    *,
    kind: Annotated[str | None, KIND] = None,
    unit: Annotated[str, UNIT] = "",
    columns: Annotated[str | None, TEXT.called(letter="LIST", group=_DATA)] = None,
    decimal: Annotated[str | None, TEXT.called(letter="MARK", group=_DATA)] = None,
    skip: Annotated[int, whole(0, MOST_SKIPPED).called(group=_DATA)] = 0,
    sheet: Annotated[str | None, TEXT.called(group=_DATA)] = None,
    rate: Annotated[Number | None, POSITIVE.called(letter="HZ", group=_DATA)] = None,
    laws: Annotated[Sequence[str] | None, WORDS] = None,
    springs: Annotated[Sequence[str], WORDS.called(letter="P")] = (),
    amplitudes: Annotated[tuple[float, float] | None, Kind("LOW:HIGH", _range, group=_DATA)] = None,
    amplitudes_only: Annotated[bool, FLAG.called(group=_DATA)] = False,
    mass: Annotated[Number | None, POSITIVE.called(letter="M", group=_LAW)] = None,
    stiffness: Annotated[Number | None, POSITIVE.called(letter="K", group=_LAW)] = None,
    omega_0: Annotated[Number | None, POSITIVE.called(letter="W", option="omega0", group=_LAW)] = None,
    noise: Annotated[Number | None, POSITIVE.called(letter="S", group=_DATA)] = None,
    bootstrap: Annotated[bool, BOOTSTRAP] = True,
    modes: Annotated[int, whole(1, 2).called(group=_DATA)] = 1,
    max_seconds: Annotated[Number, SECONDS.called(default=str(PATIENCE))] = PATIENCE,
) -> Identification | DampingLaw:
    """Which damping law is it?  From a measured decay to exponents, strengths and honest intervals.

      asymptotics identify DATA.csv                              # the columns say what it is
      asymptotics identify DATA.csv --kind turning-points --laws 1 1+2 0+2 free --json
      asymptotics identify RUN1.csv RUN2.csv --unit deg          # several runs of one oscillator

    Columns: record `t,x`; velocity `t,v`; acceleration `t,a`; turning-points `n,x[,tau]`; decrement
    `amplitude,decrement[,resolution]` of half-swings; damping `A,zeta` or `A,Q`, or of a resonance `A,force[,omega]`,
    `[,resolution]`, which `damping --from` reads too. Names, units, separators and decimal marks are found and told;
    where two readings are possible, --columns or --decimal is asked for. Laws: exponents joined by + (1+2, or 3/2
    alone), `free` (one exponent to be found), `A,M:` for the loss |x|^M v|v|^(A-1), as `--law A,M:E` in other commands,
    `sP` for a spring x|x|^(P-1), `pendulum` for sin x. By default every subset of 0, 1, 2, 3 and a free exponent
    compete, each with and without the springs x^3 and x^3, x^5 where there are times. epsilon refers to x0 = 1 unit of
    the file; intervals are 95 %.

    Parameters
    ----------
    data
        a table of any layout, xlsx, parquet, npz, mat; several: several runs
    x
        the column beside an array of times: ``identify(t, x)``
    kind
        what the columns are
    unit
        the unit of x, or of x and time
    columns
        which is what: t=Time (s),x=3 (a name, or a place from 1)
    decimal
        the decimal mark: . or , (default: found in the file)
    skip
        lines before the table that are not read
    sheet
        the sheet of a spreadsheet, where several hold numbers
    rate
        samples a second of a file without times (default: found above the numbers)
    laws
        candidate laws: 1 1+2 0+2 free 1+s3 1,2: ...
    springs
        springs to add to each law: 3 3+5 pendulum
    amplitudes
        use the turning points with |x| in this range only
    amplitudes_only
        use no times; intervals widen by the cost
    mass
        mass in kg, if known
    stiffness
        stiffness in N/m, if known
    omega_0
        sqrt(k/m) in rad/s, if known
    noise
        standard deviation of x, if known
    bootstrap
        whether the intervals of correlated residuals are lengthened
    modes
        2: the strongest further line of the samples is fitted beside the motion
    max_seconds
        the time the request may take, in seconds

    Raises
    ------
    InputError
        for data that cannot be used, naming the row and the column
    LimitError
        after ``max_seconds``

    Notes
    -----
    ``data`` is a file (a text table of any layout, xlsx, parquet, npz, mat), an open one, a data frame, a mapping of
    columns, two arrays ``t, x`` or ``(t, x)``, observations, or a list of several runs.  ``kind`` is record, velocity,
    acceleration, envelope, turning-points, decrement or damping (amplitudes with zeta, Q, or the force of a resonance:
    the answer is that of ``damping_law`` then, a ``DampingLaw``); ``unit`` m, cm, mm, rad, deg, and of time too:
    "mm,ms".
    epsilon_i refers to x0 = 1 unit of the data: x'' + x + sum epsilon_i x'|x'|^(alpha_i - 1) = 0 in the time omega_0 t;
    b or b/m is given as far as ``mass``, ``stiffness``, ``omega_0`` or the times tell it.
    What is judged is a matter of counted work (a minute of an ordinary core, or a tenth of ``max_seconds`` where that
    is more), so that a verdict does not depend on how busy the machine is; what a limit cuts off is undecided.

    Examples
    --------
    >>> import numpy as np
    >>> n = np.arange(41)
    >>> x = (-1.0) ** n / (1 + 0.05 * n) + 1e-4 * np.random.default_rng(3).standard_normal(41)
    >>> identify({"n": n, "x": x}, laws=["1", "2", "free"]).law("1").law.verdict
    'refuted'
    >>> identify({"A": ["0.1", "0.2", "0.4", "0.8"], "zeta": [0.0120, 0.0141, 0.0178, 0.0261]}, noise=2e-4).best.name
    '1+2'
    """
    how = How(columns, decimal, skip, sheet, None if rate is None else float(rate))
    if kind is not None:
        require_choice(kind, "kind", (*KINDS, DAMPING))
    if kind in (None, DAMPING):
        one = len(data) == 1 if isinstance(data, list) else not isinstance(data, tuple)
        data = opened_once(data[0] if one and isinstance(data, list) else data, how) if one else data
    if is_damping(data, kind, columns, omega_0):
        asked = {
            "x": x, "unit": unit, "columns": columns, "rate": rate, "springs": springs, "amplitudes": amplitudes,
            "amplitudes_only": amplitudes_only, "omega_0": omega_0, "modes": modes, "noise": noise, "laws": laws,
            "mass": mass, "stiffness": stiffness,
        }  # fmt: skip
        return law_of_damping(data, asked)
    return identified(
        data, kind=kind, unit=unit, laws=laws, springs=springs, amplitudes=amplitudes, amplitudes_only=amplitudes_only,
        mass=mass, stiffness=stiffness, omega_0=omega_0, noise=noise, bootstrap=bootstrap,
        how=how, modes=modes,
    )  # fmt: skip
