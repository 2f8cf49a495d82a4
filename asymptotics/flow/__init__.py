"""The certified flow u' = -w, w' = G(u, w) = s_0(u) - (losses at the speed w) of a half-swing, for every force.

The mass moves towards smaller u with the speed w >= 0; s_0 is the force of the springs less dry friction.  What is
here is proved once for the linear spring, for every other well and for polynomial forces with gains; the rooms
``swing``, ``wells`` and ``limit_cycles`` follow an orbit with it, each with its own theorem on how far two motions
part.

===============  =====================================================================================
``balls``        upper bounds, sizes in doubles, dyadic numbers
``force``        what the flow asks of a force
``composition``  power series put into the force, on a line or on a simplex of exponents
``taylor``       one Taylor step with its error by the residual (defect), the same for all forces
``times``        times added exactly; the state at a time next to a turning point
===============  =====================================================================================

Derivation ``taylor-residual``.
"""
