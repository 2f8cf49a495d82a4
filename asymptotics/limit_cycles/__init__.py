"""Limit cycles of anti-damped laws: where losses and gains of energy balance (van der Pol, Rayleigh, ...).

==============  =========================================================================================
``series``      amplitude, frequency and multiplier as series in mu, the common factor of the laws
``result``      both as rows of decimals and exact forms
``force``       the polynomial force in balls, for the certified flow
``half_turn``   from one turning point to the next on the flow, with gains as well as losses
``certified``   at a number mu: the turning amplitude by interval Newton, the period and the multiplier
==============  =========================================================================================
"""
