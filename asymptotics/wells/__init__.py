"""One half-swing in any even well, at any strength, as an enclosure: springs, pendulum, losses that know the place.

    u' = -w,    w' = G(u, w) = s_0(u) - sum_i epsilon_i |u|^m_i w^alpha_i,
    s_0(u) = V'(u) - (the losses of exponent 0)

on a swing towards smaller u, w >= 0.  It differs from ``swing`` in how errors travel: beside the linear spring two
motions never part, here their distance may grow within a half-swing, at a rate that is bounded piece by piece, while
from one turning point to the next the squares of the speeds at equal places draw together.

==============  ======================================================================================
``force``       the force in balls: values, slopes, what a disc of complex u and w can make of it
``expansion``   the motion next to a turning point, in powers of the speed, with its majorant
``distance``    how far two motions can part: growth along a piece, places and times of turning
``ends``        sticks, creeps, overdamped; escapes and rotates: what leaves the well
``landing``     the turning point ahead
``course``      a half-swing in pieces, from an exact state to the next turning point
``sequence``    turning points one after the other
``dense``       (x, v) at many times in one pass
==============  ======================================================================================

Taylor steps and compositions are those of ``flow``.  Derivations ``wells-contract``, ``wells-distance``,
``wells-majorant`` and ``wells-traps``.
"""
