"""The certified response against an own integrator after many periods, the closed linear answer, and near misses."""

import math
import time
from dataclasses import replace
from itertools import pairwise

import pytest
from flint import arb
from scipy.integrate import solve_ivp

import asymptotics as asy
from asymptotics.driven import contraction, first_order, linear, trial
from asymptotics.driven.drive import Drive
from asymptotics.driven.orbit import bits_lost, orbit
from asymptotics.driven.result import _orbit
from asymptotics.errors import UndecidedError
from asymptotics.law import Oscillator
from asymptotics.numbers.context import ctx
from asymptotics.numbers.decimals import bits_for


def after(law, f, omega, periods, start):
    """x, v at t = 0 and the largest |x| after so many periods, by another integrator."""

    def slope(t, z):
        loss = sum(b * math.copysign(abs(z[1]) ** a, z[1]) for a, b in law.items())
        return z[1], f * math.cos(omega * t) - z[0] - loss

    T = 2 * math.pi / omega
    found = solve_ivp(slope, (0, periods * T), start, method="DOP853", rtol=1e-11, atol=1e-13)
    last = solve_ivp(slope, (0, T), found.y[:, -1], method="DOP853", rtol=1e-11, atol=1e-13, dense_output=True)
    x = last.sol([T * n / 4000 for n in range(4001)])[0]
    return found.y[0, -1], found.y[1, -1], max(map(abs, x))


@pytest.mark.parametrize(
    ("law", "f", "omega"),
    [({2: 0.25}, 0.5, 1), ({1.5: 0.5, 1: 0.125}, 2, 0.75), ({3: 0.5}, 1, 1.5), ({1.25: 0.5, 2.5: 0.5}, 1, 2)],
)
def test_two_far_starts_end_in_it(law, f, omega):
    found = asy.response(law, f, omega, digits=10)
    assert found.certified
    for start in ((3 * float(found.amplitude), 0), (-1, 5 * float(found.amplitude))):
        x, v, largest = after(law, f, omega, 60, start)
        assert abs(x - float(found.x0)) < 1e-7 and abs(v - float(found.v0)) < 1e-7
        assert abs(largest - float(found.amplitude)) < 1e-6
    # Near miss: the first order is not the orbit.
    assert abs(largest - float(found.first_order.amplitude)) > 3e-6


@pytest.mark.parametrize("bits", [70, 150])
def test_the_orbit_in_balls_is_the_closed_form_of_viscous_damping(bits):
    """The same law by both ways, to all bits: as the route in balls does not know that alpha is 1."""
    drive = Drive.read(Oscillator({1: "1/10"}, mass=2, stiffness=3), "1/5", "7/5")
    with ctx.workprec(bits):
        found, C = orbit(drive), linear.coefficient(drive)
        x, v = found.state()
        for value, known in (
            (found.amplitude(), abs(C)), (x, C.real), (v, -C.imag), (found.harmonic(1).real, C.real),
            (found.harmonic(1).imag, C.imag), (abs(found.harmonic(3)), arb(0)),
        ):  # fmt: skip
            assert value.overlaps(known)
        assert found.amplitude().rel_accuracy_bits() > bits - 30
        # Near misses: another strength, and a mirrored phase.
        other = linear.coefficient(Drive.read(Oscillator({1: "1000001/10000000"}, mass=2, stiffness=3), "1/5", "7/5"))
        assert not found.amplitude().overlaps(abs(other))
        assert not found.harmonic(1).imag.overlaps(-C.imag)


def test_digits_of_one_precision_hold_at_another():
    few, many = (asy.response({"3/2": "1/5"}, 1, "4/5", digits=d) for d in (6, 18))
    for name in ("amplitude", "x0", "v0", "phase", "energy"):
        assert (
            asy.Coefficient(getattr(few, name), None).ball().overlaps(asy.Coefficient(getattr(many, name), None).ball())
        )
    assert few.amplitude == str(round(float(many.amplitude), 5)) and len(many.amplitude) == 19


def test_every_rung_holds_what_is_above_it():
    """The orbit and the first order at three precisions: each enclosure has those of more bits inside."""
    drive = Drive.read(Oscillator({"3/2": "1/5", 2: "1/10"}), 1, "4/5")
    rungs = []
    for bits in (64, 80, 100):
        with ctx.workprec(bits):
            own, balls = orbit(drive), drive.balls()
            waves = [part for n in (1, 3) for part in (own.harmonic(n).real, own.harmonic(n).imag)]
            A = first_order.amplitude(balls)
            there = first_order.amplitude(drive.balls_at_resonance())
            first = [A, first_order.phase(balls, A), first_order.resistance(balls, A), first_order.damping(drive, A)]
            peak = first_order.peak(drive)
            rungs.append([*own.state(), own.amplitude(), *waves, *first, *first_order.quality(drive, there), *peak])
    for low, high in pairwise(rungs):
        for n, (wide, narrow) in enumerate(zip(low, high, strict=True)):
            assert wide.contains(narrow) and narrow.rad() < wide.rad(), n


def test_energy_is_what_the_losses_take():
    """The work of the force against the mean of b |v|^(alpha+1) over the trial orbit, by quadrature in doubles."""
    found = asy.response({2: "1/4"}, "1/2", 1, digits=12)
    drive = Drive.read(Oscillator({2: "1/4"}), "1/2", 1)
    with ctx.workprec(80):
        own = orbit(drive)
        taken = 0.0
        for p, begin, end in zip(own.trial.pieces, own.trial.nodes, own.trial.nodes[1:]):
            h = (end - begin).mid()
            speeds = [float((own.length * p.state((h * (i + 0.5) / 40).mid())[1]).mid()) for i in range(40)]
            taken += 2 * sum(0.25 * v**3 for v in speeds) * float(h) / 40
    assert abs(taken / float(found.energy) - 1) < 1e-4


@pytest.mark.parametrize("law", [{2: "1/4"}, {"3/2": "1/4", 1: "1/10"}, {"sqrt(2)": "1/4"}])
def test_the_defect_of_every_piece_is_bounded(law):
    """mu w' - g + k y + c w^alpha at places of each piece, at far more bits: the bound holds, and not idly."""
    drive = Drive.read(Oscillator(law), "1/2", 1)
    with ctx.workprec(75):
        own = orbit(drive).trial
    balls, idle = own.balls, True
    with ctx.workprec(400):
        for p in own.pieces:
            exact = replace(p, ws=tuple(w.mid() for w in p.ws), y0=p.y0.mid())
            for share in (0.3, 1):
                s = (p.length * share).mid()
                y, w = exact.state(s)
                slope = sum(
                    (
                        (e + p.lead) * c * s ** (e + p.lead - 1)
                        for c, e in zip(exact.ws, p.exponents)
                        if e + p.lead != 0
                    ),
                    arb(0),
                )
                force = p.sign * balls.f * (p.begin + p.side * s).cos()
                r = balls.mu * slope - force + balls.k * y + p.side * sum((c * w**a for c, a in balls.losses), arb(0))
                # Midpoints of the coefficients add their own rounding, of 2^-75, to what is bounded.
                assert abs(r) * p.length <= p.defect + arb(2) ** -62
                idle = idle and abs(r) * p.length < p.defect / 1000
    assert not idle


def test_the_contraction_is_no_less_than_the_true_one():
    """Where e is large: the distance from the truth is within the bound; a thousandth of it does not hold."""
    drive = Drive.read(Oscillator({1: "1/10"}), "1/5", "7/5")
    with ctx.workprec(120):
        found = orbit(drive)
        C = linear.coefficient(drive) / found.length
    shifted = replace(found.trial, X=found.trial.X + arb(2) ** -40)
    with ctx.workprec(120):
        # One turning point moved by 2^-40: what half a period makes of it is known in closed form.
        moved = trial.march(found.trial.balls, trial.grids(drive.alphas, 120), shifted.theta, shifted.X)
        dx, dw = moved.mismatch
        e = (shifted.balls.k * dx**2 + shifted.balls.mu * dw**2).sqrt()
        q = contraction.factor(found.trial, arb(2) ** -10)
        truth = shifted.balls.k.sqrt() * abs(abs(shifted.X) - abs(C))
        assert truth < e / (1 - q) and q < 1
        # The true factor is e^(-c pi/(2 mu)), of the square root of the determinant: no bound may be below it.
        assert q > (-(shifted.balls.losses[0][0]) * arb.pi() / (2 * shifted.balls.mu)).exp() * arb("0.999")
        assert not truth < e / 1000 / (1 - q)


def test_what_is_not_served_is_told_by_name(monkeypatch):
    monkeypatch.setattr(trial, "MAX_PIECES", 60)  # of 4000: what needs more is refused as late as that
    for law, force, omega, word in (
        ({0: "0.479"}, "0.742", "1.751", "or dry friction holds the mass"),
        ({0: "0.199"}, "0.323", "2.362", "dry friction holds the mass where it turns"),
        ({0: "1/5"}, 1, "1/2", "omega_0 is 2 Omega"),
        ({"1/4": "0.479"}, "0.742", "1.751", "pieces"),
    ):
        found = asy.response(law, force, omega, digits=5)
        assert not found.certified and found.amplitude is None and word in found.notes[-1]
        assert found.first_order.amplitude
    monkeypatch.setattr(trial, "MAX_PIECES", 200)
    superharmonic = asy.response({2: "1/2"}, 20, "1/7", digits=5)
    assert superharmonic.certified or "turns" in superharmonic.notes[-1]


@pytest.mark.parametrize(
    ("law", "force", "omega"),
    [({2: "1e-30"}, "1/5", 2), ({2: "1/10"}, "1e-26", 1), ({"sqrt(2)": 1, "sqrt(3)": 1, "sqrt(5)": 1}, 1, 1)],
)
def test_weak_losses_and_many_powers_are_served(law, force, omega):
    """So weak that 53 bits of the contraction see none, doubles no phase; so many powers that few of them must do."""
    found = asy.response(law, force, omega, digits=5)
    assert found.certified
    if len(law) == 1:  # a loss of that size leaves first order right to all digits
        assert (found.amplitude, found.phase) == (found.first_order.amplitude, found.first_order.phase)
    else:
        x, v, largest = after({2**0.5: 1, 3**0.5: 1, 5**0.5: 1}, 1, 1, 20, (1, 0))
        assert abs(x - float(found.x0)) + abs(v - float(found.v0)) + abs(largest - float(found.amplitude)) < 1e-4


@pytest.mark.parametrize(("law", "force", "omega"), [({2: "1/10"}, "1/5", 10**400), ({2: "1e-300"}, "1/5", 1)])
def test_a_loss_too_weak_for_the_bits_is_told_before_the_work(law, force, omega):
    begin = time.process_time()
    found = asy.response(law, force, omega, digits=5)
    assert not found.certified and "more than 1024" in found.notes[-1] and found.first_order.amplitude
    assert time.process_time() - begin < 2


@pytest.mark.parametrize("digits", [5, pytest.param(30, marks=pytest.mark.slow)])
@pytest.mark.parametrize(
    ("law", "force", "omega", "fewer"),
    [({2: "1/10"}, "1/5", 1, False), pytest.param({2: "1e-20"}, "1/5", 2, False, marks=pytest.mark.slow),
     ({3: "1/10"}, "1e-8", "1/2", True)],
)  # fmt: skip
def test_the_bits_foretold_suffice(law, force, omega, fewer, digits):
    """Precision is foretold, for weak losses too: one attempt, and a fifth fewer bits do not do."""
    drive = Drive.read(Oscillator(law), force, omega)
    bits = bits_for(digits, 48) + bits_lost(drive)
    with ctx.workprec(bits):
        assert _orbit(drive, digits)["certified"]
    if fewer:
        with ctx.workprec(bits * 4 // 5), pytest.raises(UndecidedError):
            _orbit(drive, digits)


def test_too_few_bits_are_undecided(monkeypatch):
    drive = Drive.read(Oscillator({2: "1/10"}), "1/5", 1)
    monkeypatch.setattr("asymptotics.driven.orbit.factor", lambda *_: arb(1))
    with ctx.workprec(100), pytest.raises(UndecidedError):
        orbit(drive)
