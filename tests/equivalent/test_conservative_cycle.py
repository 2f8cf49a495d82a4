"""One cycle without loss in balls: against 2F1, against itself at other precisions, and at the ends of the well."""

import pytest
from flint import acb, arb, ctx

from asymptotics.equivalent.conservative_cycle import ConservativeCycle, Spring, _power
from asymptotics.errors import InputError
from asymptotics.expansions.straightening.wells import Loss, Well
from asymptotics.law import Law

WELLS = [
    ({"3/2": "1/10"}, "pendulum"), ({2: "1/10", 0: "1/7"}, "pendulum"), ({"1/2": "1/3"}, {3: "1/2"}),
    ({(1, 2): "1/10", 3: "1/5"}, {3: "-1/2"}), ({"sqrt(2)": "1/10"}, {3: 4}),
]  # fmt: skip
ALL = [*WELLS, ({"3/2": "1/10", (0, 1): "1/9"}, {2: "1/2"}), ({2: 1}, {5: "1/3", 3: "-1/9"}), ({"5/2": 1}, None)]


def orbit(losses, spring):
    law = Law(losses, spring=spring)
    return ConservativeCycle.of(law.terms, [t.strength.ball() for t in law.terms])


@pytest.mark.parametrize(("losses", "spring"), WELLS, ids=str)
def test_the_quadrature_is_the_hypergeometric_function(losses, spring):
    law = Law(losses, spring=spring)
    with ctx.workprec(100):
        found = orbit(losses, spring)
        c = law.springs[0].strength.ball()
        well = Well.pendulum(c) if spring == "pendulum" else Well.duffing(c)
        s = -well.xi(arb(1)).log()
        parts = [
            t.strength.ball() * well.loss(Loss(t.strength.ball(), t.velocity.ball(), t.position), s) for t in law.losses
        ]
        expected = sum(parts[1:], start=parts[0])
        assert found.zeta.overlaps(expected) and found.zeta.rad() < 1e-20
        assert not (found.zeta * arb("1.000000001")).overlaps(expected)


@pytest.mark.parametrize(("losses", "spring"), ALL, ids=str)
def test_every_rung_of_an_orbit_holds_what_is_above_it(losses, spring):
    def numbers(bits):
        with ctx.workprec(bits):
            o = orbit(losses, spring)
            return o.energy, o.force, o.lost, o.action, o.period, o.zeta, o.quality, o.decrement, o.coefficient

    truth = numbers(200)
    for bits in (30, 53, 90, 140):
        for rough, fine in zip(numbers(bits), truth, strict=True):
            assert rough.contains(fine) and rough.rad() <= abs(fine) * arb(2) ** (20 - bits)


def test_the_spring_of_an_orbit_is_its_potential():
    law = Law({2: 1}, spring={3: "1/2", 2: "-1/5"})
    with ctx.workprec(120):
        spring = Spring.of(law.terms, [t.strength.ball() for t in law.terms])
        for x in (arb("0.1"), arb("0.6"), arb("0.99")):
            twice = 2 * (spring.potential(arb(1)) - spring.potential(x)) / (1 - x)
            assert spring.stiffness(acb(x)).real.overlaps(twice)
        step = arb(2) ** -40
        slope = (spring.potential(1 + step) - spring.potential(1 - step)) / (2 * step)
        assert abs(slope - spring.force()) < 1e-20


def test_the_size_of_a_power_near_zero_is_attained():
    box, near = acb(arb(0, 0.5), arb(0, 0.5)), arb("0.4999")
    flat, steep = arb("1.01"), arb("1.99")
    assert _power(box, flat, False).contains(acb(near) ** acb(flat))
    assert _power(box, steep, False).contains(acb(near, near) ** acb(steep))
    assert not acb(_power(box, flat, False) / 2).contains(acb(near) ** acb(flat))
    assert not acb(_power(box, steep, False) / 2).contains(acb(near, near) ** acb(steep))
    assert not _power(box, flat, True).is_finite()


def test_near_the_top_of_the_well_the_orbit_is_long_but_loses_no_more():
    """At 3.1 rad: zeta of viscous damping is the action over 8 pi E, and the action tends to 16."""
    with ctx.workprec(80):
        law = Law({1: "1/10"}, spring="pendulum")
        amplitude = arb("3.1")
        found = ConservativeCycle.of(law.terms, [arb("0.1"), amplitude**2])
        assert abs(found.action * amplitude**2 - 16) < 0.05
        assert abs(found.coefficient - arb("0.1")) < 1e-15


def test_a_spring_that_depends_on_the_velocity_has_no_potential():
    law = Law({2: 1}, spring={(1, 2): 1})
    with pytest.raises(InputError, match="no potential"):
        Spring.of(law.terms, [arb(1), arb(1)])
