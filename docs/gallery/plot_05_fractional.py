"""
What does the exponent change?
==============================

Six laws that take the same fraction of the amplitude on the first swings, from dry friction to cubic damping.  Below
:math:`\\alpha = 1` the averaged amplitude ends at a finite time; above, it never does; at 1 it falls exponentially.
"""

import matplotlib.pyplot as plt
import numpy as np

import asymptotics as asy

tau = np.linspace(0, 120, 601)
figure, axes = plt.subplots()
for alpha in ("0", "1/2", "1", "3/2", "2", "3"):
    kappa_of_one = float(asy.envelope({alpha: 1}).kappas(digits=15)[0])
    epsilon = f"{0.02 / kappa_of_one:.12f}"
    axes.plot(tau, asy.envelope({alpha: epsilon}).amplitudes(tau), label=rf"$\alpha = {alpha}$")
axes.set(xlabel=r"$\tau$", ylabel="A", ylim=(0, 1))
axes.legend()

# %%
# :math:`\kappa = M_{\alpha+1}\varepsilon` is the rate that all of them share at the start.

end = asy.envelope({"1/2": "0.1"}).extinction_time(digits=10)
print("for alpha = 1/2, epsilon = 0.1 the averaged law ends at tau =", end)
assert np.isclose(float(end), 2 / float(asy.moment("3/2")) / 0.1)
