"""The orders of the quarter swing, computed twice by one recursion: in truncated power series, and in bounds.

The second is Cauchy's method of majorants, with suprema on a disc in the place of the functions.

**Variables.**  On the quarter swing from the turning point (theta = 0) to the equilibrium passage (theta = pi/2) put
theta = (pi/2) u, t = u², and R = ln r, Y = S/(1 − c S), where S = sum_i delta^{k_i} P_i varrho_i s^{v_i} c^{m_i} runs
over the members of the forces (``forces``): key k_i, number ±varrho_i, powers of s and c, and P_i = e^{a_i R} with the
weight a_i of the key (for v|v|^{alpha−1}: s^alpha, a = alpha − 1; for a spring x|x|^{p−1}: −c^p, a = p − 1).  The
motion (``quarter``) becomes

    Y = S (1 + c Y),   theta dR/d theta = −theta s Y,   theta dP_i/d theta = −a_i theta s Y P_i,
    theta d tau/d theta = theta (1 + c Y),

sums and products only.  With sigma = sin theta/theta and g = theta sin theta, power series in t without negative
powers, one finds order by order in the multi-index n (deltaⁿ = prod delta_i^{n_i}, and n·alpha = sum n_i alpha_i counts
the powers of the *velocity*: 0 for a force of the position alone)

    Y = sum deltaⁿ theta^{n·alpha} y_n(t),   S = sum deltaⁿ theta^{n·alpha} s_n(t),
    P_i = sum deltaⁿ theta^{n·alpha} p_{i,n}(t),   p_{i,0} = 1,
    C_{i,n} = sum_m p_{i,m} y_{n−m},   y_n = sum_i varrho_i sigma^{v_i} c^{m_i} (p_{i,n−k_i} + c C_{i,n−k_i}),
    p_{i,n} = −a_i I_n[ g C_{i,n} ]      (sum_m s_m y_{n−m} = sum_i varrho_i sigma^{v_i} c^{m_i} C_{i,n−k_i}),

where I_n divides the coefficient of t^j by n·alpha + 2j.  Here g = O(t), so j ≥ 1 and nothing is ever divided by zero,
not even at n·alpha = 0.  All these functions are analytic in |t| < 4, because sigma(t) = prod_k (1 − t/(4k²)) has no
zero there; they are needed at t = 1.

**The first K coefficients** of a product, and of I_n, depend on the first K coefficients of the factors only: they are
computed in balls without any truncation error.  What is missing at t = 1 is the sum of the coefficients from K on.

**Bounds.**  Let |f| be the supremum of |f(t)| over |t| < varrho, 1 < varrho ≤ 4, and theta_varrho = (pi/2) √varrho.  It
is submultiplicative and

1. |sigma^alpha| ≤ (sinh theta_varrho/theta_varrho)^alpha for alpha ≥ 0: |1 − t/(4k²)| ≤ 1 + varrho/(4k²) in the
   product, and |z^alpha| = |z|^alpha for real alpha;
2. |c^m| ≤ (cosh theta_varrho)^m and |g| ≤ theta_varrho sinh theta_varrho: replace each Taylor coefficient by its
   absolute value;
3. |I_n f| ≤ |f|/(n·alpha + 2) if f(0) = 0: I_n f(t) = ½ ∫_0^1 v^{n·alpha/2 − 1} f(vt) dv and |f(vt)| ≤ v |f| (Schwarz);
4. the coefficients satisfy |f_j| ≤ |f| varrho^{−j} (Cauchy), so sum_{j≥K} |f_j| ≤ |f| varrho^{−K}/(1 − 1/varrho).

Hence the same recursion, with the numbers 1–3 in the place of the functions and |a_i|, |varrho_i| in that of −a_i,
varrho_i, yields upper bounds of |y_n| and |p_{i,n}| by induction, and 4 turns them into a bound of every tail.
`order_series` is that recursion; `power_series_ring` and `bound_ring` are its two arithmetics.

>>> drag = Forces.losses([2])
>>> small = order_series(power_series_ring(drag, 30), indices(1, 2))
>>> sum(small[(1,)].coeffs(), arb(0)).str(8)        # y_1 = sigma^2, at theta = pi/2: (2/pi)^2 up to the tail
'[0.40528473 +/- ...]'
>>> (order_series(bound_ring(drag, 4), indices(1, 2))[(1,)]).str(5)     # (sinh(pi)/pi)^2
'[13.514 +/- ...]'
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from typing import Any

from flint import arb, arb_poly

from asymptotics.expansions.half_swings.forces import Forces, Member
from asymptotics.running.budget import tick
from asymptotics.series import Key, monomials


@dataclass(frozen=True)
class Ring:
    """What `order_series` needs: the functions c and g, truncation and I_n; the velocity powers of the variables; and
    of each member its key, its function varrho sigma^v c^m, and the factor ±a of its slope."""

    cosine: Any
    turn: Any
    velocities: tuple[arb, ...]
    keys: tuple[Key, ...]
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


def dot(n: Key, velocities: Sequence[arb]) -> arb:
    """The exponent n·alpha of a power of the sine."""
    return sum((k * a for k, a in zip(n, velocities, strict=True)), arb(0))


def convolve(f: Mapping[Key, Any], g: Mapping[Key, Any], n: Key) -> Any:
    """sum_m f_m g_{n−m} over the orders that both have so far; the integer 0 if there is none."""
    tick()
    total: Any = 0
    for m in product(*(range(k + 1) for k in n)):
        if m in f and (rest := minus(n, m)) in g:
            total = f[m] * g[rest] + total
    return total


def order_series(ring: Ring, orders: Sequence[Key]) -> dict[Key, Any]:
    """All y_n, n ≠ 0, of the module docstring in the arithmetic of ``ring``; ``orders`` as from `indices`."""
    zero, members = orders[0], range(len(ring.keys))
    y: dict[Key, Any] = {}
    p: list[dict[Key, Any]] = [{zero: arb(1)} for _ in members]
    C: list[dict[Key, Any]] = [{} for _ in members]
    top = sum(orders[-1])
    for n in orders[1:]:
        tick(f"order {sum(n)} of {top} of the quarter swing")
        # y_0 = 0, so that C_n needs p_m of lower degree only: y_n comes first, then C_n, then p_n from C_n.
        rests = [(i, minus(n, ring.keys[i])) for i in members]
        s = ring.cut(sum((ring.powers[i] * p[i][m] for i, m in rests if m in p[i]), start=0 * ring.cosine))
        products = (ring.powers[i] * C[i][m] for i, m in rests if m in C[i])
        y[n] = s + ring.cut(ring.cosine * ring.cut(sum(products, start=0 * ring.cosine)))
        for i in members:
            # No order that is asked for can use it.
            if sum(n) + sum(ring.keys[i]) > top:
                continue
            C[i][n] = ring.cut(convolve(p[i], y, n))
            # P_i = 1 where the weight is exactly 0 (linear friction);
            # a ball around 0 is no such weight and may not be dropped.
            if ring.slopes[i] != 0 or not ring.slopes[i].is_exact():
                p[i][n] = ring.slopes[i] * ring.integrate(ring.cut(ring.turn * C[i][n]), dot(n, ring.velocities))
    return y


def power_series_ring(forces: Forces, terms: int) -> Ring:
    """Polynomials in t with the first ``terms`` coefficients of each function, as balls."""
    cosine, sine_ratio = elementary_series(terms)
    square = (arb.pi() / 2) ** 2

    # The sum of nothing is a number among polynomials: adding the empty polynomial makes one of it.
    def cut(f: Any) -> Any:
        return (f + arb_poly()).truncate(terms)

    def function(m: Member) -> arb_poly:
        f = sine_ratio_power(m.velocity.ball(), terms) * (arb(m.ratio) * m.side)
        for _ in range(m.position):
            f = cut(f * cosine)
        return f

    # g = theta sin theta = theta^2 sigma with theta^2 = (pi/2)^2 t.
    turn = cut((square * sine_ratio).left_shift(1))
    return Ring(
        cosine, turn, *_variables(forces), tuple(map(function, forces.members)),
        tuple(-a for a in _weights(forces)), cut, integrate_series,
    )  # fmt: skip


def _variables(forces: Forces) -> tuple[tuple[arb, ...], tuple[Key, ...]]:
    return tuple(v.ball() for v in forces.velocities), tuple(m.key for m in forces.members)


def _weights(forces: Forces) -> list[arb]:
    """The weight of each member, exactly zero where it is."""
    return [(m.degree - 1).ball() for m in forces.members]


def elementary_series(terms: int) -> tuple[arb_poly, arb_poly]:
    """cos theta and sin theta/theta as polynomials in t = (2 theta/pi)², ``terms`` coefficients each."""
    minus_square = -((arb.pi() / 2) ** 2)
    even, odd = [arb(1)], [arb(1)]
    for j in range(1, terms):
        even.append(even[-1] * minus_square / (2 * j * (2 * j - 1)))
        odd.append(odd[-1] * minus_square / (2 * j * (2 * j + 1)))
    return arb_poly(even), arb_poly(odd)


def sine_ratio_power(alpha: arb, terms: int) -> arb_poly:
    """(sin theta/theta)^alpha in t, from t d/dt ln sigma = −sum_j zeta(2j) (t/4)^j, which is the product of the module
    docstring."""
    # ln sigma = sum_k ln(1 - t/(4 k^2)) = -sum_j zeta(2j)/j (t/4)^j, and f' = alpha (ln sigma)' f coefficient by
    # coefficient: no root or logarithm of a ball is taken, so any alpha will do.
    slope = [arb(0)] + [-alpha * arb(2 * j).zeta() / arb(4) ** j for j in range(1, terms)]
    f = [arb(1)]
    for j in range(1, terms):
        tick(f"term {j} of a power of the sine")
        f.append(sum((slope[i] * f[j - i] for i in range(1, j + 1)), arb(0)) / j)
    return arb_poly(f)


def integrate_series(f: arb_poly, exponent: arb) -> arb_poly:
    """I_n: the coefficient of t^j, j >= 1, divided by ``exponent`` + 2j; f(0) = 0 by construction."""
    return arb_poly([arb(0)] + [x / (exponent + 2 * j) for j, x in enumerate(f.coeffs()[1:], 1)])


def bound_ring(forces: Forces, radius: arb | int) -> Ring:
    """Upper bounds of the functions on |t| < ``radius``, 1 < radius <= 4."""
    theta = arb.pi() / 2 * arb(radius).sqrt()
    # Items 1 to 3 of the module docstring in balls: their upper ends are what the tails are made of.
    cosine, sine_ratio = theta.cosh(), theta.sinh() / theta
    powers = tuple(abs(arb(m.ratio)) * sine_ratio ** m.velocity.ball() * cosine**m.position for m in forces.members)
    return Ring(
        cosine, theta * theta.sinh(), *_variables(forces), powers, tuple(abs(a) for a in _weights(forces)), arb,
        lambda f, exponent: f / (exponent + 2),
    )  # fmt: skip
