"""The amplitude and phase equations as one result: evaluated, converted, shown, compared, observed.

================  ====================================================================================
``result``        ``Equations``: p_k and Omega_k of any law in any gauge, and what they say at an amplitude
``build``         ``expand``: from an exponent, a list, a law, an oscillator or a symbol
``observables``   half period, decrement, Q, energy loss at a turning amplitude, with error estimates
``comparison``    two sets of equations, or equations and a user's function
================  ====================================================================================
"""
