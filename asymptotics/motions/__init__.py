"""Motion: x(t) and v(t) in SI units, for any law, any start, at a chosen order or to any number of digits.

Asymptotic motion is that of averaging (Bogoliubov and Mitropolsky 1961): slow equations for amplitude and phase, and a
waveform; its error is an estimate.  Reference and exact motion are enclosed in balls, and every digit is proved.
"""
