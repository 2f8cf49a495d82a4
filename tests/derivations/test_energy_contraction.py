"""dV(q) = dV(p) exp(-int dh/dv dt) along half-swings that DOP853 integrates, with the variation of the start."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

LAWS = {  # V', V'' and the losses (strength, m, alpha)
    "pendulum, 3/2": (np.sin, np.cos, [(0.3, 0, 1.5)]),
    "pendulum, quadratic and |x| x'": (np.sin, np.cos, [(0.2, 0, 2.0), (0.3, 1, 1.0)]),
    "x + x|x|, cubic": (lambda x: x + x * abs(x), lambda x: 1 + 2 * abs(x), [(0.5, 0, 3.0)]),
    "softening, x^2 x'": (lambda x: x - x**3 / 5, lambda x: 1 - 3 * x**2 / 5, [(0.8, 2, 1.0)]),
}


def half_swing(force, slope, losses, p):
    """q, dq/dp and J = int h_v dt: the variation (y, y') runs beside the motion."""

    def field(_, z):
        x, v, y, w, _ = z
        h = sum(e * abs(x) ** m * v * abs(v) ** (a - 1) for e, m, a in losses if v)
        h_v = sum(e * abs(x) ** m * a * abs(v) ** (a - 1) for e, m, a in losses if v or a > 1)
        h_x = sum(e * m * abs(x) ** (m - 1) * np.sign(x) * v * abs(v) ** (a - 1) for e, m, a in losses if v and m)
        return [v, -force(x) - h, w, -(slope(x) + h_x) * y - h_v * w, h_v]

    def turns(_, z):
        return z[1]

    turns.terminal, turns.direction = True, 1
    start = [p, -1e-14, 1.0, 0.0, 0.0]
    run = solve_ivp(field, (0, 40), start, events=turns, method="DOP853", rtol=1e-11, atol=1e-13, max_step=0.05)
    return -run.y[0, -1], -run.y[2, -1], run.y[4, -1]


@pytest.mark.parametrize("name", LAWS)
def test_energies_contract_by_the_loss_alone(name):
    force, slope, losses = LAWS[name]
    p = 1.4
    q, dq_dp, J = half_swing(force, slope, losses, p)
    ratio = force(q) * dq_dp / force(p)
    assert ratio == pytest.approx(np.exp(-J), rel=1e-7)
    assert 0 < ratio < 1
    assert abs(q * dq_dp / p - np.exp(-J)) > 1e-3  # near miss: the energy of a linear spring
