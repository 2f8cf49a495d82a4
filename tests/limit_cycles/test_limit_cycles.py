"""Limit cycles: the literature, the flow of the normal form as a second route, an integrator, and near misses."""

import json
from fractions import Fraction

import numpy as np
import pytest
from flint import arb, ctx, fmpq
from scipy.integrate import solve_ivp

from asymptotics.cli.main import main
from asymptotics.errors import InputError, LimitError
from asymptotics.expansions.half_swings.fourier_flow import fourier_flow
from asymptotics.law import Law
from asymptotics.limit_cycles.certified import _at_rest, certified_limit_cycle
from asymptotics.limit_cycles.half_cycle import half_cycle
from asymptotics.limit_cycles.result import limit_cycle
from asymptotics.limit_cycles.series import limit_cycle_series
from asymptotics.numbers.exact import ExactReal

VAN_DER_POL, RAYLEIGH = Law({1: -1, (1, 2): 1}), Law({1: -1, 3: 1})
# Andersen and Geer, SIAM J. Appl. Math. 42 (1982) 678: the frequency through mu^8
FREQUENCY = {0: fmpq(1), 2: fmpq(-1, 16), 4: fmpq(17, 3072), 6: fmpq(35, 884736), 8: fmpq(-678899, 5096079360)}


def test_van_der_pol_is_the_series_of_the_literature():
    found = limit_cycle_series(VAN_DER_POL, 8)
    assert found.frequency == FREQUENCY
    assert found.square == 4
    assert {k: 2 * c for k, c in found.amplitude.items() if k < 6} == {0: 2, 2: fmpq(1, 96), 4: fmpq(-1033, 552960)}


def test_rayleigh_has_the_frequency_and_the_multiplier_of_van_der_pol():
    """x'' + x + mu (x'^3/3 - x') = 0 differentiates to van der Pol for x'; the amplitude differs."""
    one, two = limit_cycle_series(VAN_DER_POL, 10), limit_cycle_series(RAYLEIGH, 10)
    assert one.frequency == two.frequency and one.log_multiplier == two.log_multiplier
    assert one.amplitude != two.amplitude


def test_order_24_is_exact():
    found = limit_cycle_series(VAN_DER_POL, 24)
    assert found.frequency[24] != 0 and found.is_exact


@pytest.mark.parametrize("law", [VAN_DER_POL, RAYLEIGH, Law({1: -1, (1, 4): "1/2"})])
def test_the_flow_of_the_normal_form_vanishes_on_the_cycle(law):
    """U = 0 and omega = 1/W at delta_i = mu E_i A^(d_i-1), A from the cycle: another engine, at the turning points."""
    order = 7
    cycle, flow = limit_cycle_series(law, order - 1), fourier_flow(law.terms, order)
    mu = [fmpq(0)] * (order + 1)
    square = poly_square([cycle.amplitude.get(k, fmpq(0)) for k in range(order)], order)
    deltas = []
    for t in law.terms:
        half = (int(t.velocity.rational) + t.position - 1) // 2
        E = fmpq(t.b.rational.numerator, t.b.rational.denominator) * cycle.square**half
        power = [fmpq(1)] + mu[1:]
        for _ in range(half):
            power = product(power, square, order)
        deltas.append([fmpq(0)] + [E * c for c in power[:-1]])
    for series, expected in ((flow.U, {}), (flow.W.inverse(), cycle.frequency)):
        total = [fmpq(0)] * (order + 1)
        for key, c in series.coefficients.items():
            term = [c.as_rational() if hasattr(c, "as_rational") else fmpq(c)] + mu[1:]
            for d, n in zip(deltas, key):
                for _ in range(n):
                    term = product(term, d, order)
            total = [a + b for a, b in zip(total, term)]
        assert total[:order] == [expected.get(k, 0) for k in range(order)]


def product(a, b, order):
    return [sum((a[j] * b[n - j] for j in range(n + 1)), start=fmpq(0)) for n in range(order + 1)]


def poly_square(a, order):
    padded = a + [fmpq(0)] * (order + 1 - len(a))
    return product(padded, padded, order)


def test_certified_cycle_against_an_integrator_and_the_series():
    found = certified_limit_cycle(VAN_DER_POL, ExactReal(Fraction(1, 2)), 15, 2.0)
    run = solve_ivp(
        lambda t, y: [y[1], -y[0] - 0.5 * (y[0] ** 2 - 1) * y[1], 0.5 * (y[0] ** 2 - 1)],
        (0, float(found.period)), [float(found.amplitude), 0, 0], rtol=1e-12, atol=1e-13,
    )  # fmt: skip
    assert run.y[0, -1] == pytest.approx(float(found.amplitude), abs=1e-9)
    assert np.exp(-run.y[2, -1]) == pytest.approx(float(found.multiplier), rel=1e-8)
    series = limit_cycle_series(VAN_DER_POL, 24)
    value = sum(2 * float(int(c.p) / int(c.q)) * 0.5**k for k, c in series.amplitude.items())
    assert value == pytest.approx(float(found.amplitude), abs=1e-12)
    assert found.stable is True
    assert certified_limit_cycle(VAN_DER_POL, ExactReal(Fraction(-1, 2)), 10, 2.0).stable is False


def test_the_half_turn_encloses_and_bites():
    """At a low precision the ball contains the fine value; a wide start gives a wide image, and its midpoint misses."""
    with ctx.workprec(160):
        fine = half_cycle(VAN_DER_POL.terms, arb(1), arb(2))
    with ctx.workprec(80):
        coarse = half_cycle(VAN_DER_POL.terms, arb(1), arb(2))
        wide = half_cycle(VAN_DER_POL.terms, arb(1), arb(2, 1e-9))
    for name in ("q", "T", "J"):
        assert getattr(coarse, name).contains(getattr(fine, name))
        assert getattr(coarse, name).rad() < 1e-10
    with ctx.workprec(160):
        edge = half_cycle(VAN_DER_POL.terms, arb(1), arb(2) + arb(10) ** -9)
    assert wide.q.contains(edge.q) and wide.q.contains(fine.q)
    assert not wide.q.mid().overlaps(edge.q)


@pytest.mark.parametrize("spring", [{3: "1/2"}, {3: "-1/10"}, {5: "1/20", (1, 2): "1/4"}])
def test_springs_beside_the_laws_at_a_number(spring):
    """The cycle by an integrator; F' = (f(A)/f(q)) e^(-J) - 1 against a difference of half-turns, A/q for f is off."""
    found = limit_cycle(Law({1: -1, (1, 2): 1}, spring=spring), 4, 12, ExactReal(Fraction(1, 2))).at
    forces = [(float(t.strength.ball()), t.position, int(t.velocity.rational)) for t in Law({}, spring).terms]

    def field(_, y):
        return [y[1], -y[0] - sum(c * y[0] ** p * y[1] ** q for c, p, q in forces) - 0.5 * (y[0] ** 2 - 1) * y[1]]

    start = [float(found.amplitude), 0.0]
    run = solve_ivp(field, (0, float(found.period)), start, rtol=1e-12, atol=1e-13, method="DOP853")
    assert run.y[:, -1] == pytest.approx(start, abs=1e-9)
    terms, away = Law({1: -1, (1, 2): 1}, spring=spring).terms, 1.7
    near, far = (half_cycle(terms, arb(1) / 2, arb(away) + s * arb(10) ** -5) for s in (-1, 1))
    middle = half_cycle(terms, arb(1) / 2, arb(away))
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
        assert found.at.stable is stable


@pytest.mark.parametrize(
    ("spring", "mu"), [({3: 1}, None), ({2: 1}, 1), ("pendulum", 1), ({(3, 1): 1}, 1), ({(3, "1/2"): 1}, 1)]
)
def test_springs_that_are_not_served_are_refused_by_name(spring, mu):
    with pytest.raises(InputError, match="argument spring"):
        limit_cycle(Law({1: -1, (1, 2): 1}, spring=spring), 4, 10, None if mu is None else ExactReal(mu))


@pytest.mark.parametrize(
    ("law", "reason"),
    [
        (Law({1: 1}), "balance"),
        (Law({1: 1, 3: 1}), "balance"),
        (Law({2: -1, 3: 1}), "polynomial"),
        (Law({1: -1, (1, 1): 1}), "polynomial"),
        (Law({1: -1, (1, 2): 1}, spring={3: 1}), "linear spring"),
        (Law({1: 1, (1, 2): -5, (1, 4): 1}), "2 limit cycles"),
        (Law({1: "-sqrt(2)", 3: 1}), "irrational"),
    ],
)
def test_laws_without_one_cycle_are_refused_by_name(law, reason):
    with pytest.raises(InputError, match=reason):
        limit_cycle_series(law, 4)


def test_bad_numbers():
    with pytest.raises(LimitError):
        limit_cycle_series(VAN_DER_POL, 61)
    for mu in (0, 21):
        with pytest.raises(InputError, match="mu"):
            certified_limit_cycle(VAN_DER_POL, ExactReal(mu), 10, 2.0)


def test_irrational_amplitudes_are_certified():
    found = limit_cycle(Law({1: -1, (1, 2): 1, (1, 4): "1/7"}), 4, 20)
    more = limit_cycle(Law({1: -1, (1, 2): 1, (1, 4): "1/7"}), 4, 30)
    assert found.arithmetic == "certified"
    assert all(more.frequency[k].value[:15] == c.value[:15] for k, c in found.frequency.items())


def test_the_contract(capsys):
    assert main(["limit-cycle", "--law", "1:-1", "--law", "1,2:1", "--order", "8", "--json", "--digits", "10"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert data["amplitude"]["2"] == {"value": "0.01041666667", "exact": "1/96"}
    assert list(data["frequency"]) == ["0", "2", "4", "6", "8"]
    assert data["frequency"]["8"]["exact"] == "-678899/5096079360"
    line = "limit-cycle --law 1:-1 --law 1,2:1 --spring 3:1/2 --mu 1 --digits 10"
    assert main([*line.split(), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["at"]["amplitude"].startswith("1.95363")
    assert main(line.split()) == 0 and "x'' + x + 1/2 x^3 + mu (-x' + x^2 x')" in capsys.readouterr().out
    assert main(["limit-cycle", "--law", "1:-1", "--law", "1,2:1", "--near", "-1"]) == 2
    assert main(["limit-cycle", "--law", "1:1"]) == 2
