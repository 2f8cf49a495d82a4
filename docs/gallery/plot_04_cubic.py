"""
By how much does a cubic damper delay the oscillation, for ever?
================================================================

For :math:`\\alpha > 1` the damping dies out with the amplitude, so the phase lags by a *finite* amount in all:
for :math:`\\alpha = 3` it is :math:`15\\varepsilon/64`, the same in every gauge.  First order knows nothing of it.
"""

import matplotlib.pyplot as plt
import numpy as np
from scipy.integrate import solve_ivp

import asymptotics as asy

figure, axes = plt.subplots()
tau = np.geomspace(1, 1e5, 200)
for epsilon in ("0.05", "0.1", "0.2"):
    equations = asy.expand({3: epsilon}, order=4)

    def lag(t, y, rates=equations):  # the phase less the time
        dA, dpsi = rates(y[0])
        return [dA, dpsi - 1]

    slow = solve_ivp(lag, (0, 1e5), [1.0, 0.0], t_eval=tau, rtol=1e-10)
    (line,) = axes.semilogx(tau, slow.y[1], label=rf"$\varepsilon = {epsilon}$")
    axes.axhline(-15 / 64 * float(epsilon), color=line.get_color(), linestyle=":")
axes.set(xlabel=r"$\tau$", ylabel=r"phase $\psi - \tau$ (rad)")
axes.legend()

# %%
# The dotted lines are :math:`-15\varepsilon/64`.

final = slow.y[1][-1] / -0.2
print(f"{final:.5f} against {15 / 64:.5f}")
assert abs(final - 15 / 64) < 2e-3
