"""Linear programs and what balls prove of them, the middle of a table, the boxes of strengths >= 0, sums and slopes."""

from fractions import Fraction
from types import SimpleNamespace

import numpy as np
import pytest
from flint import arb, fmpq
from scipy.optimize import linprog

from asymptotics.decays.identification.certified_sets import central_point, physical, table_rows
from asymptotics.decays.identification.certified_sets.central_point import chebyshev_point
from asymptotics.decays.identification.certified_sets.certified_ratio import CertifiedRatio
from asymptotics.decays.identification.certified_sets.physical import _largest, _shrunk, physical_box
from asymptotics.decays.identification.certified_sets.table_rows import (
    RatioInequality,
    _lower_bound,
    bounds,
    elastic,
    exact,
    is_empty,
)
from asymptotics.decays.identification.fitting.printed import Decrements
from asymptotics.decays.identification.forward.candidates import read_candidate as read
from asymptotics.decays.identification.forward.quadrature import TooStrongError
from asymptotics.errors import UndecidedError
from asymptotics.numbers.context import ctx
from asymptotics.terms import Term

M = np.array([[1.0, 2.0], [-1.0, 0.5], [0.0, -1.0]])
B = np.array([0.5, -0.75, -0.6])
RADIUS = np.array([2.0, 1.5])


def test_a_printed_decimal_is_the_number_that_is_printed():
    for x in (0.1, -2.5, 1e-3, 3.0):
        q = Fraction(repr(x))
        assert exact(x).overlaps(arb(fmpq(q.numerator, q.denominator))) and exact(x).contains(
            arb(fmpq(q.numerator, q.denominator))
        )
    with ctx.workprec(80):
        assert not exact(0.1).contains(arb(0.1))  # the double is another number


def optimum(c, sense):
    found = linprog(sense * np.array(c), A_ub=-M, b_ub=-B, bounds=list(zip(-RADIUS, RADIUS)), method="highs")
    return sense * found.fun


def test_bounds_are_those_of_the_program_and_not_inside():
    low, high = bounds(M, B, RADIUS)
    for i, c in enumerate(np.eye(2)):
        least, most = optimum(c, 1.0), optimum(c, -1.0)
        assert low[i] <= least < low[i] + 1e-12 and high[i] >= most > high[i] - 1e-12
    assert (low > -RADIUS).any() and (high < RADIUS).any()
    free = bounds(np.array([[1.0, 0.0]]), np.array([-9.0]), RADIUS)  # a row that asks for nothing
    assert free[0].tolist() == (-RADIUS).tolist() and free[1].tolist() == RADIUS.tolist()


def test_a_program_without_a_solution_leaves_the_box_or_ends_that_do_not_cross():
    low, high = bounds(np.array([[1.0, 0.0]]), np.array([5.0]), RADIUS)
    assert (low >= -RADIUS).all() and (high >= low).all()


@pytest.mark.parametrize("multipliers", [[0.0, 0.0, 0.0], [0.3, 0.0, 0.0], [0.4, 0.6, 0.3], [5.0, 0.0, 7.0]])
def test_any_multipliers_give_a_proved_bound(multipliers):
    """lambda.b + min over the box of (c - M^T lambda).y, by its corners."""
    c = np.array([1.0, -0.5])
    found = _lower_bound(c, M, B, RADIUS, np.array(multipliers))
    rest = c - M.T @ multipliers
    corners = [rest @ (RADIUS * [s, t]) for s in (-1, 1) for t in (-1, 1)]
    assert found == pytest.approx(np.dot(multipliers, B) + min(corners), rel=1e-14) and found <= optimum(c, 1.0)
    whole = [Fraction(x) for x in np.array(multipliers)]
    own = [
        Fraction(x) - sum((w * Fraction(M[k, j]) for k, w in enumerate(whole)), Fraction(0)) for j, x in enumerate(c)
    ]
    truth = sum((w * Fraction(b) for w, b in zip(whole, B)), Fraction(0)) - sum(
        abs(r) * Fraction(s) for r, s in zip(own, RADIUS)
    )
    assert Fraction(found) < truth < Fraction(found) + Fraction(1, 10**14)


def test_the_elastic_program_misses_each_row_by_the_same_share():
    """The least t with M y + t size >= b, size_k = sum |M_k| half."""
    y, multipliers = elastic(M, B + 3.0, -RADIUS, RADIUS)
    size = np.abs(M) @ RADIUS
    t = ((B + 3.0 - M @ y) / size).max()
    padded = np.column_stack([M, size])
    found = linprog(
        [0, 0, 1], A_ub=-padded, b_ub=-(B + 3.0), bounds=[*zip(-RADIUS, RADIUS), (None, None)], method="highs"
    )
    assert t == pytest.approx(found.fun, abs=1e-9) and t > 0
    assert multipliers == pytest.approx(
        np.maximum(-found.ineqlin.marginals, 0), abs=1e-7
    ) and multipliers @ size == pytest.approx(1.0)
    shifted, _ = elastic(M, B, np.array([0.0, 0.0]), np.array([1.0, 1.0]))
    assert (shifted >= -1e-9).all() and (shifted <= 1 + 1e-9).all()


@pytest.mark.parametrize(("row", "empty"), [(3.49, False), (3.51, True)])
def test_a_box_is_empty_where_a_row_asks_for_more_than_its_corner(row, empty):
    """y_1 + y_2 <= 3.5 in the box."""
    assert is_empty(np.array([[1.0, 1.0]]), np.array([row]), RADIUS) == empty


def test_two_rows_that_exclude_each_other_leave_nothing(monkeypatch):
    rows = np.array([[1.0, 1.0], [-1.0, -1.0]])
    assert is_empty(rows, np.array([0.6, -0.5]), RADIUS) and not is_empty(rows, np.array([0.4, -0.5]), RADIUS)
    monkeypatch.setattr(table_rows, "linprog", lambda *_, **__: SimpleNamespace(x=None))
    assert not is_empty(rows, np.array([0.6, -0.5]), RADIUS)  # a program that fails proves nothing
    y, multipliers = elastic(rows, np.array([0.6, -0.5]), -RADIUS, RADIUS)
    assert y.tolist() == [0.0, 0.0] == multipliers.tolist()


# The sum and its slopes.


def test_the_sum_its_slopes_and_its_areas_are_those_of_a_polynomial():
    coefficients = {(1, 0): arb(-2), (0, 1): arb(-3), (2, 0): arb(5), (1, 1): arb(7), (0, 2): arb(11), (2, 1): arb(13)}
    ratio = CertifiedRatio((arb(0), arb(1)), (arb(1), arb(1)), coefficients, 3)
    x, y = 0.25, 0.5
    value = -2 * x - 3 * y + 5 * x * x + 7 * x * y + 11 * y * y + 13 * x * x * y
    assert float(ratio.polynomial([arb(x), arb(y)])) == value and [float(a) for a in ratio.areas] == [2.0, 3.0]
    by_x, by_y = -2 + 10 * x + 7 * y + 26 * x * y, -3 + 7 * x + 22 * y + 13 * x * x
    assert [float(g) for g in ratio.gradient([arb(x), arb(y)])] == [by_x, by_y]


# The middle of a table.


def table(*strengths, digits=3):
    """Decrements of viscous and quadratic loss, to first order."""
    a = np.array([1.0, 0.8, 0.6, 0.4])
    d = np.pi / 2 * strengths[0] * a + 4 / 3 * strengths[1] * a**2
    return Decrements(a, np.round(d, digits), np.full(4, 0.5 * 10.0**-digits))


def test_the_middle_misses_the_rows_by_the_least_share_of_their_resolution():
    """By a search of all strengths: no other comes nearer."""
    given = table(0.03, 0.02)
    t, theta = chebyshev_point(read("1+2"), given)
    model = central_point.DecrementModel(read("1+2").swing(), given)
    missed = lambda at: np.abs((given.decrement - model.predict(at)[0]) / given.resolution).max()  # noqa: E731
    assert t == pytest.approx(missed(theta)) and t < 1
    steps = [np.array([p, q]) * 1e-4 for p in (-3, -1, 1, 3) for q in (-3, -1, 0, 1, 3)]
    assert all(missed(theta + step) > t for step in steps) and missed(theta + [1e-5, -1.2e-5]) > t * 0.999


def test_strengths_are_physical_unless_they_may_be_negative():
    given = table(0.06, -0.02)
    t, theta = chebyshev_point(read("1+2"), given)
    assert theta[1] == pytest.approx(0.0, abs=1e-12) and (theta >= 0).all() and t > 1
    t, theta = chebyshev_point(read("1+2"), given, physical=False)
    assert theta[1] < -0.01 and t < 1


def test_a_resolution_of_zero_asks_for_all_but_equality():
    given = table(0.03, 0.0, digits=12)
    t, _ = chebyshev_point(read("1"), Decrements(given.amplitude, given.decrement, np.zeros(4)))
    assert np.isfinite(t)


def test_where_the_motion_ends_weaker_losses_are_tried(monkeypatch):
    asked = []

    class Model:
        size = 2

        def __init__(self, swing, table):
            pass

        def predict(self, theta):
            asked.append(theta.tolist())
            if theta[0] > 1.5:
                raise TooStrongError("it ends")
            return np.array([theta[0]]), np.array([[1.0, 0.0]])

    given = SimpleNamespace(amplitude=np.ones(1), decrement=np.array([1.0]), resolution=np.array([0.5]))
    monkeypatch.setattr(central_point, "DecrementModel", Model)
    monkeypatch.setattr(central_point, "decrement_start", lambda model: np.array([3.0, 7.0]))
    t, theta = chebyshev_point(read("free"), given)
    assert asked[:3] == [[3.0, 5.0], [pytest.approx(2.1), 5.0], [pytest.approx(1.47), 5.0]] and t == pytest.approx(
        0, abs=1e-9
    )
    asked.clear()
    chebyshev_point(read("0+1"), given)
    assert asked[1] == [pytest.approx(2.1), pytest.approx(4.9)]


def test_a_step_is_that_of_the_least_largest_miss():
    slopes, missed = np.array([[1.0, 0.0], [0.0, 1e4], [1.0, 1e4]]), np.array([0.5, 0.2, 1.0])
    free = np.full(2, np.inf)
    y = central_point._step(slopes, missed, -free, free)
    assert np.abs(missed - slopes @ y).max() == pytest.approx(0.1)  # 0.6, 0.3 and 0.9: each misses by a tenth
    held = central_point._step(slopes, missed, -free, np.array([0.3, np.inf]))
    assert held[0] == pytest.approx(0.3)
    assert central_point._step(slopes, missed, np.array([1.0, 1.0]), np.array([0.0, 0.0])).tolist() == [0.0, 0.0]


# Boxes of strengths >= 0.


def upper(level, scale=1.0):
    return RatioInequality(-1, (arb(scale),), arb(level))


def test_a_strength_that_exceeds_a_row_is_proved_in_steps_of_three_percent():
    """-L = pi (e/2)/sqrt(1 - e^2/4): a little more than pi e/2."""
    term = Term(1, 1)
    u = _largest(term, [upper(0.3), upper(0.1), RatioInequality(1, (arb(1),), arb("0.01"))], 0)
    assert u == pytest.approx(1.03 * 0.1 / (np.pi / 2), rel=1e-9)  # of the lowest upper row, by the first step
    lag = np.pi * u / 2 / np.sqrt(1 - u * u / 4)
    assert lag > 0.1
    assert _largest(term, [upper(0.1, 2.0)], 0) == pytest.approx(u / 2, rel=1e-9)
    assert _largest(term, [], 0) is None


def box(monkeypatch, beyond, shrunk, *, met=False, largest=(1.0, 2.0), rows=()):
    asked = []
    monkeypatch.setattr(physical, "_largest", lambda term, rows, i: largest[i])
    monkeypatch.setattr(physical, "_is_beyond", lambda ratio, rows, corner, sign: beyond(corner, sign))
    monkeypatch.setattr(
        physical,
        "_shrunk",
        lambda ratio, rows, low, high: (asked.append((low.tolist(), high.tolist())), shrunk(low, high))[1],
    )
    return physical_box(("a", "b"), None, rows, met=met), asked


def test_boxes_are_halved_until_each_is_decided(monkeypatch):
    found, asked = box(monkeypatch, lambda corner, sign: False, lambda low, high: None)
    assert found == "none" and asked == [([0.0, 0.0], [1.0, 2.0])]
    found, asked = box(monkeypatch, lambda corner, sign: True, None)
    assert found == "none" and asked == []
    whole = lambda low, high: (low, high)  # noqa: E731
    found, asked = box(monkeypatch, lambda corner, sign: False, whole)
    assert len(asked) == 60 and found[0].tolist() == [0.0, 0.0] and found[1].tolist() == [1.0, 2.0]
    _, asked = box(monkeypatch, lambda corner, sign: False, whole, met=True)
    assert len(asked) == 7
    assert asked[1:3] == [([0.0, 0.0], [0.5, 2.0]), ([0.5, 0.0], [1.0, 2.0])]  # the oldest first


def test_what_is_lost_too_much_below_or_too_little_above_is_left_out(monkeypatch):
    """-L grows with the strengths: only 0.3 <= the first strength <= 0.6 is left."""
    beyond = lambda corner, sign: corner[0] >= 0.6 if sign < 0 else corner[0] <= 0.3  # noqa: E731
    (low, high), _ = box(monkeypatch, beyond, lambda low, high: (low, high))
    assert 0.2 < low[0] <= 0.3 and 0.6 <= high[0] < 0.7 and (low[1], high[1]) == (0.0, 2.0)


def test_without_a_largest_strength_nothing_is_said_and_a_row_that_grows_refutes(monkeypatch):
    assert box(monkeypatch, None, None, largest=(1.0, None))[0] is None
    grows = [RatioInequality(-1, (arb(1),), arb("-0.1"))]
    assert box(monkeypatch, None, None, rows=grows)[0] == "none"
    lower = [RatioInequality(1, (arb(1),), arb("-0.1"))]  # a lower row with a negative level asks for nothing
    assert box(monkeypatch, lambda *_: False, lambda *_: None, rows=lower)[1] != []


def test_a_box_shrinks_to_what_its_rows_leave(monkeypatch):
    low, high = np.array([0.0, 1.0]), np.array([2.0, 5.0])
    monkeypatch.setattr(physical, "linear", lambda ratio, rows, centre, radius: (centre, radius))
    monkeypatch.setattr(physical, "is_empty", lambda M, b, radius: False)
    monkeypatch.setattr(physical, "bounds", lambda M, b, radius: (np.array([-0.5, -9.0]), np.array([9.0, 1.0])))
    found = _shrunk(None, [], low, high)
    assert found[0] == pytest.approx([0.5, 1.0]) and found[1] == pytest.approx([2.0, 4.0])
    assert found[0][0] < 0.5 and found[1][1] > 4.0  # outwards
    monkeypatch.setattr(physical, "is_empty", lambda M, b, radius: True)
    assert _shrunk(None, [], low, high) is None

    def unreached(*_):
        raise UndecidedError("not reached")

    monkeypatch.setattr(physical, "linear", unreached)
    assert _shrunk(None, [], low, high) == (low, high)
