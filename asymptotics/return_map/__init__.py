"""The return map from one turning point to the next, interpolated in the amplitude: beside the linear spring.

Chebyshev interpolation of an analytic function with an error by Cauchy's inequality on a Bernstein ellipse (Trefethen,
Approximation Theory and Approximation Practice, theorems 8.1 and 8.2); the map is analytic in the local strengths by a
majorant (``expansions.half_swings.finite_majorant``, ``quarter_majorant``).

Derivation ``quarter-collocation``.
"""
