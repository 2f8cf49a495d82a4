import pytest
from flint import arb, ctx, fmpq, fmpq_series

from asymptotics.series import Series, compose_all, is_exact_zero


def rationals(values):
    return Series.from_list([fmpq(v) if isinstance(v, int) else fmpq(*v) for v in values])


A = rationals([0, 2, (-1, 3), 5, (7, 2), -1])
B = rationals([1, (1, 2), 3, -4, (2, 5), 6])


def test_products_inverse_exp_and_log_agree_with_flint():
    ctx.cap = 6
    try:
        a, b = (fmpq_series([s[n] for n in range(6)], prec=6) for s in (A, B))
        for ours, flint in ((A * B, a * b), (B.inverse(), 1 / b), (A.exp(), a.exp()), (B.log(), b.log())):
            assert [ours[n] for n in range(6)] == [flint[n] for n in range(6)]
    finally:
        ctx.cap = 10


def test_cosine_and_sine_satisfy_their_identity():
    c, s = A.cos_sin()
    assert (c * c + s * s - 1).coefficients == {}


def test_composition_is_associative_in_two_variables():
    x, y = (Series.variable(i, 2, 4, fmpq(1)) for i in (0, 1))
    f, g, h = x + 2 * x * y - y * y * y, x * x + y, y + x * y
    first = f.compose((g, h)).compose((h, x))
    second = f.compose(tuple(compose_all((g, h), (h, x))))
    assert (first - second).coefficients == {}
    assert (first - f.compose((h, g)).compose((h, x))).coefficients != {}


def test_a_ball_around_zero_is_kept_and_a_ball_around_one_is_inverted():
    fuzzy = Series({(0,): arb(1, 0.1), (1,): arb(0, 1)}, 1, 1)
    assert (fuzzy + fuzzy).coefficients.keys() == {(0,), (1,)}
    assert not is_exact_zero(fuzzy[1])
    assert fuzzy.inverse()[0].contains(1 / arb(0.9))


@pytest.mark.parametrize("call", [lambda: B.exp(), lambda: A.log(), lambda: A.truncate(2)[3], lambda: B.cos_sin()])
def test_misuse_is_refused(call):
    with pytest.raises((ValueError, IndexError)):
        call()
