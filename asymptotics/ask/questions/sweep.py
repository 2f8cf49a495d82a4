"""Any of these commands at many points, resumable, from one core to a cluster."""

import argparse
import csv
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Executor
from functools import partial
from pathlib import Path
from typing import Annotated, Any

from asymptotics.ask.answers import Offers, Request
from asymptotics.ask.axes import point_options, read_axes, run_point
from asymptotics.ask.kinds import SECONDS, Kind, Option, whole
from asymptotics.ask.question import question
from asymptotics.ask.registry import SWEPT
from asymptotics.ask.typed import typed_options
from asymptotics.errors import InputError, require_choice, shown
from asymptotics.numbers.integers import parse_integer
from asymptotics.numbers.policy import Number, exact_number
from asymptotics.running.progress import progress_bar
from asymptotics.sweeps.export import export, require_format
from asymptotics.sweeps.grid import MAX_POINTS, Grid, Point, too_large
from asymptotics.sweeps.run import MAX_WORKERS, OpenCrew, SweepResult
from asymptotics.sweeps.run import sweep as swept
from asymptotics.sweeps.workers import dask_executor

Points = Grid | list[Point]


def _command(value: Any, name: str) -> str:
    if isinstance(value, str) and value not in SWEPT and name == "COMMAND":
        raise InputError(name, f"{value[:40]!r} cannot be swept", ", ".join(SWEPT))
    return require_choice(value, name, SWEPT)


def _points(options: Any, name: str, command: str = "") -> Points:
    """Every combination of the values of a mapping, or a list of points."""
    require_choice(command, "command", SWEPT)
    points: Points
    if isinstance(options, Mapping):
        texts = [(_named(n, name), v if isinstance(v, list | tuple) else [v]) for n, v in options.items()]
        points = Grid(read_axes(command, [f"--{n}={_text(n, v)}" for n, each in texts for v in each]))
    elif isinstance(options, list | tuple) and all(isinstance(row, Mapping) for row in options):
        points = [point_options(command, {_named(n, name): _text(n, v) for n, v in row.items()}) for row in options]
    else:
        raise InputError(name, f"{shown(options)} is neither", "a mapping of options, or a list of points")
    if not points:
        raise InputError(name, "there is no point", "at least one")
    return points


def _named(name: Any, argument: str) -> str:
    if not isinstance(name, str):
        raise InputError(argument, f"{shown(name)} is no name of an option", "a text such as 'alpha'")
    return name


def _text(name: str, value: Any) -> str:
    """A value as it would be typed: a text as it is, any other number as the exact one that it is."""
    return value if isinstance(value, str) else str(exact_number(value, name))


def _typed_points(options: argparse.Namespace) -> Points:
    """The grid of the options, or the list of a file with the options added to each of its points."""
    command = _command(options.command, "COMMAND")
    axes = read_axes(command, options.options)
    if options.list is None:
        return Grid(axes)
    # Options beside --list hold for all of its points, so each has one value.
    fixed = {name: values[0] for name, values in axes.items() if len(values) == 1}
    if len(fixed) < len(axes):
        raise InputError("--list", "it stands next to a range", "either a list of points or ranges")
    try:
        with Path(options.list).open(newline="", encoding="utf-8") as stream:
            rows = [point_options(command, row, fixed) for _, row in zip(range(MAX_POINTS + 1), csv.DictReader(stream))]
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        reason = f"cannot read {options.list}: {' '.join(str(error).split())}"
        raise InputError("--list", reason, "a CSV file") from error
    if not rows:
        raise InputError("--list", f"{options.list} has no rows", "a header of option names, and a row for each point")
    if len(rows) > MAX_POINTS:
        raise too_large(len(rows), "--list")
    return [{**fixed, **row} for row in rows]


def _crew(options: argparse.Namespace) -> OpenCrew | None:
    if options.dask is None:
        return None
    workers = None if options.workers is None else parse_integer(options.workers, "--workers", 1, MAX_WORKERS)
    return partial(dask_executor, options.dask, workers)


COMMAND = Kind("COMMAND", _command, place=True, words=True, suffix=f": {', '.join(SWEPT)}")
POINTS = Kind(
    "...", _points, beside=("command",), assemble=_typed_points,
    options=(
        Option("options", "...", "its options, each a value, a list or a range", place=True, rest=True),
        Option("list", "FILE", "the points from a CSV file, one column for each option"),
    ),
)  # fmt: skip
FOLDER = Kind("DIR", lambda folder, _: folder, option="store", group="limits", words=True)
EXECUTOR = Kind(
    "URL", lambda executor, _: executor, assemble=_crew,
    options=(
        Option("dask", "URL", "run on a Dask scheduler, tcp://host:port, or on a local cluster: local", "limits"),
    ),
)  # fmt: skip


def _of_shell(request: Request) -> SweepResult:
    """The sweep with its progress shown; one that is interrupted says where its points are."""
    command, points, folder = request["command"], request["options"], Path(request["folder"])
    with progress_bar(len(points), unit="point", quiet=request.options.quiet) as bar:
        try:
            return swept(
                partial(run_point, command), command, points, folder, workers=request["workers"],
                crew=request["executor"], progress=lambda done, total: bar.update(done - bar.n),
            )  # fmt: skip
        except KeyboardInterrupt as stop:
            stop.add_note(f"what is finished is in {folder}: the same command continues")
            raise


def _show(request: Request) -> Callable[[SweepResult], tuple[dict[str, Any], str]]:
    command, points, target = request["command"], request["options"], request.typed("export")
    if target is not None:
        require_format(Path(target))
    typed_options(command, points[0])  # what no point could use is refused at once, as the command refuses it

    def show(result: SweepResult) -> tuple[dict[str, Any], str]:
        data: dict[str, Any] = {"swept": command, **result.to_dict()}
        if target is not None:
            export(Path(target), command, points, Path(request["folder"]))
            data["export"] = target
        return data, _summary(result, target)

    return show


def _summary(result: SweepResult, target: str | None) -> str:
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
    return "\n".join([*lines, *([] if target is None else [f"written: {target}"])])


@question(
    Offers(
        more=(Option("export", "FILE", "write the result: .csv, .json or .parquet", "output"),),
        of_shell=_of_shell,
        show=_show,
        # A point that fails is an answer too; a sweep in which all of them fail has none, exit code 1.
        failed=lambda result, _: result.failed == result.points > 0,
        lacks={
            **dict.fromkeys(("csv", "latex", "plot"), "`--export FILE.csv`, .json or .parquet writes the points"),
            **dict.fromkeys(("digits", "gauge"), "it is an option of COMMAND, and stands behind it"),
            "points": "a range start:stop:step says how many",
        },
    ),
    name="sweep",
    alone=False,
    example="moment --p 1 --workers 1 --store {folder}",
    rests="what the command that is swept rests on, row by row",
)
def sweep_command(
    command: Annotated[str, COMMAND],
    options: Annotated[Mapping[str, str | int | Sequence[str]] | Sequence[Point], POINTS],
    folder: Annotated[Path | str, FOLDER],
    *,
    workers: Annotated[int | None, whole(1, MAX_WORKERS).called(group="limits")] = None,
    executor: Annotated[Executor | None, EXECUTOR] = None,
    max_seconds: Annotated[Number | None, SECONDS.called(in_shell=False)] = None,
) -> SweepResult:
    """Any command at many points: on every core or a cluster, stopped and resumed at will, each finished point kept.

      asymptotics sweep turning-points --alpha 1:3:1/10 --epsilon 1/10:1/2:1/10 --count 2 --times --store runs
      asymptotics sweep moment --p 0:10:1/4 --digits 50 --store runs --export moments.csv
      asymptotics sweep turning-points --law 1:1/10 --law 2:1/20,1/10 --count 5 --store runs --dask tcp://host:8786
      asymptotics sweep expand --list points.csv --order 4 --store runs --export coefficients.parquet

    The options of COMMAND take ranges start:stop:step (ends included) and comma lists; --list FILE.csv has one column
    for each option and one row for each point instead.  Nothing that the store holds is computed again; a point that
    fails is reported with its reason and ends nothing.

    Parameters
    ----------
    command
        what to compute
    options
        option -> a value, a comma list or a range start:stop:step, a list where the option is repeated; or a list of
        points
    folder
        the folder of finished points: new, empty, or one that a sweep has made
    workers
        processes (default: one for each core; 1: no pool)
    executor
        any of concurrent.futures; it is left open
    max_seconds
        the time the sweep may take, in seconds (default: no limit)

    Raises
    ------
    InputError
        for what cannot be swept, and as ``sweep``
    LimitError
        after ``max_seconds``; everything finished is in the store

    Examples
    --------
    >>> import tempfile
    >>> sweep_command("moment", {"p": "0:1:1/2", "digits": 5}, tempfile.mkdtemp(), workers=1)
    3 points: 3 computed, 0 from the store, 0 failed
    in ... s, store ...
    """
    points: Any = options
    # An option that no point could use is refused before anything is computed or a store is made.
    typed_options(command, points[0])
    return swept(partial(run_point, command), command, points, folder, workers=workers, executor=executor)
