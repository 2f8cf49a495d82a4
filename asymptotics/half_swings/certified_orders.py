"""The orders of the quarter swing, computed twice by one recursion: in truncated power series, and in bounds.

**Variables.**  On the quarter swing from the turning point (θ = 0) to the equilibrium passage (θ = π/2) put
θ = (π/2) u, t = u², and R = ln r, P_i = e^{(α_i−1) R}, S = Σ δ_i P_i s^{α_i}, Y = S/(1 − c S).  The equations become

    Y = S (1 + c Y),   θ dR/dθ = −θ s Y,   θ dP_i/dθ = (1−α_i) θ s Y P_i,   θ dτ/dθ = θ (1 + c Y),

sums and products only.  With σ = sin θ/θ and g = θ sin θ, power series in t without negative powers, one finds order by
order in the multi-index n (δⁿ = Π δ_i^{n_i}, n·α = Σ n_i α_i)

    Y = Σ δⁿ θ^{n·α} y_n(t),   S = Σ δⁿ θ^{n·α} s_n(t),   P_i = Σ δⁿ θ^{n·α} p_{i,n}(t),   p_{i,0} = 1,
    s_n = Σ_i σ^{α_i} p_{i, n−e_i},   y_n = s_n + c Σ_m s_m y_{n−m},   p_{i,n} = (1−α_i) I_n[ g Σ_m p_{i,m} y_{n−m} ],

where I_n divides the coefficient of t^j by n·α + 2j.  Here g = O(t), so j ≥ 1 and nothing is ever divided by zero, not
even at α = 0.  All these functions are analytic in |t| < 4, because σ(t) = Π_k (1 − t/(4k²)) has no zero there; they
are needed at t = 1.

**The first K coefficients** of a product, and of I_n, depend on the first K coefficients of the factors only: they are
computed in balls without any truncation error.  What is missing at t = 1 is the sum of the coefficients from K on.

**Bounds.**  Let |f| be the supremum of |f(t)| over |t| < ϱ, 1 < ϱ ≤ 4, and θ_ϱ = (π/2) √ϱ.  It is submultiplicative and

1. |σ^α| ≤ (sinh θ_ϱ/θ_ϱ)^α for α ≥ 0: |1 − t/(4k²)| ≤ 1 + ϱ/(4k²) in the product, and |z^α| = |z|^α for real α;
2. |c| ≤ cosh θ_ϱ and |g| ≤ θ_ϱ sinh θ_ϱ: replace each Taylor coefficient by its absolute value;
3. |I_n f| ≤ |f|/(n·α + 2) if f(0) = 0: I_n f(t) = ½ ∫_0^1 v^{n·α/2 − 1} f(vt) dv and |f(vt)| ≤ v |f| (Schwarz);
4. the coefficients satisfy |f_j| ≤ |f| ϱ^{−j} (Cauchy), so Σ_{j≥K} |f_j| ≤ |f| ϱ^{−K}/(1 − 1/ϱ).

Hence the same recursion, with the numbers 1–3 in the place of the functions and |1−α_i| in that of 1−α_i, yields upper
bounds of |y_n| and |p_{i,n}| by induction, and 4 turns them into a bound of every tail.  `order_series` is that
recursion; `power_series_ring` and `bound_ring` are its two arithmetics.

>>> one_law = [arb(2)]
>>> small = order_series(power_series_ring(one_law, 30), one_law, indices(1, 2))
>>> sum(small[(1,)].coeffs(), arb(0)).str(8)        # y_1 = σ^2, at θ = π/2: (2/π)^2 up to the tail
'[0.40528473 +/- ...]'
>>> (order_series(bound_ring(one_law, 4), one_law, indices(1, 2))[(1,)]).str(5)     # (sinh(π)/π)^2
'[13.514 +/- ...]'
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from typing import Any

from flint import arb, arb_poly

from asymptotics.series import Key, monomials


@dataclass(frozen=True)
class Ring:
    """What `order_series` needs: the functions c, g, σ^{α_i}, the numbers ±(1−α_i), truncation, and I_n."""

    cosine: Any
    turn: Any
    powers: tuple[Any, ...]
    slopes: tuple[arb, ...]
    cut: Callable[[Any], Any]
    integrate: Callable[[Any, arb], Any]


def indices(laws: int, order: int) -> list[Key]:
    """All multi-indices of total degree <= order, by degree; the first is zero.

    >>> indices(2, 1)
    [(0, 0), (0, 1), (1, 0)]
    """
    return [n for degree in range(order + 1) for n in monomials(laws, degree)]


def minus(n: Key, m: Key) -> Key:
    """The difference of two multi-indices."""
    return tuple(a - b for a, b in zip(n, m, strict=True))


def dot(n: Key, alphas: Sequence[arb]) -> arb:
    """The exponent n·α."""
    return sum((k * a for k, a in zip(n, alphas, strict=True)), arb(0))


def convolve(f: Mapping[Key, Any], g: Mapping[Key, Any], n: Key) -> Any:
    """Σ_m f_m g_{n−m} over the orders that both have so far; the integer 0 if there is none."""
    total: Any = 0
    for m in product(*(range(k + 1) for k in n)):
        if m in f and (rest := minus(n, m)) in g:
            total = f[m] * g[rest] + total
    return total


def order_series(ring: Ring, alphas: Sequence[arb], orders: Sequence[Key]) -> dict[Key, Any]:
    """All y_n, n ≠ 0, of the module docstring in the arithmetic of ``ring``; ``orders`` as from `indices`."""
    zero, laws = orders[0], range(len(alphas))
    unit = [tuple(int(i == k) for k in laws) for i in laws]
    s: dict[Key, Any] = {}
    y: dict[Key, Any] = {}
    p: list[dict[Key, Any]] = [{zero: arb(1)} for _ in laws]
    for n in orders[1:]:
        terms = [ring.powers[i] * p[i][minus(n, unit[i])] for i in laws if n[i] and minus(n, unit[i]) in p[i]]
        s[n] = ring.cut(sum(terms, start=0 * ring.cosine))
        y[n] = s[n] + ring.cut(ring.cosine * ring.cut(convolve(s, y, n)))
        for i in laws:
            if ring.slopes[i] != 0 or not ring.slopes[i].is_exact():
                drive = ring.cut(ring.turn * ring.cut(convolve(p[i], y, n)))
                p[i][n] = ring.slopes[i] * ring.integrate(drive, dot(n, alphas))
    return y


def power_series_ring(alphas: Sequence[arb], terms: int) -> Ring:
    """Polynomials in t with the first ``terms`` coefficients of each function, as balls."""
    cosine, sine_ratio = elementary_series(terms)
    square = (arb.pi() / 2) ** 2

    def cut(f: Any) -> Any:
        return (f + arb_poly()).truncate(terms)

    turn = cut((square * sine_ratio).left_shift(1))
    powers = tuple(sine_ratio_power(a, terms) for a in alphas)
    return Ring(cosine, turn, powers, tuple(1 - a for a in alphas), cut, integrate_series)


def elementary_series(terms: int) -> tuple[arb_poly, arb_poly]:
    """cos θ and sin θ/θ as polynomials in t = (2θ/π)², ``terms`` coefficients each."""
    minus_square = -((arb.pi() / 2) ** 2)
    even, odd = [arb(1)], [arb(1)]
    for j in range(1, terms):
        even.append(even[-1] * minus_square / (2 * j * (2 * j - 1)))
        odd.append(odd[-1] * minus_square / (2 * j * (2 * j + 1)))
    return arb_poly(even), arb_poly(odd)


def sine_ratio_power(alpha: arb, terms: int) -> arb_poly:
    """(sin θ/θ)^α in t, from t d/dt ln σ = −Σ_j ζ(2j) (t/4)^j, which is the product of the module docstring."""
    slope = [arb(0)] + [-alpha * arb(2 * j).zeta() / arb(4) ** j for j in range(1, terms)]
    f = [arb(1)]
    for j in range(1, terms):
        f.append(sum((slope[i] * f[j - i] for i in range(1, j + 1)), arb(0)) / j)
    return arb_poly(f)


def integrate_series(f: arb_poly, exponent: arb) -> arb_poly:
    """I_n: the coefficient of t^j, j >= 1, divided by ``exponent`` + 2j; f(0) = 0 by construction."""
    return arb_poly([arb(0)] + [x / (exponent + 2 * j) for j, x in enumerate(f.coeffs()[1:], 1)])


def bound_ring(alphas: Sequence[arb], radius: arb | int) -> Ring:
    """Upper bounds of the functions on |t| < ``radius``, 1 < radius <= 4."""
    theta = arb.pi() / 2 * arb(radius).sqrt()
    return Ring(
        cosine=theta.cosh(),
        turn=theta * theta.sinh(),
        powers=tuple((theta.sinh() / theta) ** a for a in alphas),
        slopes=tuple(abs(1 - a) for a in alphas),
        cut=arb,
        integrate=lambda f, exponent: f / (exponent + 2),
    )
