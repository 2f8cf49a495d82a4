"""Which places z the next panel of ``panels`` shall hold, and on which ellipse: choices in doubles, checked in balls.

A panel is worth its nodes if it saves more half-swings than it costs.

* Where z is a power of the amplitude: an interval [0, z_top] out of a fixed row, z_top = 1/2 of the reach and ever
  shorter by the root of 2 (``from_zero``), and 4/5 or 9/10 (``farthest``), so that a map that is asked again finds what
  it has.
* Where z = ln A: from the present amplitude to a smaller one, out of a few (``between``).  Amplitudes to come are
  guessed from the averaged law of each term, A' = -M_(alpha+1) epsilon A^alpha, followed in turn for a half-swing.

>>> from asymptotics.numbers.exact import ExactReal
>>> linear_and_quadratic = Coordinate.of([(arb(1) / 20, ExactReal(1)), (arb(1), ExactReal(2))])
>>> long, short = (from_zero(linear_and_quadratic, z, 120, quartered=True) for z in (0.2, 1e-3))
>>> (long.first, 0.2 < long.last < 0.5, 20 < long.nodes < 60, short.last <= long.last) if long and short else None
(0.0, True, True, True)
>>> from_zero(linear_and_quadratic, 1.0, 120, quartered=True) is None
True
"""

from collections.abc import Iterator
from dataclasses import dataclass
from math import ceil, cos, exp, inf, lgamma, log, log1p, log2, pi, sin, sqrt
from operator import mul

from flint import arb

from asymptotics.errors import UndecidedError
from asymptotics.expansions.half_swings.finite_majorant import Majorant
from asymptotics.flow.balls import upper
from asymptotics.numbers.context import lru_cache
from asymptotics.return_map.coordinate import Coordinate

MIN_STRETCH, MAX_STRETCH = 1.5, 1e6
"""Of the ellipse, (R + 1/R)/2: below, nodes are many and polynomials cancel; above, one node is enough."""
# Half-swings of the path; what comes after them counts as served where z falls, without being looked at.
_LOOK_AHEAD = 3000
_RANGE = 990.0  # log2 of the largest |z| looked at
# In the unit in which a half-swing by pieces costs 1.  They decide only from how many half-swings on a panel is worth
# while.  Of an interval of ln A, measured at 80 bits for alpha = 3/2; of one from 0, a quarter-swing and each node on
# its way: fitted to 3/2, 2, 3 and (1, 2) at 80, 3/2 and 2 at 136 and 3/2 at 300 bits, where panels of 12 to 106 nodes
# cost 4 to 84 half-swings and the fit is off by at most a half, to 6/5 and 6 at 80 by as much again where they are
# strong.
_AT_ONCE, _A_NODE = 4, 0.6  # what quarter-swings cost however few they are, and each of them
_A_QUARTER, _A_PLACE = 0.018, 0.0023
_OF_REACH = tuple(2.0 ** -(k / 2) for k in range(2, 43))  # the last places of the panels from 0
# Of the last one, by whether its nodes are quarter-swings.  Half-swings have to be analytic around it, and these are;
# their collocation takes 1.6 times as many nodes at 0.9 as at 0.5, and 2 to 4 times as many at 1, or fails.
_FARTHEST = {True: 0.9, False: 0.8}
_INSIDE = 0.8  # of the reach of the quarter-swings, so that there is room for an ellipse
# Half-swings by pieces, or the part of the shortest: what a longer panel may cost, as the first of a map for few
# half-swings, and else; by whether its nodes are quarter-swings.
_CHEAP, _DEARER = {True: (6, 22), False: (20, 50)}, 1.1
MANY = 200
"""Half-swings beside which the longer one costs little: 1,000 points of a first law of exponent 3/2 to 5/2 take 1.3 to
1.9 times as long, and those of one up to three times as strong a quarter to a third of what a second panel makes of it.
"""
_DOWN = tuple(
    k * log(2) for k in (0.5, 1, 1.5, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256, 384, 512, 768)
)
_DENSE = 8  # starts looked at one by one; then ever fewer
_STEPS, _FINE = 24, 200  # of a quarter; one reach is found for many half-swings
# ln of what the steepest strength grows by, at most, in a quarter-swing; smaller alpha - 1, which doubles may not tell
# from 0, are taken for this one.
_STEEP, _FLAT = 2.5, 1 / 16
_MARGIN = 2.0**-10  # a panel of ln A begins that much above the amplitude it is made for: the error of it lies inside


@dataclass(frozen=True)
class PanelPlan:
    """z from ``first`` to ``last`` on ``nodes`` nodes, for ``served`` half-swings, after ``wait`` without it.

    ``stretch``: the half axis of the ellipse in units of the panel's half width; of an interval from 0 ``sides``, 1
    where one set of quarter-swings serves forwards and backwards, else 2, and the nodes ``along`` each of them.
    """

    first: float
    last: float
    stretch: float
    nodes: int
    served: int = 0
    wait: int = 0
    sides: int = 0
    along: float = 0

    def work(self, quartered: bool) -> int:
        """What the nodes cost, in half-swings by pieces."""
        if not quartered:
            return self.nodes
        if not self.sides:
            return _AT_ONCE + int(_A_NODE * self.nodes)
        return 1 + ceil(self.sides * self.nodes * (_A_QUARTER + _A_PLACE * self.along))


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


def from_zero(coordinate: Coordinate, z: float, bits: int, *, quartered: bool, long: bool = False) -> PanelPlan | None:
    """The interval from 0 that shall hold z >= 0, a power of the amplitude; None beyond half of the reach.

    The longest of a row that is not much dearer than the shortest; ``quartered``: read off quarter-swings; ``long``: it
    may be dearer, for laws to come.
    """
    plans: list[PanelPlan] = []
    for share in _OF_REACH:
        plan = _up_to(coordinate, share, bits, quartered)
        if not plan.last >= z or not plan.last > 0:
            break
        plans.append(plan)
    if not plans:
        return None
    # A longer one serves more laws.
    most = max(_CHEAP[quartered][long], _DEARER * plans[-1].work(quartered))
    return next((p for p in plans if p.work(quartered) <= most), plans[-1])


def farthest(coordinate: Coordinate, bits: int, *, quartered: bool) -> PanelPlan:
    """The interval from 0 that ends next to the reach: dear, for places that no other holds."""
    return _up_to(coordinate, _FARTHEST[quartered], bits, quartered)


@lru_cache(maxsize=256)
def _up_to(coordinate: Coordinate, share: float, bits: int, quartered: bool) -> PanelPlan:
    last, odd = share * places_of(coordinate, quartered=quartered), coordinate.is_odd
    # The half width is last/2, and the ellipse may go as far as the reach.  Quarters of one law have the middle 0.
    middle, half = (0.0, last) if quartered and odd else (last / 2, last / 2)
    stretch = widest(coordinate, middle, half, whole=not quartered) or MIN_STRETCH  # of an interval that is empty
    # Measured as well: 74 nodes at 80 bits for a share of 0.15, 103 for 0.5, 169 for 0.9.
    along = 0.83 * bits / (1 - 0.67 * share)
    return PanelPlan(0.0, last, stretch, _count(bits, stretch), sides=1 if odd else 2, along=along)


def pieces_from_zero(coordinate: Coordinate, log_size: float, remaining: int, bits: int) -> int:
    """What ``remaining`` half-swings from ln A cost in half-swings by pieces, the nodes of ``from_zero`` included."""
    held, total, quartered = -1.0, 0, coordinate.is_quartered
    places = list(path(coordinate, log_size, min(remaining, _LOOK_AHEAD)))
    for z in (at_log(coordinate, place) for place in places):
        if z <= held:
            continue
        plan = from_zero(coordinate, z, bits, quartered=quartered)
        if plan is None:
            total += 1
        else:
            held, total = plan.last, total + plan.work(quartered)
    # What comes after the path: served if that is long, by pieces where it ended early.
    return min(total if len(places) == _LOOK_AHEAD else total + remaining - len(places), remaining)


def at_log(coordinate: Coordinate, log_size: float) -> float:
    """z at ln A in doubles, 0 or infinity beyond their range."""
    if coordinate.root is None:
        return log_size
    power = float(coordinate.root) * log_size
    return exp(power) if power < 700 else inf


def between(coordinate: Coordinate, log_size: float, remaining: int, bits: int) -> PanelPlan | None:
    """With z = ln A: from one of a few starts on the path to one of a few places below it: the one that saves most."""
    if remaining < 4:
        return None
    places = list(path(coordinate, log_size, min(remaining, _LOOK_AHEAD)))
    best, gain, start = None, 0, 0
    # A start so late that fewer half-swings are left than the best plan saves cannot save more.
    while start < len(places) - gain - 4:
        for down in _DOWN:
            low = places[start] - down
            served = sum(place > low for place in places[start:])
            if served == len(places) - start:
                # The last place of the path, and what it may be off by.
                low = places[-1] - 0.02
            last = places[start] + _MARGIN
            stretch = widest(coordinate, (low + last) / 2, (last - low) / 2)
            if stretch > MIN_STRETCH:
                plan = PanelPlan(low, last, stretch, _count(bits, stretch), served, start)
                if served - (cost := plan.work(coordinate.is_quartered)) > gain:
                    best, gain = plan, served - cost
            if stretch <= MIN_STRETCH or served == len(places) - start:
                break
        # Ever fewer starts: at least half of the amplitude farther down.
        start += max(1, start // _DENSE, sum(place > places[start] - log(2) for place in places[start:]))
    return best


def path(coordinate: Coordinate, log_size: float, count: int) -> Iterator[float]:
    """ln A at ``count`` turning points, by the averaged laws, as long as it moves.

    >>> from asymptotics.numbers.exact import ExactReal
    >>> places = path(Coordinate.of([(arb(25), ExactReal(3))]), 0.0, 3)  # strong at first: the first order says 1e-13
    >>> [round(exp(place), 3) for place in places]
    [1.0, 0.129, 0.092]
    """
    laws = [(_moment(float(a) + 1) * float(e), float(a) - 1) for e, a in zip(coordinate.epsilons, coordinate.exponents)]
    for _ in range(count):
        yield log_size
        try:
            for m, w in laws:
                loss = pi * m * exp(w * log_size)
                # The averaged law A' = -m A^(w+1) of one term solved over a half-swing: A^-w grows by w m pi.
                log_size -= loss if w == 0 else log1p(w * loss) / w
        except (OverflowError, ValueError):  # too strong to go on; or friction stops the mass
            return


def _moment(p: float) -> float:
    return exp(lgamma((p + 1) / 2) - lgamma(p / 2 + 1)) / sqrt(pi)


@lru_cache(maxsize=64)
def reach_of(coordinate: Coordinate, *, whole: bool = True, by_modulus: bool = False) -> float:
    """About the largest |z| with a majorant (of the quarter-swing, if not ``whole``), or 0: bisection of log2 |z|.

    ``by_modulus``: of the quarter-swing as ``finite_majorant`` bounds it.
    """
    low, high = -_RANGE, _RANGE
    while high - low > 0.03:
        middle = (low + high) / 2
        there = _exists(coordinate, 0.0, 2.0**middle, whole, _FINE, by_modulus=by_modulus)
        low, high = (middle, high) if there else (low, middle)
    return float(2.0**low) if low > -_RANGE else 0.0


def places_of(coordinate: Coordinate, *, quartered: bool) -> float:
    """What the last places of panels from 0 are shares of."""
    if not quartered:
        return reach_of(coordinate)
    # Quarter-swings are analytic farther out than by modulus, but so their collocation (``quarters``) bounds |c D|.
    return min(reach_of(coordinate, whole=False, by_modulus=True), _INSIDE * reach_of(coordinate, whole=False))


def widest(coordinate: Coordinate, middle: float, half: float, *, whole: bool = True) -> float:
    """About the largest half axis, in units of the half width, with a majorant about a middle z; 0 if there is none."""
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


def _exists(
    coordinate: Coordinate,
    middle: float,
    half_axis: float,
    whole: bool = True,
    count: int = _STEPS,
    *,
    by_modulus: bool = False,
) -> bool:
    """Whether the majorant seems to exist there: its equation by midpoint steps in doubles."""
    try:
        high, low = (_strengths(coordinate, middle + side * half_axis) for side in (1, -1))
        sizes = [max(pair) for pair in zip(high, low, strict=True)] if coordinate.root is None else high
        growth, slopes = 0.0, [abs(float(a) - 1) for a in coordinate.exponents]
        most = 4.0 if whole or by_modulus else _STEEP / max(*slopes, _FLAT)
        steps = _quarter(tuple(map(float, coordinate.exponents)), count)
        for sines, products in steps if whole else steps[:count]:
            strengths = [size * exp(slope * growth) for size, slope in zip(sizes, slopes)]
            room = 1 - sum(map(mul, strengths, products))
            # 1 - C* so small, or so much growth, in doubles: the balls of 256 pieces would not prove it, or the bound
            # would be useless.
            if not room > 0.02 or growth > most:
                return False
            # Of a quarter the real part counts, which grows less (``quarter_majorant``): 2 - room = 1 + C*.
            growth += pi / 2 / count * sum(map(mul, strengths, sines)) / (room if whole or by_modulus else 2 - room)
    except OverflowError:
        return False
    return True


def _strengths(coordinate: Coordinate, z: float) -> list[float]:
    """|delta_i| at |z|, or at Re z."""
    by_power = coordinate.root is not None
    sizes = zip(map(float, coordinate.epsilons), map(float, coordinate.powers))
    return [e * (abs(z) ** k if by_power else exp(k * z)) for e, k in sizes]


@lru_cache(maxsize=64)
def _quarter(alphas: tuple[float, ...], count: int) -> list[tuple[list[float], list[float]]]:
    """s^(alpha_i+1) and s^alpha_i |c| at the middles of the steps of two quarters."""
    angles = [pi / 2 * (j + 0.5) / count for j in range(2 * count)]
    return [([sin(t) ** (a + 1) for a in alphas], [sin(t) ** a * abs(cos(t)) for a in alphas]) for t in angles]


def _count(bits: int, stretch: float) -> int:
    # 8 for the majorant on an ellipse near the edge, before it is known: three bits of a count.
    return _nodes(bits, 8.0, stretch + sqrt(stretch**2 - 1))


def _nodes(bits: int, size: float, R: float) -> int:
    # ``chebyshev.cut`` <= 2^-bits solved for m.
    return max(1, ceil((bits + log2(2 * size * (R + 1) / (R - 1))) / log2(R)))
