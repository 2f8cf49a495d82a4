"""What must hold of every half-swing at any strength, on random laws: two motions, two units, one law more."""

from fractions import Fraction

from flint import arb, ctx
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from asymptotics.errors import UndecidedError
from asymptotics.flow.damping import Damping
from asymptotics.law import Law
from asymptotics.return_map.half_swing_map import HalfSwingBalls, integrated
from asymptotics.testing import strategies
from tests.properties.in_time import answered_in_time

LONGER = max(1, settings().max_examples // 80)  # the nightly profile draws more

BITS = 60
laws = strategies.laws(2, strategies.exponents(high=3), strategies.strengths("1/50", "3/2"))
sizes = st.fractions(Fraction(1, 4), 2, max_denominator=16)


def ball(q: Fraction) -> arb:
    return arb(q.numerator) / q.denominator


def swing(law: Law, p: Fraction, scale: Fraction = Fraction(1)) -> HalfSwingBalls:
    """From the amplitude p; with ``scale``, of the law that the same motion obeys in units of length 1/scale."""
    with ctx.workprec(BITS + 20):
        terms = [(t.strength.ball() * ball(scale) ** (1 - t.velocity.ball()), t.velocity) for t in law.terms]
        damping = Damping.of(terms)
    with ctx.workprec(BITS):
        return integrated(damping, ball(p).mid())


def turning(law: Law, p: Fraction) -> HalfSwingBalls:
    """The half-swing, where there is one and it is quickly had."""
    with answered_in_time(law):
        found = swing(law, p)
    assume(found.ended is None)
    return found


@settings(max_examples=25 * LONGER)
@given(laws, sizes, sizes)
def test_two_motions_never_part(law, p, other):
    """|q - q'| <= |p - p'|, for every nondecreasing law, friction included."""
    a, b = turning(law, p), turning(law, other)
    with ctx.workprec(BITS):
        assert not abs(a.amplitude * ball(p) - b.amplitude * ball(other)) > abs(ball(p - other)) + arb("1e-12")


@settings(max_examples=25 * LONGER)
@given(laws, sizes)
def test_one_law_more_takes_more(law, p):
    """A further loss lowers the next amplitude: q falls strictly, by any exponent."""
    more = Law({**{t.velocity: t.strength for t in law.terms}, "7/4": "1/4"})
    assert turning(more, p).amplitude < turning(law, p).amplitude < 1


@settings(max_examples=25 * LONGER)
@given(laws, st.sampled_from([Fraction(2), Fraction(1, 4)]))
def test_a_unit_of_length_changes_nothing(law, scale):
    """From p in a unit of length c the strengths are epsilon c^(1 - alpha): the ratio q/p and the time stay."""
    here = turning(law, Fraction(1))
    there = swing(law, scale, scale)
    assert there.amplitude.overlaps(here.amplitude)
    assert there.duration.overlaps(here.duration)
    assert there.amplitude.rad() < 1e-10


@settings(max_examples=25 * LONGER)
@given(laws, st.integers(20, 60))
def test_few_bits_contain_what_many_bits_say(law, bits):
    found = turning(law, Fraction(1))
    with ctx.workprec(bits):
        damping = Damping.of_law(law)
        try:
            rough = integrated(damping, arb(1))
        except UndecidedError:
            return
    assert rough.ended is None
    assert rough.amplitude.overlaps(found.amplitude)
    assert rough.duration.overlaps(found.duration)
