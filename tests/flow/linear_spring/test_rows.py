"""The shared coefficients of the expansion at a turning point: against rationals, and whatever was asked for before."""

from fractions import Fraction
from itertools import product

import pytest
from flint import arb, ctx
from scipy.integrate import solve_ivp

from asymptotics.flow.damping import Damping
from asymptotics.flow.linear_spring import rows
from asymptotics.flow.linear_spring.expansion import TurningExpansion
from asymptotics.numbers.exact import ExactReal, parse_real


def in_rationals(alphas, size):
    """(y_n, q_n/(e+1)) by the product P Q = 1 written out, n in a box of that size."""
    P, Q, found = {}, {}, {}
    for n in sorted(product(range(size), repeat=1 + len(alphas)), key=lambda n: (sum(n[1:]), n)):
        e = 2 * n[0] + sum(a * k for a, k in zip(alphas, n[1:]))
        y = Fraction(1) if not any(n) else -Q[(n[0] - 1, *n[1:])] / e if n[0] else Fraction(0)
        P[n] = y - (n[0] == 0 and sum(n) == 1)
        parts = [f for f in product(*(range(k + 1) for k in n)) if any(f)]
        Q[n] = Fraction(1) if not any(n) else -sum(P[f] * Q[tuple(k - j for k, j in zip(n, f))] for f in parts)
        found[n] = y, Q[n] / (e + 1)
    return found


@pytest.mark.parametrize("alphas", [["3/2"], ["1/3"], ["1", "5/2"]])
def test_the_coefficients_are_those_of_the_recurrence_in_rationals(alphas):
    exact = in_rationals([Fraction(a) for a in alphas], 5)
    made = rows.rows_below(tuple(parse_real(a, "a") for a in alphas), (2, *(3 for _ in alphas)), 9, 60)
    assert sum(len(y.coeffs()) <= len(s.coeffs()) for _, y, s in made) == len(made) > 2
    for m, _, slow in made:
        row = rows._grown(tuple(parse_real(a, "a") for a in alphas), 64)
        for k, s in enumerate(slow.coeffs()):
            y, slowness = exact[(k, *m)]
            with ctx.workprec(300):
                assert row.y[m][k].contains(arb(y.numerator) / y.denominator)
                assert s.contains(arb(slowness.numerator) / slowness.denominator)
            assert s.rel_accuracy_bits() > 56
            assert s > 0  # nothing cancels


def test_a_coefficient_does_not_depend_on_what_was_asked_for_before():
    alphas = (ExactReal(Fraction(7, 5)),)
    asked = [((2, 3), 30), ((1, 4), 40), ((3, 2), 35)]
    found = []
    for order in (asked, asked[::-1]):
        rows._grown.cache_clear()
        rows._cut.cache_clear()
        made = {(weights, top): rows.rows_below(alphas, weights, top, 100) for weights, top in order}
        found.append({key: [(m, y.str(40), s.str(40)) for m, y, s in value] for key, value in made.items()})
    assert found[0] == found[1]


@pytest.mark.parametrize("reached", [1, 2, 3])
def test_an_alarm_between_two_columns_leaves_nothing_behind(reached):
    """The first columns are one coefficient further than the last, as an exception in between leaves them."""
    alphas = (ExactReal(Fraction(7, 5)),)
    whole, stopped = rows._Rows(alphas, 64), rows._Rows(alphas, 64)
    for m in ((0,), (1,), (2,)):
        whole.extend(m, 6)
        stopped.extend(m, 3)
        for table in (stopped.y, stopped.p, stopped.q)[:reached]:
            table[m].append(arb(7))
        stopped.extend(m, 4 if reached == 3 else 6)
        stopped.extend(m, 6)
    for name in "ypqs":
        texts = [[[c.str(15) for c in getattr(each, name)[m]] for m in ((0,), (1,), (2,))] for each in (whole, stopped)]
        assert texts[0] == texts[1]


def test_both_ends_and_all_strengths_share_them():
    """At y_0 = -2 the motion comes in: the same series, z_i < 0, against SciPy's integrator."""
    law = Damping.of([(arb("0.25"), parse_real("5/4", "a"))])

    def slopes(w, s):
        return [-w / (s[0] - w**1.25 / 4), 1 / (s[0] - w**1.25 / 4)]

    for place in (2, -2):
        with ctx.workprec(80):
            y, tau = TurningExpansion.at(law, arb(place), arb("0.125")).state(arb("0.125"))
        expected = solve_ivp(slopes, (0, 0.125), [place, 0], rtol=1e-12, atol=1e-14).y[:, -1]
        assert abs(float(y.mid()) - expected[0]) < 1e-9
        assert abs(float(tau.mid()) - expected[1]) < 1e-9
        assert (tau > 0) == (place > 0)
