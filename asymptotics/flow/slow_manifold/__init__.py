"""Creep: motions that come to rest along the slow manifold (exponents below 1), enclosed between two barriers.

======================  ==========================================================================================
``slow_curve_series``   the slow curve as a sum of powers of the speed, cut off, and what the cut leaves
``creep_slow_curve``    creep for all times: between two barriers beside the slow curve (fences)
``creep_near_equal``    the slow curve over a stretch, where exponents are nearly equal: coefficients are polynomials
``onset``               creep that begins where its speed is lost in the errors: beside the law itself
``slide``               a fast motion that falls onto the slow curve, as one step
======================  ==========================================================================================

Derivations ``slow-curve`` and ``onset``.
"""
