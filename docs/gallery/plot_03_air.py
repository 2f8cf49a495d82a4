"""
How does a mass in air lose its amplitude?
==========================================

With quadratic drag the amplitude falls like :math:`1/(1 + 4\\varepsilon\\tau/3\\pi)`: fast at first, then ever more
slowly.  The turning points come from Lambert's function and are certified; the averaged law is a formula.
"""

import matplotlib.pyplot as plt
import numpy as np

import asymptotics as asy

air = asy.Oscillator({2: "1/2"}, mass=1, stiffness=9, x0="2/5")
points = asy.turning_points(air, 40, digits=15, times=True).points
slow = asy.envelope(air)

t = np.linspace(0, 40, 2001)
figure, axes = plt.subplots()
axes.plot(t, asy.motion(air, order=3).sample(t).x, linewidth=0.8, color="#9db4dd")
axes.plot(t, slow.amplitudes(t), color="#c2410c", label="averaged law")
axes.plot([float(p.t) for p in points], [abs(float(p.x)) for p in points], "k.", markersize=4, label="turning points")
axes.set(xlabel="t (s)", ylabel="x (m)", xlim=(0, 40))
axes.legend()

# %%
# The formula, and how far the averaged law is from the truth after forty half-swings:

print(slow.formula.expression)
gap = abs(float(points[-1].x)) / slow.amplitudes(float(points[-1].t)) - 1
print(f"{gap:.2e}")
assert 0 < abs(gap) < 2e-3
