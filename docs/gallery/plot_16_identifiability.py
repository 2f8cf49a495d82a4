"""
How many swings does it take to see linear loss beside quadratic?
=================================================================

Before anything is measured: the Fisher information of the half-swing map gives the smallest standard errors that N
turning points with noise sigma allow, and so the number of swings after which (1, 2) can be told from 2 alone.
"""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LogNorm
from matplotlib.ticker import NullFormatter

from asymptotics.decays.identification.identifiability import swings_needed

shares, noises = np.geomspace(0.02, 0.5, 9), np.geomspace(1e-4, 1e-2, 9)
total = 0.03  # of both first decrements: (pi/2) epsilon_1 + (4/3) epsilon_2
needed = np.full((len(noises), len(shares)), np.nan)
for i, noise in enumerate(noises):
    for j, share in enumerate(shares):
        strengths = [share * total * 2 / np.pi, (1 - share) * total * 3 / 4]
        needed[i, j] = swings_needed("1+2", strengths, term=0, noise=noise) or np.nan

figure, axes = plt.subplots()
levels = [3, 5, 10, 20, 40, 80, 160, 320]
picture = axes.contourf(shares, noises, needed, levels=levels, norm=LogNorm(levels[0], levels[-1]))
axes.set(xscale="log", yscale="log")
axes.grid(visible=False)
axes.xaxis.set_minor_formatter(NullFormatter())
axes.set(xlabel="share of the linear term in the first decrement", ylabel="noise / first amplitude")
bar = figure.colorbar(picture, label="half-swings needed", ticks=levels)
bar.ax.set_yticklabels(levels)
bar.ax.minorticks_off()

# %%
# Less noise and a larger share both help, never the contrary:

assert (np.diff(needed, axis=0)[np.isfinite(np.diff(needed, axis=0))] >= 0).all()
assert (np.diff(needed, axis=1)[np.isfinite(np.diff(needed, axis=1))] <= 0).all()
example = swings_needed("1+2", [0.05 * total * 2 / np.pi, 0.95 * total * 3 / 4], term=0, noise=1e-3)
print(f"5 % linear loss, noise 1e-3: {example} half-swings")
