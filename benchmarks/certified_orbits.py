"""Certified orbits: seconds for n turning points once the coefficients are there, and for a far one.

Enclosures only: neither coefficients (stated beside; panels of interpolation, or series) nor decimals are in the time.
Processor time, because the tables are ratios.

>>> run(20).columns
('what', 'coefficients', 'orbit', 'of the first')
"""

from collections.abc import Callable
from itertools import islice
from time import process_time

from flint import arb

from asymptotics.flow.damping import Damping
from asymptotics.flow.sequence import sequence
from asymptotics.flow.taylor import GUARD
from asymptotics.flow.turning import at_rest
from asymptotics.law import Law
from asymptotics.numbers.context import ctx
from asymptotics.return_map.panels import Panels
from asymptotics.return_map.sequence import Interpolated
from asymptotics.turning.choose import turning_points
from benchmarks.table import Table, seconds_text

FAR_EPSILON, FAR = "1/40", 10**9
CASES = (
    ({"3/2": "1/5"}, 15), ({"3/2": "1/5"}, 30), ({3: "1/5"}, 15), ({3: "1/5"}, 30), ({1: "1/20", 2: "1/5"}, 15),
    ({1: "1/20", 2: "1/5"}, 30), ({1: "1/20", 3: "1/5"}, 30), ({1: "1/20", 2: 2}, 30), ({"3/2": 2}, 30), ({3: 2}, 30),
)  # fmt: skip
SMALL = 100
"""Below this size only the first case runs: the coefficients cost the same at any size."""
_TITLE, _COLUMNS = "Certified orbits", ("what", "coefficients", "orbit", "of the first")


def run(size: int = 1000) -> Table:
    """``size`` turning points with their times, and the 10^9-th one to 50 digits."""
    rows, first = [], None
    for pairs, digits in CASES if size >= SMALL else CASES[:1]:
        law = Law(pairs)
        coefficients, orbit = orbit_seconds(law, digits, size)
        first = first or orbit
        label = f"{law}, {size} points and times, {digits} digits"
        rows.append((label, seconds_text(coefficients), seconds_text(orbit), f"{orbit / first:.1f}"))
    if size < SMALL:
        return Table(_TITLE, _COLUMNS, tuple(rows))
    coefficients, jump = _twice(far_point)
    label = f"alpha = 3/2, epsilon = {FAR_EPSILON}, point 10^9, 50 digits"
    rows.append((label, seconds_text(coefficients), seconds_text(jump), f"{jump / (first or 1):.1f}"))
    return Table(_TITLE, _COLUMNS, tuple(rows))


def orbit_seconds(law: Law, digits: int, size: int) -> tuple[float, float]:
    """(what the first run takes longer, the second run) of ``size`` turning points with their times."""
    bits = int(3.33 * digits) + 40
    panels = Panels.alone(law, bits)
    with ctx.workprec(bits + GUARD):
        damping = Damping.of_law(law)

    def orbit() -> None:
        with ctx.workprec(bits):
            *_, last = islice(sequence(Interpolated(damping, panels, size), at_rest(arb(1))), size + 1)
            assert last.amplitude_error < last.amplitude * arb(10) ** -digits
            assert last.time_error < last.time * arb(10) ** -digits

    return _twice(orbit)


def far_point() -> None:
    """Turning point 10^9 of alpha = 3/2 to 50 digits; the first call makes the coefficients."""
    table = turning_points(Law({"3/2": FAR_EPSILON}), 1, 50, start=FAR, route="abel-series")
    assert table.certified and len(table.points) == 1


def _twice(work: Callable[[], None]) -> tuple[float, float]:
    """(what the first call took longer, the second call)."""
    times = []
    for _ in range(2):
        start = process_time()
        work()
        times.append(process_time() - start)
    return max(times[0] - times[1], 0.0), times[1]
