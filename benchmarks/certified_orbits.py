"""Certified orbits at small strength: seconds for n turning points once the coefficients are there, and for a far one.

Enclosures only: neither coefficients (stated beside) nor decimals are in the time.  Processor time, because the tables
are ratios.

>>> run(20).columns
('what', 'coefficients', 'orbit', 'ratio')
"""

from collections.abc import Callable
from itertools import islice
from time import process_time

from flint import arb, ctx

from asymptotics.half_swings.finite import finite_quarter
from asymptotics.numbers.exact import ExactReal, parse_real
from asymptotics.turning.far import Point, far_points
from benchmarks.table import Table, seconds_text

EPSILON, FAR_EPSILON, FAR = "1/5", "1/40", 10**9
CASES = (("3/2", 15), ("3/2", 30), ("3", 15))
SMALL = 100
"""Below this size only the first case runs: the coefficients cost the same at any size."""
_TITLE, _COLUMNS = "Certified orbits, epsilon = 1/5", ("what", "coefficients", "orbit", "ratio")


def run(size: int = 1000) -> Table:
    """``size`` turning points with their times at epsilon = 1/5, and the 10^9-th one to 50 digits."""
    rows, first = [], None
    for alpha, digits in CASES if size >= SMALL else CASES[:1]:
        exponent = parse_real(alpha, "alpha")
        coefficients, orbit = _twice(lambda exponent=exponent, digits=digits: _orbit(exponent, digits, size))
        first = first or orbit
        label = f"alpha = {alpha}, {size} points and times, {digits} digits"
        rows.append((label, seconds_text(coefficients), seconds_text(orbit), f"{orbit / first:.1f}"))
    if size < SMALL:
        return Table(_TITLE, _COLUMNS, tuple(rows))
    coefficients, jump = _twice(lambda: _far(parse_real("3/2", "alpha")))
    label = f"alpha = 3/2, epsilon = {FAR_EPSILON}, point 10^9, 50 digits"
    rows.append((label, seconds_text(coefficients), seconds_text(jump), f"{jump / (first or 1):.1f}"))
    return Table(_TITLE, _COLUMNS, tuple(rows))


def _orbit(alpha: ExactReal, digits: int, size: int) -> None:
    bits = int(3.33 * digits) + 16
    with ctx.workprec(bits + 12):
        epsilon = parse_real(EPSILON, "epsilon").ball()
        quarter = finite_quarter([alpha], [epsilon], bits)
        *_, (x, e, _) = islice(quarter.orbit([epsilon], arb(0), arb(0)), size + 1)
        assert e < arb(10) ** -digits, x


def _far(alpha: ExactReal) -> None:
    with ctx.workprec(230):
        point = next(far_points(alpha, parse_real(FAR_EPSILON, "epsilon").ball(), [Point(0, arb(0), arb(0))], FAR))
        assert point.amplitude.rel_accuracy_bits() > 167


def _twice(work: Callable[[], None]) -> tuple[float, float]:
    """(what the first call took longer, the second call)."""
    times = []
    for _ in range(2):
        start = process_time()
        work()
        times.append(process_time() - start)
    return max(times[0] - times[1], 0.0), times[1]
