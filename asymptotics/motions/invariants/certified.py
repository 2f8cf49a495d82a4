"""Smith's constants of the motion S and T as enclosures, and the truth about his double series (57), (61).

In u = gamma x, w = gamma v / omega the first constant is (corrected sign of the exponent)

    S = e^(-2u) (w^2/2 - u/2 - 1/4)  for w < 0,      S = e^(2u) (w^2/2 + u/2 - 1/4)  for w > 0,

and T = omega t - (time since the last turning point), the same number all along a half-swing.  That time is evaluated
by quadrature, on either branch, so nothing has to be continued by hand when the arc tangent of (69) jumps.

>>> u, w = arb(0), -((1 - 3 * arb(-2).exp()) / 2).sqrt()    # (45): first passage through equilibrium, u_0 = 1
>>> first_constant(u, w).overlaps(-3 * arb(-2).exp() / 4)   # (42)
True
>>> since_turning_point(u, w)
[1.94029221... +/- ...]

**Where the series converges.**  With z = w / (w^2 - u) and A = 2w/z - 1 the time is
F(w, z) = int_0^w 2 dw' / (1 + W(A e^A e^(-2(w^2 - w'^2)))), singular where the level reaches that of the equilibrium on
another sheet, A e^A = -e^(2 w^2 - 1).  Hence for real w (derivation ``smith-series-radii``)

* sum_n f_n(w) z^n  (57) converges for |z| < R(w) = |2w / (1 + W_0(-e^(2w^2-1)))| and diverges for |z| > R(w);
* the double sum (61) converges absolutely for |z| < rho(|w|) = 2|w| / (-1 - W_(-1)(-e^(-1-2w^2))) <= R(w); the signs of
  C_i^n are (-1)^((n-i-1)/2), so this is F at imaginary arguments and the singularity is real (Pringsheim).

R(0) = rho(0) = 1 and both decrease: the condition always fails around the point of greatest speed, where z = tan theta
is infinite.  The series never describes a whole half-swing.
"""

from flint import acb, arb, fmpq

from asymptotics.turning.quadratic_duration import elapsed
from asymptotics.turning.quadratic_map import next_amplitude


def first_constant(u: arb, w: arb) -> arb:
    """S at (u, w); both branches have one value on a half-swing.  ValueError if the sign of w is undecided."""
    if w > 0:
        u = -u
    elif not w <= 0:
        raise ValueError(f"the sign of w = {w.str(5)} is undecided")
    return (-2 * u).exp() * (w * w / 2 - u / 2 - arb(fmpq(1, 4)))


def last_turning_point(u: arb, w: arb) -> arb:
    """|u_0| of the half-swing through (u, w): 1 + 2 u_0 = -W_(-1)(4 S / e).

    Raises ValueError if S >= 0: then the motion comes from infinity and has no earlier turning point.
    """
    level = 4 * first_constant(u, w)
    if not level < 0:
        raise ValueError("S >= 0: no turning point precedes this point")
    # S at the turning point, e^(-2u)(-u/2 - 1/4) = S, solved for u; the branch W_(-1) <= -1 is the one with u_0 >= 0.
    return (-((level / arb.const_e()).lambertw(-1)) - 1) / 2


def since_turning_point(u: arb, w: arb) -> arb:
    """omega times the time since the last turning point, from the point (u, w) with w != 0."""
    if w > 0:
        return since_turning_point(-u, -w)
    if not w < 0:
        raise ValueError(f"w = {w.str(5)} is not certainly nonzero: a point at rest is a turning point itself")
    p = 2 * last_turning_point(u, w)
    q = next_amplitude(p)
    # (1 - cos chi)/2, whose balls may leave [0, 1] by rounding next to a turning point.
    versine = ((p - 2 * u) / (p + q)).nonnegative_part()
    return elapsed(p, q, 2 * versine.min(arb(1)).sqrt().asin())


def second_constant(u: arb, w: arb, tau: arb) -> arb:
    """T = omega t - (time since the last turning point): the instant of that turning point."""
    return tau - since_turning_point(u, w)


def series_radius(w: arb) -> arb:
    """R(w), the radius of convergence in z of sum f_n(w) z^n, for real w != 0."""
    branch = acb(-((2 * w * w - 1).exp())).lambertw()
    return abs(2 * acb(w) / (1 + branch))


def absolute_radius(w: arb) -> arb:
    """rho(|w|): the double series converges absolutely for |z| below it and not above it, for w != 0."""
    return 2 * abs(w) / (-1 - (-((-1 - 2 * w * w).exp())).lambertw(-1))
