"""Random laws, forces and frequencies: the certified orbit against another integrator, over a period and after 200."""

import math
import random

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import asymptotics as asy

FEW = pytest.mark.parametrize("count", [2, pytest.param(200, marks=pytest.mark.slow)], ids=["few", "many"])
EXPONENTS = (1.0, 1.25, 1.5, 1.75, 2.0, 2.5, 3.0, 4.0, 5.5)


def drawn(seed, count, least=-2.0):
    """So many (law, force, omega), each number a decimal that is a double's as well; no law is viscous alone."""
    rng = random.Random(seed)
    for _ in range(count):
        law = {rng.choice((*EXPONENTS, round(rng.uniform(1, 4), 3))): round(10 ** rng.uniform(least, 0.5), 4)
               for _ in range(rng.choice((1, 1, 1, 2, 3)))}  # fmt: skip
        if set(law) == {1.0}:
            law[2.0] = 0.1
        omega = math.exp(rng.uniform(math.log(0.3), math.log(3)))
        yield law, round(10 ** rng.uniform(-1.5, 1), 3), round(omega, 3)


def response(law, force, omega):
    return asy.response({str(a): str(b) for a, b in law.items()}, str(force), str(omega), digits=11)


def motion(law, force, omega, start, periods, rtol=1e-12, **options):
    def slope(t, z):
        loss = sum(b * math.copysign(abs(z[1]) ** a, z[1]) for a, b in law.items())
        return [z[1], force * math.cos(omega * t) - z[0] - loss]

    span = (0, 2 * math.pi / omega * periods)
    return solve_ivp(slope, span, start, method="DOP853", rtol=rtol, atol=1e-4 * rtol, **options)


def at_rest(t, z):
    return z[1]


def misses(found, law, force, omega):
    """By how much a period that begins at (x0, v0) misses it, and the other numbers; relative to the amplitude."""
    A, start, T = float(found.amplitude), (float(found.x0), float(found.v0)), 2 * math.pi / omega
    own = motion(law, force, omega, start, 1, dense_output=True, events=at_rest)
    t = np.arange(4096) * (T / 4096)
    x, v = own.sol(t)
    waves = {n: 2 * np.mean(x * np.exp(-1j * n * omega * t)) for n in (1, 3)}
    told = {n: float(w["amplitude"]) * np.exp(-1j * float(w["phase"])) for n, w in found.harmonics.items()}
    return {
        "period": max(abs(own.y[0, -1] - start[0]), abs(own.y[1, -1] - start[1]) / omega) / A,
        # The ends of the steps next to rest: their interpolant is good to 1e-8 alone.
        "amplitude": abs(largest(law, force, omega, own) / A - 1),
        "harmonics": max(abs(waves[n] - told[str(n)]) for n in waves) / A,
        "phase": abs(-np.angle(waves[1]) - float(found.phase)),
        "energy": abs(np.mean(force * np.cos(omega * t) * v) * T - float(found.energy)) / (force * A),
    }


def largest(law, force, omega, own):
    """|x| where v = 0: short steps from the last point of the integrator before it."""
    place = int(np.searchsorted(own.t, own.t_events[0][0])) - 1

    def slope(t, z):
        loss = sum(b * math.copysign(abs(z[1]) ** a, z[1]) for a, b in law.items())
        return [z[1], force * math.cos(omega * t) - z[0] - loss]

    span, start = (own.t[place], own.t_events[0][0] + 1e-3), own.y[:, place]
    near = solve_ivp(slope, span, start, method="DOP853", rtol=1e-13, atol=1e-17, events=at_rest,
                     max_step=(span[1] - span[0]) / 50)  # fmt: skip
    return abs(near.y_events[0][0][0])


@FEW
def test_a_period_of_another_integrator_is_the_certified_orbit(count):
    for law, force, omega in drawn(1, count):
        found = response(law, force, omega)
        if not found.certified:
            assert "turns" in found.notes[-1] or "swings" in found.notes[-1]
            continue
        off = misses(found, law, force, omega)
        assert max(off.values()) < 1e-9, (law, force, omega, off)
    # Near miss: the last law with a strength off by 1e-5.
    other = {alpha: b * (1 + 1e-5) for alpha, b in law.items()}
    assert max(misses(found, other, force, omega).values()) > 1e-9


@FEW
def test_after_200_periods_two_far_starts_are_on_it(count):
    tried = 0
    for law, force, omega in drawn(2, count // 4 + 1, least=-0.7):
        found = response(law, force, omega)
        # What two starts still are apart is e^(-pi c_eq/Omega) to the power 200 at most: weak losses attract slowly.
        if not found.certified or 200 * math.pi * float(found.first_order.c_eq) / omega < 30:
            continue
        tried, A = tried + 1, float(found.amplitude)
        for start in ((4 * A, -3 * A * omega), (-7 * A, 0)):
            own = motion(law, force, omega, start, 200, rtol=1e-11).y[:, -1]
            off = abs(own[0] - float(found.x0)) + abs(own[1] - float(found.v0)) / omega
            assert off < 1e-7 * A, (law, force, omega, start, off)
            # Near miss: the state to first order.
            first = found.first_order
            x = float(first.amplitude) * math.cos(float(first.phase))
            assert abs(own[0] - x) > 1e-7 * A
    assert tried
