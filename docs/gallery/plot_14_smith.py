"""
What are Smith's sums?
======================

Smith's constants of the motion for :math:`\\alpha = 2` contain sums :math:`G_i(z) = \\sum_n C_i^n z^n`.  The paper
recognises two of them; all are rational functions and an arctangent.  Here, against their power series.
"""

import matplotlib.pyplot as plt
import numpy as np
import sympy

import asymptotics as asy

z = np.linspace(0.02, 0.9, 45)
figure, axes = plt.subplots()
worst = 0.0
for i in (0, 1, 2, 3):
    closed = sympy.lambdify(sympy.Symbol("z"), asy.G(i).in_z(), "numpy")
    partial = sum(float(asy.C(n, i)) * z**n for n in range(i + 1, 120) if (n - i) % 2)
    (line,) = axes.plot(z, closed(z), label=rf"$G_{i}$")
    axes.plot(z[::4], partial[::4], ".", color=line.get_color())
    worst = max(worst, np.abs(closed(z) - partial)[z < 0.8].max())
axes.set(xlabel="z", ylabel=r"$G_i(z)$; dots: 120 terms of the series")
axes.legend()

# %%
# The closed form of the first one that the paper calls unrecognisable:

print(asy.G(2).in_z())
assert worst < 1e-8
