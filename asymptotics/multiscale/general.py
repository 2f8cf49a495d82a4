"""The classical route for any exponents alpha_i >= 0, symbols or numbers, and springs: amplitude and phase to order 2.

Order 1 with the Fourier series of ``harmonics`` (b_n of alpha_i, d_n of p_j), P_i = M_(alpha_i+1), Q_j = M_(p_j+1):

    X_1'' + X_1 = 2 f_1 sin psi + 2 a g_1 cos psi + sum_i epsilon_i a^alpha_i sum_n b_n sin n psi
                                                  - sum_j c_j a^p_j sum_n d_n cos n psi,
    f_1 = -sum_i epsilon_i P_i a^alpha_i,      g_1 = sum_j c_j Q_j a^(p_j-1),
    X_1 = -sum_i epsilon_i a^alpha_i sum_(n>=3) b_n/(n^2-1) sin n psi
          + sum_j c_j a^p_j sum_(n>=3) d_n/(n^2-1) cos n psi.

Order 2.  The forces give S'(V_0) V_1 + R'(X_0) X_1 with S(V) = V|V|^(alpha-1), R(X) = X|X|^(p-1), X_0 = a cos psi,
V_0 = -a sin psi and V_1 = d X_1/d psi + f_1 cos psi - a g_1 sin psi.  Their projections need no |sin|^(alpha-1): by
d S/d psi = S'(V_0) d V_0/d psi and V S' = alpha S, and likewise for R,

    2 <S'(V_0) cos psi cos n psi> = n b_n a^(alpha-1),      2 <S'(V_0) sin psi sin n psi> = alpha b_n a^(alpha-1),
    2 <R'(X_0) sin psi sin n psi> = n d_n a^(p-1),          2 <R'(X_0) cos psi cos n psi> = p d_n a^(p-1).

That is right at alpha = 0 too, where S' = 2 delta(V): in the sense of distributions, every harmonic keeps its weight.
The sums over harmonics are closed (``harmonics``); what they give is in ``powers``.  f_2 has the terms with one loss
and one spring, g_2 those with two losses or two springs.  No first harmonic; the other gauges are in ``powers`` too.

>>> from sympy import Integer
>>> result = second_order((Integer(2),))
>>> result.amplitude_rate, result.phase_rate
(-4*a**2*epsilon/(3*pi), a**2*epsilon**2*(-1/6 + 40/(27*pi**2)) + 1)
>>> result.half_period[(2,)], result.log_ratio[(2,)]           # observable: pi/6 and 8/9, as Smith's exact map has it
(pi/6, 8/9)
>>> second_order((Integer(0),)).Omega()[(2,)]                  # without the delta function it would be 0
-6/pi**2
>>> second_order((Integer(2),), (Term(1, 0, 3, "position"),)).amplitude_rate
3*a**4*c*epsilon/(40*pi) - 4*a**2*epsilon/(3*pi)
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
    Mul,
    cos,
    diff,
    expand,
    latex,
    sign,
    sin,
)

from asymptotics.errors import InputError
from asymptotics.gauges import NO_FIRST_HARMONIC
from asymptotics.moments.symbolic import moment
from asymptotics.multiscale.exact import GAUGE
from asymptotics.multiscale.harmonics import N, cosine_closed_form, harmonic_closed_form, harmonic_sum
from asymptotics.multiscale.orders import (
    Order,
    a,
    general_force,
    leading_order,
    operator_equation,
    psi,
    rate_symbols,
    solution_symbol,
    symbols_of,
    velocity_equation,
)
from asymptotics.multiscale.powers import Closed, Power, Powers
from asymptotics.series import Key
from asymptotics.terms import Term


@dataclass(frozen=True, repr=False)
class SecondOrder:
    """The laws through second order for any exponents; ``orders`` shows orders 0, 1, 2 (X_2 itself is not needed)."""

    forces: Powers
    orders: tuple[Order, ...]
    gauge: str = GAUGE
    notes: tuple[str, ...] = field(default=(), compare=False)

    @property
    def alphas(self) -> tuple[Expr, ...]:
        """The exponents of the losses."""
        return self.forces.alphas

    @property
    def symbols(self) -> tuple[Expr, ...]:
        """The strengths: epsilon or epsilon_i, c or c_j, and theta_0^2 for a pendulum with x in units of theta_0."""
        return symbols_of(len(self.alphas), self.forces.springs)

    @property
    def p(self) -> tuple[Expr, ...]:
        """p_i = M_(alpha_i + 1), the same in every gauge."""
        return tuple(moment(alpha + 1) for alpha in self.alphas)

    def amplitude(self, gauge: str = NO_FIRST_HARMONIC) -> Closed:
        """p through second order in any gauge: exponent (n_0, n_1, ...) of the strengths -> coefficient."""
        return self.forces.p(gauge)

    def Omega(self, gauge: str = NO_FIRST_HARMONIC) -> Closed:
        """The frequency correction through second order in any gauge, like ``amplitude``."""
        return self.forces.Omega(gauge)

    @property
    def turning_phase(self) -> tuple[Expr, ...]:
        """psi_0 = sum_i (these) delta_i is the phase of a turning point, to first order."""
        return self.forces.turning_phase()

    @property
    def initial_phase(self) -> Expr:
        """psi(0) for X(0) = 1, X'(0) = 0, to first order."""
        return Add(*[c * e for c, e in zip(self.turning_phase, self.symbols)])

    @property
    def initial_amplitude(self) -> Expr:
        """a(0) for X(0) = 1, X'(0) = 0, to first order: 1 without springs."""
        return 1 - Add(*[c * _strength(self.symbols, key) for key, c in self.forces.turning_amplitude().items()])

    @property
    def amplitude_rate(self) -> Expr:
        """da/d tau through second order."""
        return -self._sum(self.amplitude(), 1)

    @property
    def phase_rate(self) -> Expr:
        """d psi/d tau through second order."""
        return 1 + self._sum(self.Omega(), 0)

    @property
    def log_ratio(self) -> Closed:
        """ln(A_(n+1)/A_n) through second order, in the delta_i at a turning point: observable."""
        return self.forces.log_ratio()

    @property
    def half_period(self) -> Closed:
        """The time between turning points minus pi, through second order: observable."""
        return self.forces.half_period()

    def _sum(self, closed: Closed, power: int) -> Expr:
        terms = (c * _monomial(self.forces, key, power) * _strength(self.symbols, key) for key, c in closed.items())
        return Add(*terms)

    def __repr__(self) -> str:
        springs = "".join(f", {t.shape()}" for t in self.forces.springs)
        return f"SecondOrder(alpha = {', '.join(map(str, self.alphas))}{springs}, orders 0 to 2, gauge {self.gauge})"

    def _repr_latex_(self) -> str:
        rates = rf"\frac{{da}}{{d\tau}} = {latex(self.amplitude_rate)},\quad \frac{{d\psi}}{{d\tau}} = "
        return rf"${rates}{latex(self.phase_rate)}\quad\text{{({self.gauge})}}$"


def second_order(alphas: tuple[Expr, ...], springs: tuple[Term, ...] = ()) -> SecondOrder:
    """X'' + X + sum_i epsilon_i X'|X'|^(alpha_i-1) + springs = 0 to second order, alpha_i symbols or exact, >= 0.

    ``springs``: terms c x|x|^(p-1), or a pendulum.  Raises InputError for a negative, complex or inexact exponent, for
    a spring that depends on the velocity, and for no force at all.
    """
    require_exponents(alphas, springs)
    forces = Powers(alphas, springs)
    display = _Display(forces, symbols_of(len(alphas), springs))
    return SecondOrder(forces, (leading_order(GAUGE), display.first(), display.second()))


def require_exponents(alphas: tuple[Expr, ...], springs: tuple[Term, ...] = ()) -> None:
    """InputError unless every exponent is an exact real number >= 0 or a symbol that may be one."""
    accepted = "exact numbers >= 0 or symbols declared nonnegative"
    if not alphas and not springs:
        raise InputError("alpha", "no exponent is given", accepted)
    for alpha in alphas:
        if not isinstance(alpha, Expr) or alpha.has(Float):
            raise InputError("alpha", f"{alpha!r} is not exact", accepted)
        if alpha.is_nonnegative is not True:
            raise InputError("alpha", f"{alpha} is not known to be >= 0", accepted)
    for t in springs:
        if t.sign < 0 or not t.velocity.is_zero:
            raise InputError("spring", f"{t.shape()} is no spring of the position alone", "c x|x|^(P-1), a pendulum")


def _strength(symbols: tuple[Expr, ...], key: Key) -> Expr:
    return Mul(*[s**n for s, n in zip(symbols, key)])


def _monomial(forces: Powers, key: Key, power: int) -> Expr:
    """a^power times the amplitude's share of the local strengths."""
    weights = [x - 1 for x in forces.alphas] + [Integer(int(t.weight.rational)) for t in forces.springs]
    return a ** Add(power, *[n * w for n, w in zip(key, weights)])


@dataclass(frozen=True)
class _Display:
    """Orders 1 and 2 as SymPy expressions; of one strength epsilon^n or c^n is taken out."""

    forces: Powers
    symbols: tuple[Expr, ...]

    def scaled(self, *members: Power) -> Expr:
        """The product of the strengths of some members, ratios included."""
        found = Mul(*[m.ratio for m in members])
        return found if self.forces.variables == 1 else found * Mul(*[_strength(self.symbols, m.key) for m in members])

    def rates(self) -> tuple[Expr, Expr]:
        """f_1 = D_1 a and g_1 = D_1 psi."""
        losses, springs = (self.forces.part(1, s) for s in (-1, 1))
        f = Add(*[self.scaled(x) * moment(x.exponent + 1) * a**x.exponent for x in losses])
        return -f, Add(*[self.scaled(y) * moment(y.exponent + 1) * a**y.weight for y in springs])

    def first_solution(self) -> Expr:
        """X_1, its harmonics from the third on."""
        total = Integer(0)
        for x in self.forces.part(1):
            harmonic, wave = (harmonic_closed_form, sin) if x.sign < 0 else (cosine_closed_form, cos)
            waves = harmonic_sum(harmonic(x.exponent, N) / (N**2 - 1) * wave(N * psi), x.exponent)
            total += x.sign * self.scaled(x) * a**x.exponent * waves
        return total

    def first(self) -> Order:
        """Order 1: the first harmonics of the forces give f_1 and g_1, the others X_1."""
        (f, g), X_1, (f_1, g_1) = rate_symbols(1), solution_symbol(1), self.rates()
        drive = -Add(*[self.scaled(x) * _force(x) for x in self.forces.part(1)])
        return Order(
            1,
            operator_equation(1, general_force(self.forces.members, self.scaled, 1)),
            velocity_equation(0),
            Eq(Derivative(X_1, (psi, 2)) + X_1, 2 * f * sin(psi) + 2 * a * g * cos(psi) + drive, evaluate=False),
            (2 * f - 2 * f_1, 2 * a * g - expand(2 * a * g_1)),
            (Eq(f, f_1, evaluate=False), Eq(g, g_1, evaluate=False)),
            Eq(X_1, self.first_solution(), evaluate=False),
            GAUGE,
        )

    def second(self) -> Order:
        """Order 2: only the first harmonics are needed; their sums stand open in ``secular``."""
        (f, g), X_2, (f_1, g_1), X_1 = rate_symbols(2), solution_symbol(2), self.rates(), self.first_solution()
        turned = f_1 * cos(psi) - a * g_1 * sin(psi)  # D_1 X_0
        V_1 = turned + diff(X_1, psi)
        slow = -(f_1 * diff(turned, a) + g_1 * diff(turned, psi))
        fast = diff(X_1, psi)
        slow -= 2 * f_1 * diff(fast, a) + 2 * g_1 * diff(fast, psi)
        force = Add(*[self.scaled(x) * _slope(x) * (V_1 if x.sign < 0 else X_1) for x in self.forces.part(1)])
        force += Add(*[self.scaled(x) * _force(x) for x in self.forces.part(2)])
        right = 2 * f * sin(psi) + 2 * a * g * cos(psi) + slow - force
        (sine, cosine), (f_2, g_2) = self.projections(f_1, g_1), self.solved()
        return Order(
            2,
            operator_equation(2, general_force(self.forces.members, self.scaled, 2)),
            velocity_equation(1),
            Eq(Derivative(X_2, (psi, 2)) + X_2, right, evaluate=False),
            (2 * f + sine, 2 * a * g + cosine),
            (Eq(f, f_2, evaluate=False), Eq(g, g_2, evaluate=False)),
            None,
            GAUGE,
        )

    def solved(self) -> tuple[Expr, Expr]:
        """f_2 and g_2 from the closed sums of ``powers``."""
        rates = []
        for closed, power in ((self.forces.p(), 1), (self.forces.Omega(), 0)):
            terms = {key: c for key, c in closed.items() if sum(key) == 2}
            unit = self.forces.variables == 1
            strength = {key: Integer(1) if unit else _strength(self.symbols, key) for key in terms}
            rates.append(Add(*[c * _monomial(self.forces, k, power) * strength[k] for k, c in terms.items()]))
        return -rates[0], rates[1]

    def projections(self, f_1: Expr, g_1: Expr) -> tuple[Expr, Expr]:
        """The coefficients of sin psi and cos psi in the right side at order 2, without those of f_2 and g_2."""
        sine = expand(f_1 * (diff(a * g_1, a) + g_1))
        cosine = -f_1 * diff(f_1, a) + expand(a * g_1**2)
        losses, springs = (self.forces.part(1, s) for s in (-1, 1))
        for x in losses:
            for y in losses:
                cosine += self.scaled(x, y) * a ** (x.exponent + y.weight) * _two_losses(x, y)
            for y in springs:
                sine += self.scaled(x, y) * a ** (x.exponent + y.weight) * _loss_and_spring(x, y)
        for x in springs:
            for y in springs:
                summand = cosine_closed_form(x.exponent, N) * cosine_closed_form(y.exponent, N) / (N**2 - 1)
                waves = x.exponent * harmonic_sum(summand, x.exponent, y.exponent)
                cosine -= self.scaled(x, y) * a ** (x.exponent + y.weight) * waves
        for x in self.forces.part(2):
            cosine -= self.scaled(x) * 2 * moment(x.exponent + 1) * a**x.exponent
        return sine, cosine


def _force(x: Power) -> Expr:
    """The force at X_0 = a cos psi, V_0 = -a sin psi, without its strength."""
    wave, side = (sin(psi), -1) if x.sign < 0 else (cos(psi), 1)
    power = wave**x.exponent if x.sign > 0 and x.exponent.is_odd else Abs(wave) ** x.exponent * sign(wave)
    return side * a**x.exponent * power


def _slope(x: Power) -> Expr:
    """alpha |V_0|^(alpha-1), or p |X_0|^(p-1); at alpha = 0 the delta function 2 delta(a sin psi)."""
    wave = sin(psi) if x.sign < 0 else cos(psi)
    if x.exponent.is_zero:
        return 2 * DiracDelta(a * wave)
    return x.exponent * a**x.weight * (wave**x.weight if x.sign > 0 and x.exponent.is_odd else Abs(wave) ** x.weight)


def _two_losses(x: Power, y: Power) -> Expr:
    """2 P_i P_j + sum n^2 b_n^(i) b_n^(j)/(n^2-1): from -2 <S'(V_0) V_1 cos psi>."""
    summand = N**2 * harmonic_closed_form(x.exponent, N) * harmonic_closed_form(y.exponent, N) / (N**2 - 1)
    return 2 * moment(x.exponent + 1) * moment(y.exponent + 1) + harmonic_sum(summand, x.exponent, y.exponent)


def _loss_and_spring(x: Power, y: Power) -> Expr:
    """2 alpha P Q + (alpha+1) sum n b_n d_n/(n^2-1): from -2 <S'(V_0) V_1 sin psi> and -2 <R'(X_0) X_1 sin psi>."""
    alpha, p = x.exponent, y.exponent
    summand = N * harmonic_closed_form(alpha, N) * cosine_closed_form(p, N) / (N**2 - 1)
    return 2 * alpha * moment(alpha + 1) * moment(p + 1) + (alpha + 1) * harmonic_sum(summand, alpha, p)
