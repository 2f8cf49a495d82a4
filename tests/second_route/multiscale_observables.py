"""From the classical route to what can be observed: its own flow, its own map to the turning points, the half-swing.

Nothing of the engine's result enters: p and Omega come from the solvability conditions, the map from the waveform.  The
engine lends the machinery that is the same for every flow (change of gauge, time-pi map), not its numbers.

The other gauges.  The e^(i psi) coefficient of X is a/2, hence that of X' = D X is a (-p + i (1 + Omega))/2 and that of
X - i X' is a (1 + Omega/2 + i p/2).  So the averaging gauge is one line away:

    A e^(i psi_av) = a e^(i psi) (1 + Omega(delta)/2 + i p(delta)/2).

>>> from asymptotics.expansions.multiple_scales.exact import odd_hierarchy
>>> solved = odd_hierarchy((3,), 3)
>>> flow_in(solved, "averaging").p, flow_in(solved, "turning-point").Omega
(3/8*d + 567/8192*d^3 + O(4), -45/256*d^2 + O(4))
>>> half_swing_of(solved).L
-3*pi/8*d + 9*pi**2/64*d^2 + (-...
"""

from dataclasses import replace

from flint import fmpq

from asymptotics.expansions.half_swings.pi_ring import PI, PiNumber
from asymptotics.expansions.half_swings.quarter import HalfSwing
from asymptotics.expansions.multiple_scales.exact import GAUGE, OddHierarchy
from asymptotics.expansions.multiple_scales.initial import map_to_turning_points
from asymptotics.expansions.normal_form.flow import Flow
from asymptotics.expansions.normal_form.gauges import GaugeMap, identity_map, map_of_bracket
from asymptotics.gauges import AVERAGING, NO_FIRST_HARMONIC, TURNING_POINT, require_gauge
from asymptotics.series import Series


def flow_of(hierarchy: OddHierarchy) -> Flow:
    """U = -p/(1 + Omega), W = 1/(1 + Omega) in the gauge of the hierarchy."""
    W = (hierarchy.Omega.map(PiNumber.rational) + 1).inverse()
    return Flow(hierarchy.grading, -(hierarchy.p.map(PiNumber.rational) * W), W)


def map_to(hierarchy: OddHierarchy, gauge: str) -> GaugeMap:
    """The map from the gauge of the hierarchy to any of the three, from its own waveform."""
    require_gauge(gauge)
    flow = flow_of(hierarchy)
    if gauge == NO_FIRST_HARMONIC:
        return identity_map(flow, NO_FIRST_HARMONIC)
    if gauge == AVERAGING:
        return replace(map_of_bracket(flow, _averaging_bracket(hierarchy), AVERAGING), source=GAUGE)
    return map_to_turning_points(hierarchy)


def flow_in(hierarchy: OddHierarchy, gauge: str) -> Flow:
    """The flow of the classical route in any of the three gauges."""
    return map_to(hierarchy, gauge).apply(flow_of(hierarchy))


def half_swing_of(hierarchy: OddHierarchy) -> HalfSwing:
    """L = ln(A_(n+1)/A_n) and the duration T between turning points: observable, the same for every method."""
    return flow_in(hierarchy, TURNING_POINT).half_swing(PI)


def _averaging_bracket(hierarchy: OddHierarchy) -> Series:
    """1 + Omega/2 + i p/2 at delta = i eta: 1 + Omegahat/2 - phat/2."""
    return ((hierarchy.Omega_hat - hierarchy.p_hat) / 2 + 1).map(lambda c: PiNumber.rational(fmpq(c)))
