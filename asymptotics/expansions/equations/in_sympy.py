"""The amplitude and phase equations as SymPy expressions and equations; printing them and their numbers need none.

>>> from asymptotics.law import Oscillator
>>> drag = Oscillator({"3/2": "1/10"}, mass="3/2", stiffness=30, x0="1/5")
>>> local_strengths(Strengths(drag.dimensionless.terms, drag.dimensionless, drag))
([sqrt(2)*5**(3/4)*sqrt(A)/150], 2*sqrt(5))
"""

import sympy

from asymptotics.expansions.equations.row import CoefficientRow, sum_at
from asymptotics.expansions.equations.strengths import Strengths
from asymptotics.numbers.bridge import to_sympy
from asymptotics.numbers.exact import ExactReal
from asymptotics.terms import Term

A, TAU, T = sympy.Symbol("A", positive=True), sympy.Symbol("tau", real=True), sympy.Symbol("t", real=True)


def right_sides(p: CoefficientRow, Omega: CoefficientRow, strengths: Strengths) -> tuple[sympy.Expr, sympy.Expr]:
    """(dA/dtau, dpsi/dtau) in the symbols A and epsilon, SI numbers for an oscillator."""
    deltas, scale = local_strengths(strengths)
    sums = (sum_at([(k, c.sympy()) for k, c in row.keyed().items()], deltas) for row in (p, Omega))
    amplitude, frequency = sums
    return -scale * A * amplitude, scale * (1 + frequency)


def odes(rates: tuple[sympy.Expr, sympy.Expr], time: sympy.Symbol) -> tuple[sympy.Eq, sympy.Eq]:
    """The two equations for the functions A and psi of the time, from ``right_sides``."""
    functions = sympy.Function("A", positive=True)(time), sympy.Function("psi", real=True)(time)
    right = [rate.subs(A, functions[0]) for rate in rates]
    return tuple(sympy.Eq(sympy.Derivative(f, time), r, evaluate=False) for f, r in zip(functions, right))


def local_strengths(given: Strengths) -> tuple[list[sympy.Expr], sympy.Expr]:
    """(delta_i, omega_0); symbols epsilon where no strength is known."""
    names = ["epsilon"] if given.count == 1 else [f"epsilon_{i}" for i in range(1, given.count + 1)]
    symbols = [sympy.Symbol(n, positive=True) for n in names]
    if given.symbol is not None:
        return [symbols[0] * A ** (given.symbol - 1)], sympy.Integer(1)
    powers = [A ** to_sympy(t.weight) for t in given.terms]
    if given.oscillator is None:
        # A Scaled strength has no exact form: its symbol stands for it.
        known = [t.strength for t in given.law.terms] if given.law is not None else []
        strengths = [to_sympy(e) if isinstance(e, ExactReal) else s for e, s in zip(known or symbols, symbols)]
        return [s * power for s, power in zip(strengths, powers)], sympy.Integer(1)
    k, m = to_sympy(given.oscillator.stiffness), to_sympy(given.oscillator.mass)
    omega = sympy.sqrt(k / m)
    strengths = [_physical(t, omega, k) for t in given.oscillator.law.terms]
    return [s * power for s, power in zip(strengths, powers)], omega


def _physical(t: Term, omega: sympy.Expr, k: sympy.Expr) -> sympy.Expr:
    """b omega_0^velocity/k; a named spring counts the square of the amplitude, whatever m and k are."""
    return to_sympy(t.b) if t.family else to_sympy(t.b) * omega ** to_sympy(t.velocity) / k
