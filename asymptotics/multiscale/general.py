"""The classical route for any exponents alpha_i >= 0, symbols or numbers: amplitude and phase to second order.

Order 1 with the Fourier series of ``harmonics`` (b_n of alpha_i), p_i = M_(alpha_i + 1):

    X_1'' + X_1 = 2 f_1 sin psi + 2 a g_1 cos psi + sum_i epsilon_i a^alpha_i sum_n b_n sin n psi,
    f_1 = -sum_i epsilon_i p_i a^alpha_i,  g_1 = 0,  X_1 = -sum_i epsilon_i a^alpha_i sum_(n>=3) b_n/(n^2-1) sin n psi.

Order 2.  The force gives S'(V_0) V_1 with S(V) = V|V|^(alpha-1), V_0 = -a sin psi, V_1 = d X_1/d psi + f_1 cos psi.
Its projection on cos psi needs no |sin|^(alpha-1): S'(V_0) d V_0/d psi is d S/d psi, so with d V_0/d psi = -a cos psi

    2 <S'(V_0) cos psi cos n psi> = n b_n a^(alpha-1).

That is right at alpha = 0 too, where S' = 2 delta(V): in the sense of distributions, every harmonic keeps its weight.
Hence, for the part of g_2 with epsilon_i epsilon_j,

    (1/2) alpha_j p_i p_j - p_i p_j - (1/2) sum_(n>=3) n^2 b_n^(i) b_n^(j)/(n^2-1),

and the sum over harmonics is closed (``harmonics``).  f_2 = 0 by parity.  No first harmonic; the other gauges have
Omega_2 - sum_ij c_i (alpha_i - 1) p_j with psi_g = psi + sum_i c_i delta_i: c_i = p_i/2 for averaging, and for
turning-point c_i = (alpha_i + 3)/(2 (alpha_i + 1)) p_i, which is minus the phase at which X' = 0.

>>> from sympy import Integer
>>> result = second_order((Integer(2),))
>>> result.amplitude_rate, result.phase_rate
(-4*a**2*epsilon/(3*pi), a**2*epsilon**2*(-1/6 + 40/(27*pi**2)) + 1)
>>> result.half_period[(2,)], result.log_ratio[(2,)]           # observable: pi/6 and 8/9, as Smith's exact map has it
(pi/6, 8/9)
>>> second_order((Integer(0),)).Omega()[(2,)]                  # without the delta function it would be 0
-6/pi**2
"""

from dataclasses import dataclass, field

from sympy import (
    Abs,
    Add,
    Derivative,
    DiracDelta,
    Eq,
    Expr,
    Float,
    Integer,
    Rational,
    Sum,
    Symbol,
    cos,
    factor,
    latex,
    oo,
    pi,
    sign,
    sin,
)

from asymptotics.errors import InputError
from asymptotics.gauges import AVERAGING, NO_FIRST_HARMONIC, require_gauge
from asymptotics.moments.symbolic import moment
from asymptotics.multiscale.exact import GAUGE
from asymptotics.multiscale.harmonics import harmonic_closed_form, turning_sum
from asymptotics.multiscale.orders import (
    Order,
    a,
    epsilon,
    general_force,
    law_symbols,
    leading_order,
    monomial,
    operator_equation,
    psi,
    rate_symbols,
    solution_symbol,
    velocity_equation,
)
from asymptotics.series import Key, monomials

_j = Symbol("j", integer=True, positive=True)


@dataclass(frozen=True, repr=False)
class SecondOrder:
    """The laws through second order for any exponents; ``orders`` shows orders 0, 1, 2 (X_2 itself is not needed)."""

    alphas: tuple[Expr, ...]
    orders: tuple[Order, ...]
    gauge: str = GAUGE
    notes: tuple[str, ...] = field(default=(), compare=False)

    @property
    def p(self) -> tuple[Expr, ...]:
        """p_i = M_(alpha_i + 1), the same in every gauge."""
        return tuple(moment(alpha + 1) for alpha in self.alphas)

    def Omega(self, gauge: str = NO_FIRST_HARMONIC) -> dict[Key, Expr]:
        """The second-order frequency in any gauge: exponent (n_0, n_1, ...) of the delta_i -> coefficient."""
        require_gauge(gauge)
        pairs = {(i, j): self._omega(i, j, gauge) for i in range(len(self.alphas)) for j in range(len(self.alphas))}
        return self._by_key(pairs)

    @property
    def turning_phase(self) -> tuple[Expr, ...]:
        """psi_0 = sum_i (these) delta_i is the phase of a turning point, to first order."""
        return tuple(-p - turning_sum(alpha) for p, alpha in zip(self.p, self.alphas))

    @property
    def initial_phase(self) -> Expr:
        """psi(0) for X(0) = 1, X'(0) = 0, to first order; a(0) = 1 + O(epsilon^2)."""
        return Add(*[c * e for c, e in zip(self.turning_phase, law_symbols(len(self.alphas)))])

    @property
    def amplitude_rate(self) -> Expr:
        """da/d tau through second order (the second-order term is 0)."""
        symbols = law_symbols(len(self.alphas))
        return -Add(*[e * p * a**alpha for e, p, alpha in zip(symbols, self.p, self.alphas)])

    @property
    def phase_rate(self) -> Expr:
        """d psi/d tau through second order."""
        return 1 + _step(self.alphas, 2) * self.orders[2].solvability[1].rhs

    @property
    def log_ratio(self) -> dict[Key, Expr]:
        """ln(A_(n+1)/A_n) through second order, in the delta_i at a turning point: observable."""
        first = {k: -pi * p for k, p in zip(monomials(len(self.alphas), 1)[::-1], self.p)}
        laws = list(enumerate(zip(self.alphas, self.p)))
        pairs = {(i, j): pi**2 / 2 * (x - 1) * p * q for i, (x, p) in laws for j, (_, q) in laws}
        return {**first, **self._by_key(pairs)}

    @property
    def half_period(self) -> dict[Key, Expr]:
        """The time between turning points minus pi, through second order: -pi Omega_2 in the turning-point gauge."""
        return {k: -pi * c for k, c in self.Omega("turning-point").items()}

    def _omega(self, i: int, j: int, gauge: str) -> Expr:
        """Half of (i, j) plus half of (j, i): alpha_i alpha_j M/(...) and rational * p_i p_j."""
        x, y, p, q = self.alphas[i], self.alphas[j], self.p[i], self.p[j]
        below = (x + 1) * (y + 1)
        products = (x + y) / 4 - 1 - (1 - x - y - 3 * x * y) / (2 * below)
        products -= (_lead(x, gauge) * (x - 1) + _lead(y, gauge) * (y - 1)) / 2
        return -x * y / below * moment(x + y) + factor(products) * p * q

    def _by_key(self, pairs: dict[tuple[int, int], Expr]) -> dict[Key, Expr]:
        """Sum over ordered pairs (i, j) with delta_i delta_j = delta^key."""
        found: dict[Key, Expr] = {}
        for (i, j), value in pairs.items():
            key = tuple((k == i) + (k == j) for k in range(len(self.alphas)))
            found[key] = found.get(key, Integer(0)) + value
        return found

    def __repr__(self) -> str:
        return f"SecondOrder(alpha = {', '.join(map(str, self.alphas))}, orders 0 to 2, gauge {self.gauge})"

    def _repr_latex_(self) -> str:
        rates = rf"\frac{{da}}{{d\tau}} = {latex(self.amplitude_rate)},\quad \frac{{d\psi}}{{d\tau}} = "
        return rf"${rates}{latex(self.phase_rate)}\quad\text{{({self.gauge})}}$"


def second_order(alphas: tuple[Expr, ...]) -> SecondOrder:
    """X'' + X + sum_i epsilon_i X'|X'|^(alpha_i - 1) = 0 to second order, alpha_i symbols or exact numbers >= 0.

    Raises InputError for a negative, complex or inexact exponent, or none.
    """
    require_exponents(alphas)
    bare = SecondOrder(alphas, ())
    g_2 = Add(*[c * monomial(alphas, k, 0) for k, c in bare.Omega().items()])
    return SecondOrder(alphas, (leading_order(GAUGE), _first(alphas), _second(alphas, g_2)))


def require_exponents(alphas: tuple[Expr, ...]) -> None:
    """InputError unless every exponent is an exact real number >= 0 or a symbol that may be one."""
    accepted = "exact numbers >= 0 or symbols declared nonnegative"
    if not alphas:
        raise InputError("alpha", "no exponent is given", accepted)
    for alpha in alphas:
        if not isinstance(alpha, Expr) or alpha.has(Float):
            raise InputError("alpha", f"{alpha!r} is not exact", accepted)
        if alpha.is_nonnegative is not True:
            raise InputError("alpha", f"{alpha} is not known to be >= 0", accepted)


def _lead(alpha: Expr, gauge: str) -> Expr:
    """c/p in psi_g = psi + c delta."""
    if gauge == NO_FIRST_HARMONIC:
        return Integer(0)
    return Rational(1, 2) if gauge == AVERAGING else (alpha + 3) / (2 * (alpha + 1))


def _step(alphas: tuple[Expr, ...], n: int) -> Expr:
    """epsilon^n for one law; several laws carry their own symbols."""
    return epsilon**n if len(alphas) == 1 else Integer(1)


def _laws(alphas: tuple[Expr, ...]) -> list[tuple[Expr, Expr]]:
    """(strength, exponent) of each law at one order."""
    return list(zip((Integer(1),) if len(alphas) == 1 else law_symbols(len(alphas)), alphas))


def _first(alphas: tuple[Expr, ...]) -> Order:
    """Order 1: the first harmonic of the force gives f_1, the others X_1."""
    (f, g), X_1, n = rate_symbols(1), solution_symbol(1), 2 * _j + 1
    laws = _laws(alphas)
    drive = Add(*[e * a**x * Abs(sin(psi)) ** x * sign(sin(psi)) for e, x in laws])
    first = Add(*[2 * e * moment(x + 1) * a**x for e, x in laws])
    terms = [e * a**x * harmonic_closed_form(x, n) / (n**2 - 1) for e, x in laws]
    return Order(
        1,
        operator_equation(1, general_force(alphas, 1)),
        velocity_equation(0),
        Eq(Derivative(X_1, (psi, 2)) + X_1, 2 * f * sin(psi) + 2 * a * g * cos(psi) + drive, evaluate=False),
        (2 * f + first, 2 * a * g),
        (Eq(f, -first / 2, evaluate=False), Eq(g, Integer(0), evaluate=False)),
        Eq(X_1, -Add(*[Sum(t * sin(n * psi), (_j, 1, oo)) for t in terms]), evaluate=False),
        GAUGE,
    )


def _second(alphas: tuple[Expr, ...], g_2: Expr) -> Order:
    """Order 2: only the coefficient of cos psi is needed; the sum over harmonics stands open in ``secular``."""
    (f, g), X_2, n = rate_symbols(2), solution_symbol(2), 2 * _j + 1
    laws = _laws(alphas)
    f_1 = -Add(*[e * moment(x + 1) * a**x for e, x in laws])
    V_1 = f_1 * cos(psi)
    for e, x in laws:
        V_1 -= e * a**x * Sum(n * harmonic_closed_form(x, n) / (n**2 - 1) * cos(n * psi), (_j, 1, oo))
    slow = -_squared_rate(alphas) * cos(psi)
    for e, x in laws:  # -2 D_1 d X_1/d psi
        slope = Add(*[-2 * e * h * x * moment(y + 1) * a ** (x + y - 1) for h, y in laws])
        slow += slope * Sum(n * harmonic_closed_form(x, n) / (n**2 - 1) * cos(n * psi), (_j, 1, oo))
    force = Add(*[e * _slope(x) for e, x in laws]) * V_1
    right = 2 * f * sin(psi) + 2 * a * g * cos(psi) + slow - force
    return Order(
        2,
        operator_equation(2, general_force(alphas, 2)),
        velocity_equation(1),
        Eq(Derivative(X_2, (psi, 2)) + X_2, right, evaluate=False),
        (2 * f, 2 * a * g - _squared_rate(alphas) + _projected_force(alphas)),
        (Eq(f, Integer(0), evaluate=False), Eq(g, g_2, evaluate=False)),
        None,
        GAUGE,
    )


def _squared_rate(alphas: tuple[Expr, ...]) -> Expr:
    """f_1 df_1/da, the coefficient of cos psi in D_1 D_1 X_0."""
    pairs = [(e * h, x, y) for e, x in _laws(alphas) for h, y in _laws(alphas)]
    return Add(*[f * y * moment(x + 1) * moment(y + 1) * a ** (x + y - 1) for f, x, y in pairs])


def _slope(x: Expr) -> Expr:
    """S'(V_0) = alpha |a sin psi|^(alpha-1); at alpha = 0 the delta function 2 delta(a sin psi)."""
    return 2 * DiracDelta(a * sin(psi)) if x.is_zero else x * a ** (x - 1) * Abs(sin(psi)) ** (x - 1)


def _projected_force(alphas: tuple[Expr, ...]) -> Expr:
    """-2 <S'(V_0) V_1 cos psi> = sum_ij a^(alpha_i+alpha_j-1) [2 p_i p_j + sum n^2 b_n^(i) b_n^(j)/(n^2-1)]."""
    total, n = Integer(0), 2 * _j + 1
    for e, x in _laws(alphas):
        for h, y in _laws(alphas):
            summand = n**2 * harmonic_closed_form(x, n) * harmonic_closed_form(y, n) / (n**2 - 1)
            inner = 2 * moment(x + 1) * moment(y + 1) + Sum(summand, (_j, 1, oo))
            total += e * h * a ** (x + y - 1) * inner
    return total
