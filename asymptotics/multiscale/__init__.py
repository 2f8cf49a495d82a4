"""The classical method of multiple scales, T_0, T_1, T_2, ...: the independent second route to the observables.

================  ====================================================================================================
``exact``         polynomial forces: the recurrence on rational Fourier coefficients, to any order
``initial``       X(0) = 1, X'(0) = 0 to the same order, and the map to the turning points
``verify``        the residual in the equation of motion, exact
``observables``   flow, other gauges and half-swing from the classical results alone
``orders``        one order of the hierarchy as an object that shows itself (SymPy, LaTeX, notebook)
``symbolic``      ``multiple_scales``: polynomial forces in SymPy
``harmonics``     |sin|^alpha sgn sin: Fourier coefficients and the sums over them, in closed form
``general``       ``second_order``: any exponents >= 0, symbols or numbers, to second order
================  ====================================================================================================

The gauge of this form is ``no-first-harmonic``: the coefficient of cos psi in X is exactly a, that of sin psi is 0.
"""
