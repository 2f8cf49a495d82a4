"""
Where is the billionth turning point?
=====================================

Iterating a map a billion times takes minutes and loses digits.  The Abel function :math:`\\Psi` of the map,
:math:`\\Psi(F(\\delta)) = \\Psi(\\delta) + 1`, jumps there at once, and the defect of its truncated series is bounded
by balls, so that every digit is proved although the series diverges.
"""

import matplotlib.pyplot as plt

import asymptotics as asy

starts = [10**k for k in range(13)]
found = [asy.turning_points({2: 1}, 1, start=n, digits=25) for n in starts]
values = [abs(float(f.points[0].x)) for f in found]
figure, axes = plt.subplots()
axes.loglog(starts, values, "o-", label="turning points, certified")
axes.loglog(starts, [3 / 4 / n for n in starts], ":", label=r"$3/(4\varepsilon n)$")
axes.set(xlabel="n", ylabel=r"$|X_n|$")
axes.legend()

# %%
# All of them certified, with the method that was used:

print(found[9].points[0].x, "|", found[9].method)
assert all(f.certified for f in found) and found[9].points[0].x.startswith("7.49999999339503")
