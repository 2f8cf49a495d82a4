"""The classical route for smooth forces, in SymPy: every order displayed, laws, waveform and initial conditions.

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

A spring stands beside the losses with its own strength c, and turns the phase at first order:

>>> van_der_pol, cubic = (Term(1, 1), Term(1, 1, 2)), Term(1, 0, 3, "position")
>>> multiple_scales((*van_der_pol, cubic), 1).phase_rate
3*a**2*c/8 + 1
"""

from collections.abc import Sequence
from dataclasses import dataclass, field

from flint import fmpq
from sympy import Add, Derivative, Eq, Expr, cos, diff, expand, latex, sin

from asymptotics.errors import InputError, shown
from asymptotics.multiscale.exact import MAX_SECONDS, OddHierarchy, odd_hierarchy
from asymptotics.multiscale.initial import InitialConditions, initial_conditions
from asymptotics.multiscale.orders import (
    Order,
    a,
    leading_order,
    monomial,
    operator_equation,
    psi,
    rate_symbols,
    smooth_force,
    solution_symbol,
    strength_symbols,
    velocity_equation,
)
from asymptotics.numbers.bridge import to_sympy
from asymptotics.numbers.exact import require_integer
from asymptotics.series import Key, Series, monomials
from asymptotics.terms import Term


@dataclass(frozen=True, repr=False)
class MultipleScales:
    """The hierarchy solved through ``kernel.order``: orders 0, ..., N as objects, and their sums as expressions.

    ``orders[n]`` holds X_n; for several forces X_n collects all terms of total degree n in their strengths ``symbols``
    (of one force epsilon^n or c^n is taken out).  ``rates[n]`` = (D_n a, D_n psi).
    """

    terms: tuple[Term, ...]
    kernel: OddHierarchy
    orders: tuple[Order, ...]
    start: InitialConditions
    notes: tuple[str, ...] = field(default=(), compare=False)

    @property
    def gauge(self) -> str:
        """no-first-harmonic: the coefficient of cos psi in X is exactly a, that of sin psi is 0."""
        return self.kernel.gauge

    @property
    def symbols(self) -> tuple[Expr, ...]:
        """The strengths: epsilon or epsilon_i, c or c_j, and theta_0^2 for a pendulum with x in units of theta_0."""
        return strength_symbols(self.terms)

    @property
    def rates(self) -> tuple[tuple[Expr, Expr], ...]:
        """(D_n a, D_n psi) for n = 0, ..., N, with D_0 psi = 1."""
        return tuple((e[0].rhs, e[1].rhs) for e in (order.solvability for order in self.orders))

    @property
    def amplitude_rate(self) -> Expr:
        """da/d tau as a polynomial in a and the strengths."""
        return self._sum(tuple(rate for rate, _ in self.rates))

    @property
    def phase_rate(self) -> Expr:
        """d psi/d tau as a polynomial in a and the strengths."""
        return self._sum(tuple(rate for _, rate in self.rates))

    @property
    def waveform(self) -> Expr:
        """X(a, psi) through order N."""
        return self._sum(tuple(order.solution.rhs for order in self.orders if order.solution is not None))

    @property
    def initial_amplitude(self) -> Expr:
        """a(0) for X(0) = 1, X'(0) = 0."""
        return _in_strengths(self.start.amplitude, self.symbols)

    @property
    def initial_phase(self) -> Expr:
        """psi(0) = phi(0) for X(0) = 1, X'(0) = 0."""
        return _in_strengths(self.start.phase, self.symbols)

    def slow_derivative(self, n: int, f: Expr) -> Expr:
        """D_n f = (D_n a) df/da + (D_n psi) df/d psi for an expression in a and psi; n = 0 is the fast derivative."""
        rate, turn = self.rates[require_integer(n, "n", 0, len(self.rates) - 1)]
        if not isinstance(f, Expr):
            raise InputError("f", f"{shown(f)} is no expression", "a SymPy expression in a and psi")
        return expand(rate * diff(f, a) + turn * diff(f, psi))

    def commutator(self, i: int, j: int) -> tuple[Expr, Expr]:
        """(D_i D_j - D_j D_i) of a and of psi: zero would mean that a(T_1, T_2, ...), phi(T_1, T_2, ...) exist."""
        last = len(self.rates) - 1
        pairs = zip(*(self.rates[require_integer(n, name, 0, last)] for name, n in (("i", i), ("j", j))))
        of_a, of_psi = (expand(self.slow_derivative(i, y) - self.slow_derivative(j, x)) for x, y in pairs)
        return of_a, of_psi

    def _sum(self, parts: tuple[Expr, ...]) -> Expr:
        step = self.symbols[0] if len(self.terms) == 1 else 1
        return Add(*[expand(step**n * part) for n, part in enumerate(parts)])

    def __repr__(self) -> str:
        forces = ", ".join(t.shape() for t in self.terms)
        return f"MultipleScales({forces}, orders 0 to {len(self.orders) - 1}, gauge {self.gauge})"

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


def multiple_scales(given: Sequence[int | Term], order: int, *, max_seconds: float = MAX_SECONDS) -> MultipleScales:
    """Solve X'' + X + the forces = 0 for polynomial forces through ``order``, orders shown one by one.

    ``given``: terms (losses with alpha odd and m even, springs with p odd and q even; a pendulum) or odd exponents.
    Raises InputError for other forces or an order below 1, LimitError for more than ``max_seconds``.
    """
    kernel = odd_hierarchy(tuple(given), order, max_seconds=max_seconds)
    terms = tuple(t if isinstance(t, Term) else Term(1, t) for t in given)
    made = _Display(kernel, strength_symbols(terms))
    orders = (leading_order(kernel.gauge), *(made.order(n) for n in range(1, order + 1)))
    return MultipleScales(terms, kernel, orders, initial_conditions(kernel))


@dataclass(frozen=True)
class _Display:
    """The results of the kernel as SymPy expressions in a, psi and the strengths."""

    kernel: OddHierarchy
    symbols: tuple[Expr, ...]

    def order(self, n: int) -> Order:
        """Order n: nothing is computed here, everything is shown."""
        kernel, (rate, turn) = self.kernel, rate_symbols(n)
        known = {key: kernel.right_side(key) for key in kernel.keys(n)}
        first = {key: c.get(1, fmpq(0)) for key, c in known.items()}
        sine, cosine = (self._sum({k: c for k, c in first.items() if self._is_odd(k) == odd}) for odd in (True, False))
        solved = (-self._homogeneous(kernel.p, n, 1), self._homogeneous(kernel.Omega, n, 0))
        X_n = solution_symbol(n)
        return Order(
            n,
            operator_equation(n, smooth_force(kernel.forces, self.symbols, n)),
            velocity_equation(n - 1),
            Eq(
                Derivative(X_n, (psi, 2)) + X_n,
                2 * rate * sin(psi) + 2 * a * turn * cos(psi) + self._waves(known),
                evaluate=False,
            ),
            (2 * rate + sine, 2 * a * turn + cosine),
            tuple(Eq(s, v, evaluate=False) for s, v in zip((rate, turn), solved)),
            Eq(X_n, self._waves({key: kernel.harmonics(key) for key in kernel.keys(n)}), evaluate=False),
            kernel.gauge,
        )

    def _is_odd(self, key: Key) -> bool:
        return self.kernel.forces.loss_degree(key) % 2 == 1

    def _monomial(self, key: Key, power: int = 1) -> Expr:
        degrees = tuple(to_sympy(d) for d in self.kernel.grading.degrees)
        return monomial(degrees, key, power, self.symbols)

    def _sum(self, parts: dict[Key, fmpq], power: int = 1) -> Expr:
        return Add(*[to_sympy(c) * self._monomial(k, power) for k, c in parts.items()])

    def _waves(self, parts: dict[Key, dict[int, fmpq]]) -> Expr:
        """sum of c a delta^k sin(m psi) for odd loss degree, cos(m psi) for even."""
        total = [
            to_sympy(c) * self._monomial(k) * (sin if self._is_odd(k) else cos)(m * psi)
            for k, line in parts.items()
            for m, c in line.items()
        ]
        return Add(*total)

    def _homogeneous(self, series: Series, n: int, power: int) -> Expr:
        """a^power times the terms of total degree n of p or Omega."""
        keys = monomials(series.variables, n)
        return self._sum({k: series.coefficients[k] for k in keys if k in series.coefficients}, power)


def _in_strengths(series: Series, symbols: tuple[Expr, ...]) -> Expr:
    total = Add()
    for key, c in series.coefficients.items():
        term = to_sympy(c)
        for symbol, k in zip(symbols, key):
            term = term * symbol**k
        total = total + term
    return total
