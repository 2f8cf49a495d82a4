"""The errors a user can meet; every message names the argument, the reason and what is accepted, on one short line.

>>> raise InputError("--digits", "0 is not positive", "an integer from 1 to 10000")
Traceback (most recent call last):
    ...
asymptotics.errors.InputError: argument --digits: 0 is not positive (accepted: an integer from 1 to 10000)
>>> str(InputError("--x0", "'\\x1b[2J' is no number" + 500 * "!", "3/2"))[:45]
"argument --x0: '\\\\x1b[2J' is no number!!!!!!!!"

What a user typed comes back in the message, so this is the one place where it is made harmless: control characters,
line ends and what else does not print are escaped, and what is long loses its middle (`printable`).
"""

from collections.abc import Iterable

_VOWELS = ("ndarray", "mpf", "mpc")  # types whose first letter is spoken as a vowel
# What keeps a message on one line that is read at a glance; of anything longer the middle is left out.
MAX_ARGUMENT, MAX_REASON, MAX_ACCEPTED = 60, 240, 400


def printable(text: str, limit: int) -> str:
    """``text`` on one line: what does not print is escaped; beyond ``limit`` characters the middle is left out.

    >>> printable("a\\tb" + chr(0x202e), 60), printable("0123456789" * 9, 21)
    ('a\\\\tb\\\\u202e', '01234567 ... 23456789')
    """
    # Cut before it is escaped, so that no escape is torn: the line may be somewhat longer than the limit.
    if len(text) > limit:
        half = (limit - 5) // 2
        text = f"{text[:half]} ... {text[-half:]}"
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in text)


class InputError(ValueError):
    """A value that cannot be used: ``argument`` names it, ``reason`` says why, ``accepted`` says what can be used."""

    def __init__(self, argument: str, reason: str, accepted: str) -> None:
        super().__init__(argument, reason, accepted)
        self.argument, self.reason, self.accepted = argument, reason, accepted

    def __str__(self) -> str:
        argument, reason = printable(self.argument, MAX_ARGUMENT), printable(self.reason, MAX_REASON)
        return f"argument {argument}: {reason} (accepted: {printable(self.accepted, MAX_ACCEPTED)})"


class AbsentError(InputError, AttributeError):
    """A property that this value has not: ``hasattr`` says no, as of any other name.

    >>> from asymptotics.numbers.exact import ExactReal
    >>> hasattr(ExactReal(1, 2), "rational"), hasattr(ExactReal(1, 4), "rational")
    (False, True)
    """


class LimitError(InputError):
    """A value that could be used but asks for more work than the stated limit; the reason carries the estimate."""


class UndecidedError(ArithmeticError):
    """A certified computation could not decide within its precision limit; nothing is claimed.

    ``given_up``: more precision has been tried up to the limit (``numbers.precision``).
    """

    given_up = False


def shown(value: object) -> str:
    """An offending value for a message: what was typed, of foreign objects only the type, whose repr may be anything.

    >>> shown("averag"), shown(None), shown(object())
    ("'averag'", 'None (NoneType)', 'an object')
    """
    kind = type(value).__name__
    # 60 characters and 40 digits are for a message on one line;
    # Python refuses to print an integer of more than 4300 digits.
    if isinstance(value, str):
        return repr(value[:60])
    if isinstance(value, int) and not isinstance(value, bool):
        return f"{value} ({kind})" if abs(value) < 10**40 else f"an integer of {value.bit_length()} bits"
    if value is None or isinstance(value, bool | float | complex | bytes):
        return f"{value!r:.60} ({kind})"
    return f"{'an' if kind in _VOWELS or kind[0] in 'aeioAEIO' else 'a'} {kind}"


def require_choice(value: object, argument: str, choices: Iterable[str]) -> str:
    """``value`` if it is one of the texts ``choices``; InputError otherwise.

    >>> require_choice("down", "rounding", ["up"])
    Traceback (most recent call last):
        ...
    asymptotics.errors.InputError: argument rounding: 'down' is unknown (accepted: up)
    """
    accepted = tuple(choices)
    if not isinstance(value, str) or value not in accepted:
        raise InputError(argument, f"{shown(value)} is unknown", ", ".join(accepted))
    return value


def require_flag(value: object, argument: str) -> bool:
    """``value`` if it is True or False; InputError for anything else, which would only be true in effect."""
    if not isinstance(value, bool):
        raise InputError(argument, f"{shown(value)} is no truth value", "True or False")
    return value
