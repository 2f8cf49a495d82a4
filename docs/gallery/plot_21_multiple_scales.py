"""
What does the multiple-scale solution know of the motion?
=========================================================

Air drag, :math:`\\varepsilon = 1/5`: the explicit solution of orders 1, 2 and 3, formulas in the slow time, beside the
certified motion.  Order 1 runs ahead: it knows no lag.  Below, each error with the bound that is proved for it at
every time at once.
"""

import matplotlib.pyplot as plt
import numpy as np

import asymptotics as asy

air = {2: "1/5"}
times = [k / 4 for k in range(241)]
truth = np.array([float(asy.reference(air).at(str(t), digits=12).x) for t in times])

figure, (above, below) = plt.subplots(2, 1, sharex=True, figsize=(7, 6))
above.plot(times, truth, color="black", linewidth=2.5, alpha=0.25, label="certified motion")
colors = {1: "#c2410c", 2: "#b8860b", 3: "#1d4ed8"}
ratios = {}
for order, color in colors.items():
    found = asy.solution(air, order=order)
    amplitude, _, x = found.sample(times)
    error, bound = np.abs(x - truth), float(found.proved().size)
    above.plot(times, x, color=color, linewidth=0.9, linestyle="--", label=f"order {order}")
    below.semilogy(times[1:], error[1:], color=color, linewidth=0.9, label=f"error of order {order}")
    below.axhline(bound, color=color, linestyle=":", label=f"proved for order {order}")
    ratios[order] = bound / error.max()
above.plot(times, amplitude, color="grey", linewidth=0.8)
above.set(ylabel=r"$x/x_0$")
below.set(xlabel=r"$\tau$", ylabel=r"$|x - x_N|$", ylim=(1e-9, 1))
above.legend(loc="upper right", ncols=2, fontsize=8)
below.legend(loc="lower right", ncols=3, fontsize=7)

# %%
# The formulas, and how many times larger than the largest error seen each bound is:

print(found)
print({order: round(float(ratio), 2) for order, ratio in ratios.items()})
assert all(1 <= ratio < 10 for ratio in ratios.values())
