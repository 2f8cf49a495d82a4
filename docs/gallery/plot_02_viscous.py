"""
What does linear damping do to the frequency?
=============================================

For :math:`\\alpha = 1` the local strength is the same at all amplitudes, the expansion converges, and its sum is known:
:math:`\\dot\\psi = \\sqrt{1 - \\varepsilon^2/4}`.  At :math:`\\varepsilon = 2` the oscillation ends, and the series
notices: its radius of convergence is 2.
"""

import matplotlib.pyplot as plt
import numpy as np

import asymptotics as asy

epsilon = np.linspace(0, 2, 201)
exact = np.sqrt(1 - epsilon**2 / 4)
figure, axes = plt.subplots()
axes.plot(epsilon, exact, color="black", label="exact")
for order in (2, 4, 8, 16):
    equations = asy.expand(1, order=order)
    axes.plot(epsilon, [equations(1.0, epsilon=e)[1] for e in epsilon], label=f"order {order}", linewidth=1)
axes.set(xlabel=r"$\varepsilon$", ylabel=r"$d\psi/d\tau$", ylim=(0, 1.02))
axes.legend()

# %%
# Every coefficient is a rational number:

series = asy.expand(1, order=8).Omega
print({k: c.exact for k, c in series.items()})
assert series[2].exact == "-1/8" and series[4].exact == "-1/128"
