"""The hierarchy in the turning-point gauge for any exponents, numbers or symbols, to any order: what closes is closed,
and what does not is shown as the integral it is.

On 0 < psi < pi, V = X' < 0 and |V|^alpha = a^alpha s^alpha (1 + ...)^alpha with s = sin psi: V_n/s stays bounded,
because V vanishes at psi = 0 and psi = pi for every a.  So the expansion exists at every order for every alpha >= 0.
(Without that, as in the gauge no-first-harmonic, V_1 is not 0 where s is, and s^(alpha-j) V_1^j, which the force has at
order j + 1, is not integrable for j >= alpha + 1 unless alpha is odd: from that order on nothing exists at fixed psi.)

With D_j = f_j d/da + g_j d/dpsi, F_n the forces at order n, and all lower orders known,

    K_n = sum_(0<j<n) D_j X_(n-j),        L_n = sum_(0<j<n) D_j V_(n-j) + F_n,
    V_n = dX_n/dpsi + K_n + f_n cos psi - a g_n sin psi,
    X_n = cos psi int_0^psi (-f_n + sin t L_n - cos t K_n) dt + sin psi int_0^psi (a g_n - sin t K_n - cos t L_n) dt,
    pi f_n = int_0^pi (sin L_n - cos K_n) dpsi,       pi a g_n = int_0^pi (sin K_n + cos L_n) dpsi.

*Closed.*  With p = M_(alpha+1), u = p (psi - pi/2) + cos psi 2F1(1/2, -alpha/2; 3/2; cos^2 psi), which is
int_0^psi (p - sin^(alpha+1)), one law has

    X_1 = a^alpha [cos psi u + s^(alpha+2)/(alpha+1)],
    X_2 = a^(2 alpha-1) [cos psi (alpha/2) (u^2 + (s^(alpha+1)/(alpha+1))^2) + sin psi w],
    w = (alpha/(alpha+1)) s^(alpha+1) (u - s^alpha cos psi/(alpha+1))
        - (alpha/(alpha+1))^2 [M_(2 alpha) (psi - pi/2) + cos psi 2F1(1/2, 1/2 - alpha; 3/2; cos^2 psi)],

so X_2 needs no integral at all (derivation ``multiple-scales-general``).  f_3 and g_4 of one law and the second order
of sums are closed too; other rates are integrals, with certified digits where the exponents are numbers.

>>> from asymptotics.expansions.half_swings.symbolic import alpha
>>> from sympy import symbols
>>> general = open_scales((alpha,), (), 3)
>>> general.orders[3].hierarchy.rhs.coeff(symbols("V_2", real=True))
-alpha*(-V_0)**(alpha - 1)
>>> print(general.orders[3].solvability[0].rhs)
Integral(-K_3(a, psi)*cos(psi) + L_3(a, psi)*sin(psi), (psi, 0, pi))/pi
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from math import factorial, prod

from sympy import (
    Add,
    Derivative,
    Eq,
    Expr,
    Float,
    Function,
    Integer,
    Integral,
    Mul,
    Rational,
    Symbol,
    cos,
    hyper,
    pi,
    sign,
    sin,
)

from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.expansions.moments.symbolic import moment
from asymptotics.expansions.multiple_scales.initial import InitialConditions
from asymptotics.expansions.multiple_scales.orders import (
    Order,
    a,
    leading_order,
    psi,
    rate_symbols,
    solved_order,
    symbols_of,
)
from asymptotics.expansions.multiple_scales.symbolic import MultipleScales
from asymptotics.expansions.multiple_scales.turning_orders import turning_conditions
from asymptotics.gauges import TURNING_POINT
from asymptotics.numbers.bridge import to_sympy
from asymptotics.series import Key, Series, unit_key
from asymptotics.terms import Term

Rates = Mapping[Key, Expr]
Factors = tuple[Expr, ...]
t = Symbol("t", real=True)


@dataclass(frozen=True)
class PowerForce:
    """strength ratio |x|^position v|v|^(velocity-1) (sign -1) or strength ratio x|x|^(position-1) |v|^velocity (+1)."""

    key: Key
    ratio: Expr
    velocity: Expr
    position: int
    sign: int

    @property
    def piecewise(self) -> bool:
        """Whether it is no polynomial of x where x changes its sign."""
        return self.position % 2 != (self.sign > 0)


def forces_of(alphas: tuple[Expr, ...], terms: tuple[Term, ...], order: int) -> tuple[PowerForce, ...]:
    """Losses x'|x'|^(alpha-1), then other terms, as they enter through ``order``."""
    count = len(alphas) + len(terms)
    found = [PowerForce(unit_key(i, count), Integer(1), alpha, 0, -1) for i, alpha in enumerate(alphas)]
    for m in Forces.of(terms, order).through(order) if terms else ():
        key = (*(0,) * len(alphas), *m.key)
        found.append(PowerForce(key, to_sympy(m.ratio), to_sympy(m.velocity), m.position, m.sign))
    return tuple(found)


def open_scales(
    alphas: tuple[Expr, ...], terms: tuple[Term, ...], order: int, known: tuple[Rates, Rates, int] | None = None
) -> MultipleScales:
    """X'' + X + sum_i epsilon_i X'|X'|^(alpha_i-1) + terms = 0 through ``order``; alpha_i >= 0 symbols or exact.

    ``known``: the coefficients of p and Omega in da/dtau = -a p, dpsi/dtau = 1 + Omega, by exponent of the local
    strengths, and the order through which that is all of them.  InputError where a force that is no polynomial of x
    meets an order at which its derivative in x is no function, and for an exponent that is negative or inexact.
    """
    require_exponents(alphas)
    forces = forces_of(alphas, terms, order)
    _require_derivatives(forces, order)
    symbols = symbols_of(len(alphas), terms)
    made = _Open(forces, symbols, alphas, terms, *(known or ({}, {}, 0)))
    orders = (leading_order(TURNING_POINT), *(made.order(n) for n in range(1, order + 1)))
    start = InitialConditions(Series.constant(1, len(symbols), order), Series({}, len(symbols), order))
    shapes = (*(f"x'|x'|^({x}-1)" for x in alphas), *(term.shape() for term in terms))
    return MultipleScales(shapes, symbols, orders, start, losses=alphas if not terms else ())


def require_exponents(alphas: tuple[Expr, ...]) -> None:
    """InputError unless every exponent is an exact real number >= 0 or a symbol that may be one."""
    accepted = "exact numbers >= 0 or symbols declared nonnegative"
    for alpha in alphas:
        if not isinstance(alpha, Expr) or alpha.has(Float):
            raise InputError("alpha", f"{alpha!r} is not exact", accepted)
        if alpha.is_nonnegative is not True:
            raise InputError("alpha", f"{alpha} is not known to be >= 0", accepted)


def _require_derivatives(forces: tuple[PowerForce, ...], order: int) -> None:
    for f in forces:
        # At order n the force is differentiated n - 1 times in x, and |x|^m has m derivatives that are functions.
        if f.piecewise and order > f.position + 1:
            power = f"|x|^{f.position}" if f.sign < 0 else f"x|x|^{f.position - 1}"
            reason = f"{order}: it takes derivative {order - 1} of {power}, which is no function where x = 0"
            raise InputError("order", reason, f"1 to {f.position + 1} beside {power}; 1 to 12 with M even, P odd")


@dataclass(frozen=True)
class _Open:
    """One order after the other, as SymPy expressions in X_j(a, psi) and V_j(a, psi) of the lower ones."""

    forces: tuple[PowerForce, ...]
    symbols: tuple[Expr, ...]
    alphas: tuple[Expr, ...]
    terms: tuple[Term, ...]
    p: Rates
    Omega: Rates
    known: int

    def order(self, n: int) -> Order:
        """Order n: the equation of the ansatz, the equation with its forcing, the conditions, the rates, X_n."""
        f, g = rate_symbols(n)
        K, L = self.lower(n)
        K_n, L_n = wave("K", n), wave("L", n)
        # V_n = X_n' + K_n + ... put into V_n' = -X_n - L_n - ...: K enters by its derivative.
        forcing = -(L_n + Derivative(K_n, psi)) if n > 1 else -L
        first, second = self.conditions(n)
        names, closed = turning_conditions(n), self.closed(n)
        where = [Eq(K_n, K, evaluate=False), Eq(L_n, L, evaluate=False)] if n > 1 else [Eq(L_n, L, evaluate=False)]
        where.append(Eq(wave("V", n), self.velocity(n), evaluate=False))
        return solved_order(
            n,
            self.ansatz_force(n),
            forcing,
            ((names[0], pi * f - first), (names[1], second - pi * a * g)),
            self.rates(n),
            self.integral(n) if closed is None else closed,
            TURNING_POINT,
            unknown=wave("X", n),
            where=tuple(where),
        )

    def lower(self, n: int) -> tuple[Expr, Expr]:
        """K_n and L_n in X_j, V_j, f_j, g_j with j < n."""
        return _slow("X", n), _slow("V", n) + self.force(n, (a, sin(psi)), (a, cos(psi)), wave)

    def ansatz_force(self, n: int) -> Expr:
        """The forces at order n in the letters X_j, V_j of the ansatz."""
        return self.force(n, (-_letter("V", 0),), (_letter("X", 0),), _letter)

    def force(self, n: int, Y_0: Factors, X_0: Factors, name: Callable[[str, int], Expr]) -> Expr:
        """The forces at order n where V < 0, from the factors of -V_0 and X_0."""
        total: Expr = Integer(0)
        for m in self.forces:
            if (later := n - sum(m.key)) >= 0:
                # A loss enters with V|V|^(alpha-1) = -(-V)^alpha where V < 0, which its sign -1 says; a spring with +1.
                total += m.sign * self.strength(m.key) * m.ratio * _product(m, later, Y_0, X_0, name)
        return total

    def strength(self, key: Key) -> Expr:
        """The strengths of a monomial; a single epsilon is taken out."""
        return Integer(1) if len(self.symbols) == 1 else Mul(*[s**n for s, n in zip(self.symbols, key)])

    def conditions(self, n: int) -> tuple[Expr, Expr]:
        """int_0^pi (sin L - cos K) and int_0^pi (sin K + cos L), held."""
        L = wave("L", n)
        K = wave("K", n) if n > 1 else Integer(0)
        return (
            Integral(sin(psi) * L - cos(psi) * K, (psi, 0, pi)),
            Integral(sin(psi) * K + cos(psi) * L, (psi, 0, pi)),
        )

    def integral(self, n: int) -> Expr:
        """X_n by variation of constants."""
        (f, g), L = rate_symbols(n), wave("L", n, t)
        K = wave("K", n, t) if n > 1 else Integer(0)
        u = Integral(-f + sin(t) * L - cos(t) * K, (t, 0, psi))
        return cos(psi) * u + sin(psi) * Integral(a * g - sin(t) * K - cos(t) * L, (t, 0, psi))

    def velocity(self, n: int) -> Expr:
        """V_n = dX_n/dpsi + K_n + f_n cos psi - a g_n sin psi."""
        f, g = rate_symbols(n)
        slow = wave("K", n) if n > 1 else Integer(0)
        return Derivative(wave("X", n), psi) + slow + f * cos(psi) - a * g * sin(psi)

    def rates(self, n: int) -> tuple[Expr, Expr]:
        """f_n and g_n: known coefficients, else the held integrals."""
        first, second = self.conditions(n)
        found = []
        for rates, power, open_form, sense in ((self.p, 1, first / pi, -1), (self.Omega, 0, second / (pi * a), 1)):
            keys = [k for k in rates if sum(k) == n]
            total = Add(*[rates[k] * self.strength(k) * self.power(k, power) for k in keys])
            # Known in closed form, or zero by reversal, or the integral that the condition at pi gives.
            found.append(sense * total if n <= self.known or self.vanishes(n, sense) else open_form)
        return found[0], found[1]

    def vanishes(self, n: int, sense: int) -> bool:
        """By reversal f_n has only odd, g_n only even numbers of losses: zero where no spring helps."""
        # With a spring a degree has monomials with an even and with an odd number of losses, and n itself says nothing.
        return all(f.sign < 0 for f in self.forces) and n % 2 == (0 if sense < 0 else 1)

    def power(self, key: Key, power: int) -> Expr:
        """a^(power + sum n_i (d_i - 1))."""
        # Of a symbolic exponent too: a SymPy expression, and no number is asked for.
        weights = [x - 1 for x in self.alphas] + [to_sympy(term.weight) for term in self.terms]
        return a ** Add(power, *[n * w for n, w in zip(key, weights)])

    def closed(self, n: int) -> Expr | None:
        """X_1 of losses x'|x'|^(alpha-1), X_2 of one such loss."""
        if self.terms or n > 2 or (n == 2 and len(self.alphas) > 1):
            return None
        if n == 2:
            (alpha,) = self.alphas
            return a ** (2 * alpha - 1) * second_wave(alpha)
        return Add(*[self.strength(m.key) * a**m.velocity * first_wave(m.velocity) for m in self.forces])


def lag(alpha: Expr, phase: Expr = psi) -> Expr:
    """u = int_0^psi (M_(alpha+1) - sin^(alpha+1)) = M_(alpha+1) (psi - pi/2) + cos psi 2F1(...)."""
    return moment(alpha + 1) * (phase - pi / 2) + _sine_integral(alpha + 1, phase)


def _sine_integral(power: Expr, phase: Expr) -> Expr:
    """int_psi^(pi/2) sin^power = cos psi 2F1(1/2, (1-power)/2; 3/2; cos^2 psi)."""
    c = cos(phase)
    return c * hyper((Rational(1, 2), (1 - power) / 2), (Rational(3, 2),), c**2)


def first_wave(alpha: Expr) -> Expr:
    """X_1/a^alpha, the wave of first order, of one law."""
    return cos(psi) * lag(alpha) + sin(psi) ** (alpha + 2) / (alpha + 1)


def second_wave(alpha: Expr) -> Expr:
    """X_2/a^(2 alpha-1) of one law."""
    s, c, u = sin(psi), cos(psi), lag(alpha)
    return c * alpha / 2 * (u**2 + (s ** (alpha + 1) / (alpha + 1)) ** 2) + s * second_turn(alpha)


def second_turn(alpha: Expr, phase: Expr = psi) -> Expr:
    """w of X_2 = a^(2 alpha-1) (cos psi u_2 + sin psi w)."""
    s, c, u, r = sin(phase), cos(phase), lag(alpha, phase), alpha / (alpha + 1)
    rest = moment(2 * alpha) * (phase - pi / 2) + _sine_integral(2 * alpha, phase)
    return r * s ** (alpha + 1) * (u - s**alpha * c / (alpha + 1)) - r**2 * rest


def wave(letter: str, n: int, phase: Expr = psi) -> Expr:
    """X_n(a, psi), V_n(a, psi), K_n(a, psi), L_n(a, psi)."""
    return Function(f"{letter}_{n}")(a, phase)


def _letter(letter: str, n: int) -> Expr:
    return Symbol(f"{letter}_{n}", real=True)


def _slow(letter: str, n: int) -> Expr:
    """sum_(0<j<n) (f_j d/da + g_j d/dpsi) of the part of order n - j."""
    total: Expr = Integer(0)
    for j in range(1, n):
        (f, g), part = rate_symbols(j), wave(letter, n - j)
        total += f * Derivative(part, a) + g * Derivative(part, psi)
    return total


def _product(m: PowerForce, n: int, Y_0: Factors, X_0: Factors, name: Callable[[str, int], Expr]) -> Expr:
    """Degree n of |X|^position (-V)^velocity, or with the sign of X."""
    velocity = [_power(Y_0, m.velocity, [-name("V", i) for i in range(1, j + 1)]) for j in range(n + 1)]
    position = [_power(X_0, Integer(m.position), [name("X", i) for i in range(1, j + 1)]) for j in range(n + 1)]
    total = Add(*[velocity[j] * position[n - j] for j in range(n + 1)])
    return total * sign(X_0[-1]) if m.piecewise else total


def _power(base: Factors, exponent: Expr, later: list[Expr]) -> Expr:
    """The highest part of (base + sum_j eps^j later_j)^exponent, j = 1, ..., n: one term for each partition of n."""
    # Faa di Bruno's formula: weight = exponent (exponent - 1) ... over the factorials of the multiplicities.
    terms = []
    for counts in _partitions(len(later)):
        m = sum(counts.values())
        weight = Mul(*[exponent - i for i in range(m)]) / prod(factorial(k) for k in counts.values())
        # A whole exponent ends its derivatives: what comes after is exactly 0, and base^(exponent - m) would be a pole.
        if weight != 0:
            powers = [f ** (exponent - m) for f in base]
            terms.append(weight * Mul(*powers) * Mul(*[later[j - 1] ** k for j, k in counts.items()]))
    return Add(*terms)


def _partitions(n: int, largest: int | None = None) -> Iterator[dict[int, int]]:
    """The partitions of n as part -> multiplicity."""
    if n == 0:
        yield {}
    for part in range(min(n, largest or n), 0, -1):
        for k in range(n // part, 0, -1):
            rest = n - k * part
            for found in _partitions(rest, part - 1) if part > 1 or rest == 0 else ():
                yield {part: k, **found}
