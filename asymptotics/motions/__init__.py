"""Motion: x(t) and v(t) in SI units, for any law, any start, at a chosen order or to any number of digits.

=================  ==========================================================================================
``asymptotic``     order N in a named gauge: amplitude, phase and waveform; arrays in doubles
``waveform``       Z_n(psi) of the turning-point gauge for any exponents, by quadrature
``reference``      any law to any number of digits, half-swing by half-swing; exact cases certified
``coulomb``        alpha = 0: exact, with sticking, static friction, stop time and place; certified
``linear``         alpha = 1: exact, under-, critically and over-damped; certified
``quadratic``      alpha = 2 from rest: Lambert W and quadrature; certified
``certify``        from balls to proved decimals
``result``         the immutable results
=================  ==========================================================================================
"""
