"""
How large is the limit cycle of van der Pol's oscillator?
=========================================================

:math:`x'' + x + \\mu(x^2 - 1)x' = 0` is one more law of this family: a loss that depends on the position, and one of
negative strength.  Amplitude and frequency are exact series in :math:`\\mu^2`; at a number :math:`\\mu` the fixed point
of the half-swing is certified.
"""

import matplotlib.pyplot as plt
import numpy as np

import asymptotics as asy

LAW = {1: -1, (1, 2): 1}
series = asy.limit_cycle(LAW, order=12)
mu = np.linspace(0, 1.6, 81)
figure, (left, right) = plt.subplots(1, 2, figsize=(7.6, 3.6))
for order in (2, 4, 8, 12):
    for axes, row in ((left, series.amplitude), (right, series.frequency)):
        values = sum(float(c) * mu ** int(k) for k, c in row.items() if int(k) <= order)
        axes.plot(mu, values, label=rf"through $\mu^{{{order}}}$")
numbers = ["0.4", "0.8", "1.2", "1.6"]
cycles = [asy.limit_cycle(LAW, order=2, mu=m, digits=15).at_mu for m in numbers]
left.plot([float(m) for m in numbers], [float(c.amplitude) for c in cycles], "k.", label="certified")
right.plot([float(m) for m in numbers], [float(c.frequency) for c in cycles], "k.", label="certified")
left.set(xlabel=r"$\mu$", ylabel="turning amplitude", ylim=(1.998, 2.03))
right.set(xlabel=r"$\mu$", ylabel="frequency")
left.legend(fontsize=8)

# %%
# The series are rational numbers:

print({k: c.exact for k, c in list(series.amplitude.items())[:4]})
by_series = sum(float(c) * 0.4 ** int(k) for k, c in series.amplitude.items())
assert abs(by_series - float(cycles[0].amplitude)) < 1e-9
