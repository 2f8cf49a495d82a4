"""What the header of a CSV file says of the request that made it, where the oscillator alone does not say it all.

A fixed list of commands, each with a fixed list of options: nothing that reads or writes a file is among them.

>>> request_words(loaded("stokes"), argparse.Namespace(alpha="2", count="2", digits=None, csv="out.csv"))
['stokes', '--alpha=2', '--count=2']
>>> stated_request(["stokes", "--alpha=2", "--count=2"])
('stokes', {'alpha': '2', 'count': '2'})
>>> stated_request(["stokes", "--csv=/etc/motd"])
Traceback (most recent call last):
    ...
asymptotics.errors.InputError: argument FILE: its header says '--csv=/etc/motd' of stokes, ... (accepted: ...)
"""

import argparse
from collections.abc import Sequence
from typing import Any

from asymptotics.ask.registry import QUESTIONS, loaded
from asymptotics.errors import InputError, shown
from asymptotics.present.inputs import option_words

REQUESTS = {
    "damping-law": ("A", "zeta", "Q", "decrement", "resolution", "laws", "spring", "mass", "stiffness"),  # --from
}
_PLACED = "what"


def request_words(command: Any, options: argparse.Namespace) -> list[str]:
    """The command and what it was asked for; nothing where the oscillator says enough."""
    if not isinstance(command, str):  # a question
        words: list[str] = command.words(options)
        return words
    given = {name: getattr(options, name, None) for name in REQUESTS[command]}
    return [command, *option_words(given)]


def stated_request(words: Sequence[str]) -> tuple[str, dict[str, str]]:
    """The command and its options, by name, from the words of a header; InputError, by name, for any other word."""
    command, *rest = words
    if command not in REQUESTS and not _is_asked_again(command):
        raise InputError("FILE", f"its header names no command that is asked again: {shown(command)}", _accepted())
    known, flags, repeated_ones = _known(command)
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


def _is_asked_again(command: str) -> bool:
    """Whether it is a question whose header is its request."""
    if command not in QUESTIONS:
        return False
    offers = loaded(command).offers
    return bool(offers.table) and offers.asked_again and not offers.oscillator_alone


def _known(command: str) -> tuple[tuple[str, ...], tuple[str, ...], tuple[str, ...]]:
    """The options of a command that a header may have, those without a value, and those that may be repeated."""
    if command in REQUESTS:
        return REQUESTS[command], (), ("law", "spring")
    options = loaded(command).header_options
    names = tuple(_PLACED if o.place else o.name for o in options)
    return names, tuple(o.name for o in options if not o.letter), tuple(o.name for o in options if o.repeated)


def _accepted() -> str:
    return ", ".join([*REQUESTS, "sweep"])
