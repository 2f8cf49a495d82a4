"""
How large is the limit cycle of van der Pol's oscillator?
=========================================================

:math:`x'' + x + \\mu(x^2 - 1)x' = 0` is one more law of this family: a loss that depends on the position, and one of
negative strength.  The amplitude equation has a zero near 2; here it is beside a numerical integration.
"""

import matplotlib.pyplot as plt
import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import asymptotics as asy


def by_expansion(mu, order):
    """Where dA/dtau = 0, for the strengths -mu and mu."""
    rates = asy.expand({1: f"-{mu}", (1, 2): f"{mu}"}, order=order).lambdify()
    return brentq(lambda A: rates(A)[0], 1.5, 2.5)


def by_integration(mu):
    """The largest displacement after the transient."""
    found = solve_ivp(lambda t, y: [y[1], -y[0] - mu * (y[0] ** 2 - 1) * y[1]], (0, 120), [2, 0], rtol=1e-9, atol=1e-9,
                      dense_output=True)  # fmt: skip
    return np.abs(found.sol(np.linspace(100, 120, 20001))[0]).max()


strengths = ["0.2", "0.4", "0.6", "0.8", "1"]
x = [float(mu) for mu in strengths]
truth = [by_integration(mu) for mu in x]
figure, axes = plt.subplots()
axes.plot(x, truth, "ko", label="integration")
for order in (3, 5, 9):
    axes.plot(x, [by_expansion(mu, order) for mu in strengths], label=f"order {order}")
axes.set(xlabel=r"$\mu$", ylabel="amplitude of the limit cycle")
axes.legend()

# %%
# The known series begins :math:`2 + \mu^2/96`.

print(f"{by_expansion('0.2', 9):.7f} {2 + 0.04 / 96:.7f} {truth[0]:.7f}")
assert abs(by_expansion("0.2", 9) - truth[0]) < 1e-6
