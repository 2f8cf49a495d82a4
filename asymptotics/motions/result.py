"""What a motion is handed back as: one moment in decimals, or many in doubles; both immutable.

>>> point = MotionPoint("0.1", "0", "0.1", "0", 1, "turning-point", "asymptotic", "1e-3", False)
>>> point.to_dict()["x"], point.to_dict()["certified"]
('0.1', False)
"""

from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np

from asymptotics.numbers.alike import Alike
from asymptotics.numbers.value import Coefficient, number_of, rounded
from asymptotics.present.drawn import Drawn
from asymptotics.present.inputs import csv_text
from asymptotics.present.shown import Page, Rows, Shown

Array = Any

UNITS = {"t": "s", "x": "m", "v": "m/s", "amplitude": "m", "phase": "rad"}
DIMENSIONLESS = {"t": "tau"}


@dataclass(frozen=True, repr=False)
class MotionPoint(Shown):
    """The motion at one time, SI units, decimals as strings.

    ``amplitude``, ``phase`` (psi - tau), ``order`` and ``gauge`` are None for reference and exact motion.  ``error``
    bounds what is printed of x: proved if ``certified``, else an estimate (see ``method``).
    """

    x: str
    v: str
    amplitude: str | None
    phase: str | None
    order: int | None
    gauge: str | None
    method: str
    error: str
    certified: bool
    notes: tuple[str, ...] = ()
    unit: str = "m"

    def to_dict(self) -> dict[str, Any]:
        """The state as a JSON-ready mapping: decimals are strings."""
        return {f.name: _plain(getattr(self, f.name)) for f in fields(self) if f.name != "unit"}

    def noted(self, notes: tuple[str, ...]) -> "MotionPoint":
        """The same with more notes."""
        return replace(self, notes=tuple(dict.fromkeys((*self.notes, *notes))))

    def rounded_to_error(self) -> "MotionPoint":
        """Every value cut down to the digits that the error of x leaves."""
        digits = _known_digits(self.x, self.error)
        names = ("x", "v", "amplitude", "phase")
        values: dict[str, Any] = {n: rounded(getattr(self, n), digits) for n in names if getattr(self, n) is not None}
        return replace(self, **values)

    def number(self, name: str = "x") -> Coefficient:
        """``x`` or ``v`` of a certified motion as a number: mpf, interval, ball; InputError for an estimate."""
        return number_of(self, name)

    def _page(self) -> Page:
        named = {name: unit.replace("m", self.unit) for name, unit in (UNITS | {"error": "m"}).items() if name != "t"}
        rows = tuple((n, f"{getattr(self, n)} {unit}") for n, unit in named.items() if getattr(self, n) is not None)
        order = "" if self.order is None else f", order {self.order}, gauge {self.gauge}"
        worth = f"{'certified' if self.certified else 'estimate'} ({self.method}{order})"
        title = f"x = {self.x} {self.unit}, v = {self.v} {self.unit}/s, error {self.error} {self.unit}"
        return Page(title, (worth, *self.notes), ("", "value"), rows)

    def _formula(self) -> str:
        return rf"x = {self.x}\,\mathrm{{{self.unit}}},\quad \dot x = {self.v}\,\mathrm{{{self.unit}/s}}"


@dataclass(frozen=True, eq=False, repr=False)
class MotionSamples(Alike, Rows, Drawn):
    """The motion at many times, doubles; all arrays have the shape of ``t``.  SI units, or none where ``si`` is False.

    ``missing`` counts the times that are NaN (their places hold NaN); ``extinct`` counts those beyond the fictitious
    extinction time ``extinction`` (in s; None if there is none), where the averaged amplitude is 0: x = v = 0 there.
    """

    t: Array
    x: Array
    v: Array
    amplitude: Array
    phase: Array
    order: int | None
    gauge: str | None
    missing: int
    extinct: int
    extinction: float | None
    notes: tuple[str, ...]
    si: bool = True
    unit: str = "m"

    def columns(self) -> dict[str, Array]:
        """The arrays by name; reference motion has no amplitude and phase."""
        named = {name: getattr(self, name) for name in ("t", "x", "v", "amplitude", "phase")}
        return {name: column for name, column in named.items() if column is not None}

    def header(self) -> list[str]:
        """The names of the columns with their units; tau, x, ... where there are none."""
        if not self.si:
            return [DIMENSIONLESS.get(name, name) for name in self.columns()]
        return [f"{name} [{UNITS[name].replace('m', self.unit)}]" for name in self.columns()]

    def _heading(self) -> str:
        return repr(self)

    def _curve(self, axes: Any, **style: Any) -> None:
        axes.plot(np.ravel(self.t), np.ravel(self.x), **style)
        axes.set(xlabel="t (s)" if self.si else r"$\tau = \omega_0 t$", ylabel=f"x ({self.unit})" if self.si else "x")

    def _table(self) -> dict[str, Array]:
        return {head: np.ravel(c) for head, c in zip(self.header(), self.columns().values())}

    def _page(self) -> Page:
        rows = [tuple(f"{x:.10g}" for x in row) for row in zip(*(np.ravel(c) for c in self.columns().values()))]
        end = () if self.extinction is None else (f"the averaged amplitude is 0 from t = {self.extinction:.6g} s on",)
        return Page(repr(self), ("estimates, in doubles", *end, *self.notes), tuple(self.header()), tuple(rows))

    def _formula(self) -> str:
        n, kind = np.size(self.t), "the reference" if self.order is None else f"order {self.order}"
        return rf"x(t_{{1}}),\ \ldots,\ x(t_{{{n}}})\ \text{{of {kind}}}"

    def to_csv(self) -> str:
        """CSV text: one row for each time, units in the header, shortest exact decimals; last, what code made it."""
        rows = zip(*(np.ravel(column) for column in self.columns().values()))
        return csv_text(self.header(), ([repr(float(x)) for x in row] for row in rows))

    def __repr__(self) -> str:
        kind = "reference" if self.order is None else f"order {self.order}, gauge {self.gauge}"
        return f"MotionSamples({np.size(self.t)} times, {kind})"

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready: numbers as shortest exact strings, NaN as null."""
        arrays = {name: _texts(column) for name, column in self.columns().items()}
        extinction = None if self.extinction is None else repr(self.extinction)
        rest = {"order": self.order, "gauge": self.gauge, "missing": self.missing, "extinct": self.extinct}
        return {**arrays, **rest, "extinction": extinction, "notes": list(self.notes)}


def _known_digits(x: str, error: str) -> int:
    """How many significant digits of x its error leaves, at least one."""
    size, unsure = abs(float(x)), float(error)
    if not size or not unsure:
        return 30
    # Through the digit in which the error has its first one.
    return max(1, int(np.floor(np.log10(size)) - np.floor(np.log10(unsure))) + 1)


def _plain(value: Any) -> Any:
    return list(value) if isinstance(value, tuple) else value


def _texts(values: Array) -> list[str | None]:
    return [None if np.isnan(value) else repr(float(value)) for value in np.ravel(values)]
