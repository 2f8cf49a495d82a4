"""A source without times gets a clock: n/rate for row n, from --rate or from what the file says above its numbers.

>>> from asymptotics.decays.records.sources import opened
>>> given = clocked(opened({"angle (deg)": [3.0, 2.0, -3.0]}, How(rate=250)), How(rate=250))
>>> given.names, given.read([1]).columns[1]
(('angle (deg)', 'clock (s)'), array([0.   , 0.004, 0.008]))
"""

import re
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from asymptotics.decays.records.body import Body
from asymptotics.decays.records.columns import quantity
from asymptotics.decays.records.sources import How, Source
from asymptotics.errors import InputError

CLOCK = "clock (s)"


def clocked(given: Source, how: How) -> Source:
    """The source, with a column of times behind the others where a rate is said and no column is a time."""
    timed = any(quantity(name) in ("time", "n", "amplitude") for name in given.names) or names_time(how.columns)
    rate = how.rate or (None if timed else given.rate)
    if rate is None:
        return _with_times(given, timed, how)
    place, known = len(given.names), float(rate)

    def read(wanted: Sequence[int]) -> Body:
        others = [i for i in wanted if i != place] or [0]
        body = given.read(others)
        times = np.arange(len(body.lines)) / known
        return replace(body, columns={i: times if i == place else body.columns[i] for i in wanted})

    # A single column without a name is the motion.
    names = given.names if given.headed or place > 1 else ("x",)
    said = f"{'--rate' if how.rate else 'the file'} says {known:.6g} samples a second: times are n/{known:.6g} s"
    return replace(
        given, names=(*names, CLOCK), headed=True, read=read, sample=lambda wanted: read(wanted).columns,
        notes=(*given.notes, said),
    )  # fmt: skip


def names_time(columns: str | None) -> bool:
    """Whether --columns says which column is the time, or the number of a turning point.

    >>> names_time("x=2, t=1"), names_time("x=2"), names_time(None)
    (True, False, False)
    """
    return columns is not None and bool(re.search(r"(?:^|,)\s*(?:t|n|amplitude)\s*=", columns))


def _with_times(given: Source, timed: bool, how: How) -> Source:
    """The source as it is; InputError for one column, which holds no motion without a clock."""
    if len(given.names) == 1 and not timed:
        reason = f"{given.name} has one column, {given.names[0][:40]!r}, and no times"
        raise InputError("FILE", reason, "--rate HZ: samples a second; or a column of times")
    return given
