"""Creep where exponents are nearly equal: the slow curve over a stretch of ln w, between two barriers.

w^d with a small d is no small number: a sum of powers of it (``slow_curve_series``) has too many terms.  But over a
stretch, ln w = centre + reach t with |t| <= 1, the laws of a group of exponents beside its least, beta, are together

    sum_i epsilon_i w^(beta + eta_i) = w^beta sum_k m_k t^k/k!,  m_k = sum_i epsilon_i e^(eta_i centre) (eta_i reach)^k,

cut off after a few k with a proved remainder.  So the coefficients of the slow curve are polynomials in t, their
derivatives join A, and the barriers are those of one law, but with a constant theta, as long as the stretch lasts
(derivation ``slow-curve``).

>>> from fractions import Fraction
>>> from asymptotics.numbers.exact import ExactReal
>>> law = Damping.of([(arb(1), ExactReal(Fraction(1, 2))), (arb(1), ExactReal(Fraction(1, 2) + Fraction(1, 10**20)))])
>>> with ctx.workprec(80):
...     y = arb("0.01")
...     w = (y / 2) ** 2 * (1 + y**2 / 4)
...     strip = stretch(law, y, w, arb("1e-9"))
...     strip.state(arb(10) ** 9)[0].str(3)
'[4.00e-9 +/- ...]'
"""

from dataclasses import dataclass
from itertools import product
from math import lgamma, log, log2, log10
from operator import add, mul, sub

from flint import arb, arb_poly

from asymptotics.errors import UndecidedError
from asymptotics.flow.balls import size_of, upper
from asymptotics.flow.damping import Damping
from asymptotics.flow.slow_manifold.slow_curve import INSIDE, ORDERS, WIDEST, FencedStrip, solve, too_early
from asymptotics.flow.slow_manifold.slow_curve_series import Key, lower_set, unit
from asymptotics.numbers.context import ctx
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.precision import at_growing_precision

# Exponents farther apart have w^d small enough to be a power of its own; a strip is verified whatever the groups are.
_NEAR = arb(1) / 4  # exponents of one group differ by less
# Four bits for each power of t; and where all eta are tiny a stretch still ends, at a speed e^2048 times lower.
_SHARE, _FARTHEST = 1 / 16, 1024.0  # eta times the reach, and the reach, at most
# A choice: too small a number misses a strip and costs steps, too large a one costs series in vain.
_OPEN = 4  # times the terms of the last order but one looked at: what later ones may add up to
# So that Newton's method for the time stays where the barriers hold.
_MARGIN = arb(1) / 64  # of ln w, at the end of a stretch
_LN2, _DIGITS = log(2), log10(2)

Part = tuple[arb_poly, arb]  # a polynomial in t, and the exponent of the w that stands beside it


@dataclass(frozen=True)
class Scale:
    """ln w = centre + reach t, both exact."""

    centre: arb
    reach: arb

    def t(self, log_w: arb) -> arb:
        """Where ln w is on the stretch."""
        return (log_w - self.centre) / self.reach

    def slope(self, part: Part) -> arb_poly:
        """Of p(t) w^e: its derivative by ln w, over w^e."""
        return part[0] * part[1] + part[0].derivative() * (1 / self.reach)


@dataclass(frozen=True)
class StretchCurve:
    """y = sum p(t) w^e, as a function of ln w; ``grown``: that of the antiderivative of dy/w."""

    scale: Scale
    parts: tuple[Part, ...]
    grown: tuple[Part, ...]

    @classmethod
    def of(cls, scale: Scale, parts: list[Part]) -> "StretchCurve":
        """With the antiderivative made of the parts' slopes."""
        return cls(scale, tuple(parts), tuple((_integral(scale.slope(p), p[1] - 1, scale), p[1] - 1) for p in parts))

    def place(self, log_w: arb) -> tuple[arb, arb]:
        """y and dy/d ln w."""
        slopes = tuple((self.scale.slope(part), part[1]) for part in self.parts)
        return self._sum(self.parts, log_w), self._sum(slopes, log_w)

    def clock(self, log_w: arb) -> tuple[arb, arb]:
        """The antiderivative of dy/w, and its derivative by ln w."""
        return self._sum(self.grown, log_w), self.place(log_w)[1] / log_w.exp()

    def _sum(self, parts: tuple[Part, ...], log_w: arb) -> arb:
        t = self.scale.t(log_w)
        return sum((polynomial(t) * (e * log_w).exp() for polynomial, e in parts), arb(0))


@dataclass(frozen=True)
class FencedStretch(FencedStrip):
    """A strip for ``least`` < ln w < ``most``; ``length``: how long the motion is followed in it."""

    least: arb
    length: arb

    def holds(self, log_w: arb) -> bool:
        """Whether the barriers are checked there."""
        return bool(log_w < self.most) and bool(log_w > self.least)


@dataclass(frozen=True)
class Grouped:
    """The laws over a stretch up to ln w = ``most``, over epsilon w^alpha of the first group: ``parts`` by their keys,
    ``powers`` the exponents of w of a step of each, and ``lost``, what was cut off the sums over k at most."""

    scale: Scale
    most: arb
    epsilon: arb
    alpha: arb
    powers: tuple[arb, ...]
    parts: dict[Key, arb_poly]
    lost: arb

    @property
    def length(self) -> int:
        """How many powers of t are kept."""
        return int(max(part.length() for part in self.parts.values()))

    def exponent(self, key: Key) -> arb:
        """Of w, for a product."""
        return sum(map(mul, self.powers, key), arb(0))

    def size(self, polynomial: arb_poly, key: Key) -> arb:
        """A bound of |p(t)| w^e on the stretch."""
        return upper(_plain(polynomial) * (self.exponent(key) * self.most).exp())

    def value(self, parts: dict[Key, arb_poly], log_w: arb) -> arb:
        """sum p(t) w^e."""
        t = self.scale.t(log_w)
        return sum((p(t) * (self.exponent(key) * log_w).exp() for key, p in parts.items()), arb(0))

    def slope(self, polynomial: arb_poly, key: Key) -> arb_poly:
        """The part of A, for a part of R or -B."""
        return self.scale.slope((polynomial, self.alpha + self.exponent(key)))


def groups(damping: Damping) -> list[list[int]]:
    """The laws by their exponents from the least on, those near to the first of a group in one."""
    found: list[list[int]] = []
    for i in sorted(range(len(damping.alphas)), key=damping.alphas.__getitem__):
        if found and _apart(damping.alphas[i], damping.alphas[found[-1][0]]) < _NEAR:
            found[-1].append(i)
        else:
            found.append([i])
    return found


def _apart(a: ExactReal, b: ExactReal) -> arb:
    """a - b, with all bits however near they are and whatever their roots."""
    if a == b:
        return arb(0)
    wanted = ctx.prec

    def attempt(_bits: int) -> arb | None:
        found = a.ball() - b.ball()
        return found if found.rel_accuracy_bits() > wanted else None

    return at_growing_precision(attempt, int(wanted * _DIGITS), 2 * wanted)


def stretch(damping: Damping, y: arb, w: arb, error: arb) -> FencedStretch | None:
    """The strip that holds all states within ``error`` of the exact (y, w) for a while, or None where none is narrow
    enough; for a law with exponents near to its least one only."""
    if not damping.sublinear or not (w > 2 * error and y > 2 * error):
        return None
    together = groups(damping)
    if all(len(group) == 1 for group in together):
        return None
    laws = grouped(damping, together, (INSIDE * (w + error)).upper().log().upper())
    size = damping.resistance(w)
    goal = upper((error * (1 + laws.alpha * size / w) + abs(y) * arb(2) ** -ctx.prec) / size)
    log_w = w.log()
    found = _short_enough(laws, goal, (log_w, (size - y) / (laws.epsilon * (laws.alpha * log_w).exp())))
    return None if found is None else _between(laws, found, (damping, y, w, error), goal)


def grouped(damping: Damping, together: list[list[int]], most: arb) -> Grouped:
    """The laws on the stretch up to ln w = most, at the current precision."""
    first = damping.alphas[together[0][0]]
    bases = [damping.alphas[group[0]] for group in together]
    beside = [[_apart(damping.alphas[i], base) for i in group] for group, base in zip(together, bases)]
    # The reach is a choice, so a double may name it; the cut below is bounded with the exact eta.
    widest = max(float(eta.mid()) for group in beside for eta in group)
    reach = arb(min(_FARTHEST, _SHARE / max(widest, _SHARE / _FARTHEST)))
    # Rounded up, so that t <= 1 up to ln w = most whatever the precision: all sums are bounded on |t| <= 1.
    scale, degree = Scale((most - reach).upper(), reach), _degree(max(widest, 2.0**-900) * float(reach))
    sums = [
        [(damping.strengths[i] * (eta * scale.centre).exp(), eta * reach) for i, eta in zip(group, etas)]
        for group, etas in zip(together, beside)
    ]
    epsilon = sum((e for e, _ in sums[0]), arb(0))
    alpha = first.ball()
    powers = (2 - 2 * alpha, *(_apart(base, first) for base in bases[1:]))
    keys = [(0,) * len(powers), *(unit(i, len(powers)) for i in range(1, len(powers)))]
    laws = Grouped(scale, most, epsilon, alpha, powers, {}, arb(0))
    parts = {key: _exponentials([(e / epsilon, eta) for e, eta in group], degree) for key, group in zip(keys, sums)}
    # Lagrange's remainder of e^x after the power ``degree``, x = eta t <= eta, for each law: e^eta
    # eta^(degree+1)/(degree+1)!, with eta already times the reach.
    lost = sum(
        (
            e / epsilon * laws.size(arb_poly([1]), key) * eta.exp() * eta ** (degree + 1) / arb(degree + 2).gamma()
            for key, group in zip(keys, sums)
            for e, eta in group
        ),
        arb(0),
    )
    return Grouped(scale, most, epsilon, alpha, powers, parts, upper(lost))


def _degree(size: float) -> int:
    """How many k are kept, for the precision: a choice."""
    return next(k for k in range(1, ctx.prec) if -k * log2(size) + lgamma(k + 1) / _LN2 > ctx.prec + 8)


def _exponentials(terms: list[tuple[arb, arb]], degree: int) -> arb_poly:
    """sum c e^(eta t) through t^degree."""
    coefficients = [arb(0)] * (degree + 1)
    for c, eta in terms:
        for k in range(degree + 1):
            coefficients[k] += c
            c = c * eta / (k + 1)
    return arb_poly(coefficients)


def _short_enough(laws: Grouped, goal: arb, state: tuple[arb, arb]) -> tuple[dict[Key, arb_poly], arb] | None:
    """The shortest B with a residual below the goal on the stretch, and the residual; None where terms grow before.

    ``state``: ln w, and what B is there if the state is on the curve; none is sought where it certainly is not (a
    choice: that B is off by more than the last terms leave open).
    """
    if too_early(laws.epsilon, laws.alpha, laws.most):
        return None
    before, least, b = arb(1), 0, dict[Key, arb_poly]()
    # The last order's terms are a cheap sign of how the series falls; the residual is formed only when they are small.
    for order in ORDERS:
        keys = lower_set(tuple(abs(float(d.mid())) for d in laws.powers), order)
        if keys is None:
            return None
        extend(laws, b, keys)
        last = upper(sum((laws.size(b[key], key) for key in keys if key[0] == order), arb(0)))
        if not last <= before or abs(laws.value(b, state[0]) - state[1]) > _OPEN * before + WIDEST * goal:
            return None
        # A quarter of the drift alpha h for h = goal; ``_between`` makes h five times what is left.
        if last < goal / 8 and (left := residual(laws, b)) < goal * laws.alpha / 4:
            return b, left
        if _too_slow(size_of(last), (size_of(before) - size_of(last)) / (order - least), order, size_of(goal)):
            return None
        before, least = last, order
    return None


def _too_slow(last: float, fall: float, order: int, goal: float) -> bool:
    """Whether terms that fall on as they do, by ``fall`` bits an order, are above the goal to the end: a choice."""
    return order > 2 and last - fall * (ORDERS[-1] - order) > goal


def extend(laws: Grouped, b: dict[Key, arb_poly], keys: list[Key]) -> None:
    """B = A^(-1) w^(2-2 alpha)/epsilon^2 power by power, through the keys, which are a lower set, small ones first."""
    none, length = (0,) * len(laws.powers), laws.length
    inverse = _inverse(laws.slope(laws.parts[none], none), length)
    others = {key: laws.slope(part, key) for key, part in laws.parts.items() if key != none}
    slopes = {key: laws.slope(p, key) for key, p in b.items()}
    for key in keys:
        if key in b:
            continue
        total = arb_poly([1 / laws.epsilon**2]) if key == unit(0, len(key)) else arb_poly([])
        for before, c in others.items():
            if (beside := b.get(tuple(map(sub, key, before)))) is not None:
                total -= c * beside
        for before, c in slopes.items():
            if (beside := b.get(tuple(map(sub, key, before)))) is not None:
                total += c * beside
        b[key] = (total.truncate(length) * inverse).truncate(length)
        slopes[key] = laws.slope(b[key], key)


def residual(laws: Grouped, b: dict[Key, arb_poly]) -> arb:
    """A bound of what A B - w^(2-2 alpha)/epsilon^2 keeps on the stretch: by the choice of B no power of t below
    ``length`` beside a key of B."""
    A = {key: laws.slope(part, key) for key, part in laws.parts.items()}
    A.update({key: -laws.slope(p, key) for key, p in b.items()})
    left: dict[Key, arb_poly] = {}
    for (i, c), (j, d) in product(A.items(), b.items()):
        key = tuple(map(add, i, j))
        whole = c * d
        # The powers below ``length`` beside a key of B cancel, as B was solved for; the balls of the higher ones, and
        # of all other keys, are the residual.
        kept = whole.right_shift(laws.length).left_shift(laws.length) if key in b else whole
        left[key] = left[key] + kept if key in left else kept
    return sum((laws.size(p, key) for key, p in left.items()), arb(0))


def _between(
    laws: Grouped, found: tuple[dict[Key, arb_poly], arb], state: tuple[Damping, arb, arb, arb], goal: arb
) -> FencedStretch | None:
    """The strip, where the motion crosses its edges one way only, and it is worth it."""
    (b, residual), (damping, y, w, error) = found, state
    scale, a, speed = laws.scale, laws.alpha, w + arb(0, error)
    log_w, none = speed.log(), (0,) * len(laws.powers)
    size = laws.epsilon * (a * log_w).exp()
    theta = upper((damping.resistance(speed) - y - arb(0, error)) / size - laws.value(b, log_w)) + laws.lost
    # A constant theta = +-h: the drift alpha h of A B must exceed what is left of it, with room for the products with h
    # that ``one_way`` counts.
    h = upper(theta + 5 * (residual + 2 * laws.lost) / a)
    if not h < WIDEST * goal or not one_way(laws, b, residual, h):
        return None
    curves = []
    for sign in (-1, 1):
        # y = epsilon w^alpha (1 + R - B - theta) as parts p(t) w^e; theta joins the constant key.
        parts = [(p * laws.epsilon, a + laws.exponent(key)) for key, p in laws.parts.items() if key != none]
        parts += [(-laws.epsilon * p, a + laws.exponent(key)) for key, p in b.items()]
        parts.append(((laws.parts[none] - sign * h) * laws.epsilon, a))
        curves.append(StretchCurve.of(scale, parts))
    above, below = curves
    least = (scale.centre - scale.reach + _MARGIN).upper()
    try:
        starts = solve(above.place, y + error, w.log()), solve(below.place, y - error, w.log())
    except UndecidedError:  # too few bits here: a later state may do
        return None
    last = (least + _MARGIN).mid()
    times = [(curve.clock(at)[0] - curve.clock(last)[0]).lower() for curve, at in zip((above, below), starts)]
    length = times[0].min(times[1]).mid()
    if not all(last < at < laws.most for at in starts) or not length > 0:
        return None
    return FencedStretch(above, below, starts, laws.most, upper(4 * h / a), arb(0), least, length)


def one_way(laws: Grouped, b: dict[Key, arb_poly], residual: arb, h: arb) -> bool:
    """Whether on all the stretch the motion crosses the curves of theta = +-h one way, and A > alpha/2 on them."""
    a, none = laws.alpha, (0,) * len(laws.powers)
    own = sum((laws.size(laws.slope(p, key), key) for key, p in b.items()), a * h)
    plain = sum((laws.size(p, key) for key, p in b.items()), h)
    # A >= alpha - falls - own: what the first group and the others may take from alpha.
    falls = laws.size(
        laws.slope(laws.parts[none], none) - a, none
    )  # the slopes of R may be below 0 only by their tails
    others = arb(0)
    for key, part in laws.parts.items():
        if key != none:
            slope = laws.slope(part, key)
            others += laws.size(slope, key)
            # A law's slope is below 0 by no more than the rest exceeds its constant, which is above 0.
            falls += (laws.size(slope - slope[0], key) - abs(laws.size(arb_poly([slope[0]]), key))).nonnegative_part()
    most = a + falls + others + own
    # What disturbs the drift alpha h of theta: the residual, A times what N lacks, and h times B.
    crossing = residual + most * laws.lost + a * h * (plain + laws.lost)
    return bool(crossing < a / 2 * h) and bool(falls + own < a / 2)


def _integral(polynomial: arb_poly, d: arb, scale: Scale) -> arb_poly:
    """q with (q(t) w^d)' = p(t) w^d by ln w, exactly for one value in the ball of q_0 at each t; d may be 0.

    With r the reach, p_k = (k+1) q_(k+1)/r + d q_k: downwards from the highest power where |d| r is no small number.
    Where it is, upwards from q_0 = 0, as far as some n; then (q w^d)' is too large by d q_n t^n w^d, whose integral
    from 0 to t, over w^d, is at most e^(|d| r) |d q_n| r/(n+1), as w^d changes by e^(|d| r) at most in between.
    """
    p = polynomial.coeffs()
    # Dividing by a small d loses bits; upwards each power is worth three bits at |d| r = 1/8, and fewer above.
    if abs(d) * scale.reach > 1 / arb(8):
        above, downwards = arb(0), list[arb]()
        for k in reversed(range(len(p))):
            above = (p[k] - (k + 1) * above / scale.reach) / d
            downwards.append(above)
        return arb_poly(downwards[::-1])
    q, n = [arb(0)], len(p) + _more(abs(d) * scale.reach, len(p))
    for k in range(n):
        q.append(((p[k] if k < len(p) else arb(0)) - d * q[k]) * scale.reach / (k + 1))
    # The remainder of the docstring, as a radius of the constant coefficient.
    q[0] = arb(0, upper((abs(d) * scale.reach).exp() * d * q[n] * scale.reach / (n + 1)))
    return arb_poly(q)


def _more(size: arb, length: int) -> int:
    """How many powers of t more make (|d| r)^k length!/(length+k)! less than the precision: a choice."""
    small, fine, k = size, arb(2) ** (-ctx.prec - 8), 1
    while not small < fine and k < ctx.prec:
        small, k = small * size / (length + k), k + 1
    return k


def _plain(polynomial: arb_poly) -> arb:
    """The absolute values of the coefficients together."""
    return sum((abs(c) for c in polynomial.coeffs()), arb(0))


def _inverse(polynomial: arb_poly, length: int) -> arb_poly:
    """1/p to so many coefficients."""
    p, found = polynomial.coeffs() + [arb(0)] * length, [1 / polynomial[0]]
    for k in range(1, length):
        found.append(-sum((found[j] * p[k - j] for j in range(k)), arb(0)) / p[0])
    return arb_poly(found)
