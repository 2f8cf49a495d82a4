"""The constants of the O(): above the true difference over one half-swing, and nearly attained."""

import numpy as np
import pytest
from flint import arb, ctx
from scipy.integrate import solve_ivp

from asymptotics.bounds import local
from asymptotics.bounds.local import Remainder, flow_majorant, local_bounds
from asymptotics.errors import UndecidedError
from asymptotics.flow.damping import Damping
from asymptotics.numbers.exact import parse_real
from asymptotics.return_map.half_swing_map import integrated


def reals(*texts):
    return [parse_real(text, "alpha") for text in texts]


def truncated_swing(bounds, deltas):
    """(L_N, T_N) of the equations of order N, integrated in doubles."""
    weights = [float(a.ball()) - 1 for a in bounds.alphas]
    p, Omega = (f.truncate(bounds.order) for f in (bounds.flow.p, bounds.flow.Omega))

    def value(f, ln_A):
        at = [d * np.exp(w * ln_A) for d, w in zip(deltas, weights)]
        return sum(float(arb(c)) * np.prod([x**k for x, k in zip(at, n)]) for n, c in f.coefficients.items())

    def rates(psi, y):
        speed = 1 + value(Omega, y[0])
        return [-value(p, y[0]) / speed, 1 / speed]

    end = solve_ivp(rates, (0, np.pi), [0.0, 0.0], method="DOP853", rtol=1e-13, atol=1e-15).y[:, -1]
    return end[0], end[1]


def true_swing(alphas, deltas):
    with ctx.workprec(80):
        found = integrated(Damping.of([(arb(d), a) for d, a in zip(deltas, alphas)]), arb(1))
        return float(found.amplitude.log()), float(found.duration)


# Exponents, order, the part of delta_max at which to look, and the part of each bound that is attained there.
ATTAINED = [
    (("2",), 1, 0.3, 0.7, 0.7),
    (("3/2",), 1, 0.3, 0.7, 0.7),
    (("3/2",), 3, 0.5, 0.6, 0.6),
    (("1/2",), 1, 0.3, 0.6, 0.6),
    (("1/2",), 2, 0.5, 0.55, 0.5),
    (("3",), 2, 0.4, 0.6, 0.6),
    (("1",), 1, 0.3, 0.9, 0.9),
]


SLOW = [pytest.param(("1/2", "2"), marks=pytest.mark.slow), pytest.param(("3/2", "3"), marks=pytest.mark.slow)]


@pytest.mark.parametrize(("alphas", "order", "part", "share_L", "share_T"), ATTAINED)
def test_the_bounds_hold_and_half_of_them_would_not(alphas, order, part, share_L, share_T):
    bounds = local_bounds(reals(*alphas), order)
    d = part * float(bounds.delta_max)
    (L, T), (L_N, T_N) = true_swing(reals(*alphas), [d]), truncated_swing(bounds, [d])
    assert share_L * float(bounds.amplitude(arb(d))) < abs(L - L_N) < float(bounds.amplitude(arb(d)))
    assert share_T * float(bounds.duration(arb(d))) < abs(T - T_N) < float(bounds.duration(arb(d)))
    assert min(share_L, share_T) >= 0.5


@pytest.mark.parametrize("split", [0.1, 0.5, 0.9])
@pytest.mark.parametrize("order", [1, 2])
def test_the_bounds_of_a_sum_hold_for_every_mixture(split, order):
    alphas = reals("1", "2")
    bounds = local_bounds(alphas, order)
    d = float(bounds.delta_max) * 0.6
    deltas = [split * d, (1 - split) * d]
    (L, T), (L_N, T_N) = true_swing(alphas, deltas), truncated_swing(bounds, deltas)
    assert abs(L - L_N) < float(bounds.amplitude(arb(d)))
    assert abs(T - T_N) < float(bounds.duration(arb(d)))


@pytest.mark.parametrize("alpha", ["1/2", "3/2", "3"])
def test_the_majorant_of_the_equations_is_above_them_and_not_far_above(alpha):
    bounds = local_bounds(reals(alpha), 2)
    rho = float(bounds.delta_max) / 2
    growth, excess = flow_majorant(bounds.flow, 2, arb(rho))
    L, T = truncated_swing(bounds, [-rho])  # a driving force: the largest value on the circle
    assert abs(L) < float(growth) < 1.2 * abs(L)
    assert abs(T - np.pi) < float(excess) < 2.5 * abs(T - np.pi)
    assert flow_majorant(bounds.flow, 2, arb(50)) is None


def test_a_power_too_high_is_noticed():
    bounds = local_bounds(reals("2"), 2)
    with ctx.workprec(local.BITS):
        difference = bounds.half.L - bounds.flow.half_swing(arb.pi()).L
        assert local._sizes(difference, 3)
        with pytest.raises(ArithmeticError, match="degree 3"):
            local._sizes(difference, 4)


def test_dry_friction_alone_has_no_error():
    assert local_bounds(reals("0"), 2).to_dict()["amplitude"] == "0"


def test_constants_are_rounded_up_and_grow_with_delta():
    bounds = local_bounds(reals("3/2"), 2)
    shown = bounds.to_dict()
    assert arb(shown["amplitude"]) >= bounds.amplitude.constant(bounds.limit)
    assert arb(shown["frequency"]) >= bounds.duration.constant(bounds.limit)
    assert bounds.amplitude.constant(bounds.limit / 2) < bounds.amplitude.constant(bounds.limit)
    assert arb(shown["amplitude"]) < 3 * bounds.amplitude.coefficients[0]
    with pytest.raises(UndecidedError, match="polydisc"):
        bounds.amplitude.constant(bounds.amplitude.radius)
    assert Remainder(2, (arb(1),), arb(1), arb(1))(arb(0)) == 0


@pytest.mark.parametrize("d", ["0.01", "0.2", "0.45"])
def test_what_lies_beyond_is_a_geometric_series(d):
    """|c_k| = M rho^-k is Cauchy's worst: the sum of M (d/rho)^k over k >= first, and as a part of the constant."""
    remainder = Remainder(3, (arb(1) / 7, arb(1) / 5), arb(2), arb("0.5"))
    x = float(arb(d)) / 0.5
    whole = sum(2 * x**k for k in range(5, 2000))
    assert (
        whole <= float(remainder.beyond(arb(d), 5)) * (1 + 1e-12) and float(remainder.beyond(arb(d), 5)) < 1.001 * whole
    )
    known = float(arb(1) / 7) + float(arb(1) / 5) * float(arb(d))
    again = known + whole / float(arb(d)) ** 3
    assert (
        again <= float(remainder.constant(arb(d))) * (1 + 1e-12) and float(remainder.constant(arb(d))) < 1.001 * again
    )


@pytest.mark.parametrize(("alphas", "slack"), [(("2",), 2.5), (("1/2",), 11), (("1", "2"), 2.5)])
def test_both_functions_are_bounded_on_the_polydisc(alphas, slack):
    """M is above max |L| + max |L_N| on the circle, at most 2.5 times; for T - pi and T_N - pi ``slack`` times."""
    bounds = local_bounds(reals(*alphas), 2)
    rho = float(bounds.amplitude.radius)
    found = np.abs([complex_swings(bounds, [rho * turn for _ in alphas]) for turn in (1, -1, 1j)]).max(axis=0)
    for remainder, (motion, truncated), most in zip((bounds.amplitude, bounds.duration), found.T, (2.5, slack)):
        assert motion + truncated < float(remainder.cauchy) < most * (motion + truncated)
        assert min(motion, truncated) > 0.3 * max(motion, truncated)  # both count


def complex_swings(bounds, deltas):
    """(L, T - pi) of the motion and of the equations of order N for complex local strengths, in doubles."""
    exponents = [float(a.ball()) for a in bounds.alphas]

    def motion(angle, y):
        s, c = np.sin(angle), np.cos(angle)
        u = [d * np.exp((a - 1) * y[0]) * max(s, 0) ** a for d, a in zip(deltas, exponents)]
        room = 1 - sum(u) * c
        return [-sum(u) * s / room, 1 / room]

    flow = bounds.flow
    p, Omega = (f.truncate(bounds.order) for f in (flow.p, flow.Omega))

    def value(f, y):
        at = [d * np.exp((a - 1) * y) for d, a in zip(deltas, exponents)]
        return sum(float(arb(c)) * np.prod([x**k for x, k in zip(at, n)]) for n, c in f.coefficients.items())

    def truncated(_, y):
        speed = 1 + value(Omega, y[0])
        return [-value(p, y[0]) / speed, 1 / speed]

    ends = [solve_ivp(f, (0, np.pi), [0j, 0j], rtol=1e-9, atol=1e-11).y[:, -1] for f in (motion, truncated)]
    return [[end[0], end[1] - np.pi] for end in ends]


@pytest.mark.parametrize("steepness", [0.0, 1.0, 5.0, 20.0, 1000.0])
def test_the_end_of_a_piece_is_above_the_solution(steepness):
    """G' = 1 + k G from 0 over a piece of length 1/10 by the exponential; where no candidate serves none is given."""
    found = local._upper_end(arb(0), arb("0.1"), lambda g: (1 + steepness * g, arb(0)))
    truth = 0.1 if steepness == 0 else np.expm1(0.1 * steepness) / steepness
    assert (found is None) is (steepness > 4)
    assert found is None or truth <= float(found) < 1.5 * truth


@pytest.mark.parametrize("alphas", [("1", "2"), *SLOW])
def test_the_majorant_of_a_sum_is_nearly_attained(alphas):
    bounds = local_bounds(reals(*alphas), 2)
    rho = float(bounds.delta_max) / 2
    growth, excess = flow_majorant(bounds.flow, 2, arb(rho))
    L, T = truncated_swing(bounds, [-rho, -rho])
    assert abs(L) < float(growth) < 1.2 * abs(L)
    assert abs(T - np.pi) < float(excess)
