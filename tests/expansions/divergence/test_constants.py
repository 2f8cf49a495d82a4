"""The Stokes constants: two heights, the complex plane, Smith's map in mpmath, the large orders; near misses."""

from functools import cache, partial
from time import process_time

import mpmath
import pytest
from flint import acb, arb
from mpmath import mp

import asymptotics as asy
from asymptotics.errors import InputError, LimitError
from asymptotics.expansions.divergence import result
from asymptotics.expansions.divergence.abel import at, odd_series
from asymptotics.expansions.divergence.constants import _solved, effort, rough_petal, stokes_balls
from asymptotics.expansions.divergence.germ import germ
from asymptotics.numbers.context import ctx
from asymptotics.numbers.decimals import certified_decimal
from asymptotics.numbers.exact import parse_real


def alpha(text):
    return parse_real(text, "alpha")


@cache
def constants(text, count=1, digits=12):
    return stokes_balls(alpha(text), count, digits)


DRAG = parse_real("2", "alpha")


@pytest.mark.parametrize("text", ["2", "4", pytest.param("3/2", marks=pytest.mark.slow)])
def test_another_height_gives_the_same_numbers(text):
    low, high = constants(text), stokes_balls(alpha(text), 1, 12, lift=0.6)
    for a, b in zip((*low[0], *low[1]), (*high[0], *high[1]), strict=True):
        assert a.overlaps(b) and a.rad() < 1e-12 * abs(a) and b.rad() < 1e-12 * abs(b)
        assert not (a * (1 + arb("1e-11"))).overlaps(b)


@pytest.mark.slow
@pytest.mark.parametrize("text", ["1.1", "1.2", "3/2", "5/2", "6"])
def test_fifty_digits_beside_seventeen_more_from_farther_up(text):
    """Within the default time: d digits at one height, d + 17 at another."""
    start = process_time()
    found = asy.stokes(text, digits=50)
    assert process_time() - start < 60 and found.certified
    more = stokes_balls(alpha(text), 1, 67, lift=0.6)
    for (ball,), decimal in zip(more, (found.constants[0], found.time_constants[0]), strict=True):
        assert ball.rad() < arb("1e-66") * abs(ball)
        with ctx.workprec(300):
            assert abs(ball - arb(decimal)) < arb("0.51e-49") * abs(ball)
            assert not abs(ball * (1 + arb("1e-49")) - arb(decimal)) < arb("0.4e-49") * abs(ball)


@pytest.mark.parametrize(("n", "rounds", "orders"), [(2, 2, (1,)), pytest.param(3, 12, (1, 2), marks=pytest.mark.slow)])
def test_the_trapezoidal_rule_on_a_line_of_the_complex_plane(n, rounds, orders):
    """c_k = int_0^1 D e^(2 pi i k w) dw: a route through complex points, c_2 too, with the symmetric w and no other."""
    law = alpha("2")
    rough, p = rough_petal(law)
    plan = effort(rough, p, 2, 12)
    c, d = constants("2", 2)
    sums = {"c": [0, 0], "d": [0, 0], "c by Phi_-": [0, 0]}
    with ctx.workprec(plan.bits):
        g = germ(law, plan.order, plan.bits, plan.small)
        series = odd_series(g)
        for j in range(n):
            wanted = acb(arb(j) / n, -arb(plan.heights[0]))
            z = wanted
            for _ in range(rounds):  # w(z) = wanted, on midpoints
                Phi, theta, Phi_minus, theta_minus = both(g, p, series, z)
                moved = z + wanted - (Phi + Phi_minus) / 2
                z = acb(moved.real.mid(), moved.imag.mid())
            Phi, theta, Phi_minus, theta_minus = both(g, p, series, z)
            for k in orders:
                turn = 2 * acb.pi() * acb(0, 1) * k
                symmetric = (turn * (Phi + Phi_minus) / 2).exp() / n
                sums["c"][k - 1] += (Phi - Phi_minus) * symmetric
                sums["d"][k - 1] += (theta - theta_minus) * symmetric
                sums["c by Phi_-"][k - 1] += (Phi - Phi_minus) * (turn * Phi_minus).exp() / n
    for name, exact in (("c", c), ("d", d)):
        for k in orders:
            assert abs(sums[name][k - 1] - acb(exact[k - 1])) < 1e-9 * abs(exact[k - 1]), name
    assert abs(sums["c by Phi_-"][0] - acb(c[0])) < 1e-9 * abs(c[0])
    if 2 not in orders:
        return
    lopsided = c[1] - 2 * acb(0, 1) * arb.pi() * c[0] ** 2  # q from Phi_- = w - D/2 beside dw
    assert abs(sums["c by Phi_-"][1] - lopsided) < 1e-9 and not abs(sums["c by Phi_-"][1] - acb(c[1])) < 1e-3


def both(g, p, series, z):
    """Phi_+, theta_+, Phi_-, theta_- at z: f_-(delta) = -f_+(-delta)."""
    Phi, theta = at(g, p, series, z)
    back = at(g, p, series, -z)
    return Phi, theta, -back[0], -back[1]


def test_smiths_map_in_another_library():
    """alpha = 2: z -> 3/(4 F), 2 F = 1 + W_0(-(1 + 2 delta) e^-(1 + 2 delta)) (Smith 2012, (43)), in mpmath."""
    with mp.workdps(60):
        c, y, steps = mp.mpf(3) / 4, mp.mpf(5), 400
        delta = c / mp.mpc(0, -y)
        for _ in range(steps):
            x = 1 + 2 * delta
            delta = (1 + mpmath.lambertw(-x * mpmath.exp(-x))) / 2
        Phi = c / delta - steps + sum(e * delta ** (2 * k + 1) for k, e in enumerate(odd_coefficients()))
        q = mpmath.exp(2 * mp.pi * Phi.imag)
        c_1, c_2 = (mp.mpf(x.str(25, radius=False)) for x in constants("2", 2)[0])
        assert abs((2 * Phi.real / q - c_1) / q - c_2) < 1e-3  # one height alone is wrong by c_2 q
        assert not abs((2 * Phi.real / q - c_1) / q) < 1e-3


def odd_coefficients():
    """e_1, e_3, … of the odd Laurent series, from F = sum f_n delta^n by Lagrange's formula, in mpmath rationals."""
    with ctx.workprec(400):
        g = germ(alpha("2"), 40, 400, 0.1)
        return [mp.mpf(e.str(60, radius=False)) for e in odd_series(g)[0].coefficients[:12]]


def test_what_is_known_at_the_ends():
    assert asy.stokes(0, count=3).constants == ("0",) * 3
    small = asy.stokes("1/1000", digits=8)  # c_k = (-1)^(k+1) alpha/k + O(alpha^2), derivation stokes-small-alpha
    assert abs(float(small.c(1)) / 1e-3 - 1) < 5e-3 and abs(float(small.d(1))) < 1e-4
    with pytest.raises(InputError, match="alpha.*identity"):
        asy.stokes(1)
    with pytest.raises(InputError, match="out of range"):
        asy.stokes(-1)
    with pytest.raises(LimitError, match="estimated"):
        asy.stokes("1.0001")


def test_a_zero_of_c_1_between_two_signs():
    """c_1 is continuous in alpha and changes its sign between 2 and 4: it vanishes in between."""
    assert constants("2")[0][0] < 0 < constants("4")[0][0]


def test_the_contract():
    found = asy.stokes(2, count=2, digits=10)
    data = found.to_dict()
    assert data["constants"] == ["-0.09092800104", "0.01652962754"] and data["certified"] is True
    assert data["time_constants"] == ["0.4125253586", "-0.1830569277"]
    assert data["pole"] == "0.7500000000" and data["action"] == "4.712388980" and data["digits"] == 10
    low, high = found.c(1).interval().a, found.c(1).interval().b
    assert low < float(constants("2")[0][0]) < high and "c_{1}" in found._repr_latex_()


@pytest.mark.parametrize(("text", "digits", "pole", "action"), [("6", 4, "0.2188", "1.374"), ("5", 2, "0.25", "1.6")])
def test_a_rational_pole_on_a_tie_is_rounded_to_even(text, digits, pole, action):
    """c = 7/32 = 0.21875 at alpha = 6, where no ball decides the fourth digit; 2 pi |c| = 8/5 at alpha = 5."""
    law = alpha(text)
    assert [certified_decimal(partial(f, law), digits) for f in (result.pole_of, result.action_of)] == [pole, action]


def test_certified_is_what_was_found(monkeypatch):
    """Each decimal is compared with its enclosure once more: a digit too low is no longer certified."""
    assert asy.stokes(2, digits=6).certified and asy.stokes(0).certified
    honest = result.decimal_of_ball
    monkeypatch.setattr(result, "decimal_of_ball", lambda ball, digits: honest(ball * arb("1.0001"), digits))
    wrong = asy.stokes(2, digits=6)
    assert not wrong.certified and "certified: false" in str(wrong) and wrong.to_dict()["certified"] is False


@pytest.mark.parametrize("moved", ["0.12344", "0.12356"])
def test_an_enclosure_beyond_half_a_unit_does_not_round_there(moved):
    assert result.rounds_to(arb("0.1235", "0.00004"), "0.1235", 4)
    assert not result.rounds_to(arb(moved, "0.00004"), "0.1235", 4)


ZEROS = [  # the last decimals of alpha between which c_1 has a zero, and its sign at the lower one
    ("2.162839771406037186039", -1),
    ("1.554939221917691414365", 1),
    ("1.361215147925769093085", -1),
    ("0.543614812520194734658", 1),
    ("0.691093816523080272379", -1),
    ("0.765443172719509578219", 1),
]


@pytest.mark.slow
@pytest.mark.parametrize(("text", "sign"), ZEROS)
def test_the_zeros_of_c_1_nearest_to_1_by_two_signs(text, sign):
    """c_1 is continuous in alpha: opposite signs at two exponents 10^-21 apart enclose a zero to 20 digits."""
    after = f"{text[:-3]}{int(text[-3:]) + 1:03d}"
    low, high = (stokes_balls(alpha(x), 1, 27)[0][0] for x in (text, after))
    assert sign * low > 0 > sign * high


def test_neighbouring_zeros_are_about_one_apart_in_1_over_eta():
    """Towards alpha = 1: the conjecture c_1 = K cos(pi/eta + phi), seen in the zeros that are proved."""
    above, below = ([1 / (float(x) - 1) for x, _ in ZEROS[i : i + 3]] for i in (0, 3))
    gaps = [abs(b - a) for row in (above, below) for a, b in zip(row, row[1:], strict=False)]
    assert all(0.93 < gap < 1.07 for gap in gaps) and not all(0.99 < gap < 1.01 for gap in gaps)


def test_a_tail_left_out_moves_the_constants():
    """D = sum c_k q^k with the largest c_k that the petal allows: enclosed, and not without the tail."""
    _, p = rough_petal(DRAG)
    with ctx.workprec(200):
        heights = [p.Y_0 + arb(k) / 4 + 1 for k in range(3)]
        c = [2 * p.s * (2 * arb.pi() * k * p.Y_0).exp() * arb("0.99") for k in range(1, 60)]
        q = [(-2 * arb.pi() * v).exp() for v in heights]
        rows = [(x, sum(a * x**k for k, a in enumerate(c, 1)).mid(), v) for x, v in zip(q, heights, strict=True)]
        found = _solved(p, rows, p.s)
        assert all(ball.contains(value.mid()) for ball, value in zip(found, c, strict=False))
        without = _solved(p, rows, arb(0))
        assert not any(ball.contains(value.mid()) for ball, value in zip(without, c, strict=False))


def test_one_height_gives_the_constant_up_to_its_tail(law):
    _, p = law
    with ctx.workprec(100):
        v = p.Y_0 + 2
        q = (-2 * arb.pi() * v).exp()
        radius = float(_solved(p, [(q.mid(), arb(0), v)], p.s)[0].rad())
        assert radius / float(p.tail(p.s, 1, v) / q) == pytest.approx(1, rel=1e-6)
