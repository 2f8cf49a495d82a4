"""The motion of an oscillator that dry friction stops, by an integrator of its own: half-swing by half-swing."""

import numpy as np
from scipy.integrate import solve_ivp


def stopped(t, start, omega, losses, restoring=lambda x: x):
    """(x, v) of x'' + omega^2 restoring(x) + sum b |v|^a sign(v) = 0 from rest at ``start``; ``losses``: {a: b}."""
    x, begun, found = start, 0.0, np.zeros((2, len(t)))
    while omega**2 * abs(restoring(x)) > losses[0]:
        side = -np.sign(x)

        def moves(_, y, side=side):
            lost = sum(b * side * abs(y[1]) ** a for a, b in losses.items())
            return [y[1], -(omega**2) * restoring(y[0]) - lost]

        def turns(s, y, side=side, begun=begun):
            return y[1] * side if s > begun + 1e-9 else 1.0

        turns.terminal, turns.direction = True, -1
        half = solve_ivp(
            moves, (begun, begun + 9 / omega), [x, 0], method="DOP853", rtol=1e-10, atol=1e-12, events=turns,
            dense_output=True,
        )  # fmt: skip
        now = (t >= begun) & (t <= half.t[-1])
        found[:, now] = half.sol(t[now])
        begun, x = half.t[-1], half.y[0, -1]
    found[0, t > begun] = x
    return found[0], found[1]
