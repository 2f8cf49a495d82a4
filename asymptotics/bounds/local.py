"""What the O() of a truncated expansion holds: a constant, and how far it reaches.

Cauchy's method of majorants shows where both sides are analytic, and Cauchy's inequalities on a polydisc (Hörmander, An
Introduction to Complex Analysis in Several Variables, section 2.2) bound the rest of their series.

The equations of order N (turning-point gauge), dA/d tau = -A p_N, d psi/d tau = 1 + Omega_N, lead from a turning point,
psi = 0, to psi = pi.  Let L_N and T_N be ln(A(pi)/A(0)) and the time this takes, L and T those of the motion.  Then

    |L - L_N| <= C_A |delta|^a,   |T - T_N| <= C_T |delta|^b,      |delta| = sum_i delta_i <= delta_max,

a = N + 2, b = N + 1 for odd N and a = N + 1, b = N + 2 for even N.  (Derivation ``expansion-bounds``.)

*Proof.*  The four functions are analytic on the polydisc |delta_i| <= rho: L and T by ``half_swings.finite_majorant``,
L_N and T_N because G' = P(v)/(1 - Q(v)), v_i = rho e^(|alpha_i-1| G), is a majorant of their equations, P and Q being
p_N and Omega_N with the absolute values of the coefficients.  The differences begin with degree a and b.  Their next
coefficients are computed in balls, and Cauchy's inequality bounds what is beyond:

    C = sum_(m <= k <= J) max_n |c_n|/binomial(k; n) |delta|^(k-m) + M rho^(-J-1) |delta|^(J+1-m)/(1 - |delta|/rho)

with the multinomial coefficient of n, |n| = k: then sum_(|n|=k) |c_n| delta^n <= max_n (...) |delta|^k.  ``delta_max``
is chosen such that C is at most twice its largest term, wherever that is possible: the constants are nearly the best.

>>> from asymptotics.numbers.exact import parse_real
>>> local_bounds([parse_real("2", "--alpha")], 3).to_dict()
{'delta_max': '0.11', 'amplitude': '0.019', 'frequency': '0.071', 'amplitude_power': 5, 'frequency_power': 4}
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import factorial, prod
from typing import Any

from flint import arb

from asymptotics.errors import UndecidedError
from asymptotics.expansions.half_swings.certified import quarter_swing
from asymptotics.expansions.half_swings.finite_majorant import majorant, widest
from asymptotics.expansions.half_swings.quarter import HalfSwing, half_swing
from asymptotics.expansions.normal_form.flow import Flow, flow_of
from asymptotics.numbers.context import ctx, lru_cache
from asymptotics.numbers.decimals import directed_decimal
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.extremes import greatest
from asymptotics.numbers.rationals import bounds
from asymptotics.series import Key, Series

# Bounds are printed with two digits; what cancellation takes from the coefficients of the differences is in their
# balls.
BITS = 128
NEXT = 8
"""Orders of the difference that are computed before Cauchy's inequality takes over; half of it from three laws on."""
_PIECES = 256
# Two digits are enough for coefficients that are only bounded; the rest of the precision is for what cancels.
_COARSE = 24  # bits beside which the rest of a precision is a guard
_GRID = 100
_TERMS = (2.3, 1.15)


@dataclass(frozen=True)
class Remainder:
    """|f(delta)| <= constant(d) d^power for |delta| = d < radius, f being L - L_N or T - T_N.

    ``power``: m, that is a or b; ``coefficients``: max_n |c_n|/binomial(k; n) for k = m, ..., J; ``cauchy``: M, the
    largest |f| on the polydisc; ``radius``: rho.
    """

    power: int
    coefficients: tuple[arb, ...]
    cauchy: arb
    radius: arb

    def constant(self, d: arb) -> arb:
        """C at |delta| = d; it grows with d."""
        # What is known, term by term, and Cauchy's inequality beyond, so that the constant is nearly attained and a
        # halved one fails (L5 of the shared notes).
        return (self.known(d) + self.beyond(d, self.power + len(self.coefficients)) / d**self.power).upper()

    def known(self, d: arb) -> arb:
        """The part of C that the next coefficients make."""
        return sum((c * d**k for k, c in enumerate(self.coefficients)), arb(0))

    def beyond(self, d: arb, first: int) -> arb:
        """Cauchy's bound of all terms from the degree ``first`` on: M x^first/(1 - x), x = d/radius."""
        # sum_(|n|=k) |c_n| |delta^n| <= M (|delta|/rho)^k on a polydisc of equal radii (derivation
        # ``expansion-bounds``).
        x = d / self.radius
        if not x < 1:
            raise UndecidedError("delta is outside the polydisc on which the expansion is bounded")
        return self.cauchy * x**first / (1 - x)

    def largest_term(self, d: arb) -> arb:
        """The largest of the terms c_k d^(k-m) that are known."""
        return greatest(c * d**k for k, c in enumerate(self.coefficients))

    def __call__(self, d: arb) -> arb:
        """The bound itself at |delta| = d."""
        return (self.constant(d) * d**self.power).upper() if d > 0 else arb(0)


@dataclass(frozen=True)
class LocalBounds:
    """The two remainders of one order: ``amplitude`` bounds |L - L_N|, ``duration`` |T - T_N|, up to ``delta_max``."""

    alphas: tuple[ExactReal, ...]
    order: int
    delta_max: Fraction
    amplitude: Remainder
    duration: Remainder
    flow: Flow
    half: HalfSwing

    def to_dict(self) -> dict[str, Any]:
        """Decimals rounded up (delta_max is exact); ``frequency``: that of the duration."""
        constants = {name: _up(f.constant(self.limit)) for name, f in self._named}
        powers = {f"{name}_power": f.power for name, f in self._named}
        return {"delta_max": directed_decimal(self.delta_max, 2, -1), **constants, **powers}

    @property
    def limit(self) -> arb:
        """delta_max as a ball."""
        return arb(self.delta_max.numerator) / self.delta_max.denominator

    @property
    def _named(self) -> tuple[tuple[str, Remainder], ...]:
        return ("amplitude", self.amplitude), ("frequency", self.duration)

    def __str__(self) -> str:
        d = self.to_dict()
        parts = [
            f"|{f} - {f}_{self.order}| <= {d[n]} d^{d[n + '_power']}"
            for f, n in (("L", "amplitude"), ("T", "frequency"))
        ]
        return f"proved for d = sum delta_i <= {d['delta_max']}, on each half-swing: " + ", ".join(parts)


def local_bounds(alphas: Sequence[ExactReal], order: int, bits: int = BITS) -> LocalBounds:
    """C_A and C_T of the expansion of order N >= 1 in the turning-point gauge; any exponents >= 0, any sum.

    ``bits``: the precision of the coefficients of the flow.  LimitError when they would take too long; UndecidedError
    if no polydisc can be verified.
    """
    return _local_bounds(tuple(alphas), order, bits)


@lru_cache(maxsize=64)
def _local_bounds(alphas: tuple[ExactReal, ...], order: int, bits: int) -> LocalBounds:
    # p is odd and Omega even in the strengths (derivation ``parity-of-flow``): what order N lacks begins one degree
    # later in one of the two.
    powers = (order + 2, order + 1) if order % 2 else (order + 1, order + 2)
    last = max(powers) + (NEXT if len(alphas) <= 2 else NEXT // 2)
    with ctx.workprec(bits):
        half, full = _half_swing(alphas, order, last)
        flow = truncated_flow(full, order, last)
        other = flow.half_swing(arb.pi())
        differences = (half.L - other.L, half.T - other.T)
        balls = [a.ball() for a in alphas]
        found = [
            Remainder(m, _sizes(f, m), M, rho)
            for f, m, (M, rho) in zip(differences, powers, _cauchy(balls, full, order), strict=True)
        ]
        # Dry friction alone: the balls of the differences hold 0, which is the truth by the closed form; up to delta =
        # 1/2 the mass turns again.
        exact = len(alphas) == 1 and alphas[0].is_zero
        if exact:
            found = [Remainder(f.power, (arb(0),), arb(0), arb(1) / 2) for f in found]
        limit = Fraction(49, 100) if exact else _limit(found)
        amplitude, duration = found
        return LocalBounds(alphas, order, limit, amplitude, duration, flow, half)


def _half_swing(alphas: tuple[ExactReal, ...], order: int, last: int) -> tuple[HalfSwing, Flow]:
    """L and T through ``last``, and the flow through ``order``.

    Sums have many coefficients: beyond the order, where they are only bounded, a few digits of them will do.
    """
    if len(alphas) == 1:
        half = half_swing(quarter_swing(alphas, last))
        return half, flow_of(half)
    flow = flow_of(half_swing(quarter_swing(alphas, order)))
    # How many terms of the orbit's series some digits need; where two digits are not reached half as many more are
    # taken, twice.  Three quarters of them fail the first time, half as many more cost half as much more or twice as
    # much, and the constants are the same (``benchmarks/constants.json``).
    terms = int(last * (_TERMS[0] + _TERMS[1] * max(float(a.ball()) for a in alphas)))
    for factor in (2, 3, 4):
        with ctx.workprec(_COARSE):
            quarter = quarter_swing(alphas, last, terms=terms * factor // 2, guard=terms * factor // 2)
        with ctx.workprec(_COARSE + terms * factor // 2):
            half = half_swing(quarter)
            if _sharp(half.L, order) and _sharp(half.T, order):
                break
    return half, flow


def _sharp(f: Series, order: int) -> bool:
    """Whether the largest coefficients of each degree beyond the order have two digits."""
    parts = [[arb(c) for _, c in part] for part in f.parts[order + 1 :] if part]
    # 2^-6 of the largest coefficient of the degree: what is added to a bound of two digits.
    return all(max(c.rad() for c in part) < max(arb(abs(c).upper()) for c in part) * arb(2) ** -6 for part in parts)


def truncated_flow(full: Flow, order: int, last: int | None = None) -> Flow:
    """The flow of the equations with p_k and Omega_k for k <= order, as series through ``last`` (else as ``full``)."""
    p, Omega = (f.truncate(order).extend(last or full.order) for f in (full.p, full.Omega))
    W = (Omega + 1).inverse()
    return Flow(full.grading, -p * W, W)


def _sizes(f: Series, power: int) -> tuple[arb, ...]:
    """max_n |c_n|/multinomial(n) for the degrees |n| = power, …; lower degrees vanish, which is checked."""
    for degree, part in enumerate(f.parts[:power]):
        # Below degree a and b the difference vanishes identically; a ball that does not hold 0 would refute the
        # expansion itself.
        if any(not arb(c).contains(0) for _, c in part):
            raise ArithmeticError(f"the expansion differs from the motion at degree {degree}: {part}")
    return sizes_from(f, power)


def sizes_from(f: Series, power: int) -> tuple[arb, ...]:
    """max_n |c_n|/multinomial(n) for the degrees |n| >= power."""
    return tuple(greatest(arb((abs(c) / multinomial(n)).upper()) for n, c in part) for part in f.parts[power:])


def multinomial(n: Key) -> int:
    """The multinomial coefficient |n|!/(n_1! ... n_m!)."""
    return factorial(sum(n)) // prod(factorial(k) for k in n)


def _cauchy(alphas: list[arb], full: Flow, order: int) -> list[tuple[arb, arb]]:
    """(M, rho) for the differences of L and of T, on one polydisc of equal radii."""
    widest_half = widest(alphas, [arb(1)] * len(alphas), whole=True)
    # Nearly as large as the motion's own polydisc where the truncated equations allow it; a smaller one makes Cauchy's
    # part larger.
    for share in (0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2, 0.1, 0.03, 0.01):
        rho = arb((widest_half.radii[0] * arb(share)).mid())
        motion = majorant(alphas, [rho] * len(alphas), whole=True)
        flow = flow_majorant(full, order, rho)
        if motion is not None and flow is not None:
            return [(motion.growth + flow[0], rho), (motion.excess + flow[1], rho)]
    raise UndecidedError("no polydisc was verified on which the truncated equations are analytic")


def flow_majorant(full: Flow, order: int, rho: arb, pieces: int = _PIECES) -> tuple[arb, arb] | None:
    """Bounds of |L_N| and |T_N - pi| for complex |delta_i| <= rho, or None where they are not verified."""
    P, Q = (_absolute(f.truncate(order)) for f in (full.p, full.Omega))
    slopes = [abs(w) for w in full.grading.weights]

    def rates(growth: arb) -> tuple[arb, arb]:
        v = tuple(rho * (k * growth).exp() for k in slopes)
        # |Omega_N| <= Q, so that |1/(1 + Omega_N)| <= 1/(1 - Q); the caller needs Q < 1, which a negative room fails.
        room = 1 - Q.at(v) if Q.coefficients else arb(1)
        return P.at(v) / room, 1 / room - 1

    growth, excess, h = arb(0), arb(0), arb.pi() / pieces
    for _ in range(pieces):
        end = _upper_end(growth, h, rates)
        if end is None:
            return None
        excess = (excess + h * rates(end)[1]).upper()
        growth = end
    return growth, excess


def _upper_end(start: arb, h: arb, rates: Callable[[arb], tuple[arb, arb]]) -> arb | None:
    """A number g with start + h rate(g) <= g, so that G <= g on the piece; None if the simple candidates fail."""
    rate = rates(start)[0]
    # Candidates for a number g with start + h rate(g) <= g: the rate grows with G, so G cannot reach g within the
    # piece.
    for factor in ("1.001", "1.01", "1.1", "1.5"):
        end = arb((start + h * rate * arb(factor) + arb(10) ** -18).upper())
        slope = rates(end)[0]
        if slope > 0 and start + h * slope <= end:
            return end
    return None


def _absolute(f: Series) -> Series:
    return f.map(lambda c: arb(abs(c).upper()))


def _limit(found: Sequence[Remainder]) -> Fraction:
    """The largest n/100 of the radius, to two digits, at which every constant is at most twice its largest term."""
    best = Fraction(0)
    radius = Fraction(float(found[0].radius))
    for k in range(1, _GRID):
        d = two_digits(radius * k / _GRID)
        at = arb(d.numerator) / d.denominator
        # The range ends where the constant would be more than twice its largest term: a statement that is nearly the
        # best, over a range that is stated.
        if not all(f.constant(at) <= 2 * f.largest_term(at) for f in found):
            break
        best = d
    return best or two_digits(radius / _GRID)


def two_digits(x: Fraction) -> Fraction:
    """x rounded down to two digits."""
    return Fraction(directed_decimal(x, 2, -1))


def _up(x: arb) -> str:
    return directed_decimal(max(bounds(x)), 2, 1)
