"""The motion on a half-swing order by order in delta, over any algebra of functions of theta.

Along the half-swing, started with r(0) = 1, the quotient m = N/D (see ``quarter``) obeys m = N + c N m, and

    d ln r/d theta = -s m,   d tau/d theta = 1 + c m,   N = sum_i delta_i s^alpha_i exp((alpha_i - 1) ln r).

Each degree in delta needs lower degrees only.  The algebra supplies s^alpha_i, c and the integral of -s m.

>>> from flint import fmpq_poly                      # alpha = 2: everything is a polynomial in c
>>> orbit = Orbit.solve((1,), 2, (fmpq_poly([1, 0, -1]),), fmpq_poly([0, 1]), lambda m: m.integral() - m.integral()(1))
>>> orbit.log_r[1], orbit.log_r[1][(1,)](-1)         # L = -4/3 delta + ...
({(1,): (-1/3)*x^3 + x + (-2/3)}, -4/3)
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from asymptotics.series import Key, Series, accumulate, is_exact_zero

Part = dict[Key, Any]


@dataclass(frozen=True)
class Orbit:
    """Homogeneous parts in delta of ln r and of m = (d tau/d theta - 1)/c, as functions of theta."""

    log_r: tuple[Part, ...]
    m: tuple[Part, ...]
    variables: int

    @classmethod
    def solve(
        cls,
        weights: tuple[int, ...],
        order: int,
        sine_powers: tuple[Any, ...],
        cosine: Any,
        integrate: Callable[[Any], Any],
    ) -> "Orbit":
        """ln r and m through degree ``order``; ``integrate(m)`` is -int_0^theta s m d theta."""
        zero = (0,) * len(weights)
        log_r: list[Part] = [{}]
        strengths: list[list[Part]] = [[{zero: s}] for s in sine_powers]  # s^alpha_i exp((alpha_i - 1) ln r)
        n: list[Part] = [{}]
        m: list[Part] = [{}]
        for d in range(1, order + 1):
            n.append(_numerator(strengths, d))
            m.append(dict(n[d]))
            for j in range(1, d):
                accumulate(m[d], n[j].items(), [(k, cosine * x) for k, x in m[d - j].items()])
            log_r.append({k: integrate(x) for k, x in m[d].items()})
            for i, weight in enumerate(weights):
                strengths[i].append(_exponential_part(strengths[i], log_r, weight, d))
        return cls(tuple(log_r), tuple(m), len(weights))

    def series(self, parts: tuple[Part, ...], value: Callable[[Any], Any]) -> Series:
        """The series in delta of a functional of theta applied to each coefficient."""
        values = {k: value(x) for part in parts for k, x in part.items()}
        return Series({k: v for k, v in values.items() if not is_exact_zero(v)}, self.variables, len(parts) - 1)


def _numerator(strengths: list[list[Part]], d: int) -> Part:
    total: Part = {}
    for i, strength in enumerate(strengths):
        for k, x in strength[d - 1].items():
            key = (*k[:i], k[i] + 1, *k[i + 1 :])
            total[key] = total[key] + x if key in total else x
    return total


def _exponential_part(known: list[Part], exponent: list[Part], factor: int, d: int) -> Part:
    """Degree d of s^alpha exp(factor * exponent) from the Euler operator; ``known`` holds the lower degrees."""
    total: Part = {}
    if factor:
        for j in range(1, d + 1):
            accumulate(total, [(k, x * (factor * j)) for k, x in exponent[j].items()], known[d - j].items())
    return {k: x / d for k, x in total.items()}
