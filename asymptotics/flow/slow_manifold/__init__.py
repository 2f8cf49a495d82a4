"""Creep: motions that come to rest along the slow manifold (exponents below 1), enclosed between two barriers.

Derivations ``slow-curve`` and ``onset``.
"""
