"""Kinds of values: how one parameter of a question is read, of a text or of a Python object, and how it is told.

A parameter of a question is annotated with its kind, ``count: Annotated[int, whole(1, 100, "K")]``.  One reader serves
the shell, Python, the header of a file and the axes of a sweep; its errors name the argument as the asker wrote it.

>>> REAL.read("3/2", "--alpha"), whole(1, 9).read(4.0, "count")
(ExactReal('3/2'), 4)
>>> whole(1, 9).read("x", "--count")
Traceback (most recent call last):
    ...
asymptotics.errors.InputError: argument --count: 'x' is not an integer (accepted: an integer from 1 to 9)
>>> choice("nearest", "down").read("up", "rounding")
Traceback (most recent call last):
    ...
asymptotics.errors.InputError: argument rounding: 'up' is unknown (accepted: nearest, down)
"""

import argparse
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from asymptotics.ask.pairs import Pair
from asymptotics.errors import InputError, require_choice, require_flag, shown
from asymptotics.numbers.exact import REAL_FORMS
from asymptotics.numbers.policy import exact_double, exact_integer, exact_number, exact_seconds
from asymptotics.running.budget import Unasked

COMPUTED = "what to compute"


@dataclass(frozen=True)
class Option:
    """One option of the shell: its name without dashes, the letter of its value (none: a flag), its help.

    ``repeated``: it may be given again, ``several``: it takes one word or more, ``place``: it stands without its name;
    ``rest``: it is all words behind a place;
    ``words``: the values that there are, for the completion of a shell; ``beside``: what --help says of other options.
    """

    name: str
    letter: str
    help: str
    group: str = COMPUTED
    repeated: bool = False
    several: bool = False
    place: bool = False
    rest: bool = False
    needed: bool = False
    dest: str = ""
    words: tuple[str, ...] = ()
    beside: str = ""

    @property
    def key(self) -> str:
        """The name under which the parsed value is kept."""
        return self.dest or self.name.replace("-", "_")

    def add_to(self, parser: Any) -> None:
        """Declare it; every value stays a text."""
        more: dict[str, Any] = {"help": self.help}
        if self.rest:
            parser.add_argument(self.key, metavar=self.letter, nargs=argparse.REMAINDER, **more)
            return
        if self.place:
            count = "+" if self.several and self.needed else "*" if self.several else None if self.needed else "?"
            made = parser.add_argument(self.key, metavar=self.letter, nargs=count, **more)
        elif not self.letter:
            made = parser.add_argument(f"--{self.name}", dest=self.key, action="store_true", **more)
        else:
            more |= {"action": "append"} if self.repeated else {"nargs": "+"} if self.several else {}
            more |= {"metavar": self.letter, "required": self.needed}
            made = parser.add_argument(f"--{self.name}", dest=self.key, **more)
        made.words, made.beside = self.words, self.beside


@dataclass(frozen=True)
class Kind:
    """How a value is read; ``schema`` is what JSON Schema says of it.

    ``option``: what the shell calls it, where that is not the parameter's name.  ``needed``: the shell demands it,
    though Python has a default.  ``words``: its values are words and no numbers, also on the axes of a sweep.
    ``in_shell``: whether it is an option there.
    ``beside``: other parameters of the Python call that its reader takes, such as the springs of a law.
    ``options`` and ``assemble``: a kind that several options make (a law, a start); ``feeds`` says which of them may
    have set a parameter of the library, so that an error can name the one that was typed.  ``in_header``: the header of
    a file says it; no, where the table does not depend on it.
    ``pairs``: which of its options exclude or need each other; ``word``: the option that a text in Python stands for.
    """

    letter: str
    read: Callable[..., Any]
    suffix: str = ""
    schema: Mapping[str, Any] = field(default_factory=lambda: {"type": "string"})
    group: str = COMPUTED
    option: str = ""
    needed: bool = False
    words: bool = False
    place: bool = False
    several: bool = False
    default: str = ""
    beside: tuple[str, ...] = ()
    in_shell: bool = True
    options: tuple[Option, ...] = ()
    assemble: Callable[[argparse.Namespace], Any] | None = None
    feeds: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    in_header: bool = True
    pairs: tuple[Pair, ...] = ()
    word: str = ""

    def called(self, **changes: Any) -> "Kind":
        """The same kind under another option, in another group, or needed."""
        return replace(self, **changes)


REAL = Kind("A", exact_number, schema={"type": "string", "description": REAL_FORMS})


def _positive(value: Any, name: str) -> float:
    number = exact_double(value, name)
    if not number > 0:
        raise InputError(name, f"{shown(value)} is not positive", "a positive number")
    return number


POSITIVE = Kind("S", _positive)
"""A double > 0: what is known of data, which a fit uses and no claim rests on."""
FLAG = Kind("", require_flag, schema={"type": "boolean"})


def _reals(value: Any, name: str) -> tuple[Any, ...]:
    given = value.split(",") if isinstance(value, str) else value if isinstance(value, list | tuple) else [value]
    return tuple(exact_number(part, name) for part in given)


def _seconds(value: Any, name: str) -> float:
    return value if isinstance(value, Unasked) else exact_seconds(value, name)


REALS = Kind("D", _reals, schema={"type": "string", "description": f"one or several, with commas: {REAL_FORMS}"})
"""A number, or several: a list, or a text with commas."""
SECONDS = Kind(
    "S", _seconds, schema={"type": "string"}, group="limits", option="max-seconds", default="60"
)  # read where the time begins


def whole(low: int, high: int, letter: str = "N") -> Kind:
    """An integer from ``low`` to ``high``."""
    schema = {"type": "integer", "minimum": low, "maximum": high}
    return Kind(letter, lambda value, name: exact_integer(value, name, low, high), f" ({low} to {high}", schema)


def digits(high: int, default: str = "") -> Kind:
    """Significant digits; ``default``: what the help says of a default that is no number."""
    return replace(whole(1, high, "D"), group="output", default=default)


def choice(*words: str, letter: str = "NAME", of: str = "") -> Kind:
    """One of some words; ``of``: what they are, for the message about another one."""

    def read(value: Any, name: str) -> str:
        if of and isinstance(value, str) and value not in words:
            raise InputError(name, f"no {of} {value!r}", ", ".join(words))
        return require_choice(value, name, words)

    return Kind(
        letter, read, f": {', '.join(words)}",
        {"enum": list(words)}, words=True,
    )  # fmt: skip


def _text(value: Any, name: str) -> str:
    if not isinstance(value, str):
        raise InputError(name, f"{shown(value)} is no text", "a text")
    return value


TEXT = Kind("NAME", _text, words=True)
