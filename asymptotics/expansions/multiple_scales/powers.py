"""Losses and springs that are powers, and what the second order of the hierarchy gives for them, in closed form.

    X'' + X + sum_i epsilon_i X'|X'|^(alpha_i-1) + sum_j c_j X|X|^(p_j-1) = 0,    rho_i = epsilon_i a^(alpha_i-1),
                                                                               gamma_j = c_j a^(p_j-1),

da/d tau = -a p(rho, gamma), d psi/d tau = 1 + Omega(rho, gamma), gauge no-first-harmonic.  With P_i = M_(alpha_i+1),
Q_j = M_(p_j+1) and the sums of ``harmonics``, the second-order parts are (derivations ``multiple-scales-general`` and
``multiple-scales-springs``)

    p:      rho_i gamma_j    P_i Q_j [alpha_i - (p_j+1)/2] + (1/2) (alpha_i+1) sum n b_n d_n/(n^2-1),
    Omega:  rho_i rho_j      (alpha_j/2 - 1) P_i P_j - (1/2) sum n^2 b_n^(i) b_n^(j)/(n^2-1),
            gamma_j gamma_k  -(1/2) Q_j Q_k + (1/2) p_j sum d_n^(j) d_n^(k)/(n^2-1).

*Another gauge* is A = a (1 + sum lambda_j gamma_j), psi_g = psi + sum chi_i rho_i to first order, so that, w = d - 1,

    p_ij gains P_i (w_j - w_i) lambda_j,    Omega_ij loses chi_i w_i P_j (losses) and Q_j w_j lambda_k (springs):

chi = P/2 and lambda = Q/2 for averaging; turning-point: chi is minus the phase where X' = 0, and lambda = X_1/a^p at
psi = 0, the sum d_n/(n^2-1).

>>> from sympy import Integer
>>> forces = Powers((Integer(2),), (Term(1, 0, 3, "position"),))
>>> forces.p("turning-point")[1, 1]
-1/(30*pi)
"""

from dataclasses import dataclass

from sympy import Expr, Integer, Rational, factor

from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.expansions.moments.symbolic import mean, moment
from asymptotics.expansions.multiple_scales.harmonics import displacement_sum, spring_sum
from asymptotics.gauges import AVERAGING, NO_FIRST_HARMONIC, require_gauge
from asymptotics.numbers.bridge import to_sympy
from asymptotics.numbers.context import cached_property
from asymptotics.series import Key, unit_key
from asymptotics.terms import Term

Closed = dict[Key, Expr]


@dataclass(frozen=True)
class Power:
    """ratio * strength^key * v|v|^(exponent-1) (sign -1) or ratio * strength^key * x|x|^(exponent-1) (sign +1)."""

    key: Key
    ratio: Expr
    exponent: Expr
    sign: int

    @property
    def mean(self) -> Expr:
        """ratio * M_(exponent+1): its first harmonic is twice that."""
        return self.ratio * moment(self.exponent + 1)

    @property
    def weight(self) -> Expr:
        """exponent - 1, the power of the amplitude in the local strength."""
        return self.exponent - 1


@dataclass(frozen=True)
class Powers:
    """Losses v|v|^(alpha-1), alpha symbols or exact numbers, and springs; keys count losses, then springs."""

    alphas: tuple[Expr, ...]
    springs: tuple[Term, ...] = ()

    @cached_property
    def members(self) -> tuple[Power, ...]:
        """Every power of v and x through second order: a pendulum has two."""
        zeros = (0,) * len(self.alphas)
        found = [Power(unit_key(i, self.variables), Integer(1), x, -1) for i, x in enumerate(self.alphas)]
        for m in Forces.of(self.springs, 2).through(2) if self.springs else ():
            found.append(Power((*zeros, *m.key), to_sympy(m.ratio), Integer(m.position), 1))
        return tuple(found)

    @property
    def variables(self) -> int:
        """The number of strengths."""
        return len(self.alphas) + len(self.springs)

    def part(self, order: int, sign: int = 0) -> tuple[Power, ...]:
        """The members of one order, of both signs or of one."""
        return tuple(m for m in self.members if sum(m.key) == order and sign in (0, m.sign))

    def p(self, gauge: str = NO_FIRST_HARMONIC) -> Closed:
        """p through second order in a gauge."""
        require_gauge(gauge)
        found = {m.key: m.mean for m in self.part(1, -1)}
        for x in self.part(1, -1):
            for y in self.part(1, 1):
                # A = a (1 + lambda_j gamma_j): the strength of the loss is w_i lambda_j less in terms of A, and the
                # stretch falls with the amplitude, w_j lambda_j more.
                shift = x.mean * (y.weight - x.weight) * _stretch(y, gauge)
                _add(found, x, y, _cross(x, y) + shift)
        return found

    def Omega(self, gauge: str = NO_FIRST_HARMONIC) -> Closed:
        """Omega through second order in a gauge."""
        require_gauge(gauge)
        found = {m.key: m.mean for m in self.members if m.sign > 0}
        for sign in (-1, 1):
            for x in self.part(1, sign):
                # Ordered pairs: a mixed term comes twice, which is its coefficient in the square of the sum.
                for y in self.part(1, sign):
                    _add(found, x, y, _losses(x, y, gauge) if sign < 0 else _two_springs(x, y, gauge))
        return found


def _add(found: Closed, x: Power, y: Power, value: Expr) -> None:
    key = tuple(a + b for a, b in zip(x.key, y.key))
    found[key] = found.get(key, Integer(0)) + value


def _cross(x: Power, y: Power) -> Expr:
    """The second-order part of p of a loss alpha with a spring p, the sum over harmonics closed by ``cross_sum``."""
    a, p = x.exponent, y.exponent
    products = (a * (p + 3) - (p - 1) * (p + 2)) / (2 * (p + 1)) * moment(p + 1)
    rest = p / (p + 1) * mean(p - 1, a + 1)
    P = moment(a + 1)
    return x.ratio * y.ratio * P * factor(products - rest / P)


def _losses(x: Power, y: Power, gauge: str) -> Expr:
    """Half of (x, y) plus half of (y, x): alpha_i alpha_j M/(...) and rational * P_i P_j."""
    a, b = x.exponent, y.exponent
    # Half of the sums for (x, y) and for (y, x), with ``velocity_sum`` put in: the moment of a + b, and products.
    below = (a + 1) * (b + 1)
    products = (a + b) / 4 - 1 - (1 - a - b - 3 * a * b) / (2 * below)
    products -= (_lead(a, gauge) * (a - 1) + _lead(b, gauge) * (b - 1)) / 2
    return -a * b / below * moment(a + b) + factor(products) * x.mean * y.mean


def _two_springs(x: Power, y: Power, gauge: str) -> Expr:
    """-Q_j Q_k/2 + p_j/2 sum d_n^(j) d_n^(k)/(n^2-1), less what the gauge takes."""
    own = x.ratio * y.ratio * x.exponent * spring_sum(x.exponent, y.exponent) - x.mean * y.mean
    return own / 2 - x.mean * x.weight * _stretch(y, gauge)


def _lead(alpha: Expr, gauge: str) -> Expr:
    """chi/P, by which a loss turns the phase of a gauge, to first order."""
    if gauge == NO_FIRST_HARMONIC:
        return Integer(0)
    # X' = 0 at psi_0 = -rho (P + sum n b_n/(n^2-1)), the second sum of ``harmonics``; chi takes that phase away.
    return Rational(1, 2) if gauge == AVERAGING else (alpha + 3) / (2 * (alpha + 1))


def _stretch(spring: Power, gauge: str) -> Expr:
    """lambda, by which a spring stretches the amplitude of a gauge, to first order."""
    if gauge == NO_FIRST_HARMONIC:
        return Integer(0)
    return spring.mean / 2 if gauge == AVERAGING else spring.ratio * displacement_sum(spring.exponent)
