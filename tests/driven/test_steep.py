"""Dry friction that slides all along and exponents below 1: the certified response by routes of their own."""

import math
import random
from collections.abc import Mapping
from itertools import pairwise

import pytest
from flint import arb
from scipy.integrate import solve_ivp

import asymptotics as asy
from asymptotics.driven.drive import Drive
from asymptotics.driven.orbit import free_harmonic, orbit
from asymptotics.law import Oscillator
from asymptotics.numbers.context import ctx

FEW = pytest.mark.parametrize("count", [3, pytest.param(200, marks=pytest.mark.slow)], ids=["few", "many"])
EXPONENTS = {"dry": (0.0,), "dry and drag": (0.0, 1.0, 1.5, 2.0, 3.0), "below 1": (0.1, 0.25, 0.5, 0.75, 0.9)}


def swung(law: Mapping[float, float], force, omega, start, end):
    """(x, v, the turning points, whether it stuck): integrated from turn to turn, where friction changes its side."""
    dry, t, (x, v), tops = law.get(0.0, 0.0), 0.0, start, []
    side = math.copysign(1, v)
    while t < end:

        def slope(s, z, side=side):
            loss = sum(b * math.copysign(abs(z[1]) ** a, z[1]) for a, b in law.items() if a)
            return [z[1], force * math.cos(omega * s) - z[0] - side * dry - loss]

        def at_rest(s, z):
            return z[1]

        at_rest.terminal, at_rest.direction = True, -side
        own = solve_ivp(slope, (t, end), (x, v), method="DOP853", rtol=1e-12, atol=1e-15, events=at_rest, max_step=0.3)
        if own.status != 1:
            return own.y[0, -1], own.y[1, -1], tops, False
        t, (x, _), v = own.t_events[0][0], own.y_events[0][0], 0.0
        tops.append(abs(x))
        pull = force * math.cos(omega * t) - x
        if abs(pull) <= dry:
            return x, v, tops, True
        side = math.copysign(1, pull)
    return x, v, tops, False


def drawn(kind, seed, count):
    rng = random.Random(seed)
    for _ in range(count):
        first, *more = EXPONENTS[kind]
        alphas = (rng.choice((first, *more)),) if kind == "below 1" else (first, *([rng.choice(more)] if more else ()))
        law = {a: round(10 ** rng.uniform(-1.7, -0.3), 3) for a in alphas}
        yield law, round(10 ** rng.uniform(-0.2, 0.5), 3), round(math.exp(rng.uniform(math.log(0.6), math.log(3))), 3)


def response(law, force, omega):
    return asy.response({str(a): str(b) for a, b in law.items()}, str(force), str(omega), digits=11)


@FEW
@pytest.mark.parametrize("kind", EXPONENTS)
def test_a_period_from_turn_to_turn_is_the_certified_orbit(kind, count):
    served = 0
    for law, force, omega in drawn(kind, 3, count):
        found = response(law, force, omega)
        if not found.certified:
            continue
        start, A, T = (float(found.x0), float(found.v0)), float(found.amplitude), 2 * math.pi / omega
        x, v, tops, stuck = swung(law, force, omega, start, T)
        off = max(abs(x - start[0]), abs(v - start[1]) / omega, abs(max(tops) - A)) / A
        assert off < 1e-9 and not stuck, (law, force, omega, off)
        served, last = served + 1, (law, force, omega, start, T, A)
    assert served > count / 2
    # Near miss: the last strengths off by 1e-5.
    law, force, omega, start, T, A = last
    x, v, _, _ = swung({a: b * (1 + 1e-5) for a, b in law.items()}, force, omega, start, T)
    assert max(abs(x - start[0]), abs(v - start[1])) > 1e-8 * A


@pytest.mark.parametrize(
    ("law", "force", "omega"), [({0.0: 0.3}, 1, 1.5), ({0.0: 0.2, 2.0: 0.1}, 1, 1), ({0.5: 0.3}, 1, 1.25)]
)
def test_two_far_starts_end_in_it(law, force, omega):
    found = response(law, force, omega)
    assert found.certified
    for start in ((4 * float(found.amplitude), 0.5), (-1, -3 * float(found.amplitude))):
        x, v, _, _ = swung(law, force, omega, start, 2 * math.pi / omega * 80)
        off = abs(x - float(found.x0)) + abs(v - float(found.v0))
        assert off < 1e-8
    first = found.first_order  # near miss
    assert abs(x - float(first.amplitude) * math.cos(float(first.phase))) > 1e-5


@pytest.mark.parametrize(("share", "omega"), [("1/5", "2"), ("3/10", "3/2"), ("1/10", "3/4"), ("1/50", "43/100")])
def test_dry_friction_alone_has_the_amplitude_of_den_hartog(share, omega):
    """(1/(1 - Omega^2))^2 less (c sin(pi/Omega)/(Omega (1 + cos(pi/Omega))))^2, f = 1 (Trans. ASME 53, 1931)."""
    drive = Drive.read(Oscillator({0: share}), 1, omega)
    with ctx.workprec(110):
        found = orbit(drive).amplitude()
        w, c = drive.omega.ball(), drive.friction.strength.ball()
        part = (arb.pi() / w).sin() / (w * (1 + (arb.pi() / w).cos()))

        def exact(c):
            return ((1 / (1 - w**2)) ** 2 - (c * part) ** 2).sqrt()

        assert found.overlaps(exact(c)) and found.rel_accuracy_bits() > 60
        assert not found.overlaps(exact(c * (1 + arb(2) ** -40)))


@pytest.mark.parametrize("more", [pytest.param(2, marks=pytest.mark.slow), "1/3"])
def test_every_rung_holds_what_is_above_it(more):
    rungs = []
    for bits in (72, 96):
        with ctx.workprec(bits):
            own = orbit(Drive.read(Oscillator({0: "1/5", more: "1/20"}), 1, "4/5"))
            rungs.append([*own.state(), own.amplitude(), own.harmonic(1).real, own.harmonic(3).imag])
    for low, high in pairwise(rungs):
        assert all(wide.contains(narrow) and narrow.rad() < wide.rad() for wide, narrow in zip(low, high))


def test_where_a_free_motion_rests_at_every_turn_of_dry_friction():
    def n_of(law, omega):
        return free_harmonic(Drive.read(Oscillator(law, mass="1/5", stiffness="16/5"), 1, omega))

    assert [n_of({0: "1/5"}, w) for w in (2, "4/3", "2.0001")] == [2, 3, None]
    assert n_of({0: "1/5", 1: "1/100"}, 2) is None
    assert free_harmonic(Drive.read(Oscillator({0: "1/5"}, mass=3), 1, "sqrt(1/12)")) == 2
