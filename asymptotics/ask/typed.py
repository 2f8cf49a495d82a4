"""A request as words, of a header or of a point of a sweep: read as the shell reads them, without the shell.

>>> stated_request(["stokes", "--alpha=2", "--count=2"])
('stokes', {'alpha': '2', 'count': '2'})
>>> stated_request(["stokes", "--csv=/etc/motd"])
Traceback (most recent call last):
    ...
asymptotics.errors.InputError: argument FILE: its header says '--csv=/etc/motd' of stokes, ... (accepted: ...)
>>> answered("moment", {"p": "2", "digits": "5"}).data
{'p': '2', 'value': '0.50000', 'exact': '1/2'}
"""

import argparse
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any, NoReturn

from asymptotics.ask.answers import Request
from asymptotics.ask.moving import without_units
from asymptotics.ask.question import Question
from asymptotics.ask.registry import ANSWERING, loaded
from asymptotics.errors import InputError, shown

_PLACED = "what"


class _Parser(argparse.ArgumentParser):
    """A parser that raises what it has to say."""

    def error(self, message: str) -> NoReturn:
        raise InputError("COMMAND", " ".join(message.split()), f"the options of asymptotics {self.prog}")


# One parser for all points of a process: declaring the options costs more than a cheap point.
@lru_cache
def parser_of(name: str) -> argparse.ArgumentParser:
    """The parser of a question's options."""
    parser = _Parser(prog=name, allow_abbrev=False, add_help=False)
    loaded(name).add_to(parser)
    return parser


def typed_options(name: str, point: Mapping[str, str]) -> argparse.Namespace:
    """The options as if they had been typed; InputError for one that is unknown, or missing."""
    flags = [v if not n else f"--{n.partition('.')[0]}" + (f"={v}" if v else "") for n, v in point.items()]
    return without_units(parser_of(name).parse_args(flags))


@dataclass(frozen=True)
class Answered:
    """A question that was asked: its request, and what was found."""

    question: Question
    request: Request
    found: Any

    @property
    def failed(self) -> bool:
        """Whether a check of its own has failed."""
        return bool(self.question.offers.failed(self.found, self.request))

    @cached_property
    def data(self) -> dict[str, Any]:
        """Its record: what --json prints, without what every command adds."""
        return self.question.offers.record(self.found, self.request)

    @property
    def csv(self) -> str:
        """Its table: what --csv writes."""
        return str(self.question.offers.as_csv(self.found, self.request))

    @property
    def certified(self) -> bool:
        """What the answer itself says; exact arithmetic is."""
        said, arithmetic = self.data.get("certified"), self.data.get("arithmetic")
        again = self.question.offers.again
        exact = arithmetic in ("exact", "certified") or (again is not None and again.exact)
        return said is True or (said is None and exact)


def answered(name: str, point: Mapping[str, str], *, file: bool = False) -> Answered:
    """The question at a point, as the shell asks it; ``file``: for its table."""
    options = typed_options(name, point)
    if file:
        options.csv = f"{name}.csv"  # what has no effect without a table is no fault where one is asked for
    asked = loaded(name)
    request = Request(asked.of_options(options), options)
    asked.offers.typed(request)
    of_shell = asked.offers.of_shell
    found = asked.function(**request.values) if of_shell is None else of_shell(request)
    return Answered(asked, request, found)


def stated_request(words: Sequence[str]) -> tuple[str, dict[str, str]]:
    """The command and its options, by name, from the words of a header; InputError, by name, for any other word."""
    command, *rest = words
    if command not in ANSWERING or not loaded(command).in_header:
        accepted = ", ".join([*(name for name in ANSWERING if loaded(name).in_header), "sweep"])
        raise InputError("FILE", f"its header names no command that is asked again: {shown(command)}", accepted)
    known, flags, repeated_ones = _known(loaded(command))
    point = dict[str, str]()
    for word in rest:
        name, equals, value = word.removeprefix("--").partition("=")
        # A header is foreign text: one word without an option's name where the command has a place for it, and
        # otherwise options of the list, flags without and all others with a value.  Anything else is refused.
        if not word.startswith("--") and _PLACED in known and "" not in point:
            point[""] = word
        elif not word.startswith("--") or name not in known or name == _PLACED or bool(equals) == (name in flags):
            accepted = ", ".join(f"--{each}" for each in known if each != _PLACED)
            raise InputError("FILE", f"its header says {shown(word)} of {command}, which is not asked again", accepted)
        else:
            # A mapping has each key once: repeated options are numbered, law.1, law.2, as the axes of a sweep are.
            repeated = sum(key.partition(".")[0] == name for key in point)
            if repeated and name not in repeated_ones:
                raise InputError("FILE", f"its header says --{name} twice", "each option once")
            point[f"{name}.{repeated + 1}" if name in repeated_ones else name] = value
    return command, point


def _known(asked: Question) -> tuple[tuple[str, ...], tuple[str, ...], tuple[str, ...]]:
    """The options of a command that a header may have, those without a value, and those that may be repeated."""
    again = asked.offers.again
    options, more = asked.header_options, () if again is None else again.words
    # A header with words of its own (a table in the place of its file) has no other option: FILE names a file.
    names = more or tuple(_PLACED if o.place else o.name for o in options)
    repeated = tuple(o.name for o in options if o.repeated and o.name in names)
    return names, tuple(o.name for o in options if not o.letter and o.name in names), repeated
