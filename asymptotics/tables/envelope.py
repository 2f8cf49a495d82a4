"""First-order envelopes as formulas: Lancaster's Table I, for the paper's exponents and for the symbol alpha."""

from sympy import Expr, Integer, Rational

from asymptotics.envelopes.symbolic import alpha, averaged_law

_EXPONENTS: tuple[Expr, ...] = (Integer(0), Integer(1), Rational(3, 2), Integer(2), Integer(3), alpha)


def lancaster_table_1(_digits: int) -> tuple[tuple[str, ...], ...]:
    """Rows (alpha, A(t)), exact; the last row is (13) for any alpha other than 1.  Digits do not matter."""
    return tuple((str(a), str(averaged_law(a).physical_amplitude())) for a in _EXPONENTS)
