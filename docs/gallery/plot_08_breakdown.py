"""
Where does the expansion fail?
==============================

The error of order N falls like :math:`\\varepsilon^N` while :math:`\\varepsilon` is small.  Near 1 more orders do not
help: the series diverges.  The truth is a high-precision reference.
"""

import matplotlib.pyplot as plt
import numpy as np

import asymptotics as asy

strengths = ["0.01", "0.02", "0.05", "0.1", "0.2", "0.5", "1", "2"]
t = np.linspace(0, 12, 61)
figure, axes = plt.subplots()
errors = {}
for order in (1, 3, 5):
    worst = []
    for e in strengths:
        law = {"3/2": e}
        worst.append(np.abs(asy.motion(law, order=order).sample(t).x - asy.reference(law).sample(t).x).max())
    errors[order] = worst
    axes.loglog([float(e) for e in strengths], worst, "o-", label=f"order {order}")
axes.set(xlabel=r"$\varepsilon$ ($\alpha = 3/2$)", ylabel="largest error of X")
axes.legend()

# %%
# Measured slopes between the two smallest strengths:

slopes = {n: np.log(e[1] / e[0]) / np.log(2) for n, e in errors.items()}
print({n: round(float(s), 2) for n, s in slopes.items()})
assert all(abs(s - n) < 0.3 for n, s in slopes.items())
