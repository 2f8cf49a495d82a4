"""A(tau) and phi(tau) of one law with a symbolic exponent, the coefficients of its equations held under their names.

From order 5 on the rates p_k, Omega_k of a symbolic exponent are open integrals, or products of gamma functions that
nobody wants to see expanded.  In the unit 1/p_1 of time only p_k/p_1, Omega_k/p_1 and W = 1/(alpha-1) occur in
``slow_time``, as polynomials over Q; so its coefficients are made in that ring and written with the letters p_1, p_3,
..., Omega_2, ..., which the solution defines.

>>> from asymptotics.envelopes.slow_time import epsilon
>>> from asymptotics.expansions.half_swings.symbolic import alpha
>>> relative, phase = named_slow_time(alpha, 4)
>>> phase.coeff(epsilon, 1)
-D*Omega_2/(p_1*(alpha - 1)) + Omega_2/(p_1*(alpha - 1))
>>> relative.coeff(epsilon, 2)
D**2*p_3/(p_1*(alpha - 1)) - D*p_3/(p_1*(alpha - 1))
"""

from typing import Any

from flint import fmpq, fmpq_mpoly, fmpq_mpoly_ctx
from sympy import Add, Expr, Mul, Symbol

from asymptotics.envelopes.laurent import envelope_of_series
from asymptotics.envelopes.slow_time import explicit, expression
from asymptotics.numbers.bridge import to_sympy
from asymptotics.series import Series


def rate_letters(order: int) -> tuple[dict[int, Expr], dict[int, Expr]]:
    """The letters p_k (k odd) and Omega_k (k even) through ``order``."""
    p = {k: Symbol(f"p_{k}", positive=True if k == 1 else None, real=True) for k in range(1, order + 1, 2)}
    return p, {k: Symbol(f"Omega_{k}", real=True) for k in range(2, order + 1, 2)}


def named_slow_time(exponent: Expr, order: int) -> tuple[Expr, Expr]:
    """A/A_0 and phi in D, epsilon, the exponent and the letters of ``rate_letters``."""
    p, Omega = rate_letters(order)
    names = [*(f"p_{k}" for k in p if k > 1), *(f"Omega_{k}" for k in Omega)]
    # W stands for 1/(alpha - 1): what is left are polynomials over Q, and no quotient of symbols is ever simplified.
    ring = fmpq_mpoly_ctx.get(("W", *names), "lex")
    W, *gens = ring.gens()
    places = dict(zip(names, gens))
    rates, detuning = (
        # p_1 is the unit of the rates, so its own coefficient is 1.
        Series({(k,): places.get(f"{name}_{k}", 1) for k in letters}, 1, order)
        for name, letters in (("p", p), ("Omega", Omega))
    )
    envelope = envelope_of_series(exponent, rates, detuning)
    values = [1 / (exponent - 1), *(p[k] for k in p if k > 1), *Omega.values()]
    found = explicit(envelope, order - 1, W)

    def written(c: Any) -> Expr:
        """A polynomial over Q with its letters."""
        if not isinstance(c, fmpq_mpoly):
            return to_sympy(fmpq(c))
        return Add(*[_monomial(key, q, values, p[1]) for key, q in c.to_dict().items()])

    amplitude, phase = (expression(series, written) for series in found)
    return amplitude, phase


def _monomial(key: tuple[int, ...], q: fmpq, values: list[Expr], p_1: Expr) -> Expr:
    """The monomial q W^i prod (c_k/p_1)^n_k."""
    powers = [v**n for v, n in zip(values, key)]
    return to_sympy(q) * Mul(*powers) / p_1 ** sum(key[1:])
