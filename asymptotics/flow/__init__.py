"""The certified flow u' = -w, w' = G(u, w) = s_0(u) - (losses at the speed w) of a half-swing, for every force.

The mass moves towards smaller u with the speed w >= 0; s_0 is the force of the springs less dry friction.  What is
here is proved once for the linear spring (a nonexpansive flow), for every other well and for polynomial forces with
gains.  The rooms within bring the forces, and what is known of the motions of each (a ``CertifiedFlow``): the local
expansion at a turning point, traps, closed forms (``linear_spring``, ``wells``), slow curves (``slow_manifold``).

===============  =====================================================================================
``balls``        upper bounds, sizes in doubles, dyadic numbers
``force``        what the flow asks of a force
``damping``      powers of the velocity alone in balls: N(w), and doubles that choose sizes
``composition``  power series put into the force, on a line or on a simplex of exponents
``taylor``       one Taylor step with its error by the residual (defect), the same for all forces
``times``        times added exactly; the state at a time next to a turning point
``parting``      how far two motions part: the record of errors, and the rule by which they travel
``trajectory``   a half-swing in pieces, from an exact state to the next turning point
``turning``      a turning point with its errors
``sequence``     turning points one after the other
``dense``        (x, v) at many times in one pass
===============  =====================================================================================

Derivations ``taylor-residual``, ``motions-never-part``, ``wells-contract``, ``wells-distance`` and
``parting-with-gains``.
"""
