"""What is read of a drive: the equation in theta is that in time, and what a force cannot move by integration."""

import math
from fractions import Fraction

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from asymptotics.driven.drive import Drive
from asymptotics.errors import InputError
from asymptotics.law import Oscillator
from asymptotics.numbers.context import ctx


def moved(mass, stiffness, losses, force, rate, span):
    """x of mass x'' + stiffness x + losses = force cos(rate t) from (0.3, 0.2/rate) at ten places of the span."""

    def slope(t, z):
        loss = sum(b * math.copysign(abs(z[1]) ** a, z[1]) for b, a in losses)
        return [z[1], (force * math.cos(rate * t) - stiffness * z[0] - loss) / mass]

    places = np.linspace(0, span, 10)
    return solve_ivp(slope, (0, span), (0.3, 0.2 * rate), method="DOP853", rtol=1e-11, atol=1e-13, t_eval=places).y[0]


def test_the_equation_in_theta_is_that_in_time():
    """m = 2, k = 3, Omega = 7/5 from typed numbers, in two units of x; near miss: another power of Omega."""
    law, m, k, f, omega = {2: "1/5", "3/2": "1/10", 3: 0}, 2, 3, "3/4", "7/5"
    w, force = (float(Fraction(v)) for v in (omega, f))
    true = moved(m, k, [(0.2, 2), (0.1, 1.5)], force, w, 9 / w)
    with ctx.workprec(80):
        plain = Drive.read(Oscillator(law, mass=m, stiffness=k, x0=5), f, omega).balls()
        scaled = plain.in_units(plain.f * 2)
    read = {
        n: [float(b.mu), float(b.k), [tuple(map(float, t)) for t in b.losses], float(b.f)]
        for n, b in ((1.0, plain), (2 * force, scaled))
    }
    for unit, (mu, stiffness, losses, size) in read.items():

        def slope(s, z, mu=mu, stiffness=stiffness, losses=losses, size=size):
            loss = sum(c * math.copysign(abs(z[1]) ** a, z[1]) for c, a in losses)
            return [z[1], (size * math.cos(s) - stiffness * z[0] - loss) / mu]

        x = solve_ivp(slope, (0, 9), (0.3 / unit, 0.2 / unit), method="DOP853", rtol=1e-11, atol=1e-13,
                      t_eval=np.linspace(0, 9, 10)).y[0]  # fmt: skip
        assert np.allclose(unit * x, true, atol=1e-8)
    other = moved(m, k, [(0.2 * w, 2), (0.1, 1.5)], force, w, 9 / w)
    assert not np.allclose(other, true, atol=1e-3)


@pytest.mark.parametrize("share", [0.98, 1.02])
def test_a_force_below_the_dry_friction_moves_nothing(share):
    """v/sqrt(v^2 + d^2) for the sign of v: below the friction x is of the size of d, above it is not."""
    friction, force, d = 0.5, 0.5 * share, 1e-6

    def slope(t, z):
        return [z[1], force * math.cos(t / 10) - z[0] - friction * z[1] / math.hypot(z[1], d)]

    x = solve_ivp(slope, (0, 30), (0, 0), method="LSODA", rtol=1e-9, atol=1e-12).y[0]
    assert (np.max(abs(x)) > 1e-3) == (share > 1)
    if share < 1:
        with pytest.raises(InputError, match="never moves the mass"):
            Drive.read(Oscillator({0: "1/2", 2: 1}), force, "1/10")
    else:
        assert Drive.read(Oscillator({0: "1/2", 2: 1}), force, "1/10").friction.strength == Fraction(1, 2)


@pytest.mark.parametrize(
    ("law", "force", "omega", "named"),
    [
        ({2: 1}, 0, 1, "force"), ({2: 1}, -1, 1, "force"), ({2: 1}, 1, 0, "omega"), ({2: 0}, 1, 1, "law"),
        ({0: 1, 2: 1}, 1, 1, "force"), ({(3, 0): 1, (0, 1): "1/10"}, 1, 1, "law"),
        ({1: "-1/10", 3: 1}, 1, 1, "strength"),
    ],
)  # fmt: skip
def test_what_is_no_drive_is_refused_by_name(law, force, omega, named):
    with pytest.raises(InputError) as error:
        Drive.read(Oscillator(law), force, omega)
    assert error.value.argument == named
