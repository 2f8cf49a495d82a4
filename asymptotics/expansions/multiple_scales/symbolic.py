"""The classical route for smooth forces, in SymPy: every order displayed, laws, waveform and initial conditions.

>>> result = multiple_scales((3,), 3)
>>> result.orders[1].equation.rhs
3*a**3*sin(psi)/4 - a**3*sin(3*psi)/4 + 2*a*g_1*cos(psi) + 2*f_1*sin(psi)
>>> [c for _, c in result.orders[1].conditions], result.orders[1].solvability
([3*a**3/4 + 2*f_1, 2*a*g_1], (Eq(f_1, -3*a**3/8), Eq(g_1, 0)))
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
from sympy import Add, Expr, cos, diff, expand, latex, sin

from asymptotics.errors import InputError, shown
from asymptotics.expansions.multiple_scales.exact import MAX_SECONDS, OddHierarchy, odd_hierarchy
from asymptotics.expansions.multiple_scales.initial import InitialConditions, initial_conditions
from asymptotics.expansions.multiple_scales.orders import (
    SECULAR,
    Order,
    a,
    leading_order,
    order_letters,
    psi,
    rate_symbols,
    smooth_force,
    solved_order,
    strength_monomial,
    strength_symbols,
)
from asymptotics.expansions.multiple_scales.turning import TurningHierarchy
from asymptotics.numbers.bridge import to_sympy
from asymptotics.numbers.integers import require_integer
from asymptotics.numbers.policy import Number
from asymptotics.present.shown import Page, Shown
from asymptotics.running.public import public
from asymptotics.series import Key, Series, monomials
from asymptotics.terms import Term


@dataclass(frozen=True, repr=False)
class MultipleScales(Shown):
    """The hierarchy solved through order N: orders 0, ..., N as objects, and their sums as expressions.

    ``shapes``: the forces in words; ``symbols``: their strengths, epsilon or epsilon_i, c or c_j, and theta_0^2 for a
    pendulum with x in units of theta_0; ``kernel``: the exact solution it shows, if there is one.  ``orders[n]`` holds
    X_n; for several forces X_n collects all terms of total degree n in their strengths ``symbols``
    (of one force epsilon^n or c^n is taken out).  ``rates[n]`` = (D_n a, D_n psi).  ``losses``: the exponents where
    waveforms are no polynomials and all forces are powers of x'.
    """

    shapes: tuple[str, ...]
    symbols: tuple[Expr, ...]
    orders: tuple[Order, ...]
    start: InitialConditions
    kernel: OddHierarchy | TurningHierarchy | None = field(default=None, compare=False)  # ``orders`` shows it
    notes: tuple[str, ...] = field(default=(), compare=False)
    losses: tuple[Expr, ...] = field(default=(), compare=False)

    @property
    def gauge(self) -> str:
        """no-first-harmonic: the coefficient of cos psi in X is exactly a, that of sin psi is 0; or turning-point."""
        return self.orders[0].gauge

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
        """X(a, psi) through order N; in the turning-point gauge on 0 < psi < pi, and X(a, psi + pi) = -X(a, psi)."""
        return self._sum(tuple(order.solution.rhs for order in self.orders if order.solution is not None))

    @property
    def initial_amplitude(self) -> Expr:
        """a(0) for X(0) = 1, X'(0) = 0."""
        return _in_strengths(self.start.amplitude, self.symbols)

    @property
    def initial_phase(self) -> Expr:
        """psi(0) = phi(0) for X(0) = 1, X'(0) = 0."""
        return _in_strengths(self.start.phase, self.symbols)

    @public
    def slow_derivative(self, n: int, f: Expr, *, max_seconds: Number = 60) -> Expr:
        """D_n f = (D_n a) df/da + (D_n psi) df/d psi for an expression in a and psi; n = 0 is the fast derivative."""
        rate, turn = self.rates[require_integer(n, "n", 0, len(self.rates) - 1)]
        if not isinstance(f, Expr):
            raise InputError("f", f"{shown(f)} is no expression", "a SymPy expression in a and psi")
        return expand(rate * diff(f, a) + turn * diff(f, psi))

    @public
    def commutator(self, i: int, j: int, *, max_seconds: Number = 60) -> tuple[Expr, Expr]:
        """(D_i D_j - D_j D_i) of a and of psi: zero would mean that a(T_1, T_2, ...), phi(T_1, T_2, ...) exist."""
        last = len(self.rates) - 1
        pairs = zip(*(self.rates[require_integer(n, name, 0, last)] for name, n in (("i", i), ("j", j))))
        # The bracket of two vector fields on the coordinates: D_i of the components of D_j, less the other way round.
        of_a, of_psi = (expand(self.slow_derivative(i, y) - self.slow_derivative(j, x)) for x, y in pairs)
        return of_a, of_psi

    def _sum(self, parts: tuple[Expr, ...]) -> Expr:
        step = self.symbols[0] if len(self.symbols) == 1 else 1
        return Add(*[step**n * term for n, part in enumerate(parts) for term in Add.make_args(part)])

    def __repr__(self) -> str:
        return f"MultipleScales({', '.join(self.shapes)}, orders 0 to {len(self.orders) - 1}, gauge {self.gauge})"

    def _page(self) -> Page:
        rates = (f"da/dtau = {self.amplitude_rate}", f"dpsi/dtau = {self.phase_rate}")
        start = f"a(0) = {self.initial_amplitude}, psi(0) = {self.initial_phase} for X(0) = 1, X'(0) = 0"
        worth = f"orders 0 to {len(self.orders) - 1}, gauge {self.gauge}: exact coefficients, no bound on the remainder"
        return Page(f"X'' + X + {' + '.join(self.shapes)} = 0", (*rates, f"X = {self.waveform}", start, worth))

    def _letters(self) -> dict[str, str]:
        return order_letters(self.gauge)

    def _formula(self) -> str:
        rows = (
            rf"\frac{{da}}{{d\tau}} &= {latex(self.amplitude_rate)}",
            rf"\frac{{d\psi}}{{d\tau}} &= {latex(self.phase_rate)}",
            f"X &= {latex(self.waveform)}",
            f"a(0) &= {latex(self.initial_amplitude)}",
            rf"\psi(0) &= {latex(self.initial_phase)}",
            rf"&\text{{gauge: {self.gauge}}}",
        )
        return r"\displaystyle \begin{aligned}" + r" \\ ".join(rows) + r"\end{aligned}"


def multiple_scales(given: Sequence[int | Term], order: int, *, max_seconds: float = MAX_SECONDS) -> MultipleScales:
    """Solve X'' + X + the forces = 0 for polynomial forces through ``order``, orders shown one by one.

    ``given``: terms (losses with alpha odd and m even, springs with p odd and q even; a pendulum) or odd exponents.
    Raises InputError for other forces or an order below 1, LimitError for more than ``max_seconds``.
    """
    kernel = odd_hierarchy(tuple(given), order, max_seconds=max_seconds)
    terms = tuple(t if isinstance(t, Term) else Term(1, t) for t in given)
    made = _Display(kernel, strength_symbols(terms))
    orders = (leading_order(kernel.gauge), *(made.order(n) for n in range(1, order + 1)))
    shapes = tuple(t.shape() for t in terms)
    return MultipleScales(shapes, made.symbols, orders, initial_conditions(kernel), kernel)


@dataclass(frozen=True)
class _Display:
    """The results of the kernel as SymPy expressions in a, psi and the strengths."""

    kernel: OddHierarchy
    symbols: tuple[Expr, ...]

    def order(self, n: int) -> Order:
        """Order n: nothing is computed here, everything is shown."""
        kernel, (rate, turn) = self.kernel, rate_symbols(n)
        # From here on everything is exact and known: the display only orders it by sin and cos.
        known = {key: kernel.right_side(key) for key in kernel.keys(n)}
        first = {key: c.get(1, fmpq(0)) for key, c in known.items()}
        sine, cosine = (self._sum({k: c for k, c in first.items() if self._is_odd(k) == odd}) for odd in (True, False))
        # f_n = -a p_n and g_n = Omega_n, with which the two conditions hold.
        solved = (-self._homogeneous(kernel.p, n, 1), self._homogeneous(kernel.Omega, n, 0))
        return solved_order(
            n,
            smooth_force(kernel.forces, self.symbols, n),
            self._waves(known),
            ((SECULAR[0], 2 * rate + sine), (SECULAR[1], 2 * a * turn + cosine)),
            solved,
            self._waves({key: kernel.harmonics(key) for key in kernel.keys(n)}),
            kernel.gauge,
        )

    def _is_odd(self, key: Key) -> bool:
        return self.kernel.forces.loss_degree(key) % 2 == 1

    def _monomial(self, key: Key, power: int = 1) -> Expr:
        return strength_monomial(self.kernel.grading, self.symbols, key, power)

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
