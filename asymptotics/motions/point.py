"""The motion at one moment, in decimals.

>>> point = MotionPoint("0.1", "0", "0.1", "0", 1, "turning-point", "asymptotic", "1e-3", False)
>>> point.to_dict()["x"], point.to_dict()["certified"]
('0.1', False)
"""

from dataclasses import dataclass, fields, replace
from math import floor, log10
from typing import Any

from asymptotics.frames import BARE, Frame
from asymptotics.numbers.value import Coefficient, number_of, rounded
from asymptotics.present.shown import Page, Shown

_TOLD = ("x", "v", "amplitude", "phase", "error")


@dataclass(frozen=True, repr=False)
class MotionPoint(Shown):
    """The motion at one time, in the units of its frame, decimals as strings.

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
    frame: Frame = BARE

    def to_dict(self) -> dict[str, Any]:
        """The state as a JSON-ready mapping: decimals are strings."""
        return {f.name: _plain(getattr(self, f.name)) for f in fields(self) if f.name != "frame"}

    def with_notes(self, notes: tuple[str, ...]) -> "MotionPoint":
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
        told = {
            name: self.frame.with_unit(name, getattr(self, name)) for name in _TOLD if getattr(self, name) is not None
        }
        order = "" if self.order is None else f", order {self.order}, gauge {self.gauge}"
        worth = f"{'certified' if self.certified else 'estimate'} ({self.method}{order})"
        title = f"x = {told['x']}, v = {told['v']}, error {told['error']}"
        return Page(title, (worth, *self.notes), ("", "value"), tuple(told.items()))

    def _formula(self) -> str:
        return rf"x = {self.frame.latex('x', self.x)},\quad \dot x = {self.frame.latex('v', self.v)}"


def _known_digits(x: str, error: str) -> int:
    """How many significant digits of x its error leaves, at least one."""
    size, unsure = abs(float(x)), float(error)
    if not size or not unsure:
        return 30
    # Through the digit in which the error has its first one.
    return max(1, floor(log10(size)) - floor(log10(unsure)) + 1)


def _plain(value: Any) -> Any:
    return list(value) if isinstance(value, tuple) else value
