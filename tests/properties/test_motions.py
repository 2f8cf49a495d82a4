"""What must hold of every motion in physical units: other units change nothing, and energy goes to the damping."""

from fractions import Fraction

from flint import arb, ctx
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from asymptotics.flow.damping import Damping
from asymptotics.flow.dense import states
from asymptotics.flow.linear_spring.linear_spring import LinearSpring
from asymptotics.law import Law, Oscillator
from asymptotics.motions.reference import reference_motion
from asymptotics.testing import strategies
from tests.properties.in_time import answered_in_time

LONGER = max(1, settings().max_examples // 80)  # the nightly profile draws more

laws = strategies.laws(2, strategies.exponents(high=3), strategies.strengths("1/50", "1"))
scales = st.sampled_from([Fraction(2), Fraction(1, 3), Fraction(10)])
NODES, WEIGHTS = (  # Gauss-Legendre with 12 nodes on (-1, 1); half of them, the rule is symmetric
    ("0.1252334085114689", "0.3678314989981802", "0.5873179542866175", "0.7699026741943047", "0.9041172563704749",
     "0.9815606342467193"),
    ("0.2491470458134028", "0.2334925365383548", "0.2031674267230659", "0.1600783285433462", "0.1069393259953184",
     "0.0471753363865118"),
)  # fmt: skip


@settings(max_examples=10 * LONGER)
@given(laws, strategies.states(), scales, st.fractions(Fraction(1, 10), 8, max_denominator=10))
def test_other_units_of_length_and_time_change_nothing(law, state, c, time):
    """x = c y(t/c): y has the stiffness k c^2 and the strengths c b, for every exponent, and the speed stays."""
    (x0, v0), k = state, Fraction(7, 3)
    assume(abs(x0) + abs(v0) > Fraction(1, 100))
    scaled = {t.velocity: t.strength.rational * c for t in law.terms}
    with answered_in_time(law):
        here = reference_motion(Oscillator(law, mass=1, stiffness=k, x0=x0, v0=v0), time, 12)
    with answered_in_time(law):  # each has the time of a public call: a creep at 1/100 beside 1001/1000 takes 39 s
        there = reference_motion(Oscillator(scaled, mass=1, stiffness=k * c * c, x0=x0 / c, v0=v0), time / c, 12)
    assert abs(Fraction(here.x) - c * Fraction(there.x)) <= Fraction(here.error) + c * Fraction(there.error)
    assert abs(Fraction(here.v) - Fraction(there.v)) < Fraction(1, 10**8) * (1 + abs(Fraction(here.v)))


@settings(max_examples=10 * LONGER)
@given(laws)
def test_the_energy_that_is_missing_is_the_work_of_the_damping(law):
    """(X^2 + X'^2)/2 falls by int sum eps_i |X'|^(alpha_i + 1) dtau, between two times within a half-swing."""
    first, last = arb("0.4"), arb("1.8")
    places = [(first + last) / 2 + s * arb(u) * (last - first) / 2 for u in NODES for s in (-1, 1)]
    order = sorted(range(12), key=lambda i: float(places[i]))
    with ctx.workprec(80):
        with answered_in_time(law):
            found = states(
                LinearSpring(Damping.of_law(law)), arb(1), arb(0), [first, *(places[i].mid() for i in order), last]
            )
        assume(all(bool(arb("-0.01") > V) for _, V in found))  # moving all the time, towards the other side
        terms = [(t.strength.ball(), t.velocity.ball() + 1) for t in law.terms]
        power = {i: sum((e * (-V) ** a for e, a in terms), arb(0)) for i, (_, V) in zip(order, found[1:-1])}
        work = sum((power[i] * arb(WEIGHTS[i // 2]) for i in range(12)), arb(0)) * (last - first) / 2
        energies = [(X**2 + V**2) / 2 for X, V in (found[0], found[-1])]
        lost = energies[0] - energies[1]
        assert abs(lost - work) < arb("1e-7") * (1 + lost)
        assert lost > 0
        assert not abs(lost - work * arb("1.0001")) < arb("1e-7") * (1 + lost) or lost < arb("0.01")


def test_a_law_of_another_strength_is_seen():
    """Near miss: with the strength unscaled the two motions part."""
    here = reference_motion(Oscillator({2: "1/2"}, mass=1, stiffness=1, x0=1), 3, 12)
    there = reference_motion(Oscillator(Law({2: "1/2"}), mass=1, stiffness=4, x0="1/2"), "3/2", 12)
    assert abs(Fraction(here.x) - 2 * Fraction(there.x)) > Fraction(1, 1000)
