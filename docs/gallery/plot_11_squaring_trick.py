"""
Does replacing the mean of a root by the root of a mean matter?
===============================================================

Lelas' squaring trick puts :math:`2^{-(\\alpha+1)/2}` in the place of :math:`M_{\\alpha+1}`.  The ratio does not depend
on the strength: the error of the rate stays, however weak the damping.
"""

import matplotlib.pyplot as plt
import numpy as np

import asymptotics as asy

ratio = []
for n in range(41):
    alpha = f"{n}/10"
    mean = float(asy.envelope({alpha: 1}).kappas(digits=15)[0])
    ratio.append(2 ** (-(n / 10 + 1) / 2) / mean)
x = np.arange(41) / 10
figure, axes = plt.subplots()
axes.plot(x, ratio)
axes.axhline(1, color="#6b7280", linewidth=0.8)
axes.set(xlabel=r"$\alpha$", ylabel="rate by the trick / true rate")

# %%
# Exact at :math:`\alpha = 1` only; 11 % too much damping for dry friction, 17 % too little for air.

print(f"{ratio[0]:.4f} {ratio[10]:.4f} {ratio[20]:.4f}")
assert np.isclose(ratio[10], 1) and np.isclose(ratio[0], np.sqrt(2) * np.pi / 4)
