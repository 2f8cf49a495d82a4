"""The certified flow u' = -w, w' = G(u, w) = s_0(u) - (losses at the speed w) of a half-swing, for every force.

The mass moves towards smaller u with the speed w >= 0; s_0 is the force of the springs less dry friction.  What is
here is proved once for the linear spring (a nonexpansive flow, the semigroup of a monotone operator: Brezis 1973), for
every other well and for polynomial forces with gains (the logarithmic norm: Dahlquist 1958, Lozinskii 1958).  No set is
carried through a step, so nothing wraps (Moore, Lohner): an exact orbit is followed, and the distance of the truth from
it is a number of its own.  The rooms within bring the forces, and what is known of the motions of each (a
``CertifiedFlow``): the local expansion at a turning point, traps, closed forms (``linear_spring``, ``wells``), slow
curves (``slow_manifold``).

Derivations ``taylor-residual``, ``motions-never-part``, ``wells-contract``, ``wells-distance`` and
``parting-with-gains``.
"""
