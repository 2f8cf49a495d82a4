"""What the averaged law says in closed form: amplitudes, times of two laws, where its motion ends, the phase lost.
First and second order of averaging (Bogoliubov and Mitropolsky): these formulas are enclosed, not the motion.

Lengths and times are in units of x0 and 1/omega_0 except in Lancaster's Table I, which is in SI.
"""

from fractions import Fraction
from functools import partial

from flint import arb
from sympy import Expr, Integer, Rational, latex

from asymptotics.envelopes.certified import extinction_time, time
from asymptotics.envelopes.symbolic import alpha, averaged_law
from asymptotics.errors import InputError
from asymptotics.expansions.moments.certified import moment
from asymptotics.law import Law
from asymptotics.numbers.bridge import to_sympy
from asymptotics.numbers.decimals import certified_decimal
from asymptotics.numbers.exact import ExactReal
from asymptotics.tables.cells import Cell, Formula, Nearest
from asymptotics.tables.inputs import Inputs, label
from asymptotics.tables.recipe import Found

# The exponents of Lancaster's printed table, and his (13) for a letter.
_PRINTED: tuple[Expr, ...] = (Integer(0), Integer(1), Rational(3, 2), Integer(2), Integer(3), alpha)
# Pairs on both sides of 1 and around it, among them those at which one of the two forms by 2F1 breaks down.
_PAIRS = (("0", "1/2"), ("0", "1"), ("0", "2"), ("1/2", "3/2"), ("1", "2"), ("1", "3"), ("3/2", "2"), ("2", "3"))
_AMPLITUDES = (Fraction(9, 10), Fraction(1, 2), Fraction(1, 10))


def lancaster_table_1(inputs: Inputs, _digits: int) -> Found:
    """Rows (alpha, A(t)), exact; the last default row is (13) for any alpha other than 1.  Digits do not matter."""
    exponents = [to_sympy(a) for a in inputs.alphas] or list(_PRINTED)
    rows: list[tuple[Cell, ...]] = []
    for a in exponents:
        amplitude = averaged_law(a).physical_amplitude()
        rows.append((Formula(str(a), latex(a)), Formula(str(amplitude), latex(amplitude))))
    return Found(rows, True)


def two_law_times(inputs: Inputs, digits: int) -> Found:
    """Rows (law, A, tau): when the averaged amplitude of two laws has fallen to A; A = 0 is the extinction time."""
    rows: list[tuple[Cell, ...]] = []
    for law in _pairs(inputs):
        for amplitude in _AMPLITUDES:
            tau = certified_decimal(partial(_time, law, amplitude), digits)
            rows.append((label(law), str(amplitude), Nearest(tau)))
        if any(t.velocity < 1 for t in law.terms):
            rows.append((label(law), "0", Nearest(certified_decimal(partial(_end, law), digits))))
    return Found(rows, True)


def extinction_times(inputs: Inputs, digits: int) -> Found:
    """Rows (alpha, epsilon, tau_e) for alpha < 1: the fictitious end 1/((1-alpha) M_(alpha+1) epsilon)."""
    rows: list[tuple[Cell, ...]] = []
    for a in inputs.alphas_or(("0", "1/4", "1/3", "1/2", "2/3", "3/4")):
        if not a < 1:
            raise InputError("alpha", f"{a}: the averaged law never ends", "exponents below 1")
        for epsilon in inputs.epsilons_or("1/10"):
            law = Law({a: epsilon})
            rows.append((str(a), str(epsilon), Nearest(certified_decimal(partial(_end, law), digits))))
    return Found(rows, True)


def phase_lags(inputs: Inputs, digits: int) -> Found:
    """Rows (alpha, epsilon, lag) for alpha > 1: -phi at tau = infinity, to second order."""
    rows: list[tuple[Cell, ...]] = []
    for a in inputs.alphas_or(("5/4", "3/2", "2", "5/2", "3", "4", "5")):
        if not a > 1:
            raise InputError("alpha", f"{a}: the lag grows without bound", "exponents above 1")
        for epsilon in inputs.epsilons_or("1/10"):
            rows.append((str(a), str(epsilon), _lag_cell(a, epsilon, digits)))
    return Found(rows, True)


def _lag_cell(a: ExactReal, epsilon: ExactReal, digits: int) -> Cell:
    # Rational lags may be ties: exact cells.  M_(2 alpha) is rational for every integer alpha, M_(alpha+1) for odd
    # ones.
    if a.is_integer and a.rational.numerator % 2 and epsilon.is_rational:  # both moments are rational
        exact = averaged_law(a.rational.numerator).w_2 / averaged_law(a.rational.numerator).p_1 / (to_sympy(a) - 1)
        return Fraction(int(exact.p), int(exact.q)) * epsilon.rational
    return Nearest(certified_decimal(lambda: _lag(a.ball()) * epsilon.ball(), digits))


def _lag(a: arb) -> arb:
    """w_2/((alpha-1) p_1), w_2 = (alpha/(alpha+1))^2 M_(2 alpha), p_1 = M_(alpha+1)."""
    return (a / (a + 1)) ** 2 * moment(2 * a) / ((a - 1) * moment(a + 1))


def _pairs(inputs: Inputs) -> list[Law]:
    if inputs.law is None:
        return [Law({low: e, high: e}) for low, high in _PAIRS for e in inputs.epsilons_or("1/10")]
    if len(inputs.law.terms) != 2:
        raise InputError("law", "this table is about two laws", "a law of two terms")
    return [inputs.law]


def _kappas(law: Law) -> list[tuple[ExactReal, arb]]:
    return [(t.velocity, moment(t.velocity.ball() + 1) * t.strength.ball()) for t in law.terms]


def _time(law: Law, amplitude: Fraction) -> arb:
    return time(_kappas(law), ExactReal(amplitude).ball())


def _end(law: Law) -> arb:
    found = extinction_time(_kappas(law))
    # Never reached: the callers ask for exponents below 1 alone.  NaN would be undecided, not printed.
    return arb.nan() if found is None else found
