"""The motion at many moments, in doubles; one moment in decimals is a ``point``.

>>> samples = MotionSamples(*np.zeros((5, 2)), 1, "turning-point", 0, 0, None, ())
>>> samples, samples.header()
(MotionSamples(2 times, order 1, gauge turning-point), ['tau', 'x', 'v', 'amplitude', 'phase'])
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from asymptotics.frames import BARE, Frame
from asymptotics.numbers.alike import Alike
from asymptotics.present.drawn import Drawn
from asymptotics.present.inputs import OF_EXPANSION, csv_text, option_words, with_words
from asymptotics.present.shown import Page, Rows

Array = Any


@dataclass(frozen=True, eq=False, repr=False)
class MotionSamples(Alike, Rows, Drawn):
    """The motion at many times, doubles; all arrays have the shape of ``t``.  in the units of ``frame``.

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
    frame: Frame = BARE

    def columns(self) -> dict[str, Array]:
        """The arrays by name; reference motion has no amplitude and phase."""
        named = {name: getattr(self, name) for name in ("t", "x", "v", "amplitude", "phase")}
        return {name: column for name, column in named.items() if column is not None}

    def header(self) -> list[str]:
        """The names of the columns with their units; tau, x, ... where there are none."""
        return [self.frame.named(name) for name in self.columns()]

    def _heading(self) -> str:
        return repr(self)

    def _curve(self, axes: Any, **style: Any) -> None:
        axes.plot(np.ravel(self.t), np.ravel(self.x), **style)
        axes.set(xlabel=self.frame.axis("t"), ylabel=self.frame.axis("x"))

    def _table(self) -> dict[str, Array]:
        return {head: np.ravel(c) for head, c in zip(self.header(), self.columns().values())}

    def _page(self) -> Page:
        rows = [tuple(f"{x:.10g}" for x in row) for row in zip(*(np.ravel(c) for c in self.columns().values()))]
        t = self.frame.with_unit("t", f"{self.extinction:.6g}") if self.extinction is not None else ""
        end = (f"the averaged amplitude is 0 from {self.frame.time} = {t} on",) if t else ()
        return Page(repr(self), ("estimates, in doubles", *end, *self.notes), tuple(self.header()), tuple(rows))

    def _formula(self) -> str:
        n, kind = np.size(self.t), "the reference" if self.order is None else f"order {self.order}"
        return rf"x(t_{{1}}),\ \ldots,\ x(t_{{{n}}})\ \text{{of {kind}}}"

    def to_csv(self) -> str:
        """CSV text: one row for each time, units in the header, shortest exact decimals; last, what code made it.

        Beside that, order and gauge, of which amplitude and phase are.
        """
        rows = zip(*(np.ravel(column) for column in self.columns().values()))
        text = csv_text(self.header(), ([repr(float(x)) for x in row] for row in rows))
        return with_words(text, option_words({name: getattr(self, name) for name in OF_EXPANSION}))

    def __repr__(self) -> str:
        kind = "reference" if self.order is None else f"order {self.order}, gauge {self.gauge}"
        return f"MotionSamples({np.size(self.t)} times, {kind})"

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready: numbers as shortest exact strings, NaN as null."""
        arrays = {name: _texts(column) for name, column in self.columns().items()}
        extinction = None if self.extinction is None else repr(self.extinction)
        rest = {"order": self.order, "gauge": self.gauge, "missing": self.missing, "extinct": self.extinct}
        return {**arrays, **rest, "extinction": extinction, "notes": list(self.notes)}


def _texts(values: Array) -> list[str | None]:
    return [None if np.isnan(value) else repr(float(value)) for value in np.ravel(values)]
