"""The hierarchy of integer exponents in the turning-point gauge, in SymPy: every order displayed, on 0 < psi < pi.

>>> air = turning_scales((2,), 3)
>>> print(air.orders[1])
order 1: X_1(psi) + Derivative(X_1(psi), (psi, 2)) = -a**2*cos(psi)**2 + a**2 + 2*a*g_1*cos(psi) + 2*f_1*sin(psi)
  X_1(pi): 4*a**2/3 + pi*f_1 = 0
  V_1(pi): -pi*a*g_1 = 0
  D_1 a = f_1 = -4*a**2/(3*pi)
  D_1 psi = g_1 = 0
  solution: X_1(psi) = 4*a**2*psi*cos(psi)/(3*pi) + a**2*cos(psi)**2/3 - 2*a**2*cos(psi)/3 + a**2/3
>>> air.orders[2].hierarchy.rhs                       # the equation as the ansatz gives it
2*V_0*V_1 - D_0*D_1*X_1 - D_0*D_2*X_0 - D_1*D_0*X_1 - D_1**2*X_0 - D_2*D_0*X_0
>>> air.amplitude_rate, air.phase_rate, air.initial_amplitude, air.initial_phase
(-2*a**4*epsilon**3/(135*pi) - 4*a**2*epsilon/(3*pi), -a**2*epsilon**2/6 + 1, 1, 0)
>>> turning_scales((0, 2), 2).phase_rate              # dry friction with drag: closed as well
-a**2*epsilon_1**2/6 + 1
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from sympy import Add, Expr, cos, pi, sin

from asymptotics.expansions.multiple_scales.initial import InitialConditions
from asymptotics.expansions.multiple_scales.orders import (
    Order,
    a,
    leading_order,
    psi,
    rate_symbols,
    smooth_force,
    solved_order,
    strength_monomial,
    strength_symbols,
)
from asymptotics.expansions.multiple_scales.ring import Wave
from asymptotics.expansions.multiple_scales.symbolic import MultipleScales
from asymptotics.expansions.multiple_scales.turning import MAX_SECONDS, TurningHierarchy, turning_hierarchy
from asymptotics.series import Key, Series
from asymptotics.terms import Term

if TYPE_CHECKING:
    from asymptotics.expansions.half_swings.pi_ring import PiNumber


def turning_scales(given: Sequence[int | Term], order: int, *, max_seconds: float = MAX_SECONDS) -> MultipleScales:
    """Solve X'' + X + the forces = 0 in the turning-point gauge through ``order``, orders shown one by one.

    ``given``: terms (losses |x|^m x'|x'|^(A-1), A an integer and m even; springs x^P |x'|^Q, P odd) or exponents.
    Raises InputError for other forces or an order below 1, LimitError for more than ``max_seconds``.
    """
    terms = tuple(t if isinstance(t, Term) else Term(1, t) for t in given)
    kernel = turning_hierarchy(terms, order, max_seconds=max_seconds)
    made = _TurningDisplay(kernel, strength_symbols(terms))
    orders = (leading_order(kernel.gauge), *(made.order(n) for n in range(1, order + 1)))
    shapes = tuple(t.shape() for t in terms)
    return MultipleScales(shapes, made.symbols, orders, at_rest(kernel), kernel)


def at_rest(kernel: TurningHierarchy) -> InitialConditions:
    """X(0) = 1, X'(0) = 0 is a turning point: a(0) = 1 and psi(0) = 0 at every order."""
    variables, order = kernel.forces.variables, kernel.order
    return InitialConditions(Series.constant(1, variables, order), Series({}, variables, order))


def turning_conditions(n: int) -> tuple[str, str]:
    """The names of the two conditions at the next turning point."""
    return rf"$X_{{{n}}}(\pi)$", rf"$V_{{{n}}}(\pi)$"


@dataclass(frozen=True)
class _TurningDisplay:
    """The results of the kernel as SymPy expressions in a, psi and the strengths."""

    kernel: TurningHierarchy
    symbols: tuple[Expr, ...]

    def order(self, n: int) -> Order:
        """Order n: nothing is computed here, everything is shown."""
        kernel, (rate, turn) = self.kernel, rate_symbols(n)
        forcing = self._waves({key: kernel.forcing(key) for key in kernel.keys(n)})
        p, Omega = (self._numbers(series, n, power) for series, power in ((kernel.p, 1), (kernel.Omega, 1)))
        # The conditions carry a Omega_n, the rate of the phase Omega_n alone.
        turned = self._numbers(kernel.Omega, n, 0)
        names = turning_conditions(n)
        return solved_order(
            n,
            smooth_force(kernel.forces, self.symbols, n),
            forcing,
            ((names[0], pi * rate + _times_pi(p)), (names[1], -pi * a * turn + _times_pi(Omega))),
            (-p, turned),
            self._waves(kernel.X[n]),
            kernel.gauge,
        )

    def _monomial(self, key: Key, power: int = 1) -> Expr:
        return strength_monomial(self.kernel.grading, self.symbols, key, power)

    def _waves(self, parts: dict[Key, Wave]) -> Expr:
        terms: list[Any] = []
        s, c = sin(psi), cos(psi)
        for key, f in parts.items():
            scale = self._monomial(key)
            # As it stands in the ring, power by power: SymPy is not asked to simplify what may be long.
            terms += [scale * q.to_sympy() * psi**i * s**j * c**m for (i, j, m), q in f.coefficients().items()]
        return Add(*terms)

    def _numbers(self, series: Series, n: int, power: int) -> Expr:
        """a^power times the terms of total degree n of p or Omega."""
        found: dict[Key, PiNumber] = {k: c for k, c in series.coefficients.items() if sum(k) == n}
        return Add(*[c.to_sympy() * self._monomial(k, power) for k, c in found.items()])


def _times_pi(x: Expr) -> Expr:
    return (pi * x).expand()
