"""Hypothesis strategies that look for trouble: exact data, with the corners drawn as often as the rest: property-based
testing, in which a failure is shrunk to the simplest law that has it.

>>> from hypothesis import find
>>> str(find(exponents(), lambda a: 1 < a < 2))                    # the simplest exponent between 1 and 2
'1001/1000'
"""

from fractions import Fraction

from hypothesis import strategies as st

from asymptotics.law import Law, Oscillator
from asymptotics.numbers.exact import ExactReal, square_root

# Exponents at which something changes: friction, the linear law, integers, where waveforms are polynomials, and halves.
CORNERS = [Fraction(n, d) for n, d in ((0, 1), (1, 2), (1, 1), (3, 2), (2, 1), (5, 2), (3, 1), (4, 1))]
NEAR_TROUBLE = [Fraction(n, d) for n, d in ((1, 100), (99, 100), (1001, 1000), (1999, 1000), (7, 1))]
"""Next to dry friction, to the linear law from both sides, to an integer; and a high power."""


def exponents(low: int = 0, high: int = 5) -> st.SearchStrategy[ExactReal]:
    """Exponents in [low, high]: the usual ones, their neighbours, fractions, and square roots."""
    named = [q for q in NEAR_TROUBLE + CORNERS if low <= q <= high]
    # Small denominators, which make the expansions power series in |v|^(1/q); roots are exponents without any.
    fractions = st.fractions(low, high, max_denominator=12)
    roots = st.fractions(low * low, high * high, max_denominator=6).map(square_root)
    return st.one_of(st.sampled_from(named).map(ExactReal), fractions.map(ExactReal), roots)


def strengths(
    low: Fraction | str = Fraction(1, 100), high: Fraction | str = Fraction(2)
) -> st.SearchStrategy[Fraction]:
    """Strengths in [low, high] as fractions."""
    # From weak damping to 2, the critical strength of the linear law.
    return st.fractions(Fraction(low), Fraction(high), max_denominator=1000)


def laws(
    max_terms: int = 3,
    alphas: st.SearchStrategy[ExactReal] | None = None,
    sizes: st.SearchStrategy[Fraction] | None = None,
) -> st.SearchStrategy[Law]:
    """Dimensionless laws of 1 ... ``max_terms`` terms; equal exponents are merged, so there may be fewer."""
    chosen = st.lists(alphas if alphas is not None else exponents(), min_size=1, max_size=max_terms, unique_by=str)
    size = sizes if sizes is not None else strengths()
    return chosen.flatmap(lambda a: st.tuples(*[size] * len(a)).map(lambda e: Law(dict(zip(a, e)))))


def states() -> st.SearchStrategy[tuple[Fraction, Fraction]]:
    """(x0, v0) away from rest at 0: from rest, through the centre, both signs, very different sizes."""
    number = st.one_of(st.sampled_from([Fraction(0), Fraction(1), Fraction(-1), Fraction(1, 1000)]), strengths())
    signed = st.tuples(number, st.sampled_from([1, -1])).map(lambda p: p[0] * p[1])
    # Rest at the centre is no start: nothing moves.
    return st.tuples(signed, signed).filter(any)


def oscillators(of: st.SearchStrategy[Law] | None = None) -> st.SearchStrategy[Oscillator]:
    """Oscillators in SI with any start; the drawn strengths are read as b."""
    positive = strengths("1/10", "30")
    drawn = st.tuples(of if of is not None else laws(), positive, positive, states())
    return drawn.map(lambda d: Oscillator(d[0], mass=d[1], stiffness=d[2], x0=d[3][0], v0=d[3][1]))
