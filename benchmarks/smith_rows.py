"""Smith's rows C_i^1 ... C_i^n by (62a): one integer polynomial per row beside rational arithmetic of three kinds.

All routes compute every row up to n, keep two, and end with row n as fractions in lowest terms.

>>> rational_rows(4, Fraction)[1:]
[Fraction(-2, 3), Fraction(0, 1), Fraction(16, 35)]
"""

from collections.abc import Callable
from fractions import Fraction
from functools import partial
from inspect import getsource
from typing import Any

import sympy

from asymptotics.motions.invariants.exact import coefficients
from benchmarks.peers import ask
from benchmarks.table import Table, best_time, with_ratios

ONCE_ABOVE = 200
"""Rational arithmetic is timed three times up to this row, and once above."""


def rational_rows(last: int, number: Callable[[int, int], Any]) -> list[Any]:
    """Row ``last`` by (n+i) C_i^n = 2(n-1) C_(i-1)^(n-1) - (n-2) C_i^(n-2) in the given rational type."""
    zero = number(0, 1)
    before: list[Any] = []
    row = [number(1, 1)]
    for n in range(2, last + 1):
        shifted = [zero, *row]
        below = [*before, zero, zero]
        before, row = (
            row,
            [(2 * (n - 1) * shifted[i] - (n - 2) * below[i]) / (n + i) if (n - i) % 2 else zero for i in range(n)],
        )
    return row


PEERS = ("gmpy2", "cypari")
NUMBERS = {
    "gmpy2.mpq": "import gmpy2; number = gmpy2.mpq",
    "PARI": "from cypari import pari; number = lambda p, q: pari(p) / q",
}
ROUTE = """
from typing import Any
from collections.abc import Callable
{setup}
{source}
seconds, row = best(lambda: rational_rows(last, number), 1)
answer = {{"seconds": seconds}}
"""


def peer_seconds(last: int, setup: str) -> float | None:
    """The same function in the peers' environment, with their rational type."""
    return ask(ROUTE.format(setup=setup, source=getsource(rational_rows)), last=last)["seconds"]


def run(size: int = 400) -> Table:
    """Rows 1 ... n in the integer kernel and in rationals, for n = size/8, size/4, size/2 and size."""
    rows = []
    for n in (max(2, size // 8), max(2, size // 4), max(2, size // 2), size):
        timings: list[tuple[str, float | None]] = [(f"n = {n}, integer kernel", best_time(partial(coefficients, n)))]
        for number in (Fraction, sympy.Rational):
            once = best_time(partial(rational_rows, n, number), 3 if n <= ONCE_ABOVE else 1)
            timings.append((f"n = {n}, {number.__module__.split('.')[0]}.{number.__name__}", once))
        timings += [(f"n = {n}, {name}", peer_seconds(n, setup)) for name, setup in NUMBERS.items()]
        rows.extend(with_ratios(timings))
    return Table("Smith's coefficients, all rows up to n", ("what", "seconds", "ratio"), tuple(rows))
