"""Every bound of the driven response against the truth, where half of it does not hold."""

from dataclasses import replace

import pytest
from flint import arb

from asymptotics.driven import contraction, expansion, first_order, guess, linear, trial
from asymptotics.driven.drive import Balls, Drive
from asymptotics.driven.expansion import Arc, grid, piece
from asymptotics.driven.orbit import Orbit, orbit
from asymptotics.errors import UndecidedError
from asymptotics.law import Oscillator
from asymptotics.numbers.context import ctx
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.policy import exact_number

SHARES = [arb(n) / 8 for n in range(9)]


@pytest.fixture(scope="module")
def quadratic() -> Orbit:
    with ctx.workprec(80):
        return orbit(Drive.read(Oscillator({2: "1/4"}), "1/2", 1))


def test_the_rest_of_a_harmonic_is_that_of_the_wave():
    """A constant x, y = 1, over a short piece: at few bits the integral is exact but for the rest of e^(-i s)."""
    h = arb((1, -10), 0)
    one = Arc(arb(0), 1, 1, 0, arb(1), (arb(0),), (arb(0),), h, arb(0), arb(0))
    for bits, part in ((20, "real"), (25, "imag")):  # the wave ends before s^2, whose integral is real, and before s^3
        with ctx.workprec(bits):
            found = getattr(one.harmonic(1), part)
        with ctx.workprec(200):
            assert found.contains(h.sin() if part == "real" else h.cos() - 1)


def test_the_weights_of_an_uncertain_exponent_hold_those_of_both_ends():
    alpha, powers = arb(1.5, 0.125), grid((), 3, 40)
    kept = expansion._euler(alpha.mid().man_exp(), alpha.rad().man_exp(), powers, 40)
    for end in (arb(1.375), arb(1.625)):
        for n in range(1, 4):
            weights = [i * end - j for i, j in powers.products[n] if i]
            assert len(weights) == len(kept[n]) == n and all(map(arb.contains, kept[n], weights))


def test_growth_is_that_of_the_speed(quadratic):
    """w/(w_0 s^lead) - 1 along each piece is G(length) at most, and more than half of it somewhere."""
    nearest = arb(0)
    with ctx.workprec(200):
        for p in quadratic.trial.pieces:
            for s in (p.length * share for share in SHARES[1:]):
                grown = abs(p.state(s)[1] / (p.ws[0] * s**p.lead) - 1)
                assert not grown > p.growth
                nearest = max(nearest, (grown / p.growth).mid())
    assert nearest > 0.7


def test_speeds_and_slopes_hold_those_of_every_motion_in_the_room(quadratic):
    apart = arb("0.01")
    with ctx.workprec(100):
        for p in quadratic.trial.pieces:
            low, high = contraction._speeds(p, apart)
            for share in SHARES:
                w = p.state((p.length * share).mid())[1]
                assert (low == 0 or not w - apart < low.mid()) and not w + apart > high.mid()
    balls = Balls(arb(3), arb(1), arb(1), ((arb(2), arb(1)), (arb(5), arb(2))))  # g = (2 + 10 v)/3
    assert contraction._slope(balls, arb(1), arb(2), lower=True) <= 4
    assert contraction._slope(balls, arb(1), arb(2), lower=False) >= arb(22) / 3 * (1 - arb(2) ** -40)


def test_the_room_for_the_speed_is_that_of_the_norm(quadratic, monkeypatch):
    told = []
    known = contraction._speeds
    monkeypatch.setattr(contraction, "_speeds", lambda p, apart: told.append(apart) or known(p, apart))
    found, room = quadratic.trial, arb("0.001")
    contraction.factor(found, room)
    # The motion with x as on the orbit whose speed is off by this has the distance room from it.
    assert told and all(apart * found.balls.mu.sqrt() > room * (1 - arb(2) ** -30) for apart in told)


def test_monomials_beside_a_turning_point():
    found = grid((exact_number("3/2", "alpha"),), 4, 60)
    assert [float(e) for e in found.exponents] == [0, 1, 1.5, 2, 2.5, 3, 3.5, 4]


def test_a_piece_that_the_force_pulls_back_does_not_move_on():
    balls = Balls(arb(1), arb(1), arb(1), ((arb(1), arb(2)),))
    with ctx.workprec(60), pytest.raises(UndecidedError, match="does not move on"):
        piece(balls, grid((ExactReal(2),), 8, 60), arb(0), 1, 1, arb(2), None, -40.0)


@pytest.mark.parametrize("at_rest", [True, False])
def test_the_defect_of_a_force_alone_is_the_first_term_left_out(at_rest):
    """Hardly a spring, no loss: what does not cancel is the rest of the cosine, which half of the defect is below."""
    balls = Balls(arb(1), arb((1, -200), 0), arb(1), ())
    with ctx.workprec(300):
        # From rest s^9 is met, in motion s^7; the next power has a part of the cosine.
        w0, top = (None, 9) if at_rest else (arb(1), 8)
        p = piece(balls, grid((), top, 300), arb(0), 1, 1, arb(0), w0, -90.0)
        s = p.length
        slope = sum(((e + p.lead) * c * s ** (e + p.lead - 1) for c, e in zip(p.ws, p.exponents) if e + p.lead > 0),
                    arb(0))  # fmt: skip
        left = abs(slope - s.cos()) * s
    assert p.defect / 2 < left < p.defect


def test_the_peak_is_held_at_few_bits():
    drive = Drive.read(Oscillator({2: "1/10"}, mass=2, stiffness=3), "1/5", 1)
    with ctx.workprec(200):
        known = first_order.peak(drive)
    for bits in (30, 53, 90):
        with ctx.workprec(bits):
            assert all(wide.contains(narrow) for wide, narrow in zip(first_order.peak(drive), known))
    # An exponent a little below 1, whose curve falls from Omega = 0 on and has a hump near omega_0 as well.
    assert first_order.peak(Drive.read(Oscillator({"99/100": "1/1000"}), 1, 1)) is None


def test_the_error_moves_x_and_the_speed_by_as_much_as_the_norm_lets_it(quadratic):
    wide = replace(quadratic, error=arb(1) / 8)
    k, mu = quadratic.trial.balls.k, quadratic.trial.balls.mu
    (x, v), most = quadratic.state(), quadratic.amplitude()
    off, of_v = (quadratic.length / 8 * (1 - arb(2) ** -30) / size.sqrt() for size in (k, mu))
    for sign in (-1, 1):
        assert wide.amplitude().contains((most + sign * off).mid())
        assert wide.state()[0].contains((x + sign * off).mid()) and wide.state()[1].contains((v + sign * of_v).mid())


def moved_by(shift: arb, monkeypatch) -> tuple[trial.Trial, Orbit, arb]:
    """The trial orbit of a weak viscous loss at omega_0, its turning point moved: half a period hardly turns there."""
    drive = Drive.read(Oscillator({1: "1/100"}), 1, 1)
    with ctx.workprec(100):
        C = linear.coefficient(drive)

        def moved(balls, both, *_):
            theta, X = exact[0], exact[1] + shift
            return theta, X, trial.march(balls, both, theta, X)

        monkeypatch.setattr(trial, "_refined", moved)
        monkeypatch.setattr(guess, "turning_point", lambda *_: (0.0, 0.0))
        unit = first_order.amplitude(drive.balls()).mid()
        exact = ((-C.arg() - arb.pi()).mid(), (-abs(C) / unit).mid())
        found = orbit(drive)
    return found.trial, found, shift


def test_error_and_miss_of_a_moved_orbit_are_near_the_true_ones(monkeypatch):
    shift = arb((1, -40), 0)
    own, found, _ = moved_by(shift, monkeypatch)
    away = own.balls.k.sqrt() * shift
    assert away < found.error < away * 1.5
    # Half a period shortens what was moved by e^(-c pi/(2 mu)), and brings it back to where it was.
    gained = away * (1 - (-own.balls.losses[0][0] * arb.pi() / (2 * own.balls.mu)).exp())
    assert gained * 0.999 < own.miss < gained * 1.5


def test_the_march_counts_every_defect_and_has_a_limit(monkeypatch):
    drive = Drive.read(Oscillator({2: "1/4"}), "1/2", 1)
    with ctx.workprec(80):
        balls = drive.balls().in_units(arb(1))
        near = guess.turning_point(balls, 1.5)
        both = trial.grids(drive.alphas, 80)
        theta, X = (arb(v) for v in near)
        found = trial.march(balls, both, theta, X)
        ends = [p.state(p.length) for p in found.pieces[:-2]]  # the state after the last but one is in the mismatch
        jumps = sum((balls.k.sqrt() * y.rad() + balls.mu.sqrt() * w.rad() for y, w in ends), arb(0))
        counted = jumps + sum((p.defect for p in found.pieces), arb(0)) / balls.mu.sqrt()
        assert not counted > found.rest * (1 + arb(2) ** -40) and found.rest < counted * 2
        # The last piece is no longer than the length its defect was made for.
        last = piece(balls, both[0], theta + arb.pi(), -1, found.pieces[-1].sign, found.pieces[-1].y0, None, -76.0)
        assert found.pieces[-1].length <= last.length
        monkeypatch.setattr(trial, "MAX_PIECES", 2)
        with pytest.raises(UndecidedError, match="too many pieces"):
            trial.march(balls, both, theta, X)
