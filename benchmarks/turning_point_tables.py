"""1000 turning points for alpha = 2, epsilon = 1/10, 30 digits: certified balls beside the same map in mpmath.

mpmath knows nothing of its own rounding error, and 1 + W_0(-y e^-y) loses digits next to the branch point: when it
works with the digits asked for and no more, the last ones are wrong.  It is timed with and without guard digits.

>>> wrong_digits(lambert_iteration(10, 30), certified(10, 30)) > 0
True
"""

import mpmath

from asymptotics.law import Law
from asymptotics.numbers.decimal_context import workdps
from asymptotics.turning.choose import turning_points
from benchmarks.table import Table, best_time, seconds_text

EPSILON = "1/10"
GUARD = 20


def certified(count: int, digits: int) -> list[str]:
    """|x_n|/x_0, correctly rounded and proved to be."""
    table = turning_points(Law({2: EPSILON}), count, digits, route="quadratic")
    return [point.x.lstrip("-") for point in table.points]


def lambert_iteration(count: int, digits: int, guard: int = 0) -> list[str]:
    """The same by q = 1 + W_0(-(1+p) e^(-(1+p))) in mpmath, with ``guard`` more digits inside."""
    with workdps(digits + guard):
        start = p = mpmath.mpf(2) / 10
        found = []
        for _ in range(count):
            found.append(mpmath.nstr(p / start, digits, strip_zeros=False))
            y = 1 + p
            p = 1 + mpmath.lambertw(-y * mpmath.exp(-y)).real
    return found


def wrong_digits(values: list[str], right: list[str]) -> int:
    """The largest number of wrong trailing digits of a value."""
    worst = 0
    for value, truth in zip(values, right, strict=True):
        digits = len(truth.partition("e")[0].replace(".", "").lstrip("0"))
        with workdps(2 * digits):
            error = abs(mpmath.mpf(value) / mpmath.mpf(truth) - 1)
            known = digits if error == 0 else int(-mpmath.log10(error))
        worst = max(worst, digits - known - 1 if known < digits else 0)
    return worst


def run(size: int = 1000, digits: int = 30) -> Table:
    """``size`` turning points: seconds, ratio, and the wrong digits at the end of the worst value."""
    right = certified(size, digits)
    first = best_time(lambda: certified(size, digits))
    rows = [("certified balls", seconds_text(first), "1.0", "0 (proved)")]
    for guard in (0, GUARD):
        seconds = best_time(lambda guard=guard: lambert_iteration(size, digits, guard))
        wrong = wrong_digits(lambert_iteration(size, digits, guard), right)
        label = f"mpmath.lambertw, {digits + guard} digits inside"
        rows.append((label, seconds_text(seconds), f"{seconds / first:.1f}", str(wrong)))
    title = f"{size} turning points, alpha = 2, epsilon = {EPSILON}, {digits} digits"
    return Table(title, ("what", "seconds", "ratio", "wrong digits"), tuple(rows))
