"""Where an envelope is slow, |dA/dt| <= eta omega_0 A, in the units of its oscillator: heuristic doubles.  That is the
condition of averaging, in which the amplitude changes little within a period.

One law is slow for an interval of times, a sum for an interval of amplitudes (``envelopes.validity``).

>>> from asymptotics.envelopes.first_order import FirstOrderEnvelope
>>> from asymptotics.law import Oscillator
>>> heavy = FirstOrderEnvelope(Oscillator({2: "1/10"}, mass=2, stiffness=8, x0=3))
>>> print(slow_part(heavy, "1/50", Frame("m", "s")))
slow (|dA/dt| <= 1/50 omega_0 A) for t from 17.146018 s to infinity; heuristic, doubles
>>> print(slow_part(FirstOrderEnvelope(Oscillator({1: "1/10"})), "1/50", BARE))
slow (|dA/dt| <= 1/50 omega_0 A) never; heuristic, doubles
"""

from dataclasses import dataclass
from math import inf
from typing import Any

from asymptotics.envelopes.first_order import FirstOrderEnvelope
from asymptotics.envelopes.validity import slow_amplitudes, slow_interval
from asymptotics.errors import InputError, shown
from asymptotics.frames import BARE, Frame
from asymptotics.numbers.policy import exact_number
from asymptotics.present.shown import Page, Shown

# 1/eta and eta kappa must stay far inside the range of doubles; an eta that large or small asks nothing.
MAX_ETA = 1e9
_SHOWN = 8


@dataclass(frozen=True, repr=False)
class SlowPart(Shown):
    """``quantity`` "time" (s) or "amplitude" (m), from ``start`` to ``end``; both None where it is never slow.

    An amplitude from 0 on means down to rest; a time to infinity has ``end`` inf.
    """

    quantity: str
    start: float | None
    end: float | None
    eta: str
    frame: Frame = BARE

    @property
    def certified(self) -> bool:
        """False: the ends are doubles."""
        return False

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready: numbers are strings, "infinity" for a time without end."""
        ends = {name: None if x is None else _text(x, 17) for name, x in (("start", self.start), ("end", self.end))}
        return {"quantity": self.quantity, **ends, "eta": self.eta, "arithmetic": "heuristic"}

    def __str__(self) -> str:
        head = f"slow (|dA/dt| <= {self.eta} omega_0 A)"
        if self.start is None or self.end is None:
            return f"{head} never; heuristic, doubles"
        name = self.frame.time if self.quantity == "time" else "A"
        ends = " to ".join(self._end(x) for x in (self.start, self.end))
        return f"{head} for {name} from {ends}; heuristic, doubles"

    def _end(self, x: float) -> str:
        return self.frame.with_unit(self._name, _text(x, _SHOWN)) if x < inf else _text(x, _SHOWN)

    @property
    def _name(self) -> str:
        return "t" if self.quantity == "time" else "x"

    def _page(self) -> Page:
        unit = self.frame.unit(self._name)
        ends = [(n, x) for n, x in (("from", self.start), ("to", self.end)) if x is not None]
        rows = tuple((n, _text(x, _SHOWN), unit if x < inf else "") for n, x in ends)
        return Page(str(self), (), (self.quantity, "value", "unit"), rows)

    def _formula(self) -> str:
        return rf"|dA/dt| \le \eta\,\omega_0 A,\quad \eta = {self.eta}"


def slow_part(law: FirstOrderEnvelope, eta: Any, frame: Frame) -> SlowPart:
    """The times in s (one law) or the amplitudes in m (a sum) that are slow; InputError for an eta out of range."""
    limit = exact_number(eta, "eta")
    number, omega_0, length = (
        float(x.mid()) for x in (limit.ball(), law.oscillator.omega_0(), law.oscillator.length())
    )
    if not 1 / MAX_ETA <= number <= MAX_ETA:
        raise InputError("eta", f"{shown(eta)} is no small number", f"a number from {1 / MAX_ETA} to {MAX_ETA}")
    active = law.laws()
    if not active:
        raise InputError("law", "every strength is zero: the amplitude is constant", "at least one b > 0")
    if len(active) == 1:
        ((alpha, kappa),) = active
        # For one law |dA/dtau|/A is monotone in time, so that the slow part is an interval of times; for a sum it is
        # convex in ln A, and the slow part is an interval of amplitudes, whose times would each be a quadrature.
        found, unit = slow_interval(float(alpha.ball().mid()), kappa=float(kappa.mid()), eta=number), 1 / omega_0
    else:
        found, unit = slow_amplitudes(law.numeric(), number), length
    quantity = "time" if len(active) == 1 else "amplitude"
    if found is None:
        return SlowPart(quantity, None, None, str(limit), frame)
    return SlowPart(quantity, found.start * unit, found.end * unit, str(limit), frame)


def _text(x: float, digits: int) -> str:
    return "infinity" if x == inf else f"{x:.{digits}g}"
