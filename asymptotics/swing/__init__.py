"""One half-swing at any strength, as an enclosure: any real alpha >= 0, sums of laws, any amplitude.

==============  ======================================================================================
``damping``     the law in balls: N(w), and doubles that choose sizes
``majorant``    the algebraic majorant of the local expansion at a turning point, its tail in balls
``kept_terms``  which terms of a local expansion are kept, by integer weights
``expansion``   the motion next to a turning point, in powers of the speed: the branch point removed
``ends``        when no turning point follows: sticks, creeps, overdamped, decided in balls
``creep_slow_curve`` creep for all times: between two barriers beside the slow curve
``slow_curve_series`` the slow curve as a sum of powers of the speed, cut off, and what the cut leaves
``creep_near_equal`` the slow curve over a stretch, where exponents are nearly equal: coefficients that are polynomials
``onset``       creep that begins where its speed is lost in the errors: beside the law itself
``linear``      linear damping and dry friction alone: the closed form
``near_critical`` next to critical linear damping: how long a half-swing takes, how many bits it loses
``linear_spring`` the flow beside the linear spring: its closed form, its creeps
``turning_point`` the far turning point: no bracketing, the family of orbits spreads
``chebyshev``   interpolation of a function known as balls, with its error
``coordinate``  the one number that a half-swing depends on analytically, and how far
``panel_plan``  which amplitudes are worth a panel: choices, and the ellipse about it, checked
``spectral``    Chebyshev points: values, coefficients and integrals, as matrices
``quarters_in_doubles`` quarter-swings in doubles: where the collocation begins, and how many nodes it takes
``quarters``    quarter-swings at many strengths at once, forwards or backwards, by collocation
``half_swings`` half-swings put together from two quarters
``panels``      half-swings by interpolation: hundredths of a millisecond each
``sequence``    turning points one after the other, by interpolation where it pays
==============  ======================================================================================

The course, the errors and the Taylor steps are those of ``flow``.  Derivations ``motions-never-part``,
``turning-point-majorant``, ``slow-curve``,
``onset``   , ``arrival`` and ``quarter-collocation``.
"""
