"""The one loop that raises the precision: a computation in balls is repeated until it decides, or the limit is reached.

This is Ziv's strategy (ACM Trans. Math. Software 17, 1991), for decisions as well as for roundings.

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

from asymptotics.errors import UndecidedError
from asymptotics.numbers.context import ctx
from asymptotics.running.budget import tick

Found = TypeVar("Found")
TOO_WIDE = "the enclosure is too wide"


class TooWideError(UndecidedError):
    """Not decided at this precision; ``lacking``: about how many bits more will do, if the attempt can tell.

    ``of``: which of several numbers it was.
    """

    def __init__(self, reason: str = TOO_WIDE, lacking: int | None = None, of: str = "") -> None:
        super().__init__(reason)
        self.lacking, self.of = lacking, of


def at_growing_precision(
    attempt: Callable[[int], Found | None], digits: int, bits: int, *, max_bits: int = 1 << 16
) -> Found:
    """``attempt(bits)`` at a growing working precision, from ``bits`` up to ``max_bits``, until it has a result.

    None and every UndecidedError ask for more precision: how a motion goes on may show there.  Only where a loop inside
    the attempt has given up, this one does too.  The precision doubles, unless the attempt says how much is
    ``lacking``; a second guess of that kind must add half as much again, so that a tie, which no precision decides,
    ends soon.  At the limit UndecidedError says how far it went and why.
    """
    # 65,536 bits (19,728 digits) is a limit of time: what is
    # undecided there is refused, and nothing else depends on it.
    bits, least = min(bits, max_bits), 0
    while True:
        tick(f"{bits} bits")
        reason, of, more = TOO_WIDE, "", bits
        with ctx.workprec(bits):
            try:
                found = attempt(bits)
            except UndecidedError as undecided:
                # A loop inside has gone to its own limit: to double here too would multiply the two.
                if undecided.given_up:
                    raise
                found, reason, of = None, str(undecided), getattr(undecided, "of", "")
                lacking = getattr(undecided, "lacking", None)
                more = bits if lacking is None else max(lacking, least)
        if found is not None:
            return found
        if bits >= max_bits:
            raise _given_up(f"no certified {digits} digits{of and ' of ' + of} at {bits} bits: {reason}")
        least, bits = bits // 2, min(bits + more, max_bits)


def _given_up(reason: str) -> UndecidedError:
    error = UndecidedError(reason)
    error.given_up = True
    return error
