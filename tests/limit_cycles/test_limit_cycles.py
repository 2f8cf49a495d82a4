"""Limit cycles as they are asked for: springs, one of several, refusals."""

from fractions import Fraction

import pytest
from flint import arb
from scipy.integrate import solve_ivp

from asymptotics.errors import InputError
from asymptotics.law import Law
from asymptotics.limit_cycles.certified import _at_rest
from asymptotics.limit_cycles.half_cycle import half_cycle as half_turn
from asymptotics.limit_cycles.result import limit_cycle
from asymptotics.numbers.exact import ExactReal


@pytest.mark.parametrize("spring", [{3: "1/2"}, {3: "-1/10"}, {5: "1/20", (1, 2): "1/4"}])
def test_springs_beside_the_laws_at_a_number(spring):
    """The cycle by an integrator; F' = (f(A)/f(q)) e^(-J) - 1 against a difference of half-turns, A/q for f is off."""
    found = limit_cycle(Law({1: -1, (1, 2): 1}, spring=spring), 4, 12, ExactReal(Fraction(1, 2))).at_mu
    forces = [(float(t.strength.ball()), t.position, int(t.velocity.rational)) for t in Law({}, spring).terms]

    def field(_, y):
        return [y[1], -y[0] - sum(c * y[0] ** p * y[1] ** q for c, p, q in forces) - 0.5 * (y[0] ** 2 - 1) * y[1]]

    start = [float(found.amplitude), 0.0]
    run = solve_ivp(field, (0, float(found.period)), start, rtol=1e-12, atol=1e-13, method="DOP853")
    assert run.y[:, -1] == pytest.approx(start, abs=1e-9)
    terms, away = Law({1: -1, (1, 2): 1}, spring=spring).terms, 1.7
    near, far = (half_turn(terms, arb(1) / 2, arb(away) + s * arb(10) ** -5) for s in (-1, 1))
    middle = half_turn(terms, arb(1) / 2, arb(away))
    rest = _at_rest(terms, arb(1) / 2)
    slope = rest(arb(away)) / rest(middle.q) * (-middle.J).exp()
    difference = (far.q - near.q) / (arb(2) * arb(10) ** -5)
    assert abs(float(difference - slope)) < 1e-7
    assert abs(float(difference - away / middle.q * (-middle.J).exp())) > 1e-3


def test_one_of_several_cycles_by_its_amplitude():
    law = Law({1: 1, (1, 2): -5, (1, 4): 1})  # A^4 - 10 A^2 + 8 = 0: A^2 = 5 +- sqrt(17)
    for near, square, stable in ((0.5, 5 - 17**0.5, False), (4, 5 + 17**0.5, True)):
        found = limit_cycle(law, 2, 15, ExactReal(Fraction(1, 100)), near)
        assert float(found.amplitude["0"].value) == pytest.approx(square**0.5, abs=1e-13)
        assert found.at_mu.stable is stable


@pytest.mark.parametrize(
    ("spring", "mu"), [({3: 1}, None), ({2: 1}, 1), ("pendulum", 1), ({(3, 1): 1}, 1), ({(3, "1/2"): 1}, 1)]
)
def test_springs_that_are_not_served_are_refused_by_name(spring, mu):
    with pytest.raises(InputError, match="argument spring"):
        limit_cycle(Law({1: -1, (1, 2): 1}, spring=spring), 4, 10, None if mu is None else ExactReal(mu))


def test_irrational_amplitudes_are_certified():
    found = limit_cycle(Law({1: -1, (1, 2): 1, (1, 4): "1/7"}), 4, 20)
    more = limit_cycle(Law({1: -1, (1, 2): 1, (1, 4): "1/7"}), 4, 30)
    assert found.arithmetic == "certified"
    assert all(more.frequency[k].value[:15] == c.value[:15] for k, c in found.frequency.items())


def test_the_cycle_at_a_number_is_at_mu_and_the_old_name_says_so():
    """``at`` is a method of every other result; in JSON the key stays."""
    law = Law({1: -1, (1, 2): 1})
    found, alone = limit_cycle(law, 2, 8, ExactReal(1)), limit_cycle(law, 2, 8)
    assert found.to_dict()["at"] == found.at_mu.to_dict() and alone.at_mu is None and alone.to_dict()["at"] is None
    for each in (found, alone):
        with pytest.raises(InputError, match=r"argument at: .*\.at_mu"):
            _ = each.at
