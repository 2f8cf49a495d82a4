"""Half-swings by interpolation: a panel costs as much as dozens by pieces, each half-swing in it tens of microseconds.

What is interpolated is the return map of the section v = 0, as a function of the amplitude, with its time of return.

A ``Panel`` holds q/p and T as polynomials in a coordinate z (``coordinate``, ``chebyshev``) for all amplitudes of an
interval, with proved errors.  ``Panels`` lays one out when the half-swings still to come are expected to repay it, and
hands out what it has; what no panel serves is integrated.  Only the choice is made in doubles.

Every real amplitude in the interval lies in the polydisc of the majorant, where the motion reaches theta = pi: the next
turning point exists.

>>> from asymptotics.law import Law
>>> with ctx.workprec(80):
...     panel = Panels(Law({1: "1/20", 2: "1/5"}), 80).serving(arb(1), arb(0), 1000)
...     found = panel.half_swing(arb("0.5")) if panel else None
>>> found.amplitude.str(12), found.duration.str(12), found.route
('[0.818929935607 +/- ...]', '[3.15094119172 +/- ...]', 'Chebyshev interpolation in the amplitude')
"""

from dataclasses import dataclass, field

from flint import arb

from asymptotics.errors import LimitError, UndecidedError
from asymptotics.flow.damping import Damping
from asymptotics.flow.linear_spring.linear import is_linear
from asymptotics.law import Law
from asymptotics.numbers.context import ctx, lru_cache
from asymptotics.return_map.chebyshev import Interpolant, interpolant, nodes
from asymptotics.return_map.coordinate import Coordinate
from asymptotics.return_map.half_swing_map import INTEGRATED, HalfSwingBalls, integrated
from asymptotics.return_map.panel_plan import Ellipse, PanelPlan, planned, verified
from asymptotics.running.budget import tick

ROUTE = "Chebyshev interpolation in the amplitude"
COLLOCATED = "quarter-swings by collocation"
ONE = arb(1)
# So that the amplitudes within the error of the first one lie inside; a thousandth more of the interval costs no node.
_MARGIN = 2.0**-10  # a panel begins that much above the amplitude it is made for
# Bits for the nodes and coefficients beyond the panel's, and of the panel beyond those asked for: a value read off it
# must not be the weakest link.
_GUARD, _SLACK = 32, 8
# The averaged path may be wrong for strong laws; a plan whose time is over without its amplitude is replaced, at the
# cost of a new plan.
_AGAIN = 8  # half-swings after which a plan that does not come true is made anew
# Below 2^-512 amplitudes are planned in units of 2^-512, below 2^-1024 in units of 2^-1024, and so on: in doubles,
# whose range ends near 2^-1074. Half as many bits would plan as well, with more panels that end at a border.
_SHRUNK = 512


@dataclass(frozen=True)
class Panel:
    """q/p and T for the exact amplitudes from ``low`` (excluded where it is 0) to ``high``.

    Amplitudes are given as they are, and the panel holds them in its ``unit``, a power of two.  ``cost``: its nodes,
    each found ``by`` a route.
    """

    coordinate: Coordinate
    unit: arb
    low: arb
    high: arb
    middle: arb
    scale: arb
    ratio: Interpolant
    duration: Interpolant
    cost: int
    by: str

    def holds(self, p: arb, error: arb) -> bool:
        """Whether every amplitude within ``error`` of p lies in the panel."""
        nearest, farthest = (p - error) / self.unit, (p + error) / self.unit
        # Comparisons of balls that must be certain; amplitude 0 has no half-swing.
        return bool(nearest >= self.low) and bool(nearest > 0) and bool(farthest <= self.high)

    def half_swing(self, p: arb, error: arb | None = None) -> HalfSwingBalls:
        """The half-swing from the exact amplitude p.

        Its ball of durations holds that of every amplitude within ``error`` of p: what an error of the amplitude does
        to the ratio is led on by contraction (``sequence.following``), what it does to the time is not.
        """
        t = self._place(p)
        # The ratio is that of p itself, as the error of the amplitude is led on by contraction
        # (``sequence.following``); the duration must hold for the truth.
        wide = t if error is None or error == 0 else self._place(arb(p, error))
        return HalfSwingBalls(self.ratio(t), self.duration(wide), ROUTE, self.ratio.degree, self.ratio.error)

    def _place(self, p: arb) -> arb:
        return (self.coordinate(p / self.unit) - self.middle) * self.scale


@dataclass
class Panels:
    """The panels of one law at one precision, laid out as they are needed."""

    law: Law
    bits: int
    made: list[Panel] = field(default_factory=list)
    planned_for: tuple[float, int] = (0.0, 0)
    plan: PanelPlan | None = None
    shrunk: int = 0

    def __post_init__(self) -> None:
        with ctx.workprec(self.bits + _SLACK + _GUARD):
            terms = [(t.strength.ball(), t.velocity) for t in self.law.terms if t.strength.sign > 0]
            damping = Damping.of(terms)
            self.closed, self.sizes = is_linear(damping), damping.sizes
            self.coordinates: dict[int, Coordinate] = {} if self.closed else {0: Coordinate.of(terms)}

    def serving(self, p: arb, error: arb, remaining: int) -> Panel | None:
        """A panel for the amplitudes within ``error`` of p; a new one if ``remaining`` half-swings may repay it."""
        # What has been laid out is free, whatever the plan says.
        for panel in self.made:
            if panel.holds(p, error):
                return panel
        if self.closed:
            return None
        if (shrunk := _shrunk(p)) != self.shrunk:
            self.shrunk, self.plan, self.planned_for = shrunk, None, (0.0, 0)
        coordinate, unit, bits = self.coordinate(shrunk), _unit(shrunk), self.bits + _SLACK
        size = float(p / unit)
        if not (size <= self.planned_for[0] and remaining <= self.planned_for[1]) or self._is_late(size, remaining):
            self.plan, self.planned_for = planned(coordinate, size, remaining, bits), (size, remaining)
        if self.plan is None or not self.plan.low < size <= self.plan.high:
            return None
        try:
            panel = laid_out(coordinate, self.plan, bits, unit)
        except UndecidedError:  # seen in doubles, not proved in balls: by pieces, where the plan would hold
            self.plan = None
            return None
        self.made.append(panel)
        self.planned_for = (0.0, 0)
        return panel if panel.holds(p, error) else None

    def coordinate(self, shrunk: int) -> Coordinate:
        """The coordinate of amplitudes in units of 2^(-512 ``shrunk``)."""
        if shrunk not in self.coordinates:
            with ctx.workprec(self.bits + _SLACK + _GUARD):
                self.coordinates[shrunk] = self.coordinates[0].in_units(_unit(shrunk))
        return self.coordinates[shrunk]

    def _is_late(self, size: float, remaining: int) -> bool:
        """Whether the amplitude of the plan is not there although twice its half-swings have passed."""
        passed = self.planned_for[1] - remaining
        return self.plan is not None and size > self.plan.high and passed > 2 * self.plan.wait + _AGAIN

    def pieces(self, remaining: int) -> int:
        """About how many half-swings by pieces ``remaining`` of them from X = 1 are worth, nodes included.

        0 where they have a closed form.
        """
        if self.closed:
            return 0
        size, shrunk, total = 1.0, 0, 0
        while remaining > 0:
            coordinate = self.coordinate(shrunk)
            plan = planned(coordinate, size, remaining, self.bits + _SLACK)
            if plan is None:
                return total + remaining
            total += plan.wait + plan.work(coordinate)
            remaining -= plan.wait + plan.served
            size = plan.low
            while 0 < size <= 2.0**-_SHRUNK:
                size, shrunk = size * 2.0**_SHRUNK, shrunk + 1
        return total


def _shrunk(p: arb) -> int:
    """How often p can be doubled 512 times and stay at most 1."""
    mantissa, exponent = p.mid().man_exp()
    return max(0, -(int(exponent) + mantissa.bit_length()) // _SHRUNK)


def _unit(shrunk: int) -> arb:
    """2^(-512 ``shrunk``), exactly."""
    return arb(2) ** (-_SHRUNK * shrunk)


@lru_cache(maxsize=16)
def panels_of(law: Law, bits: int) -> Panels:
    """The panels of a law at a precision, kept for the next who asks."""
    return Panels(law, bits)


def laid_out(coordinate: Coordinate, plan: PanelPlan, bits: int, unit: arb = ONE) -> Panel:
    """The panel of a plan, at ``bits`` bits, for amplitudes in that ``unit``; its nodes are integrated."""
    with ctx.workprec(bits + _GUARD):
        # Doubles become exact ends here; all bounds from now on are about the interval between them.
        low, high = arb(plan.low), arb(plan.high * (1 + _MARGIN))
        first, last = _outwards(coordinate, low, high)
        middle, half = (first + last) / 2, (last - first) / 2
        ellipse = verified(coordinate, middle, half, plan.stretch)
        count = ellipse.nodes_for(bits)
        by, swings = _half_swings(coordinate, [middle + half * t for t in nodes(count)], (first, last, ellipse), bits)
        ratios, durations = zip(*swings)
        fine = arb(2) ** -bits
        ratio, duration = (
            interpolant(values, bound, ellipse.R, fine)
            for values, bound in ((ratios, ellipse.ratio_bound), (durations, ellipse.majorant.excess))
        )
    return Panel(coordinate, unit, low, high, middle, 1 / half, ratio, duration, count, by)


def _half_swings(
    coordinate: Coordinate, places: list[arb], within: tuple[arb, arb, Ellipse], bits: int
) -> tuple[str, list[tuple[arb, arb]]]:
    """The route, and q/p and T at the places z: from quarter-swings where those serve, else by pieces.

    ``within``: the least and the largest z, and the ellipse about them.
    """
    first, last, ellipse = within
    if coordinate.is_quartered:
        from asymptotics.return_map.half_swings import HalfSwings  # noqa: PLC0415 (NumPy, only where it pays)

        try:
            # All nodes at once by collocation, about five times cheaper than by pieces (``PanelPlan.work``); where the
            # quarters need too many nodes or are not enclosed, pieces serve.
            swings = (
                HalfSwings.up_to(coordinate, last, bits)
                if coordinate.from_zero
                else HalfSwings.between(coordinate, first, last, ellipse.majorant.growth, bits)
            )
            return COLLOCATED, [swings(z) for z in places]
        except (LimitError, UndecidedError):
            pass
    found = []
    for j, z in enumerate(places):
        tick(f"node {j} of {len(places)} of an interpolation")
        law = coordinate.damping(z)
        with ctx.workprec(bits):
            there = integrated(law, arb(1))
        found.append((_certain(there.amplitude), _certain(there.duration)))
    return INTEGRATED, found


def _outwards(coordinate: Coordinate, low: arb, high: arb) -> tuple[arb, arb]:
    """Exact z that enclose the images of both amplitudes, ascending."""
    # z falls with the amplitude where its root is below 0, so the ends are sorted; rounded outwards, the interval of z
    # holds every amplitude of the panel.
    ends = [arb(0) if p == 0 else coordinate(p) for p in (low, high)]
    first, last = ends if ends[0] < ends[1] else reversed(ends)
    with ctx.workprec(53):
        return (first + 0).lower(), (last + 0).upper()


def _certain(value: arb | None) -> arb:
    if value is None:
        # The majorant proves that the motion reaches theta = pi there; an end would refute it.
        raise ArithmeticError("a half-swing inside the polydisc of the majorant has no end")
    return value
