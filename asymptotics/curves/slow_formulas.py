"""A and phi of one law in D and epsilon, from the hierarchy: closed as far as its rates are, then in decimals.

>>> from asymptotics.expansions.multiple_scales.hierarchy import multiple_scales
>>> scales = multiple_scales(2, order=3, gauge="turning-point")
>>> slow_formulas(scales, Integer(2), 3, 30)
(epsilon**2*(D**2/90 - D/90) + 1, epsilon*(pi*D/8 - pi/8))
"""

import sympy
from flint import fmpq
from sympy import Add, Expr, Integer, Integral

from asymptotics.curves.evaluated import tau
from asymptotics.envelopes.named_slow_time import named_slow_time
from asymptotics.envelopes.slow_time import certified_slow_time, epsilon, expressions, slow_time
from asymptotics.expansions.multiple_scales.orders import a
from asymptotics.expansions.multiple_scales.symbolic import MultipleScales
from asymptotics.expansions.multiple_scales.turning import TurningHierarchy
from asymptotics.numbers.policy import exact_number
from asymptotics.series import Key, Series

CLOSED_ORDER = 4
"""Through which a symbolic exponent has its rates written out; beyond, p_k and Omega_k stand by name."""


def slow_formulas(scales: MultipleScales, alpha: Expr, order: int, digits: int) -> tuple[Expr, Expr]:
    """A/A_0 and phi in D and epsilon; at alpha = 1 in tau and epsilon.  ``digits`` of the rates that do not close."""
    kernel = scales.kernel
    # From what is shortest to what is general: letters for a symbol, the exponential decay of the linear law (which
    # divides by no alpha - 1), exact polynomials, and closed forms continued by decimals.
    if not alpha.is_number and order > CLOSED_ORDER:
        return named_slow_time(alpha, order)
    if alpha == 1:
        return Integer(1), Add(*[epsilon**n * g * tau for n, (_, g) in enumerate(scales.rates) if n])
    if isinstance(kernel, TurningHierarchy):
        return expressions(slow_time(fmpq(int(alpha)), kernel.p, kernel.Omega))
    rates = list(enumerate(scales.rates))[1:]
    p: dict[Key, Expr] = {(n,): -f.subs(a, 1) for n, (f, _) in rates if f != 0}
    Omega: dict[Key, Expr] = {(n,): g.subs(a, 1) for n, (_, g) in rates if g != 0}
    # The first rate that is a decimal ends the exact part: rates through ``closed`` fix A and phi through
    # epsilon^(closed-1), and the balls give what comes after, so no order is counted twice.
    numbers = [n for row in (p, Omega) for (n,), c in row.items() if c.has(sympy.Float)]
    closed = min([*numbers, order + 1]) - 1
    exact = slow_time(alpha, *(Series(row, 1, order).truncate(closed) for row in (p, Omega)))
    if not numbers:
        return expressions(exact)
    decimals = certified_slow_time(exact_number(alpha, "alpha"), order, digits, above=closed - 1)
    relative, phase = (e + rest for e, rest in zip(expressions(exact), decimals))
    return relative, phase


def closed_wave(scales: MultipleScales, n: int) -> Expr | None:
    """x_n(psi), or None where it is an open integral."""
    found = scales.orders[n].solution
    return None if found is None or found.rhs.has(Integral) else found.rhs.subs(a, 1)
