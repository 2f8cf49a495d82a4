"""Many ways of being wrong, as samples x(tau) of motions from rest: (what it is, its name, how it is made).

Integrators at several steps and tolerances, formulas of first and second order, wrong strengths, exponents and laws,
noise, and rounded values.  ``RIGHT`` are the answers of ``quick_look`` that are right for each.
"""

from itertools import product

import numpy as np
from scipy.integrate import solve_ivp
from scipy.special import beta, betainc

from tests.tables import second

_RNG = 20260101
# The thresholds were chosen on {1: 0.1}, {2: 0.1}, {3/2: 0.15}, {3: 0.3}, {1: 0.03, 2: 0.1}, {1/2: 0.05}, {5/2: 0.5},
# {4: 0.2}, {0: 0.005, 1: 0.05}, {1: 0.02, 3: 0.2}, {3/4: 0.04}, {1: 0.04, 3/2: 0.05}; these are others.
UNSEEN = [((1.25,), (0.3,)), ((5.0,), (0.6,)), ((0.8,), (0.05,)), ((2.0, 3.0), (0.05, 0.1)),
          ((1.0, 1.5), (0.03, 0.06)), ((0.0, 2.0), (0.004, 0.08)), ((2.0,), (0.4,)), ((1.0,), (0.15,))]  # fmt: skip
FINE, COARSE = np.linspace(0, 30, 601), np.linspace(0, 40, 201)
EULER, STEPS, FIRST, SECOND = "Euler's method", "an integrator", "a formula of first order", "a formula of second order"
WRONG, SLIGHTLY, NOISE, ROUNDED = "another law", "a law changed by a thousandth or less", "noise", "rounded values"

RIGHT = {
    EULER: {"truncation"},
    STEPS: {"truncation", "phase drift", "rounding"},
    FIRST: {"phase drift"},
    SECOND: {"truncation", "rounding"},
    WRONG: {"wrong law"},
    SLIGHTLY: {"wrong law"},
    NOISE: {"truncation"},
    ROUNDED: {"rounding"},
}


def force(law):
    a, e = law
    return lambda v: sum(s * np.sign(v) * abs(v) ** p for p, s in zip(a, e))


def truth(law, grid):
    """x, v and (times, sizes) of the turning points, half-swing by half-swing with the sign of v fixed."""
    a, e = law
    tau, x, side, xs, vs = 0.0, 1.0, -1.0, [], []
    times, sizes = [0.0], [1.0]
    while len(xs) < len(grid):

        def rhs(_, y, side=side):
            w = max(side * y[1], 0.0)
            return [y[1], -y[0] - side * sum(s * (w**p if p else 1.0) for p, s in zip(a, e))]

        def turns(t, y, tau=tau, side=side):
            return side if t <= tau + 0.1 else y[1]

        turns.terminal = True
        inside = grid[(grid >= tau) & (grid <= tau + 6)]
        found = solve_ivp(rhs, (tau, tau + 6), [x, 0.0], "DOP853", inside, events=turns, rtol=1e-13, atol=1e-15)
        xs, vs = [*xs, *found.y[0]], [*vs, *found.y[1]]
        tau, x, side = found.t_events[0][0], found.y_events[0][0][0], -side
        times.append(tau)
        sizes.append(abs(x))
    return np.array(xs[: len(grid)]), np.array(vs[: len(grid)]), (np.array(times), np.array(sizes))


def adaptive(method, rtol):
    def run(law, tau):
        N, ends = force(law), (0, tau[-1])
        found = solve_ivp(
            lambda t, y: [y[1], -y[0] - N(y[1])], ends, [1.0, 0.0], method, tau, rtol=rtol, atol=rtol / 99
        )
        return found.y[0]

    return run


def stepped(step, per):
    """A fixed step: ``per`` steps between two of the samples."""

    def run(law, tau):
        N, h = force(law), tau[1] / per
        x, v, found = 1.0, 0.0, [1.0]
        for k in range((len(tau) - 1) * per):
            x, v = step(x, v, h, N)
            if (k + 1) % per == 0:
                found.append(x)
        return np.array(found)

    return run


def euler(x, v, h, N):
    return x + h * v, v + h * (-x - N(v))


def symplectic_euler(x, v, h, N):
    v = v + h * (-x - N(v))
    return x + h * v, v


def heun(x, v, h, N):
    f = -x - N(v)
    y, w = x + h * v, v + h * f
    return x + h / 2 * (v + w), v + h / 2 * (f - y - N(w))


def leapfrog(x, v, h, N):
    half = v + h / 2 * (-x - N(v))
    x = x + h * half
    return x, half + h / 2 * (-x - N(half))


def midpoint(x, v, h, N):
    y, w = x, v
    for _ in range(12):
        y, w = x + h / 2 * w, v + h / 2 * (-y - N(w))
    return 2 * y - x, 2 * w - v


def rk4(x, v, h, N):
    def f(s):
        return np.array([s[1], -s[0] - N(s[1])])

    s = np.array([x, v])
    k1 = f(s)
    k2 = f(s + h / 2 * k1)
    k3 = f(s + h / 2 * k2)
    k4 = f(s + h * k3)
    return tuple(s + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4))


def formula(order):
    """The equations of an order for amplitude and phase; from the second on with the waveform of first order too."""

    def run(law, tau):
        a, e = law
        p, Omega = second.normal_form(a, 3)

        def value(f, d):
            return sum(c * np.prod([x**k for x, k in zip(d, n)]) for n, c in f.items() if sum(n) <= order)

        def rates(_, y):
            d = [s * np.exp((q - 1) * y[0]) for q, s in zip(a, e)]
            return [-value(p, d), 1 + value(Omega, d)]

        ln_A, psi = solve_ivp(rates, (0, tau[-1]), [0.0, 0.0], "DOP853", tau, rtol=1e-12, atol=1e-14).y
        wave = np.cos(psi)
        if order > 1:
            for q, s in zip(a, e):
                real, imaginary = waveform(q, psi % np.pi)
                wave = wave + s * np.exp((q - 1) * ln_A) * (np.cos(psi) * real - np.sin(psi) * imaginary)
        return np.exp(ln_A) * wave

    return run


def waveform(a, psi):
    """Z_1 = p_1 psi - integral of sin^(a+1) - i sin^(a+1)/(a+1) on 0 <= psi < pi."""
    whole = beta(a / 2 + 1, 0.5)
    part = whole / 2 * betainc(a / 2 + 1, 0.5, np.sin(psi) ** 2)
    part = np.where(psi <= np.pi / 2, part, whole - part)
    return whole / np.pi * psi - part, -(np.sin(psi) ** (a + 1)) / (a + 1)


def exactly(change):
    """The right motion of a law that is not the one asked about."""

    def run(law, tau):
        return truth(change(*map(list, law)), tau)[0]

    return run


def changed(place, factor=1.0, power=0.0):
    def change(a, e):
        a[place], e[place] = a[place] + power, e[place] * factor
        return tuple(a), tuple(e)

    return change


def more(power, strength):
    return lambda a, e: ((*a, power), (*e, strength))


def spoiled(how):
    def run(law, tau):
        return how(np.random.default_rng(_RNG), truth(law, tau)[0])

    return run


WAYS = [
    *((EULER, f"Euler, 1/{n}", stepped(euler, n)) for n in (1, 5, 50)),
    *((STEPS, f"{step.__name__}, 1/{n}", stepped(step, n))
      for step, n in product((symplectic_euler, heun, leapfrog, midpoint, rk4), (1, 5))),
    *((STEPS, f"{m}, rtol {r:g}", adaptive(m, r))
      for m, r in product(("RK45", "DOP853", "Radau", "LSODA"), (1e-3, 1e-5, 1e-7, 1e-9))),
    (FIRST, "order 1", formula(1)),
    (SECOND, "order 2", formula(2)),
    *((WRONG, f"strength times {f}", exactly(changed(0, f))) for f in (0.8, 0.98, 1.02, 1.3)),
    *((WRONG, f"exponent {p:+}", exactly(changed(-1, 1.0, p))) for p in (-0.2, 0.1, 0.5)),
    (WRONG, "a linear term of 0.02 more", exactly(more(1.0, 0.02))),
    (WRONG, "a cubic term of 0.05 more", exactly(more(3.0, 0.05))),
    (WRONG, "dry friction of 0.003 more", exactly(more(0.0, 0.003))),
    (SLIGHTLY, "strength times 1.001", exactly(changed(0, 1.001))),
    (SLIGHTLY, "strength times 0.9999", exactly(changed(0, 0.9999))),
    (SLIGHTLY, "exponent + 0.001", exactly(changed(-1, 1.0, 0.001))),
    *((NOISE, f"noise of {s:g}", spoiled(lambda rng, x, s=s: x + s * rng.standard_normal(len(x))))
      for s in (1e-2, 1e-4, 1e-7)),
    *((ROUNDED, f"{d} decimals", spoiled(lambda rng, x, d=d: np.round(x, d))) for d in (3, 6)),
]  # fmt: skip
