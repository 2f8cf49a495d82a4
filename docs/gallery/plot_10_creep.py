"""
Why does it neither stop nor swing?  Creep below α = 1
=======================================================

For :math:`0 < \\alpha < 1` the damping force wins at small speed.  After finitely many swings the mass creeps back like
a power of time: for :math:`\\alpha = 1/2` like :math:`\\varepsilon^2/\\tau`.  The averaged law
claims that it is at rest.
"""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import NullFormatter

import asymptotics as asy

law = {"1/2": "1/2"}
tau = np.linspace(0, 80, 801)
x = asy.reference(law).sample(tau).x
averaged = asy.motion(law, order=1).sample(tau)
figure, (left, right) = plt.subplots(1, 2, figsize=(7.6, 3.6))
left.plot(tau, x, label="reference")
left.plot(tau, averaged.x, "--", linewidth=1, label="averaged law, order 1")
left.set(xlabel=r"$\tau$", ylabel="X", xlim=(0, 25))
left.legend()
right.loglog(tau[60:], np.abs(x[60:]), label="|X|")
right.loglog(tau[60:], 0.25 / tau[60:], ":", label=r"$\varepsilon^2/\tau$")
right.set(xlabel=r"$\tau$")
right.legend()
right.xaxis.set_minor_formatter(NullFormatter())

# %%
# How the sequence of turning points ends:

points = asy.turning_points(law, 5, digits=10)
print(points.ended)
print(f"X tau at the end: {abs(x[-1]) * tau[-1]:.4f} (law: 0.25)")
assert points.ended is not None and abs(abs(x[-1]) * tau[-1] - 0.25) < 0.05
