"""A multiple-scale expansion as a result: amplitude and frequency series, with gauge, arithmetic and order.

    dA/d tau = -A (p_1 delta + p_3 delta^3 + ...),      d psi/d tau = 1 + Omega_2 delta^2 + Omega_4 delta^4 + ...

``order`` N: p_k and Omega_k for all k <= N.  For sums of laws the coefficients carry one exponent per law.

>>> expansion = exact_expansion((2,), 3)
>>> expansion.p, expansion.Omega
(4/(3*pi)*d + 2/(135*pi)*d^3 + O(4), -1/6*d^2 + O(4))
>>> print(exact_expansion((3,), 3, "no-first-harmonic"))
degrees 3, gauge no-first-harmonic, exact, order 3
p: 3/8*d + 351/8192*d^3 + O(4)
Omega: 9/256*d^2 + O(4)
"""

from dataclasses import dataclass
from typing import Any

from flint import arb

from asymptotics.costs import exact_expansion_seconds, require_affordable
from asymptotics.expansions.half_swings.exact import exact_half_swing, exact_quarter_swing
from asymptotics.expansions.half_swings.forces import Forces, Given
from asymptotics.expansions.half_swings.fourier_flow import fourier_flow
from asymptotics.expansions.half_swings.pi_ring import PiNumber
from asymptotics.expansions.half_swings.quarter import HalfSwing, QuarterSwing, half_swing
from asymptotics.expansions.normal_form.flow import Flow, flow_of
from asymptotics.expansions.normal_form.gauges import (
    GaugeMap,
    gauge_map,
    identity_map,
    map_of_bracket,
)
from asymptotics.gauges import TURNING_POINT, require_gauge
from asymptotics.numbers.exact import MAX_ORDER
from asymptotics.numbers.integers import require_integer
from asymptotics.running.budget import Unasked
from asymptotics.series import Series

MAX_SECONDS = Unasked(60)


@dataclass(frozen=True)
class Expansion:
    """The normal form of one law or of a sum, in one gauge.

    ``flow``: U and W in this gauge; ``half``: the half-swing it came from (turning-point gauge by nature);
    ``gauge_map``: the map from the turning-point gauge to this one; ``arithmetic``: "exact" or "certified".
    """

    gauge: str
    arithmetic: str
    order: int
    flow: Flow
    half: HalfSwing
    gauge_map: GaugeMap

    @property
    def degrees(self) -> tuple[Any, ...]:
        """The degrees of homogeneity (the exponents of pure losses), as numbers of the coefficient ring."""
        return self.flow.grading.degrees

    @property
    def p(self) -> Series:
        """p(delta) in dA/d tau = -A p(delta)."""
        return self.flow.p

    @property
    def Omega(self) -> Series:
        """Omega(delta) in d psi/d tau = 1 + Omega(delta)."""
        return self.flow.Omega

    @property
    def pi(self) -> Any:
        """pi in the coefficient ring."""
        return self.half.T.constant_term

    def turning_point_flow(self) -> Flow:
        """The flow carried back to the turning-point gauge by the inverse gauge map."""
        return self.gauge_map.inverse().apply(self.flow)

    def _repr_latex_(self) -> str:
        names = [r"\delta"] if len(self.degrees) == 1 else [rf"\delta_{{{i}}}" for i in range(len(self.degrees))]
        p, Omega = (latex_series(s, names) for s in (self.p, self.Omega))
        return rf"$\frac{{dA}}{{d\tau}} = -A\left({p}\right),\quad \frac{{d\psi}}{{d\tau}} = 1 + {Omega}$"

    def __str__(self) -> str:
        degrees = ", ".join(str(d) for d in self.degrees)
        head = f"degrees {degrees}, gauge {self.gauge}, {self.arithmetic}, order {self.order}"
        return f"{head}\np: {self.p}\nOmega: {self.Omega}"


def latex_series(series: Series, names: list[str]) -> str:
    """A truncated series in LaTeX: exact coefficients exactly, balls to six digits with their radius.

    >>> print(latex_series(exact_expansion((2,), 3).p, ["x"]))
    \\frac{4}{3 \\pi} x + \\frac{2}{135 \\pi} x^{3}
    """
    terms = []
    for key, c in ((k, c) for part in series.parts for k, c in part):
        number = c.closed().latex() if isinstance(c, PiNumber) else c.str(6) if isinstance(c, arb) else str(c)
        power = " ".join(name + (f"^{{{n}}}" if n > 1 else "") for name, n in zip(names, key) if n)
        terms.append(f"{number} {power}".strip())
    return " + ".join(terms) or "0"


def expansion_of(quarter: QuarterSwing, gauge: str = TURNING_POINT, *, arithmetic: str) -> Expansion:
    """The expansion from the data of a quarter-swing; other gauges than the turning-point gauge need its moments K."""
    require_gauge(gauge)
    half = half_swing(quarter)
    flow = flow_of(half)
    change = gauge_map(flow, quarter.K, gauge)
    return Expansion(gauge, arithmetic, half.order, _in_gauge(flow, change), half, change)


def exact_expansion(
    given: Given, order: int, gauge: str = TURNING_POINT, *, max_seconds: float = MAX_SECONDS
) -> Expansion:
    """The exact expansion for integer exponents >= 0 through ``order`` >= 1: exponents of losses, terms, or forces.

    Raises InputError for exponents that are not integers or an unknown gauge, LimitError when the estimated time is
    above ``max_seconds``.
    """
    require_gauge(gauge)
    forces = Forces.read(given, order)
    require_size(forces, order, gauge, max_seconds)
    # The smallest algebra first: rational Fourier polynomials, then the half-swing, then the quarter with its moments.
    if forces.is_smooth:
        return _smooth_expansion(forces, order, gauge)
    # No waveform moments are wanted here, so that the half-swing may choose its algebra.
    if gauge == TURNING_POINT:
        half = exact_half_swing(forces, order)
        flow = flow_of(half)
        return Expansion(gauge, "exact", order, flow, half, identity_map(flow))
    return expansion_of(exact_quarter_swing(forces, order, moments=True), gauge, arithmetic="exact")


def _smooth_expansion(forces: Forces, order: int, gauge: str) -> Expansion:
    """Smooth forces: the bracket is the mean of the turning-point waveform, a rational Fourier polynomial."""
    half = exact_half_swing(forces, order)
    source = fourier_flow(forces, order)
    flow = Flow(half.grading, source.U, source.W)
    if gauge == TURNING_POINT:
        return Expansion(gauge, "exact", order, flow, half, identity_map(flow))
    change = map_of_bracket(flow, source.bracket(gauge), gauge)
    return Expansion(gauge, "exact", order, change.apply(flow), half, change)


def _in_gauge(flow: Flow, change: GaugeMap) -> Flow:
    return flow if change.target == TURNING_POINT else change.apply(flow)


def estimated_seconds(given: Given, order: int, gauge: str = TURNING_POINT) -> float:
    """A rough estimate of the time for an exact expansion."""
    forces = Forces.read(given, order)
    # Of the first member of a family only: the others have a higher degree and a higher order in the same measure.
    degree = max(2, *(m.integer_velocity + m.position for m in forces.members if m.order == 1)) / 2
    plain = gauge == TURNING_POINT
    return exact_expansion_seconds(order, forces.variables, degree, smooth=forces.is_smooth, turning_point=plain)


def require_size(given: Given, order: int, gauge: str = TURNING_POINT, max_seconds: float = MAX_SECONDS) -> None:
    """InputError for an order below 1, LimitError when the estimated time is above ``max_seconds``."""
    require_integer(order, "order", 1, MAX_ORDER)
    require_affordable(estimated_seconds(given, order, gauge), max_seconds, "order", f"order {order}")
