"""``compare`` of many values beside certified ones: CPU time, and how it grows with the number of values.

Two files: turning points of quadratic drag, and samples of its motion over 100 units of tau.  The last column is the
time of 10^5 values at the rate of that row, as a share of the ten seconds that they may take: below 1 is kept.
"""

from pathlib import Path
from tempfile import TemporaryDirectory
from time import process_time

from asymptotics.decays.comparison import compare_file
from asymptotics.law import Oscillator
from asymptotics.law_given import Given
from asymptotics.turning.choose import turning_points
from benchmarks.table import Table, seconds_text

ALLOWED, VALUES, SPAN = 10.0, 100_000, 100
_DRAG = Oscillator({2: "1/10"})


def turning_rows(count: int) -> list[str]:
    """The amplitudes of turning points as doubles that are a little off."""
    points = turning_points(_DRAG.dimensionless, count, 17).points
    return ["n,x", *(f"{p.n},{float(p.x) * (1 + 1e-9)!r}" for p in points)]


def motion_rows(count: int) -> list[str]:
    """What a file of samples looks like; how right they are does not change the work."""
    return ["tau,x", *(f"{SPAN * k / count!r},{1 / (3 + k % 7)!r}" for k in range(count))]


def cpu_seconds(rows: list[str]) -> float:
    """The CPU time of one comparison, with the certified values in it."""
    with TemporaryDirectory() as folder:
        path = Path(folder) / "values.csv"
        path.write_text("\n".join(rows) + "\n", encoding="utf-8")
        start = process_time()
        compare_file(path, Given(_DRAG))
        return process_time() - start


def run(size: int = VALUES) -> Table:
    """Files of size/10 and size values of either kind."""
    rows = []
    for name, make in (("turning points", turning_rows), ("motion", motion_rows)):
        for count in (max(1, size // 10), size):
            seconds = cpu_seconds(make(count))
            share = seconds / count * VALUES / ALLOWED
            rows.append((name, str(count), seconds_text(seconds), f"{share:.2f}"))
    return Table("compare", ("file", "values", "CPU seconds", "share of 10 s for 10^5"), tuple(rows))
