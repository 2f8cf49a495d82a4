"""|x - x_N| for all times at once: a theorem, no enclosure of the motion.

A differential inequality along a nonexpansive flow: in the energy norm the distance from any curve grows at most by the
defect of the curve in the equation (Brezis, Opérateurs maximaux monotones, 1973, for monotone friction; Walter,
Ordinary Differential Equations, 1998, § 9, for the comparison).

x_N - i x_N'/omega_0 = z_N = A e^(i psi) Z, with A and psi of order N and the waveform through delta^(N-1).  Let z~ be
the same with the waveform through N + 1: it satisfies the equations of motion up to A R, per unit of psi
(``waveform``).  Friction is a monotone function of the velocity, so |z - z~| grows by at most what is left over
(derivation ``uniform-bound``), whatever the motion does; with |delta| = sum_i delta_i, d_0 its value at t = 0,
A = A_0 e^(-s), K = sup |delta| (1 + Omega_N)/p_N and |R| <= sum_(k>N) r_k |delta|^k,

    |x - x_N|/A_0  <=  a + sum_(k>N) r_k K I_(k-1) + sup_s e^(-s) (xi_N |delta|^N + xi_(N+1) |delta|^(N+1)),

    I_m = int_0^S e^(-s) |delta|^m ds,       |delta| = sum_i delta_i(0) e^(-(alpha_i - 1) s),

|Re e^(i psi) Z_n| <= xi_k binomial(k; n) for |n| = k, the imaginary part for x'; a = 0 for a start at rest, and the two
terms of |Z| at t = 0 for one in motion.
If all exponents are >= 1 then S = infinity: the bound, O(d_0^N), holds for every t >= 0, a linear term included, since
errors of phase are made while there is amplitude.  Below, |delta| grows, and S is where it may leave the range
of the theorem, or belongs to a time ``until`` before that: the bound holds up to a stated time.

>>> from asymptotics.law import Oscillator
>>> uniform_bound(Oscillator({"2": "1/10"}), 3)
|x - x_3| <= 0.000046, |x' - x'_3| <= 0.000066 for every t >= 0
>>> uniform_bound(Oscillator({"1/2": "1/50"}), 3, until=40)
|x - x_3| <= 7.8e-7, |x' - x'_3| <= 2.7e-7 for t <= 40
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import takewhile
from typing import Any

from flint import arb

from asymptotics.bounds.flow import TruncatedFlow
from asymptotics.bounds.local import two_digits
from asymptotics.bounds.turning import rates
from asymptotics.bounds.waveform import BITS, WaveformBounds, waveform_bounds
from asymptotics.errors import InputError, LimitError
from asymptotics.frames import BARE, Frame
from asymptotics.law import Oscillator
from asymptotics.numbers.context import ctx
from asymptotics.numbers.decimals import directed_decimal
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.extremes import least
from asymptotics.numbers.policy import Number, exact_integer, exact_number
from asymptotics.numbers.rationals import bounds
from asymptotics.present.shown import Page, Shown

MAX_ORDER = 12
# Strengths looked at for a range, in per cent of the radius; pieces of the integral over s, by its largest values on
# each, which decide how sharp it is.
_GRID, _PIECES = 100, 128
_COULOMB = Fraction(3, 10)
"""With dry friction the expansion holds the mass from its last half-swing on, which begins with delta > 1/3."""


@dataclass(frozen=True, repr=False)
class UniformBound(Shown):
    """|x - x_N| <= ``bound`` (m) and |x' - x_N'| <= ``velocity`` (m/s) for 0 <= t <= ``until`` (s; None: for ever)."""

    order: int
    bound: str
    velocity: str
    until: str | None
    frame: Frame = field(default=BARE, compare=False)

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready; decimals rounded to the safe side."""
        return {"order": self.order, "bound": self.bound, "velocity": self.velocity, "until": self.until}

    def _page(self) -> Page:
        return Page(repr(self), ("proved, rounded up", self.frame.in_words))

    def _formula(self) -> str:
        n, told = self.order, self.frame.latex
        end = r"t\ge0" if self.until is None else rf"0\le t\le {told('t', self.until)}"
        bound, velocity = told("x", self.bound), told("v", self.velocity)
        return rf"|x-x_{{{n}}}|\le {bound},\ |\dot x-\dot x_{{{n}}}|\le {velocity},\quad {end}"

    def __repr__(self) -> str:
        n, told = self.order, self.frame.with_unit
        end = "every t >= 0" if self.until is None else f"t <= {told('t', self.until)}"
        return f"|x - x_{n}| <= {told('x', self.bound)}, |x' - x'_{n}| <= {told('v', self.velocity)} for {end}"


def uniform_bound(oscillator: Oscillator, order: int = 3, *, until: Number | None = None) -> UniformBound:
    """The bound for the expansion of order N in the turning-point gauge, before rounding to decimals.

    InputError beside a spring, with losses that depend on the place, or for an order out of range; LimitError where
    the local strength at the start is beyond the range of the theorem.
    """
    order = exact_integer(order, "order", 1, MAX_ORDER)
    if not oscillator.law.is_pure:
        raise InputError("law", "springs and losses that depend on the place have no such theorem", "powers of x'")
    acting = [term for term in oscillator.dimensionless.terms if term.strength.sign > 0]
    oscillator.law.require_dissipative("error bound")
    last = None if until is None else exact_number(until, "until")
    if last is not None and not last > 0:
        raise InputError("until", f"{last} leaves no time", "a time > 0 in s")
    if not acting:
        return UniformBound(order, "0", "0", None)
    waves = waveform_bounds(tuple(term.velocity for term in acting), order)
    with ctx.workprec(BITS):
        theorem = _UniformTheorem(waves, order, tuple(term.strength.ball() for term in acting))
        omega = oscillator.omega_0()
        x, v, reached = theorem.bound(
            moving=not oscillator.v0.is_zero, until=None if last is None else last.ball() * omega
        )
        length, end = oscillator.length(), None if last is None else str(last)
        if last is None and reached is not None:
            end = directed_decimal(min(bounds(reached / omega)), 2, -1)
        bound, velocity = (directed_decimal(max(bounds(b)), 2, 1) for b in (x * length, v * length * omega))
        return UniformBound(order, bound, velocity, end)


class _UniformTheorem:
    """The bound in units of length and of 1/omega_0."""

    def __init__(self, waves: WaveformBounds, order: int, strengths: Sequence[arb]) -> None:
        self.waves, self.order, self.strengths = waves, order, strengths
        self.weights = [(a - 1).ball() for a in waves.alphas]  # exact first: a ball of alpha near 1 has lost 1 - alpha
        self.falling = [bool(a >= 1) for a in waves.alphas]
        self.fades = all(self.falling)
        limit = largest_strength(waves, fades=self.fades)
        self.limit = arb(limit.numerator) / limit.denominator

    def bound(self, *, moving: bool, until: arb | None) -> tuple[arb, arb, arb | None]:
        """The bounds of x and of x', and the time up to which they are proved."""
        A, d = self._start(moving=moving)
        deltas = tuple(e * A**w for e, w in zip(self.strengths, self.weights))
        flow = self._fastest(deltas)
        # None is infinity: where all strengths fade the integrals over all s are finite.
        S = None if self.fades and until is None else self._reach(flow, d, until)
        pieces = self._pieces(deltas, S)
        r, largest = self.waves.residual, max(d for _, _, d in pieces)
        last = r.power + len(r.coefficients)
        rows = [
            *((c, r.power + k) for k, c in enumerate(r.coefficients)),
            (r.beyond(largest, last) / largest**last, last),
        ]
        # 1/K: the infimum of p_N/(|delta| (1 + Omega_N)) over all strengths met.
        low, _ = rates(self.waves.p, self.waves.Omega, largest)
        if not low > 0:
            raise LimitError("law", f"the amplitude equation of order {self.order} may lose its sign", "weaker damping")
        left_over = sum((c * sum((u * x ** (k - 1) for _, u, x in pieces), arb(0)) for c, k in rows), arb(0)) / low
        # From rest z~ and z_N begin at the same point, Z(0) = 1; in motion they differ by the terms that z~ has more.
        at_start = self._omitted(self.waves.sizes, d) if moving else arb(0)
        both = []
        for sizes in (self.waves.displacements, self.waves.velocities):
            printed = max(arb((u * self._omitted(sizes, x)).upper()) for u, _, x in pieces)
            # |x| <= 1 by the energy and |x_N| by its terms: a bound in any case, and the smaller one counts.
            energy = 1 + A * sum((z * largest**k for k, z in enumerate(sizes[: self.order])), arb(0))
            both.append(arb((A * (at_start + left_over + printed)).min(energy).upper()))
        return both[0], both[1], None if S is None else flow.time(S)

    def _fastest(self, deltas: Sequence[arb]) -> TruncatedFlow:
        """A comes down no faster than with |p_k| for p_k and the largest strengths: times come out too small."""
        # Absolute values: an upper bound of the rate at which A falls gives a lower bound of the time.
        p, Omega = (f.map(lambda c: arb(abs(arb(c)).upper())) for f in (self.waves.p, self.waves.Omega))
        return TruncatedFlow(p, Omega, tuple(self.weights), tuple(arb(d.upper()) for d in deltas))

    def _omitted(self, sizes: Sequence[arb], d: arb) -> arb:
        """The terms of degree N and N + 1 of the waveform, which z~ has and z_N has not."""
        return sum((sizes[k] * d**k for k in (self.order, self.order + 1)), arb(0))

    def _pieces(self, deltas: Sequence[arb], S: arb | None) -> list[tuple[arb, arb, arb]]:
        """On pieces of 0 <= s <= S: the largest u = e^-s, the integral of u ds, and the largest |delta|."""
        if S is None:
            cuts = [arb(k) / _PIECES for k in range(_PIECES + 1)]
            logs = [arb.neg_inf(), *(u.log() for u in cuts[1:])]
        else:
            logs = [S * (arb(k) / _PIECES - 1) for k in range(_PIECES + 1)]
            cuts = [log.exp() for log in logs]
        found = []
        for k, (low, high) in enumerate(zip(cuts, cuts[1:])):
            # Each delta_i at the end of the piece where it is largest, for alpha_i >= 1 the earlier one.
            ends = (logs[k + 1] if f else logs[k] for f in self.falling)
            sizes = (e * (w * end).exp() for e, w, end in zip(deltas, self.weights, ends))
            found.append((arb(high.upper()), high - low, arb(sum(sizes, arb(0)).upper())))
        return found

    def _start(self, *, moving: bool) -> tuple[arb, arb]:
        """A_0 as a ball and an upper bound of d_0; in motion, A_0 |Z(psi_0)| = 1 with the waveform through N - 1.

        |Z| is in 1 +- q wherever A_0 is in 1/(1 +- q), so the solution there stays there.
        """
        q = arb(0)
        # A_0 |Z| = 1: q is enlarged by a tenth until |Z| stays within 1 +- q for all A_0 in 1/(1 +- q), so that A_0 ->
        # 1/|Z| takes this interval into itself.
        for _ in range(8):
            A = 1 / arb(1, q)
            d = arb(sum((e * A**w for e, w in zip(self.strengths, self.weights)), arb(0)).upper())
            if not d <= self.limit:
                break
            size = sum((z * d**k for k, z in enumerate(self.waves.sizes[: self.order]) if k), arb(0))
            if not moving or size <= q:
                return A, d
            q = arb((size * arb("1.1")).upper())
            if not q < 1:
                break
        reason = f"|delta| = {d.str(3, radius=False)} at the start is beyond the range of the theorem"
        raise LimitError("law", reason, f"at most {float(self.limit):.2g} at order {self.order}")

    def _reach(self, flow: TruncatedFlow, d: arb, until: arb | None) -> arb:
        """S: how far the motion may have come at the time ``until``, or where |delta| may leave the range."""
        if self.fades and until is not None:
            return flow.beyond(until)
        # The least exponent makes |delta| grow fastest: e^(|w| S) d = limit, rounded down.
        S = arb(((self.limit / d).log() / -least(self.weights)).lower())
        if until is None:
            return S
        end = flow.time(S)
        if not until <= end:
            reason = f"|delta| may leave the range of the theorem after {end.str(3, radius=False)}/omega_0"
            raise LimitError("until", reason, "an earlier time")
        return S.min(flow.beyond(until))


@dataclass(frozen=True)
class Displacement:
    """|x - x_N| <= ``constant`` A_0 |delta|^N for every t >= 0, from rest with |delta| <= ``delta_max``."""

    order: int
    delta_max: Fraction
    constant: arb

    def to_dict(self) -> dict[str, Any]:
        """Decimals rounded up (delta_max is exact)."""
        constant, d = directed_decimal(max(bounds(self.constant)), 2, 1), directed_decimal(self.delta_max, 2, -1)
        return {"displacement": constant, "displacement_power": self.order, "displacement_delta_max": d}

    def __str__(self) -> str:
        found = self.to_dict()
        reach = f"from rest with d <= {found['displacement_delta_max']}"
        return f"|x - x_{self.order}| <= {found['displacement']} A d^{self.order} for every t >= 0, {reach}"


def displacement_bound(alphas: Sequence[ExactReal], order: int) -> Displacement | None:
    """The bound that holds for all strengths up to a delta_max, where the constant is twice that of weak damping.

    None where an exponent is below 1: no such bound holds for ever.
    """
    if not all(a >= 1 for a in alphas):
        return None
    waves = waveform_bounds(tuple(alphas), order)
    with ctx.workprec(BITS):
        grid = [two_digits(largest_strength(waves, fades=True) * k / _GRID) for k in range(1, _GRID)]
        constants = [_constant(waves, order, arb(d.numerator) / d.denominator) for d in grid]
        # The constant grows with d; the range ends where it has doubled, a choice of what is useful to state.
        k = sum(1 for _ in takewhile(lambda c: c <= 2 * constants[0], constants)) - 1
        return Displacement(order, grid[k], constants[k])


def _constant(waves: WaveformBounds, order: int, d: arb) -> arb:
    """sum_(k>N) r_k K d^(k-1-N)/(1 + w (k-1)) + xi_N + xi_(N+1) d; it grows with d."""
    low, _ = rates(waves.p, waves.Omega, d)
    w, r, xi = least(a.ball() - 1 for a in waves.alphas), waves.residual, waves.displacements
    last = r.power + len(r.coefficients)
    terms = (c * d**k / (1 + w * (order + k)) for k, c in enumerate(r.coefficients))
    beyond = r.beyond(d, last) / d**r.power / (1 + w * (last - 1))
    return arb((sum(terms, beyond) / low + xi[order] + xi[order + 1] * d).upper())


def largest_strength(waves: WaveformBounds, *, fades: bool) -> Fraction:
    """How large |delta| may be: p_N keeps sign and size; where it grows, the known terms of R outweigh the others."""
    r, best = waves.residual, Fraction(0)
    radius = Fraction(float(r.radius))
    for k in range(1, _GRID - 9):
        d = two_digits(radius * k / _GRID)
        if any(a.is_zero for a in waves.alphas) and d > _COULOMB:
            break
        at = arb(d.numerator) / d.denominator
        low, high = rates(waves.p, waves.Omega, at)
        # p_N/(|delta| (1 + Omega_N)) between bounds within a factor of 3, and, where |delta| grows, Cauchy's part no
        # larger than what is known: choices of a range on which the bound is not useless.
        if not high < 3 * low or (
            not fades and not r.beyond(at, r.power + len(r.coefficients)) <= at**r.power * r.known(at)
        ):
            break
        best = d
    return best or two_digits(radius / _GRID)
