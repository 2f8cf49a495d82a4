"""The motion next to a turning point, any exponents: the speed as the variable, so that the branch point is explicit.

On a half-swing write y for the displacement measured from the centre that dry friction shifts, and w >= 0 for the speed
(units: amplitude 1, tau), with the orientation in which the motion goes to smaller y:

    y' = -w,   w' = y - N(w),   N(w) = sum_i epsilon_i w^alpha_i over alpha_i > 0.

At w = 0 the motion is not analytic in tau, but with w as the independent variable

    dy/dw = -w/(y - N(w)),      d tau/dw = 1/(y - N(w)),

and the only singular functions are the w^alpha_i, which are given: y and tau/w are power series in w^2 and the
w^alpha_i.  With P = y - N and Q = 1/P (coefficients by exponent e) one pass in ascending e gives everything:

    P_e = -Q_(e-2)/e - [e = alpha_i] epsilon_i,   Q_e = -(1/P_0) sum_(0<f<=e) P_f Q_(e-f),   tau_(e+1) = Q_e/(e+1).

The same series serves both ends: P_0 = y_0 > 0 where a half-swing begins, P_0 = y_1 < 0 where it ends (then tau <= 0).
The nearest singularity is where P = 0, about lambda w with sum_g q_g lambda^g = 1/2, q_0 = (w/y)^2 for g = 2 and
q_i = epsilon_i w^alpha_i/|y| for g = alpha_i: terms fall like lambda^(-e).  Heuristic arithmetic: midpoints of balls.

>>> from fractions import Fraction
>>> from asymptotics.numbers.exact import ExactReal
>>> damping = Damping.of([(arb("0.1"), ExactReal(Fraction(3, 2)))])
>>> end = LocalExpansion.at(damping, arb(1), arb("0.2"))
>>> y, tau = end.evaluate(arb("0.2"))
>>> y.str(12, radius=False), tau.str(12, radius=False)
('0.979689522447', '0.202098883820')
"""

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache
from itertools import product
from math import ceil, exp, log
from operator import mul

from flint import arb, ctx

from asymptotics.errors import LimitError, UndecidedError
from asymptotics.numbers.exact import ExactReal

Key = tuple[int, ...]
MAX_TERMS = 4000
_SMALLEST_ALPHA = Fraction(1, 100)
_MAX_DENOMINATOR = 20
_SECANT_STEPS = 40


@dataclass(frozen=True)
class Damping:
    """Strengths epsilon_i >= 0 and exponents alpha_i > 0 of N(w); ``friction`` is that of the term alpha = 0."""

    friction: arb
    strengths: tuple[arb, ...]
    alphas: tuple[ExactReal, ...]

    @classmethod
    def of(cls, terms: list[tuple[arb, ExactReal]]) -> "Damping":
        """From (epsilon_i, alpha_i); only the midpoints of the strengths are used, and zeros are dropped."""
        for _, a in terms:
            if a > 0 and a < _SMALLEST_ALPHA:
                reason = "the local expansion near v = 0 needs too many terms for so small an exponent"
                raise LimitError("alpha", reason, f"0, or at least {_SMALLEST_ALPHA}")
        friction = sum((e.mid() for e, a in terms if not a > 0), arb(0))
        moving = [(e.mid(), a) for e, a in terms if a > 0 and e.mid() != 0]
        return cls(friction, tuple(e for e, _ in moving), tuple(a for _, a in moving))

    @cached_property
    def floats(self) -> tuple[tuple[float, float], ...]:
        """(ln epsilon_i, alpha_i) in doubles, for choosing sizes."""
        return tuple((_log(e), float(a.ball().mid())) for e, a in zip(self.strengths, self.alphas))

    @cached_property
    def lattice(self) -> "Lattice":
        """The exponents of the local expansion."""
        return Lattice.of(self.alphas)

    def resistance(self, w: arb) -> arb:
        """N(w) for w > 0."""
        ln_w = w.log()
        terms = (e * (a.ball() * ln_w).exp() for e, a in zip(self.strengths, self.alphas))
        return sum(terms, arb(0)).mid()

    def radius(self, y: arb, w: arb) -> float:
        """ln lambda of the module docstring: how far the singularity is from w, 0 or less if it is not farther."""
        ln_y, ln_w = _log(abs(y)), _log(w)
        sizes = [(2 * (ln_w - ln_y), 2.0)] + [(ln_e + a * ln_w - ln_y, a) for ln_e, a in self.floats]
        high = min((log(0.5) - q) / g for q, g in sizes)
        low = high - max(log(2 * len(sizes)) / g for _, g in sizes) - 1
        for _ in range(60):
            middle = (low + high) / 2
            if sum(exp(min(50.0, q + g * middle)) for q, g in sizes) < 0.5:
                low = middle
            else:
                high = middle
        return low


@dataclass(frozen=True)
class Lattice:
    """The additive semigroup of the exponents 2 and alpha_i: rational ones on one axis, the others on one each."""

    denominator: int
    generators: tuple[Key, ...]
    values: tuple[float, ...]
    reach: float

    @classmethod
    def of(cls, alphas: tuple[ExactReal, ...]) -> "Lattice":
        """Exponents with a small denominator share the first axis; merging equal ones saves work, nothing else."""
        small = [a for a in alphas if a.is_rational and a.rational.denominator <= _MAX_DENOMINATOR]
        q = 1
        for a in small:
            q = q * a.rational.denominator if q % a.rational.denominator else q
        own = [a for a in alphas if a not in small]
        axes = 1 + len(own)
        keys = [_axis(int(a.rational * q), 0, axes) if a in small else _axis(1, 1 + own.index(a), axes) for a in alphas]
        smallest = min([1.0] + [float(a.ball().mid()) for a in alphas])
        reach = log(3.0) / smallest * (1.0 if not own else 3.0)
        values = [1 / q] + [float(a.ball().mid()) for a in own]
        return cls(q, tuple(keys), tuple(values), reach)

    def value(self, key: Key) -> float:
        """The exponent in doubles, for sorting."""
        return sum(n * v for n, v in zip(key, self.values))

    def keys(self, top: float) -> tuple[Key, ...]:
        """All exponents up to ``top``, ascending; UndecidedError above ``MAX_TERMS`` of them."""
        return _ascending(self.values, top)


@lru_cache(maxsize=64)
def _ascending(values: tuple[float, ...], top: float) -> tuple[Key, ...]:
    ranges = [range(int(top / v) + 1) for v in values]
    size = 1
    for r in ranges:
        size *= len(r)
    if size > 50 * MAX_TERMS:
        raise UndecidedError(f"the local expansion at a turning point needs about {size} terms")
    found = [k for k in product(*ranges) if sum(n * v for n, v in zip(k, values)) <= top]
    if len(found) > MAX_TERMS:
        raise UndecidedError(f"the local expansion at a turning point needs {len(found)} terms")
    return tuple(sorted(found, key=lambda k: sum(n * v for n, v in zip(k, values))))


@dataclass(frozen=True)
class LocalExpansion:
    """y(w) and tau(w) at the turning point ``y0``: coefficients of w^e and of w^(e+1), with the exponents e."""

    y0: arb
    exponents: tuple[arb, ...]
    y_coefficients: tuple[arb, ...]
    tau_coefficients: tuple[arb, ...]

    @classmethod
    def at(cls, damping: Damping, y0: arb, w: arb) -> "LocalExpansion":
        """The expansion at y = ``y0`` != 0, long enough for speeds up to ``w`` at the current precision."""
        ln_radius = damping.radius(y0, w)
        if not ln_radius > 0:
            raise UndecidedError("the speed is outside the expansion at the turning point")
        top = ceil((ctx.prec + 4) * log(2) / ln_radius) + 2
        keys = damping.lattice.keys(float(top))
        Q, y = _quotient(damping, y0, keys)
        exponents = tuple(_exponent(damping, key) for key in keys)
        return cls(y0, exponents, tuple(y), tuple(q / (e + 1) for q, e in zip(Q, exponents)))

    @classmethod
    def through(cls, damping: Damping, y: arb, w: arb) -> "LocalExpansion":
        """The expansion whose orbit passes through (y, w): the turning point is found by the secant method."""
        step = w * w / (2 * y)
        a = (y + step).mid()
        best = cls.at(damping, a, w)
        miss_a = (best.evaluate(w)[0] - y).mid()
        b = (a - miss_a).mid()
        for _ in range(_SECANT_STEPS):
            best = cls.at(damping, b, w)
            miss_b = (best.evaluate(w)[0] - y).mid()
            if _negligible(miss_b, y) or b == a or miss_a == miss_b:
                return best
            a, b, miss_a = b, (b - miss_b * (b - a) / (miss_b - miss_a)).mid(), miss_b
        raise UndecidedError("the turning point was not found: raise the precision")

    def evaluate(self, w: arb) -> tuple[arb, arb]:
        """(y, tau) at the speed w >= 0, tau since (or, if negative, until) the turning point."""
        if w == 0:
            return self.y0, arb(0)
        ln_w = w.log()
        powers = [(e * ln_w).exp() for e in self.exponents]
        tau = w * sum(map(mul, self.tau_coefficients, powers), arb(0))
        return sum(map(mul, self.y_coefficients, powers), arb(0)).mid(), tau.mid()

    def at_time(self, damping: Damping, tau: arb, w_end: arb) -> tuple[arb, arb]:
        """(y, w) at the time tau from the turning point, |tau| <= |tau(w_end)|, by Newton's method in w."""
        if tau == 0:
            return self.y0, arb(0)
        low, high, w = arb(0), w_end, min(w_end.mid(), (tau * self.y0).mid())
        for _ in range(200):
            y, found = self.evaluate(w)
            miss = (found - tau).mid()
            if _negligible(miss, tau):
                return y, w
            early = bool(abs(found) < abs(tau))
            low, high = (w, high) if early else (low, w)
            step = (w - miss * (y - damping.resistance(w))).mid()
            following = step if bool(low <= step) and bool(step <= high) else ((low + high) / 2).mid()
            if following == w:
                return y, w
            w = following
        return y, w


def _quotient(damping: Damping, y0: arb, keys: tuple[Key, ...]) -> tuple[list[arb], list[arb]]:
    """The coefficients of Q and y, key by key."""
    if len(damping.lattice.values) == 1:
        return _quotient_on_a_line(damping, y0, len(keys))
    return _quotient_in_general(damping, y0, keys)


def _quotient_on_a_line(damping: Damping, y0: arb, count: int) -> tuple[list[arb], list[arb]]:
    q = damping.lattice.denominator
    force = {key[0]: e for key, e in zip(damping.lattice.generators, damping.strengths)}
    P, Q, y = [y0], [1 / y0], [y0]
    scale = -1 / y0
    for k in range(1, count):
        y.append((-Q[k - 2 * q] * q / k).mid() if k >= 2 * q else arb(0))
        P.append((y[k] - force.get(k, 0)).mid())
        Q.append((scale * sum(map(mul, P[1 : k + 1], reversed(Q)), arb(0))).mid())
    return Q, y


def _quotient_in_general(damping: Damping, y0: arb, keys: tuple[Key, ...]) -> tuple[list[arb], list[arb]]:
    two = (2 * damping.lattice.denominator,) + (0,) * (len(keys[0]) - 1)
    force = dict(zip(damping.lattice.generators, damping.strengths))
    P: dict[Key, arb] = {keys[0]: y0}
    Q: dict[Key, arb] = {keys[0]: 1 / y0}
    y: dict[Key, arb] = {keys[0]: y0}
    scale, live = -1 / y0, []
    for key in keys[1:]:
        before = Q.get(tuple(a - b for a, b in zip(key, two)))
        y[key] = arb(0) if before is None else (-before / _exponent(damping, key)).mid()
        P[key] = (y[key] - force.get(key, 0)).mid()
        if P[key] != 0:
            live.append((key, P[key]))
        total = arb(0)
        for f, c in live:
            other = Q.get(tuple(a - b for a, b in zip(key, f)))
            if other is not None:
                total += c * other
        Q[key] = (scale * total).mid()
    return [Q[k] for k in keys], [y[k] for k in keys]


def _exponent(damping: Damping, key: Key) -> arb:
    lattice = damping.lattice
    total = arb(key[0]) / lattice.denominator
    for i, n in enumerate(key[1:], start=1):
        if n:
            total += n * next(a for a, g in zip(damping.alphas, lattice.generators) if g[i]).ball()
    return total


def _axis(n: int, i: int, axes: int) -> Key:
    return tuple(n if j == i else 0 for j in range(axes))


def _negligible(miss: arb, scale: arb) -> bool:
    return bool(abs(miss) <= abs(scale) * arb(2) ** (4 - ctx.prec))


def _log(x: arb) -> float:
    """ln of the midpoint of a positive ball, also far outside the range of doubles."""
    mantissa, exponent = x.mid().man_exp()
    return log(int(mantissa)) + int(exponent) * log(2)
