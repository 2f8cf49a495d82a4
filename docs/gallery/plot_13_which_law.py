"""
Which law is it?  Q against amplitude
=====================================

Measure the decrement at several amplitudes.  On a doubly logarithmic plot the slope is :math:`\\alpha - 1`: falling for
dry friction, flat for a viscous damper, rising for air.  This needs no fit and no model of the start.
"""

import matplotlib.pyplot as plt
import numpy as np

import asymptotics as asy

amplitudes = np.geomspace(0.02, 0.2, 9)
figure, axes = plt.subplots()
slopes = {}
for alpha, b in (("0", "0.05"), ("1/2", "0.06"), ("1", "0.1"), ("3/2", "0.2"), ("2", "0.5")):
    equations = asy.expand(asy.Oscillator({alpha: b}, mass="3/2", stiffness=30, x0="1/5"), order=4)
    Q = [equations.observables(a).Q.value for a in amplitudes]
    axes.loglog(amplitudes, Q, "o-", markersize=3, label=rf"$\alpha = {alpha}$")
    slopes[alpha] = -np.polyfit(np.log(amplitudes[:4]), np.log(Q[:4]), 1)[0] + 1
axes.set(xlabel="amplitude (m)", ylabel="Q")
axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1), ncols=5, fontsize=8)

# %%
# The exponents read off the slopes at small amplitude:

print({a: round(float(s), 2) for a, s in slopes.items()})
assert abs(slopes["2"] - 2) < 0.1 and abs(slopes["1"] - 1) < 0.01
