"""The worked examples of `compare`: what three common ways of solving the equation write into a file.

X'' + X + epsilon X'|X'|^(alpha-1) = 0, X(0) = 1, X'(0) = 0, in doubles.
"""

import numpy as np
from scipy.integrate import solve_ivp
from scipy.special import gamma


def motion(alpha, epsilon):
    def rhs(_, state):
        x, v = state
        return [v, -x - epsilon * v * abs(v) ** (alpha - 1)]

    return rhs


def dop853_naive(alpha, epsilon, end, points, rtol=1e-13):
    """SciPy's DOP853 on the equation as it is written: the right-hand side is not smooth where v = 0.

    Its error control notices, and pays with steps: three times as many as for alpha = 1.
    """
    tau = np.linspace(0, end, points)
    found = solve_ivp(motion(alpha, epsilon), (0, end), [1.0, 0.0], "DOP853", tau, rtol=rtol, atol=1e-15)
    return tau, found.y[0]


def dop853_in_steps(alpha, epsilon, end, points, step=0.2):
    """The same with a fixed step, as for a table at equal times: (tau, x, v)."""
    tau = np.linspace(0, end, points)
    found = solve_ivp(motion(alpha, epsilon), (0, end), [1.0, 0.0], "DOP853", tau, rtol=0.1, atol=1.0,
                      first_step=step, max_step=step)  # fmt: skip
    return tau, found.y[0], found.y[1]


def dop853_by_half_swings(alpha, epsilon, end, points, rtol=1e-13):
    """The same method with the sign of v fixed on each half-swing, stopped and restarted where v = 0."""
    grid, tau, state, sign, found = np.linspace(0, end, points), 0.0, [1.0, 0.0], -1.0, []
    while len(found) < points:

        def rhs(_, y, sign=sign):
            return [y[1], -y[0] - sign * epsilon * max(sign * y[1], 0.0) ** alpha]

        def turns(t, y, tau=tau, sign=sign):
            return sign if t <= tau + 0.1 else y[1]

        turns.terminal = True
        times = grid[(grid >= tau) & (grid <= tau + 6)]
        swing = solve_ivp(rhs, (tau, tau + 6), state, "DOP853", times, events=turns, rtol=rtol, atol=1e-15)
        found += list(swing.y[0])
        tau, state, sign = swing.t_events[0][0], [swing.y_events[0][0][0], 0.0], -sign
    return grid, np.array(found[:points])


def rk4(alpha, epsilon, end, steps):
    """The classical Runge-Kutta method with a fixed step."""
    rhs, h = motion(alpha, epsilon), end / steps
    state, found = np.array([1.0, 0.0]), [1.0]
    for _ in range(steps):
        k1 = np.array(rhs(0, state))
        k2 = np.array(rhs(0, state + h / 2 * k1))
        k3 = np.array(rhs(0, state + h / 2 * k2))
        k4 = np.array(rhs(0, state + h * k3))
        state = state + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        found.append(state[0])
    return np.linspace(0, end, steps + 1), np.array(found)


def first_order(alpha, epsilon, end, points):
    """Lancaster's (13): A(tau) cos(tau) with the averaged law of decay, alpha != 1."""
    p1 = gamma(alpha / 2 + 1) / (np.sqrt(np.pi) * gamma(alpha / 2 + 1.5))
    tau = np.linspace(0, end, points)
    return tau, (1 + (alpha - 1) * p1 * epsilon * tau) ** (-1 / (alpha - 1)) * np.cos(tau)


def write(path, tau, x, *v):
    """tau, x and perhaps v, in full."""
    rows = [",".join(repr(float(cell)) for cell in row) for row in zip(tau, x, *v)]
    path.write_text("\n".join(["tau,x,v" if v else "tau,x", *rows]) + "\n")
