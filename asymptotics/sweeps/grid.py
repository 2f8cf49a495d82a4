"""Where a sweep goes: a grid (every combination of the values of its axes) or a list of points, all values exact text.

An axis is written ``start:stop:step`` (both ends included), a single value, or a list of these with commas.

>>> values("1:2:1/4", "--alpha")
('1', '5/4', '3/2', '7/4', '2')
>>> values("0.1,sqrt(2)", "--alpha")
('1/10', 'sqrt(2)')
>>> grid = Grid({"alpha": ("1", "2"), "epsilon": ("1/10", "1/5", "3/10")})
>>> len(grid), grid[4]
(6, {'alpha': '2', 'epsilon': '1/5'})

A grid is never written out: its points are computed from their numbers, and its size is known before it is made.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import lcm, prod

from asymptotics.errors import InputError, LimitError
from asymptotics.numbers.exact import parse_rational, parse_real

# At a millisecond a point three hours of one core, and 5 GB of store: more is likely a slip, or wants several sweeps.
MAX_POINTS = 10**7
RANGE_FORMS = "start:stop:step with both ends met by the step, or a comma list: 1:3:1/10, 1,3/2,sqrt(2)"

Point = dict[str, str]


def values(text: str, argument: str) -> tuple[str, ...]:
    """The exact values of a range, a list or a single number, in the order written, without repetition.

    Raises InputError for what is no number and for a step that misses the end, LimitError for more than 10^7 values.
    """
    # Without repetition, in the order written: a point met twice would be computed once anyway and counted as reused.
    found = [value for part in text.split(",") for value in _part(part, argument)]
    if len(found) > MAX_POINTS:
        raise too_large(len(found), argument)
    return tuple(dict.fromkeys(found))


def _part(text: str, argument: str) -> tuple[str, ...]:
    if ":" not in text:
        return (str(parse_real(text, argument)),)
    ends = text.split(":")
    if len(ends) != 3:
        raise InputError(argument, f"{text[:60]!r} is not a range", RANGE_FORMS)
    start, stop, step = (parse_rational(end, argument) for end in ends)
    if not step:
        raise InputError(argument, f"{text[:60]!r} has the step 0", RANGE_FORMS)
    steps = (stop - start) / step
    if steps < 0:
        raise InputError(argument, f"{text[:60]!r} steps away from its end", RANGE_FORMS)
    # A last value that the step passes by is asked for: most likely one of the three numbers is a slip.
    if steps.denominator != 1:
        last = start + step * (steps.numerator // steps.denominator)
        reason = f"{text[:60]!r} does not meet its end {stop}: the last values are {last} and {last + step}"
        raise InputError(argument, reason, RANGE_FORMS)
    if steps >= MAX_POINTS:
        raise too_large(int(steps) + 1, argument)
    # Integers over one denominator: a range of millions of Fractions added up would reduce each sum anew.
    bottom = lcm(start.denominator, step.denominator)
    first, pace = int(start * bottom), int(step * bottom)
    return tuple(str(Fraction(first + pace * i, bottom)) for i in range(int(steps) + 1))


@dataclass(frozen=True)
class Grid(Sequence[Point]):
    """All combinations of the values of named axes; the last axis runs fastest.  LimitError above 10^7 points."""

    axes: Mapping[str, tuple[str, ...]]

    def __post_init__(self) -> None:
        size = prod(len(values) for values in self.axes.values())
        if size > MAX_POINTS:
            raise too_large(size, "grid")

    def __len__(self) -> int:
        return prod(len(values) for values in self.axes.values())

    def __getitem__(self, index: int) -> Point:  # type: ignore[override]
        if not 0 <= index < len(self):
            raise IndexError(index)
        point = {}
        # The index in the mixed radix of the lengths of the axes, last digit first.
        for name, axis in reversed(list(self.axes.items())):
            index, place = divmod(index, len(axis))
            point[name] = axis[place]
        return dict(reversed(point.items()))

    def __iter__(self) -> Iterator[Point]:
        return (self[i] for i in range(len(self)))


def too_large(size: int, argument: str) -> LimitError:
    """The refusal of a sweep of ``size`` points, with what it would cost at a millisecond and 500 bytes a point."""
    days, gigabytes = size / 1000 / 86400, size * 500 / 1e9
    cost = f"about {days:.2g} days at 1 ms a point on one core and {gigabytes:.2g} GB"
    reason = f"{_power(size)} points would take {cost}"
    return LimitError(argument, reason, f"at most {MAX_POINTS} points in one sweep")


def _power(size: int) -> str:
    digits = len(str(size)) - 1
    return f"10^{digits}" if str(size) == "1" + "0" * digits else f"about {size / 10**digits:.2g}*10^{digits}"
