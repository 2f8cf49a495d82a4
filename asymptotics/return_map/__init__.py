"""The return map from one turning point to the next, interpolated in the amplitude: beside the linear spring.

=======================  =========================================================================================
``coordinate``           the one number that a half-swing depends on analytically, and how far
``chebyshev``            interpolation of a function known as balls, with its error
``spectral``             Chebyshev points: values, coefficients and integrals, as matrices
``quarters_in_doubles``  quarter-swings in doubles: where the collocation begins, and how many nodes it takes
``quarters``             quarter-swings at many strengths at once, forwards or backwards, by collocation
``half_swings``          half-swings put together from two quarters
``half_swing_map``       one half-swing, by the flow or in closed form
``panel_plan``           which amplitudes are worth a panel: choices, and the ellipse about it, checked
``panels``               half-swings by interpolation: hundredths of a millisecond each
``sequence``             turning points one after the other, by interpolation where it pays
=======================  =========================================================================================

Derivation ``quarter-collocation``.
"""
