"""
Does the spring show in the decrements?
=======================================

It does, at first order: the same drag on a softening, a linear and a hardening spring gives different decrements at the
same amplitude, because the energy that an amplitude stands for is different.  Times tell the spring, decrements alone
cannot: a loss that depends on the position could imitate it.
"""

import matplotlib.pyplot as plt
import numpy as np

import asymptotics as asy

amplitudes = np.linspace(0.05, 1.0, 20).round(3)
figure, (left, right) = plt.subplots(1, 2, figsize=(7.6, 3.6))
slope = {}
for name, spring in (("softening", "-1/10"), ("linear", "0"), ("hardening", "1/10")):
    equations = asy.expand({2: "1/20"}, order=6, spring={3: spring})
    seen = [equations.observables(str(a)) for a in amplitudes]
    relative = np.array([s.decrement.value for s in seen]) / amplitudes
    left.plot(amplitudes, relative, label=name)
    right.plot(amplitudes, [s.half_period.value for s in seen], label=name)
    slope[name] = relative[-1]
left.set(xlabel="amplitude", ylabel="decrement / amplitude")
right.set(xlabel="amplitude", ylabel="half period")
left.legend()

# %%
# The cross term, in closed form:

print(asy.half_swing([2], spring={3: 1}, order=2).U["1,1"].exact)
assert slope["hardening"] < slope["linear"] < slope["softening"]
