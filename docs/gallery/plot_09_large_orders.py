"""
How many orders are worth computing?
====================================

The coefficients grow factorially: a map is not a flow, and no amplitude equation is exact.  The terms fall, reach a
smallest one, and grow; the smallest term is about the best accuracy the expansion can have.
How fast they grow is a theorem (derivation ``large-orders``).
"""

import matplotlib.pyplot as plt

import asymptotics as asy

equations = asy.expand(2, order=40, exact=True)
sizes = {k: abs(float(c)) for k, c in equations.p.items()}
figure, axes = plt.subplots()
smallest = {}
for delta in (0.3, 0.5, 1.0):
    terms = {k: c * delta**k for k, c in sizes.items()}
    axes.semilogy(list(terms), list(terms.values()), "o-", markersize=3, label=rf"$\delta = {delta}$")
    smallest[delta] = min(terms, key=terms.get)
    axes.semilogy(smallest[delta], terms[smallest[delta]], "k*", markersize=10)
axes.set(xlabel="order k", ylabel=r"$|p_k|\,\delta^k$", ylim=(1e-16, 1e3))
axes.legend()

# %%
# The stars move to the left as the local strength grows.

print(smallest)
assert smallest[1.0] < smallest[0.5] < smallest[0.3]
