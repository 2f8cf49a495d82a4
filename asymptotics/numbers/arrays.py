"""Arrays of doubles, from whatever stands for one: where curves are drawn, a number is a double and no more.

What is exact (text, fractions, SymPy) is read by the number policy first; NaN keeps its place as a gap in the data.

>>> from fractions import Fraction
>>> real_array([0, "1/2", Fraction(3, 4), float("nan")], "time").tolist()
[0.0, 0.5, 0.75, nan]
>>> real_array([1, 2j], "time")
Traceback (most recent call last):
    ...
asymptotics.errors.InputError: argument time: 2j (complex) is not an exact number (accepted: ...)
"""

from typing import Any

import numpy as np

from asymptotics.errors import InputError, LimitError, shown
from asymptotics.numbers.policy import double_of, exact_number

_ACCEPTED = "a number, or an array of numbers"
# What is made of an array has several of its size: beyond, the memory of a usual machine ends without a word.
MAX_SIZE = 50_000_000


def real_array(value: Any, argument: str) -> Any:
    """``value`` as an array of doubles of the same shape; InputError names ``argument`` for what is none.

    LimitError for more than ``MAX_SIZE`` numbers, before they are made.
    """
    _require_size(value, argument)
    if isinstance(value, bytes | bytearray | memoryview):  # NumPy reads a buffer: b"1" would be the number 49
        raise InputError(argument, f"{shown(value)} is not an array of numbers", _ACCEPTED)
    try:
        given = np.asarray(value)
    except (TypeError, ValueError):  # rows of different lengths
        raise InputError(argument, f"{shown(value)} is not an array of numbers", _ACCEPTED) from None
    # Doubles and machine integers are taken as they are; a masked entry is a gap in the data, for which NaN stands.
    if given.dtype.kind in "fiu":
        masked = np.ma.isMaskedArray(value)
        return np.ma.filled(value.astype(float), np.nan) if masked else given.astype(float)
    # Objects and text go on to the number policy, complex numbers and bools with them, to be refused by name.
    if given.dtype.kind not in "OUcb":
        raise InputError(argument, f"an array of {given.dtype} is not an array of numbers", _ACCEPTED)
    # The user's own list, where there is one: NumPy would make
    # text of all of [0, "1/2"], and 0.1 is read as it was typed.
    cells = [value] if not given.ndim else list(value) if given.ndim == 1 else given.ravel().tolist()
    return np.array([_double(cell, argument) for cell in cells]).reshape(given.shape)


def _require_size(value: Any, argument: str) -> None:
    """A range or a view holds more numbers than there is memory for: its size is asked before it is read."""
    try:
        size = int(value.size) if isinstance(value, np.ndarray) else len(value)
    except OverflowError:  # a range of more than 2^63 numbers has no length in Python
        size = MAX_SIZE + 1
    except Exception:  # a number has no length; a foreign object may fail in any way
        return
    if size > MAX_SIZE:
        raise LimitError(argument, "it has too many numbers", f"at most {MAX_SIZE} at once")


def _double(cell: Any, argument: str) -> float:
    if isinstance(cell, float | np.floating):
        return float(cell)
    try:
        return double_of(exact_number(cell, argument))
    except OverflowError:
        raise InputError(argument, "it is too large for a double", _ACCEPTED) from None
