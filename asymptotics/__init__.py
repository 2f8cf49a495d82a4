"""Symbolic and certified asymptotics for oscillators with power-law damping.

The one equation of this package, for any real alpha >= 0 and any finite sum of such terms, is

    m x'' + k x + sum_i b_i x'|x'|^(alpha_i - 1) = 0.

Import what you need from the folder that names the concept, for example
``from asymptotics.turning import quadratic_turning_points``.  The README has the map.
"""

__version__ = "0.1.0"
