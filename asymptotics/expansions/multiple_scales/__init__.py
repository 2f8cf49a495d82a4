"""The classical method of multiple scales, T_0, T_1, T_2, ...: the independent second route to the observables.

==================  ==================================================================================================
``ring``            polynomials in psi, sin psi, cos psi over Q[pi, 1/pi], on 0 < psi < pi
``turning``         integer exponents, dry friction and springs in the turning-point gauge: exact, to any order
``turning_orders``  the same in SymPy, every order displayed
``open_orders``     any other exponent, also symbolic: closed where it closes, named integrals beyond
``rates``           the rates that are known: closed forms, certified digits
``exact``           polynomial forces, gauge no-first-harmonic: the recurrence on rational Fourier coefficients
``symbolic``        the same in SymPy, and the type of every derivation, ``MultipleScales``
``start``           a(0), psi(0) of any start, in motion too, in the turning-point gauge
``initial``         X(0) = 1, X'(0) = 0 to the same order, and the map to the turning points
``orders``          one order of the hierarchy as an object that shows itself (SymPy, LaTeX, notebook)
``harmonics``       |sin|^alpha sgn sin: Fourier coefficients and the sums over them, in closed form
``powers``          second order of losses and springs in closed form, in every gauge
==================  ==================================================================================================

Gauges: ``no-first-harmonic`` (the coefficient of cos psi in X is exactly a, that of sin psi is 0; polynomial forces
only) and ``turning-point`` (a is the turning amplitude, X' = 0 at psi = 0 and pi; every law).
"""
