"""a(0) and phi(0) for any start, in motion too, through the order of the hierarchy: the ansatz read backwards.

A start X(0) = r cos theta, X'(0) = -r sin theta lies on X - i X' = a e^(i psi) Z(psi, delta) with, by variation of
constants, Z = 1 + sum delta^k (u_k - i w_k), u_k = x_k cos psi - v_k sin psi, w_k = x_k sin psi + v_k cos psi.  So

    ln a = ln r - Re ln Z(psi, delta),      psi = theta - Im ln Z(psi, delta),      delta_i = epsilon_i a^(d_i-1),

and each pass of this fixed point, Taylor expanded about theta and rho_i = epsilon_i r^(d_i-1), makes one order right.
0 < theta < pi is a start with X' < 0; for the others -X moves like X, and theta, psi lose pi.

>>> from asymptotics.expansions.multiple_scales.turning import turning_hierarchy
>>> found = start_of(turning_hierarchy((3,), 2))
>>> found.log_amplitude[1].to_sympy(), found.phase[1].to_sympy()
(sin(psi)*cos(psi)**3/4 - 5*sin(psi)*cos(psi)/8, cos(psi)**4/4 - cos(psi)**2/2 + 1/4)
"""

from dataclasses import dataclass
from math import factorial

from flint import fmpq

from asymptotics.expansions.multiple_scales.ring import COSINE, ONE, SINE, Wave
from asymptotics.expansions.multiple_scales.turning import TurningHierarchy
from asymptotics.series import Series


@dataclass(frozen=True)
class Start:
    """ln(a(0)/r) and psi(0) - theta as series in rho_i; the coefficients are functions of theta on (0, pi)."""

    log_amplitude: Series
    phase: Series

    @property
    def amplitude(self) -> Series:
        """a(0)/r, the slow amplitude at the start over the radius there."""
        return _exp(self.log_amplitude, fmpq(1), self.log_amplitude.order)


def start_of(h: TurningHierarchy) -> Start:
    """The start through the order of the hierarchy, exact."""
    variables, order = h.forces.variables, h.order
    real, imaginary = _log_Z(h)
    lam, beta = Series({}, variables, order), Series({}, variables, order)
    for _ in range(order):
        # Re ln Z and Im ln Z are O(delta): each pass makes one order more right.
        lam, beta = -_at(h, real, lam, beta), -_at(h, imaginary, lam, beta)
    return Start(lam, beta)


def _log_Z(h: TurningHierarchy) -> tuple[Series, Series]:
    """Re ln Z and Im ln Z by degree: E ln Z = E Z/Z with the Euler operator E."""
    variables, order = h.forces.variables, h.order
    u, w = ({}, {})
    for X, V in zip(h.X[1:], h.V[1:]):
        for k, x in X.items():
            u[k] = COSINE * x - SINE * V[k]
            w[k] = SINE * x + COSINE * V[k]
    # Z = 1 + P + i Q.
    P, Q = Series(u, variables, order), -Series(w, variables, order)
    ones = (1,) * variables
    modulus = P * 2 + P * P + Q * Q  # |Z|^2 - 1
    # 1/|Z|^2 by the geometric series, which ends with the order: Wave has no division.
    inverse, power = Series.constant(ONE, variables, order), Series.constant(ONE, variables, order)
    for _ in range(order):
        power = -(power * modulus)
        inverse = inverse + power
    EP, EQ = P.weighted(ones), Q.weighted(ones)
    real, turn = ((EP + P * EP + Q * EQ) * inverse, (EQ + P * EQ - Q * EP) * inverse)
    return tuple(s.map_keys(lambda k, c: c * fmpq(1, sum(k))) for s in (real, turn))  # type: ignore[return-value]


def _at(h: TurningHierarchy, f: Series, lam: Series, beta: Series) -> Series:
    """f(psi, delta) at psi = theta + beta, delta_i = rho_i exp((d_i - 1) lambda)."""
    total, order = Series({}, f.variables, f.order), f.order
    slope, power = f, Series.constant(ONE, f.variables, order)
    for j in range(order + 1):
        # Taylor in the phase by j, and delta^key = rho^key e^(a_key lambda) monomial by monomial.
        for key, c in slope.coefficients.items():
            if sum(key) <= order:
                grown = _exp(lam, h.grading.weight(key), order)
                shifted = Series({key: c * fmpq(1, factorial(j))}, f.variables, order)
                total = total + shifted * (grown * power)
        slope, power = slope.map(Wave.derivative), power * beta
    return total


def _exp(lam: Series, weight: fmpq, order: int) -> Series:
    """exp(weight lambda) for a series of waves without constant term."""
    total = term = Series.constant(ONE, lam.variables, order)
    for n in range(1, order + 1):
        term = term * lam * (weight / n)
        total = total + term
    return total
