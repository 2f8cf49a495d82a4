"""The numbers of first order, correctly rounded.

>>> from asymptotics.law import Oscillator
>>> found = first_order_of(Drive.read(Oscillator({1: "1/10"}), "1/5", 1), 5)
>>> found.amplitude, found.phase, found.c_eq, found.resonance["Q_width"]
('2.0000', '1.5708', '0.10000', '10.000')
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

from flint import arb

from asymptotics.driven import balance, first_order, linear
from asymptotics.driven.drive import Drive
from asymptotics.numbers.decimals import certified_decimal
from asymptotics.numbers.exact import ExactReal
from asymptotics.present.shown import Page, Shown
from asymptotics.running.budget import tick

MAX_BITS = 1 << 12
"""Where a number is not rounded by then it lies on a tie, and UndecidedError says so."""
Value = arb | ExactReal


@dataclass(frozen=True, repr=False)
class FirstOrder(Shown):
    """x = amplitude cos(theta - phase) to first order, and what belongs to it; every number is that of the formula.

    ``c_eq``: the viscous damping that takes the same; ``resonance``: the amplitude at omega_0, and Q there of the decay
    and of the half-power width (to leading order in the loss); ``peak``: the largest amplitude and its Omega, None
    where an exponent is below 1 or the amplitude falls from Omega = 0 on.  ``error``: what the response has beyond
    this amplitude and phase, an estimate by the next harmonics; None where they have no balance.
    """

    amplitude: str
    phase: str
    c_eq: str
    resonance: dict[str, str] | None
    peak: dict[str, str] | None
    error: dict[str, str] | None

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready."""
        return dict(vars(self))

    def errors(self) -> dict[str, str]:
        """Of amplitude and phase, as far as they are known."""
        return {name: value for name, value in (self.error or {}).items() if name != "method"}

    def _page(self) -> Page:
        rows = [("amplitude", self.amplitude), ("phase", self.phase), ("c_eq", self.c_eq)]
        rows += [(f"{name} at omega_0", value) for name, value in (self.resonance or {}).items()]
        rows += [(f"{name} of the peak", value) for name, value in (self.peak or {}).items()]
        rows += [(f"error of {name}, estimated", value) for name, value in self.errors().items()]
        title = f"first order: x = {self.amplitude} cos(Omega t - {self.phase})"
        return Page(title, ("digits of the formula, correctly rounded",), ("", "value"), tuple(rows))


def first_order_of(drive: Drive, digits: int) -> FirstOrder:
    """The numbers of first order, correctly rounded."""
    tick("first order")
    told = partial(_told, digits)

    def A() -> arb:
        return first_order.amplitude(drive.balls())

    if linear.is_linear(drive):
        amplitude, c_eq = told(lambda: linear.exact(drive).amplitude), told(lambda: _strength(drive))
    else:
        amplitude, c_eq = told(A), told(lambda: first_order.damping(drive, A()))
    phase = told(lambda: first_order.phase(drive.balls(), A()))
    return FirstOrder(amplitude, phase, c_eq, resonance(drive, digits), _peak(drive, told), _error(drive))


def _error(drive: Drive) -> dict[str, str] | None:
    if linear.is_linear(drive):
        return {"amplitude": "0", "phase": "0", "method": "exact: viscous damping alone"}
    return balance.estimated_error(drive)


def _strength(drive: Drive) -> Value:
    b = drive.losses[0].strength
    return b if isinstance(b, ExactReal) else b.ball()


def _told(digits: int, evaluate: Callable[[], Value]) -> str:
    return certified_decimal(evaluate, digits, max_bits=MAX_BITS)


def resonance(drive: Drive, digits: int) -> dict[str, str] | None:
    """Amplitude at omega_0, Q there of the decay and of the width; None for dry friction alone, which does not bound
    it."""
    if all(a.is_zero for a in drive.alphas):
        return None
    told = partial(_told, digits)

    def A() -> arb:
        return first_order.amplitude(drive.balls_at_resonance())

    def Q(i: int) -> arb:
        return first_order.quality(drive, A())[i]

    return {"amplitude": told(A), "Q_decay": told(partial(Q, 0)), "Q_width": told(partial(Q, 1))}


def _peak(drive: Drive, told: Callable[[Callable[[], Value]], str]) -> dict[str, str] | None:
    if first_order.peak(drive) is None:
        return None

    def number(i: int) -> arb:
        found = first_order.peak(drive)
        return arb.nan() if found is None else found[i]

    return {"amplitude": told(partial(number, 0)), "omega": told(partial(number, 1))}
