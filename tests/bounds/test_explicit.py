"""The bound of the explicit form: it holds, half of it does not, and each of its parts is what its definition says."""

from fractions import Fraction
from random import Random

import mpmath
import numpy as np
import pytest
import sympy
from flint import acb, arb, ctx

import asymptotics as asy
from asymptotics.bounds import explicit
from asymptotics.bounds.explicit import _ExplicitTheorem, explicit_bound
from asymptotics.bounds.uniform import largest_strength, uniform_bound
from asymptotics.bounds.waveform import waveform_bounds
from asymptotics.curves.solution import epsilon, tau
from asymptotics.errors import InputError, LimitError
from asymptotics.law import Oscillator
from asymptotics.motions.reference import reference_states
from asymptotics.numbers.exact import ExactReal, parse_real


def seen(law, order, until, points=24):
    """The largest |x - x_N| at times up to ``until``: certified x, and the functions that are handed out."""
    times = np.linspace(until / points, until, points)
    truth = reference_states(Oscillator(law), [ExactReal(Fraction(float(t))) for t in times], 20).x
    found = asy.solution(law, order=order).sample(times)[2]
    return max(abs(float(a) - b) for a, b in zip(truth, found))


ATTAINED = [
    ({"2": "1/10"}, 3, None),
    ({"2": "1/10"}, 1, None),
    pytest.param({"3": "1/50"}, 3, None, marks=pytest.mark.slow),
    pytest.param({"3/2": "1/20"}, 3, None, marks=pytest.mark.slow),
    pytest.param({"1/2": "1/50"}, 3, 40, marks=pytest.mark.slow),
    pytest.param({"1/2": "1/50"}, 1, 40, marks=pytest.mark.slow),
    ({"0": "1/50"}, 1, None),
]


@pytest.mark.parametrize(("law", "order", "until"), ATTAINED)
def test_the_bound_holds_and_half_of_it_does_not(law, order, until):
    found = explicit_bound(Oscillator(law), order, until=until)
    end = 30.0 if found.until == "oo" else min(70.0, float(Fraction(found.until)))
    assert float(found.size) / 2 < seen(law, order, end) <= float(found.size)


def laws():
    draw = Random(20261124)
    exponents = [Fraction(draw.randint(6, 35), 10) for _ in range(2)]
    return [({a: Fraction(1, draw.randint(15, 60))}, draw.randint(1, 4)) for a in exponents]


@pytest.mark.parametrize(("law", "order"), laws())
def test_laws_that_nobody_chose(law, order):
    (alpha,) = law
    found = explicit_bound(Oscillator(law), order, until=None if alpha > 1 else 12)
    assert seen(law, order, 12.0, 12) <= float(found.size)


def theorem(alpha, order, strength="1/10"):
    waves = waveform_bounds((parse_real(alpha, "alpha"),), order + 1)
    with ctx.workprec(80):
        return _ExplicitTheorem.of(waves, order, parse_real(strength, "epsilon").ball())


@pytest.mark.parametrize(
    ("alpha", "order"),
    [
        ("2", 3),
        ("3/2", 2),
        ("1/2", 4),
        pytest.param("sqrt(7)", 5, marks=pytest.mark.slow),
        pytest.param("2", 7, marks=pytest.mark.slow),
    ],
)
def test_the_defects_begin_with_the_order(alpha, order):
    """Exact cancellation in balls below epsilon^N, and something there: this is what ``_defects`` leaves out."""
    whole = theorem(alpha, order)
    with ctx.workprec(80):
        for D in (arb(1) / 3, arb(9) / 10):
            rows = whole._series(D)
            assert all(row[n].contains(0) and row[n].rad() < 1e-12 for row in rows for n in range(order))
            assert any(abs(row[order]) > 1e-7 for row in rows)


@pytest.mark.parametrize(("alpha", "order"), [("2", 3), ("1/2", 2), ("5/2", 2)])
def test_the_defects_are_those_of_the_functions_handed_out(alpha, order):
    """A'/A + p(delta) and phi' - Omega(delta) by differences of ``solution``: within the bounds, not within half."""
    whole, found = theorem(alpha, order), asy.solution(alpha, order=order)
    time, eps, a = 5, mpmath.mpf("0.1"), mpmath.mpf(Fraction(alpha).numerator) / Fraction(alpha).denominator
    with mpmath.workdps(40), ctx.workprec(80):
        values = {epsilon: sympy.Rational(1, 10)}
        A, phi = (sympy.lambdify([tau], e.subs(values), "mpmath") for e in (found.amplitude, found.phase))
        delta = eps * A(time) ** (a - 1)
        p, Omega = (
            sum(mpmath.mpf(c.mid().str(30, radius=False)) * delta**k for k, c in row.items())
            for row in (whole.p, whole.Omega)
        )
        D = mpmath.mpf(found.leading[1].subs({**values, tau: time}).evalf(40))
        true = [(mpmath.diff(A, time) / A(time) + p) / (eps * D), (mpmath.diff(phi, time) - Omega) / (eps * D)]
        ball = arb(mpmath.nstr(D, 30))
        rest = whole._rest(ball)
        bounds = whole._defects(explicit._Piece(arb(0), arb(1), ball, arb(1), arb(0)), rest)
        for value, bound in zip(true, bounds):
            assert abs(value) <= float(bound.upper()) * (1 + 1e-9) + 1e-20
            assert abs(value) > float(bound.upper()) / 2 - 1e-12


def test_cauchy_takes_over_where_the_computed_degrees_end(monkeypatch):
    """M by its definition; and the next coefficients are below M rho^-n."""
    whole = theorem("2", 3, "1/5")
    with ctx.workprec(80):
        D = arb(1)
        rho = next(r for r in whole._radii(D) if whole._swing(r, D) <= arb(1) / 2)
        q, x = whole._swing(rho, D), arb(1) / 5 / rho
        swing = rho**2 * (arb(1) / 90 + arb(1) / 90)
        assert abs(q - swing) < 1e-15
        slope = rho**2 * (arb(2) / 90 + arb(1) / 90)
        turn = rho * arb.pi() / 8
        p_1, p_3 = 4 / (3 * arb.pi()), arb(2) / (135 * arb.pi())
        M_A = p_1 * (1 + slope / (1 - q)) + p_1 * (1 + q) + p_3 * rho**2 * (1 + q) ** 3
        M_phi = p_1 * turn + rho / 6 * (1 + q) ** 2 + arb(7) / 432 * rho**3 * (1 + q) ** 4
        rest = whole._rest(D)
        for found, M in zip(rest, (M_A, M_phi)):
            assert abs(found - M * x**11 / (1 - x)) < 1e-12 * found
        monkeypatch.setattr(explicit, "NEXT", 20)
        for found, row in zip(rest, whole._series(D)):
            assert sum((abs(row[n]) / arb(5) ** n for n in range(11, 23)), arb(0)) < found


def test_the_integrand_is_what_is_left_over():
    """Each part by its definition, on a thin piece."""
    whole = theorem("1/2", 3)
    with ctx.workprec(80):
        D, d, r, w = arb(11) / 10, arb(1) / 9, arb(101) / 100, arb(-1) / 2
        one = explicit._Piece(arb(1) / 128, arb(1) / 2, D, r, d)
        rest = whole._rest(D)
        f_A, f_phi = whole._defects(one, rest)
        for f, row, beyond in zip((f_A, f_phi), whole._series(D), rest):
            late = sum((row[n] / arb(10) ** n for n in range(3, 11)), arb(0))
            assert abs(f - abs(late) - beyond) < 1e-20 < beyond < f
        waves = whole.waves
        Omega = abs(arb(waves.Omega[2])) * d**2 + abs(arb(waves.Omega[4])) * d**4
        R = (1 + Omega) * r**w * sum((c * d ** (4 + k) for k, c in enumerate(waves.residual.coefficients)), arb(0))
        turned = sum((waves.turns[k] * d**k for k in range(1, 6)), arb(0))
        grown = sum((abs(1 + k * w) * waves.sizes[k] * d**k for k in range(1, 6)), arb(0))
        rows = [(c, 5 + k) for k, c in enumerate(waves.residual.coefficients)]
        found = whole._left_over(one, rows, rest)
        assert abs(found - r * (R + abs(acb(f_A, f_phi)) + f_A * grown + f_phi * turned)) < 1e-15
        omitted = sum((waves.displacements[k] * d**k for k in (3, 4, 5)), arb(0)) * r / 2
        assert abs(whole._omitted(one) - omitted) < 1e-15


def test_the_bound_is_the_sum_of_its_parts():
    whole = theorem("2", 2, "1/20")
    with ctx.workprec(80):
        pieces, rest, r = whole._pieces(arb(0)), whole._rest(arb(1)), whole.waves.residual
        rows = [(c, r.power + k) for k, c in enumerate(r.coefficients)]
        left_over = sum((one.width * whole._left_over(one, rows, rest) for one in pieces), arb(0)) * 3 * arb.pi() / 4
        found, _ = whole.bound(None)
        first = whole._omitted(pieces[-1])
        assert abs((found - left_over - first).mid()) < found / 1000
        assert left_over > found / 10
        assert first > found / 10


@pytest.mark.parametrize(("alpha", "until"), [("2", None), ("2", 20), ("1/2", 20)])
def test_on_each_piece_is_what_is_anywhere_on_it(alpha, until):
    whole = theorem(alpha, 2, "1/20")
    with ctx.workprec(80):
        last = whole._last(None if until is None else arb(until))
        assert last.is_zero() if until is None else whole._time(last) > until * (1 - arb(10) ** -18)
        assert until is None or whole._time(last) < until * (1 + 1e-12)
        pieces, total, u = whole._pieces(last), arb(0), last
        for piece in pieces:
            for v in (u, piece.end, (u + piece.end) / 2):
                assert piece.D.contains((v**whole.w).mid()) or v.is_zero()
            assert (piece.delta - arb(1) / 20 * piece.D * piece.r**whole.w).contains(0)
            total, u = total + piece.width, piece.end
        assert (total - (1 - last)).contains(0) and (u - 1).contains(0)


def test_a_bound_of_early_times_is_smaller_and_ends_before_the_amplitude_does():
    drag = Oscillator({"2": "1/10"})
    whole, early = explicit_bound(drag, 3), explicit_bound(drag, 3, until=5)
    assert float(early.size) < float(whole.size) and (whole.until, early.until) == ("oo", "5")
    creeping = Oscillator({"1/2": "1/50"})
    end = Fraction(explicit_bound(creeping, 2).until)
    assert float(explicit_bound(creeping, 2, until=end).size) <= float(explicit_bound(creeping, 2).size)
    for late in (end * Fraction(6, 5), 10**6):
        with pytest.raises(LimitError):
            explicit_bound(creeping, 2, until=late)


def test_units_and_what_needs_no_theorem():
    plain = explicit_bound(Oscillator({"2": "1/50"}), 2)
    scaled = explicit_bound(Oscillator({"2": "3/20"}, mass="3/2", stiffness=30, x0="1/5"), 2)
    assert float(scaled.size) == pytest.approx(float(plain.size) / 5, rel=0.04)
    assert explicit_bound(Oscillator({"2": 0}), 2) == ("oo", "0", "proved")
    linear = Oscillator({"1": "1/10"})
    assert explicit_bound(linear, 3).size == uniform_bound(linear, 3).bound


@pytest.mark.parametrize(
    ("oscillator", "keywords", "argument"),
    [
        (Oscillator({"2": "1/10"}), {"order": 0}, "order"),
        (Oscillator({"2": "1/10"}), {"order": 13}, "order"),
        (Oscillator({"2": "1/10"}), {"until": 0}, "until"),
        (Oscillator({"1": "1/10", "2": "1/10"}), {}, "law"),
        (Oscillator({"2": "1/10"}, spring={3: "1/2"}), {}, "law"),
        (Oscillator({"2": "1/10"}, v0=1), {}, "v0"),
        (Oscillator({"2": "-1/10"}), {}, "damping"),
    ],
)
def test_bad_input_names_the_argument(oscillator, keywords, argument):
    with pytest.raises(InputError, match=argument):
        explicit_bound(oscillator, **keywords)


@pytest.mark.parametrize("law", [{"2": "1"}, {1 + Fraction(1, 10**40): "1/50"}, {"1/2": "2"}, {"40": "1/5"}])
def test_what_is_out_of_reach_is_refused(law):
    with pytest.raises(LimitError):
        explicit_bound(Oscillator(law), 3)


def test_the_range_is_that_of_the_waveform():
    limit = largest_strength(waveform_bounds((parse_real("2", "alpha"),), 4), fades=True)
    assert explicit_bound(Oscillator({"2": limit - Fraction(1, 50)}), 3).label == "proved"
    with pytest.raises(LimitError, match="beyond the range"):
        explicit_bound(Oscillator({"2": limit + Fraction(1, 50)}), 3)
