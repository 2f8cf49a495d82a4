"""The bound for all times: it holds, half of it does not, and each of its constants is nearly attained."""

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from flint import arb, ctx

from asymptotics.bounds.flow import TruncatedFlow
from asymptotics.bounds.turning import rates
from asymptotics.bounds.uniform import _UniformTheorem, displacement_bound, largest_strength, uniform_bound
from asymptotics.bounds.waveform import waveform_bounds
from asymptotics.errors import InputError, LimitError
from asymptotics.law import Oscillator
from asymptotics.motions.asymptotic import AsymptoticMotion
from asymptotics.motions.reference import reference_states
from asymptotics.motions.truncation import Truncation
from asymptotics.numbers.exact import ExactReal, parse_real
from asymptotics.series import Series


def true_errors(oscillator, order, until, points=80):
    """The largest |x - x_N| and |v - v_N| seen at times up to ``until``; certified x, and x_N in doubles."""
    times = np.linspace(until / points, until, points)
    truth = reference_states(oscillator, [ExactReal(Fraction(float(t))) for t in times], 20)
    found = AsymptoticMotion.of(oscillator, order).sample(times)
    pairs = (truth.x, found.x), (truth.v, found.v)
    return tuple(max(abs(float(a) - b) for a, b in zip(*pair)) for pair in pairs)


# Law, start, order, up to when; which of the two bounds is at most twice what is seen.
ATTAINED = [
    ({"2": "1/20"}, (1, 0), 3, None, "xv"),
    ({"3": "1/50"}, (1, 0), 3, None, "xv"),
    ({"3/2": "1/20"}, (1, 0), 2, None, "v"),
    pytest.param({"1": "1/10"}, (1, 0), 6, None, "v", marks=pytest.mark.slow),
    ({"1/2": "1/50"}, (1, 0), 1, 40, "xv"),
    ({"1/2": "1/50"}, (1, 0), 3, 40, "x"),
    ({"0": "1/50"}, (1, 0), 1, None, "xv"),
    ({"1": "1/50", "2": "1/50"}, (-1, 0), 2, None, "v"),
    ({"0": "1/100", "1": "1/50"}, (1, 0), 3, 20, "x"),
    ({"2": "1/50"}, ("1/2", "-1"), 2, None, "x"),
    ({"1/2": "1/50"}, ("1/2", "-1"), 2, 20, "x"),
]


@pytest.mark.parametrize(("law", "start", "order", "until", "sharp"), ATTAINED)
def test_the_bound_holds_and_half_of_it_does_not(law, start, order, until, sharp):
    oscillator = Oscillator(law, x0=start[0], v0=start[1])
    found = uniform_bound(oscillator, order, until=until)
    end = 30.0 if found.until is None else min(30.0, float(found.until))
    for name, seen, bound in zip("xv", true_errors(oscillator, order, end), (found.bound, found.velocity)):
        assert seen <= float(bound)
        if name in sharp:
            assert seen > float(bound) / 2


def test_in_si_it_is_the_same_bound():
    """Unit of length 1/5, omega_0 = sqrt(20): the dimensionless bounds times 1/5 and sqrt(20)/5."""
    plain = uniform_bound(Oscillator({"2": "1/50"}), 2)
    scaled = uniform_bound(Oscillator({"2": "3/20"}, mass="3/2", stiffness=30, x0="1/5"), 2)
    assert float(scaled.bound) == pytest.approx(float(plain.bound) / 5, rel=0.04)
    assert float(scaled.velocity) == pytest.approx(float(plain.velocity) * 20**0.5 / 5, rel=0.04)


@pytest.mark.parametrize("law", [{"1/2": "1/50"}, {"0": "1/50"}, {"0": "1/100", "2": "1/50"}])
def test_below_alpha_1_it_ends_where_it_says_and_grows_until_then(law):
    oscillator = Oscillator(law)
    whole, early = uniform_bound(oscillator, 2), uniform_bound(oscillator, 2, until=10)
    assert float(early.bound) <= float(whole.bound)
    assert early.until == "10"
    assert float(uniform_bound(oscillator, 2, until=whole.until).bound) <= float(whole.bound)
    with pytest.raises(LimitError, match="until"):
        uniform_bound(oscillator, 2, until=2 * Fraction(whole.until))


def test_at_the_stated_end_delta_is_still_in_range():
    """dA/dt = -p_1 eps A^alpha - ... : for alpha = 1/2, order 1, 2 (1 - sqrt A) = p_1 eps t, delta = eps/sqrt A."""
    waves = waveform_bounds((parse_real("1/2", "alpha"),), 1)
    limit, p_1 = float(largest_strength(waves, fades=False)), float(arb(waves.p[1]))
    found = float(uniform_bound(Oscillator({"1/2": "1/50"}), 1).until)
    end = 2 * (1 - (0.02 / limit)) / (p_1 * 0.02)
    assert 0.95 * end < found <= end


@pytest.mark.parametrize(("alphas", "order"), [(("2",), 1), (("2",), 3), (("3/2",), 2), (("1", "2"), 2)])
def test_the_constant_for_all_strengths_is_the_bound_at_its_largest(alphas, order):
    """For one law it is the same theorem; a sum is bounded by its slowest law, never better than the bound itself."""
    found = displacement_bound([parse_real(a, "alpha") for a in alphas], order)
    d = found.delta_max
    each = uniform_bound(Oscillator(dict.fromkeys(alphas, d / len(alphas))), order)
    ratio = float(found.constant) * float(d) ** order / float(each.bound)
    assert (0.93 if len(alphas) == 1 else 0.97) < ratio < (1.06 if len(alphas) == 1 else 2)
    assert displacement_bound([parse_real("1/2", "alpha")], order) is None


def test_where_nothing_is_known_energy_is_the_bound():
    found = uniform_bound(Oscillator({"40": "1/5"}), 2)
    assert 2 <= float(found.bound) <= 2.6


def test_uncertain_exponents_near_1_are_no_trouble():
    near = uniform_bound(Oscillator({1 + Fraction(1, 10**40): "1/50"}), 2)
    assert near.bound == uniform_bound(Oscillator({1: "1/50"}), 2).bound


def test_just_below_1_the_bound_ends_very_late():
    """1 - alpha = 1e-40 is nothing in a ball of alpha, and e^-s at the end is nothing beside 1."""
    near = Oscillator({1 - Fraction(1, 10**40): "1/50"})
    assert float(uniform_bound(near, 2).until) == pytest.approx(9.6e41, rel=0.1)
    assert uniform_bound(near, 2, until=20).bound == uniform_bound(Oscillator({1: "1/50"}), 2, until=20).bound


def reals(*texts):
    return tuple(parse_real(t, "alpha") for t in texts)


def theorem(law, order, oscillator=None):
    acting = (oscillator or Oscillator(law)).dimensionless.terms
    waves = waveform_bounds(tuple(t.velocity for t in acting), order)
    return _UniformTheorem(waves, order, tuple(t.strength.ball() for t in acting))


def test_each_part_of_the_bound_counts():
    """Without the omitted terms, the residual or the start the bound is smaller: none is forgotten."""
    with ctx.workprec(80):
        whole = theorem({"2": "1/20"}, 2)
        x, v, _ = whole.bound(moving=False, until=None)
        none = arb(0)
        silent = replace(whole.waves, residual=replace(whole.waves.residual, coefficients=(none,) * 9, cauchy=none))
        printed, turned, _ = _UniformTheorem(silent, 2, whole.strengths).bound(moving=False, until=None)
        assert abs(v - x - (turned - printed)) < arb(10) ** -15
        d = arb(1) / 20
        xi = whole.waves.displacements
        assert abs(printed - xi[2] * d**2 - xi[3] * d**3) < arb(10) ** -15
        assert x > printed
        moving, _, _ = whole.bound(moving=True, until=None)
        assert moving - x > whole.waves.sizes[2] * d**2


def test_on_each_piece_the_strength_is_the_largest():
    with ctx.workprec(80):
        whole = theorem({"1/2": "1/50", "2": "1/100"}, 2)
        S, total = arb(2), arb(0)
        pieces = whole._pieces(whole.strengths, S)
        for k, (u, integral, size) in enumerate(pieces):
            ends = [(S * (arb(j) / len(pieces) - 1)).exp() for j in (k, k + 1)]
            sizes = [sum((e * v**w for e, w in zip(whole.strengths, whole.weights)), arb(0)) for v in ends]
            assert all(abs(u - v) < 1e-15 or u > v for v in ends)
            assert all(v <= size for v in sizes)
            assert size < 1.01 * max(sizes, key=float)
            total += integral
        assert abs(total - (1 - (-S).exp())) < 1e-15


@pytest.mark.parametrize("strengths", [("1/50",), ("1/50", "1/20")])
def test_what_is_reached_later_is_hardly_later(strengths):
    whole = theorem(dict(zip(("2", "1"), strengths)), 2)
    with ctx.workprec(80):
        flow = whole._fastest(whole.strengths)
        for tau in (1, 1000):
            s = flow.beyond(arb(tau))
            assert tau <= flow.time(s) < tau * (1 + 1e-5)


def test_a_root_that_is_a_little_short_is_not_taken(monkeypatch):
    whole = theorem({"2": "1/50"}, 2)
    near = TruncatedFlow._near
    monkeypatch.setattr(TruncatedFlow, "_near", lambda self, f, t: near(self, f, t) * arb("0.9999"))
    with ctx.workprec(80):
        flow = whole._fastest(whole.strengths)
        assert flow.time(flow.beyond(arb(100))) >= 100


@pytest.mark.parametrize(("alphas", "delta"), [(("2",), "1/4"), (("3/2",), "1/2"), (("0", "2"), "1/10")])
def test_the_rates_are_attained_or_not_far_off(alphas, delta):
    """p_N/(|delta| (1 + Omega_N)) on rays: its least and its largest value, found by looking."""
    waves = waveform_bounds(tuple(parse_real(a, "alpha") for a in alphas), 3)
    d = float(Fraction(delta))
    rays = [(k / 10, 1 - k / 10) for k in range(11)] if len(alphas) == 2 else [(1.0,)]
    seen = []
    for ray in rays:
        for scale in (1e-6, d / 2, d):
            at = tuple(arb(x * scale) for x in ray)
            seen.append(float(waves.p.at(at) / (sum(at, arb(0)) * (1 + waves.Omega.at(at)))))
    low, high = (float(x) for x in rates(waves.p, waves.Omega, arb(d)))
    assert 0.85 * min(seen) < low <= min(seen) * (1 + 1e-12)
    assert max(seen) * (1 - 1e-12) <= high < 1.15 * max(seen)


@pytest.mark.parametrize(("exponent", "strength"), [("2", "1/5"), ("1", "1/10"), ("1/2", "1/10")])
def test_a_start_in_motion_has_its_amplitude_in_the_ball(exponent, strength):
    """A_0 of order 3 by Newton's method (``motions.truncation``); the ball reaches at most four times as far from 1."""
    oscillator = Oscillator({exponent: strength}, x0=1, v0=-1)
    whole = theorem(None, 3, oscillator)
    with ctx.workprec(80):
        frame = Truncation.of(oscillator, 3, "turning-point")
        true = (-frame.start(AsymptoticMotion.of(oscillator)._doubles.guess).s).exp()
        A, d = whole._start(moving=True)
        assert A.contains(true)
        assert abs(true - 1) > A.rad() / 4
        weight = whole.weights[0]
        assert whole.strengths[0] * true**weight <= d < whole.strengths[0] * true**weight * (1 + 2 * A.rad())


def test_decimals_are_rounded_up():
    whole, found = theorem({"2": "1/20"}, 2), uniform_bound(Oscillator({"2": "1/20"}), 2)
    with ctx.workprec(80):
        for decimal, ball in zip((found.bound, found.velocity), whole.bound(moving=False, until=None)):
            assert float(ball) < float(decimal) < 1.1 * float(ball)


def test_the_range_ends_where_the_amplitude_equation_may_lose_its_sign():
    """p = 0.4 d - d^3 is between d (0.4 -+ d^2): a factor of three at d^2 = 0.2; dry friction keeps below 3/10."""
    waves = waveform_bounds(reals("2"), 3)
    p, Omega = (Series({(k,): arb(c) for k, c in row.items()}, 1, 3) for row in ({1: 0.4, 3: -1}, {}))
    assert 0.42 < largest_strength(replace(waves, p=p, Omega=Omega), fades=True) < 0.2**0.5
    assert largest_strength(waves, fades=True) > 0.5
    assert largest_strength(waveform_bounds(reals("0"), 3), fades=False) == Fraction(3, 10)


def test_where_the_amplitude_equation_may_lose_its_sign_there_is_no_bound():
    """p = 0.4 d - 1e8 d^3 has no range of its own: the smallest strength that is tried is beyond its zero."""
    waves = replace(waveform_bounds(reals("2"), 3), p=Series({(1,): arb(0.4), (3,): arb(-(10**8))}, 1, 3))
    with ctx.workprec(80), pytest.raises(LimitError, match="lose its sign"):
        _UniformTheorem(waves, 3, (arb(1) / 1000,)).bound(moving=False, until=None)


@pytest.mark.parametrize(
    ("law", "keywords", "argument"),
    [
        ({"2": "1/10"}, {"order": 0}, "order"),
        ({"2": "1/10"}, {"order": 13}, "order"),
        ({"2": "1/10"}, {"until": 0}, "until"),
        ({"2": "1/10"}, {"until": -1}, "until"),
        ({"2": "-1/10"}, {}, "damping"),
    ],
)
def test_bad_input_names_the_argument(law, keywords, argument):
    with pytest.raises(InputError, match=argument):
        uniform_bound(Oscillator(law), **keywords)


def test_strong_damping_and_springs_are_refused():
    with pytest.raises(LimitError, match="beyond the range"):
        uniform_bound(Oscillator({"2": "1"}), 3)
    with pytest.raises(LimitError, match="beyond the range"):
        uniform_bound(Oscillator({"2": "2/3"}, x0=1, v0=-1), 3)
    with pytest.raises(InputError, match="springs"):
        uniform_bound(Oscillator({"2": "1/10"}, spring={3: "1/2"}), 3)


def test_no_damping_no_error():
    assert uniform_bound(Oscillator({"2": 0}), 3).to_dict() == {
        "order": 3,
        "bound": "0",
        "velocity": "0",
        "until": None,
    }
