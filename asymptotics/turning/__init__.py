"""Turning points and the times between them.

======================  ==========================================================================================
``quadratic``           alpha = 2: tables of turning points and times, certified, from any starting index
``quadratic_map``       one half-swing of the amplitude: the Lambert W map, as a contraction of balls
``quadratic_duration``  the half period: a quadrature without end point singularities, with its error bound
``quadratic_series``    exact power series of the map, the half period and their Abel functions
``quadratic_abel``      the Abel function from the exact coefficients
``abel``, ``jump``      any alpha > 1: the n-th turning point for any n, with a rigorous bound of the truncated series
``abel_flow``           sums with every alpha > 1: the same by the integral of the slow flow
``drag_exact``          quadratic drag and dry friction beside any spring, such as a pendulum in air
``any_well``            any spring, pendulum or loss that depends on the place, from rest or in motion
``quadratic_large``     the half period for large amplitudes
``half_swing``          one half-swing at any strength as a result object
``routes``              by pieces, by the series or by one jump: the cheapest of the certified ways
``choose``              any law: the closed forms where they exist, else enclosures half-swing by half-swing
``coulomb``, ``linear`` alpha = 0 and alpha = 1: closed forms, exact and certified; sticking and overdamping
======================  ==========================================================================================
"""
