"""One order of the hierarchy as an object that shows itself: equation, secular terms, solvability, solution.

The scales are T_n = eps^n tau and X = X_0 + eps X_1 + ..., d/d tau = D_0 + eps D_1 + eps^2 D_2 + ....  With
X_0 = a cos psi, psi = T_0 + phi, the fast derivative D_0 is d/d psi and the slow ones act through a and phi,

    D_n = (D_n a) d/da + (D_n psi) d/d psi,

vector fields that do *not* commute.  At order n

    D_0^2 X_n + X_n = - sum_(i+j+k=n, k<n) D_i D_j X_k - (the force at order n - 1),

and D_0 D_n + D_n D_0 on X_0 gives 2 (D_n a) sin psi + 2 a (D_n psi) cos psi, by which the secular terms are removed.

>>> force = smooth_force(Forces.losses([3]), (epsilon,), 2)
>>> operator_equation(2, force).rhs                             # D_1 D_1 X_0, D_0 D_2 X_0, D_2 D_0 X_0, ...
-3*V_0**2*V_1 - D_0*D_1*X_1 - D_0*D_2*X_0 - D_1*D_0*X_1 - D_1**2*X_0 - D_2*D_0*X_0
>>> velocity_equation(1)
Eq(V_1, D_0*X_1 + D_1*X_0)
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from sympy import Add, Derivative, Eq, Expr, Function, Mul, Symbol, cos, expand, latex, sin

from asymptotics.expansions.half_swings.forces import Forces, Member
from asymptotics.expansions.half_swings.grading import Grading
from asymptotics.numbers.bridge import to_sympy
from asymptotics.present.shown import Page, Shown
from asymptotics.series import Key
from asymptotics.terms import Term

a = Symbol("a", positive=True)
psi = Symbol("psi", real=True)
epsilon = Symbol("epsilon", positive=True)
theta_0 = Symbol("theta_0", positive=True)
SECULAR = (r"secular, $\sin\psi$", r"secular, $\cos\psi$")
"""The names of the two conditions in the gauge no-first-harmonic."""


def law_symbols(count: int) -> tuple[Expr, ...]:
    """The epsilon_i of several laws; for one law there is only the expansion parameter."""
    return (epsilon,) if count == 1 else tuple(Symbol(f"epsilon_{i}", positive=True) for i in range(count))


def strength_symbols(terms: Sequence[Term]) -> tuple[Expr, ...]:
    """epsilon or epsilon_i of the losses, c or c_j of the springs; theta_0^2 (in rad) of a pendulum's angle unit."""
    springs = [t for t in terms if t.sign > 0]
    losses = len(terms) - len(springs)
    found = symbols_of(losses, springs)
    of_losses, of_springs = iter(found[:losses]), iter(found[losses:])
    return tuple(next(of_losses if t.sign < 0 else of_springs) for t in terms)


def symbols_of(losses: int, springs: Sequence[Term]) -> tuple[Expr, ...]:
    """The same for losses that are only counted, then the springs."""
    plain = sum(not t.family for t in springs)
    numbered = [Symbol(f"c_{j}", real=True) for j in range(plain)]
    names = iter([Symbol("c", real=True)] if plain == 1 else numbered)
    return (*(law_symbols(losses) if losses else ()), *(theta_0**2 if t.family else next(names) for t in springs))


def rate_symbols(n: int) -> tuple[Symbol, Symbol]:
    """f_n = D_n a and g_n = D_n psi before they are known."""
    return Symbol(f"f_{n}", real=True), Symbol(f"g_{n}", real=True)


def solution_symbol(n: int) -> Expr:
    """The unknown X_n as a function of psi."""
    return Function(f"X_{n}")(psi)


def _latex(x: Any) -> str:
    return str(latex(x))


def _plain(name: str) -> str:
    """The name of a condition without LaTeX."""
    return name.replace(r"\psi", " psi").translate(str.maketrans("", "", "${}\\"))


@dataclass(frozen=True, repr=False)
class Order(Shown):
    """Order n of the hierarchy; every field is SymPy, and LaTeX and notebooks show all of it.

    ``hierarchy``: the equation in the operators D_i (noncommutative symbols), with V_k = (X')_k; ``velocity``: V_(n-1);
    ``equation``: everything lower inserted, f_n = D_n a and g_n = D_n psi still unknown; ``conditions``: what must
    vanish, by name: the coefficients of sin psi and cos psi, or X_n and V_n at psi = pi; ``solvability``: the f_n and
    g_n for which it does; ``solution``: X_n (turning-point gauge: on 0 < psi < pi, X(a, psi + pi) = -X(a, psi));
    ``where``: what other letters mean.
    """

    n: int
    hierarchy: Eq
    velocity: Eq | None
    equation: Eq
    conditions: tuple[tuple[str, Expr], ...]
    solvability: tuple[Eq, ...]
    solution: Eq | None
    gauge: str
    where: tuple[Eq, ...] = ()

    @property
    def lines(self) -> tuple[tuple[str, str], ...]:
        """(name, LaTeX) of every displayed line."""
        shown = [(f"order {self.n}", _latex(self.hierarchy))]
        shown += [("velocity", _latex(self.velocity))] if self.velocity is not None else []
        shown += [("equation", _latex(self.equation))]
        shown += [(name, _latex(c) + " = 0") for name, c in self.conditions]
        rates = zip(("a", r"\psi"), self.solvability)
        shown += [("solvability", f"D_{{{self.n}}} {x} = {_latex(e)}") for x, e in rates]
        shown += [(f"solution, {self.gauge}", _latex(self.solution))] if self.solution is not None else []
        return (*shown, *(("with", _latex(e)) for e in self.where))

    def _page(self) -> Page:
        title, *rest = str(self).splitlines()
        return Page(title, (*(line.strip() for line in rest), f"exact; gauge {self.gauge}"))

    def _letters(self) -> dict[str, str]:
        return order_letters(self.gauge)

    def _formula(self) -> str:
        rows = (rf"&\text{{{name}:}} && {line}" for name, line in self.lines)
        return r"\displaystyle \begin{aligned}" + r" \\ ".join(rows) + r"\end{aligned}"

    def __str__(self) -> str:
        parts = [f"order {self.n}: {self.equation.lhs} = {self.equation.rhs}"]
        parts += [f"  {_plain(name)}: {c} = 0" for name, c in self.conditions]
        parts += [f"  D_{self.n} {x} = {e.lhs} = {e.rhs}" for x, e in zip(("a", "psi"), self.solvability)]
        parts += [f"  solution: {self.solution.lhs} = {self.solution.rhs}"] if self.solution is not None else []
        parts += [f"  with {e.lhs} = {e.rhs}" for e in self.where]
        return "\n".join(parts)


def order_letters(gauge: str) -> dict[str, str]:
    """What the letters of a hierarchy mean."""
    return {r"\epsilon": "strength of the loss", "c": "strength of the spring", "X": "displacement, X_n its order n",
            "a": f"slow amplitude, gauge {gauge}", "V": "velocity, V_n its order n", "j": "a number that counts",
            "D": "derivative with respect to a slow time", "I": "integral", "J": "integral", "K": "integral",
            "L": "integral", r"\theta": "angle of the pendulum at the start"}  # fmt: skip


def _operator(n: int) -> Symbol:
    # Symbols that do not commute: SymPy would else write D_1 D_2 for D_2 D_1, the mistake that this hierarchy warns of.
    return Symbol(f"D_{n}", commutative=False)


def _unknown(n: int) -> Symbol:
    return Symbol(f"X_{n}", commutative=False)


def _displacement(n: int) -> Symbol:
    """X_n as a factor of a force, where it is a number and no operator acts on it."""
    return Symbol(f"X_{n}", real=True)


def _velocity(n: int) -> Symbol:
    return Symbol(f"V_{n}", real=True)


def operator_equation(n: int, force: Expr) -> Eq:
    """D_0^2 X_n + X_n = -sum D_i D_j X_k - force, with every product of operators in its own order."""
    # All D_i D_j X_k with i + j + k = n but D_0 D_0 X_n, which stands on the left.
    pairs = [(i, j) for i in range(n + 1) for j in range(n + 1 - i) if i + j]
    known = Add(*[_operator(i) * _operator(j) * _unknown(n - i - j) for i, j in pairs])
    return Eq(_operator(0) ** 2 * _unknown(n) + _unknown(n), expand(-known) - force, evaluate=False)


def velocity_equation(n: int) -> Eq:
    """V_n = D_0 X_n + D_1 X_(n-1) + ... + D_n X_0: the velocity at order n."""
    return Eq(_velocity(n), Add(*[_operator(j) * _unknown(n - j) for j in range(n + 1)]), evaluate=False)


def smooth_force(forces: Forces, symbols: tuple[Expr, ...], n: int) -> Expr:
    """All forces at order n in terms of X_k and V_k = (X')_k, k < n; of one variable the strength is taken out.

    Forces that are no polynomials in V are those of 0 < psi < pi, where V < 0: V|V| = -V^2.
    """
    return Add(*[_at_order(m, symbols, n) for m in forces.through(n)])


def _at_order(member: Member, symbols: tuple[Expr, ...], n: int) -> Expr:
    strength = Mul(*[s**k for s, k in zip(symbols, member.key)]) if len(symbols) > 1 else 1
    factors: list[Callable[[int], Symbol]] = [_displacement] * member.position
    factors += [_velocity] * member.integer_velocity
    odd = (member.integer_velocity + (member.sign < 0)) % 2  # where V < 0: V|V|^(A-1) = -(-V)^A, |V|^Q = (-V)^Q
    return expand((-1) ** odd * to_sympy(member.ratio) * strength * _product_part(factors, n - member.order))


def _product_part(factors: list[Callable[[int], Symbol]], degree: int) -> Expr:
    """The coefficient of eps^degree in a product of series X_0 + eps X_1 + ... and V_0 + eps V_1 + ...."""
    parts: list[Expr] = [Add(1)] + [Add()] * degree
    for factor in factors:
        # One factor after the other: products of truncated series, degree by degree.
        parts = [expand(Add(*[factor(j) * parts[d - j] for j in range(d + 1)])) for d in range(degree + 1)]
    return parts[degree]


def monomial(degrees: tuple[Any, ...], key: Key, power: int = 1, symbols: tuple[Expr, ...] = ()) -> Expr:
    """a^power delta^k in powers of a, times the strengths of several forces (of one force epsilon^n is left out)."""
    total = a ** (power + sum(k * (d - 1) for k, d in zip(key, degrees)))
    if len(degrees) == 1:
        return total
    for symbol, k in zip(symbols or law_symbols(len(degrees)), key):
        total = total * symbol**k
    return total


def solved_order(
    n: int,
    force: Expr,
    forcing: Expr,
    conditions: tuple[tuple[str, Expr], tuple[str, Expr]],
    rates: tuple[Expr, Expr],
    solution: Expr,
    gauge: str,
    *,
    unknown: Expr | None = None,
    where: tuple[Eq, ...] = (),
) -> Order:
    """Order n of the equation X_n'' + X_n = 2 f_n sin psi + 2 a g_n cos psi + ``forcing``.

    ``force``: the forces in the letters of the ansatz; ``rates``: f_n and g_n, by which the ``conditions`` hold;
    ``unknown``: X_n, a function of psi unless it is given.
    """
    (f, g), X_n = rate_symbols(n), solution_symbol(n) if unknown is None else unknown
    right = 2 * f * sin(psi) + 2 * a * g * cos(psi) + forcing
    return Order(
        n,
        operator_equation(n, force),
        velocity_equation(n - 1),
        Eq(Derivative(X_n, (psi, 2)) + X_n, right, evaluate=False),
        conditions,
        tuple(Eq(s, v, evaluate=False) for s, v in zip((f, g), rates)),
        Eq(X_n, solution, evaluate=False),
        gauge,
        where,
    )


def strength_monomial(grading: Grading, symbols: tuple[Expr, ...], key: Key, power: int = 1) -> Expr:
    """a^power delta^key for the degrees of a grading, in a and the strengths."""
    return monomial(tuple(to_sympy(d) for d in grading.degrees), key, power, symbols)


def leading_order(gauge: str) -> Order:
    """X_0 = a cos psi with D_0 a = 0, D_0 psi = 1."""
    X_0, zero = solution_symbol(0), Add()
    solvability = tuple(Eq(s, v, evaluate=False) for s, v in zip(rate_symbols(0), (zero, Add(1))))
    equation = Eq(Derivative(X_0, (psi, 2)) + X_0, 0, evaluate=False)
    hierarchy = operator_equation(0, zero)
    return Order(0, hierarchy, None, equation, (), solvability, Eq(X_0, a * cos(psi)), gauge)
