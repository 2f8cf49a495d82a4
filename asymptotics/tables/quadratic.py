"""The tables for quadratic damping."""

from functools import partial
from itertools import islice

from flint import arb, fmpq

from asymptotics.invariants.certified import first_constant
from asymptotics.invariants.symbolic import generating_functions
from asymptotics.numbers.decimals import certified_decimal
from asymptotics.turning.quadratic_map import amplitudes

_HALF_CYCLES = 6
_ORDER = 24


def smith_table_1(digits: int) -> tuple[tuple[str, ...], ...]:
    """Rows (n, S_(n-1), u_(n-1)) of Smith's Table I for u_0 = 1; S_0 = 0 by definition."""
    rows = []
    for n in range(_HALF_CYCLES):
        constant = certified_decimal(partial(smith_offset, n), digits) if n else "0"
        amplitude = certified_decimal(partial(_amplitude, n), digits)
        rows.append((str(n + 1), constant, "-" + amplitude if n % 2 else amplitude))
    return tuple(rows)


def smith_offset(n: int) -> arb:
    """S_n = S - S^-(|u_n|): what makes the first constant continuous over the n-th turning point, for u_0 = 1."""
    return first_constant(arb(1), arb(0)) - first_constant(_amplitude(n), arb(0))


def _amplitude(n: int) -> arb:
    return next(islice(amplitudes(arb(2)), n, None)) / 2


def transit_time(_digits: int) -> tuple[tuple[str, ...], ...]:
    """Rows (i, H_i(pi)/pi), exact; the number of digits does not matter."""
    return tuple((str(g.i), str(g.P(fmpq(-1)))) for g in islice(generating_functions(), _ORDER + 1))
