"""
Viscous and quadratic together: which one acts when?
====================================================

At large amplitude the drag of the air wins, at small amplitude the viscous bearing.  Lancaster's (21) is the formula;
the change-over is where :math:`\\kappa_2 A = \\kappa_1`.
"""

import matplotlib.pyplot as plt
import numpy as np

import asymptotics as asy

both, viscous, air = (asy.envelope(law) for law in ({1: "1/50", 2: "1/5"}, {1: "1/50"}, {2: "1/5"}))
tau = np.linspace(0, 300, 601)
figure, axes = plt.subplots()
axes.semilogy(tau, both.amplitudes(tau), label="both")
axes.semilogy(tau, viscous.amplitudes(tau), "--", label="viscous alone", linewidth=1)
axes.semilogy(tau, air.amplitudes(tau), ":", label="air alone")
k1, k2 = (float(k) for k in both.kappas(digits=15))
axes.axhline(k1 / k2, color="#6b7280", linewidth=0.8)
axes.annotate(r"$\kappa_2 A = \kappa_1$", (220, k1 / k2 * 1.1))
axes.set(xlabel=r"$\tau$", ylabel="A")
axes.legend()

# %%
# The formula, from the library, and its value against the certified envelope:

print(both.formula.family, both.formula.expression)
closed = 1 / ((1 + k2 / k1) * np.exp(k1 * 50) - k2 / k1)
assert np.isclose(float(both.amplitude(50, digits=15)), closed, rtol=1e-13)
