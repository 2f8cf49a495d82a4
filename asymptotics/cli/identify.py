"""Which damping law is it?  From a measured decay to exponents, strengths and honest intervals.

  asymptotics identify DATA.csv                              # the columns say what it is
  asymptotics identify DATA.csv --kind turning-points --laws 1 1+2 0+2 free --json
  asymptotics identify RUN1.csv RUN2.csv --unit deg          # several runs of one oscillator

Columns: record `t,x`; velocity `t,v`; acceleration `t,a`; turning-points `n,x[,tau]`; decrement
`amplitude,decrement[,resolution]` of half-swings. Names, units, separators and decimal marks are found and told;
where two readings are possible, --columns or --decimal is asked for. Laws: exponents joined by + (1+2, or 3/2 alone),
`free` (one exponent to be found), `A,M:` for the loss |x|^M v|v|^(A-1), as `--law A,M:E` in other commands, `sP` for a
spring x|x|^(P-1), `pendulum` for sin x. By default every
subset of 0, 1, 2, 3 and a free exponent compete, each with and without the springs x^3 and x^3, x^5 where there are
times. epsilon refers to x0 = 1 unit of the file; intervals are 95 %.
"""

import argparse
from datetime import UTC, datetime
from hashlib import sha256
from pathlib import Path

from asymptotics.cli.answer import Answer, add_common
from asymptotics.cli.files import Makers, add_csv, add_plot, picture_maker, read_files, write_files
from asymptotics.errors import InputError
from asymptotics.identification.identify import identify
from asymptotics.identification.telling.html_report import html_report
from asymptotics.identification.telling.result import Identification
from asymptotics.numbers.exact import parse_integer
from asymptotics.numbers.policy import exact_double
from asymptotics.present.files import require_different
from asymptotics.present.inputs import csv_text
from asymptotics.records.columns import KINDS
from asymptotics.records.units import UNITS


def configure(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument(
        "files", nargs="+", metavar="FILE", help="a table of any layout, xlsx, npz, mat; several: several runs"
    )
    parser.add_argument("--kind", metavar="KIND", help=f"{', '.join(KINDS)} (default: found from the columns)")
    parser.add_argument("--unit", default="", metavar="U", help=f"the unit of x: {', '.join(UNITS)}; of time: mm,ms")
    parser.add_argument("--columns", metavar="LIST", help="which is what: t=Time (s),x=3 (a name, or a place from 1)")
    parser.add_argument("--decimal", metavar="MARK", help="the decimal mark: . or , (default: found in the file)")
    parser.add_argument("--skip", metavar="N", default="0", help="lines before the table that are not read")
    parser.add_argument("--sheet", metavar="NAME", help="the sheet of a spreadsheet, where several hold numbers")
    parser.add_argument("--laws", nargs="+", metavar="LAW", help="candidate laws: 1 1+2 0+2 free 1+s3 1,2: ...")
    parser.add_argument("--springs", nargs="+", default=[], metavar="P", help="springs to add to each law: 3 3+5")
    parser.add_argument("--amplitudes", metavar="LOW:HIGH", help="use the turning points with |x| in this range only")
    parser.add_argument("--amplitudes-only", action="store_true", help="use no times; intervals widen by the cost")
    parser.add_argument("--mass", metavar="M", help="mass in kg, if known")
    parser.add_argument("--stiffness", metavar="K", help="stiffness in N/m, if known")
    parser.add_argument("--omega0", metavar="W", help="sqrt(k/m) in rad/s, if known")
    parser.add_argument("--noise", metavar="S", help="standard deviation of x, if known")
    parser.add_argument("--no-bootstrap", action="store_true", help="keep the intervals of correlated residuals")
    add_plot(parser, "decay, decrement plot, residuals, profiles")
    parser.add_argument("--html", metavar="FILE", help="one page: verdict, pictures, laws, data, provenance")
    add_csv(parser, "all candidate laws")
    add_common(parser)


def run(options: argparse.Namespace) -> Answer:
    """Run the command."""
    files = read_files(options)
    # A file of data must not be overwritten by a picture of it, whichever of several runs it is.
    for name in options.files:
        require_different({"FILE": Path(name), **files})
    numbers = {name: _number(getattr(options, name), f"--{name}") for name in ("mass", "stiffness", "omega0", "noise")}
    answer = identify(
        list(options.files),
        kind=options.kind,
        unit=options.unit,
        laws=options.laws,
        springs=options.springs,
        amplitudes=_range(options.amplitudes),
        amplitudes_only=options.amplitudes_only,
        omega_0=numbers.pop("omega0"),
        bootstrap=not options.no_bootstrap,
        columns=options.columns,
        decimal=options.decimal,
        skip=parse_integer(options.skip, "--skip", 0, 100_000),
        sheet=options.sheet,
        **numbers,
    )
    makers: Makers = {
        "--plot": picture_maker(options, lambda: [answer], panels=True),
        "--csv": lambda _: _table(answer),
        "--html": lambda _: html_report(answer, _provenance(options)),
    }
    written = write_files(files, makers)
    text = "\n".join([_text(answer), *written])
    return Answer({**answer.to_dict(), "files": written}, text, options.json)


def _table(answer: Identification) -> str:
    """All candidate laws, best first: a row for each strength, both ends of its interval as columns."""
    columns = answer._table()
    return csv_text(list(columns), zip(*columns.values()))


def _provenance(options: argparse.Namespace) -> dict[str, str]:
    """The files with their digests, and the options that are not at their defaults."""
    # The page is to be checked against its data years later: names change, digests do not.
    files = {str(name): f"SHA-256 {sha256(Path(name).read_bytes()).hexdigest()}" for name in options.files}
    names = ("kind", "unit", "laws", "springs", "amplitudes", "amplitudes_only", "mass", "stiffness", "omega0", "noise")
    given = {name: getattr(options, name) for name in (*names, "columns", "decimal", "sheet", "no_bootstrap")}
    chosen = "; ".join(
        f"{name}: {' '.join(value) if isinstance(value, list) else value}" for name, value in given.items() if value
    )
    return {**files, "options": chosen or "none", "date": datetime.now(UTC).strftime("%Y-%m-%d %H:%M UTC")}


def _number(text: str | None, argument: str) -> float | None:
    if text is None:
        return None
    value = exact_double(text, argument)
    if not value > 0:
        raise InputError(argument, f"{text} is not positive", "a positive number")
    return value


def _range(text: str | None) -> tuple[float, float] | None:
    if text is None:
        return None
    low, colon, high = text.partition(":")
    if not colon:
        raise InputError("--amplitudes", f"{text[:40]!r} has no colon", "LOW:HIGH, such as 0.05:0.2")
    return exact_double(low, "--amplitudes"), exact_double(high, "--amplitudes")


def _text(answer: Identification) -> str:
    said = [line for line in (answer.in_words, answer.verdict.telling) if line]
    lines = [answer.verdict.text, *said, "", answer.table(), ""]
    for law in answer.laws[:1]:
        lines.append(law.law.candidate.formula())
        shown = [law.physical(i) for i in range(len(law.law.epsilon))]
        lines += [
            f"  {name} of {a}: {ends.estimate:.4g} [{ends.low:.4g}, {ends.high:.4g}] (SI)"
            for a, found in zip(law.law.candidate.alphas, shown)
            if found is not None
            for name, ends in [found]
            if ends.low is not None and ends.high is not None
        ]
    for name, found in answer.textbook.items():
        bias = "" if found["systematic_error"] is None else f", systematic error {', '.join(found['systematic_error'])}"
        lines.append(f"{name}: epsilon of {','.join(found['alphas'])} = {', '.join(found['epsilon'])}{bias}")
    return "\n".join([*lines, *(f"note: {note}" for note in answer.notes)])
