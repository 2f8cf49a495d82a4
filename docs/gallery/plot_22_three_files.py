"""
Three files to try: which law?
==============================

Three records come with the program (``asymptotics identify --example phone``, ``ship``, ``ringdown``; what they are
stands in ``asymptotics/decays/identification/data``): a phone on a pendulum, the roll of a tanker model, the level of
a resonator after its drive has stopped.  Nothing but the file is said: the notes tell what was read.
"""

import matplotlib.pyplot as plt
import numpy as np

import asymptotics as asy
from asymptotics.decays.identification.examples import example

phone = asy.identify(example("phone"), laws=["1", "2", "1+2", "1+pendulum", "1+2+pendulum"])
print(phone.notes[0])
print(phone.verdict.text)
print(phone.table(3))

# %%
# The axis that swings was found among three.  The file was computed, so that the answer can be judged: both losses, and
# the sine in the place of x.

law = phone.law("1+2+pendulum").law
assert law.verdict == "consistent" and law.epsilon[0].contains(0.012) and law.epsilon[1].contains(0.11)

# %%
# Without any law the envelope has Q and the period at each amplitude: the backbone of a pendulum.

for row in phone.to_dict()["envelope"]["backbone"]:
    print(row["amplitude"], "rad:", row["omega"]["estimate"], "rad/s")

# %%
# A ring-down in dBm is an envelope; its frequency stands above the numbers.  One exponential would be a straight line.

ringdown = asy.identify(example("ringdown"), laws=["1", "2", "1+2", "1+3"])
print(ringdown.verdict.text)
assert ringdown.law("1+3").law.verdict == "consistent" and ringdown.law("1").law.verdict == "refuted"
seen = ringdown.runs[0]
time, level = seen.n * seen.spacing, 20 * np.log10(np.abs(seen.x))
figure, axes = plt.subplots()
axes.plot(time, level, ".", markersize=2, label="measured")
slope = np.polyfit(time[-200:], level[-200:], 1)
axes.plot(time, np.polyval(slope, time), label="one exponential, of the end")
axes.set(xlabel="time (s)", ylabel="level (dBm)")
axes.legend()

# %%
# The tanker's roll is in a page of its own; its period at both ends of the record tells that its spring is no line.

ship = asy.identify(example("ship"), laws=["1", "2"], springs=["3"])
first, *_, last = ship.to_dict()["envelope"]["backbone"]
print(first["amplitude"], first["period"], last["amplitude"], last["period"])
