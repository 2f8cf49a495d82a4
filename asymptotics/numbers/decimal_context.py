"""The door of ``numbers.context`` for mpmath: its precision, and that of its intervals, are the process's as well.

>>> with workdps(30):
...     mpmath.mp.dps
30
"""

from collections.abc import Iterator
from contextlib import contextmanager

import mpmath

from asymptotics.numbers.context import Setting, alone

# A child that is forked while another thread works sets these back as well.
alone.guarded += [(mpmath.mp, "prec"), (mpmath.iv, "prec")]


@contextmanager
def workdps(digits: int) -> Iterator[None]:
    """``mpmath.workdps``, alone."""
    # Left in the opposite order: the digits are set back first, the lock is released last.
    with alone, mpmath.workdps(digits):
        yield


def intervals(bits: int) -> Setting:
    """``with intervals(bits):`` intervals of mpmath at that many bits."""
    return Setting(mpmath.iv, "prec", bits)
