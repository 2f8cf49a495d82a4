"""The classical route for odd exponents, in SymPy: every order displayed, laws, waveform and initial conditions.

>>> result = multiple_scales((3,), 3)
>>> result.orders[1].equation.rhs
3*a**3*sin(psi)/4 - a**3*sin(3*psi)/4 + 2*a*g_1*cos(psi) + 2*f_1*sin(psi)
>>> result.orders[1].secular, result.orders[1].solvability
((3*a**3/4 + 2*f_1, 2*a*g_1), (Eq(f_1, -3*a**3/8), Eq(g_1, 0)))
>>> result.orders[1].solution
Eq(X_1(psi), a**3*sin(3*psi)/32)
>>> result.amplitude_rate, result.phase_rate
(-351*a**7*epsilon**3/8192 - 3*a**3*epsilon/8, 9*a**4*epsilon**2/256 + 1)
>>> result.initial_amplitude, result.initial_phase
(87*epsilon**2/2048 + 1, 15*epsilon**3/2048 - 9*epsilon/32)

Textbooks write a(T_1, T_2, ...) and phi(T_1, T_2, ...) as if T_1, T_2, ... were independent variables.  No such phi
exists here, its mixed derivatives differ:

>>> result.commutator(1, 2)                       # (D_1 D_2 - D_2 D_1) of a and of psi
(0, -27*a**6/512)

The D_n are vector fields on the (a, psi) plane, d/d tau is their sum along one solution, and order matters in D_i D_j.
"""

from dataclasses import dataclass, field

from flint import fmpq
from sympy import Add, Derivative, Eq, Expr, cos, diff, expand, latex, sin

from asymptotics.multiscale.exact import MAX_SECONDS, OddHierarchy, odd_hierarchy
from asymptotics.multiscale.initial import InitialConditions, initial_conditions
from asymptotics.multiscale.orders import (
    Order,
    a,
    epsilon,
    law_symbols,
    leading_order,
    monomial,
    odd_force,
    operator_equation,
    psi,
    rate_symbols,
    solution_symbol,
    velocity_equation,
)
from asymptotics.numbers.bridge import to_sympy
from asymptotics.series import Series, monomials


@dataclass(frozen=True, repr=False)
class MultipleScales:
    """The hierarchy solved through ``kernel.order``: orders 0, ..., N as objects, and their sums as expressions.

    ``orders[n]`` holds X_n; for several laws X_n collects all terms of total degree n in epsilon_0, epsilon_1, ....
    ``rates[n]`` = (D_n a, D_n psi).
    """

    kernel: OddHierarchy
    orders: tuple[Order, ...]
    start: InitialConditions
    notes: tuple[str, ...] = field(default=(), compare=False)

    @property
    def gauge(self) -> str:
        """no-first-harmonic: the coefficient of cos psi in X is exactly a, that of sin psi is 0."""
        return self.kernel.gauge

    @property
    def rates(self) -> tuple[tuple[Expr, Expr], ...]:
        """(D_n a, D_n psi) for n = 0, ..., N, with D_0 psi = 1."""
        return tuple((e[0].rhs, e[1].rhs) for e in (order.solvability for order in self.orders))

    @property
    def amplitude_rate(self) -> Expr:
        """da/d tau as a polynomial in epsilon and a."""
        return self._sum(tuple(rate for rate, _ in self.rates))

    @property
    def phase_rate(self) -> Expr:
        """d psi/d tau as a polynomial in epsilon and a."""
        return self._sum(tuple(rate for _, rate in self.rates))

    @property
    def waveform(self) -> Expr:
        """X(a, psi) through order N."""
        return self._sum(tuple(order.solution.rhs for order in self.orders if order.solution is not None))

    @property
    def initial_amplitude(self) -> Expr:
        """a(0) for X(0) = 1, X'(0) = 0."""
        return _in_epsilon(self.start.amplitude)

    @property
    def initial_phase(self) -> Expr:
        """psi(0) = phi(0) for X(0) = 1, X'(0) = 0."""
        return _in_epsilon(self.start.phase)

    def slow_derivative(self, n: int, f: Expr) -> Expr:
        """D_n f = (D_n a) df/da + (D_n psi) df/d psi for an expression in a and psi; n = 0 is the fast derivative."""
        rate, turn = self.rates[n]
        return expand(rate * diff(f, a) + turn * diff(f, psi))

    def commutator(self, i: int, j: int) -> tuple[Expr, Expr]:
        """(D_i D_j - D_j D_i) of a and of psi: zero would mean that a(T_1, T_2, ...), phi(T_1, T_2, ...) exist."""
        pairs = zip(self.rates[i], self.rates[j])
        of_a, of_psi = (expand(self.slow_derivative(i, y) - self.slow_derivative(j, x)) for x, y in pairs)
        return of_a, of_psi

    def _sum(self, parts: tuple[Expr, ...]) -> Expr:
        step = epsilon if len(self.kernel.alphas) == 1 else 1
        return Add(*[expand(step**n * part) for n, part in enumerate(parts)])

    def __repr__(self) -> str:
        exponents = ", ".join(map(str, self.kernel.alphas))
        return f"MultipleScales(alpha = {exponents}, orders 0 to {len(self.orders) - 1}, gauge {self.gauge})"

    def _repr_latex_(self) -> str:
        rows = (
            rf"\frac{{da}}{{d\tau}} &= {latex(self.amplitude_rate)}",
            rf"\frac{{d\psi}}{{d\tau}} &= {latex(self.phase_rate)}",
            f"X &= {latex(self.waveform)}",
            f"a(0) &= {latex(self.initial_amplitude)}",
            rf"\psi(0) &= {latex(self.initial_phase)}",
            rf"&\text{{gauge: {self.gauge}}}",
        )
        return r"$\displaystyle \begin{aligned}" + r" \\ ".join(rows) + r"\end{aligned}$"


def multiple_scales(alphas: tuple[int, ...], order: int, *, max_seconds: float = MAX_SECONDS) -> MultipleScales:
    """Solve X'' + X + sum_i epsilon_i X'^alpha_i = 0 for odd alpha_i >= 1 through ``order``, orders shown one by one.

    Raises InputError for exponents that are not odd or an order below 1, LimitError for more than ``max_seconds``.
    """
    kernel = odd_hierarchy(alphas, order, max_seconds=max_seconds)
    orders = (leading_order(kernel.gauge), *(_order(kernel, n) for n in range(1, order + 1)))
    return MultipleScales(kernel, orders, initial_conditions(kernel))


def _order(kernel: OddHierarchy, n: int) -> Order:
    alphas = kernel.alphas
    rate, turn = rate_symbols(n)
    known = {key: kernel.right_side(key) for key in kernel.keys(n)}
    right = 2 * rate * sin(psi) + 2 * a * turn * cos(psi) + _trigonometric(alphas, n, known)
    first = Add(*[to_sympy(c.get(1, fmpq(0))) * monomial(alphas, k) for k, c in known.items()])
    secular = (2 * rate + first, 2 * a * turn) if n % 2 else (2 * rate, 2 * a * turn + first)
    solved = (-_homogeneous(alphas, kernel.p, n, 1), _homogeneous(alphas, kernel.Omega, n, 0))
    X_n = solution_symbol(n)
    return Order(
        n,
        operator_equation(n, odd_force(alphas, n)),
        velocity_equation(n - 1),
        Eq(Derivative(X_n, (psi, 2)) + X_n, right, evaluate=False),
        secular,
        tuple(Eq(s, v, evaluate=False) for s, v in zip((rate, turn), solved)),
        Eq(X_n, _trigonometric(alphas, n, {key: kernel.harmonics(key) for key in kernel.keys(n)}), evaluate=False),
        kernel.gauge,
    )


def _trigonometric(alphas: tuple[int, ...], n: int, parts: dict[tuple[int, ...], dict[int, fmpq]]) -> Expr:
    """sum of c a delta^k sin(m psi) for odd n, cos(m psi) for even n."""
    wave = sin if n % 2 else cos
    terms = [to_sympy(c) * monomial(alphas, k) * wave(m * psi) for k, line in parts.items() for m, c in line.items()]
    return Add(*terms)


def _homogeneous(alphas: tuple[int, ...], series: Series, n: int, power: int) -> Expr:
    """a^power times the terms of total degree n of p or Omega."""
    found = [(k, series.coefficients[k]) for k in monomials(len(alphas), n) if k in series.coefficients]
    return Add(*[to_sympy(c) * monomial(alphas, k, power) for k, c in found])


def _in_epsilon(series: Series) -> Expr:
    symbols, total = law_symbols(series.variables), Add()
    for key, c in series.coefficients.items():
        term = to_sympy(c)
        for symbol, k in zip(symbols, key):
            term = term * symbol**k
        total = total + term
    return total
