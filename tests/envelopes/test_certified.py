"""Balls of the averaged law: against mpmath, against each other, narrow enough, near misses outside."""

from fractions import Fraction

import mpmath
import pytest
import sympy
from flint import arb, ctx, fmpq
from mpmath import mp

import asymptotics as asy
from asymptotics.envelopes import certified
from asymptotics.envelopes.certified import F
from asymptotics.envelopes.explicit import explicit_amplitude
from asymptotics.envelopes.symbolic import tau as tau_symbol
from asymptotics.errors import InputError, LimitError
from asymptotics.expansions.moments.certified import moment
from asymptotics.numbers.exact import ExactReal, parse_real
from asymptotics.numbers.precision import TooWideError
from tests.each import each

SETS = [
    "0", "1", "3/2", "1/2", "sqrt(2)", "0 1", "0 2", "1 2", "1 3", "2 3", "0 1/2", "1/2 sqrt(2)", "sqrt(2) sqrt(3)",
    "0 1 2", "1/3 2/3 3", "1 2 3", "3/2 2 5/2",
]  # fmt: skip


KAPPAS = ("1/10", "1/4", "1/7")


def laws_of(text, kappas=KAPPAS):
    return [(parse_real(a, "alpha"), parse_real(k, "kappa").ball()) for a, k in zip(text.split(), kappas)]


def mp_laws(text):
    pairs = [(parse_real(a, "alpha"), Fraction(k)) for a, k in zip(text.split(), KAPPAS)]
    return [(mp.mpf(a.ball().mid().str(35, radius=False)), mp.mpf(k.numerator) / k.denominator) for a, k in pairs]


def close(ball, value, digits):
    return abs(mp.mpf(ball.mid().str(40, radius=False)) - value) < mp.mpf(10) ** -digits * (1 + abs(value))


@pytest.mark.parametrize("text", SETS)
def test_time_against_quadrature_and_back(text):
    with mp.workdps(30), ctx.workprec(120):
        pairs = mp_laws(text)
        for A in (Fraction(9, 10), Fraction(1, 20)):
            a = arb(fmpq(A.numerator, A.denominator))
            t = certified.time(laws_of(text), a)
            ends = [mp.mpf(A.numerator) / A.denominator, 0.3, 1]
            want = mpmath.quad(lambda x: 1 / sum(k * x**e for e, k in pairs), ends)
            assert close(t, want, 22)
            assert not close(t, want * (1 + mp.mpf(10) ** -15), 22)
            assert t.rad() < 1e-28 * abs(t)
            back = certified.amplitude(laws_of(text), t)
            assert back.contains(a)
            assert back.rad() < 1e-25
            assert not certified.amplitude(laws_of(text), t * (1 + arb("1e-12"))).contains(a)


@pytest.mark.parametrize("text", ["0", "1/2", "0 1", "0 2", "0 1/2", "1/2 sqrt(2)", "0 1 2", "1/3 2/3 3", "2/3 3 4"])
def test_extinction(text):
    with mp.workdps(30), ctx.workprec(120):
        laws, pairs = laws_of(text), mp_laws(text)
        end = certified.extinction_time(laws)
        below = 1 - pairs[0][0]
        powers = [((e - pairs[0][0]) / below, k) for e, k in pairs]
        want = mpmath.quad(lambda u: 1 / (below * sum(k * u**e for e, k in powers)), [0, 0.001, 0.1, 1])
        assert close(end, want, 10)  # the quadrature is the coarse side: an algebraic singularity at 0
        # the certified route: tau(A) + what is left lies between the bounds of the pure smallest exponent
        small, power = arb("1e-9"), 1 - laws[0][0].ball()
        rest = end - certified.time(laws, small)
        bound = small**power / (power * laws[0][1])
        assert 0.9 * bound < rest < 1.000001 * bound
        assert end.rad() < 1e-28 * end
        assert certified.amplitude(laws, end * 1.001) == 0
        around = certified.amplitude(laws, arb(end.mid(), arb("1e-3")))
        assert around.contains(0)
        assert around < 0.1


def test_too_little_precision_is_an_enclosure():
    for text in ("0 1", "1 2", "0 1 2"):
        with ctx.workprec(120):
            sharp = certified.amplitude(laws_of(text), arb(2))
        with ctx.workprec(12):
            assert certified.amplitude(laws_of(text), arb(2)).contains(sharp)
        assert certified.amplitude(laws_of(text), arb(0)) == 1


def test_no_extinction_at_or_above_one():
    for text in ("1", "3/2", "1 2", "2 3", "1 2 3"):
        assert certified.extinction_time(laws_of(text)) is None


def test_integral_and_hypergeometric_routes_overlap():
    with ctx.workprec(200):
        for text in ("0 1", "1 2", "2 3", "1/3 7/5", "sqrt(2) sqrt(3)"):
            laws = laws_of(text)
            for A in (arb(9) / 10, arb(1) / 30):
                two, quad = certified.time(laws, A), certified._integral(laws, [], -A.log())
                assert two.overlaps(quad)
                assert two.rad() < arb("1e-50")
                assert quad.rad() < arb("1e-50")
                assert not (two * (1 + arb("1e-40"))).overlaps(quad)


@each("z", ["-1/10", "-3/10", "-1", "-50", "-1000000"])
@each("a", [Fraction(1), Fraction(1, 2), Fraction(5, 3), Fraction(7, 2), Fraction(3)])
def test_log_form_against_arb(a, z):
    with ctx.workprec(300):
        w = parse_real(z, "z").ball()
        ball = arb(fmpq(a.numerator, a.denominator))
        log_form = certified._log_form(a.numerator, a.denominator, -w)
        assert log_form.overlaps(w.hypgeom_2f1(1, ball, ball + 1, abc=True))
        assert F(a, w).overlaps(log_form)
        assert F(a, w).rad() < arb("1e-70")
        assert not (log_form * (1 + arb("1e-60"))).overlaps(F(a, w))


def test_explicit_forms_agree_with_the_inversion():
    for text in ("0 1", "0 2", "1 3", "2 3", "0 1 2"):
        laws = {sympy.sympify(a): sympy.Rational(k) for a, k in zip(text.split(), KAPPAS)}
        value = explicit_amplitude(laws).expression.subs(tau_symbol, 2)
        with ctx.workprec(120), mp.workdps(30):
            assert close(certified.amplitude(laws_of(text), arb(2)), mp.mpf(str(sympy.re(value.evalf(35)))), 26)


@pytest.mark.parametrize("text", ["0", "1", "3", "3/2", "1/2", "1 2", "0 2", "2 3", "0 1 2"])
def test_phase_against_quadrature(text):
    """phi = -int sum w_ij delta_i delta_j dtau, the integrand from the theory page ``slow_flow``, by mpmath."""
    with mp.workdps(25), ctx.workprec(120):
        laws, pairs = laws_of(text), mp_laws(text)
        strengths = [k / moment(a.ball() + 1) for a, k in laws]

        def M(p):
            return mpmath.gamma((p + 1) / 2) / (mp.sqrt(mp.pi) * mpmath.gamma(p / 2 + 1))

        def slope(A):
            d = [(a, k / M(a + 1) * A ** (a - 1)) for a, k in pairs]
            w = sum(a * b * M(a + b) * x * y / ((a + 1) * (b + 1)) for a, x in d for b, y in d)
            return w / sum(k * A**a for a, k in pairs)

        A = mp.mpf(1) / 4
        want = -mpmath.quad(slope, [A, 0.5, 1])
        got = certified.phase(laws, strengths, arb(1) / 4)
        assert close(got, want, 20)
        if text != "0":
            assert not close(got, want * (1 + mp.mpf(10) ** -12), 20)


def test_limit_alpha_to_one_is_smooth():
    with ctx.workprec(300):
        at, near = (certified.amplitude(laws_of(a), arb(5)) for a in ("1", f"{10**30 + 1}/{10**30}"))
        assert not at.overlaps(near)
        assert abs(at - near) < arb("1e-30")
        assert near.rad() < arb("1e-55")  # 30 of 90 digits go into alpha - 1


def test_refusals():
    laws = laws_of("1 2")
    with pytest.raises(InputError, match="amplitude"):
        certified.time(laws, arb(0))
    with pytest.raises(InputError, match="time"):
        certified.amplitude(laws, arb(-1))
    with pytest.raises(LimitError, match="e\\^-600"):
        certified.amplitude(laws, arb(10000))
    with pytest.raises(InputError, match="strength"):
        certified.time(laws_of("1 2", ("1", "-1")), arb(1) / 2)
    with pytest.raises(InputError, match="every strength is zero"):
        certified.time(laws_of("1 2", ("0", "0")), arb(1) / 2)
    with pytest.raises(InputError, match="amplitude"):
        certified.phase(laws, [arb(1), arb(1)], arb(0))
    zero_dropped = certified.time(laws_of("1 2", ("1/10", "0")), arb(1) / 2)
    assert zero_dropped.overlaps(arb(2).log() * 10)


@pytest.mark.parametrize("text", ["0 1 2", "1 2 3"])
def test_wide_amplitudes_and_times_hold_those_at_both_ends(text):
    """The integral in the mean-value form and the inversion, of balls so wide that their ends are not near."""
    with ctx.workprec(80):
        laws, e = laws_of(text), arb(2) ** -6
        wide, back = certified.time(laws, arb("0.5", e)), certified.amplitude(laws, arb(1, e))
        for side in (e, -e):
            end = certified.time(laws, arb("0.5") + side)
            assert wide.contains(end.mid()) and abs(end - wide.mid()) > wide.rad() * arb("0.9")
            assert back.contains(certified.amplitude(laws, 1 + side).mid())


def test_an_interval_that_the_rate_leaves_is_not_claimed():
    """Near the extinction s runs away: what is claimed for a wide time holds the times before, or nothing is."""
    with ctx.workprec(80):
        laws = laws_of("0 1 2")
        end = certified.extinction_time(laws).mid()
        for share in ("0.1", "0.4", "0.45", "0.46", "0.47", "0.48"):
            found = certified._inverse(laws, arb(end / 2, end * arb(share)))
            late = -certified.amplitude(laws, end * (arb("0.499") + arb(share))).log()
            assert found is None or found.contains(late.mid())
        assert found is None
        around = certified.amplitude(laws, arb(end, "1e-3"))
        assert around.contains(certified.amplitude(laws, end - arb("0.00099")).mid())


def test_two_exponents_next_to_each_other_go_by_the_integral():
    """2F1 with an index near 10^18 took more than a minute; both forms agree where both serve."""
    near = asy.envelope(asy.Oscillator({"1/3": "1/10", "1000000000000000003/3000000000000000000": "1/10"}, x0="1/2"))
    one = asy.envelope(asy.Oscillator({"1/3": "1/5"}, x0="1/2"))
    for found, expected in (
        (near.extinction_time(digits=16), one.extinction_time(digits=16)),
        (near.time("1/8", digits=16), one.time("1/8", digits=16)),
    ):
        assert found == expected
    with ctx.workprec(80):
        laws = [(parse_real(a, "alpha"), arb(k) / 10) for a, k in (("1/3", 2), ("2/3", 1))]
        both = certified._integral(laws, [], arb(1)), certified.time(laws, arb(-1).exp())
        assert both[0].overlaps(both[1]) and both[0].rad() < 1e-20


def test_an_inversion_that_fails_says_all_that_is_known(monkeypatch):
    monkeypatch.setattr(certified, "_inverse", lambda *_: None)
    laws = [(ExactReal(1), arb(1)), (ExactReal(2), arb(1))]
    found = certified.amplitude(laws, arb(1))
    assert found.contains(arb(0)) and found.contains(arb(1))


def test_an_amplitude_that_may_be_positive_is_too_wide_and_one_that_is_not_is_refused():
    laws = [(ExactReal(2), arb(1))]
    with pytest.raises(TooWideError, match="not certainly positive"):
        certified.time(laws, arb(1, 1))
    with pytest.raises(InputError, match="is not positive"):
        certified.time(laws, arb(0))


def test_an_amplitude_next_to_the_end_is_found_where_doubles_take_it_for_the_end():
    """e^-w s/(w kappa) is left: 1/2 beside 2, five of forty digits before the end."""
    slow = asy.envelope({"1/2": "1/10", "2": "1/10"})
    end = slow.extinction_time(digits=40)
    near = end[:-5]
    left = mpmath.mpf(10) ** (3 - len(near)) * mpmath.mpf(f"0.{end[-5:]}")
    expected = (mpmath.mpf(slow.kappas(digits=20)[0]) / 2 * left) ** 2
    found = mpmath.mpf(slow.amplitude(near, digits=5))
    assert found < 1e-60 and abs(found / expected - 1) < 1e-4
