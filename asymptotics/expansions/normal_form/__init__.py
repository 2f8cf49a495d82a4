"""The flow behind the half-swing map: amplitude and frequency series in three gauges, observables, large orders.

====================  ==================================================================================
``flow``              U, V, W from L, F, T by (1/pi) log C/(C - 1), for any coefficient ring
``gauges``            turning-point, averaging, no-first-harmonic; exact maps between them
``expansion``         p_k and Omega_k as a result that carries gauge, arithmetic and order
``observables``       amplitude ratio, half period, energy loss, logarithmic decrement: the same in every gauge
``symbolic``          one law with symbolic exponent, closed forms through Omega_4
``results``           the rows of an expansion and of a half-swing
``show``              series as text and LaTeX, written as one would by hand
``tau_polynomial``    polynomials in tau as coefficients, for the gauge brackets
====================  ==================================================================================
"""
