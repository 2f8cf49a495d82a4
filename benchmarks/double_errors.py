"""What files of doubles say they are good to, against what they are: random laws, the same columns with 25 digits.

For each column stated/true is the error that the header states over the largest one found at ``PLACES`` of its times,
where it is not below the last place of a double.  Below 1 a stated error is wrong; far above 1 it says little.
``size`` is the number of laws; kinds of curves go round.
"""

import random
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from statistics import median
from typing import Any

import numpy as np

import asymptotics as asy
from asymptotics.curves.double_errors import of_envelope, of_motion, of_solution
from asymptotics.errors import InputError, LimitError
from asymptotics.law import Oscillator
from asymptotics.numbers.double_error import DoubleError
from asymptotics.numbers.policy import exact_number
from benchmarks.table import Table

SEED, DIGITS, ROWS, PLACES = 34, 25, 301, 6
LAWS = (
    ("2",), ("1", "2"), ("0", "2"), ("3/2",), ("1",), ("3",), ("0", "1"), ("1/2",), ("5/2",), ("1", "3"), ("0",),
    ("sqrt(2)",), ("3/2", "2"), ("0", "1", "2"), ("11/10",), ("9/10",), ("0", "3/2"), ("1.001",), ("1/2", "2"), ("4",),
)  # fmt: skip
Columns = Mapping[str, tuple[Any, DoubleError | None]]
At = Callable[[Fraction], Mapping[str, str | None]]


@dataclass
class Ratios:
    """Stated over true of one column of one kind; ``below``: where a stated error was less than the true one."""

    found: list[float] = field(default_factory=list)
    below: list[str] = field(default_factory=list)


def oscillator(chance: random.Random, alphas: tuple[str, ...], **more: Any) -> Oscillator:
    """Strengths from 1/300 to 1/3 at the start, in random units."""
    law = {alpha: Fraction(chance.randint(1, 100), 300 * len(alphas)) for alpha in alphas}
    units: dict[str, Any] = {n: Fraction(chance.randint(1, 40), chance.randint(1, 20)) for n in ("mass", "stiffness")}
    return Oscillator(law, **units, **{"x0": Fraction(chance.randint(5, 20), 10), **more})


def envelope(chance: random.Random, acting: Oscillator, t: Any) -> tuple[Columns, At]:
    """The averaged amplitude and phase, or their formulas of an order."""
    order = chance.choice((None, None, 2, 4)) if len(acting.law.terms) == 1 else None
    found: Any = asy.envelope(acting)
    _, A, phi = found.columns(t, order=order)
    stated = of_envelope(found, t, order)

    def at(time: Fraction) -> Mapping[str, str | None]:
        if order is not None:
            return dict(zip(("amplitude", "phase"), found.at_order(time, order, digits=DIGITS)))
        return {"amplitude": found.amplitude(time, digits=DIGITS), "phase": found.phase(time, digits=DIGITS)}

    return {"amplitude": (A, stated["amplitude"]), "phase": (phi, stated["phase"])}, at


def motion(chance: random.Random, acting: Oscillator, t: Any) -> tuple[Columns, At]:
    """An expansion of order 1 to 6 in one of the gauges."""
    gauge = chance.choice(("turning-point", "averaging", "no-first-harmonic"))
    found = asy.motion(acting, order=chance.choice((1, 2, 3, 3, 4, 6)), gauge=gauge)
    rows = found.sample(t)
    stated, columns = of_motion(found, rows), rows.columns()
    return {n: (columns[n], stated[n]) for n in ("x", "v", "amplitude", "phase")}, lambda at: found.at(
        at, digits=DIGITS
    ).to_dict()


def reference(chance: random.Random, acting: Oscillator, t: Any) -> tuple[Columns, At]:
    """The certified motion, whose doubles are rounded balls."""
    found = asy.reference(acting)
    rows = found.sample(t)
    stated, columns = of_motion(found, rows), rows.columns()
    return {n: (columns[n], stated[n]) for n in ("x", "v")}, lambda at: found.at(at, digits=DIGITS).to_dict()


def solution(chance: random.Random, acting: Oscillator, t: Any) -> tuple[Columns, At]:
    """A, phi and x of the multiple-scale solution of order 1 to 3."""
    found = asy.solution(acting, order=chance.choice((1, 2, 3)))
    _, A, phi, x = found.columns(t)
    stated = of_solution(found, t)

    def at(time: Fraction) -> Mapping[str, str | None]:
        there = found.at_time(acting, time, DIGITS)
        return {"amplitude": there.amplitude, "phase": there.phase, "x": there.x}

    return {"amplitude": (A, stated["amplitude"]), "phase": (phi, stated["phase"]), "x": (x, stated["x"])}, at


KINDS = {"envelope": envelope, "motion": motion, "solution": solution, "reference": reference}


def compared(name: str, columns: Columns, at: At, t: Any, into: dict[tuple[str, str], Ratios], law: str) -> None:
    """The largest true error of each column at some of its times, beside the stated one."""
    places = sorted({int(k) for k in np.linspace(1, len(t) - 1, PLACES)})
    shown = [at(Fraction(float(t[k]))) for k in places]
    for column, (values, stated) in columns.items():
        true = 0.0
        for k, row in zip(places, shown):
            given, value = float(values[k]), row.get(column)
            if stated is None or value is None or not np.isfinite(given) or given == 0:
                continue
            right = exact_number(value, "value").rational
            error, unit = abs(Fraction(given) - right), abs(right) if stated.relative else 1
            if unit:
                true = max(true, float(error / unit))
        if stated is not None and true:
            kept, ratio = into.setdefault((name, column), Ratios()), float(stated.size) / true
            kept.found.append(ratio)
            if ratio < 1:
                kept.below.append(f"{law}: stated {stated!r}, true {true:.1e}")


def run(size: int = 40) -> Table:
    """A row for each column of each kind of curve."""
    chance, into, refused = random.Random(SEED), dict[tuple[str, str], Ratios](), 0
    for k in range(size):
        alphas = LAWS[k % len(LAWS)]
        for name, kind in KINDS.items():
            until = 10.0 ** chance.uniform(0.5, 1.5 if name == "reference" else 3.5)
            t, more = np.linspace(0.0, until, ROWS), {}
            if name in ("motion", "envelope") and chance.random() < 0.2 and alphas[0] not in ("0", "1/2", "9/10"):
                more["v0" if name == "motion" else "spring"] = "1/3" if name == "motion" else "pendulum"
            acting = oscillator(chance, alphas, **more)
            try:
                columns, at = kind(chance, acting, t)
                compared(name, columns, at, t, into, f"{acting} to {until:.4g}")
            except (InputError, LimitError):
                refused += 1
    rows = []
    for key, kept in sorted(into.items()):
        least, most = (f"{each:.1f}" for each in (min(kept.found), max(kept.found)))
        rows.append(
            (*key, str(len(kept.found)), least, f"{median(kept.found):.0f}", most, "; ".join(kept.below) or "-")
        )
    head = ("curve", "column", "laws", "least stated/true", "median", "most", "stated below true")
    return Table(f"Errors that files of doubles state ({size} laws, {refused} curves refused)", head, tuple(rows))
