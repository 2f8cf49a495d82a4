"""The options of a question as the axes of a sweep, and one point of a sweep as one answer.

>>> read_axes("moment", ["--p", "0:1:1/2", "--digits=20"])
{'p': ('0', '1/2', '1'), 'digits': ('20',)}
>>> run_point("moment", {"p": "2", "digits": "5"})
{'p': '2', 'value': '0.50000', 'exact': '1/2'}
"""

import re
from collections.abc import Iterable, Mapping
from types import MappingProxyType
from typing import Any

from asymptotics.ask.kinds import SECONDS, Kind, Option
from asymptotics.ask.moving import PHYSICAL, plain_list
from asymptotics.ask.registry import loaded
from asymptotics.ask.typed import answered
from asymptotics.errors import InputError, UndecidedError
from asymptotics.numbers.context import alone
from asymptotics.numbers.exact import parse_real
from asymptotics.running.budget import DEFAULT_SECONDS
from asymptotics.running.public import limited
from asymptotics.sweeps.grid import Point, values
from asymptotics.terms_given import PENDULUM

_WORD = re.compile(r"[a-z][a-z0-9-]{0,39}\Z")
_FORMAL = ("expand", "half-swing")  # they need no strengths


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
    names, frame = [name for name, _ in given], _frame(given)
    axes: dict[str, tuple[str, ...]] = {}
    for name, text in given:
        repeated = names.count(name) > 1 and name
        label = f"{name}.{1 + sum(key.startswith(name + '.') for key in axes)}" if repeated else name
        axes[label] = _axis(command, name, text, frame)
    return axes


def _option(command: str, name: str) -> tuple[Kind, Option]:
    """An option with the kind of its parameter; ``name`` is empty for what stands without one.

    InputError for what writes a file or shapes what is printed: that is no parameter of the question.
    """
    for asked in loaded(command).asked:
        for option in asked.options:
            if option.name == name or (option.place and not name):
                return asked.kind, option
    raise InputError(f"--{name}", "it cannot be swept", f"the options of asymptotics {command} that are numbers")


def takes_no_value(command: str, name: str) -> bool:
    """Whether an option is a flag; InputError for one that cannot be swept."""
    return not _option(command, name)[1].letter


def _frame(given: Iterable[tuple[str, str]]) -> dict[str, bool]:
    """What units starts may have beside these options."""
    options = [(name.partition(".")[0], text) for name, text in given]
    return {"physical": any(name in PHYSICAL for name, _ in options), "pendulum": ("spring", PENDULUM) in options}


def _axis(command: str, name: str, text: str, frame: dict[str, bool]) -> tuple[str, ...]:
    if name and takes_no_value(command, name):
        return ("",)
    # The colon of a force is not that of a range: the powers are cut off first.
    if name in ("law", "spring"):
        return _forces(command, name, text)
    if name == "" or _option(command, name)[0].words or text == "symbolic":
        words = tuple(text.split(","))
        for word in words:
            if not _WORD.match(word):
                argument = f"--{name}" if name else "COMMAND"
                raise InputError(argument, f"{word[:60]!r} is not a word", "the command's words, with commas")
        return words
    return values(plain_list(text, name, **frame), f"--{name}")


def _forces(command: str, name: str, text: str) -> tuple[str, ...]:
    """A term with a list or a range of strengths, A:E,E,... or A,M:start:stop:step; the powers are one pair."""
    powers, colon, strengths = text.partition(":")
    if text == PENDULUM:
        return (text,)
    shape = ",".join(str(parse_real(power, f"--{name}")) for power in powers.split(","))
    if not colon and command not in _FORMAL:
        raise InputError(f"--{name}", f"{text[:60]!r} has no colon", "A:E, A:E,E,... or A:start:stop:step")
    return tuple(f"{shape}:{strength}" for strength in values(strengths, f"--{name}")) if colon else (shape,)


def point_options(command: str, row: Mapping[Any, Any], beside: Mapping[str, str] = MappingProxyType({})) -> Point:
    """A row of a list of points: each cell a number, empty cells left out; ``beside``: options that hold for all."""
    point: Point = {}
    frame = _frame((str(name).strip(), str(cell).strip()) for name, cell in (*beside.items(), *row.items()) if cell)
    for name, cell in row.items():
        if name is None or cell is None:
            raise InputError("--list", "a row is longer or shorter than the header", "a cell for each column")
        if cell.strip():
            axis = _axis(command, name.partition(".")[0].strip(), cell.strip(), frame)
            if len(axis) != 1:
                raise InputError("--list", f"{cell[:60]!r} is more than one value", "one value in a cell")
            point[name.strip()] = axis[0]
    return point


def run_point(command: str, point: Point) -> dict[str, Any]:
    """One answer of the command: its record.  This is the task of a sweep."""
    text = point.get("max-seconds")
    # The time is that of a point, as --max-seconds of the command says; the sweep itself may last for days.
    seconds = DEFAULT_SECONDS if text is None else SECONDS.read(text, "--max-seconds")
    with limited(seconds), alone:
        found = answered(command, point)
    if found.failed:
        raise UndecidedError("the command's own check failed")
    return found.data
