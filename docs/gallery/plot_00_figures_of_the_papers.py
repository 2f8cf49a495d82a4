"""
How do I draw a figure of each paper?
=====================================

One figure of Lancaster 2020, one of Lelas 2024 and one of Smith 2012, each in a dozen lines that a lecture can change:
the exact motion with every digit proved, and beside it what the paper draws.  This page is a notebook too: its link is
at the end.
"""

import matplotlib.pyplot as plt
import numpy as np

import asymptotics as asy

# %%
# **Lancaster 2020, Fig. 2**: :math:`\alpha = 3/2` and :math:`\kappa \approx 0.19`, the motion and
# :math:`A(t)\cos\omega_0 t` with the averaged amplitude (13).  Time is in units of :math:`1/\omega_0`,
# :math:`x` in those of :math:`x_0`; :math:`\varepsilon = \kappa/M_{5/2}`.

epsilon = f"{0.19 / float(asy.moment('5/2')):.6f}"
law = asy.Law({"3/2": epsilon})
tau = np.linspace(0, 30, 601)
truth = asy.reference(law).sample(tau).x
amplitude = asy.envelope(law).amplitudes(tau)
figure, axes = plt.subplots()
axes.plot(tau, truth, label="the motion")
axes.plot(tau, amplitude * np.cos(tau), "--", label=r"$A(t)\,\cos\,\omega_0t$, (13)")
axes.plot(tau, amplitude, color="#6b7280", linewidth=0.8)
axes.set(xlabel=r"$\omega_0 t$", ylabel="$x/x_0$")
axes.legend(loc="lower right")

turns = asy.turning_points(law, 10, times=True).points
off = max(abs(abs(float(p.x)) / asy.envelope(law).amplitudes(np.array([float(p.tau)]))[0] - 1) for p in turns)
print(f"the amplitude is right to {off:.1e}, what is off is the phase")
assert off < 3e-4

# %%
# **Lelas 2024, Fig. 1(a)**: sliding friction, :math:`\mu = 0.01`.  The exact motion stops beside the middle; the
# averaged amplitude (48) and that of the squaring trick (47) both end in it, the trick too early.

weight = 1.5 * 9.81
block = asy.Oscillator({0: f"{0.01 * weight:.5f}"}, mass="3/2", stiffness=30, x0="1/5")
t = np.linspace(0, 16, 801)
exact = asy.reference(block)
figure, axes = plt.subplots()
axes.plot(t, exact.sample(t).x, "k--", linewidth=1, label="exact, (49)")
for averaging, name in (("squaring", "squaring trick, (47)"), ("mean", "averaged, (48)")):
    envelope = asy.envelope(block, averaging=averaging)
    end = float(envelope.extinction_time(digits=12))
    inside = t[t < end]
    axes.plot(inside, envelope.amplitudes(inside) * np.cos(np.sqrt(20) * inside), label=f"{name}: until {end:.1f} s")
axes.set(xlabel="t (s)", ylabel="x (m)")
axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1), ncols=3, fontsize=8)

events = exact.events(until=20)
print(f"it stops after {events.stop:.2f} s, {exact.at(20, digits=6).x} m from the middle")
assert round(events.stop, 2) == 14.05  # as the paper reads it from its graph

# %%
# **Smith 2012, Fig. 3**: three full cycles in phase space for :math:`\alpha = 2`, :math:`u = \gamma x` from 1,
# :math:`w = \gamma v/\omega`.  The turning points are those of Table I.

air = asy.Law({2: 1})
points = asy.turning_points(air, 7, times=True).points
tau = np.linspace(0, float(points[6].tau), 901)
samples = asy.reference(air).sample(tau)
figure, axes = plt.subplots(figsize=(6.4, 4.2))
axes.plot(samples.x, samples.v)
axes.plot([float(p.x) for p in points], np.zeros(7), "o", markersize=4, label="turning points, Table I")
axes.set(xlabel="u", ylabel="w", aspect="equal")
axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1), fontsize=8)

print("u_1 ... u_5:", *(f"{float(p.x):.6f}" for p in points[1:6]))
assert [round(float(p.x), 6) for p in points[1:6]] == [-0.41072, 0.263568, -0.194566, 0.154318, -0.127908]
