"""Smith's constants of the motion for alpha = 2: f_n, C_i^n and G_i (exact), S and T on the orbit (certified).

=============  =========================================================================
``exact``      the coefficients C_i^n and the polynomials f_n, as fractions, by four routes
``symbolic``   the generating functions G_i in closed form, for every i
``certified``  S and T at a point of the orbit, and where Smith's double series converges
=============  =========================================================================
"""
