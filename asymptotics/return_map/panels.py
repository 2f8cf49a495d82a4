"""Half-swings by interpolation: a panel costs as much as dozens by pieces, each half-swing in it tens of microseconds.

What is interpolated is the return map of the section v = 0, as a function of the amplitude, with its time of return.

A ``Panel`` holds q/p and T as polynomials in a coordinate z (``coordinate``, ``chebyshev``) on an interval, with
proved errors.  A ``ReturnMap`` has those of all laws that differ in the unit of amplitude alone (``ray``): of one
exponent every strength, start and half-swing is read off it.  It lays a panel out when the half-swings asked for, and
those that it could not serve before, repay it; what no panel serves is integrated.  Only the choice is made in doubles,
and it depends on what was asked before: times differ, and digits, which are proved, do not.

Every real amplitude in the interval lies in the polydisc of the majorant, where the motion reaches theta = pi, or both
its quarters the centre: the next turning point exists.

>>> from asymptotics.law import Law
>>> with ctx.workprec(80):
...     panels = Panels.alone(Law({1: "1/20", 2: "1/5"}), 80)
...     found = panels.half_swing(arb("0.5"), arb(0), 1000)
>>> found.amplitude.str(12), found.duration.str(12), found.route
('[0.818929935607 +/- ...]', '[3.15094119172 +/- ...]', 'Chebyshev interpolation in the amplitude')
"""

from collections import deque
from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

from flint import arb

from asymptotics.errors import LimitError, UndecidedError
from asymptotics.flow.damping import Damping
from asymptotics.flow.linear_spring.linear import is_linear
from asymptotics.law import Law
from asymptotics.numbers.context import ctx, inside, lru_cache
from asymptotics.return_map.chebyshev import Interpolant, interpolant, nodes
from asymptotics.return_map.coordinate import Coordinate
from asymptotics.return_map.course import Course
from asymptotics.return_map.half_swing_map import INTEGRATED, ROUTE, HalfSwingBalls, integrated
from asymptotics.return_map.panel_plan import (
    MANY,
    Ellipse,
    PanelPlan,
    at_log,
    between,
    farthest,
    from_zero,
    path,
    pieces_from_zero,
    places_of,
    verified,
)
from asymptotics.return_map.ray import Ray, ray_of
from asymptotics.running.budget import tick

if TYPE_CHECKING:
    from asymptotics.return_map.courses import Courses

COLLOCATED = "quarter-swings by collocation"
# Bits for the nodes and coefficients beyond the panel's, and of the panel beyond those asked for: a value read off it
# must not be the weakest link.
_GUARD, _SLACK = 32, 8
_BLOCK = 8  # bits: requests of some more or fewer digits and points share a map
# The averaged path may be wrong for strong laws; a plan whose time is over without its amplitude is replaced, at the
# cost of a new plan.
_COURSES = 40  # half-swings from which on courses are laid out: they cost about 15 half-swings by pieces
_FARTHER = 1 + arb(2) ** -10  # than the place for which courses are made
_AGAIN = 8  # half-swings after which a plan that does not come true is made anew
_MAPS, _LAWS, _PANELS = 32, 64, 64  # kept: maps, views of laws, panels of one map, the latest of each


@dataclass(frozen=True)
class Panel:
    """q/p and T for ``first`` <= z <= ``last``: exact ends, about ``middle`` in units of 1/``scale``.

    ``cost``: its nodes, each found ``by`` a route.
    """

    first: arb
    last: arb
    middle: arb
    scale: arb
    ratio: Interpolant
    duration: Interpolant
    cost: int
    by: str

    def holds(self, z: arb) -> bool:
        """Whether every place in the ball lies in the panel."""
        # Comparisons of balls that must be certain.
        return bool(z >= self.first) and bool(z <= self.last)

    def half_swing(self, z: arb, wide: arb) -> HalfSwingBalls:
        """The half-swing from the place z of an exact amplitude; ``wide`` is that of all amplitudes within its error.

        What an error of the amplitude does to the ratio is led on by contraction (``sequence.following``); what it does
        to the time is not, so that the ball of durations holds that of every place in ``wide``.
        """
        ratio = self.ratio((z - self.middle) * self.scale)
        duration = self.duration((wide - self.middle) * self.scale)
        return HalfSwingBalls(ratio, duration, ROUTE, self.ratio.degree, self.ratio.error)


class Readable(Protocol):
    """What half-swings are read off: a ``Panel``, or from z = 0 on the quarter-swings themselves (``half_swings``)."""

    def holds(self, z: arb, /) -> bool:
        """As of a panel."""

    def half_swing(self, z: arb, wide: arb, /) -> HalfSwingBalls:
        """As of a panel."""


class ReturnMap:
    """The panels of one ray of laws that is not linear, at one precision, laid out as they are needed."""

    def __init__(self, ray: Ray, bits: int) -> None:
        self.bits = bits
        with ctx.workprec(bits + _GUARD):
            self.coordinate = Coordinate.of(ray.terms())
        # Bounded: with z = ln A each law of the ray may add one.
        self.made: deque[Readable] = deque(maxlen=_PANELS)
        self.quartered = self.coordinate.is_quartered
        self.missed: dict[PanelPlan, int] = {}
        self.refused: set[PanelPlan] = set()
        self.courses: Courses | None = None
        self.too_far: arb | None = None  # a place from which on no courses are had
        self.planned_for: tuple[float, int] = (0.0, 0)
        self.plan: PanelPlan | None = None

    @inside
    def panel(self, z: arb, remaining: int) -> Readable | None:
        """A panel for all places in the ball z; a new one if ``remaining`` half-swings may repay it."""
        # What has been laid out is free, whatever the plan says.
        for panel in self.made:
            if panel.holds(z):
                return panel
        plan = self._between(z, remaining) if self.coordinate.root is None else self._from_zero(z, remaining)
        if plan is None:
            return None
        new = self._laid_out(plan)
        if new is None:
            return None
        self.made.append(new)
        self.planned_for = (0.0, 0)
        return new if new.holds(z) else None

    def _laid_out(self, plan: PanelPlan) -> Readable | None:
        try:
            if self.coordinate.root is None or not self.quartered:
                return laid_out(self.coordinate, plan, self.bits)
            from asymptotics.return_map.half_swings import HalfSwings  # noqa: PLC0415 (NumPy, only where it pays)

            return HalfSwings.up_to(self.coordinate, arb(plan.last), self.bits)
        # Seen in doubles, not proved in balls, or too many nodes: by pieces, where the plan would hold.
        except (LimitError, UndecidedError):
            tick()  # where the time is over, the plan is not to blame
            self.refused.add(plan)
            self.plan, self.quartered = None, False
            return None

    @inside
    def courses_to(self, z: arb) -> "Courses | None":
        """Those of all half-swings from places up to z, where one set of quarters serves; they are made once."""
        if not (self.coordinate.is_odd and self.coordinate.from_zero and self.quartered):
            return None
        if self.too_far is not None and not z < self.too_far:
            return None
        if self.courses is None or not z <= self.courses.last:
            from asymptotics.return_map.courses import Courses  # noqa: PLC0415 (NumPy, only where it pays)

            try:
                self.courses = Courses.up_to(self.coordinate, (z * _FARTHER).mid(), self.bits)
            except (LimitError, UndecidedError):
                tick()  # where the time is over, the place is not to blame
                self.too_far = (z / 2).mid()  # a choice: nearer to 0 it is tried again
                return None
            self.made.append(self.courses.swings)
        return self.courses

    def _from_zero(self, z: arb, remaining: int) -> PanelPlan | None:
        """The interval that holds z, if the half-swings that it would have served and will serve repay it."""
        place, c = float(z.upper()), self.coordinate
        long = bool(self.made) or remaining >= MANY  # a choice: who asks for so much may ask for other strengths too
        plan, beyond = from_zero(c, place, self.bits, quartered=self.quartered, long=long), 0.0
        if plan is None:
            plan = farthest(c, self.bits, quartered=self.quartered)
            beyond = 0.5 * places_of(c, quartered=self.quartered)
        if not place <= plan.last or plan in self.refused:
            return None
        missed = self.missed[plan] = self.missed.get(plan, 0) + 1
        work = plan.work(self.quartered)
        # Where z falls as the amplitude does, the panel holds all that follows.
        if beyond or not c.from_zero:
            remaining = self._within(z, (beyond, plan.last), min(remaining, work + 1))
        # As many laws again are to be expected as there were.
        return plan if 2 * missed + remaining > work else None

    def _within(self, z: arb, ends: tuple[float, float], count: int) -> int:
        """About how many of the next ``count`` half-swings begin between two places."""
        root = self.coordinate.root
        assert root is not None
        places = path(self.coordinate, float(z.log()) / float(root), count)
        return sum(ends[0] < at_log(self.coordinate, place) <= ends[1] for place in places)

    def _between(self, z: arb, remaining: int) -> PanelPlan | None:
        place = float(z)
        if not (place <= self.planned_for[0] and remaining <= self.planned_for[1]) or self._is_late(place, remaining):
            self.plan = between(self.coordinate, place, remaining, self.bits)
            self.planned_for = (place, remaining)
        held = self.plan is not None and self.plan.first < place <= self.plan.last
        return self.plan if held and self.plan not in self.refused else None

    def _is_late(self, place: float, remaining: int) -> bool:
        """Whether the amplitude of the plan is not there although twice its half-swings have passed."""
        passed = self.planned_for[1] - remaining
        return self.plan is not None and place > self.plan.last and passed > 2 * self.plan.wait + _AGAIN

    def pieces(self, log_size: float, remaining: int) -> int:
        """About what ``remaining`` half-swings from ln A cost with a new map, in half-swings by pieces."""
        if self.coordinate.root is not None:
            return pieces_from_zero(self.coordinate, log_size, remaining, self.bits)
        total = 0
        while remaining > 0:
            plan = between(self.coordinate, log_size, remaining, self.bits)
            if plan is None:
                return total + remaining
            total += plan.wait + plan.work(self.coordinate.is_quartered)
            remaining -= plan.wait + plan.served
            log_size = plan.first
        return total


class Panels:
    """The return map of one law: that of its ``ray``, at amplitudes in the law's own unit; None where it is linear."""

    def __init__(self, law: Law, kept: ReturnMap | None) -> None:
        self.map = kept
        with ctx.workprec((0 if kept is None else kept.bits) + _GUARD):
            self.damping = Damping.of_law(law)
            self.sizes = self.damping.sizes
            # z at A in the unit of the ray is z(A) times this factor, or plus it.
            self.unit = arb(1) if kept is None else kept.coordinate.unit(ray_of(law)[1]())

    @classmethod
    def alone(cls, law: Law, bits: int) -> "Panels":
        """Of a law whose map nobody else uses."""
        return cls(law, None if _is_closed(law) else ReturnMap(ray_of(law)[0], _rounded(bits)))

    @property
    def closed(self) -> bool:
        """Whether the law is linear: its half-swings have a closed form."""
        return self.map is None

    @property
    def collocated(self) -> bool:
        """Whether the nodes of a panel come from quarter-swings where those serve."""
        return self.map is not None and self.map.coordinate.is_quartered

    def half_swing(self, p: arb, error: arb, remaining: int) -> HalfSwingBalls | None:
        """The half-swing from the exact amplitude p, with the durations of all within ``error``; or None."""
        # Amplitude 0 has no half-swing.
        if self.map is None or not p > error:
            return None
        # The ratio is that of p itself, as the error of the amplitude is led on by contraction
        # (``sequence.following``); the duration must hold for the truth.
        wide = self.place(p if error == 0 else arb(p, error))
        panel = self.map.panel(wide, remaining)
        if panel is None:
            return None
        try:
            return panel.half_swing(wide if error == 0 else self.place(p), wide)
        except UndecidedError:  # an amplitude so uncertain that it may end outside: the pieces may tell
            return None

    def course(self, p: arb, within: int) -> Course | None:
        """The motion from rest at the exact amplitude p; ``within``: of about how many half-swings it will be asked."""
        if self.map is None or within < _COURSES or (root := self.map.coordinate.root) is None:
            return None
        z = self.place(p)
        courses = self.map.courses_to(z)
        found = None if courses is None else self.half_swing(p, arb(0), within)
        if courses is None or found is None or found.amplitude is None or found.duration is None:
            return None
        quarters = courses.quarter(z), courses.quarter(-z * found.amplitude**root)
        return Course.of(*quarters, p, p * found.amplitude, found.duration, self.damping)

    def place(self, p: arb) -> arb:
        """z at an amplitude > 0 of this law, in the unit of the ray."""
        assert self.map is not None
        z = self.map.coordinate(p)
        return z + self.unit if self.map.coordinate.root is None else z * self.unit

    def pieces(self, remaining: int) -> int:
        """About how many half-swings by pieces ``remaining`` of them from X = 1 are worth, nodes included.

        0 where they have a closed form.
        """
        if self.map is None:
            return 0
        z, root = self.place(arb(1)), self.map.coordinate.root
        return self.map.pieces(float(z if root is None else z.log() / root), remaining)


def _is_closed(law: Law) -> bool:
    with ctx.workprec(64):
        return is_linear(Damping.of_law(law))


def _rounded(bits: int) -> int:
    """The bits of the map that serves requests of ``bits``."""
    return -(-(bits + _SLACK) // _BLOCK) * _BLOCK


@lru_cache(maxsize=_MAPS)
def map_of(ray: Ray, bits: int) -> ReturnMap:
    """The return map of a ray at a precision, kept for the next who asks."""
    return ReturnMap(ray, bits)


@lru_cache(maxsize=_LAWS)
def panels_of(law: Law, bits: int) -> Panels:
    """The return map of a law at a precision, which is that of its ray."""
    return Panels(law, None if _is_closed(law) else map_of(ray_of(law)[0], _rounded(bits)))


def laid_out(coordinate: Coordinate, plan: PanelPlan, bits: int) -> Panel:
    """The panel of a plan, at ``bits`` bits; its nodes are integrated."""
    with ctx.workprec(bits + _GUARD):
        # Doubles become exact ends here; all bounds from now on are about the interval between them.
        first, last = arb(plan.first), arb(plan.last)
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
    return Panel(first, last, middle, 1 / half, ratio, duration, count, by)


def _half_swings(
    coordinate: Coordinate, places: list[arb], within: tuple[arb, arb, Ellipse], bits: int
) -> tuple[str, list[tuple[arb, arb]]]:
    """The route, and q/p and T at the places z: from quarter-swings where those serve, else by pieces.

    ``within``: the least and the largest z, and the ellipse about them.
    """
    first, last, ellipse = within
    if coordinate.is_quartered and coordinate.root is None:
        from asymptotics.return_map.half_swings import HalfSwings  # noqa: PLC0415 (NumPy, only where it pays)

        try:
            # All nodes at once by collocation, about five times cheaper than by pieces (``PanelPlan.work``); where the
            # quarters need too many nodes or are not enclosed, pieces serve.
            swings = HalfSwings.between(coordinate, first, last, ellipse.majorant.growth, bits)
            return COLLOCATED, [swings(z) for z in places]
        except (LimitError, UndecidedError):
            tick()
    found = []
    for j, z in enumerate(places):
        tick(f"node {j} of {len(places)} of an interpolation")
        law = coordinate.damping(z)
        with ctx.workprec(bits):
            there = integrated(law, arb(1))
        found.append((_certain(there.amplitude), _certain(there.duration)))
    return INTEGRATED, found


def _certain(value: arb | None) -> arb:
    if value is None:
        # The majorant proves that the motion reaches theta = pi there; an end would refute it.
        raise ArithmeticError("a half-swing inside the polydisc of the majorant has no end")
    return value
