from fractions import Fraction

import pytest
from flint import arb
from hypothesis import given, settings
from hypothesis import strategies as st

from asymptotics.errors import InputError, LimitError
from asymptotics.numbers.decimals import bits_for
from asymptotics.numbers.exact import ExactReal, parse_real
from asymptotics.turning.quadratic_duration import node_count
from asymptotics.turning.quadratic_map import next_amplitude
from asymptotics.turning.routes import quadratic
from tests.second_route.forced import quadratic_turning_points

ONE = parse_real("1", "--epsilon")


@settings(max_examples=20)
@given(st.fractions(min_value=1e-6, max_value=1000), st.integers(1, 40), st.integers(0, 30))
def test_fewer_digits_are_a_rounding_of_more(epsilon, digits, start):
    few, many = (quadratic_turning_points(ExactReal(epsilon), 2, d, start=start).points for d in (digits, digits + 25))
    for a, b in zip(few, many):
        x, y = parse_real(a.x, "x").rational, parse_real(b.x, "y").rational
        assert abs(x - y) <= abs(y) * 6 / 10 ** min(digits, 40)  # half a unit of the last digit, both roundings
        assert a.n == b.n
        assert (x > 0) == (a.n % 2 == 0)


def test_the_two_methods_print_the_same_digits(monkeypatch):
    direct = quadratic_turning_points(parse_real("sqrt(2)", "e"), 2, 40, start=3000, times=True)
    monkeypatch.setattr(quadratic, "_DIRECT", 100)
    jumped = quadratic_turning_points(parse_real("sqrt(2)", "e"), 2, 40, start=3000, times=True)
    assert direct.points == jumped.points
    assert direct.method != jumped.method


def test_the_billionth_turning_point_follows_the_leading_law():
    # Psi = 3/(2p) + p/15 + ...: p_n = 3/(2n) (1 + O(log n / n) corrections from the start), here to nine digits.
    point = quadratic_turning_points(ONE, 1, 50, start=10**9).points[0]
    assert point.x.startswith("7.49999999")
    assert point.x.endswith("e-10")
    assert len(point.x) == 50 + len(".e-10")


@pytest.mark.parametrize("epsilon", ["0", "-1", "1e-13", "1e13"])
def test_amplitudes_out_of_range_are_refused(epsilon):
    with pytest.raises(InputError, match="negative|quadratic does not serve"):
        quadratic_turning_points(parse_real(epsilon, "--epsilon"), 1, 10)


@pytest.mark.parametrize(
    ("count", "digits", "start", "times", "argument"),
    [
        (0, 10, 0, False, "count"),
        (100_001, 10, 0, False, "count"),
        (1, 0, 0, False, "digits"),
        (1, 10_001, 0, False, "digits"),
        (1, 10, -1, False, "start"),
        (1, 2_000, 10**9, False, "digits"),
        (100_000, 10_000, 0, False, "count"),
        (10_000, 2_000, 0, True, "count"),
    ],
)
def test_limits_are_checked_before_the_work(count, digits, start, times, argument):
    with pytest.raises((InputError, LimitError), match=argument):
        quadratic_turning_points(ONE, count, digits, start=start, times=times)


@pytest.mark.parametrize("epsilon", ["1e-3", "1", "20"])
def test_the_estimate_counts_the_nodes_of_the_longest_half_swing(monkeypatch, epsilon):
    seen = []
    monkeypatch.setattr(
        quadratic, "map_seconds", lambda steps, digits, first, times: seen.append((steps, first)) or 1.0
    )
    for start in (20_000, 20_001):
        quadratic.estimated_seconds(parse_real(epsilon, "e"), 5, 30, start, True)
    quadratic.estimated_seconds(parse_real(epsilon, "e"), 5, 30, 0, False)
    p = 2 * float(Fraction(epsilon))
    needed = node_count(p + float(next_amplitude(arb(p))), bits_for(30))
    assert [steps for steps, _ in seen] == [20_005, 415, 5] and seen[2][1] == 0
    assert needed <= seen[0][1] == seen[1][1] <= max(needed * 1.1, node_count(1.01, bits_for(30)))


def test_small_and_large_amplitudes_and_many_points():
    assert len(quadratic_turning_points(parse_real("1e-6", "e"), 300, 25).points) == 300
    # epsilon = 1000: 2u_1 = -1 + O(e^(-2000)), so x_1 = -1/2000 exactly to 20 digits.
    table = quadratic_turning_points(parse_real("1000", "e"), 2, 20)
    assert table.points[1].x == "-0.00050000000000000000000"


def test_progress_and_presentation():
    seen = []
    table = quadratic_turning_points(ONE, 3, 5, progress=seen.append)
    assert seen == [1, 2, 3]
    assert "-0.41072" in table._repr_latex_()
    assert table.to_dict()["certified"] is True


@pytest.mark.parametrize(("epsilon", "start"), [("1e-8", 20001), ("1e-12", 10**6)])
def test_small_amplitudes_far_along(epsilon, start):
    # 1/p_n = 1/p_0 + (2/3) n + O(log n): x_n = p_n/p_0 = 1/(1 + (4/3) epsilon n) up to O(epsilon^2 n).
    x = abs(float(quadratic_turning_points(parse_real(epsilon, "e"), 1, 20, start=start).points[0].x))
    assert abs(x - 1 / (1 + 4 / 3 * float(epsilon) * start)) < 1e-11
