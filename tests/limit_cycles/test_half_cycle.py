"""One half-turn and its bounds: what is missing to the turning point, how motions part, the box of a step, J."""

import numpy as np
import pytest
from flint import arb, ctx
from scipy.integrate import quad, solve_ivp

from asymptotics.flow.error_propagation import CarriedErrors, distance_growth
from asymptotics.flow.taylor import TaylorStep
from asymptotics.law import Law
from asymptotics.limit_cycles import half_cycle
from asymptotics.limit_cycles.force import PolynomialForce
from asymptotics.limit_cycles.half_cycle import _after, _box, _Here, _integral, _step, _to_the_turn
from asymptotics.limit_cycles.half_cycle import half_cycle as half_turn
from asymptotics.limit_cycles.series import require_polynomial

VAN_DER_POL = require_polynomial(Law({1: -1, (1, 2): 1}), springs=True)
ZERO, ONE = arb(0), arb(1)


def at(u, w, error="0"):
    return _Here(arb(3), arb(u), arb(w), CarriedErrors(ZERO, arb(error)), ZERO)


VAN_DER_POL_LAW, RAYLEIGH = Law({1: -1, (1, 2): 1}), Law({1: -1, 3: 1})


def test_what_is_missing_to_the_turn_is_bounded_on_its_box():
    """dt = w/g, du = 2 w dt, dJ = |G_w| dt; g and G_w at the worst corner of |w| <= 2 omega, |u - u_0| <= 4 omega."""
    u, w = -1.9, 0.01
    found = _to_the_turn(PolynomialForce.of(VAN_DER_POL, ONE), ONE, at(u, w))
    corners = [(u + a * 4 * w, b * 2 * w) for a in (-1, 1) for b in (-1, 1)]
    g = min(-(x - s * (x * x - 1)) for x, s in corners)
    divergence = max(abs(x * x - 1) for x, _ in corners)
    for radius, wanted in ((found.T.rad(), w / g), (found.q.rad(), 2 * w * w / g), (found.J.rad(), divergence * w / g)):
        assert wanted * (1 - 1e-9) <= float(radius) < 1.05 * wanted


def test_what_was_uncertain_before_the_turn_is_so_after_it():
    field, error, unit = PolynomialForce.of(VAN_DER_POL, ONE), 0.001, arb(2)
    found = _to_the_turn(field, unit, at(-1.9, 0, error))
    assert float(found.T.rad()) >= error / 1.95 and float(found.q.rad()) >= error / 2


@pytest.mark.parametrize(("u", "w"), [(1.9, 0.3), (0.5, 0.2), (1.9, 1.0)])
def test_too_far_from_the_turn_nothing_is_claimed(u, w):
    """w must be below a quarter of the least deceleration on the box, or the orbit may leave it."""
    assert _to_the_turn(PolynomialForce.of(VAN_DER_POL, arb("1e-9")), ONE, at(-u, w)) is None


@pytest.mark.parametrize(
    ("mu", "unit", "u", "w"), [(1, 1, 0.3, 1.4), (5, 4, 1.8, 0.2), (5, 2, 0.2, 5.0), (3, 8, -1.2, 4)]
)
def test_how_far_two_motions_part(mu, unit, u, w):
    """Near one state: the largest singular value of e^(A t) from the variational equation; half the rate is refuted."""
    field, t = PolynomialForce.of(VAN_DER_POL, arb(mu)), 1e-4
    in_u, in_w = (float(c) for c in field.slopes(arb(u), arb(w)))
    scaled = np.array([[0, -unit], [in_u / unit, in_w]])
    largest = float(np.linalg.norm(np.eye(2) + t * scaled + t * t / 2 * scaled @ scaled, 2))
    bound = float(distance_growth(field, arb(unit), arb(u), arb(w), arb(t)))
    assert largest <= bound * (1 + 1e-9)
    assert largest - 1 > (bound - 1) / 2


def test_a_distance_grows_by_its_factor_and_the_next_state_keeps_it():
    field, error = PolynomialForce.of(VAN_DER_POL, ONE), arb("1e-6")
    with ctx.workprec(80):
        here = at("0.5", "1.5", error)
        step, ends = _step(field, ONE, here)
        there = _after(field, ONE, here, step)
        factor = distance_growth(field, ONE, *_box(ONE, here, step), step.length)
    assert not ends and there.errors.error >= error * factor * (1 - 1e-9) > error


def test_the_residual_of_a_step_counts():
    """A step of few bits, where its polynomials are off: the truth of many bits is within the error alone."""
    field = PolynomialForce.of(VAN_DER_POL, ONE)
    with ctx.workprec(200):
        fine = TaylorStep.at(field, arb("0.5"), arb("1.5"), ONE, ONE)
    with ctx.workprec(30):
        coarse = TaylorStep.at(field, arb("0.5"), arb("1.5"), ONE, ONE)
    length = min(fine.length, coarse.length).mid()
    with ctx.workprec(200):
        there = _after(field, ONE, at("0.5", "1.5"), coarse.shortened(length))
        u, w = fine.state(length)
        off = ((u - there.u) ** 2 + (w - there.w) ** 2).sqrt()
        assert off <= there.errors.error and there.errors.error < 2.0**-20
        assert off > there.errors.error / 1000


@pytest.mark.parametrize(("u", "w"), [("1.5", "0.75"), ("0.25", "1.5"), ("-1", "2")])
def test_the_box_of_a_step_holds_the_whole_step(u, w):
    """By an integrator, from the state and from states within the error."""
    field, error = PolynomialForce.of(VAN_DER_POL, ONE), 1e-3
    with ctx.workprec(53):
        here = at(u, w, error)
        step, _ = _step(field, ONE, here)
        box = _box(ONE, here, step)
    for du, dw in ((0, 0), (error, 0), (0, -error), (0.7 * error, 0.7 * error)):
        run = solve_ivp(lambda _, y: [-y[1], y[0] - (y[0] ** 2 - 1) * y[1]], (0, float(step.length)),
                        [float(u) + du, float(w) + dw], rtol=1e-11, atol=1e-13)  # fmt: skip
        assert all(box[0].contains(arb(x)) and box[1].contains(arb(s)) for x, s in run.y.T)
    assert box[1] > 0


def test_the_integral_of_the_slope_in_the_speed():
    """int G_w over the polynomials against a quadrature, and what the distance of the truth adds."""
    field = PolynomialForce.of(VAN_DER_POL, arb(2))
    with ctx.workprec(60):
        step = TaylorStep.at(field, arb("1.25"), arb("1.5"), ONE, ONE)
        whole = _integral(field, step)
        by_quadrature = quad(lambda t: -2 * (float(step.state(arb(t))[0]) ** 2 - 1), 0, float(step.length))[0]
        assert float(whole) == pytest.approx(by_quadrature, rel=1e-12)
        exact, rough = (_after(field, ONE, at("1.25", "1.5", e), step) for e in (ZERO, arb("1e-3")))
    wanted = 1e-3 * float(step.length) * 4 * 1.25  # |G_uw| = 2 mu u at the start, the error with it
    assert float(exact.J.rad()) < 1e-15 and wanted <= float(rough.J.rad()) < 20 * wanted


def test_an_orbit_that_goes_off_is_no_half_turn():
    with ctx.workprec(60):
        assert half_cycle.half_cycle(require_polynomial(Law({1: 1, (1, 2): -1}), springs=True), arb(3), arb(3)) is None


def test_the_last_step_ends_next_to_the_zero_of_the_speed():
    """Without losses u = cos t, w = sin t: T = pi, q = 1 and J = 0."""
    with ctx.workprec(100):
        found = half_cycle.half_cycle(VAN_DER_POL, ZERO, ONE)
        assert found.T.contains(arb.pi()) and found.T.rad() < 1e-25
        assert found.q.contains(ONE) and found.J == 0


@pytest.mark.parametrize(("mu", "bits"), [("0.0625", 40), ("3", 40), ("1", 150), ("7", 90)])
def test_the_speed_has_no_other_zero_on_the_way(mu, bits, monkeypatch):
    """On every box with the room of its errors: G > 0 at first, then w > 0, at last G < 0 and the turn is near."""
    seen = []

    def noted(force, unit, here, step):
        seen.append((here, step, *_box(unit, here, step)))
        return _after(force, unit, here, step)

    monkeypatch.setattr(half_cycle, "_after", noted)
    with ctx.workprec(bits):
        field = PolynomialForce.of(VAN_DER_POL, arb(mu))
        assert half_cycle.half_cycle(VAN_DER_POL, arb(mu), arb(2)) is not None
        (_, _, *first), *middle, (here, last, *ending) = seen
        assert field.at(*first) > 0 and all(w > 0 for _, _, _, w in middle) and field.at(*ending) < 0
        assert abs(last.state(last.length)[1]) < 1e-6 * here.w
        for begin, step, _, w in seen:
            assert w.rad() >= 2 * (begin.errors.error + step.residual)


@pytest.mark.parametrize(("place", "speed", "far"), [(0.5, 1.5, 0.25), (0.125, 0.125, 0.0625)])
def test_the_worst_of_a_box_counts(place, speed, far):
    """The factor over a box is that of its worst corner at least, in doubles; that of its middle is less."""
    field, t = PolynomialForce.of(VAN_DER_POL, ONE), 0.01

    def factor(u, w):
        in_u, in_w = 1 - 2 * u * w, 1 - u * u
        return np.exp(t * (in_w / 2 + np.hypot(in_w / 2, (in_u - 1) / 2)))

    found = float(distance_growth(field, ONE, arb(place, far), arb(speed, far), arb(t)))
    worst = max(factor(place + a * far, speed + b * far) for a in (-1, 1) for b in (-1, 1))
    assert worst <= found < worst * 1.01
    assert factor(place, speed) < worst


def test_a_box_has_room_for_all_that_the_errors_may_become():
    """The factor of a step is at most ``_ROOM``: the box holds that many errors about the polynomials."""
    field, error, unit = PolynomialForce.of(VAN_DER_POL, ONE), arb("1e-3"), arb(2)
    step = TaylorStep.at(field, arb("0.5"), arb("1.5"), unit, ONE)
    wide, exact = (_box(unit, at("0.5", "1.5", e), step) for e in (error, ZERO))
    more = [(float(x.rad()) - float(y.rad())) for x, y in zip(wide, exact, strict=True)]
    assert more == pytest.approx([half_cycle._ROOM * 5e-4, half_cycle._ROOM * 1e-3], rel=1e-3)


def test_the_half_turn_encloses_and_bites():
    """At a low precision the ball contains the fine value; a wide start gives a wide image, and its midpoint misses."""
    with ctx.workprec(160):
        fine = half_turn(VAN_DER_POL_LAW.terms, arb(1), arb(2))
    with ctx.workprec(80):
        coarse = half_turn(VAN_DER_POL_LAW.terms, arb(1), arb(2))
        wide = half_turn(VAN_DER_POL_LAW.terms, arb(1), arb(2, 1e-9))
    for name in ("q", "T", "J"):
        assert getattr(coarse, name).contains(getattr(fine, name))
        assert getattr(coarse, name).rad() < 1e-10
    with ctx.workprec(160):
        edge = half_turn(VAN_DER_POL_LAW.terms, arb(1), arb(2) + arb(10) ** -9)
    assert wide.q.contains(edge.q) and wide.q.contains(fine.q)
    assert not wide.q.mid().overlaps(edge.q)
