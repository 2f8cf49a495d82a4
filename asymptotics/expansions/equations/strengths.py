"""What delta_i is, in numbers and in words: epsilon_i A^w_i, or b_i omega_0^alpha_i A^w_i/k with A in metres.

>>> from asymptotics.law import Oscillator
>>> drag = Oscillator({"3/2": "1/10"}, mass="3/2", stiffness=30, x0="1/5")
>>> Strengths(drag.dimensionless.terms, drag.dimensionless, drag).texts()
['(1/10) omega_0^(3/2)/k A^(1/2)']
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from flint import arb

from asymptotics.errors import InputError
from asymptotics.law import Law, Oscillator
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.policy import exact_number
from asymptotics.terms import Term

if TYPE_CHECKING:
    from sympy import Symbol


def _float(x: arb) -> float:
    return float(x.mid())


@dataclass(frozen=True)
class Strengths:
    """The terms of a law, its strengths if they are known, its units if there are any; or a symbolic exponent."""

    terms: tuple[Term, ...]
    law: Law | None = None
    oscillator: Oscillator | None = None
    symbol: "Symbol | None" = None

    @property
    def count(self) -> int:
        """The number of the delta_i."""
        return len(self.terms) or 1

    def numbers(self, epsilon: Any = None, number: Callable[[arb], Any] = _float) -> tuple[list[Any], list[Any], Any]:
        """(strengths, weights, omega_0), made of balls: delta_i = strength_i A^weight_i, A in the unit of length."""
        if not self.terms:
            raise InputError("alpha", "it is symbolic", "to_sympy(), or a number")
        weights = [number(t.weight.ball()) for t in self.terms]
        if self.law is None:
            return [number(e.ball()) for e in self._given(epsilon)], weights, 1
        if epsilon is not None:
            raise InputError("epsilon", "the law has its strengths", "nothing")
        balls = [t.strength.ball() for t in self.law.terms]
        if self.oscillator is None:
            return [number(e) for e in balls], weights, 1
        length, omega = number(self.oscillator.length()), number(self.oscillator.omega_0())
        # delta = epsilon (A/length)^w, with A in metres.
        return [number(e) / length**w for e, w in zip(balls, weights)], weights, omega

    def texts(self) -> list[str]:
        """What each delta is, in words."""
        if not self.terms:
            return ["epsilon A^(alpha - 1)"]
        physical = None if self.oscillator is None else self.oscillator.law.terms
        found = []
        for i, t in enumerate(self.terms):
            name = ("epsilon" if t.sign < 0 else "c") + (f"_{i + 1}" if self.count > 1 else "")
            if physical is not None:
                name = _si_text(physical[i])
            elif self.law is not None:
                name = f"({t.strength})" if "/" in str(t.strength) else str(t.strength)
            found.append((name + _power_text(" A", t.weight)).removeprefix("1 "))
        return found

    def _given(self, epsilon: Any) -> list[ExactReal]:
        values = list(epsilon) if isinstance(epsilon, list | tuple) else [] if epsilon is None else [epsilon]
        if len(values) != self.count:
            raise InputError("epsilon", f"{len(values)} given for {self.count} terms", "one strength for each term")
        return [exact_number(e, "epsilon") for e in values]


def _si_text(t: Term) -> str:
    return f"({t.b})" if t.family else f"({t.b}){_power_text(' omega_0', t.velocity)}/k"


def _power_text(name: str, exponent: ExactReal) -> str:
    if exponent.is_zero:
        return ""
    plain = exponent.is_integer and exponent.sign > 0
    return name if exponent == 1 else f"{name}^{exponent}" if plain else f"{name}^({exponent})"
