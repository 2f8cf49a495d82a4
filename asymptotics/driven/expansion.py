"""A piece of a trial orbit: a finite series in the elapsed angle s, beside a turning point or from a state in motion.

y and w >= 0 are +-x and its slope, towards one side.  ``back``: s counts against the time, and the losses feed.

    mu w' = g(s) - k y -+ sum_i c_i w^alpha_i,    y' = w,    g = +-f cos(theta -+ s)

At a turning point w = s u, and u is a series in the monomials s^e, e = n + sum_i j_i alpha_i; in motion w itself is a
power series.  All coefficients up to ``top`` cancel in the equation, and what is left of it, the *defect*, bounds how
far the piece is from an exact motion.  With w = w_0 s^lead (1 + g(s)) and G(s) the sum of |g_e| s^e, G(R) < 1, the
coefficients of (1 + g)^alpha are bounded by those of (1 - G)^(-alpha), so that those beyond the exponent e_0 sum to

    (s/R)^e_0 (1 - G(R))^(-alpha)    at most (s <= R).

Derivation ``driven-unique``.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import reduce
from math import inf, log2
from typing import Any

from flint import acb, arb

from asymptotics.driven.drive import Balls
from asymptotics.errors import LimitError, UndecidedError
from asymptotics.flow.balls import dyadic, size_of, upper
from asymptotics.numbers.context import ctx, lru_cache
from asymptotics.numbers.exact import ExactReal

_SHARES = [0.8 * 0.9**i for i in range(16)]  # of the radius on which the series hardly moves: choices
MAX_MONOMIALS = 1500


@dataclass(frozen=True, eq=False)
class Lattice:
    """The monomials s^e up to s^top: exponents, products of two, where e - alpha and e - 2 stand (None: nowhere)."""

    top: int
    exponents: tuple[arb, ...]
    whole: tuple[int | None, ...]
    products: tuple[tuple[tuple[int, int], ...], ...]
    less_two: tuple[int | None, ...]
    less: tuple[tuple[int | None, ...], ...]


Key = tuple[Fraction, ...]


@lru_cache(maxsize=32)
def grid(alphas: tuple[ExactReal, ...], top: int, bits: int) -> Lattice:
    """For these exponents beside a turning point; without exponents, in motion: the powers of s."""
    irrational = [a for a in alphas if not a.is_rational]
    size = 1 + len(irrational)
    one = (Fraction(1), *[Fraction(0)] * (size - 1))
    steps: list[Key] = []
    for a in alphas:
        key = [Fraction(0)] * size
        key[0 if a.is_rational else 1 + irrational.index(a)] = a.rational if a.is_rational else Fraction(1)
        steps.append(tuple(key))
    weights = [1.0, *(float(a.ball().mid()) for a in irrational)]
    found, front = {(Fraction(0),) * size}, [(Fraction(0),) * size]
    while front:
        grown = {_sum(key, g) for key in front for g in (one, *steps) if any(g)}
        front = [k for k in grown if k not in found and sum(float(n) * w for n, w in zip(k, weights)) <= top]
        found.update(front)
        if len(found) > MAX_MONOMIALS:
            raise LimitError("alpha", "too many powers beside a turning point", "fewer or larger exponents")
    keys = sorted(found, key=lambda k: sum(float(n) * w for n, w in zip(k, weights)))
    place = {key: i for i, key in enumerate(keys)}

    def minus(key: Key, other: Key) -> int | None:
        return place.get(tuple(a - b for a, b in zip(key, other)))

    products = tuple(
        tuple((i, j) for i, other in enumerate(keys[: n + 1]) if (j := minus(key, other)) is not None)
        for n, key in enumerate(keys)
    )
    with ctx.workprec(bits):
        exponents = tuple(
            arb(k[0].numerator) / k[0].denominator + sum((int(n) * a.ball() for n, a in zip(k[1:], irrational)), arb(0))
            for k in keys
        )
    whole = tuple(int(k[0]) if not any(k[1:]) and k[0].denominator == 1 else None for k in keys)
    two = tuple(2 * n for n in one)
    return Lattice(
        top, exponents, whole, products, tuple(minus(k, two) for k in keys),
        tuple(tuple(minus(k, g) for k in keys) for g in steps),
    )  # fmt: skip


def _sum(a: Key, b: Key) -> Key:
    return tuple(x + y for x, y in zip(a, b))


@dataclass(frozen=True)
class Arc:
    """y = y_0 + int w and w = s^lead sum w_e s^e for 0 <= s <= length; the truth parts from it by ``defect`` at most.

    ``begin``: the angle at s = 0; ``side``: +1 where s counts with the time, -1 against it; ``sign``: x = sign y.
    ``growth``: G(length), so that w lies between w_0 s^lead (1 -+ growth).
    """

    begin: arb
    side: int
    sign: int
    lead: int
    y0: arb
    ws: tuple[arb, ...]
    exponents: tuple[arb, ...]
    length: arb
    defect: arb
    growth: arb

    def state(self, s: arb) -> tuple[arb, arb]:
        """(y, w) after s."""
        if s == 0:
            return self.y0, arb(0) if self.lead else self.ws[0]
        w = y = arb(0)
        for c, e in zip(self.ws, self.exponents):
            power = c * s**e if self.lead or e != 0 else c
            w, y = w + power, y + power / (e + self.lead + 1)
        return (self.y0 + y * s ** (self.lead + 1), w * s if self.lead else w)

    def harmonic(self, n: int) -> acb:
        """int x e^(-i n theta) d theta over the piece, by the Taylor series of the wave."""
        h, turn = self.length, -self.side * n
        terms = [(self.y0, arb(0))] + [
            (c / (e + self.lead + 1), e + self.lead + 1) for c, e in zip(self.ws, self.exponents)
        ]
        size = sum((abs(c) * h**e if e != 0 else abs(c) for c, e in terms), arb(0))
        parts = [(c * h ** (e + 1), e + 1) for c, e in terms]
        total, wave, j = acb(0), acb(1), 0
        while True:
            total += wave * sum((part / (e + j) for part, e in parts), arb(0))
            j += 1
            wave *= acb(0, turn) * h / j
            # What is left of e^(i n s) is at most (n s)^j/j!, and of its integral (n h)^j/j! h/(j + 1).
            if abs(wave) < arb(2) ** (-ctx.prec) or j > 4 * ctx.prec:
                break
        rest = upper(size * abs(wave) * h / (j + 1))
        start = (acb(0, -n) * self.begin).exp()
        return self.sign * start * (total + acb(arb(0, rest), arb(0, rest)))


def _wave(f: arb, theta: arb, side: int, top: int) -> list[arb]:
    """The coefficients of f cos(theta + side s)."""
    values = [f * theta.cos(), -f * side * theta.sin()]
    for n in range(2, top + 1):
        values.append(-values[n - 2] / (n * (n - 1)))
    return values


def piece(balls: Balls, g: Lattice, theta: arb, side: int, sign: int, y0: arb, w0: arb | None, tolerance: float) -> Arc:
    """The piece from the state (y0, w0), or from rest at y0 (w0 None); ``tolerance``: log2 of the defect aimed at."""
    lead, force = int(w0 is None), [sign * c for c in _wave(balls.f, theta, side, g.top)]
    force[0] -= side * sum((c for c, a in balls.losses if a == 0), arb(0))  # dry friction has one direction in a piece
    losses = [(side * c, a) for c, a in balls.losses if a != 0]
    first = (force[0] - balls.k * y0) / balls.mu if w0 is None else w0
    if not first > 0:
        raise UndecidedError("a piece of the trial orbit does not move on")
    ws, ys, inverse = [first], [y0], 1 / first
    powers = [[first**a] for _, a in losses]
    weights = [_euler(a.mid().man_exp(), a.rad().man_exp(), g, ctx.prec) for _, a in losses]
    for n in range(1, len(g.exponents)):
        # At rest the equation at s^e gives (1 + e) u_e, in motion that at s^(n-1) gives n w_n.
        if lead:
            ys.append(_or_none(ws, g.less_two[n]) / g.exponents[n])
            slope = _or_none(force, g.whole[n]) - balls.k * ys[n]
            slope -= sum((c * _or_none(p, row[n]) for (c, _), p, row in zip(losses, powers, g.less)), arb(0))
        else:
            slope = force[n - 1] - balls.k * ys[n - 1] - sum((c * p[-1] for (c, _), p in zip(losses, powers)), arb(0))
            ys.append(ws[-1] / n)
        ws.append(slope / ((lead + g.exponents[n]) * balls.mu))
        for weight, p in zip(weights, powers):
            p.append(_next_power(weight[n], inverse, n, ws, p, g))
    return _cut(balls, g, theta, side, sign, lead, y0, ws, losses, tolerance)


def _or_none(series: list[arb], n: int | None) -> arb:
    """A coefficient; 0 where there is none."""
    return arb(0) if n is None else series[n]


def _next_power(weights: Sequence[arb], inverse: arb, n: int, ws: list[arb], p: list[arb], g: Lattice) -> arb:
    """The coefficient of s^e in w^alpha: from w E(P) = alpha E(w) P with Euler's E s^e = e s^e."""
    terms = [weight * ws[i] * p[j] for weight, (i, j) in zip(weights, g.products[n][1:])]
    return sum(terms, arb(0)) * inverse / g.exponents[n]


Exact = tuple[Any, Any]


@lru_cache(maxsize=64)
def _euler(middle: Exact, radius: Exact, g: Lattice, bits: int) -> tuple[tuple[arb, ...], ...]:
    """alpha e_i - e_j, by which ``_next_power`` weighs the products of two, i > 0: the same for all pieces."""
    with ctx.workprec(bits):
        alpha = arb(arb(middle), arb(radius))
        return tuple(tuple(alpha * g.exponents[i] - g.exponents[j] for i, j in pairs[1:]) for pairs in g.products)


def _cut(
    balls: Balls, g: Lattice, theta: arb, side: int, sign: int, lead: int, y0: arb, ws: list[arb],
    losses: list[tuple[arb, arb]], tolerance: float,
) -> Arc:  # fmt: skip
    """The length for which the defect is near 2^tolerance, and the defect."""
    parts = [(upper(c / ws[0]), e) for c, e in zip(ws[1:], g.exponents[1:])]
    # A radius on which no term exceeds 1, in doubles; the largest share of it with G(R) < 1/2, by doubles first.
    logs = [(size_of(c), float(e.mid())) for c, e in parts if c != 0]
    widest = min([2.0, *(-size / e for size, e in logs)])
    shares = (widest + log2(s) for s in _SHARES)
    inner = (s for s in shares if sum(2.0 ** (size + e * s) for size, e in logs) < 0.5)
    R = next((r for s in inner if _sum_of(parts, r := dyadic(s)) < 0.5), None)
    if R is None:
        raise UndecidedError("the coefficients of a piece of the trial orbit are too wide")
    inside = _sum_of(parts, R)
    last = (1 if lead else 0) + g.top
    sizes = [(size_of(c) + float(a.mid()) * size_of(ws[0]) + 1.0, float(a.mid()) * lead) for c, a in losses]
    rate = max([s for s, _ in sizes] + [size_of(balls.k * ws[0]), -inf])
    length = _short(min(size_of(R) - 0.3, size_of(R) + (tolerance - rate) / (last - 1)))
    defect = _defect(balls, g, lead, y0, ws, losses, length, R, inside)
    return Arc(
        theta, side, sign, lead, y0, tuple(ws), g.exponents, length, upper(length * defect), _sum_of(parts, length)
    )


def _short(size: float) -> arb:
    """A number a little below 2^size with twelve bits, so that sums of many are exact."""
    whole = int(size // 1)
    return arb((int(2.0 ** (size - whole) * 2048), whole - 11), 0)


def _sum_of(parts: list[tuple[arb, arb]], s: arb) -> arb:
    return upper(reduce(lambda total, part: total + part[0] * s ** part[1], parts, arb(0)))


def _defect(
    balls: Balls,
    g: Lattice,
    lead: int,
    y0: arb,
    ws: list[arb],
    losses: list[tuple[arb, arb]],
    h: arb,
    R: arb,
    inside: arb,
) -> arb:
    """A bound of |mu w' - g + k y +- sum c w^alpha| for 0 <= s <= h: what does not cancel."""
    # In motion the equation was met up to s^(top-1), beside a turning point up to s^top.
    met = g.top if lead else g.top - 1
    rest = arb(0)
    for c, e in zip(ws, g.exponents):
        power = e + lead + 1  # of y
        if not power <= met:
            rest += balls.k * abs(c) / power * h**power
    factor = arb(1)
    for n in range(1, met + 2):
        factor *= h / n
    rest += balls.f * factor
    for c, a in losses:
        # Coefficients of w^alpha whose exponent, with that of s^(lead alpha), is above ``met``; at least met - lead
        # alpha.
        beyond = met - a if lead else arb(met)
        share = (h / R) ** beyond if beyond > 0 else arb(1)
        rest += abs(c) * (ws[0] * (h if lead else arb(1))) ** a * share * (1 - inside) ** (-a)
    return upper(rest)
