"""
How large is the constant in front of the divergence?
=====================================================

Half-swings can be counted by where an orbit goes, or by where it comes from.  The two counts differ by a wave that is
exponentially small in 1/delta.  Its size is the Stokes constant of the law: certified, and zero for some exponents.
"""

from fractions import Fraction

import matplotlib.pyplot as plt
import numpy as np

import asymptotics as asy

# %%
# Quadratic drag in the complex plane of the local strength.  Each half-swing is a step from delta to F(delta).  On the
# right petal orbits run into 0, on the left one they come from 0; by the reversal -F(-F(delta)) = delta one is the
# mirror image of the other.  Above and below 0 the petals overlap: there an orbit has both counts.

figure, plane = plt.subplots(figsize=(5.4, 4.4))
log_ratio = {int(k): float(c) for k, c in asy.half_swing(2, order=12).log_ratio.items()}
z = np.concatenate([-3 + 1j * np.array([-9, -7, -5, -4, -3, 3, 4, 5, 7, 9]), [2.5 + 1.5j, 2.5, 2.5 - 1.5j]])
orbits = [0.75 / z]  # z = c/delta: a half-swing is nearly z + 1
for _ in range(60):
    orbits.append(orbits[-1] * np.exp(sum(c * orbits[-1] ** k for k, c in log_ratio.items())))
to, back = np.array(orbits), -np.conj(orbits)
for paths, colour, name in ((to, "C0", "right petal, to 0"), (back, "C1", "left petal, from 0")):
    lines = plane.plot(paths.real, paths.imag, ".-", color=colour, linewidth=0.6, markersize=3)
    lines[0].set_label(name)
plane.plot(0, 0, "k.")
plane.set(xlabel=r"Re $\delta$", ylabel=r"Im $\delta$", aspect="equal")
plane.legend(loc="lower center", bbox_to_anchor=(0.5, 1), ncols=2, fontsize="small")

# %%
# The constants at forty exponents, to four digits, evenly in 1/(alpha - 1) near 1: there they beat with period 1, and
# the zeros of c_1 accumulate.  Three on either side of 1 are proved, the outermost are the diamonds.

figure, curve = plt.subplots()
below = [f"{k}/10" for k in range(1, 6)] + [str(Fraction(k - 4, k)) for k in range(9, 20)]
above = [str(Fraction(k + 4, k)) for k in range(20, 3, -1)] + ["9/4", "5/2", "3", "7/2", "4", "5", "6"]
found = {text: asy.stokes(text, digits=4) for text in (*below, *above)}
for name, colour in (("c", "C0"), ("d", "C3")):
    for side in (below, above):
        exponents = [float(Fraction(text)) for text in side]
        values = [float(getattr(found[text], name)(1)) for text in side]
        curve.plot(exponents, values, ".-", color=colour, linewidth=0.7, label=f"${name}_1$" if side is above else None)
curve.axvspan(0.8, 1.2, color="0.9")
curve.axhline(0, color="0.5", linewidth=0.6)
curve.plot([0.543614812520, 2.162839771406], [0, 0], "kD", markersize=5, label="$c_1 = 0$")
curve.set(xlabel=r"$\alpha$", ylabel="Stokes constant")
curve.legend(loc="lower center", bbox_to_anchor=(0.5, 1), ncols=3)

# %%
# A sign that changes between two certified values proves a zero in between.

print(found["2"])
assert all(constants.certified for constants in found.values())
assert float(found["2"].c(1)) < 0 < float(found["4"].c(1))
