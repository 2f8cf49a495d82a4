"""x'' + x + epsilon x'^3 = 0, order by order: the exact engine beside other tools, amplitude and phase law alike.

>>> expand_by_hand(3)                                   # p_1, Omega_2, p_3 in the no-first-harmonic gauge
[3/8, 9/256, 351/8192]
"""

import shutil
import subprocess
from functools import partial
from math import inf, nan
from time import perf_counter

import sympy
from sympy import I, Symbol

from asymptotics.expansions.normal_form.expansion import exact_expansion
from benchmarks.peers import ask
from benchmarks.table import Table, best_time, with_ratios

q = Symbol("q")
PEERS = ("oscilate",)
TIMEOUT = 30

OSCILATE = """
start = process_time()
from sympy import Function, symbols
from oscilate import MMS
omega0, b, eps = symbols("omega0 b epsilon", positive=True)
t = symbols("t")
x = Function("x", real=True)(t)
system = MMS.Dynamical_system(t, x, x.diff(t, 2) + omega0**2 * x + b * x.diff(t)**3, omega0)
_, scaled = MMS.scale_parameters((b,), (1,), eps)
MMS.Multiple_scales_oscillator(system, eps, {order}, omega0, scaled).apply_MMS(orders_polar=0)
answer = {{"seconds": process_time() - start}}
"""
MAXIMA = 'load("rand/averm.mac")$ averm();\ny;\ny;\n1;\n-zdot^3;\n{order};\n'


def expand_by_hand(order: int) -> list[sympy.Expr]:
    """p_1, Omega_2, p_3, ... by plain SymPy: x = a sum_k delta^k X_k(q), q = e^(i psi), X_k without first harmonic.

    At each order the first harmonic of the equation fixes a' = -a sum p_k delta^k and psi' = 1 + sum Omega_k delta^k,
    delta = epsilon a^2, and the other harmonics m are divided by 1 - m^2.
    """
    X = [(q + 1 / q) / 2]
    p: list[sympy.Expr] = [sympy.Integer(0)]
    frequency: list[sympy.Expr] = [sympy.Integer(1)]
    for n in range(1, order + 1):
        p_n, Omega_n = Symbol("p_n"), Symbol("Omega_n")
        terms = residual_term([*X, sympy.Integer(0)], [*p, p_n], [*frequency, Omega_n], n)
        harmonics = sympy.Poly(sympy.expand(terms * q ** (2 * n + 1)), q)
        c = {m: harmonics.coeff_monomial(q ** (m + 2 * n + 1)) for m in range(-2 * n - 1, 2 * n + 2)}
        solved = sympy.solve([c[1], c[-1]], [p_n, Omega_n], dict=True)[0]
        p.append(solved[p_n])
        frequency.append(solved[Omega_n])
        X.append(sum(x.subs(solved) * q**m / (m**2 - 1) for m, x in c.items() if m not in (-1, 1)))
    return [(p if n % 2 else frequency)[n] for n in range(1, order + 1)]


def residual_term(X: list[sympy.Expr], p: list[sympy.Expr], frequency: list[sympy.Expr], n: int) -> sympy.Expr:
    """The coefficient of epsilon^n a^(2n+1) in x'' + x + epsilon x'^3."""
    velocity = slow_derivative(X, p, frequency)
    acceleration = slow_derivative(velocity, p, frequency)
    cube = sum(velocity[i] * velocity[j] * velocity[n - 1 - i - j] for i in range(n) for j in range(n - i))
    return acceleration[n] + X[n] + cube


def slow_derivative(f: list[sympy.Expr], p: list[sympy.Expr], frequency: list[sympy.Expr]) -> list[sympy.Expr]:
    """d/d tau of a sum_k delta^k f_k(q): psi' i q d/dq on f_k, and a' acting on a^(2k+1)."""
    return [
        sympy.expand(
            sum(frequency[n - k] * I * q * sympy.diff(f[k], q) - (2 * k + 1) * p[n - k] * f[k] for k in range(n + 1))
        )
        for n in range(len(f))
    ]


def oscilate_seconds(order: int) -> float | None:
    """One run of oscilate (its imports included), None if it is not installed."""
    return ask(OSCILATE.format(order=order))["seconds"]


def maxima_seconds(order: int) -> float | None:
    """One run of Maxima's averm (its start included), None if Maxima is not installed."""
    program = shutil.which("maxima")
    return process_seconds([program, "--very-quiet"], MAXIMA.format(order=order)) if program else None


def process_seconds(command: list[str], text: str, timeout: float = TIMEOUT) -> float:
    """Seconds of one process; nan if it fails or prints an error, infinity if it is stopped after ``timeout`` seconds.

    >>> import sys
    >>> process_seconds([sys.executable, "-c", "raise SystemExit(1)"], "")
    nan
    """
    start = perf_counter()
    try:
        run = subprocess.run(command, input=text, capture_output=True, text=True, timeout=timeout, check=False)
    except subprocess.TimeoutExpired:
        return inf
    failed = run.returncode != 0 or "-- an error" in run.stdout  # Maxima reports errors on stdout and exits with 0
    return nan if failed else perf_counter() - start


def run(size: int = 3) -> Table:
    """Orders 1 ... size: seconds, and the ratio to the exact engine; other tools only if they are installed."""
    rows = []
    for order in range(1, size + 1):
        exact = partial(exact_expansion, (3,), order, "no-first-harmonic")
        rows += with_ratios(
            [
                (f"order {order}, exact engine", best_time(exact)),
                (f"order {order}, SymPy by hand", best_time(partial(expand_by_hand, order), 3 if order < 4 else 1)),
                (f"order {order}, oscilate", oscilate_seconds(order)),
                (f"order {order}, Maxima averm", maxima_seconds(order)),
            ]
        )
    return Table("x'^3, amplitude and phase law in one gauge", ("what", "seconds", "ratio"), tuple(rows))
