"""Straightening: every even potential is a linear spring in the coordinate xi = sgn(x) sqrt(2 V(x)).

Let V' > 0 for 0 < x <= x0, V even, and d sigma = xi'(x) dt.  Since xi xi' = V', the motion

    x'' + V'(x) + sum_i eps_i |x|^m_i v|v|^(alpha_i-1) = 0

is that of a linear spring with losses that depend on the place, and a clock (derivation ``straightening``):

    d xi/d sigma = v,    d v/d sigma = -xi - x'(xi) sum_i eps_i |x(xi)|^m_i v|v|^(alpha_i-1),    dt = x'(xi) d sigma.

**Identifiability.**  The turning amplitudes depend on (spring, loss) only through the function x'(xi) |x(xi)|^m, after
the relabelling A -> xi_A = sqrt(2 V(A)): a pendulum in a loss v|v|^(alpha-1) and a linear spring in the loss
v|v|^(alpha-1)/sqrt(1 - xi^2/4) have the same amplitudes xi, for ever.  Amplitudes alone cannot tell a nonlinear spring
from a loss that depends on the place; times can, because the clock x'(xi) belongs to the spring alone.
"""
