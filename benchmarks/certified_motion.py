"""What a proof costs at finite strength: certified motion and turning points beside an integrator that knows no error.

The motion: x at many times over 100 swings for alpha = 3/2, epsilon = 1/10, 20 proved digits, and DOP853 of SciPy with
its dense output at its tightest tolerance (about 10 digits, measured, not proved).  The turning points: 30 digits with
times, for three laws, decimals included; the last but one column has the motion by DOP853 as its unit.
"""

from fractions import Fraction

import numpy as np
from scipy.integrate import solve_ivp

from asymptotics.law import Law, Oscillator
from asymptotics.motions.reference import reference_states
from asymptotics.numbers.exact import ExactReal
from asymptotics.turning.choose import turning_points
from benchmarks.table import Table, best_time, seconds_text

SWINGS, DIGITS, LONG = 100, 20, 600.0
LAWS = {"alpha = 3/2, 1/5": {"3/2": "1/5"}, "alpha = 3, 1/5": {3: "1/5"}, "(1, 2), 1/20, 1/5": {1: "1/20", 2: "1/5"}}


def certified(times: list[Fraction]) -> list[float]:
    """X at the times, from enclosures."""
    system = Oscillator(Law({"3/2": "1/10"}))
    found = reference_states(system, [ExactReal(t) for t in times], DIGITS, max_seconds=LONG)
    return [float(x.mid()) for x in found.x]


def dop853(times: list[Fraction]) -> list[float]:
    """The same by SciPy, |v| as it stands."""
    right = lambda t, y: (y[1], -y[0] - 0.1 * y[1] * abs(y[1]) ** 0.5)  # noqa: E731
    at = np.array([float(t) for t in times])
    run = solve_ivp(right, (0, at[-1]), (1.0, 0.0), method="DOP853", rtol=2.3e-14, atol=1e-15, t_eval=at)
    return [float(x) for x in run.y[0]]


def moments(size: int) -> list[Fraction]:
    """``size`` times over 100 swings, fewer for a tiny size."""
    end = Fraction(628 * min(size, 10_000), 10_000) if size < 100 else Fraction(628)
    return [end * (k + 1) / size for k in range(size)]


def run(size: int = 10_000) -> Table:
    """``size`` times, and a tenth as many turning points of each law."""
    times = moments(size)
    base = best_time(lambda: dop853(times), 1)
    seconds = best_time(lambda: certified(times), 1)
    few = times[: size // 10 + 1]
    worst = max(abs(a - b) for a, b in zip(certified(few), dop853(few), strict=True))
    rows = [
        (f"{size} times, DOP853", seconds_text(base), "1.0", f"{worst:.0e} (measured)"),
        (f"{size} times, enclosures", seconds_text(seconds), f"{seconds / base:.1f}", f"1e-{DIGITS} (proved)"),
    ]
    count = max(2, size // 10)
    for label, law in LAWS.items():
        points = best_time(lambda law=law: turning_points(Law(law), count, 30, times=True, max_seconds=LONG), 1)
        ratio = f"{points / base:.1f}"
        rows.append((f"{count} turning points, {label}", seconds_text(points), ratio, "1e-30 (proved)"))
    title = f"Motion over {SWINGS} swings and turning points: what a proof costs"
    return Table(title, ("what", "seconds", "of DOP853", "error"), tuple(rows))
