"""The commands that can be swept: their options as axes, and one point of a sweep as one run of the command.

>>> read_axes("moment", ["--p", "0:1:1/2", "--digits=20"])
{'p': ('0', '1/2', '1'), 'digits': ('20',)}
>>> run_point("moment", {"p": "2", "digits": "5"})
{'p': '2', 'value': '0.50000', 'exact': '1/2'}
"""

import argparse
import re
from collections.abc import Mapping, Sequence
from concurrent.futures import Executor
from functools import lru_cache, partial
from pathlib import Path
from typing import Any, NoReturn

from asymptotics.cli.answer import read_max_seconds
from asymptotics.cli.commands import module_of
from asymptotics.errors import InputError, UndecidedError, require_choice, shown
from asymptotics.numbers.context import alone
from asymptotics.numbers.exact import parse_real
from asymptotics.numbers.policy import Number, exact_integer, exact_number
from asymptotics.public import limited, public_beside_others
from asymptotics.sweeps.grid import Grid, Point, values
from asymptotics.sweeps.run import MAX_WORKERS, SweepResult, sweep

# The commands that answer one set of option values with one record.
SWEPT = ("turning-points", "half-swing", "expand", "moment", "motion", "smith", "envelope", "limit-cycle", "stokes")
# Options that write files or shape what is printed: a point of a sweep is its JSON, and a header or a list of points
# from elsewhere must not name a file to be written.
EXCLUDED = ("json", "plot", "csv", "latex", "points", "save", "report", "quiet", "list", "store", "export")
_WORD = re.compile(r"[a-z][a-z0-9-]{0,39}\Z")
_FORMAL = ("expand", "half-swing")  # they need no strengths
_NAMED = ("gauge", "parameter", "average")  # options whose values are words


class _Parser(argparse.ArgumentParser):
    """A parser that raises what it has to say."""

    def error(self, message: str) -> NoReturn:
        raise InputError("COMMAND", " ".join(message.split()), f"the options of asymptotics {self.prog}")


# One parser for all points of a process: declaring the options costs more than a cheap point.
@lru_cache
def _command(name: str) -> tuple[Any, argparse.ArgumentParser, dict[str, argparse.Action]]:
    """The module of a command, its parser, and its options by name."""
    module = module_of(name)
    parser = _Parser(prog=name, allow_abbrev=False, add_help=False)
    module.configure(parser)
    actions = {flag[2:]: action for flag, action in parser._option_string_actions.items() if flag.startswith("--")}
    return module, parser, actions


def read_axes(command: str, arguments: list[str]) -> dict[str, tuple[str, ...]]:
    """The axes of a grid from the options of the command; a repeated option gives axes law.1, law.2, ..."""
    given: list[tuple[str, str]] = []
    rest = list(arguments)
    while rest:
        text = rest.pop(0)
        name, equals, value = text[2:].partition("=")
        if not text.startswith("--"):
            name, value = "", text  # what a command takes without an option name
        elif not equals and not takes_no_value(command, name):
            if not rest:
                raise InputError(text, "it has no value", "a value, a list or a range")
            value = rest.pop(0)
        given.append((name, value))
    names = [name for name, _ in given]
    axes: dict[str, tuple[str, ...]] = {}
    for name, text in given:
        repeated = names.count(name) > 1 and name
        label = f"{name}.{1 + sum(key.startswith(name + '.') for key in axes)}" if repeated else name
        axes[label] = _axis(command, name, text)
    return axes


def takes_no_value(command: str, name: str) -> bool:
    """Whether an option is a flag; InputError for one that cannot be swept."""
    module, _, actions = _command(command)
    action, asked = actions.get(name), getattr(module, "question", None)
    # What writes a file or shapes what is printed is no parameter of the question.
    if asked is not None and name and name not in {o.name for a in asked.asked for o in a.options}:
        action = None
    if action is None or name in EXCLUDED:
        raise InputError(f"--{name}", "it cannot be swept", f"the options of asymptotics {command} that are numbers")
    return action.nargs == 0


def takes_words(command: str, name: str) -> bool:
    """Whether the values of an option are words."""
    asked = getattr(_command(command)[0], "question", None)
    if asked is None:
        return name in _NAMED
    return any(a.kind.words and o.name == name for a in asked.asked for o in a.options)


def _axis(command: str, name: str, text: str) -> tuple[str, ...]:
    if name and takes_no_value(command, name):
        return ("",)
    # The colon of a force is not that of a range: the powers are cut off first.
    if name in ("law", "spring"):
        return _forces(command, name, text)
    if name == "" or takes_words(command, name) or text == "symbolic":
        words = tuple(text.split(","))
        for word in words:
            if not _WORD.match(word):
                argument = f"--{name}" if name else "COMMAND"
                raise InputError(argument, f"{word[:60]!r} is not a word", "the command's words, with commas")
        return words
    return values(text, f"--{name}")


def _forces(command: str, name: str, text: str) -> tuple[str, ...]:
    """A term with a list or a range of strengths, A:E,E,... or A,M:start:stop:step; the powers are one pair."""
    powers, colon, strengths = text.partition(":")
    if text == "pendulum":
        return (text,)
    shape = ",".join(str(parse_real(power, f"--{name}")) for power in powers.split(","))
    if not colon and command not in _FORMAL:
        raise InputError(f"--{name}", f"{text[:60]!r} has no colon", "A:E, A:E,E,... or A:start:stop:step")
    return tuple(f"{shape}:{strength}" for strength in values(strengths, f"--{name}")) if colon else (shape,)


def point_options(command: str, row: Mapping[Any, Any]) -> Point:
    """A row of a list of points: each cell a number, empty cells left out."""
    point: Point = {}
    for name, cell in row.items():
        if name is None or cell is None:
            raise InputError("--list", "a row is longer or shorter than the header", "a cell for each column")
        if cell.strip():
            axis = _axis(command, name.partition(".")[0].strip(), cell.strip())
            if len(axis) != 1:
                raise InputError("--list", f"{cell[:60]!r} is more than one value", "one value in a cell")
            point[name.strip()] = axis[0]
    return point


def typed_options(command: str, point: Point) -> argparse.Namespace:
    """The options as if they had been typed; InputError for one that is unknown, or missing."""
    flags = [v if not n else f"--{n.partition('.')[0]}" + (f"={v}" if v else "") for n, v in point.items()]
    return _command(command)[1].parse_args(flags)


def run_point(command: str, point: Point) -> dict[str, Any]:
    """One run of the command: its JSON, without what every command adds.  This is the task of a sweep."""
    options = typed_options(command, point)
    # The time is that of a point, as --max-seconds of the command says; the sweep itself may last for days.
    with limited(read_max_seconds(options)), alone:
        answer = _command(command)[0].run(options)
    if answer.failed:
        raise UndecidedError("the command's own check failed")
    data: dict[str, Any] = answer.data
    return data


@public_beside_others
def sweep_command(
    command: str,
    options: Mapping[str, str | int | Sequence[str]] | Sequence[Point],
    folder: Path | str,
    *,
    workers: int | None = None,
    executor: Executor | None = None,
    max_seconds: Number | None = None,
) -> SweepResult:
    """What ``asymptotics sweep COMMAND`` does: every combination of the values of the options, kept in ``folder``.

    ``options``: option -> a value, a comma list or a range start:stop:step, a list where the option is repeated; or a
    list of points.  InputError for what cannot be swept, and as ``sweep``.

    >>> import tempfile
    >>> sweep_command("moment", {"p": "0:1:1/2", "digits": 5}, tempfile.mkdtemp(), workers=1)
    3 points: 3 computed, 0 from the store, 0 failed
    in ... s, store ...
    """
    require_choice(command, "command", SWEPT)
    points: Grid | list[Point]
    if isinstance(options, Mapping):
        texts = [(_named(n), v if isinstance(v, list | tuple) else [v]) for n, v in options.items()]
        points = Grid(read_axes(command, [f"--{n}={_text(n, v)}" for n, each in texts for v in each]))
    elif isinstance(options, list | tuple) and all(isinstance(row, Mapping) for row in options):
        points = [point_options(command, {_named(n): _text(n, v) for n, v in row.items()}) for row in options]
    else:
        raise InputError("options", f"{shown(options)} is neither", "a mapping of options, or a list of points")
    if not points:
        raise InputError("options", "there is no point", "at least one")
    count = None if workers is None else exact_integer(workers, "workers", 1, MAX_WORKERS)
    # An option that no point could use is refused before anything is computed or a store is made.
    typed_options(command, points[0])
    return sweep(partial(run_point, command), command, points, folder, workers=count, executor=executor)


def _named(name: Any) -> str:
    if not isinstance(name, str):
        raise InputError("options", f"{shown(name)} is no name of an option", "a text such as 'alpha'")
    return name


def _text(name: str, value: Any) -> str:
    """A value as it would be typed: a text as it is, any other number as the exact one that it is."""
    return value if isinstance(value, str) else str(exact_number(value, name))
