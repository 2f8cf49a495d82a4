"""
Why do published second orders disagree?
========================================

Because an amplitude is only defined up to a choice.  For cubic damping :math:`\\Omega_2` is :math:`-45/256`,
:math:`-27/256` or :math:`+9/256`: all three are right, each in its own *gauge*.  The amplitudes differ; the motion does
not.
"""

import matplotlib.pyplot as plt
import numpy as np

import asymptotics as asy

gauges = ("turning-point", "averaging", "no-first-harmonic")
law = {3: "1/2"}
tau = np.linspace(0, 12, 601)
figure, (above, below) = plt.subplots(2, 1, sharex=True, figsize=(6.4, 5))
for gauge in gauges:
    samples = asy.motion(law, order=5, gauge=gauge).sample(tau)
    above.plot(tau, samples.amplitude, label=f"A, {gauge}")
    below.plot(tau, samples.x, label=gauge)
    print(f"{gauge:18}  Omega_2 = {asy.expand(3, order=2, gauge=gauge).Omega[2].exact}")
above.legend()
above.set(ylabel="slow amplitude")
below.set(xlabel=r"$\tau$", ylabel="X (three curves)")

# %%
# What can be observed agrees, within the estimated error of the truncation:

one, other = (asy.expand(law, order=6, gauge=g) for g in gauges[::2])
print(one.compare(other))
assert one.compare(other).agree and one != other
