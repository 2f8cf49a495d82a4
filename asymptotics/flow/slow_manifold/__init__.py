"""Motions that follow a slow manifold, enclosed between two barriers (fences).

They are the creep to rest of exponents below 1 and, for one exponent above 1, a stiff motion that slides (``slide``).
Derivations ``slow-curve`` and ``settling``.
"""
