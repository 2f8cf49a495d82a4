"""Equivalent damping as a result: formulas, a table of proved numbers, a curve; text, CSV, JSON, LaTeX, HTML.

Immutable; every number of the table is a decimal with its label, and the curve alone is in doubles.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import sympy
from flint import arb
from numpy.typing import ArrayLike
from sympy import Expr

from asymptotics.equivalent.conversions import Conversion, conversions
from asymptotics.equivalent.rows import DRAWN, OF_MOTION, QUANTITIES, DampingRow, Measure, cycle_of
from asymptotics.errors import InputError, require_choice
from asymptotics.frames import Frame
from asymptotics.law import Oscillator
from asymptotics.numbers.arrays import real_array
from asymptotics.numbers.context import ctx
from asymptotics.numbers.digits import outward, spread
from asymptotics.numbers.policy import Number, exact_number
from asymptotics.numbers.rationals import decimal_fraction
from asymptotics.present.drawn import Drawn
from asymptotics.present.inputs import csv_text
from asymptotics.present.shown import Page, Rows
from asymptotics.running.public import public

UNITS = {
    "amplitude": "m", "energy_loss": "J", "c_eq": "N s/m", "half_life": "s", "period": "s", "omega": "rad/s",
}  # fmt: skip
ANGULAR = {**UNITS, "amplitude": "rad", "c_eq": "N m s"}
"""Of a pendulum, whose m is a moment of inertia and whose k is m g l."""
LETTERS = {
    "zeta": r"\zeta", "zeta_log": r"\zeta_{\log}", "Q": "Q", "decrement": r"\Lambda", "energy_loss": r"\Delta E",
    "c_eq": r"c_{\mathrm{eq}}", "half_life": r"t_{1/2}",
}  # fmt: skip
PARTS = {"first": "first order", "motion": "the motion itself", "expanded": "order N"}
# Of the curve alone: its points, their bits, and the ratio of the amplitudes from which the axes are logarithmic.
_CURVE, _LOW, _WIDE = 60, 53, 8


@dataclass(frozen=True, repr=False)
class EquivalentDamping(Rows, Drawn):
    """zeta, Q, decrement, energy loss, c_eq, half-life and backbone at turning amplitudes A (m, or rad for a pendulum).

    ``zeta`` = Delta E/(4 pi E) is of first order; the motion has ``zeta_log`` = d/sqrt(4 pi^2 + d^2), d its decrement.
    ``formulas``: of first order in A, b, m, k (epsilon without units); ``rows``: the numbers, a row an amplitude, each
    with the ``first`` order (one cycle without loss), the ``motion`` itself (one full swing from rest at A) and, if
    asked for, ``expanded``: order N with the proved bound of each number.  ``oscillator`` is None for a symbolic
    exponent.  ``unit``: that of all amplitudes, if it was named, and its ``size`` in m or rad.
    """

    oscillator: Oscillator | None
    frame: Frame
    digits: int
    order: int | None
    formulas: dict[str, Expr]
    rows: tuple[DampingRow, ...]
    notes: tuple[str, ...] = field(default=(), compare=False)
    unit: str = ""
    size: float = 1.0

    @property
    def certified(self) -> bool:
        """Whether all numbers of the table are proved."""
        return all(m.certified for row in self.rows for m in row.parts.values() if not m.reason or m.Q)

    def header(self) -> list[str]:
        """The columns of the table, with their units."""
        return ["part", *(self._named(name) for name in ("amplitude", *QUANTITIES)), "bound of zeta log", "remark"]

    def table(self) -> list[list[str]]:
        """The rows of the table as text: first order, then the motion, then order N."""
        rows = []
        for part in PARTS:
            for row in self.rows:
                found = row.parts.get(part)
                if found is not None:
                    values = [getattr(found, name) or "" for name in QUANTITIES]
                    bound = found.bounds.get("zeta_log", "")
                    rows.append([self._part(part), row.amplitude, *values, bound, found.reason])
        return rows

    def to_csv(self) -> str:
        """CSV text: units in the header; the last column says what code made it."""
        return csv_text(self.header(), self.table())

    @public
    def sample(self, A: ArrayLike, *, max_seconds: Number = 60) -> dict[str, Any]:
        """zeta, Q, decrement, energy_loss, c_eq of first order, period and omega without loss, in doubles.

        ``A``: amplitudes > 0 in ``unit``, a number or an array, whose shape all of them have.
        """
        oscillator = self._numbers()
        amplitudes = real_array(A, "A")
        rows = [_doubles(oscillator, a * self.size) for a in np.ravel(amplitudes)]
        return {name: np.reshape([row[i] for row in rows], amplitudes.shape) for i, name in enumerate(DRAWN)}

    def _curve(self, axes: Any, quantity: str = "Q", **style: Any) -> None:
        """A quantity against A: first order as a line, the motion as points."""
        require_choice(quantity, "quantity", DRAWN)
        ends = sorted(float(exact_number(row.amplitude, "A").ball().mid()) for row in self.rows)
        low, high = (ends[0], ends[-1]) if ends[-1] > ends[0] else (ends[0] / 10, ends[0])
        A = np.geomspace(low, high, _CURVE)
        axes.plot(A, self.sample(A)[quantity], **{"label": "first order", **style})
        name = OF_MOTION.get(quantity, quantity)
        points = [(r.amplitude, getattr(r.motion, name)) for r in self.rows if r.motion is not None]
        told = [(float(exact_number(a, "A").ball().mid()), float(v)) for a, v in points if v]
        if told:
            label = "the motion, one full swing" + ("" if name == quantity else f": {name.replace('_', ' ')}")
            axes.plot(*zip(*told), "o", markersize=4, label=label)
        if high > _WIDE * low:
            axes.set(xscale="log", yscale="log")
        axes.set(xlabel=self._named("amplitude"), ylabel=self._named(quantity))

    @public
    def conversions(self, *, max_seconds: Number = 60) -> tuple[Conversion, ...]:
        """The strengths under the names of ITTC, IMO, OpenFAST, OrcaFlex and of dampers, with their definitions; SI."""
        if not self.frame:
            raise InputError("law", "it has no units", "an oscillator: mass, stiffness and b in SI")
        return conversions(self._numbers(), self.digits)

    def latex(self) -> str:
        """The formulas of first order in LaTeX."""
        return " \\\\\n".join(f"{LETTERS[name]}(A) = {sympy.latex(e)}" for name, e in self.formulas.items())

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready: numbers are strings."""
        formulas = {n: {"exact": str(e), "latex": sympy.latex(e)} for n, e in self.formulas.items()}
        rows = [
            {"amplitude": row.amplitude, **{part: m.to_dict() for part, m in row.parts.items()}} for row in self.rows
        ]
        units = {name: self._unit(name) for name in ("amplitude", *QUANTITIES)}
        law = None if self.oscillator is None else str(self.oscillator.law)
        return {
            "law": law, "si": bool(self.frame), "units": units,
            "formulas": formulas, "order": self.order, "digits": self.digits, "rows": rows,
            "certified": self.certified, "notes": list(self.notes),
        }  # fmt: skip

    def __str__(self) -> str:
        lines = [f"{name} = {e}" for name, e in self.formulas.items()]
        for part in PARTS:
            told = [(row.amplitude, row.parts[part]) for row in self.rows if part in row.parts]
            if told:
                lines += [f"{self._part(part)}:", *self._lines(told)]
        claim = [f"certified: {str(self.certified).lower()}"] if self.rows else []
        return "\n".join([*lines, *claim, *self.notes])

    def _lines(self, told: list[tuple[str, Measure]]) -> list[str]:
        """One part as a table of text."""
        names = [n for n in QUANTITIES if any(getattr(m, n) for _, m in told)]
        head = [self._named("amplitude"), *map(self._named, names)]
        rows = [
            [a, *(_shown(m, n) for n in names)] if m.Q else [a, m.reason, *[""] * (len(names) - 1)][: len(head)]
            for a, m in told
        ]
        if not names:
            return [f"  {a}  {m.reason}" for a, m in told]
        widths = [max(len(r[i]) for r in (head, *rows) if i != 1 or r[1:] != [""]) for i in range(len(head))]
        lines = ["  " + "  ".join(c.ljust(w) for c, w in zip(row, widths)).rstrip() for row in (head, *rows)]
        return [*lines, *dict.fromkeys(f"  {m.reason}" for _, m in told if m.Q and m.reason)]

    def _page(self) -> Page:
        """The value first: Q at the amplitudes; then the formulas and the table."""
        title = self._at_amplitudes("Q")
        law = "x'|x'|^(alpha-1)" if self.oscillator is None else str(self.oscillator.law)
        worth = "; ".join(dict.fromkeys(m.guarantee for row in self.rows for m in row.parts.values()))
        lines = (f"equivalent damping of {law}", worth or "formulas of first order, exact", *self.notes)
        return Page(title, lines, tuple(self.header()) if self.rows else (), tuple(map(tuple, self.table())))

    def _at_amplitudes(self, quantity: str) -> str:
        """A quantity at the first amplitudes, of the motion where it has it, or its formula."""
        unit, name = f" {self._unit('amplitude')}".rstrip(), OF_MOTION.get(quantity, quantity)
        values = [
            (m.amplitude, m.motion and getattr(m.motion, name), getattr(m.first, quantity)) for m in self.rows[:4]
        ]
        own = f" {self._unit(quantity)}".rstrip()
        told = ", ".join(f"{motion or first}{own} at {amplitude}{unit}" for amplitude, motion, first in values)
        return f"{quantity.replace('_', ' ')} = {told or self.formulas[quantity]}"

    def _headed(self, style: Mapping[str, Any]) -> str:
        return self._at_amplitudes(style.get("quantity", "Q"))

    def _table(self) -> dict[str, list[Any]]:
        told = [(part, row.amplitude, row.parts[part]) for part in PARTS for row in self.rows if part in row.parts]
        columns: dict[str, list[Any]] = {
            "part": [self._part(part) for part, _, _ in told],
            self._named("amplitude"): [_double(a) for _, a, _ in told],
        }
        for name in QUANTITIES:
            columns |= _spread(self._named(name), [(getattr(m, name), m.bounds.get(name)) for _, _, m in told])
        return columns | {"remark": [m.reason for _, _, m in told]}

    def _formula(self) -> str:
        return rf"\displaystyle\begin{{gathered}}{self.latex()}\end{{gathered}}"

    def _letters(self) -> dict[str, str]:
        return {
            "A": "turning amplitude", "a": "the amplitude integrated over", "E": "energy V(A)", "k": "stiffness",
            "c": "c_eq, the viscous coefficient that takes as much; c alone: strength of the spring", "t": "half-life",
            "x": "displacement; under an integral, the place integrated over",
            r"\zeta": "equivalent damping ratio Delta E/(4 pi E)",
            r"\Lambda": "decrement of a swing", r"\Delta": "what a cycle takes", "F": "hypergeometric function",
        }  # fmt: skip

    def _part(self, part: str) -> str:
        return f"order {self.order}, with its bound" if part == "expanded" else PARTS[part]

    def _unit(self, name: str) -> str:
        if name == "amplitude" and self.unit:
            return self.unit
        if not self.frame or self.oscillator is None:
            return ""
        return (ANGULAR if self.oscillator.unit == "rad" else UNITS).get(name, "")

    def _named(self, name: str) -> str:
        unit = self._unit(name)
        return f"{name.replace('_', ' ')} [{unit}]" if unit else name.replace("_", " ")

    def _numbers(self) -> Oscillator:
        if self.oscillator is None:
            raise InputError("alpha", "it is symbolic", "an exponent")
        return self.oscillator


def _spread(name: str, cells: list[tuple[str | None, str | None]]) -> dict[str, list[Any]]:
    """Columns of a data frame: digits within half a unit of the last, or within the bound that stands beside them."""
    columns = spread(name, [value for value, _ in cells])
    for i, (value, bound) in enumerate(cells):
        if value is not None and bound is not None:
            # Order N is known to within its bound, not to half a unit: the ends are made anew, rounded outward.
            middle, radius = decimal_fraction(value), decimal_fraction(bound)
            low, high = middle - radius, middle + radius
            columns[f"{name}_low"][i], columns[f"{name}_high"][i] = outward(low, -1), outward(high, 1)
    return columns


def _double(text: str) -> float:
    return float(exact_number(text, "A").ball().mid())


def _shown(m: Measure, name: str) -> str:
    value = getattr(m, name)
    return "-" if value is None else f"{value} +- {m.bounds[name]}" if name in m.bounds else value


def _doubles(oscillator: Oscillator, a: float) -> tuple[float, ...]:
    """The first order at one amplitude; NaN stays NaN."""
    # NaN fails this test too, and so keeps its place.
    if not a > 0:
        return (float("nan"),) * len(DRAWN)
    local = Oscillator(oscillator.law, mass=oscillator.mass, stiffness=oscillator.stiffness, x0=exact_number(a, "A"))
    # At the bits of a double: the middle of each ball is drawn, and no more is said.
    with ctx.workprec(_LOW):
        cycle = cycle_of(local)
        k, omega_0 = oscillator.stiffness.ball(), local.omega_0()
        numbers = (
            cycle.zeta, cycle.quality, cycle.decrement, cycle.lost * k * local.length() ** 2,
            cycle.coefficient * (k * oscillator.mass.ball()).sqrt(), cycle.period / omega_0,
            2 * arb.pi() * omega_0 / cycle.period,
        )  # fmt: skip
        return tuple(float(x.mid()) for x in numbers)
