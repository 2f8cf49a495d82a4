"""What the front door hands out: each function takes a law or an oscillator and answers in its units.

===================  =============================================================================
``units``            a law, an oscillator or a mapping, read as what is meant
``motions``          ``motion`` (asymptotic) and ``reference``: arrays, dense solution, events
``swings``           ``turning_points``, ``half_swing`` of a law, or of an oscillator in m and s
``slow``             ``envelope``: A(t) and phi(t) at first order, with its formula
``lookups``          ``moment``, ``table``, Smith's polynomials, coefficients and functions
``hierarchy``        ``multiple_scales``: the classical derivation, order by order
===================  =============================================================================
"""
