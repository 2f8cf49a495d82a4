"""Smith's constants of the motion for alpha = 2: f_n, C_i^n and G_i (exact), S and T on the orbit (certified).

First integrals of an integrable equation: S of the orbit, T of the time on it (Smith 2012).
"""
