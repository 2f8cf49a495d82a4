"""The gate for what was typed: words are text, and every option has such a value as its kind says.

>>> words(["--epsilon", "-1/2", "--law", "2:1"])
['--epsilon=-1/2', '--law', '2:1']
>>> words(["--digits=--"])
Traceback (most recent call last):
    ...
asymptotics.errors.InputError: argument --digits: '--' is no value (accepted: see --help)
"""

import argparse
import re
from collections.abc import Sequence
from typing import Any

from asymptotics.errors import InputError, shown

_OPTION = re.compile(r"--[a-z][a-z0-9-]*")
# -inf and -nan are joined as well: the reader of numbers refuses them by the name of the option, argparse would say
# that the option has no value.
_NEGATIVE_VALUE = re.compile(r"-(\d|\.\d|sqrt|inf|nan)", re.IGNORECASE)


def words(arguments: Sequence[Any]) -> list[str]:
    """The arguments as argparse shall have them: InputError for what is no text, and for ``--option=--``.

    ``--epsilon -1/2`` becomes ``--epsilon=-1/2``: argparse would take the value for an option.  It would drop a value
    ``--``, whatever stands before it.
    """
    joined: list[str] = []
    for argument in arguments:
        if not isinstance(argument, str):
            raise InputError("argv", f"{shown(argument)} is no text", "a list of words")
        name, equals, value = argument.partition("=")
        if equals and value == "--" and name.startswith("-"):
            raise InputError(name, "'--' is no value", "see --help")
        if joined and _OPTION.fullmatch(joined[-1]) and _NEGATIVE_VALUE.match(argument):
            joined[-1] += "=" + argument
        else:
            joined.append(argument)
    return joined


def typed(options: argparse.Namespace) -> argparse.Namespace:
    """The options, if each is a text, a list of texts, a flag or absent; InputError otherwise."""
    for name, value in vars(options).items():
        parts = value if isinstance(value, list) else [value]
        if not all(part is None or isinstance(part, str | bool) for part in parts):
            raise InputError(f"--{name.replace('_', '-')}", f"{shown(value)} is no text", "see --help")
        if not all(_is_whole(part) for part in parts if isinstance(part, str)):
            raise InputError(name, f"{shown(value)} has half a character", "see --help")
    return options


def _is_whole(text: str) -> bool:
    """Whether a text may be the name of a file: no half of a surrogate pair but those that Python makes of bytes."""
    try:
        text.encode("utf-8", "surrogateescape")
    except UnicodeEncodeError:
        return False
    return True
