"""
What does a resonance tell of the damping?
==========================================

Under a harmonic force there is one response, whatever the law: the amplitude at the peak and the width of the peak
depend on the force as the exponent says.  The Q of the width is that of the decay for viscous damping alone.
"""

import matplotlib.pyplot as plt

import asymptotics as asy

figure, axes = plt.subplots(figsize=(7.2, 4.2))
for alpha in ("1/2", "1", "2", "3"):
    asy.response({alpha: "1/5"}, "1/2", 1, digits=6).plot(axes, label=f"alpha = {alpha}")

# %%
# Four laws of one strength under one force.  The response is certified for each; the amplitude at resonance
# grows with the force to the power 1/alpha:

ratios = []
for alpha in ("1", "2", "3"):
    weak, strong = (asy.response({alpha: "1/5"}, force, 1, digits=9) for force in ("1/10", "1/5"))
    ratios.append(float(strong.amplitude) / float(weak.amplitude))
    print(alpha, round(ratios[-1], 3), strong.first_order.resonance["Q_decay"], strong.first_order.resonance["Q_width"])
assert all(abs(ratio - 2 ** (1 / alpha)) < 0.01 * ratio for ratio, alpha in zip(ratios, (1, 2, 3)))
