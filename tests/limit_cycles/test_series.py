"""The series of a limit cycle: the literature, and the flow of the normal form as a second route."""

import pytest
from flint import fmpq, fmpq_poly

from asymptotics.errors import InputError, LimitError, UndecidedError
from asymptotics.expansions.half_swings.fourier_flow import fourier_flow
from asymptotics.law import Law
from asymptotics.limit_cycles.certified import certified_limit_cycle
from asymptotics.limit_cycles.series import _positive_roots, limit_cycle_series
from asymptotics.numbers.exact import ExactReal

VAN_DER_POL_LAW, RAYLEIGH = Law({1: -1, (1, 2): 1}), Law({1: -1, 3: 1})
# Andersen and Geer, SIAM J. Appl. Math. 42 (1982) 678: the frequency through mu^8
FREQUENCY = {0: fmpq(1), 2: fmpq(-1, 16), 4: fmpq(17, 3072), 6: fmpq(35, 884736), 8: fmpq(-678899, 5096079360)}


def product(a, b, order):
    return [sum((a[j] * b[n - j] for j in range(n + 1)), start=fmpq(0)) for n in range(order + 1)]


def poly_square(a, order):
    padded = a + [fmpq(0)] * (order + 1 - len(a))
    return product(padded, padded, order)


def test_a_double_root_of_the_balance_has_no_series():
    assert _positive_roots(fmpq_poly([-2, 1])) == [2]
    with pytest.raises(UndecidedError, match="double root"):
        _positive_roots(fmpq_poly([4, -4, 1]))


def test_van_der_pol_is_the_series_of_the_literature():
    found = limit_cycle_series(VAN_DER_POL_LAW, 8)
    assert found.frequency == FREQUENCY
    assert found.square == 4
    assert {k: 2 * c for k, c in found.amplitude.items() if k < 6} == {0: 2, 2: fmpq(1, 96), 4: fmpq(-1033, 552960)}


def test_rayleigh_has_the_frequency_and_the_multiplier_of_van_der_pol():
    """x'' + x + mu (x'^3/3 - x') = 0 differentiates to van der Pol for x'; the amplitude differs."""
    one, two = limit_cycle_series(VAN_DER_POL_LAW, 10), limit_cycle_series(RAYLEIGH, 10)
    assert one.frequency == two.frequency and one.log_multiplier == two.log_multiplier
    assert one.amplitude != two.amplitude


def test_order_24_is_exact():
    found = limit_cycle_series(VAN_DER_POL_LAW, 24)
    assert found.frequency[24] != 0 and found.is_exact


@pytest.mark.parametrize("law", [VAN_DER_POL_LAW, RAYLEIGH, Law({1: -1, (1, 4): "1/2"})])
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
        limit_cycle_series(VAN_DER_POL_LAW, 61)
    for mu in (0, 21):
        with pytest.raises(InputError, match="mu"):
            certified_limit_cycle(VAN_DER_POL_LAW, ExactReal(mu), 10, 2.0)
