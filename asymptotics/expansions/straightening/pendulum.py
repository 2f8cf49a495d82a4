"""A pendulum in any loss: first order in the loss, exact in the amplitude.

x'' + sin x + eps v|v|^(alpha-1) = 0, k = sin(a/2) at the turning angle a, energy E = 2 k^2.  On the conservative path
sin(x/2) = k sin(theta), v = 2 k cos(theta), dx = 2 k cos(theta) d theta/sqrt(1 - k^2 sin(theta)^2), so that a
half-swing takes int |v|^alpha dx = (2 k)^(alpha+1) int cos^(alpha+1)/sqrt(1 - k^2 sin^2), and (derivation
``pendulum-first-order``)

    ln(k'/k) = -eps pi M_(alpha+1) (2 k)^(alpha-1) 2F1(1/2, 1/2; (alpha+3)/2; k^2) + O(eps^2),
    T = pi 2F1(1/2, 1/2; 1; k^2) = 2 K(k^2),

T being the conservative half period.  alpha = 0: arcsin(k)/k; alpha = 1: E and K; alpha = 2: elementary,
-2 eps (sin a - a cos a)/(1 - cos a).

>>> a = arb(3)                                              # 172 degrees, quadratic loss of strength 1/100
>>> log_ratio(arb(2), arb("0.01"), a).str(12), (-arb("0.02") * (a.sin() - a * a.cos()) / (1 - a.cos())).str(12)
('[-0.0312674294318 +/- ...]', '[-0.0312674294318 +/- ...]')
"""

from flint import arb

from asymptotics.errors import InputError
from asymptotics.expansions.moments.certified import moment


def modulus(angle: arb) -> arb:
    """k = sin(a/2) for a turning angle 0 < a < pi (a ball, rad); InputError outside."""
    if not (angle > 0 and angle < arb.pi()):
        shown = angle.str(5, radius=False)
        raise InputError("angle", f"{shown} is not certainly between 0 and pi", "0 < a < pi, in rad")
    return (angle / 2).sin()


def log_ratio(alpha: arb, epsilon: arb, angle: arb) -> arb:
    """ln(k'/k) on the half-swing from the angle a to first order in epsilon: an enclosure of that first order.

    The next turning angle is a' = 2 arcsin(k e^(log_ratio)), with a relative error O(epsilon^2) of the ratio.
    InputError for alpha < 0 or an angle outside the well.
    """
    if not alpha >= 0:
        raise InputError("alpha", f"{alpha.str(5, radius=False)} is not certainly >= 0", "alpha >= 0")
    k, half = modulus(angle), arb(1) / 2
    hypergeometric = (k * k).hypgeom_2f1(half, half, (alpha + 3) / 2)
    power = ((alpha - 1) * (2 * k).log()).exp()
    return -epsilon * arb.pi() * moment(alpha + 1) * power * hypergeometric


def half_period(angle: arb) -> arb:
    """2 K(k^2), the time from one turning angle to the other without loss.

    >>> half_period(arb(2)).str(10)
    '[4.174876463 +/- ...]'
    """
    k, half = modulus(angle), arb(1) / 2
    return arb.pi() * (k * k).hypgeom_2f1(half, half, arb(1))
