"""The classical method of multiple scales, T_0, T_1, T_2, ...: the independent second route to the observables.

The method is that of Kevorkian and Cole, Perturbation Methods in Applied Mathematics, 1981.

Gauges: ``no-first-harmonic`` (the coefficient of cos psi in X is exactly a, that of sin psi is 0; polynomial forces
only) and ``turning-point`` (a is the turning amplitude, X' = 0 at psi = 0 and pi; every law).
"""
