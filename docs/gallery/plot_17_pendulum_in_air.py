"""
How does a pendulum in air lose its amplitude?
==============================================

The usual experiment: quadratic drag *and* a spring that is not linear.  The decrement and the half period of one swing,
by the expansion, against the exact turning points (an elementary equation at :math:`\\alpha = 2`) and the elliptic
integral.
"""

import matplotlib.pyplot as plt
import numpy as np
from scipy.optimize import brentq
from scipy.special import ellipk

import asymptotics as asy

DRAG = 0.05


def exact_loss(a):
    """ln(a/q): (cos x + 2 b sin x) e^(-2 b x) is equal at the turning points x = a and x = -q."""
    level = (np.cos(a) + 2 * DRAG * np.sin(a)) * np.exp(-2 * DRAG * a)
    q = brentq(lambda q: (np.cos(q) - 2 * DRAG * np.sin(q)) * np.exp(2 * DRAG * q) - level, a / 2, a, xtol=1e-14)
    return np.log(a / q)


amplitudes = np.linspace(0.1, 2.6, 26)
figure, (left, right) = plt.subplots(1, 2, figsize=(7.6, 3.6))
left.plot(np.degrees(amplitudes), [exact_loss(a) for a in amplitudes], "k.", label="exact")
right.plot(np.degrees(amplitudes), 2 * ellipk(np.sin(amplitudes / 2) ** 2), "k.", label="no drag: 2 K(sin²(a/2))")
for order in (1, 2, 6):
    equations = asy.expand({2: str(DRAG)}, order=order, spring="pendulum")
    seen = [equations.observables(float(a)) for a in amplitudes.round(6)]
    left.plot(np.degrees(amplitudes), [-np.log(s.amplitude_ratio.value) for s in seen], label=f"order {order}")
    right.plot(np.degrees(amplitudes), [s.half_period.value for s in seen], label=f"order {order}")
left.set(xlabel="amplitude (degrees)", ylabel=r"$\ln(A_n/A_{n+1})$")
right.set(xlabel="amplitude (degrees)", ylabel="half period")
left.legend()
right.legend()

# %%
# At 60 degrees order 6 is right to four digits:

at = asy.expand({2: str(DRAG)}, order=6, spring="pendulum").observables("1.0472")
print(f"{-np.log(at.amplitude_ratio.value):.6f} exact {exact_loss(1.0472):.6f}")
assert abs(-np.log(at.amplitude_ratio.value) - exact_loss(1.0472)) < 1e-4
