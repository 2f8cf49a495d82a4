"""The formal solution on a half-swing, order by order in the local strengths, over any algebra of functions of theta.

Along the half-swing, started with r(0) = 1, the quotient m = N/D (see ``quarter``) obeys m = N + c N m, and

    d ln r/d theta = -s m,   d tau/d theta = 1 + c m,   N = sum delta^key f exp(a_key ln r)

over the members of the forces (``forces``): f is the function of theta, a_key the weight of the monomial.  Each degree
in delta needs lower degrees only.  The algebra supplies the functions f, c and the integral of -s m.

>>> from flint import fmpq, fmpq_poly                # alpha = 2: everything is a polynomial in c
>>> shapes = [((1,), fmpq_poly([1, 0, -1]))]
>>> c, integral = fmpq_poly([0, 1]), lambda m: m.integral() - m.integral()(fmpq(1))
>>> orbit = FormalSolution.solve(Grading.of((2,)), 2, shapes, c, integral)
>>> orbit.log_r[1], orbit.log_r[1][(1,)](-1)         # L = -4/3 delta + ...
({(1,): (-1/3)*x^3 + x + (-2/3)}, -4/3)
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from asymptotics.expansions.half_swings.grading import Grading
from asymptotics.running.budget import tick
from asymptotics.series import Key, Series, accumulate, is_exact_zero

Part = dict[Key, Any]


@dataclass(frozen=True)
class FormalSolution:
    """Homogeneous parts in delta of ln r and of m = (d tau/d theta - 1)/c, as functions of theta."""

    log_r: tuple[Part, ...]
    m: tuple[Part, ...]
    variables: int

    @classmethod
    def solve(
        cls,
        grading: Grading,
        order: int,
        shapes: Sequence[tuple[Key, Any]],
        cosine: Any,
        integrate: Callable[[Any], Any],
    ) -> "FormalSolution":
        """ln r and m through degree ``order``; ``integrate(m)`` is -int_0^theta s m d theta."""
        zero = (0,) * grading.variables
        log_r: list[Part] = [{}]
        grown: list[list[Part]] = [[{zero: f}] for _, f in shapes]  # f exp(a_key ln r)
        n: list[Part] = [{}]
        m: list[Part] = [{}]
        for d in range(1, order + 1):
            tick(f"order {d} of {order} of the orbit")
            n.append(_numerator(shapes, grown, d))
            # m = N + c N m at degree d: N begins with degree 1, so that m is needed below d only.
            m.append(dict(n[d]))
            for j in range(1, d):
                tick()
                accumulate(m[d], n[j].items(), [(k, cosine * x) for k, x in m[d - j].items()])
            log_r.append({k: integrate(x) for k, x in m[d].items()})
            for (key, _), known in zip(shapes, grown):
                # A higher degree of f exp(a ln r) would meet no order that is asked for.
                if d + sum(key) <= order:
                    known.append(_exponential_part(known, log_r, grading.weight(key), d))
        return cls(tuple(log_r), tuple(m), grading.variables)

    def series(self, parts: tuple[Part, ...], value: Callable[[Any], Any]) -> Series:
        """The series in delta of a functional of theta applied to each coefficient."""
        values = {k: value(x) for part in parts for k, x in part.items()}
        return Series({k: v for k, v in values.items() if not is_exact_zero(v)}, self.variables, len(parts) - 1)


def _numerator(shapes: Sequence[tuple[Key, Any]], grown: list[list[Part]], d: int) -> Part:
    total: Part = {}
    for (step, _), known in zip(shapes, grown):
        if sum(step) <= d:
            for k, x in known[d - sum(step)].items():
                key = tuple(a + b for a, b in zip(k, step))
                total[key] = total[key] + x if key in total else x
    return total


def _exponential_part(known: list[Part], exponent: list[Part], factor: Any, d: int) -> Part:
    """Degree d of f exp(factor * exponent) from the Euler operator; ``known`` holds the lower degrees."""
    total: Part = {}
    if factor != 0:
        for j in range(1, d + 1):
            accumulate(total, [(k, x * (factor * j)) for k, x in exponent[j].items()], known[d - j].items())
    return {k: x / d for k, x in total.items()}
