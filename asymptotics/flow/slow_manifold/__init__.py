"""Motions that follow a slow manifold (Fenichel 1979), enclosed between two barriers.

A barrier is a lower or an upper solution of dy/dw (Walter 1998, section 9), a fence in the words of Hubbard and West
(1991): motions cross it one way only, by a differential inequality.  No theorem on slow manifolds is used, as each pair
of barriers is checked in balls.

They are the creep to rest of exponents below 1 and, for one exponent above 1, a stiff motion that slides
(``strong_damping``).  Derivations ``slow-curve`` and ``settling``.
"""
