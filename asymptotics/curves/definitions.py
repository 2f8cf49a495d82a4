"""What the letters of a solution mean where waveforms or rates do not close: X_j, f_j, g_j, K_j, L_j, V_j, p_j, ...

>>> from asymptotics.curves.solve import solution
>>> [str(e.lhs) for e in definitions_of(solution("symbolic", order=5))][4:8]
['p_1', 'Omega_2', 'p_3', 'Omega_4']
"""

from typing import Any

from sympy import Eq, Expr, Integral, Symbol

from asymptotics.envelopes.named_slow_time import rate_letters
from asymptotics.expansions.multiple_scales.orders import a, rate_symbols


def definitions_of(s: Any) -> list[Eq]:
    """The equations of the letters of a ``Solution``, from the orders of its hierarchy."""
    # x needs the waveforms through N - 1; the rates of order N enter A and phi, and are added below where they are
    # open.
    shown, weight = s.scales.orders[1 : s.order], s.alpha - 1
    powers = [Eq(e.solution.lhs, a ** (1 + e.n * weight) * Symbol(f"x_{e.n}")) for e in shown if e.solution is not None]
    found = [*powers, *_named(s), *(e for one in shown for e in (*one.solvability, *one.where))]
    last = s.scales.orders[s.order]
    if any(_is_held(s, n, side) and rate.has(Integral) for n, side, rate in _rates(s) if n == s.order):
        found += [*last.solvability, *last.where[:-1]]  # without V_N
    return found


def _rates(s: Any) -> list[tuple[int, int, Expr]]:
    """(n, 0 for f and 1 for g, the rate) where the theorem of reversal leaves one."""
    # Under reversal of time the losses change sign and with them every odd power of epsilon: A changes at odd orders
    # alone, the phase at even ones (derivation ``parity-of-flow``).
    return [(n, (n + 1) % 2, s.scales.rates[n][(n + 1) % 2]) for n in range(1, s.order + 1)]


def _is_held(s: Any, n: int, side: int) -> bool:
    """Whether A or phi hold the letter p_n or Omega_n."""
    return rate_letters(s.order)[side][n] in s.relative.free_symbols | s.slow_phase.free_symbols


def _named(s: Any) -> list[Eq]:
    """p_n and Omega_n where A and phi hold them by name: closed, or from f_n and g_n."""
    found, letters = [], rate_letters(s.order)
    for n, side, rate in _rates(s):
        # f_n = -a p_n (a^(alpha-1))^n and g_n = Omega_n (a^(alpha-1))^n: homogeneous in the amplitude.
        open_form = rate_symbols(n)[side] / a ** (1 - side + n * (s.alpha - 1))
        value = open_form if rate.has(Integral) else rate.subs(a, 1)
        found += [Eq(letters[side][n], value if side else -value, evaluate=False)] if _is_held(s, n, side) else []
    return found
