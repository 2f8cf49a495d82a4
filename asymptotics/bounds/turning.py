"""How the errors of an expansion add up over all turning points: a theorem for every n, no iteration.

Errors of single steps, carried on by a return map that contracts: Lady Windermere's fan (Hairer, Nørsett and Wanner,
Solving Ordinary Differential Equations I, section I.7), summed in closed form.

Let A_n, tau_n be the turning points of the motion (units of x0 and 1/omega_0) and A_hat_n, tau_hat_n those of the
truncated equations of order N, psi = n pi, from the same start A = 1; all exponents >= 1, w = min alpha_i - 1,
|delta_0| = sum epsilon_i <= delta_max.  With C_A, C_T, a, b of ``local`` (derivation ``expansion-bounds``):

* |ln A_(n+1) - ln A_hat_(n+1)| <= lambda |ln A_n - ln A_hat_n| + C_A |delta_hat_n|^a with lambda <= 1
  (quarter-swing-tail, L1b);
* along the truncated orbit 1/|delta_hat| grows by at least g = w pi inf p_N/(|delta| (1 + Omega_N)) a half-swing, so
  that

      sum_(j<n) |delta_hat_j|^m <= S_m(n) = ((Y - g/2)^(1-m) - (Y + g (n - 1/2))^(1-m))/((m-1) g),   Y = 1/|delta_0|,

  bounded for all n if w > 0, and at most n |delta_0|^m in any case: |ln A_n - ln A_hat_n| <= e = C_A S_a(n);
* one law, alpha > 1: lambda <= exp(-(alpha-1) k delta), k = inf -L', and 1/delta_hat grows by at most G: the errors
  fade,

      |ln A_n - ln A_hat_n| <= C_A ((G/g)(1 + g delta_0)/(Y + G n))^q S_(a-q)(n),   q = (alpha-1) k e^(-(alpha-1) e)/G;

* times: |tau_n - tau_hat_n| <= C_T S_b(n) + B e' exp(2 e') S_2(n), e' = max(alpha_i - 1) e, because amplitudes that
  differ by a factor e^e at most have |T - T_hat| <= B e' (|delta_hat| e^e')^2,
  B = sup sum_i |delta_i dT/d delta_i|/|delta|^2.

A start that is itself uncertain, |ln A_0 - ln A_hat_0| <= e_0, adds e_0 to each |ln A_n - ln A_hat_n|, since lambda
<= 1; delta_0 is then the larger of the two strengths, and 1/delta_hat <= r (Y + G n) with their ratio r.

>>> from asymptotics.numbers.exact import parse_real
>>> quadratic = turning_bounds([parse_real("2", "--alpha")], 3, [arb(1) / 10])
>>> [quadratic.log_amplitude(n).str(2, radius=False) for n in (1, 10, 10**9, None)]         # None: for all n at once
['1.6e-7', '2.4e-7', '8.4e-14', '4.0e-7']
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import reduce

from flint import arb

from asymptotics.bounds.local import BITS, LocalBounds, local_bounds
from asymptotics.errors import InputError, LimitError
from asymptotics.numbers.context import ctx
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.extremes import greatest, least
from asymptotics.series import Series


@dataclass(frozen=True, eq=False)
class TurningBounds:
    """Bounds of |ln A_n - ln A_hat_n|, |tau_n - tau_hat_n| and of the phase error, for every n >= 0."""

    local: LocalBounds
    delta: arb
    C_A: arb
    C_T: arb
    slowest: arb
    fastest: arb
    g: arb
    G: arb
    fading: arb
    B: arb
    start: arb
    widening: arb

    def log_amplitude(self, n: int | None) -> arb:
        """A bound of |ln A_n - ln A_hat_n|; None: for all n at once, infinite where a linear term makes it grow."""
        with ctx.workprec(BITS):
            plain = self._crude(n)
            if n is None or not (self.fading > 0 and self.g > 0):
                return plain
            # k delta of the true orbit, which is at least e^-((alpha-1) e) of the truncated one's (e, the crude bound).
            q = self.fading * (-self.slowest * plain).exp() / self.G
            a = self.local.amplitude.power
            ratio = self.widening * self.G / self.g * (1 + self.g * self.delta) / (1 / self.delta + self.G * n)
            # Both are theorems; for few half-swings errors have not begun to fade and the plain one is smaller.
            return plain.min((self.start + self.C_A * ratio**q * self._sum(a - q, n)).upper())

    def time(self, n: int | None) -> arb:
        """A bound of |tau_n - tau_hat_n|; None as in ``log_amplitude``."""
        with ctx.workprec(BITS):
            e = self.fastest * self._crude(n)
            # |T(delta) - T(delta_hat)| summed, with the crude bound of the amplitudes: they differ by a factor e^e at
            # most.
            late = self.B * e * (2 * e).exp() * self._sum(arb(2), n)
            return (self.C_T * self._sum(arb(self.local.duration.power), n) + late).upper()

    def phase(self, n: int | None) -> arb:
        """A bound of |psi^(tau_n) - n pi|: the phase that order N gives to the true turning point; None as above."""
        with ctx.workprec(BITS):
            Omega = largest(self.local.flow.Omega.truncate(self.local.order), self.delta)
            return (self.time(n) * (1 + Omega)).upper()

    def _crude(self, n: int | None) -> arb:
        return arb((self.start + self.C_A * self._sum(arb(self.local.amplitude.power), n)).upper())

    def _sum(self, m: arb, n: int | None) -> arb:
        """A bound of the sum of |delta_hat_j|^m over j < n, over all j for None."""
        if n == 0:
            return arb(0)
        # Where |delta| does not fall (a linear term) errors add up for ever.
        plain = arb.pos_inf() if n is None else arb((n * self.delta**m).upper())
        Y = 1 / self.delta
        if not (self.g > 0 and self.g / 2 < Y):
            return plain
        late = arb(0) if n is None else (Y + self.g * (n - arb(1) / 2)) ** (1 - m)
        # Hermite and Hadamard: a convex summand is at most its mean over the unit interval about it.
        whole = ((Y - self.g / 2) ** (1 - m) - late) / ((m - 1) * self.g)
        return plain.min(whole.upper())


def turning_bounds(
    alphas: Sequence[ExactReal], order: int, epsilons: Sequence[arb], start: arb | None = None, bits: int = BITS
) -> TurningBounds:
    """The bounds for strengths epsilon_i >= 0 of exponents alpha_i >= 1.

    ``start``: a bound of |ln A_0|, where the motion does not start at A = 1 exactly as the truncated equations do;
    ``bits``: the precision of the coefficients.
    InputError for an exponent below 1, where errors need not fade; LimitError above delta_max.
    """
    if any(a < 1 for a in alphas):
        raise InputError("alpha", f"{min(alphas)} is below 1", "exponents >= 1 for a bound at all times")
    local = local_bounds(alphas, order, bits)
    with ctx.workprec(BITS):
        weights = [a.ball() - 1 for a in alphas]
        slowest, fastest = least(weights), greatest(weights)
        e = arb(0) if start is None else arb(start.upper())
        # An uncertain start may have the larger strengths; all bounds are taken at those.
        total, swell = sum(epsilons, arb(0)), (fastest * e).exp()
        delta = arb((total * swell).upper())
        if not (delta > 0 and delta <= local.limit):
            reason = f"sum epsilon_i = {delta.str(3, radius=False)} is not in the range of the theorem"
            raise LimitError("epsilon", reason, f"0 < sum epsilon_i <= {float(local.delta_max):g} at order {order}")
        low, high = rates(local.flow.p.truncate(order), local.flow.Omega.truncate(order), delta)
        # The truncated amplitude must fall: 1/|delta_hat| grows by g > 0, or the sums along the orbit mean nothing.
        if not (low > 0 and high > 0):
            raise LimitError("epsilon", f"order {order} may lose its sign at delta = {delta.str(3)}", "weaker damping")
        g, G = (slowest * arb.pi() * low).lower(), (fastest * arb.pi() * high).upper()
        C_A, C_T = local.amplitude.constant(delta), local.duration.constant(delta)
        fading = arb(0)
        if len(alphas) == 1 and slowest > 0:
            fading = (slowest * _steepness(local, delta)).lower()
        B, widening = sensitivity(local, delta), (delta * swell / total).upper()
    return TurningBounds(local, delta, C_A, C_T, slowest, fastest, arb(g), arb(G), arb(fading), B, e, widening)


def rates(p: Series, Omega: Series, delta: arb) -> tuple[arb, arb]:
    """The infimum and supremum of p_N/(|delta| (1 + Omega_N)) over 0 < |delta| <= ``delta``."""
    first = [arb(c) for k, c in p.coefficients.items() if sum(k) == 1]
    rest = largest(Series({k: c for k, c in p.coefficients.items() if sum(k) > 1}, p.variables, p.order), delta) / delta
    swing = largest(Omega, delta)
    # sum_i c_i delta_i is between the least and the largest c_i times |delta|; the higher degrees and Omega count
    # against it with their absolute values.
    low = (reduce(arb.min, first) - rest) / (1 + swing)
    return arb(low.lower()), arb(((reduce(arb.max, first) + rest) / (1 - swing)).upper())


def _steepness(local: LocalBounds, delta: arb) -> arb:
    """A lower bound of -L'(delta) on (0, delta] (one law): the first coefficient against all others, Cauchy beyond."""
    L = local.half.L
    others = sum((abs(c) * k * delta ** (k - 1) for (k,), c in L.coefficients.items() if k > 1), arb(0))
    return arb(
        (-L[1] - others - _beyond(local.amplitude.cauchy, local.amplitude.radius, L.order, delta) / delta).lower()
    )


def sensitivity(local: LocalBounds, delta: arb) -> arb:
    """A bound of sum_i |delta_i d T/d delta_i|/|delta|^2 for |delta| <= ``delta``."""
    T = local.half.T.without_constant()
    first = [c for k, c in T.coefficients.items() if sum(k) == 1]
    if not all(arb(c).contains(0) for c in first):
        raise ArithmeticError(f"T begins with degree 1: {first}")
    known = sum((abs(c) * sum(k) * delta ** (sum(k) - 2) for k, c in T.coefficients.items() if sum(k) > 1), arb(0))
    return arb((known + _beyond(local.duration.cauchy, local.duration.radius, T.order, delta) / delta**2).upper())


def _beyond(M: arb, rho: arb, order: int, delta: arb) -> arb:
    """The sum of k M x^k over k > order, x = delta/rho."""
    x = delta / rho
    J = order + 1
    # x d/dx of the geometric series from x^J on.
    return M * x**J * (J - (J - 1) * x) / (1 - x) ** 2


def largest(f: Series, delta: arb) -> arb:
    """A bound of |f| for |delta| <= ``delta``: each degree by its largest coefficient over the multinomial one."""
    return sum((abs(arb(c)) * delta ** sum(k) for k, c in f.coefficients.items()), arb(0))
