"""Any command at many points: on every core or a cluster, stopped and resumed at will, each finished point kept.

  asymptotics sweep turning-points --alpha 1:3:1/10 --epsilon 1/10:1/2:1/10 --count 2 --times --store runs
  asymptotics sweep moment --p 0:10:1/4 --digits 50 --store runs --export moments.csv
  asymptotics sweep turning-points --law 1:1/10 --law 2:1/20,1/10 --count 5 --store runs --dask tcp://host:8786
  asymptotics sweep expand --list points.csv --order 4 --store runs --export coefficients.parquet

The options of COMMAND take ranges start:stop:step (ends included) and comma lists; --list FILE.csv has one column for
each option and one row for each point instead.  Nothing that the store holds is computed again; a point that fails
is reported with its reason and ends nothing.
"""

import argparse
import csv
from functools import partial
from pathlib import Path
from typing import Any

from asymptotics.cli.answer import Answer
from asymptotics.cli.progress import progress_bar
from asymptotics.cli.shell import complain
from asymptotics.cli.swept import SWEPT, point_options, read_axes, run_point, typed_options
from asymptotics.errors import InputError
from asymptotics.numbers.exact import parse_integer
from asymptotics.sweeps.export import export, require_format
from asymptotics.sweeps.grid import MAX_POINTS, Grid, Point, too_large
from asymptotics.sweeps.run import MAX_WORKERS, SweepResult, sweep
from asymptotics.sweeps.workers import dask_executor

# Processes of one machine or slots of one scheduler; a refusal of slips.


def configure(parser: argparse.ArgumentParser) -> None:
    """Declare the options; those of COMMAND are its own."""
    parser.add_argument("swept", metavar="COMMAND", help=f"what to compute: {', '.join(SWEPT)}")
    parser.add_argument("options", nargs=argparse.REMAINDER, metavar="...", help="the options of COMMAND, and these:")
    group = parser.add_argument_group("options of the sweep")
    for name, value, text in OWN:
        if value:
            group.add_argument(name, metavar=value, help=text)
        else:
            group.add_argument(name, action="store_true", help=text)


OWN = (
    ("--store", "DIR", "the folder of finished points (needed)"),
    ("--workers", "N", "processes (default: one for each core; 1: no pool)"),
    ("--dask", "URL", "run on a Dask scheduler, tcp://host:port, or on a local cluster: local"),
    ("--export", "FILE", "write the result: .csv, .json or .parquet"),
    ("--list", "FILE", "the points from a CSV file, one column for each option"),
    ("--json", "", "print JSON"),
    ("--quiet", "", "no progress"),
)


def run(options: argparse.Namespace) -> Answer:
    """Run the command."""
    if options.swept not in SWEPT:
        raise InputError("COMMAND", f"{options.swept[:40]!r} cannot be swept", ", ".join(SWEPT))
    own, rest = _split(options)
    points = _points(options.swept, own, rest)
    if own.store is None:
        raise InputError("--store", "is missing", "a folder: new, empty, or one that a sweep has made")
    if own.export is not None:
        require_format(Path(own.export))
    typed_options(options.swept, points[0])  # what no point could use is refused at once, as the command refuses it
    result = _swept(options.swept, points, own)
    data: dict[str, Any] = {"swept": options.swept, **result.to_dict()}
    if own.export is not None:
        export(Path(own.export), options.swept, points, Path(own.store))
        data["export"] = own.export
    # A point that fails is an answer too; a sweep in which all of them fail has none, exit code 1.
    return Answer(data, _text(result, own), own.json, failed=result.failed == result.points > 0)


def _split(options: argparse.Namespace) -> tuple[argparse.Namespace, list[str]]:
    """The options of the sweep wherever they stand, and those that are left for the command."""
    # argparse gives everything behind COMMAND to it (REMAINDER): the options of the sweep are taken out again, those
    # before COMMAND put in front.
    parser = argparse.ArgumentParser(prog="asymptotics sweep", allow_abbrev=False, add_help=False, exit_on_error=False)
    for name, value, _ in OWN:
        parser.add_argument(name, action="store" if value else "store_true")
    given = [f"{n}={getattr(options, n[2:])}" for n, v, _ in OWN if v and getattr(options, n[2:], None) is not None]
    given += [n for n, v, _ in OWN if not v and getattr(options, n[2:], False)]
    try:
        return parser.parse_known_args([*given, *options.options])
    except argparse.ArgumentError as error:
        raise InputError(str(error.argument_name), str(error.message), "see asymptotics sweep --help") from error


def _points(command: str, own: argparse.Namespace, rest: list[str]) -> Grid | list[Point]:
    """The grid of the options, or the list of a file with the options added to each of its points."""
    axes = read_axes(command, rest)
    if own.list is None:
        return Grid(axes)
    # Options beside --list hold for all of its points, so each has one value.
    fixed = {name: values[0] for name, values in axes.items() if len(values) == 1}
    if len(fixed) < len(axes):
        raise InputError("--list", "it stands next to a range", "either a list of points or ranges")
    try:
        with Path(own.list).open(newline="", encoding="utf-8") as stream:
            rows = [point_options(command, row) for _, row in zip(range(MAX_POINTS + 1), csv.DictReader(stream))]
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise InputError("--list", f"cannot read {own.list}: {' '.join(str(error).split())}", "a CSV file") from error
    if not rows:
        raise InputError("--list", f"{own.list} has no rows", "a header of option names, and a row for each point")
    if len(rows) > MAX_POINTS:
        raise too_large(len(rows), "--list")
    return [{**fixed, **row} for row in rows]


def _swept(command: str, points: Grid | list[Point], own: argparse.Namespace) -> SweepResult:
    workers = None if own.workers is None else parse_integer(own.workers, "--workers", 1, MAX_WORKERS)
    crew = None if own.dask is None else partial(dask_executor, own.dask, workers)
    with progress_bar(len(points), unit="point", quiet=own.quiet) as bar:
        try:
            return sweep(
                partial(run_point, command), command, points, Path(own.store), workers=workers, crew=crew,
                progress=lambda done, total: bar.update(done - bar.n),
            )  # fmt: skip
        except KeyboardInterrupt:
            complain(f"asymptotics sweep: what is finished is in {own.store}: the same command continues")
            raise


def _text(result: SweepResult, own: argparse.Namespace) -> str:
    lines = [
        f"{result.points} points: {result.reused} from the store, {result.computed} computed, {result.failed} failed "
        f"({float(result.seconds):.1f} s)"
    ]
    for failure in result.failures:
        where = " ".join(f"{name}={value}" for name, value in failure["point"].items())
        lines.append(f"  failed: {where}: {failure['reason']}")
    if result.failed > len(result.failures):
        lines.append(f"  ... and {result.failed - len(result.failures)} more")
    lines += result.notes
    if own.export is not None:
        lines.append(f"written: {own.export}")
    return "\n".join(lines)
