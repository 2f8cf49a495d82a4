"""The tables for quadratic damping: Smith's Table I for any start and any length, and his coefficients."""

from fractions import Fraction
from itertools import islice

import sympy
from flint import arb, fmpq

from asymptotics.motions.invariants.certified import first_constant
from asymptotics.motions.invariants.exact import coefficients
from asymptotics.motions.invariants.symbolic import generating_functions
from asymptotics.numbers.bridge import to_sympy
from asymptotics.numbers.decimals import MAX_BITS, bits_for, decimal_of_ball
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.precision import at_growing_precision
from asymptotics.numbers.rationals import to_fraction
from asymptotics.running.budget import tick
from asymptotics.tables.cells import Cell, Formula, Nearest, Rows
from asymptotics.tables.inputs import Inputs
from asymptotics.tables.recipe import Found, rows_in_progress
from asymptotics.turning.quadratic_map import amplitudes

# Default lengths; --rows goes on.
_HALF_CYCLES, _TRANSIT_ORDER, _ROWS = 6, 24, 12
_ONE = ExactReal(Fraction(1))


def smith_table_1(inputs: Inputs, digits: int) -> Found:
    """Rows (u_0, n, S_(n-1), u_(n-1)) of Smith's Table I, S_0 = 0 by definition; u_0 is left out where it is 1."""
    rows: Rows = []
    for u_0 in inputs.epsilons_or("1"):
        rows = _half_cycles(rows, u_0, inputs.count(_HALF_CYCLES), digits)
    return Found(rows if inputs.epsilons else [row[1:] for row in rows], True)


def _half_cycles(before: Rows, u_0: ExactReal, count: int, digits: int) -> Rows:
    """The rows ``before``, and those of n < count, at growing precision until all are decided."""

    def attempt(_bits: int) -> Rows | None:
        start = u_0.ball()
        constant = first_constant(start, arb(0))
        rows = rows_in_progress()
        rows.extend(before)
        # ``amplitudes`` is in p = 2|u|, by W_0 of Lambert's function: a contraction, so that the radius of p grows by
        # roundings alone (derivation ``smith-contraction``).
        for n, p in enumerate(islice(amplitudes(2 * start), count)):
            tick(f"row {n} of {count}")
            # S_0 = 0 by definition: any ball that rounds will do in its place, and 0 is printed below.
            offset = constant - first_constant(p / 2, arb(0)) if n else arb(1)
            S, u = decimal_of_ball(offset, digits), decimal_of_ball(-p / 2 if n % 2 else p / 2, digits)
            if S is None or u is None:
                return None
            first: Cell = u_0.rational if n == 0 and u_0.is_rational else Nearest(u)
            rows.append((str(u_0), str(n + 1), Nearest(S) if n else Fraction(0), first))
        return rows

    # n steps add n roundings, log2 n bits of them; twice that and 48 bits more decide nearly every first pass, and a
    # pass that they do not is repeated at twice the bits.
    return at_growing_precision(attempt, digits, bits_for(digits, 48) + 2 * count.bit_length(), max_bits=MAX_BITS)


def transit_time(inputs: Inputs, _digits: int) -> Found:
    """Rows (i, H_i(pi)/pi), exact; the number of digits does not matter."""
    first = islice(generating_functions(), inputs.count(_TRANSIT_ORDER + 1))
    # H_i = theta P_i(cos theta) + sin theta R_i: at theta = pi it is pi P_i(-1).
    return Found([(str(g.i), str(to_fraction(g.P(fmpq(-1))))) for g in first], True)


def smith_c(inputs: Inputs, _digits: int) -> Found:
    """Rows (n, i, C_i^n, value), n up to --rows."""
    rows = rows_in_progress()
    for n in range(1, inputs.count(_ROWS, per_row=inputs.rows or _ROWS) + 1):
        rows += [(str(n), str(i), str(c), c) for i, c in coefficients(n).items()]
    return Found(rows, True)


def smith_f(inputs: Inputs, _digits: int) -> Found:
    """Rows (n, f_n(w)), n up to --rows."""
    w = sympy.Symbol("w")
    rows = rows_in_progress()
    for n in range(1, inputs.count(_ROWS, per_row=inputs.rows or _ROWS) + 1):
        f = sum((to_sympy(ExactReal(c)) * w**i for i, c in coefficients(n).items()), sympy.S.Zero)
        rows.append((str(n), Formula(str(f), sympy.latex(f))))
    return Found(rows, True)
