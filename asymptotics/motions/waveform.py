"""The waveform Z(psi, delta) of the turning-point gauge, for any forces: every coefficient by one quadrature.

X - i X' = A e^(i psi) Z, Z = 1 + sum_n delta^n Z_n(psi), Z_n pi-periodic, Z(0) = 1 (theory page ``gauges``).  Put
Z = P + i Q, s = sin psi, c = cos psi.  On 0 < psi < pi the equation of motion is, with U = d ln A/d psi and
W = d tau/d psi,

    P' = -(W-1) Q - (U + U D) P - W s F,     F = sum_i delta_i s^alpha_i g^alpha_i  (losses x'|x'|^(alpha-1)),
    Q' = (W-1) P - (U + U D) Q - W c F,

where D multiplies delta^n by sum_i n_i (d_i - 1) and |X'| = A s g, g = P + (c/s) Q; other forces are in
``formal_forces``.  In this gauge X' vanishes at psi = 0 and pi for every delta, so g = 1 + O(delta) is bounded and
g^alpha may be expanded for every alpha >= 0: order by order the right-hand sides are known, and Z_n is an integral
from 0.  Reversibility gives the second half, with l(n) the number of losses in delta^n,

    Z_n(pi - psi) = (-1)^l(n) conj Z_n(psi),

which is a check as well: P_n for odd l(n) and Q_n for even l(n) must vanish at pi/2, and they do so only for the right
U and W.

*Quadrature.*  The integrands have powers of psi at 0.  In l = ln psi they are analytic up to Re l = ln pi; on panels
whose half-width is 0.55 of that distance m Chebyshev nodes give about 5.4^-m (the Bernstein ellipse through the
singularity, 1 + 1/0.55 half-widths from the middle, has the parameter 5.45: Trefethen, Approximation Theory and
Approximation Practice, Theorem 8.2), and summing from the left keeps the relative accuracy near psi = 0 that g needs.
A power psi^top is e^(top l): on a half-width of 0.3 m/top its coefficients are I_k(0.3 m), from k = m on below 3.3^-m
of its largest value.  Heuristic arithmetic (doubles, or midpoints of balls), no proved error.

>>> from asymptotics.expansions.half_swings.certified import quarter_swing
>>> from asymptotics.expansions.normal_form.expansion import expansion_of
>>> from asymptotics.numbers.exact import ExactReal
>>> flow = expansion_of(quarter_swing([ExactReal(2)], 3), arithmetic="certified").flow
>>> Z = waveform_at(flow, Forces.losses((2,)), arb(1), 1)[(1,)]                    # Im Z_1 = -sin^(alpha+1)/(alpha+1)
>>> abs(Z[1] + arb(1).sin() ** 3 / 3) < arb(10) ** -12
True
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import ceil, log, pi
from typing import Any

import numpy as np
from flint import arb, arb_mat

from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.expansions.half_swings.grading import Grading
from asymptotics.expansions.half_swings.pi_ring import PiNumber
from asymptotics.expansions.normal_form.flow import Flow
from asymptotics.motions.formal_forces import FormalForces
from asymptotics.numbers.context import ctx, lru_cache
from asymptotics.series import Key, accumulate

Parts = list[dict[Key, Any]]
Ends = dict[int, tuple[dict[Key, Any], dict[Key, Any]]]
_LN_PI = log(pi)
# Cubic splines of 4096 pieces: an error of about (1/4096)^4 = 4e-15 times a fourth derivative, the 1e-13 that
# ``WaveformTable`` states.
_TABLE = 4096


@dataclass(frozen=True)
class Arithmetic:
    """Doubles or balls for arrays of samples: the elementary functions, matrix products, and a number as a sample."""

    exp: Callable[[Any], Any]
    sin: Callable[[Any], Any]
    cos: Callable[[Any], Any]
    number: Callable[[arb], Any]
    log: Callable[[Any], Any]
    product: Callable[[Any, Any], Any]
    bits: int
    in_doubles: bool


def doubles() -> Arithmetic:
    """The arithmetic of NumPy's doubles."""
    return Arithmetic(np.exp, np.sin, np.cos, lambda x: float(x.mid()), np.log, np.matmul, 60, in_doubles=True)


def balls() -> Arithmetic:
    """Midpoints of balls at the current precision, in object arrays."""
    exp, sin, cos, log = (np.frompyfunc(_mid(f), 1, 1) for f in (arb.exp, arb.sin, arb.cos, arb.log))
    return Arithmetic(exp, sin, cos, lambda x: x.mid(), log, _ball_product, ctx.prec, in_doubles=False)


def waveform_at(flow: Flow, forces: Forces, psi: arb, order: int) -> dict[Key, tuple[arb, arb]]:
    """(P_n, Q_n) at the phase psi (any real number) for all multi-indices n of degree 1 ... ``order``.

    ``flow`` is the flow of the turning-point gauge with ball coefficients, that of ``forces``.
    """
    # Z_n is pi-periodic; the second half of the period by reversal.
    turns = int((psi / arb.pi()).floor().mid().str(40, radius=False).split(".")[0])
    chi = (psi - turns * arb.pi()).mid()
    mirrored = bool(chi > arb.pi() / 2)
    if mirrored:
        chi = (arb.pi() - chi).mid()
    # Z_n(0) = 0 in this gauge, and ln psi does not exist there.
    if not chi > arb(2) ** -ctx.prec:
        return {k: (arb(0), arb(0)) for part in _keys(flow, order) for k in part}
    samples = _Samples.of(flow, forces, chi.log(), order, balls())
    found: dict[Key, tuple[arb, arb]] = {}
    for n in range(1, order + 1):
        for key, (p, q) in samples.end(n).items():
            sign = (-1) ** flow.grading.loss_degree(key)
            found[key] = (sign * p, -sign * q) if mirrored else (p, q)
    return found


@dataclass(frozen=True)
class WaveformTable:
    """P_n and Q_n on 0 <= psi <= pi/2 as cubic splines in u = (2 psi/pi)^(1/4), to about 1e-13; doubles.

    The fourth root makes psi^(alpha+1) at least four times differentiable.
    """

    keys: tuple[Key, ...]
    flips: tuple[int, ...]
    coefficients: Any

    @classmethod
    def of(cls, flow: Flow, forces: Forces, order: int) -> "WaveformTable":
        """Tabulate all coefficients through ``order``."""
        from scipy.interpolate import CubicSpline  # noqa: PLC0415 (slow to load; one point needs no table)

        keys = tuple(k for part in _keys(flow, order)[1:] for k in part)
        if not keys:
            return cls((), (), None)
        samples = _Samples.of(flow, forces, arb(pi / 2).log(), order, doubles())
        u = np.linspace(0.0, 1.0, _TABLE + 1)
        with np.errstate(divide="ignore"):
            values = samples.interpolate(np.log(pi / 2) + 4 * np.log(u), keys)
        spline = CubicSpline(u, values)
        flips = tuple(2 * j + (flow.grading.loss_degree(key) + 1) % 2 for j, key in enumerate(keys))
        return cls(keys, flips, np.ascontiguousarray(np.moveaxis(spline.c, 0, 1)))  # interval, power, function

    def at(self, chi: Any) -> Any:
        """Array (functions, points): P_n, Q_n, P_n', Q_n' ... for 0 <= chi <= pi, in the order of ``keys``."""
        side = np.where(chi > pi / 2, -1.0, 1.0)
        position = np.sqrt(np.sqrt(np.maximum(np.minimum(chi, pi - chi), 0.0) * (2 / pi))) * _TABLE
        index = np.minimum(position.astype(np.intp), _TABLE - 1)
        d = ((position - index) / _TABLE)[:, None]
        rows = self.coefficients[index]
        values = rows[:, 0] * d
        for power in (1, 2):
            values += rows[:, power]
            values *= d
        values += rows[:, 3]
        columns = values.T
        # (-1)^l P_n and -(-1)^l Q_n on the second half, by reversal.
        for row in self.flips:
            columns[row] *= side
        return columns


@dataclass(frozen=True)
class _Samples:
    """P and Q by degree, sampled on panels in ln psi up to a right end; rows are panels, columns nodes."""

    P: Parts
    Q: Parts
    ends: Ends
    edges: tuple[float, ...]
    nodes: int

    @classmethod
    def of(cls, flow: Flow, forces: Forces, right: arb, order: int, arithmetic: Arithmetic) -> "_Samples":
        top = max(float(m.degree.ball().mid()) / m.order for m in forces.members) * order + 2
        m = ceil(arithmetic.bits * 0.42) + 4  # ln 2/ln 5.4 = 0.41, see "Quadrature"
        # Down to psi = 2^-bits of the right end; half-widths by the singularity at psi = pi and by the largest power.
        edges = _edges(float(right.mid()), arithmetic.bits * log(2), 0.3 * m / top)
        grid = _grid(right, edges, m, arithmetic)
        P, Q, ends = _solve(flow, forces, grid, order)
        return cls(P, Q, ends, tuple(edges), m)

    def end(self, n: int) -> dict[Key, tuple[Any, Any]]:
        """(P, Q) of degree n at the right end."""
        p, q = self.ends[n]
        return {k: (p[k], q[k]) for k in p}

    def interpolate(self, l: Any, keys: tuple[Key, ...]) -> Any:  # noqa: E741 (the letter of the docstring)
        """P_n, Q_n at l = ln psi, columns in the order of ``keys``; 0 left of the first panel (doubles)."""
        edges = np.array(self.edges)
        panel = np.clip(np.searchsorted(edges, l) - 1, 0, len(edges) - 2)
        low, high = edges[panel], edges[panel + 1]
        x = np.clip((2 * l - low - high) / (high - low), -1.0, 1.0)
        basis = np.cos(np.arange(self.nodes)[None, :] * np.arccos(x)[:, None])
        transform = np.array(_chebyshev_transform(self.nodes, 80), dtype=float)
        columns = []
        for key in keys:
            for part in (self.P[sum(key)][key], self.Q[sum(key)][key]):
                columns.append(np.einsum("ij,ij->i", (part @ transform.T)[panel], basis))
        return np.where((l > edges[0])[:, None], np.array(columns).T, 0.0)


@dataclass(frozen=True)
class _Grid:
    """psi, sin, cos, ln sin at the nodes, the half-widths of the panels; integrals to each node and over a panel."""

    psi: Any
    s: Any
    c: Any
    ln_s: Any
    half: Any
    columns: Any
    arithmetic: Arithmetic

    def integrate(self, f: Any) -> tuple[Any, Any]:
        """(int_0^psi f d psi at the nodes, the same at the right end); f psi is integrated over ln psi."""
        weighted = f * self.psi
        within = self.arithmetic.product(weighted * self.half, self.columns)
        sums = within[:, -1]
        # Left of the first panel f psi falls like e^l or faster: its integral up to there is about its value, below the
        # last bit.
        before = weighted[0, 0] + np.concatenate([sums[:1] * 0, np.cumsum(sums)])
        return within[:, :-1] + before[:-1, None], before[-1]


def _grid(right: arb, edges: list[float], m: int, arithmetic: Arithmetic) -> _Grid:
    # Doubles take the weights from balls as well: sums of alternating terms would cost them digits.
    bits = max(80, arithmetic.bits)
    nodes, rows = _integration(m, bits)
    number = np.frompyfunc(arithmetic.number, 1, 1)
    shape: Any = (lambda x: number(x).astype(float)) if arithmetic.in_doubles else number
    ends = [arb(e) for e in edges[:-1]] + [right.mid()]
    middles = np.array([[(a + b) / 2] for a, b in zip(ends, ends[1:])], dtype=object)
    halves = np.array([[(b - a) / 2] for a, b in zip(ends, ends[1:])], dtype=object)
    l = shape(middles + halves * np.array(nodes, dtype=object)[None, :])  # noqa: E741
    psi = arithmetic.exp(l)
    s, c = arithmetic.sin(psi), arithmetic.cos(psi)
    return _Grid(psi, s, c, arithmetic.log(s), shape(halves), shape(np.array(rows).T), arithmetic)


def _solve(flow: Flow, forces: Forces, grid: _Grid, order: int) -> tuple[Parts, Parts, Ends]:
    """P and Q by degree at the nodes, and at the right end."""
    one = grid.psi * 0 + 1
    zero = (0,) * flow.U.variables
    number = grid.arithmetic.number
    weigh = replace(flow.grading, weights=tuple(number(w) for w in flow.grading.weights))
    U, W = (_numbers(series, order, number) for series in (flow.U, flow.W))
    P: Parts = [{zero: one}]
    Q: Parts = [{zero: one * 0}]
    ends: Ends = {}
    force = FormalForces(forces, order, grid.s, grid.c, lambda v: grid.arithmetic.exp(grid.ln_s * v), number)
    forced: Parts = [{}]
    for n in range(1, order + 1):
        forced.append(force.part(n))
        F: dict[Key, Any] = dict(forced[n])
        for j in range(1, n):
            accumulate(F, W[j].items(), forced[n - j].items())
        dP = {k: -(grid.s * f) for k, f in F.items()}
        dQ = {k: -(grid.c * f) for k, f in F.items()}
        for j in range(1, n + 1):
            minus_U = [(k, -u) for k, u in U[j].items()]
            accumulate(dP, minus_U, _weighted(P[n - j], weigh).items())
            accumulate(dQ, minus_U, _weighted(Q[n - j], weigh).items())
            accumulate(dP, [(k, -w) for k, w in W[j].items()], Q[n - j].items())
            accumulate(dQ, W[j].items(), P[n - j].items())
        p, q = ({k: grid.integrate(f) for k, f in d.items()} for d in (dP, dQ))
        P.append({k: v[0] for k, v in p.items()})
        Q.append({k: v[0] for k, v in q.items()})
        ends[n] = ({k: v[1] for k, v in p.items()}, {k: v[1] for k, v in q.items()})
        force.extend(P[n], Q[n])
    return P, Q, ends


def _weighted(part: dict[Key, Any], grading: Grading) -> dict[Key, Any]:
    """1 + D: delta^n times 1 + sum_i n_i (d_i - 1)."""
    return {k: x * (1 + grading.weight(k)) for k, x in part.items()}


def _numbers(series: Any, order: int, number: Callable[[arb], Any]) -> Parts:
    parts: Parts = [{} for _ in range(order + 1)]
    for key, c in series.coefficients.items():
        if sum(key) <= order:
            parts[sum(key)][key] = number(arb(c))
    return parts


def _keys(flow: Flow, order: int) -> list[list[Key]]:
    """The multi-indices of the delta_i, a sorted list for each degree."""
    shapes: list[list[Key]] = [[(0,) * flow.U.variables]]
    for _ in range(order):
        grown = {tuple(n + (i == j) for j, n in enumerate(k)) for k in shapes[-1] for i in range(len(k))}
        shapes.append(sorted(grown))
    return shapes


def _edges(right: float, depth: float, widest: float) -> list[float]:
    """Panel edges from the right end down to ln psi = -depth, half-widths 0.55 (ln pi - edge), at most ``widest``."""
    edges = [right]
    while edges[-1] > right - depth:
        edges.append(edges[-1] - 2 * min(0.55 * (_LN_PI - edges[-1]), widest))
    return edges[::-1]


@lru_cache(maxsize=16)
def _chebyshev_transform(m: int, bits: int) -> list[list[arb]]:
    """The matrix from values at x_j = -cos((2j+1) pi/(2m)) to Chebyshev coefficients."""
    with ctx.workprec(bits):
        angles = [arb.pi() - arb.pi() * (2 * j + 1) / (2 * m) for j in range(m)]
        return [[(k * t).cos() * (2 if k else 1) / m for t in angles] for k in range(m)]


@lru_cache(maxsize=16)
def _integration(m: int, bits: int) -> tuple[list[arb], list[list[arb]]]:
    """Nodes x_j on [-1, 1], and the weights of int_-1^(x_i), in the last row those of int_-1^1."""
    with ctx.workprec(bits):
        angles = [arb.pi() - arb.pi() * (2 * j + 1) / (2 * m) for j in range(m)]
        primitive = [[_primitive(k, t) - _primitive(k, arb.pi()) for k in range(m)] for t in [*angles, arb(0)]]
        product = arb_mat(primitive) * arb_mat(_chebyshev_transform(m, bits))
        rows = [[product[i, j].mid() for j in range(m)] for i in range(m + 1)]
        return [t.cos().mid() for t in angles], rows


def _primitive(k: int, t: arb) -> arb:
    """A primitive of T_k at cos t."""
    if k == 0:
        return t.cos()
    if k == 1:
        return (2 * t).cos() / 4
    return ((k + 1) * t).cos() / (2 * (k + 1)) - ((k - 1) * t).cos() / (2 * (k - 1))


def _ball(c: Any) -> arb:
    return c.ball() if isinstance(c, PiNumber) else arb(c)


def _ball_product(a: Any, b: Any) -> Any:
    """A product of matrices of balls by FLINT, which is several times faster than one that NumPy makes of objects."""
    return np.array((arb_mat(a.tolist()) * arb_mat(b.tolist())).tolist(), dtype=object)


def _mid(f: Callable[[arb], arb]) -> Callable[[arb], arb]:
    return lambda x: f(x).mid()
