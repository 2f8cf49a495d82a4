"""Initial conditions X(0) = 1, X'(0) = 0 to the order of the expansion, and with them the map to the turning points.

A turning point of X = a sum_k delta^k x_k(psi) near psi = 0 is at a phase psi_0(delta), where the amplitude seen is
a x(psi_0).  Its phase solves X' = 0; with psi = i sigma, q = e^(-sigma) and delta = i eta for the losses alone it is a
rational fixed point,

    sigma = sigma + Yhat(e^(-sigma), eta),      Yhat = -sinh sigma + O(eta),

where each pass makes one more order right.  So A = a exp(lambda), psi_tp = psi - psi_0 with lambda = ln x(psi_0) is the
map from this gauge to the turning-point gauge.  At the start A = 1 and psi_tp = 0: the inverse map, read at delta =
epsilon, is (ln a(0), psi(0)).

>>> from asymptotics.expansions.multiple_scales.exact import odd_hierarchy
>>> start = initial_conditions(odd_hierarchy((3,), 3))
>>> start.amplitude, start.phase                            # a(0) and psi(0) for x'^3, as series in epsilon
(1 + 87/2048*d^2 + O(4), -9/32*d + 15/2048*d^3 + O(4))
"""

from dataclasses import dataclass
from math import factorial

from flint import fmpq

from asymptotics.expansions.half_swings.pi_ring import PiNumber
from asymptotics.expansions.multiple_scales.exact import GAUGE, OddHierarchy, Part
from asymptotics.expansions.normal_form.gauges import GaugeMap
from asymptotics.gauges import TURNING_POINT
from asymptotics.series import Series


@dataclass(frozen=True)
class InitialConditions:
    """a(0) and psi(0) = phi(0) as series in epsilon_i, coefficients fmpq."""

    amplitude: Series
    phase: Series


def initial_conditions(hierarchy: OddHierarchy) -> InitialConditions:
    """a(0), psi(0) for X(0) = 1, X'(0) = 0 through the order of the hierarchy."""
    change = map_to_turning_points(hierarchy).inverse()
    return InitialConditions(change.log_modulus.exp().map(_rational), change.argument.map(_rational))


def map_to_turning_points(hierarchy: OddHierarchy) -> GaugeMap:
    """The map from this gauge to the turning-point gauge, found from the waveform of the hierarchy alone."""
    order, variables = hierarchy.order, hierarchy.forces.variables
    velocity = _taylor(hierarchy, hierarchy.Y)
    sigma = Series({}, variables, order)
    # The fixed point of the docstring: its derivative at 0 is 1 - cosh 0 + O(eta) = O(eta), an order for each pass.
    for _ in range(order):
        sigma = sigma + _at(velocity, sigma)
    # ln x(psi_0) begins with ln cos 0 = 0: the constant term under the logarithm is 1, exactly.
    log_modulus = _at(_taylor(hierarchy, hierarchy.X), sigma).log()
    lam, psi_0 = (hierarchy.real(s).map(PiNumber.rational) for s in (log_modulus, sigma))
    return GaugeMap(GAUGE, TURNING_POINT, hierarchy.grading, lam, -psi_0)


def _taylor(hierarchy: OddHierarchy, parts: tuple[Part, ...]) -> list[Series]:
    """f(e^(-sigma), eta) = sum_j f_j(eta) sigma^j: the f_j, j = 0, ..., N, from sum_m c_m (-m)^j/j!."""
    order, found = hierarchy.order, []
    for j in range(order + 1):
        values = {}
        for n, part in enumerate(parts):
            h = 1 + n * hierarchy.spread
            for k, p in part.items():
                # q^m at q = e^(-sigma) is e^(-m sigma), with m = 2 i - h for the coefficient i.
                total = sum((c * (h - 2 * i) ** j for i, c in enumerate(p.coeffs())), start=fmpq(0))
                values[k] = total / factorial(j)
        found.append(Series({k: c for k, c in values.items() if c != 0}, hierarchy.forces.variables, order))
    return found


def _at(taylor: list[Series], sigma: Series) -> Series:
    """sum_j f_j sigma^j by Horner's rule."""
    total = taylor[-1]
    for f in reversed(taylor[:-1]):
        total = total * sigma + f
    return total


def _rational(c: PiNumber | int) -> fmpq:
    return c.as_rational() if isinstance(c, PiNumber) else fmpq(c)
