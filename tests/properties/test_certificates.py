"""A third route to what is printed: a page of standard Python, which shares nothing with it, accepts it."""

from contextlib import contextmanager
from fractions import Fraction
from math import lcm

from hypothesis import assume, given, note, settings
from hypothesis import strategies as st

from asymptotics import turning_points
from asymptotics.certificates.of_results import of_states, of_turning_points
from asymptotics.errors import InputError
from asymptotics.law import Oscillator
from asymptotics.motions.reference import reference_motion
from asymptotics.numbers.exact import ExactReal
from asymptotics.testing import strategies
from tests.properties.in_time import answered_in_time

LONGER = max(1, settings().max_examples // 80)  # the nightly profile draws more

TROUBLE = [Fraction(0), Fraction(1, 7), Fraction(999, 1000), Fraction(1), Fraction(1001, 1000), Fraction(7, 2)]
exponents = st.one_of(st.sampled_from(TROUBLE), st.fractions(0, 4, max_denominator=4))
laws = strategies.laws(2, exponents.map(ExactReal), strategies.strengths("1/100", "1"))


@settings(max_examples=4 * LONGER if LONGER > 1 else 2)
@given(laws, strategies.states(), st.integers(1, 4), st.integers(3, 30))
def test_turning_points_are_accepted(law, state, count, digits):
    oscillator = started(law, state)
    with answered_in_time(law):
        table = turning_points(oscillator, count, digits=digits, times=True)
    with certified(law):
        proved = of_turning_points(oscillator, table).proved[1:]
    assert len(proved) == len(table.points) + (table.ended is not None and table.ended["reason"] == "sticks")


@settings(max_examples=4 * LONGER)
@given(laws, strategies.states(), st.fractions(Fraction(1, 10), 12, max_denominator=10), st.integers(3, 30))
def test_states_are_accepted(law, state, t, digits):
    oscillator = started(law, state)
    with answered_in_time(law):
        point = reference_motion(oscillator, t, digits)
    with certified(law):
        assert len(of_states(oscillator, [(t, point)], digits).proved) == 2


def started(law, state):
    # Series in s^(1/q) with q in the thousands take minutes.
    assume(lcm(*(t.velocity.rational.denominator for t in law.terms)) <= 1000)
    oscillator = Oscillator({t.velocity: t.strength for t in law.terms}, x0=state[0], v0=state[1])
    note(str(oscillator))
    return oscillator


@contextmanager
def certified(law):
    """What is refused by name is no example: exact places, and what costs too much."""
    try:
        with answered_in_time(law):
            yield
    except InputError as refused:
        assume(refused.argument != "certificate")
        raise
