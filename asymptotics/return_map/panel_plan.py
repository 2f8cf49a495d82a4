"""Which amplitudes the next panel of ``panels`` shall hold, and on which ellipse: choices in doubles, checked in balls.

A panel is worth its nodes if it saves more half-swings than it costs.  Amplitudes to come are guessed from the averaged
law of each term, A' = -M_(alpha+1) epsilon A^alpha, followed in turn for a half-swing.

* Where z falls to 0: one panel from there; larger amplitudes before it are integrated if that saves nodes.
* Otherwise from the present amplitude to a smaller one, out of a few.

>>> from asymptotics.numbers.exact import ExactReal
>>> linear_and_quadratic = Coordinate.of([(arb(1) / 20, ExactReal(1)), (arb(1) / 5, ExactReal(2))])
>>> plan = planned(linear_and_quadratic, 1.0, 1000, 120)
>>> (plan.low, plan.wait < 9, 15 < plan.nodes < 50, plan.served > 900) if plan else None
(0.0, True, True, True)
>>> planned(linear_and_quadratic, 1.0, 10, 120) is None
True
"""

from collections.abc import Iterator
from dataclasses import dataclass
from math import ceil, cos, exp, inf, lgamma, log1p, log2, pi, sin, sqrt
from operator import mul

from flint import arb

from asymptotics.errors import UndecidedError
from asymptotics.expansions.half_swings.finite_majorant import BITS, Majorant
from asymptotics.flow.balls import upper
from asymptotics.numbers.context import ctx, lru_cache
from asymptotics.return_map.coordinate import Coordinate

MIN_STRETCH, MAX_STRETCH = 1.5, 1e6
"""Of the ellipse, (R + 1/R)/2: below, nodes are many and polynomials cancel; above, one node is enough."""
# Half-swings of the path; what comes after them counts for a panel that ends at z = 0 without being looked at.
_LOOK_AHEAD = 3000
_RANGE = 990.0  # log2 of the largest |z| looked at
# In the unit in which a half-swing by pieces costs 1.  Where 8 was measured is not recorded; it decides only from how
# many half-swings on a panel is worth while.
_AT_ONCE = 8  # half-swings by pieces: what quarter-swings cost, however few nodes there are
# Half-swings before the panel are weighed against its nodes: 5 or 20 would wait a little longer or shorter for it.
_LASTING = 10  # a node is kept for the next who asks, a half-swing before the panel is not
_PARTS = tuple(2.0**-k for k in (0.5, 1, 1.5, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256, 384, 512, 768))
_DENSE = 8  # starts looked at one by one; then ever fewer
_STEPS = 24  # of a quarter


@dataclass(frozen=True)
class PanelPlan:
    """Amplitudes ``low`` to ``high`` on ``nodes`` nodes, for ``served`` half-swings, after ``wait`` without it.

    ``stretch``: the half axis of the ellipse in units of the panel's half width.
    """

    low: float
    high: float
    stretch: float
    nodes: int
    served: int
    wait: int

    def work(self, coordinate: Coordinate) -> int:
        """What the nodes cost, in half-swings by pieces."""
        return _AT_ONCE + self.nodes // 5 if coordinate.is_quartered else self.nodes


@dataclass(frozen=True)
class Ellipse:
    """The parameter R, and the majorant on it."""

    R: arb
    majorant: Majorant

    @property
    def ratio_bound(self) -> arb:
        """Of |q/p - 1|: e^G - 1."""
        return upper(self.majorant.growth.expm1())

    def nodes_for(self, bits: int) -> int:
        """How many nodes make both cuts less than 2^-bits."""
        # The larger of the two bounds M serves both functions; in doubles, as a node more or less only moves the cut,
        # which is bounded afterwards.
        size = max(float(self.ratio_bound), float(self.majorant.excess), 1e-300)
        return _nodes(bits, size, float(self.R))


def verified(coordinate: Coordinate, middle: arb, half: arb, stretch: float, *, whole: bool = True) -> Ellipse:
    """The ellipse about a panel, made smaller until its majorant is proved to exist."""
    # The semi-axis chosen in doubles, and shorter ones until the majorant is proved: R = a + (a^2 - 1)^(1/2) for the
    # half axis a.  Near 1 the excess over 1 is halved.
    while stretch > 1:
        longer = arb(stretch)
        bound = coordinate.bounds(middle, arb((half * longer).upper()), whole=whole)
        if bound is not None:
            return Ellipse(longer + (longer**2 - 1).sqrt(), bound)
        stretch = 0.5 + stretch / 2 if stretch < 2 else 0.97 * stretch
    raise UndecidedError("no ellipse about the panel is proved to lie in the domain of the half-swing")


def planned(coordinate: Coordinate, size: float, remaining: int, bits: int) -> PanelPlan | None:
    """The plan for ``remaining`` half-swings from the amplitude ``size``, None where no panel repays its nodes."""
    if remaining < 4 or not 0 < size < inf:
        return None
    with ctx.workprec(BITS):
        path = list(_path(coordinate, size, min(remaining, _LOOK_AHEAD)))
        beyond = remaining - len(path) if len(path) == _LOOK_AHEAD else 0
        if coordinate.from_zero:
            return _from_zero(coordinate, path, beyond, bits)
        return _between(coordinate, path, bits)


def _from_zero(coordinate: Coordinate, path: list[float], beyond: int, bits: int) -> PanelPlan | None:
    """One panel for all amplitudes from some point of the path on."""
    reach, best, total = reach_of(coordinate), None, len(path) + beyond
    cheapest = inf
    for wait, size in enumerate(path):
        z = float(coordinate(arb(size)))
        # The panel is [0, z], half width z/2; the ellipse may go as far as the reach, (reach - z/2)/(z/2).
        stretch = min(2 * reach / z - 1, MAX_STRETCH) if z > 0 else MAX_STRETCH
        if stretch > MIN_STRETCH:
            plan = PanelPlan(0.0, size, stretch, _count(bits, stretch), total - wait, wait)
            cost = plan.work(coordinate)
            if cost + wait < total and cost + _LASTING * wait < cheapest:
                best, cheapest = plan, cost + _LASTING * wait
        if _LASTING * wait > cheapest:
            break
    return best


def _between(coordinate: Coordinate, path: list[float], bits: int) -> PanelPlan | None:
    """From one of a few starts on the path to one of a few amplitudes below it: the one that saves most."""
    best, gain, start = None, 0, 0
    # A start so late that fewer half-swings are left than the best plan saves cannot save more.
    while start < len(path) - gain - 4:
        for part in _PARTS:
            low = path[start] * part
            served = sum(size > low for size in path[start:])
            if served == len(path) - start:
                # The last amplitude of the path, and what it may be off by.
                low = 0.98 * path[-1]
            stretch = _stretch(coordinate, low, path[start])
            if stretch > MIN_STRETCH:
                plan = PanelPlan(low, path[start], stretch, _count(bits, stretch), served, start)
                if served - (cost := plan.work(coordinate)) > gain:
                    best, gain = plan, served - cost
            if stretch <= MIN_STRETCH or served == len(path) - start:
                break
        # Ever fewer starts: at least half of the amplitude farther down.
        start += max(1, start // _DENSE, sum(size > path[start] / 2 for size in path[start:]))
    return best


def _path(coordinate: Coordinate, size: float, count: int) -> Iterator[float]:
    """``count`` amplitudes, by the averaged laws, while they are positive.

    >>> from asymptotics.numbers.exact import ExactReal
    >>> path = _path(Coordinate.of([(arb(25), ExactReal(3))]), 1.0, 3)  # strong at first: the first order says 1e-13
    >>> [round(size, 3) for size in path]
    [1.0, 0.129, 0.092]
    """
    laws = [(_moment(float(a) + 1) * float(e), float(a) - 1) for e, a in zip(coordinate.epsilons, coordinate.exponents)]
    for _ in range(count):
        if not size > 1e-290:
            return
        yield size
        try:
            for m, w in laws:
                loss = pi * m * size**w
                # The averaged law A' = -m A^(w+1) of one term solved over a half-swing: A^-w grows by w m pi.
                size *= exp(-loss if w == 0 else -log1p(w * loss) / w)
        except (OverflowError, ValueError):  # too strong to go on; or friction stops the mass
            return


def _moment(p: float) -> float:
    return exp(lgamma((p + 1) / 2) - lgamma(p / 2 + 1)) / sqrt(pi)


@lru_cache(maxsize=64)
def reach_of(coordinate: Coordinate, *, whole: bool = True) -> float:
    """About the largest |z| with a majorant (of the quarter-swing, if not ``whole``), or 0: bisection of log2 |z|."""
    low, high = -_RANGE, _RANGE
    while high - low > 0.03:
        middle = (low + high) / 2
        low, high = (middle, high) if _exists(coordinate, 0.0, 2.0**middle, whole) else (low, middle)
    return float(2.0**low) if low > -_RANGE else 0.0


def _stretch(coordinate: Coordinate, low: float, high: float) -> float:
    """About the largest half axis, in units of the half width, with a majorant; 0 if there is none."""
    first, last = sorted(float(coordinate(arb(p))) for p in (low, high))
    return widest(coordinate, (first + last) / 2, (last - first) / 2)


def widest(coordinate: Coordinate, middle: float, half: float, *, whole: bool = True) -> float:
    """The same about a middle z (of the quarter-swing, if not ``whole``)."""
    if not half > 0:
        return 0.0
    if coordinate.root is not None:
        # The polydisc is a disc about z = 0, so that what counts is how far the ellipse goes on the right.
        return min((reach_of(coordinate, whole=whole) - middle) / half, MAX_STRETCH)
    if _exists(coordinate, middle, half * MAX_STRETCH, whole):  # exponents next to 1: strengths that hardly change
        return MAX_STRETCH
    below, above = 0.0, MIN_STRETCH
    while above < MAX_STRETCH and _exists(coordinate, middle, half * above, whole):
        below, above = above, 2 * above
    while above > 1.05 * below > 0:
        between = (below + above) / 2
        below, above = (between, above) if _exists(coordinate, middle, half * between, whole) else (below, between)
    return below


def _exists(coordinate: Coordinate, middle: float, half_axis: float, whole: bool = True) -> bool:
    """Whether the majorant seems to exist there: its equation by midpoint steps in doubles."""
    try:
        high, low = (_strengths(coordinate, middle + side * half_axis) for side in (1, -1))
        sizes = [max(pair) for pair in zip(high, low, strict=True)] if coordinate.root is None else high
        growth, slopes = 0.0, [abs(float(a) - 1) for a in coordinate.exponents]
        steps = _quarter(tuple(map(float, coordinate.exponents)))
        for sines, products in steps if whole else steps[:_STEPS]:
            strengths = [size * exp(slope * growth) for size, slope in zip(sizes, slopes)]
            room = 1 - sum(map(mul, strengths, products))
            # 1 - C* so small, or a growth e^4, in doubles: the balls of 256 pieces would not prove it, or the bound
            # would be useless.
            if not room > 0.02 or growth > 4:
                return False
            growth += pi / 2 / _STEPS * sum(map(mul, strengths, sines)) / room
    except OverflowError:
        return False
    return True


def _strengths(coordinate: Coordinate, z: float) -> list[float]:
    """|delta_i| at |z|, or at Re z."""
    by_power = coordinate.root is not None
    sizes = zip(map(float, coordinate.epsilons), map(float, coordinate.powers))
    return [e * (abs(z) ** k if by_power else exp(k * z)) for e, k in sizes]


@lru_cache(maxsize=64)
def _quarter(alphas: tuple[float, ...]) -> list[tuple[list[float], list[float]]]:
    """s^(alpha_i+1) and s^alpha_i |c| at the middles of the steps of two quarters."""
    angles = [pi / 2 * (j + 0.5) / _STEPS for j in range(2 * _STEPS)]
    return [([sin(t) ** (a + 1) for a in alphas], [sin(t) ** a * abs(cos(t)) for a in alphas]) for t in angles]


def _count(bits: int, stretch: float) -> int:
    # 8 for the majorant on an ellipse near the edge, before it is known: three bits of a count.
    return _nodes(bits, 8.0, stretch + sqrt(stretch**2 - 1))


def _nodes(bits: int, size: float, R: float) -> int:
    # ``chebyshev.cut`` <= 2^-bits solved for m.
    return max(1, ceil((bits + log2(2 * size * (R + 1) / (R - 1))) / log2(R)))
