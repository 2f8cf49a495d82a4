"""
Which law damps a tanker's roll?
================================

The roll decay of a model of the tanker KVLCC2 (record and attribution in ``asymptotics/decays/identification/data``),
read from the raw samples: on the whole range no sum of laws reaches the noise, and the answer says so.  Between 5 and
10 degrees one exponent is found, and it is 2; the spring stiffens; the published regression has the same coefficient,
with a hundred times the interval.
"""

import matplotlib.pyplot as plt
import numpy as np

import asymptotics as asy
from asymptotics.decays.identification.examples import roll_decay

laws, springs = ["1", "2", "1+2", "1+3", "1+2+3", "free"], ["3"]
whole = asy.identify(roll_decay(), laws=laws, springs=springs)
print(whole.verdict.text)
assert whole.verdict.kind == "none fits"

# %%
# On a range of large amplitudes (in rad) one law is left, and it needs the spring:

large = asy.identify(roll_decay(), laws=laws, springs=springs, amplitudes=(np.radians(5), np.radians(11)))
print(large.verdict.text)
print(large.table(6))
exponent = large.law("free+s3").law.alpha
quadratic = large.law("2+s3").law.epsilon[0]
print(f"alpha = {exponent.estimate:.2f} [{exponent.low:.2f}, {exponent.high:.2f}]")
print(f"B2 = {quadratic.estimate:.3f} [{quadratic.low:.3f}, {quadratic.high:.3f}]; published: 0.13 [-1.2, 1.4]")
assert exponent.contains(2.0) and large.law("2").law.verdict == "refuted"

# %%
# The classical picture, decrement against mean amplitude, with the law of large amplitudes continued to small ones:

seen = whole.runs[0]
size = np.degrees(np.abs(seen.x))
mean, decrement = (size[1:] + size[:-1]) / 2, size[:-1] - size[1:]
figure, axes = plt.subplots()
axes.plot(mean, decrement, "o", markersize=3, label="measured, a half-swing each")
axes.plot(
    mean, np.degrees(4 / 3 * quadratic.estimate * np.radians(mean) ** 2), label="quadratic law from above 5 degrees"
)
axes.set(xlabel="mean amplitude (degrees)", ylabel="decrement (degrees)")
axes.legend()
