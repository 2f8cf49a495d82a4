"""Which columns of a CSV file are doubles, and what they are good to: words in its header, beside the request.

``tau,amplitude,phase,code [envelope --law=2:1/10 --time=3 --double-error=amplitude:4.2e-15:relative]``: the amplitudes
are within 4.2e-15 of what they stand for, relatively.  Columns that no word names hold digits that are all right.

>>> words = error_words({"amplitude": DoubleError(Fraction("4.2e-15"), True), "phase": None})
>>> words, errors_in(words)
(['--double-error=amplitude:4.2e-15:relative'], {'amplitude': relative 4.2e-15})
"""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from pathlib import Path

from asymptotics.errors import InputError
from asymptotics.numbers.double_error import DoubleError
from asymptotics.numbers.exact import parse_printed
from asymptotics.present.inputs import DOUBLE_ERROR, header_words, with_words

_KINDS = {"relative": True, "absolute": False}


def error_words(errors: Mapping[str, DoubleError | None]) -> list[str]:
    """The words of the columns of which an error is known."""
    known = {name: e for name, e in errors.items() if e is not None}
    return [
        f"{DOUBLE_ERROR}{n}:{float(e.size):.1e}:{'relative' if e.relative else 'absolute'}" for n, e in known.items()
    ]


def with_errors(text: str, errors: Mapping[str, DoubleError | None]) -> str:
    """CSV text whose header says what its columns of doubles are good to."""
    return with_words(text, error_words(errors))


def stated_errors(path: Path) -> dict[str, DoubleError]:
    """The columns of doubles that the header of a file names, with their errors."""
    return errors_in(header_words(path))


def errors_in(words: Sequence[str]) -> dict[str, DoubleError]:
    """The same from the words of a header; InputError for one that is no column, number and kind."""
    return dict(_read(word) for word in words if word.startswith(DOUBLE_ERROR))


def _read(word: str) -> tuple[str, DoubleError]:
    accepted = f"{DOUBLE_ERROR}x:1.2e-14:absolute (or relative)"
    name, _, rest = word.removeprefix(DOUBLE_ERROR).partition(":")
    size, _, kind = rest.partition(":")
    # A header is foreign text.
    if not name or kind not in _KINDS:
        raise InputError("file", f"its header says {word[:80]!r}, which is no error of a column", accepted)
    error = parse_printed(size, "file")
    if not 0 <= error < 1:
        raise InputError("file", f"its header says {word[:80]!r}: the error is not in 0 ... 1", accepted)
    return name, DoubleError(Fraction(error), _KINDS[kind])
