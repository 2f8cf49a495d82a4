"""Smith's constants of the motion by name: S and T at a point of the orbit, and where his series converge.  First
integrals of a half-swing; the turning point before a point is the branch W_(-1) of Lambert's W (Corless et al. 1996).

All for quadratic damping, in u = gamma x and w = gamma v/omega (X = u/epsilon in units of x0, gamma = epsilon/x0).

>>> print(S(1, 0, digits=12), T(1, 0, "1/2", digits=5))          # at a turning point: -(2 u + 1) e^(-2 u)/4, and now
-0.101501462427 0.50000
>>> print(*radii("1/2", digits=8))
0.97158589 0.73655239
"""

from math import log

from asymptotics.costs import deep_quadrature_seconds, require_affordable
from asymptotics.errors import InputError
from asymptotics.motions.invariants.certified import absolute_radius, first_constant, second_constant, series_radius
from asymptotics.numbers.decimals import bits_for, certified_decimal, rational_decimal
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.policy import Number, exact_integer, exact_number, float_notes
from asymptotics.numbers.value import Coefficient
from asymptotics.running.budget import seconds_left
from asymptotics.running.public import public

# They decide refusals alone: at u = 100 S is of the size e^200, and so is e^(2 w^2) at w = 10.  Nothing that is
# answered rests on them.
MAX_U, MAX_RADIUS_W, MAX_DIGITS, MAX_TIME = 100, 10, 1000, 10**12


@public
def S(u: Number, w: Number, *, digits: int = 30, max_seconds: Number = 60) -> Coefficient:
    """S = e^(2 s u) (w^2/2 + s u/2 - 1/4), s the sign of w: the same number all along a half-swing (Smith 2012, (40)).

    At w = 0 the point belongs to the half-swing that it starts: s = -sign(u).

    Parameters
    ----------
    u
        gamma x, without a unit, from -100 to 100
    w
        gamma x'/omega, without a unit, from -100 to 100
    digits
        significant digits, correctly rounded
    max_seconds
        the time the call may take, in s

    Returns
    -------
    Coefficient
        its digits ``value``, ``interval()``, ``ball()``

    Raises
    ------
    InputError
        for u or w beyond 100 in size

    Examples
    --------
    >>> S(0, "1/2").value, S("1/2", 0, digits=8).interval()
    ('-0.125000000000000000000000000000', mpi('-0.183939725', '-0.183939715'))
    """
    place, speed = _point(u, w)
    D, notes = exact_integer(digits, "digits", 1, MAX_DIGITS), float_notes(u=u, w=w)
    # At u = 0 the exponential is 1 and S is rational: an exact number has its ties and zeros told, which no ball can.
    if place.is_zero and speed.is_rational:
        return Coefficient(rational_decimal(_level(place, speed).rational, D), None, notes)
    # S = 0 on the separating curve: a ball around 0 would never have a first digit.
    if _level(place, speed).is_zero:
        return Coefficient("0", None, notes)
    return Coefficient(certified_decimal(lambda: first_constant(place.ball(), speed.ball()), D), None, notes)


@public
def T(u: Number, w: Number, tau: Number = 0, *, digits: int = 30, max_seconds: Number = 60) -> Coefficient:
    """T = omega t - (omega times the time since the last turning point): when the half-swing of (u, w) began.

    Source: Smith 2012, (69), by quadrature on either branch.

    Parameters
    ----------
    u
        gamma x, without a unit, from -100 to 100
    w
        gamma x'/omega, without a unit, from -100 to 100
    tau
        omega t at that point, without a unit
    digits
        significant digits, correctly rounded
    max_seconds
        the time the call may take, in s

    Returns
    -------
    Coefficient
        its digits ``value``, ``interval()``, ``ball()``

    Raises
    ------
    InputError
        where S >= 0: no turning point came before
    LimitError
        where the digits, or those that are lost next to a turning point, take longer than there is time

    Examples
    --------
    >>> print(T("1/4", "-1/4", 3, digits=12))
    2.16811921419
    """
    (place, speed), now = _point(u, w), exact_number(tau, "tau")
    D = exact_integer(digits, "digits", 1, MAX_DIGITS)
    if not abs(now) <= MAX_TIME:
        raise InputError("tau", "it is out of range", f"a number of at most {MAX_TIME} in size")
    notes = float_notes(u=u, w=w, tau=tau)
    if speed.is_zero:  # it is a turning point itself
        return Coefficient(certified_decimal(lambda: now, D), None, notes)
    # Decided exactly, before any ball: e^(2 s u) > 0 leaves the sign of S to the polynomial.
    if not _level(place, speed) < 0:
        raise InputError("w", "S >= 0: no turning point came before this point", "w^2/2 + s u/2 < 1/4, s the sign of w")
    # Next to a turning point the time since it is about |w|, found from 1 - cos of an angle, which is of size w^2: two
    # bits are lost for each bit by which w is small.  The estimate of the cost must be of the precision at which the
    # doubling of ``certified_decimal`` can end; a double chooses only what is refused.
    bits, lost = bits_for(D), -2 * float(abs(speed).ball().log()) / log(2)
    while bits < bits_for(D, 0) + lost:
        bits *= 2
    work = f"{D} digits at a speed of {speed.ball().str(3, radius=False)}"
    require_affordable(deep_quadrature_seconds(bits), seconds_left(), "digits" if lost < D else "w", work)
    # 4096 bits beyond the digits: |w| down to about 2^-2000; smaller ones are UndecidedError, not wrong.
    found = certified_decimal(
        lambda: second_constant(place.ball(), speed.ball(), now.ball()), D, max_bits=bits_for(D, 1 << 12)
    )
    return Coefficient(found, None, notes)


@public
def radii(w: Number, *, digits: int = 30, max_seconds: Number = 60) -> tuple[Coefficient, Coefficient]:
    """(R, rho): sum_n f_n(w) z^n converges for abs(z) < R, absolutely over i and n at once for abs(z) < rho <= R.

    Source: derivation ``smith-series-radii``.

    Parameters
    ----------
    w
        gamma x'/omega, without a unit, 0 < abs(w) <= 10
    digits
        significant digits, correctly rounded
    max_seconds
        the time the call may take, in s

    Returns
    -------
    tuple
        R and rho, each a ``Coefficient``

    Raises
    ------
    InputError
        for w = 0 and beyond 10 in size

    Examples
    --------
    >>> [str(radius) for radius in radii("1/2", digits=8)]
    ['0.97158589', '0.73655239']
    """
    speed, D = exact_number(w, "w"), exact_integer(digits, "digits", 1, MAX_DIGITS)
    if speed.is_zero or not abs(speed) <= MAX_RADIUS_W:
        raise InputError("w", f"{speed} is out of range", f"0 < |w| <= {MAX_RADIUS_W}")
    R = certified_decimal(lambda: series_radius(speed.ball()), D)
    rho = certified_decimal(lambda: absolute_radius(speed.ball()), D)
    return Coefficient(R, None, float_notes(w=w)), Coefficient(rho, None, float_notes(w=w))


def _point(u: Number, w: Number) -> tuple[ExactReal, ExactReal]:
    """(u, w), turned by half a turn where the point is at rest on the left: S is that of the half-swing to come."""
    place, speed = exact_number(u, "u"), exact_number(w, "w")
    for name, value in (("u", place), ("w", speed)):
        if not abs(value) <= MAX_U:
            raise InputError(name, f"{value} is out of range", f"a number of at most {MAX_U} in size")
    # (u, 0) with u < 0 starts the half-swing that (|u|, 0) starts when x and v change their signs; S is the same.
    return (abs(place), speed) if speed.is_zero else (place, speed)


def _level(place: ExactReal, speed: ExactReal) -> ExactReal:
    """The sign of S, exactly: w^2/2 + s u/2 - 1/4."""
    # ``first_constant`` without its positive factor e^(2 s u), s the sign of w.
    side = place if speed > 0 else -place
    return (speed * speed * 2 + side * 2 - 1) / 4
