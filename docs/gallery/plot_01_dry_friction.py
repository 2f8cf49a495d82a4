"""
When does dry friction stop the mass, and where?
================================================

With Coulomb friction the amplitude falls by the same length at every turn, and the mass stops as soon as the spring is
weaker than the friction: in general *not* at the middle.  The motion is exact, every digit is proved.
"""

import matplotlib.pyplot as plt
import numpy as np

import asymptotics as asy

block = asy.Oscillator({0: "0.14715"}, mass="3/2", stiffness=30, x0="0.2")  # friction 0.14715 N
truth = asy.reference(block)
events = truth.events(until=20)

t = np.linspace(0, 16, 801)
figure, axes = plt.subplots()
axes.plot(t, truth.sample(t).x)
axes.plot(events.turning, events.turning_x, "o", markersize=4, label="turning points: a straight line")
axes.axhspan(-0.14715 / 30, 0.14715 / 30, color="#c2410c", alpha=0.25, label="|k x| < friction: it can stay")
axes.axvline(events.stop, color="#6b7280", linestyle=":", label=f"stops at {events.stop:.2f} s")
axes.set(xlabel="t (s)", ylabel="x (m)")
axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1), ncols=3, fontsize=8)

# %%
# Twenty half-swings of the time :math:`\pi\sqrt{m/k}` each, and then it lies 3.8 mm from the middle.

stopped = truth.at(20, digits=12)
print(stopped.x, "m, certified:", stopped.certified)
assert stopped.certified and stopped.x == "0.00380000000000"
assert np.isclose(events.stop, 20 * np.pi / np.sqrt(20))
