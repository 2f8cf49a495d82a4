"""One law through a high order by nodes, beside the series in the angle; and what is left to those."""

import pytest
from flint import arb

from asymptotics.errors import LimitError
from asymptotics.expansions.half_swings import certified
from asymptotics.expansions.half_swings.certified import quarter_swing
from asymptotics.expansions.half_swings.certified_nodes import only_law, quarter_orders
from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.expansions.half_swings.node_transform import NodeTransform
from asymptotics.numbers.context import ctx
from asymptotics.numbers.exact import parse_real
from asymptotics.terms import Term


@pytest.mark.parametrize("text", ["1/10", "1/2", "99/100", "3/2", "sqrt(5)", "3", "17/2"])
def test_nodes_and_series_in_the_angle_agree_and_nodes_are_as_sharp(text):
    """A guard given: the other route.  Each coefficient to the precision that was asked for, relative to itself."""
    law = parse_real(text, "alpha")
    with ctx.workprec(120):
        ours = quarter_swing([law], 18)
        theirs = quarter_swing([law], 18, guard=120 + 20 * int(float(law.ball())))
        R, T = quarter_orders(law, 18)
        for n in range(1, 19):
            for mine, other, direct in ((ours.R[n], theirs.R[n], R[n,]), (ours.T_q[n], theirs.T_q[n], T[n,])):
                assert mine.overlaps(other) and (mine.mid(), mine.rad()) == (direct.mid(), direct.rad())
                assert mine.rel_accuracy_bits() > 110
                assert not (mine * (1 + arb(2) ** -80)).overlaps(other)


def test_what_the_nodes_do_not_serve_is_left_to_the_series():
    """Low orders, exponents 0 and 1, sums, springs, and whatever asks for the series themselves."""
    one = lambda text: Forces.read([parse_real(text, "alpha")], 12)  # noqa: E731
    assert only_law(one("3/2"), 18) == parse_real("3/2", "alpha")
    assert only_law(one("3/2"), 17) is only_law(one("0"), 18) is only_law(one("1"), 18) is None
    assert only_law(Forces.read([parse_real(a, "alpha") for a in ("1", "2")], 18), 18) is None
    assert only_law(Forces.read([Term(1, 0, 3, "position")], 18), 18) is None


def test_moments_come_with_the_series(monkeypatch):
    monkeypatch.setattr(certified, "quarter_orders", None)
    assert len(quarter_swing([parse_real("3/2", "alpha")], 18, moments=True).K) == 19


def test_work_that_is_too_large_is_refused_before_it_starts(monkeypatch):
    monkeypatch.setattr(certified, "quarter_orders", None)
    with pytest.raises(LimitError, match="order"):
        quarter_swing([parse_real("3/2", "alpha")], 200, max_seconds=0.5)


@pytest.mark.parametrize("count", [1, 2, 5, 8])
def test_the_two_halves_are_the_whole(count):
    """Sums and values by the definition of T_k."""
    transform = NodeTransform(count)
    rows = [[arb(i * i + 1), arb(3 - i)] for i in range(count)]
    T = [[arb.chebyshev_t(x, k) for k in range(count)] for x in transform.places]
    for k, found in enumerate(transform.sums(rows)):
        for j, total in enumerate(found):
            assert total.overlaps(sum((T[i][k] * rows[i][j] for i in range(count)), arb(0))) and total.rad() < 1e-10
    h = [arb(k + 2) for k in range(count)]
    for i, value in enumerate(transform.values(h)):
        assert value.overlaps(sum((T[i][k] * h[k] for k in range(count)), arb(0))) and value.rad() < 1e-10
