import math

import mpmath
import pytest
from flint import arb, ctx, fmpq

from asymptotics.errors import UndecidedError
from asymptotics.motions.invariants.certified import (
    absolute_radius,
    first_constant,
    last_turning_point,
    second_constant,
    series_radius,
    since_turning_point,
)
from asymptotics.motions.invariants.exact import coefficients
from asymptotics.numbers.precision import TooWideError


def _integrate(u0: float, tau: float) -> tuple[float, float]:
    """u, w after the time tau on a falling half-swing, by mpmath's Taylor integrator (w < 0 throughout: no switch)."""
    with mpmath.workdps(30):
        solution = mpmath.odefun(lambda _, y: [y[1], -y[0] + y[1] ** 2], 0, [mpmath.mpf(u0), mpmath.mpf(0)])
        return solution(mpmath.mpf(tau))


@pytest.mark.parametrize("tau", ["0.3", "1.5", "2.2", "3.1"])
@pytest.mark.parametrize("mirror", [1, -1])
def test_T_is_constant_along_the_half_swing(tau: str, mirror: int):
    u, w = _integrate(1, float(tau))
    with ctx.workprec(100):
        u, w = arb(str(mirror * u)), arb(str(mirror * w))
        assert abs(second_constant(u, w, arb(float(tau)))) < 1e-13
        assert abs(last_turning_point(u, w) - 1) < 1e-13
        assert abs(first_constant(u, w) + 3 * arb(-2).exp() / 4) < 1e-13


def test_time_to_a_turning_point_is_the_half_period():
    # Just before the next turning point of u_0 = 1 (|u_1| = 0.41072, T = 3.38097) the time is just below T.
    with ctx.workprec(100):
        assert abs(since_turning_point(arb("-0.41"), arb("-0.0170688")) - arb("3.35")) < 0.02


def test_states_without_a_turning_point_are_refused():
    with pytest.raises(ValueError, match="no turning point precedes"):
        last_turning_point(arb(0), arb(-2))
    with pytest.raises(UndecidedError, match="undecided"):
        first_constant(arb(0), arb(0, 1))


@pytest.mark.parametrize("w", [fmpq(1, 2), fmpq(1), fmpq(2)])
def test_radii_of_convergence_by_the_root_test(w: fmpq):
    # A logarithmic singularity makes |f_n| ~ C R^(-n) / n (n = 150 ... 156 and 300 ... 306, the largest of each seven),
    # so log(n |f_n|) grows by -150 log R.  The sum of absolute values does the same for rho.
    with ctx.workprec(400):
        for radius, absolute in ((series_radius(arb(w)), False), (absolute_radius(arb(w)), True)):
            growth = (_log_size(w, 300, absolute) - _log_size(w, 150, absolute)) / 150
            assert math.isclose(math.exp(-growth), float(radius.mid()), rel_tol=0.01)
            assert not math.isclose(math.exp(-growth), float(radius.mid()) * 1.03, rel_tol=0.01)


def _log_size(w: fmpq, start: int, absolute: bool) -> float:
    best = -math.inf
    for n in range(start, start + 7):
        terms = [arb(fmpq(c.numerator, c.denominator)) * arb(w) ** i for i, c in coefficients(n).items()]
        total = sum((abs(t) for t in terms), arb(0)) if absolute else abs(sum(terms, arb(0)))
        best = max(best, float((total * n).log().mid()))
    return best


def test_the_radii_start_at_one_and_decrease():
    radii = [(series_radius(arb(w) / 10), absolute_radius(arb(w) / 10)) for w in range(1, 30)]
    assert all(b[0] < a[0] and b[1] < a[1] for a, b in zip(radii, radii[1:]))
    assert all(rho < R and R < 1 for R, rho in radii)
    with ctx.workprec(150):
        assert absolute_radius(arb("1e-6")) > 0.99999


def test_a_sign_that_a_ball_does_not_tell_is_too_wide():
    near = arb(0, 1e-9)
    for asked in (lambda: first_constant(arb(1), near), lambda: since_turning_point(arb(1), near)):
        with pytest.raises(TooWideError, match="w = "):
            asked()
    with pytest.raises(TooWideError, match="4 S"):  # w^2 = u + 1/2 is the curve S = 0
        last_turning_point(arb(1) / 4, -(arb(3) / 4 + near).sqrt())
