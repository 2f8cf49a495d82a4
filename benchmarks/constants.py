"""Constants that decide cost or width and claim nothing: what each of a few values costs, and how good the result is.

``python -m benchmarks.constants [NAME …]`` measures all of them, or some, and writes ``constants.json`` beside this
file: for each value and task the processor seconds, the better of two with empty caches, and the quality, where the
task has one.  A machine under load makes the seconds rough: tens of per cent.

>>> round_to_two(0.0123456), [c.attribute for c in CONSTANTS if c.module.endswith("late")]
(0.012, ['ORDERS'])
"""

import json
import platform
import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from datetime import UTC, datetime
from functools import partial
from importlib import import_module
from itertools import islice
from pathlib import Path
from time import process_time
from typing import Any

import numpy as np
from flint import arb

from asymptotics.bounds.late import late_state
from asymptotics.bounds.local import local_bounds
from asymptotics.bounds.waveform import waveform_bounds
from asymptotics.decays.identification.measuring.demodulation import SpectralLine, _memory
from asymptotics.decays.identification.measuring.second_mode import motion_columns
from asymptotics.expansions.half_swings.certified import quarter_swing
from asymptotics.flow.damping import Damping
from asymptotics.flow.linear_spring.linear_spring import LinearSpring
from asymptotics.flow.linear_spring.near_critical import longest_half_swing_seconds
from asymptotics.flow.sequence import sequence
from asymptotics.flow.trajectory import CertifiedFlow
from asymptotics.flow.turning import at_rest
from asymptotics.flow.wells.even_well import EvenWell
from asymptotics.law import Law
from asymptotics.numbers.context import ctx
from asymptotics.numbers.exact import ExactReal, parse_real
from asymptotics.return_map.quarters_in_doubles import QuarterInDoubles
from asymptotics.turning.choose import turning_points

RECORD = Path(__file__).with_suffix(".json")
REPEATS = 2
Task = Callable[[], float | None]


@dataclass(frozen=True)
class Constant:
    """``values`` of an attribute of a module, the present one among them; ``tasks`` answer a quality or None."""

    module: str
    attribute: str
    values: tuple[Any, ...]
    tasks: Mapping[str, Task]
    quality: str

    @property
    def name(self) -> str:
        """Where it is found."""
        return f"{self.module}.{self.attribute}"

    @property
    def present(self) -> Any:
        """Its value in the library."""
        return getattr(import_module(f"asymptotics.{self.module}"), self.attribute)


def exact(*numbers: str) -> list[ExactReal]:
    """Exponents."""
    return [parse_real(x, "alpha") for x in numbers]


def swings(flow: CertifiedFlow, count: int, x0: int = 1) -> None:
    """So many turning points."""
    list(islice(sequence(flow, at_rest(arb(x0))), count))


def linear(law: dict[str, str], bits: int) -> None:
    """Turning points beside a linear spring, by steps."""
    with ctx.workprec(bits):
        swings(LinearSpring(Damping.of_law(Law(law))), 6)


def pendulum(alpha: str, bits: int) -> None:
    """Turning points of a pendulum from an angle of 2."""
    with ctx.workprec(bits):
        swings(EvenWell.of(Law({alpha: "1/5"}, spring="pendulum").terms), 4, 2)


def table(law: dict[str, str], count: int = 2, digits: int = 20, start: int = 0, route: str | None = None) -> None:
    """Turning points by the route that serves, or by one that is named."""
    turning_points(Law(law), count, digits, start=start, route=route)


def lingering() -> float:
    """The seconds that are estimated for the five half-swings of ``linear`` next to critical damping."""
    law = Law({"1": "1.99", "2": "1/10"})
    linear({"1": "1.99", "2": "1/10"}, 110)
    return longest_half_swing_seconds(law, 5, 110)


def late(law: dict[str, str], lead: int) -> float:
    """log2 of the radius of X at the time 10^6."""
    with ctx.workprec(100):
        return log2_of(late_state(Damping.of_law(Law(law)), at_rest(arb(1)), arb(10) ** 6, lead).rad())


def log2_of(x: arb) -> float:
    """For numbers that no double holds."""
    return float(arb(x).log() / arb(2).log())


def displacement(alphas: tuple[str, ...], order: int) -> float:
    """The bound of the highest degree."""
    return float(waveform_bounds(tuple(exact(*alphas)), order).displacements[-1])


def local(alphas: tuple[str, ...], order: int) -> float:
    """The constant of the amplitude, where it is printed."""
    return float(local_bounds(exact(*alphas), order).to_dict()["amplitude"])


def width(alphas: tuple[str, ...], order: int) -> float:
    """By how many bits the widest coefficient is wider than the precision."""
    with ctx.workprec(100):
        swing = quarter_swing(exact(*alphas), order, moments=True)
        return max(log2_of(arb(c).rad()) for part in (swing.R, swing.T_q) for c in part.coefficients.values()) + 100


def nodes(alpha: str, strength: float) -> float:
    """How many nodes the plan for 200 bits takes."""
    one = np.array([1.0])
    return float(QuarterInDoubles(np.array([float(alpha)]), np.array([[strength]]), one, 0 * one).planned(200)[0])


def allowed_for(count: int, a_period: float, degree: int, rho: float, *, even: bool) -> float:
    """By which factor noise of the correlation ``rho`` stretches an interval, over the true one.

    sqrt((1 + rho)/(1 - rho)) with what ``_memory`` finds in what a line of this degree leaves of such noise; the median
    of 400, seed 35.
    """
    random, t = np.random.default_rng(35), np.arange(float(count))
    if not even:
        t = np.sort(t + random.uniform(-0.4, 0.4, count))
    kept = rho ** (np.diff(t) / np.median(np.diff(t)))
    noise = random.standard_normal((count, 400))
    for k in range(1, count):
        noise[k] = kept[k - 1] * noise[k - 1] + np.sqrt(1 - kept[k - 1] ** 2) * noise[k]
    line = SpectralLine(t, 2 * np.pi / a_period, np.zeros(degree + 1), np.zeros(1 + (a_period > 8)), 0.0, 0.0, 0.0)
    Q = np.linalg.qr(motion_columns(line, t))[0]
    found = np.array([_memory(r, Q.shape[1]) for r in (noise - Q @ (Q.T @ noise)).T])
    return float(np.median(np.sqrt((1 + found) / (1 - found)) / np.sqrt((1 + rho) / (1 - rho))))


TWO = {"13/10": "1/10", "7/4": "1/10"}
SUMS = {
    "13/10 and 7/4, 150 bits": partial(linear, TWO, 150),
    "sqrt(2), 150 bits": partial(linear, {"sqrt(2)": "1/10"}, 150),
    "13/10, 400 bits": partial(linear, {"13/10": "1/10"}, 400),
}
JUMP = {"10^9 of 3/2 and 2": partial(table, {"3/2": "1/10", "2": "1/10"}, 1, 15, 10**9, "abel-flow")}
FAR = {f"10^9 with {d} digits": partial(table, {"2": "1"}, 1, d, 10**9, "quadratic") for d in (20, 100)}
RESIDUALS = ((40, 6, 3, True), (58, 6, 6, True), (200, 12, 6, False), (400, 20, 12, False), (400, 5, 12, False))
CONSTANTS = [
    Constant("flow.linear_spring.kept_terms", "_ALONE", (0.1, 0.25, 0.5, 1.0), SUMS, ""),
    Constant("flow.linear_spring.kept_terms", "_STEP", ((75, 0.05), (150, 0.1), (300, 0.2)), SUMS, ""),
    Constant("flow.linear_spring.near_critical", "_SECONDS", (0.003,), {"a long one": lingering}, "estimated seconds"),
    Constant(
        "flow.linear_spring.near_critical",
        "_NEAR_LINEAR",
        (1e-4, 1e-3, 1e-2),
        {f"alpha = {a}, epsilon = 1.99": partial(table, {a: "1.99"}) for a in ("1.0005", "1.005")},
        "",
    ),
    Constant(
        "flow.wells.expansion",
        "_SHARE",
        (0.3, 0.45, 0.6, 0.75, 0.9),
        {f"pendulum, {a}, {b} bits": partial(pendulum, a, b) for a, b in (("3/2", 100), ("2", 100), ("2", 250))},
        "",
    ),
    Constant(
        "bounds.late",
        "ORDERS",
        ({1: 3, 2: 3}, {1: 5, 2: 4}, {1: 7, 2: 5}, {1: 9, 2: 5}, {1: 11, 2: 6}),
        {
            "2, after 40": partial(late, {"2": "1/10"}, 40),
            "3/2 and 2, after 40": partial(late, {"3/2": "1/10", "2": "1/10"}, 40),
        },
        "log2 of the radius",
    ),
    Constant(
        "bounds.waveform",
        "PIECES",
        ({1: 256, 2: 128}, {1: 512, 2: 256}, {1: 1024, 2: 512}, {1: 2048, 2: 1024}),
        {"2, order 3": partial(displacement, ("2",), 3), "3/2 and 2, order 2": partial(displacement, ("3/2", "2"), 2)},
        "the bound of the highest degree",
    ),
    Constant(
        "bounds.local",
        "_TERMS",
        ((1.15, 0.6), (1.7, 0.85), (2.3, 1.15), (3.45, 1.7)),
        {"3/2 and 2, order 3": partial(local, ("3/2", "2"), 3), "1 and 5, order 2": partial(local, ("1", "5"), 2)},
        "the constant",
    ),
    Constant(
        "expansions.half_swings.certified",
        "_GUARD",
        ((0, 0.0), (24, 0.0), (24, 1.0), (24, 1.25), (24, 1.5)),
        {"3/2, order 12": partial(width, ("3/2",), 12), "1/2 and 3, order 6": partial(width, ("1/2", "3"), 6)},
        "bits by which the widest coefficient exceeds the precision",
    ),
    Constant(
        "decays.identification.measuring.demodulation",
        "_COEFFICIENTS",
        (2, 8, 1e9),
        {
            f"{n} {'even' if even else 'uneven'} samples, {a} a period, degree {d}, rho = {rho}": partial(
                allowed_for, n, a, d, rho, even=even
            )
            for n, a, d, even in RESIDUALS
            for rho in (0.0, 0.3, 0.6, 0.85)
        },
        "the factor by which an interval is stretched, over the true one",
    ),
    Constant("turning.routes.quadratic", "_HEAD", ((3, 100), (7, 200), (14, 400)), FAR, ""),
    Constant("turning.routes.quadratic", "_TERMS", ((6, 1), (12, 2), (24, 4)), FAR, ""),
    Constant("turning.jump", "_MOST_TERMS", (6, 9, 12), JUMP, ""),
    Constant("turning.jump", "_REACH", (0.2, 0.4), JUMP, ""),
    Constant(
        "return_map.quarters_in_doubles",
        "_FIRST",
        (24, 32, 48, 64, 96),
        {f"{a}, {e}": partial(nodes, a, e) for a, e in (("2", 0.1), ("1.5", 0.3), ("0.5", 0.1), ("4", 0.2))},
        "nodes that are planned",
    ),
]  # fmt: skip


@contextmanager
def instead(constant: Constant, value: Any) -> Iterator[None]:
    """With another value."""
    module, present = import_module(f"asymptotics.{constant.module}"), constant.present
    setattr(module, constant.attribute, value)
    try:
        yield
    finally:
        setattr(module, constant.attribute, present)
        forget()


def forget() -> None:
    """Empty every cache of the library."""
    for name, module in list(sys.modules.items()):
        if name.startswith("asymptotics"):
            for value in list(vars(module).values()):
                getattr(value, "cache_clear", lambda: None)()


def measured(task: Task, repeats: int = REPEATS) -> dict[str, float | str | None]:
    """The best seconds, and the quality; what is refused is said."""
    best, quality = float("inf"), None
    for _ in range(repeats):
        forget()
        start = process_time()
        try:
            quality = task()
        except Exception as error:  # noqa: BLE001 (which of them a poor choice meets is what is recorded)
            return {"refused": type(error).__name__}
        best = min(best, process_time() - start)
    return {"seconds": round_to_two(best), "quality": None if quality is None else float(f"{quality:.4g}")}


def round_to_two(x: float) -> float:
    """To two digits."""
    return float(f"{x:.2g}")


def record(constants: list[Constant], repeats: int = REPEATS) -> dict[str, Any]:
    """What stands in ``constants.json``."""
    found: dict[str, Any] = {
        "date": datetime.now(UTC).date().isoformat(),
        "machine": f"{platform.machine()}, {processor()}, Python {platform.python_version()}",
        "seconds": f"of processor time, the least of {repeats}, empty caches",
        "constants": {},
    }
    for constant in constants:
        rows = []
        for value in constant.values:
            with instead(constant, value):
                tasks = {name: measured(task, repeats) for name, task in constant.tasks.items()}
            rows.append({"value": repr(value), **tasks})
            print(constant.name, rows[-1], file=sys.stderr, flush=True)
        found["constants"][constant.name] = {
            "present": repr(constant.present), "quality": constant.quality, "measured": rows
        }  # fmt: skip
    return found


def processor() -> str:
    """Its name, where the system tells it."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        return platform.processor()
    return next((line.split(":")[1].strip() for line in lines if line.startswith("model name")), platform.processor())


def main(names: list[str]) -> None:
    """Measure these, or all, and put each into the record."""
    before = json.loads(RECORD.read_text(encoding="utf-8"))["constants"] if names and RECORD.exists() else {}
    for constant in CONSTANTS:
        if not names or constant.name in names:
            found = record([constant])
            before |= found["constants"]
            RECORD.write_text(json.dumps({**found, "constants": before}, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
