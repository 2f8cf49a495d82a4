"""The flow beside the linear spring, any sum of powers of the velocity: a nonexpansive flow (motions never part).

==================  =====================================================================================
``linear_spring``   the flow for the course of ``flow``: its closed form, its creeps
``linear``          linear damping and dry friction alone: the closed form
``majorant``        the algebraic majorant of the local expansion at a turning point, its tail in balls
``kept_terms``      which terms of a local expansion are kept, by integer weights
``rows``            the coefficients of a local expansion, row by row, where exponents are irrational
``expansion``       the motion next to a turning point, in powers of the speed: the branch point removed
``turning_point``   the far turning point: no bracketing, the family of orbits spreads
``ends``            when no turning point follows: sticks, creeps, overdamped, decided in balls
``near_critical``   next to critical linear damping: how long a half-swing takes, how many bits it loses
==================  =====================================================================================

The force in balls is ``flow.damping``; the course, the errors and the Taylor steps are those of ``flow``, creep is
``flow.slow_manifold``.  Derivations ``motions-never-part``, ``turning-point-majorant`` and ``arrival``.
"""
