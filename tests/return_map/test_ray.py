"""Which laws share a map: those that differ in the unit of amplitude, and no others."""

import pytest
from flint import arb, ctx

from asymptotics.law import Law, Oscillator
from asymptotics.return_map.coordinate import Coordinate
from asymptotics.return_map.ray import ray_of

ONE = [
    ({"3/2": "1/5"}, {"3/2": 7}),
    ({"sqrt(2)": "1/5"}, {"sqrt(2)": "sqrt(3)"}),
    ({1: "1/5", 2: "1/9"}, {2: 3, 1: "1/5"}),
    ({"3/2": "1/10", 2: "1/50"}, {"3/2": "1/5", 2: "2/25"}),
    ({0: "1/10", 2: "1/5"}, {0: "1/5", 2: "1/10"}),
    ({"1/2": "1/10"}, {"1/2": 1, 2: 0}),
]
TWO = [
    ({"3/2": "1/5"}, {"8/5": "1/5"}),
    ({1: "1/5", 2: "1/9"}, {1: "1/6", 2: "1/9"}),
    ({"3/2": "1/10", 2: "1/50"}, {"3/2": "1/5", 2: "1/25"}),
    ({0: "1/10", 2: "1/5"}, {0: "1/5", 2: "1/5"}),
    ({"5/4": "1/3", "4/3": "1/5"}, {"5/4": "1/2", "4/3": "1/5"}),  # no exact unit: each law alone
    ({"1.00001": "1/3", 2: "1/5"}, {"1.00001": "1/2", 2: "1/5"}),
]


@pytest.mark.parametrize(("one", "other"), ONE, ids=str)
def test_laws_in_other_units_of_amplitude_are_one_ray(one, other):
    assert ray_of(Law(one))[0] == ray_of(Law(other))[0] and hash(ray_of(Law(one))[0]) == hash(ray_of(Law(other))[0])


@pytest.mark.parametrize(("one", "other"), TWO, ids=str)
def test_other_laws_are_other_rays(one, other):
    assert ray_of(Law(one))[0] != ray_of(Law(other))[0]


@pytest.mark.parametrize("losses", [{"3/2": "1/10", 2: "1/50"}, {"6/5": "1/10", 2: "1/50"}, {0: "1/9", "4/3": "1/50"}])
def test_every_start_of_one_oscillator_is_one_ray(losses):
    """Also where strengths are no exact numbers; amplitudes are those of the ray in the unit of length."""
    starts = [Oscillator(losses, mass=3, stiffness=7, x0=x0).dimensionless for x0 in (1, "1/3", 9)]
    assert len({ray_of(law)[0] for law in starts}) == 1 and len({str(law) for law in starts}) == 3
    other = Oscillator(losses, mass=3, stiffness=8, x0=9).dimensionless
    assert ray_of(other)[0] != ray_of(starts[2])[0]
    for law in starts:
        test_the_strengths_at_the_place_of_an_amplitude_are_those_of_the_law(law)


@pytest.mark.parametrize(
    "law",
    [{"3/2": "1/7"}, {1: "1/20", 3: "5/3"}, {"3/2": "1/10", 2: "1/50"}, {0: "1/10", 2: "1/5"}, {"1/2": "3/7"}],
    ids=str,
)
def test_the_strengths_at_the_place_of_an_amplitude_are_those_of_the_law(law):
    """delta_i = epsilon_i A^(alpha_i - 1), by the law itself and through the unit of its ray."""
    law = Law.read(law)
    ray, log_unit = ray_of(law)
    with ctx.workprec(100):
        c, A = Coordinate.of(ray.terms()), arb(5) / 7
        unit = c.unit(log_unit())
        z = c(A) + unit if c.root is None else c(A) * unit
        found = dict(zip(ray.alphas, c.strengths(z), strict=True))
        for term in law.terms:
            assert found[term.velocity].overlaps(term.delta(A)) and found[term.velocity].rad() < arb(2) ** -80


def test_out_of_all_proportion_a_law_is_alone():
    """A unit of 10^300, or a power of 50: its own strengths, and no lead."""
    for law in ({"3/2": "1e-150", 2: 1}, {"1.04": "1/2", 3: "1/5"}):
        ray, log_unit = ray_of(Law(law))
        assert log_unit() == 0 and set(ray.strengths) == {t.strength for t in Law(law).terms}
    assert ray_of(Law({1: 3}))[1]() == 0
