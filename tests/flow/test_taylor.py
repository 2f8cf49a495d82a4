"""A Taylor step under every force: its coefficients, its discs, and each part of the bound of its error."""

from math import log2

import mpmath
import pytest
from flint import arb, ctx

from asymptotics.errors import UndecidedError
from asymptotics.flow import taylor
from asymptotics.flow.balls import size_of
from asymptotics.flow.taylor import TaylorStep, coefficients, discs
from tests.each import each
from tests.flow.forces import FORCES, OTHERS, by_strength

ONE = arb(1)


def in_floats(force, side=1):
    """F(U, W) = G - ``linear`` U on one side of U = 0, in mpmath."""
    rate = None if force.rate is None else float(force.rate)
    powers = [(float(c), n) for c, n in force.restoring_powers(side)]
    losses = [(float(d), m, float(a)) for d, m, a in force.loss_powers(side)]

    def F(U, W):
        linear = (1 - force.linear) * U if rate is None else mpmath.sin(rate * U) / rate
        return linear + sum(c * U**n for c, n in powers) + sum(d * U**m * W**a for d, m, a in losses)

    return F


def step_at(name, bits=50, u="0.5", w="0.75", unit=ONE):
    with ctx.workprec(bits):
        return TaylorStep.at(FORCES[name], arb(u).mid(), arb(w), unit, ONE)


@pytest.mark.parametrize("name", FORCES)
def test_the_residual_of_a_step(name):
    """M is at least the largest |F| on the circle, and little more; the bound, evaluated again, holds at 250 bits."""
    step, unit = step_at(name, unit=arb(2)), 2
    us, ws = ([mpmath.mpf(float(c.mid())) for c in s] for s in (step.us, step.ws))
    F, radius, n, h = in_floats(FORCES[name]), float(step.radius), len(ws) - 1, float(step.length)
    circle = [radius * mpmath.expj(2 * mpmath.pi * k / 48) for k in range(48)]
    largest = max(abs(F(mpmath.polyval(us[::-1], z), mpmath.polyval(ws[::-1], z))) for z in circle)
    assert largest <= float(step.largest) <= (8 if name != "steep" else 4000) * largest + 1e-200
    cut = (unit * abs(ws[-1]) + step.linear * abs(us[-1])) * mpmath.mpf(h) ** (n + 1)
    again = (cut + float(step.largest) * (h / radius) ** n * h / (1 - h / radius)) / (n + 1)
    assert 0.999 * again <= float(step.residual) <= 1.001 * again
    fine = step_at(name, 250)
    with ctx.workprec(250):
        t = min(step.length, fine.length)
        missing = sum((abs(a - b) for a, b in zip(step.state(t), fine.state(t))), arb(0))
    assert missing < 2 * step.residual + arb(2) ** -45


@pytest.mark.parametrize("name", FORCES)
def test_the_discs_of_a_step_are_those_of_its_polynomials(name):
    """M of every disc is the largest force where sum |u_k| R^k and sum |w_k| R^k reach; the speed stays positive."""
    force, step = FORCES[name], step_at(name)
    found = list(discs(force, list(step.us), list(step.ws)))
    assert len(found) > 5 and all(a[0] > b[0] for a, b in zip(found, found[1:]))
    for radius, largest in found:
        du, dw = (sum((abs(c) * radius**k for k, c in enumerate(s) if k), arb(0)) for s in (step.us, step.ws))
        again = force.largest(step.us[0], du, step.ws[0], dw)
        assert again * arb("0.999") <= largest <= again * arb("1.001") and dw < step.ws[0]


def test_a_disc_on_which_the_speed_may_vanish_is_not_taken():
    """|w - 1| <= R + R^2 < 1 below the golden ratio's inverse only."""
    radius, _ = next(discs(FORCES["free"], [arb(0)] * 3, [arb(1), arb(1), arb(-1)]))
    assert radius + radius**2 < 1 and radius > arb("0.5")


@pytest.mark.parametrize("name", FORCES)
def test_no_other_disc_allows_a_longer_step(name):
    """The search ends early, but nothing is lost by it; a steep force is better served by a smaller disc."""
    step, n = step_at(name), len(step_at(name).ws) - 1
    lengths = []
    for radius, largest in discs(FORCES[name], list(step.us), list(step.ws)):
        power = (-50 - size_of(largest)) / n + size_of(radius) if largest > 0 else 0.0
        lengths.append(min(size_of(radius) - 0.2, power))
    assert size_of(step.length) <= max(lengths) + 1e-6
    cut = [size_of(c[-1]) for c in ((step.us, step.ws) if step.linear else (step.ws,))]
    assert size_of(step.length) >= min(max(lengths), *((-50 - size) / (n + 1) for size in cut)) - 1e-6
    first, _ = next(discs(FORCES[name], list(step.us), list(step.ws)))
    assert (name == "steep") == (step.radius < first * arb("0.99"))


@pytest.mark.parametrize("bits", [20, 53, 120])
def test_the_cut_of_a_step_is_attained(bits):
    """Without loss the residual is that of the last coefficients: attained up to the square root of 2."""
    step = step_at("free", bits)
    with ctx.workprec(400):
        c, s, (u, w) = step.length.cos(), step.length.sin(), (arb("0.5"), arb("0.75"))
        us, ws = coefficients(FORCES["free"], u, w, len(step.us) - 1)
        found_u, found_w = (sum((k * step.length**i for i, k in enumerate(v)), arb(0)) for v in (us, ws))
        truth = ((found_u - (u * c - w * s)) ** 2 + (found_w - (w * c + u * s)) ** 2).sqrt()
        assert truth <= step.residual and step.residual / 2 < truth


def test_the_parts_of_a_residual():
    """Each of the three alone, against its integral: nothing else of the Taylor polynomials enters."""
    h, R, n, unit = 0.25, 0.5, 6, 3.0
    flat, bent = [arb(1)] + [arb(0)] * n, [arb(1)] + [arb(0)] * (n - 1) + [arb(5)]
    for us, ws, largest, linear, rate in (
        (flat, bent, 0, 1, lambda t: unit * 5 * t**n),
        (bent, flat, 0, 1, lambda t: 5 * t**n),
        (bent, flat, 2, 0, lambda t: 2 * (t / R) ** n / (1 - h / R)),
    ):
        step = TaylorStep(tuple(us), tuple(ws), arb(h), arb(unit), arb(R), arb(largest), linear)
        assert float(step.residual) == pytest.approx(float(mpmath.quad(rate, [0, h])), rel=1e-9, abs=0)


@pytest.mark.parametrize(("name", "u"), [("duffing", "-0.9"), ("pendulum", "0.5"), ("dry", "-0.75")])
def test_the_box_of_a_step_holds_it(name, u):
    """Where the force grows along the step, half of the box of speeds would not; the places are those of both ends."""
    step = step_at(name, 20, u)
    places, speeds = step.box
    with ctx.workprec(150):
        states = [step.state(step.length * k / 16) for k in range(17)]
        farthest = max((abs(w - step.ws[0]) for _, w in states), key=float)
    assert all(places.contains(x.mid()) and speeds.contains(w.mid()) for x, w in states)
    assert speeds.rad() / 2 < farthest
    assert places.rad() < abs(states[-1][0] - states[0][0]) * arb("0.6")


def test_a_step_whose_speed_may_vanish_has_no_box():
    """w = 1 - 0.9 t - 0.5 t^2 vanishes before t = 0.9: what the last coefficient takes off is not less than w_0."""
    flat = (arb(0), arb(-1), arb(0))
    with pytest.raises(UndecidedError, match="may vanish"):
        _ = TaylorStep(flat, (arb(1), arb("-0.9"), arb("-0.5")), arb("0.9"), ONE, arb(2), ONE, 0).box
    assert TaylorStep(flat, (arb(1), arb("-0.1"), arb("-0.1")), arb("0.9"), ONE, arb(2), ONE, 0).box[1] > 0


@each("name", FORCES)
@each("u", ["0.5", "-0.25"])
def test_the_coefficients_solve_the_equations(name, u):
    """By the derivatives at the start, taken numerically along the polynomials: u' = -w, w' = G(u, w)."""
    force, side = FORCES[name], 1 if float(u) > 0 else -1
    us, ws = (list(map(float, c)) for c in coefficients(force, arb(u), arb("0.75"), 9))
    F = in_floats(force, side)
    with mpmath.workdps(40):
        U, W = (lambda t, c=c: mpmath.polyval(c[::-1], t) for c in (us, ws))
        rate = mpmath.taylor(lambda t: F(U(t), W(t)) + force.linear * U(t), 0, 6)
    for k in range(6):
        assert us[k + 1] * (k + 1) == pytest.approx(-ws[k], rel=1e-12)
        assert ws[k + 1] * (k + 1) == pytest.approx(float(rate[k]), rel=1e-9, abs=1e-9 * 40.0**k)


def test_every_kind_of_force_is_there():
    assert {force.linear for force in FORCES.values()} == {0, 1} and len(OTHERS) > 4
    assert any(n for name in OTHERS for _, n, _ in FORCES[name].loss_powers(1))
    assert log2(len(FORCES)) > 3


@pytest.mark.parametrize("exponent", ["1.5", "-1"])
def test_a_force_that_says_it_is_entire_has_whole_powers(exponent):
    """A step through w = 0 takes w^alpha by products: no other exponent may be cut down to one."""

    class Claims:
        rate, linear, entire = None, 1, True

        def restoring_powers(self, _side):
            return []

        def loss_powers(self, _side):
            return [(arb(-1), 0, arb(exponent))]

    with pytest.raises(ArithmeticError, match="not entire"):
        coefficients(Claims(), arb(1), arb(1), 4)


SUMS = [[("1/10", "3/2")], [("1/9", "1/2"), ("1/7", "7/5")], [("1/5", "1"), ("2", "3/2")]]


def by_recurrence(terms, u, w, order, bits):
    """Coefficients of so many bits at least; the last ones of those asked for have few, so that more are asked for."""
    with ctx.workprec(2 * bits):
        return [c[: order + 1] for c in taylor._of_real_powers(by_strength(*terms), u, w, 2 * order)]


@pytest.mark.parametrize("terms", SUMS)
@pytest.mark.parametrize("order", [1, 12, 13, 14, 25, 26, 41, 42, 55, 83])
def test_the_second_half_of_the_coefficients_is_that_of_the_recurrence(terms, order):
    u, w, bits = arb("-0.25"), arb("0.75"), int(order / taylor.DEGREE_PER_BIT) + taylor.GUARD
    with ctx.workprec(bits):
        found = taylor._by_halves(by_strength(*terms), u, w, order, order)
    for halves, fine in zip(found, by_recurrence(terms, u, w, order, bits + 60), strict=True):
        assert all(x.contains(z) for x, z in zip(halves, fine, strict=True))


@pytest.mark.parametrize("terms", SUMS)
@pytest.mark.parametrize("bits", [40, 80, 150, 260])
@pytest.mark.parametrize(("u", "w"), [("-0.25", "0.75"), ("0.9", "0.1"), ("0.5", "0.01")])
def test_fewer_bits_for_later_coefficients_leave_the_state_at_the_end_narrow(terms, bits, u, w):
    """The radii of all coefficients together are 2^20 times below what the step is allowed."""
    with ctx.workprec(bits + taylor.GUARD):
        force = by_strength(*terms)
    with ctx.workprec(bits):
        start = arb(u).mid(), arb(w).mid()
        step = TaylorStep.at(force, *start, arb(1), arb(1))
        for series in (step.us, step.ws):
            lost = sum((c.rad() * step.length**k for k, c in enumerate(series)), arb(0))
            assert lost < arb(2) ** (-20 - bits)
    fine = by_recurrence(terms, *start, len(step.ws) - 1, bits + 60)
    assert all(x.overlaps(z) for pair in zip((step.us, step.ws), fine) for x, z in zip(*pair, strict=True))
