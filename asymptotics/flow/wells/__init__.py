"""One half-swing in any even well, at any strength, as an enclosure: springs, pendulum, losses that know the place.

No nonexpansive flow here; the bounds are by the logarithmic norm along a piece, by comparison of orbits between turns.

    u' = -w,    w' = G(u, w) = s_0(u) - sum_i epsilon_i |u|^m_i w^alpha_i,
    s_0(u) = V'(u) - (the losses of exponent 0)

on a swing towards smaller u, w >= 0.  The pieces of a half-swing and their errors are those of ``flow``: here the
distance of two motions may grow within a half-swing, while from one turning point to the next the squares of the speeds
at equal places draw together (``flow.error_propagation``).

Derivations ``wells-majorant`` and ``wells-traps``.
"""
