"""What a motion is handed back as: one moment in decimals, or many in doubles; both immutable.

>>> point = MotionPoint("0.1", "0", "0.1", "0", 1, "turning-point", "asymptotic", "1e-3", False)
>>> point.to_dict()["x"], point.to_dict()["certified"]
('0.1', False)
"""

from dataclasses import dataclass, fields
from typing import Any

import numpy as np

Array = Any


@dataclass(frozen=True)
class MotionPoint:
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

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready."""
        return {f.name: _plain(getattr(self, f.name)) for f in fields(self)}

    def _repr_latex_(self) -> str:
        return rf"$x = {self.x}\,\mathrm{{m}},\quad \dot x = {self.v}\,\mathrm{{m/s}}$"


@dataclass(frozen=True, eq=False)
class MotionSamples:
    """The motion at many times, SI units, doubles; all arrays have the shape of ``t``.

    ``missing`` counts the times that are NaN (their places hold NaN); ``extinct`` counts those beyond the fictitious
    extinction time ``extinction`` (in s; None if there is none), where the averaged amplitude is 0: x = v = 0 there.
    """

    t: Array
    x: Array
    v: Array
    amplitude: Array
    phase: Array
    order: int
    gauge: str
    missing: int
    extinct: int
    extinction: float | None
    notes: tuple[str, ...]

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready: numbers as shortest exact strings, NaN as null."""
        arrays = {name: _texts(getattr(self, name)) for name in ("t", "x", "v", "amplitude", "phase")}
        extinction = None if self.extinction is None else repr(self.extinction)
        rest = {"order": self.order, "gauge": self.gauge, "missing": self.missing, "extinct": self.extinct}
        return {**arrays, **rest, "extinction": extinction, "notes": list(self.notes)}


def _plain(value: Any) -> Any:
    return list(value) if isinstance(value, tuple) else value


def _texts(values: Array) -> list[str | None]:
    return [None if np.isnan(value) else repr(float(value)) for value in np.ravel(values)]
