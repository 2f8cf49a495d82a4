"""Why the series diverge: the Stokes constants of the half-swing, certified.

They are the Ecalle-Voronin invariants of its germ, which is tangent to the identity (Ecalle 1981, Voronin 1981).

``germ``        the half-swing of one law at delta = 0, its coefficients and majorants
``petal``       where orbits stay, and how far the Abel functions are from z there
``half_step``   one half-swing at a complex local strength, in balls
``abel``        the Abel function and the time along an orbit into the petal
``truncation``  where to stop at a local strength, and what is left
``constants``   c_k and d_k from several heights
``result``      their decimals
"""
