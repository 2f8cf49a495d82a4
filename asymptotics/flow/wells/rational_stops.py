"""Stops under dry friction beside springs, as rational numbers: what no ball tells is decided exactly.

Dry friction eps and springs c_j x|x|^(p_j-1) of rational strengths have the energy equation of a half-swing from rest
at a > 0 to -q,

    V(q) + eps q = V(a) - eps a,    V(x) = x^2/2 + sum c_j |x|^(p_j+1)/(p_j+1),

a polynomial over the rationals; where the mass stops before the centre, q = -z with V(z) - eps z = V(a) - eps a.  As
long as its root is rational the orbit is known, its ties among it: x = 0, where no digit of x is ever decided, and
V'(|q|) = eps, where a force that holds the mass just so cannot be told from one that does not.  The mass stays where
V'(|q|) <= eps.

>>> from asymptotics.law import Law
>>> rational_stops(Law({0: "3/4"}, spring={3: 1}).terms, ExactReal(1))
((Fraction(1, 1), False), (Fraction(0, 1), True))
>>> rational_stops(Law({0: 3}, spring={3: 2}).terms, ExactReal(-2))                              # V'(1) = 3: a tie
((Fraction(-2, 1), False), (Fraction(1, 1), True))
"""

from collections.abc import Sequence
from fractions import Fraction

from flint import fmpq, fmpq_poly

from asymptotics.numbers.exact import ExactReal
from asymptotics.terms import Term

# Limits of work only: beyond them the route in balls answers, and only exact ties stay undecided.
_DEGREE, _MOST = 12, 40  # powers of a spring, and places, that are looked at

Stop = tuple[Fraction, bool]  # the place, and whether dry friction holds the mass there


def rational_stops(terms: Sequence[Term], x0: ExactReal) -> tuple[Stop, ...]:
    """The turning points from rest at x0 != 0 on, inside the well, as long as they are rational.

    None for another force: springs of both signs, whose V' may cross eps twice, a pendulum, losses that depend on the
    speed or the place, numbers that are not rational.
    """
    found = _energy(terms)
    if found is None or not x0.is_rational or x0.is_zero:
        return ()
    well, dry = found
    a, side = abs(x0.rational), 1 if x0.rational > 0 else -1
    # V' + eps <= 2 eps: ``well`` has eps q in it.
    stops = [(x0.rational, _force(well, a) <= 2 * dry)]
    while len(stops) < _MOST and not stops[-1][1]:
        q = _following(well, a, dry)
        if q is None:
            break
        side = -side
        stops.append((side * q, _force(well, abs(q)) <= 2 * dry))
        a = q
    return tuple(stops)


def _energy(terms: Sequence[Term]) -> tuple[list[Fraction], Fraction] | None:
    """The coefficients of V(q) + eps q, and eps > 0."""
    well, dry, signs = {2: Fraction(1, 2)}, Fraction(0), set()
    for t in terms:
        e = t.strength
        if not isinstance(e, ExactReal) or not e.is_rational or t.family:
            return None
        if e.is_zero:
            continue
        if not t.velocity.is_zero or (t.sign > 0 and t.position > _DEGREE) or (t.sign < 0 and t.position):
            return None
        if t.sign > 0:
            well[t.position + 1] = well.get(t.position + 1, Fraction(0)) + e.rational / (t.position + 1)
            signs.add(e.sign)
        else:
            dry += e.rational
    # With springs of one sign V' is convex or concave from 0 on: where V'(a) > eps, V' crosses eps once between 0 and
    # a, and the stop before the centre is unique.
    if len(signs) > 1 or not dry > 0:
        return None
    well[1] = dry
    return [well.get(n, Fraction(0)) for n in range(max(well) + 1)], dry


def _force(well: list[Fraction], x: Fraction) -> Fraction:
    """The force V'(x) of the springs and eps together."""
    return sum((n * c * x ** (n - 1) for n, c in enumerate(well) if n), Fraction(0))


def _following(well: list[Fraction], a: Fraction, dry: Fraction) -> Fraction | None:
    """The next turning distance where it is rational; below 0 for a stop before the centre."""
    # V(a) - eps a: what is left for the other side of the centre, if it is above 0.
    energy = sum((c * a**n for n, c in enumerate(well)), Fraction(0)) - 2 * dry * a
    side = 1 if energy >= 0 else -1  # before the centre: V(z) - eps z for q = -z
    rows = [-energy, side * dry, *well[2:]]
    whole = fmpq_poly([fmpq(c.numerator, c.denominator) for c in rows]).numer()
    # Factored over the rationals: a rational root is a linear factor, and any other root ends what is known exactly.
    for factor, _ in whole.factor()[1]:
        if factor.degree() == 1:
            root = Fraction(-int(factor[0]), int(factor[1]))
            # V(q) + eps q increases, so there is one root beyond the centre; before it V(z) - eps z falls where V' <
            # eps, and the motion stops on that branch.
            if 0 <= root <= a and (side > 0 or _force(well, root) < 2 * dry):
                return side * root
    return None
