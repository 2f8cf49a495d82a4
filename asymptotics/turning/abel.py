"""The n-th turning point without iterating, any alpha > 1: a truncated Abel function with a proved bound of its defect.

The solution Psi of Abel's equation Psi(F) = Psi + 1 is the Fatou coordinate of the return map at its parabolic fixed
point 0 (Milnor 2006, section 10).

In the local strength delta = epsilon A^(alpha-1) a half-swing is the map F, of duration T.  The odd Laurent polynomials

    Psi = sum_(k<K) c_k delta^(2k-1),   Psi(F) - Psi - 1 = d,    Theta,  Theta(F) - Theta - T = d,    d = O(delta^(2K))

would give amplitude and time of any turning point at once if the defects d vanished.  The full series diverge; the
truncated ones are rigorous, because d is analytic near 0 (derivation ``abel-defect``):

* **On a circle |delta| = rho** the majorant of the half-swing (``half_swings.finite_majorant``) bounds |F|, |1/F| and
  |T|, hence |d| <= D = sum |c_k| (|F|^(2k-1) + rho^(2k-1)) + (1 or |T|).
* **So** |d(delta)| <= sum_(2K <= m < J) |d_m| delta^m + D (delta/rho)^J/(1 - delta/rho): the next coefficients of the
  defect as they are, Cauchy's inequality beyond them.
* **Along the orbit** 1/delta_(j+1) >= 1/delta_j + g, g = (alpha-1) pi M_(alpha+1); (1/delta + g x)^(-m) is convex, so

      sum_(j>=0) delta_j^m <= (1/delta_0 - g/2)^(1-m) / ((m-1) g).

Hence Psi(delta_n) = Psi(delta_M) + (n - M) up to a sum that does not depend on n; delta_n follows by one step of the
mean value theorem.

>>> from asymptotics.numbers.exact import parse_real
>>> with ctx.workprec(160):
...     jump = abel_function(parse_real("3/2", "--alpha"), terms=8)
...     far = jump.advance(arb(1) / 100, 10**9)
>>> far.str(20)
'[1.3910445426199116877e-9 +/- ...]'
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import inf

from flint import arb

from asymptotics.errors import InputError, UndecidedError
from asymptotics.expansions.half_swings.certified import quarter_swing
from asymptotics.expansions.half_swings.finite_majorant import BITS, Majorant, majorant, widest
from asymptotics.expansions.half_swings.odd_abel import odd_solution
from asymptotics.expansions.half_swings.quarter import half_swing
from asymptotics.expansions.moments.certified import moment
from asymptotics.numbers.context import ctx, lru_cache
from asymptotics.numbers.exact import ExactReal

# A bound by Cauchy alone exceeds the truth by orders of magnitude; eight true coefficients first leave to it a part
# (delta/rho)^8 smaller.  More cost coefficients of the map, fewer make a wider ball.
FOLLOWING = 8
"""How many coefficients of a defect are kept as they are."""
# Radii to try, in units of the widest: near the edge the majorant grows, far inside rho^-J does.
_SHARES = (0.5, 0.6, 0.7, 0.8, 0.9)


@dataclass(frozen=True, eq=False)
class Approximant:
    """An odd Laurent polynomial sum c_k delta^(2k-1), the next coefficients d_m of its defect, and D."""

    coefficients: tuple[arb, ...]
    following: tuple[arb, ...]
    D: arb

    def __call__(self, delta: arb) -> arb:
        """The value sum c_k delta^(2k-1), by Horner's rule."""
        square, total = delta * delta, arb(0)
        for c in reversed(self.coefficients):
            total = total * square + c
        return total / delta

    def slope(self, delta: arb) -> arb:
        """The derivative sum (2k-1) c_k delta^(2k-2)."""
        square, total = delta * delta, arb(0)
        for k in reversed(range(len(self.coefficients))):
            total = total * square + (2 * k - 1) * self.coefficients[k]
        return total / square

    def falls_up_to(self, delta: arb) -> bool:
        """Whether sum_(k>=1) (2k-1) |c_k| delta^(2k) < c_0: then the value decreases on (0, delta]."""
        rest = sum(((2 * k - 1) * abs(c) * delta ** (2 * k) for k, c in enumerate(self.coefficients) if k), arb(0))
        # delta^2 Psi' = -c_0 + that sum (derivation ``abel-defect``); it grows with delta, so one point decides for all
        # below.
        return bool(rest < self.coefficients[0])


@dataclass(frozen=True, eq=False)
class AbelFunction:
    """Psi and Theta of one law with alpha > 1, rigorous on 0 < delta < rho; 1/delta grows by g or more."""

    psi: Approximant
    theta: Approximant
    rho: arb
    g: arb

    def advance(self, delta: arb, steps: int) -> arb:
        """The local strength ``steps`` half-swings after the ball ``delta``; ValueError outside (0, radius)."""
        if not (delta > 0 and delta < self.rho):
            raise ValueError(f"{delta.str(5)} is not in (0, {self.rho.str(5)})")
        # Psi(delta_n) - Psi(delta) - n is the sum of the defects along the orbit, a part of the sum over all of it.
        return self._solve(self.psi(delta) + steps + self.defects(self.psi, delta), delta)

    def time_between(self, first: arb, last: arb) -> arb:
        """The time from the turning point at ``first`` to a later one at ``last``, in units of 1/omega_0."""
        return self.theta(last) - self.theta(first) - self.defects(self.theta, first)

    def defects(self, f: Approximant, delta: arb) -> arb:
        """The sum of all defects of f from the point ``delta`` on, as a ball around 0."""
        with ctx.workprec(BITS):
            # Every term of both bounds grows with delta: the upper end serves for the ball.
            top = arb(delta.upper())
            m = 2 * len(f.coefficients)
            total = sum((c * self.power_sum(top, m + i) for i, c in enumerate(f.following)), arb(0))
            J, x = m + len(f.following), top / self.rho
            beyond = f.D / (1 - x) * self.power_sum(top, J) / self.rho**J
            if not (x < 1 and beyond.is_finite()):
                raise UndecidedError("delta is outside the circle on which the defect is bounded")
            return arb(0, (total + beyond).upper())

    def power_sum(self, delta: arb, m: int) -> arb:
        """A bound of sum_j delta_j^m along the orbit from ``delta``, m >= 2."""
        # The convex summand at j is at most its mean over [j - 1/2, j + 1/2] (Hermite and Hadamard), so the sum is the
        # integral from -1/2 on, which needs 1/delta > g/2.
        behind = 1 / delta - self.g / 2
        if not behind > 0:
            raise UndecidedError("delta is too large for the sum along the orbit")
        return behind ** (1 - m) / ((m - 1) * self.g)

    def _solve(self, value: arb, start: arb) -> arb:
        """The only delta up to about ``start`` with Psi(delta) = value: Newton, then the mean value theorem."""
        # Far out Psi is nearly c_0/delta; Newton's method doubles the bits from there.
        middle = (self.psi.coefficients[0] / value).mid()
        for _ in range(ctx.prec.bit_length() + 3):
            middle = (middle - (self.psi(middle) - value) / self.psi.slope(middle)).mid()
        # A box for the root, a choice; interval Newton proves it: Psi is strictly decreasing on it, and if the mean
        # value form lies in the box, so does the root.
        guess = middle * (1 + arb(0, arb(2) ** -10))
        if not (guess < self.rho and self.psi.falls_up_to(arb(guess.union(start).upper()))):
            raise UndecidedError("the truncated Abel function may not decrease here: use a later head or fewer terms")
        root = middle + (value - self.psi(middle)) / self.psi.slope(guess)
        if not guess.contains(root):
            raise UndecidedError("the enclosure of the turning point was not verified: raise the precision")
        return root


def abel_function(alpha: ExactReal, terms: int) -> AbelFunction:
    """Psi and Theta with K = ``terms`` coefficients at the current precision, for one law with alpha > 1.

    InputError for alpha <= 1: no Abel function of this form exists there.
    """
    if not alpha > 1:
        raise InputError("alpha", f"{alpha} is not above 1", "an exponent > 1")
    return _abel_function(alpha, terms, ctx.prec)


@lru_cache(maxsize=16)
def _abel_function(alpha: ExactReal, terms: int, bits: int) -> AbelFunction:
    with ctx.workprec(bits):
        order = 2 * terms + FOLLOWING
        # The coefficients are the cost, and depend on alpha and the precision alone: kept for the next strength.
        half = half_swing(quarter_swing([alpha], order, max_seconds=inf))
        F = [half.F[0][k] for k in range(1, order + 1)]
        T = [half.T[k] for k in range(order)]
        return from_series(alpha, F, T, terms)


def from_series(alpha: ExactReal, F: Sequence[arb], T: Sequence[arb], terms: int) -> AbelFunction:
    """The Abel function from F_1, F_2, … and T_0, T_1, …, 2 ``terms`` of each at least."""
    (psi, psi_rest), (theta, theta_rest) = (odd_solution([arb(0), *F], rise, terms) for rise in ([arb(1)], T))
    return of_coefficients(alpha, (psi, theta), (psi_rest, theta_rest))


def of_coefficients(
    alpha: ExactReal, coefficients: tuple[Sequence[arb], ...], following: tuple[Sequence[arb], ...]
) -> AbelFunction:
    """From the coefficients of Psi and Theta, and those of their defects that follow (as many as are known)."""
    with ctx.workprec(BITS):
        g = (alpha.ball() - 1) * arb.pi() * moment(alpha.ball() + 1)
        # J: the first power that is left to Cauchy's inequality.
        power = 2 * len(coefficients[0]) + len(following[0])
        bound = _circle(alpha, coefficients[0], power)
        drives = (arb(1), arb.pi() + bound.excess)
        psi, theta = (
            Approximant(tuple(c), tuple(abs(d).upper() for d in rest), (_on_circle(c, bound) + drive).upper())
            for c, rest, drive in zip(coefficients, following, drives, strict=True)
        )
    # Rounded down: 1/delta_j >= 1/delta_0 + g j holds for any smaller gain.
    return AbelFunction(psi, theta, bound.radii[0], arb(g.lower()))


def _circle(alpha: ExactReal, coefficients: Sequence[arb], power: int) -> Majorant:
    """The circle, out of a few, on which the bound of what lies beyond delta^power is smallest."""
    return least_beyond(polydiscs([alpha.ball()], [arb(1)], _SHARES), power, lambda c: _on_circle(coefficients, c))


def polydiscs(exponents: Sequence[arb], direction: Sequence[arb], shares: Sequence[float]) -> list[Majorant]:
    """The majorants at these shares of the widest polydisc in a direction, as far as they converge provably."""
    largest = widest(exponents, direction, whole=True).radii[0]
    found = (majorant(exponents, [largest * arb(share) * d for d in direction], whole=True) for share in shares)
    return [m for m in found if m is not None]


def least_beyond(found: Sequence[Majorant], power: int, bound: Callable[[Majorant], arb]) -> Majorant:
    """The one with the least ``bound``/rho_1^power: of what lies beyond delta^power, by Cauchy's inequality."""
    return min(found, key=lambda m: float((bound(m) / m.radii[0] ** power).log()))


def _on_circle(coefficients: Sequence[arb], bound: Majorant) -> arb:
    """A bound of |f(F) - f(delta)| on the circle for f = sum c_k delta^(2k-1)."""
    rho, high, low = bound.radii[0], bound.final(0), bound.inverse()
    # The term c_0/delta takes a bound of |1/F|, all others one of |F|, both on |delta| = rho by the majorant.
    total = abs(coefficients[0]) * (low + 1 / rho)
    for k, c in enumerate(coefficients[1:], 1):
        total += abs(c) * (high ** (2 * k - 1) + rho ** (2 * k - 1))
    return arb(total.upper())
