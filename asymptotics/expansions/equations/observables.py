"""What an experiment sees on the half-swing from a turning amplitude A: the same numbers in every gauge.

    half period T/omega_0,   decrement Lambda = ln(A_n/A_(n+2)) over a full swing,
    energy loss of the half-swing 1 - V(A_(n+1))/V(A_n),   Q = 2 pi V(A_n)/(V(A_n) - V(A_(n+2))),

with V(A) = A^2/2 for the linear spring: the loss is 1 - (A_(n+1)/A_n)^2 and Q = 2 pi/(1 - e^(-2 Lambda)) there.

The values are truncated series: heuristic doubles, with an error *estimate* (twice what two orders more change), to
which they are rounded when they are printed.

>>> from asymptotics.expansions.equations.build import expand
>>> seen = expand({2: "1/10"}, order=4).observables()
>>> print(seen.half_period, seen.decrement)                     # exact: 3.1462226, 0.2366843
3.1462 0.2367
"""

from dataclasses import dataclass
from math import exp, floor, inf, isfinite, log10, nan, pi
from typing import Any

from flint import fmpq

from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.certified import quarter_swing
from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.expansions.half_swings.quarter import HalfSwing, half_swing
from asymptotics.law import Oscillator
from asymptotics.numbers.context import lru_cache
from asymptotics.present.shown import Page, Shown
from asymptotics.series import Series
from asymptotics.terms import Term


@dataclass(frozen=True, repr=False)
class Observable(Shown):
    """A value with the estimated error that its printed digits respect, and its unit ("" if it has none)."""

    value: float
    error: float
    unit: str = ""

    def __float__(self) -> float:
        return self.value

    def __str__(self) -> str:
        if self.value == inf:
            return "inf"
        # As many decimal places as the estimated error leaves, 15 at most: a double has no more.
        places = 15 if self.error == 0 else max(0, -floor(log10(self.error)) - 1)
        text = f"{self.value:.{min(places, 15)}f}" if self.error < abs(self.value) else f"{self.value:.1g}"
        return f"{text} {self.unit}".strip()

    def _page(self) -> Page:
        return Page(str(self), (f"estimate, error about {self.error:.1e}",))


@dataclass(frozen=True, repr=False)
class Observables(Shown):
    """The observables at one turning amplitude (m for an oscillator, else in units of x0).

    ``energy_loss`` is the fraction lost on the half-swing, ``energy`` the amount: J, or in units of k x0^2.
    """

    amplitude: float
    half_period: Observable
    amplitude_ratio: Observable
    decrement: Observable
    energy_loss: Observable
    Q: Observable
    energy: Observable

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready: numbers are strings."""
        names = ("half_period", "amplitude_ratio", "decrement", "energy_loss", "Q", "energy")
        seen = {n: {"value": repr(getattr(self, n).value), "error": f"{getattr(self, n).error:.1e}"} for n in names}
        return {"amplitude": repr(self.amplitude), **seen}

    def _page(self) -> Page:
        names = ("half_period", "amplitude_ratio", "decrement", "energy_loss", "Q", "energy")
        rows = tuple((n.replace("_", " "), getattr(self, n), f"{getattr(self, n).error:.1e}") for n in names)
        return Page(str(self), ("estimates, in doubles",), ("", "value", "estimated error"), rows)

    def _formula(self) -> str:
        return rf"\Lambda = {self.decrement},\quad Q = {self.Q},\quad A = {self.amplitude:g}"

    def _letters(self) -> dict[str, str]:
        return {r"\Lambda": "decrement over a full swing", "A": "turning amplitude"}

    def __str__(self) -> str:
        return (
            f"half period {self.half_period}, decrement {self.decrement}, Q {self.Q}, energy loss {self.energy_loss}"
            f" at A = {self.amplitude:g}"
        )


def observables_at(
    terms: tuple[Term, ...], order: int, deltas: list[float], amplitude: float, oscillator: Oscillator | None
) -> Observables:
    """The observables of a law at local strengths ``deltas``, through ``order``."""
    try:
        # Two orders more, for one may change nothing: with linear friction alone L is odd and T is even.
        here, finer = (_values(_half(terms, n), _potential(terms, n), deltas) for n in (order, order + 2))
    except (OverflowError, ZeroDivisionError):
        here = finer = (nan,)
    if not all(isfinite(x) or x == inf == y for x, y in zip(here, finer)):
        raise InputError("A", "the series give no number there", "a smaller amplitude or strength")
    time, unit = (1.0, "") if oscillator is None else (1 / float(oscillator.omega_0().mid()), "s")
    size, joule = (1.0, "") if oscillator is None else (float(oscillator.stiffness.ball().mid()), "J")
    factors = (time, 1.0, 1.0, 1.0, 1.0, size * amplitude**2)
    units = (unit, "", "", "", "", joule)
    return Observables(
        amplitude,
        *(
            # Twice the change, and a few units of the last place where the series has converged.
            Observable(a * f, 0.0 if a == b == inf else (2 * abs(a - b) + 1e-15 * abs(a)) * f, u)
            for a, b, f, u in zip(here, finer, factors, units)
        ),
    )


def _values(half: HalfSwing, potential: Series, deltas: list[float]) -> tuple[float, ...]:
    """(T, e^L, Lambda, energy loss, Q, energy lost/A^2) of a truncated map; ``potential`` is V(A)/(A^2/2)."""
    balls = tuple(deltas)
    L = float(half.L.map(_double).at(balls))
    # delta is multiplied by e^(w L) on a half-swing: the second one begins with these.
    after = tuple(d * exp(float(w) * L) for d, w in zip(deltas, (_double(w) for w in half.grading.weights)))
    # Over a full swing: the logarithms of two half-swings, the second at the strengths that the first has left.
    decrement = -(L + float(half.L.map(_double).at(after)))
    T = float(half.T.map(_double).at(balls))
    last = tuple(d * exp(-float(w) * decrement) for d, w in zip(deltas, (_double(w) for w in half.grading.weights)))
    start, half_way, end = (float(potential.map(_double).at(d)) for d in (balls, after, last))
    swing_loss = 1 - exp(-2 * decrement) * end / start
    # Without a loss nothing is taken, and Q is infinite, exactly.
    quality = 2 * pi / swing_loss if decrement else inf
    loss = 1 - exp(2 * L) * half_way / start
    return T, exp(L), decrement, loss, quality, loss * start / 2


@lru_cache(maxsize=64)
def _potential(terms: tuple[Term, ...], order: int) -> Series:
    return Forces.read(terms, order).potential(order)


def _double(c: Any) -> float:
    if isinstance(c, fmpq):
        return int(c.p) / int(c.q)
    return float(c.mid()) if hasattr(c, "mid") else float(c)


@lru_cache(maxsize=64)
def _half(terms: tuple[Term, ...], order: int) -> HalfSwing:
    """L, F, T of a law in balls."""
    return half_swing(quarter_swing(terms, order))
