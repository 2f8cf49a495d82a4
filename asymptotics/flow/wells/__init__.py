"""One half-swing in any even well, at any strength, as an enclosure: springs, pendulum, losses that know the place.

    u' = -w,    w' = G(u, w) = s_0(u) - sum_i epsilon_i |u|^m_i w^alpha_i,
    s_0(u) = V'(u) - (the losses of exponent 0)

on a swing towards smaller u, w >= 0.  The course and its errors are those of ``flow``: here the distance of two motions
may grow within a half-swing, while from one turning point to the next the squares of the speeds at equal places draw
together (``flow.parting``).

==============  ======================================================================================
``force``       the force in balls: values, slopes, what a disc of complex u and w can make of it
``expansion``   the motion next to a turning point, in powers of the speed, with its majorant
``ends``        sticks, creeps, overdamped; escapes and rotates: what leaves the well
``turning_point`` the turning point ahead
``even_well``   the flow of such a force, for the course of ``flow``
==============  ======================================================================================

Derivations ``wells-majorant`` and ``wells-traps``.
"""
