"""The flow beside the linear spring, any sum of powers of the velocity: a nonexpansive flow (motions never part).

The loss is nondecreasing in the velocity, so minus the vector field is a monotone operator (Brezis 1973): the Euclidean
distance of two motions does not grow, whatever the exponents.

The force in balls is ``flow.damping``; the pieces of a half-swing, the errors and the Taylor steps are those of
``flow``, creep is ``flow.slow_manifold``.  Derivations ``motions-never-part``, ``turning-point-majorant`` and
``arrival``.
"""
