"""The one loop that raises the precision: a computation in balls is repeated until it decides, or the limit is reached.

>>> from flint import arb
>>> def narrow_root(bits):
...     return bits if arb(2).sqrt().rad() < 1e-30 else None
>>> at_growing_precision(narrow_root, 30, 40)
160
>>> at_growing_precision(lambda bits: None, 5, 100, max_bits=200)
Traceback (most recent call last):
    ...
asymptotics.errors.UndecidedError: no certified 5 digits at 200 bits: the enclosure is too wide
"""

from collections.abc import Callable
from typing import TypeVar

from flint import ctx

from asymptotics.budget import tick
from asymptotics.errors import UndecidedError

Found = TypeVar("Found")


class TooWideError(UndecidedError):
    """More precision would help: the reason is told when the last precision is reached."""


def at_growing_precision(
    attempt: Callable[[int], Found | None], digits: int, bits: int, *, max_bits: int = 1 << 16
) -> Found:
    """``attempt(bits)`` at a working precision of ``bits``, 2 ``bits``, ... up to ``max_bits`` until it has a result.

    None and ``TooWideError`` ask for more precision; at the limit UndecidedError says how far it went and why.  Any
    other UndecidedError of the attempt is final.
    """
    bits = min(bits, max_bits)
    while True:
        tick(f"{bits} bits")
        reason = "the enclosure is too wide"
        with ctx.workprec(bits):
            try:
                found = attempt(bits)
            except TooWideError as wide:
                found, reason = None, str(wide)
        if found is not None:
            return found
        if bits >= max_bits:
            raise UndecidedError(f"no certified {digits} digits at {bits} bits: {reason}")
        bits = min(2 * bits, max_bits)
