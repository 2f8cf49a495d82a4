"""A(0) and phi(0) of the solution for a start in motion: exact polynomials (``multiple_scales.start``), else balls.
The start is carried back to the turning point of its own orbit, where the slow variables have their meaning.

>>> from asymptotics.gauges import TURNING_POINT
>>> from asymptotics.expansions.multiple_scales.hierarchy import multiple_scales
>>> moving = Oscillator({2: 1}, x0=0, v0=-1)
>>> start_in_motion(moving, multiple_scales(2, order=1, gauge=TURNING_POINT))
(1, epsilon/3 + pi/2)
>>> moving = Oscillator({"3/2": 1}, x0=0, v0=-1)
>>> start_in_motion(moving, multiple_scales("3/2", order=2), digits=12)       # sin^(alpha+1)/(alpha+1) = 2/5
(0.0169376567596*epsilon**2 + 1, 0.4*epsilon + pi/2)
"""

import sympy
from flint import acb, arb
from sympy import Add, Expr, Float, Integer, Mul, Symbol, acos, cos, pi, sin

from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.expansions.multiple_scales.certified_waves import start_series, wave_source
from asymptotics.expansions.multiple_scales.hierarchy import any_start, ordered
from asymptotics.expansions.multiple_scales.symbolic import MultipleScales
from asymptotics.expansions.multiple_scales.turning import TurningHierarchy
from asymptotics.law import Oscillator
from asymptotics.numbers.bridge import to_sympy
from asymptotics.numbers.context import ctx
from asymptotics.numbers.decimals import bits_for
from asymptotics.series import Series

r, theta = Symbol("r", positive=True), Symbol("theta", real=True)
DIGITS = 30


def start_in_motion(given: Oscillator, scales: MultipleScales, *, digits: int = DIGITS) -> tuple[Expr, Expr]:
    """A(0) and phi(0) in the strengths, the start at distance 1; with x' > 0 those of -x, a half-turn earlier.

    Coefficients are exact where the waveforms are polynomials, else certified balls shown with ``digits`` digits.
    """
    m, k, x0, v0 = (to_sympy(n) for n in (given.mass, given.stiffness, given.x0, given.v0))
    speed = v0 * sympy.sqrt(m / k)
    # The waveforms are known for x' < 0.  Every force is odd, so a start with x' > 0 is -x of one that has x' < 0, and
    # X(psi + pi) = -X(psi) puts that half a turn earlier.
    radius, side = sympy.sqrt(x0**2 + speed**2), -1 if given.v0 > 0 else 1
    angle = acos(side * x0 / radius)
    if isinstance(scales.kernel, TurningHierarchy):
        places = {cos(theta): side * x0 / radius, sin(theta): -side * speed / radius, theta: angle}
        size, turn = (e.subs(r, 1).subs(places) for e in any_start(scales).values())
    else:
        size, turn = _in_balls(given, scales, side, digits)
        turn = angle + turn
    return size, turn - (pi if side < 0 else 0)


def start_angle(given: Oscillator) -> Expr:
    """The angle of x - i v/omega_0 at the start, in (-pi, pi], exact.

    >>> start_angle(Oscillator({2: 1}, x0=-1)), start_angle(Oscillator({2: 1}, x0=1, v0=-1))
    (pi, pi/4)
    """
    m, k, x0, v0 = (to_sympy(n) for n in (given.mass, given.stiffness, given.x0, given.v0))
    angle = acos(x0 / sympy.sqrt(x0**2 + m * v0**2 / k))
    return -angle if given.v0 > 0 else angle


def _in_balls(given: Oscillator, scales: MultipleScales, side: int, digits: int) -> tuple[Expr, Expr]:
    """A(0) and psi(0) - theta by the orbit through the start."""
    # 64 bits beyond the digits that are shown, for what the orbit through the start loses; its balls say how much it
    # was.
    bits, order = bits_for(digits, 64), len(scales.orders) - 1
    with ctx.workprec(bits):
        speed = given.v0.ball() / given.omega_0()
        # The phase of the start as the argument of X - i X', which has no branch cut for X' < 0; an arccosine would
        # lose half its digits next to a turning point.
        angle = acb(side * given.x0.ball(), -side * speed).arg()
        forces = Forces.of(ordered(given.dimensionless.terms, scales), order)
        size, turn = start_series(wave_source(forces, order, bits), arb(angle))
        # ``size`` is the series of ln(A(0)/r).
        return _expression(size.exp(), scales, digits), _expression(turn, scales, digits)


def _expression(series: Series, scales: MultipleScales, digits: int) -> Expr:
    """A series in the strengths as SymPy has it; what a ball cannot tell from 0 is left out."""
    # The constant of exp is 1 exactly; that of the phase is 0, and its series has none.
    terms = [Integer(1)] if any(not any(key) for key in series.coefficients) else []
    for key, c in series.coefficients.items():
        if not any(key) or arb(c).contains(0):
            continue
        number = Float(arb(c).mid().str(digits, radius=False), digits)
        terms.append(number * Mul(*[s**n for s, n in zip(scales.symbols, key)]))
    return Add(*terms)
