"""What the package promises to do in a stated time: seconds of processor time, the promise, and their ratio.

The first run of each makes the coefficients that later runs share; it is not timed where they are shared in use too.
"""

from collections.abc import Callable
from fractions import Fraction
from functools import partial
from itertools import islice
from time import process_time

import numpy as np
from flint import arb

import asymptotics as asy
from asymptotics.decays.identification.forward.coefficients import loss
from asymptotics.decays.identification.forward.sequence import turning_sequence
from asymptotics.decays.identification.forward.swing import HalfSwingModel
from asymptotics.decays.identification.synthetic import observed
from asymptotics.expansions.divergence import germ
from asymptotics.expansions.half_swings.certified_zeros import certified_half_swing
from asymptotics.expansions.half_swings.exact import exact_half_swing
from asymptotics.flow.damping import Damping
from asymptotics.flow.sequence import sequence
from asymptotics.flow.taylor import GUARD
from asymptotics.flow.turning import at_rest
from asymptotics.law import Law
from asymptotics.limit_cycles.series import limit_cycle_series
from asymptotics.numbers.context import ctx
from asymptotics.return_map.panels import map_of, panels_of
from asymptotics.return_map.sequence import Interpolated
from asymptotics.return_map.spectral import analysis, integrals
from asymptotics.terms import Term
from asymptotics.turning.choose import turning_points
from benchmarks.certified_motion import certified, moments
from benchmarks.certified_orbits import far_point
from benchmarks.decays import motion
from benchmarks.table import Table, seconds_text

AIR = Law({2: "1/10"}, spring="pendulum")
DUFFING = Law({"3/2": 1}, spring={3: 1})
BETWEEN: dict[object, object] = {"3/2": "1/5"}
CUBE: dict[object, object] = {3: "1/5"}
PAIR: dict[object, object] = {1: "1/20", 2: "1/5"}
FULL = 8
"""Below this size the tables of coefficients would cost more than everything else."""
_LONG = 2.0  # seconds: the start of such a run matters no more
VAN_DER_POL = Law({1: -1, (1, 2): 1})


def promises(size: int) -> dict[str, tuple[Callable[[], object], float]]:
    """What is done, and in how many seconds it shall be done, at the stated size 8."""
    swing, p = HalfSwingModel((loss(1), loss(2))), np.array([0.0, 0.01, 0.02])
    seen = observed("1+2", [0.005, 0.015], 18 * size + 5, 1e-3, 1e-2, seed=8)
    orbit = turning_sequence(swing, 100, p)
    few, many = (min(digits, 4 * size) for digits in (15, 30))
    found: dict[str, tuple[Callable[[], object], float]] = {
        f"alpha = 2 and a pendulum, order {size}, exact": (lambda: exact_half_swing(_unit(AIR), size), 0.5),
        "alpha = 3/2 and x^3, order 6, certified": (lambda: certified_half_swing(_unit(DUFFING), min(6, size)), 1),
        f"van der Pol through mu^{3 * size}": (lambda: limit_cycle_series(VAN_DER_POL, 3 * size), 2),
        "100 turning points, pendulum in air from 170 degrees, 30 digits": (
            lambda: turning_points(AIR, 100, 30, x0="2.967", route="closed-primitive"), 1,
        ),
        "100 turning points with gradients, doubles": (lambda: turning_sequence(swing, 100, p * 1.01, orbit.a), 0.002),
        "next amplitude and half period, alpha = 1.37, 100 strengths, 20 digits": (lambda: _swept(12 * size + 4), 2.4),
        "1000 turning points and times of 3/2, 15 digits, enclosures": (lambda: points(BETWEEN, few, size), 0.05),
        "200 strengths of 3/2, 10 turning points, 12 digits, the map included": (lambda: strengths(25 * size), 1),
        "1000 turning points and times of (1, 2), 15 digits, enclosures": (lambda: points(PAIR, few, size), 0.05),
        "1000 turning points and times of 3 at epsilon = 2, 30 digits": (lambda: points({3: 2}, many, size), 20),
        "identify: 149 turning points, every law, no bootstrap": (lambda: asy.identify(seen, bootstrap=False), 2),
    }  # fmt: skip
    found["c_1 and d_1 of alpha = 2, 17 digits"] = (partial(constants, 2, 17), 0.5)
    if size >= FULL:
        found["c_1 and d_1 of alpha = 2, 60 digits"] = (partial(constants, 2, 60), 3)
        found["c_1 and d_1 of alpha = 3/2, 17 digits, coefficients included"] = (partial(constants, "3/2", 17), 5)
        found["c_1 and d_1 of alpha = 11/10, 50 digits"] = (partial(constants, "11/10", 50), 60)
        for name, law in {"3/2": BETWEEN, "3": CUBE, "(1, 2)": PAIR}.items():
            found[f"1000 turning points and times of {name}, 30 digits, coefficients included"] = (
                partial(anew, law),
                1,
            )
        for degrees, rows, promised in ((40, 3_401, 10), (100, 3_401, 10), (40, 100_000, 20)):
            angles = swung(degrees, rows)
            name = f"identify: {rows} rows of a pendulum from {degrees} degrees, default candidates"
            found[name] = (partial(asy.identify, angles, unit="deg", max_seconds=200), promised)
        found["point 10^9 of 3/2 at 50 digits, after the coefficients"] = (far_point, 1)
        found["reference motion at 10^4 times over 100 swings, 20 digits"] = (lambda: certified(moments(10_000)), 5)
    return found


def swung(degrees: float, rows: int) -> dict[str, object]:
    """A noisy record of a pendulum in air, 79 samples a period (10^5 rows: 500)."""
    t = np.arange(rows) * (0.08 if rows < 10_000 else 0.0125)
    x, _ = motion(lambda x: float(np.sin(x)), [(1.0, 0.006), (2.0, 0.008)], float(np.radians(degrees)), t)
    noisy = np.degrees(x) + 0.1 * np.random.default_rng(rows).standard_normal(rows)
    return {"t": t / 4, "x": noisy}


def constants(alpha: object, digits: int) -> object:
    """Stokes constants; no germ of an earlier run is used."""
    for table in (germ._germ, germ.majorants):
        table.cache_clear()
    return asy.stokes(alpha, digits=digits)


def anew(pairs: dict[object, object]) -> object:
    """Decimals of 1000 turning points and their times; no table of an earlier run is used."""
    _forget()
    return turning_points(Law(pairs), 1000, 30, times=True)


def _forget() -> None:
    for table in (map_of, panels_of, analysis, integrals):
        table.cache_clear()


def strengths(count: int) -> None:
    """Ten turning points of 3/2 to 12 digits at ``count`` strengths up to 1/2, in a process that has no return map."""
    _forget()
    for k in range(1, count + 1):
        turning_points(Law({"3/2": Fraction(k, 2 * count)}), 10, 12)


def points(pairs: dict[object, object], digits: int, size: int) -> object:
    """125 ``size`` turning points; the panels of the first run are kept."""
    bits = int(3.33 * digits) + 40
    law, count = Law(pairs), 125 * size
    with ctx.workprec(bits + GUARD):
        damping = Damping.of_law(law)
    with ctx.workprec(bits):
        return list(islice(sequence(Interpolated(damping, panels_of(law, bits), count), at_rest(arb(1))), count + 1))[
            -1
        ]


def run(size: int = 8) -> Table:
    """The best of two runs of each promise, one of those that take seconds."""
    rows = []
    for name, (work, promised) in promises(size).items():
        seconds = _seconds(work)
        if seconds < _LONG:
            seconds = min(seconds, _seconds(work))
        share = seconds / promised
        rows.append((name, seconds_text(seconds), f"{promised:g}", f"{share:.2f}{'' if share < 1 else ': not kept'}"))
    return Table("Promises", ("what", "seconds", "promised", "of the promise"), tuple(rows))


def _seconds(work: Callable[[], object]) -> float:
    start = process_time()
    with ctx.workprec(140):
        work()
    return process_time() - start


def _swept(points: int) -> None:
    """As a sweep does it: 24 ms for each point are 10^4 points in two minutes on two cores."""
    for k in range(1, points + 1):
        turning_points(Law({"1.37": f"{k}/100"}), 2, 20, times=True)


def _unit(law: Law) -> list[Term]:
    return list(law.terms)
