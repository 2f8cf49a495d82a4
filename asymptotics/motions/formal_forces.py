"""The forces along the formal orbit are expanded by degree: they are F in the equations of the ``waveform``.

On 0 < psi < pi, with X/A = c P - s Q and |X'|/A = s g, g = P + (c/s) Q, and one member for each homogeneous force
(``expansions.half_swings.forces``; side = +1 for a loss, -1 for a spring),

    F = sum_j side_j ratio_j delta^key_j (s g)^v_j (X/A)^m_j.

g = 1 + O(delta), so that a real power of it may be expanded; X vanishes inside the half-swing, but its powers are
integers, which are products.  Up to psi = pi/2 the polynomial (X/A)^m continues |X|^m and X|X|^(m-1): what the second
quarter needs comes from reversal.  Where m makes the force a kink at X = 0 (|x|^m with m odd, x|x|^(p-1) with p even),
the polynomial differs from the force for the O(delta) of psi between X = 0 and pi/2, by O(delta^(m+1)): the waveform
is good to O(delta^(m+2)) there, and no series in delta at fixed psi is better.
"""

from collections.abc import Callable
from typing import Any

from flint import arb

from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.graded import power_part, product_part
from asymptotics.numbers.exact import ExactReal
from asymptotics.series import Key, accumulate

Parts = list[dict[Key, Any]]


class FormalForces:
    """F by degree; ``extend`` tells it each degree of P and Q in turn, ``part(n)`` needs those below n."""

    def __init__(self, forces: Forces, order: int, s: Any, c: Any, power: Callable[[Any], Any], number: Any) -> None:
        """``power(v)`` is s^v at the samples, ``number`` turns a ball into a sample."""
        self._s, self._c, self._cot = s, c, c / s
        one, zero = s * 0 + 1, (0,) * forces.variables
        self._members = [
            (m.key, number(arb(m.side * m.ratio)) * power(number(m.velocity.ball())), m.velocity, m.position)
            for m in forces.through(order)
        ]
        self._exponents = {m.velocity: number(m.velocity.ball()) for m in forces.through(order)}
        self._velocity: dict[Any, Parts] = {v: [{zero: one}] for v in self._exponents}
        positions = set().union(*({0, 1} | _halves(m.position) for m in forces.through(order)), {0, 1})
        self._position: dict[int, Parts] = {m: [{zero: c**m if m else one}] for m in sorted(positions)}
        self._g: Parts = [{zero: one}]

    def extend(self, P: dict[Key, Any], Q: dict[Key, Any]) -> None:
        """The next degree of P and Q."""
        n = len(self._g)
        self._g.append({k: P[k] + self._cot * Q[k] for k in P})
        # g = 1 + O(delta): the power series of g^v by the recurrence n y_n = sum (v j - (n - j)) g_j y_(n-j).
        for v, power in self._velocity.items():
            power.append(power_part(self._g, power, self._exponents[v], n))
        for m, parts in self._position.items():  # rising: the halves of m are there before m
            if m < 2:
                parts.append({k: self._c * P[k] - self._s * Q[k] for k in P} if m else {})
            else:
                parts.append(product_part(self._position[m // 2], self._position[m - m // 2], n))

    def part(self, n: int) -> dict[Key, Any]:
        """The part of F that is homogeneous of degree n in the delta_i."""
        F: dict[Key, Any] = {}
        for key, factor, v, m in self._members:
            degree = n - sum(key)
            if degree >= 0:
                accumulate(F, [(key, factor)], self._orbit(v, m, degree).items())
        return F

    def _orbit(self, v: ExactReal, m: int, degree: int) -> dict[Key, Any]:
        """g^v (X/A)^m of one degree."""
        if not m:
            return self._velocity[v][degree]
        if v.is_zero:
            return self._position[m][degree]
        return product_part(self._velocity[v], self._position[m], degree)


def _halves(m: int) -> set[int]:
    """The powers that lead to X^m by products of two."""
    return {m} if m < 2 else {m} | _halves(m // 2) | _halves(m - m // 2)
