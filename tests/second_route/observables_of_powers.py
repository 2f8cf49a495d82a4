"""The observables of ``multiple_scales.powers`` through second order in the strengths at a turning point.

>>> from sympy import Integer
>>> from asymptotics.terms import Term
>>> forces = Powers((Integer(2),), (Term(1, 0, 3, "position"),))
>>> half_period(forces)[1, 1]                                                    # as the exact map has it
pi/2
"""

from sympy import Expr, Integer, pi

from asymptotics.expansions.multiple_scales.powers import Closed, Power, Powers


def log_ratio(forces: Powers) -> Closed:
    """ln(A_(n+1)/A_n): U = -p/(1 + Omega), and its change along the half-swing."""
    found = {key: -pi * c for key, c in forces.p("turning-point").items()}
    losses, springs = forces.part(1, -1), forces.part(1, 1)
    for x in losses:
        for y in losses:
            _add(found, x, y, pi**2 / 2 * x.weight * x.mean * y.mean)
        for y in springs:
            _add(found, x, y, pi * x.mean * y.mean)
    return found


def half_period(forces: Powers) -> Closed:
    """The time between turning points minus pi: W = 1/(1 + Omega), and its change along the half-swing."""
    found = {key: -pi * c for key, c in forces.Omega("turning-point").items()}
    for x in forces.part(1, 1):
        for y in forces.part(1, 1):
            _add(found, x, y, pi * x.mean * y.mean)
        for y in forces.part(1, -1):
            _add(found, x, y, pi**2 / 2 * x.weight * x.mean * y.mean)
    return found


def _add(found: Closed, x: Power, y: Power, value: Expr) -> None:
    key = tuple(a + b for a, b in zip(x.key, y.key, strict=True))
    found[key] = found.get(key, Integer(0)) + value
