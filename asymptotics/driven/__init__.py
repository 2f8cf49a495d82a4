"""The same losses under a harmonic force, m x'' + k x + sum_i b_i x'|x'|^(alpha_i-1) = f cos(Omega t): one response.

The power of each loss grows with the speed, so the difference of two motions under one force never grows: there is one
periodic orbit, and every motion tends to it.  ``first_order`` has it closed, ``respond`` in balls: a trial orbit in
pieces (``expansion``, ``trial``), how far it is from an exact motion, and the contraction of half a period beside it;
where a loss is steep at rest (dry friction, exponents below 1), of a period, whose turns count (``turn``).

With theta = Omega t, mu = m Omega^2 and c_i = b_i Omega^alpha_i the equation is

    mu x'' + k x + sum_i c_i x'|x'|^(alpha_i-1) = f cos(theta),    x(theta + pi) = -x(theta) for the response.

Derivations ``driven-first-order`` and ``driven-unique``.
"""
