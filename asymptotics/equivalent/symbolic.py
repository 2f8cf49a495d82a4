"""Equivalent damping of first order in closed form, at the turning amplitude A.

One cycle of the motion without loss takes Delta E = closed integral of the loss over the path, out of E = V(A):

    zeta = Delta E/(4 pi E),   Q = 2 pi E/Delta E = 1/(2 zeta),   decrement = Delta E/(A V'(A)) = ln(A_n/A_(n+2)),
    c_eq = Delta E/closed integral of v dx      (the viscous coefficient that takes as much in that cycle).

Linear spring (derivation ``equivalent-damping``), losses b |x|^m v|v|^(alpha-1) of degree d = alpha + m:

    zeta = sum <|cos|^m |sin|^(alpha+1)> b omega_0^alpha A^(d-1)/k,   decrement = 2 pi zeta,  c_eq = 2 zeta sqrt(k m).

Pendulum and x + c x^3: zeta by 2F1, exact in the amplitude (``straightening.wells``); other springs: an integral that
waits.  The half-life is the time in which A falls to A/2: closed for one loss, and for two if one has degree 1.

>>> from asymptotics.frames import BARE
>>> x = closed_forms((Term(1, 2),), BARE)
>>> x["zeta"], x["Q"], x["half_life"]
(4*A*epsilon/(3*pi), 3*pi/(8*A*epsilon), 3*pi/(4*A*epsilon))
>>> closed_forms((Term(1, 1),), Frame("m", "s"))["c_eq"]
b
"""

from collections.abc import Callable, Sequence

import sympy
from sympy import Expr, Rational, pi

from asymptotics.expansions.moments.symbolic import mean
from asymptotics.frames import Frame
from asymptotics.numbers.bridge import to_sympy
from asymptotics.terms import Term

A, MASS, STIFFNESS = sympy.symbols("A m k", positive=True)
ALPHA = sympy.Symbol("alpha", nonnegative=True)
NAMES = ("zeta", "Q", "decrement", "energy_loss", "c_eq", "half_life")
_a, _x = sympy.symbols("a x", positive=True)
_HALF = Rational(1, 2)
Loss = tuple[Expr, Expr, int]
"""Strength b (epsilon without units), exponent alpha, place m."""


def closed_forms(terms: Sequence[Term], frame: Frame) -> dict[str, Expr]:
    """The six formulas in A, the strengths epsilon (b, m, k with units) and c of the springs; several are numbered."""
    losses, springs = ([t for t in terms if t.sign == side] for side in (-1, 1))
    names = _numbered("b" if frame else "epsilon", len(losses))
    read = [(b, to_sympy(t.velocity), t.position) for b, t in zip(names, losses)]
    cs = _numbered("c", sum(not t.family for t in springs))
    return _forms(read, springs, cs, (MASS, STIFFNESS) if frame else (sympy.Integer(1), sympy.Integer(1)))


def symbolic_exponent(frame: Frame) -> dict[str, Expr]:
    """The formulas of x'|x'|^(alpha-1) beside the linear spring, with a symbol for alpha.

    >>> from asymptotics.frames import BARE
    >>> symbolic_exponent(BARE)["zeta"]
    A**(alpha - 1)*epsilon*gamma(alpha/2 + 1)/(sqrt(pi)*gamma(alpha/2 + 3/2))
    """
    strength = sympy.Symbol("b" if frame else "epsilon", positive=True)
    units = (MASS, STIFFNESS) if frame else (sympy.Integer(1), sympy.Integer(1))
    return _forms([(strength, ALPHA, 0)], [], [], units)


def _numbered(letter: str, count: int) -> list[Expr]:
    if count == 1:
        return [sympy.Symbol(letter, positive=letter != "c", real=True)]
    return [sympy.Symbol(f"{letter}_{i}", positive=letter != "c", real=True) for i in range(1, count + 1)]


def _forms(losses: list[Loss], springs: list[Term], cs: list[Expr], units: tuple[Expr, Expr]) -> dict[str, Expr]:
    m, k = units
    energy, unit = _potential(springs, cs, k, A), _in_well(springs, cs, units)
    parts = [unit(loss) for loss in losses]
    if not springs:
        factors = {"zeta": 1, "decrement": 2 * pi, "energy_loss": 2 * pi * k * A**2, "c_eq": 2 * sympy.sqrt(k * m)}
        found = {name: sum((_tidy(f * z) for z in parts), sympy.Integer(0)) for name, f in factors.items()}
        found["Q"] = _tidy(1 / (2 * parts[0])) if len(parts) == 1 else 1 / (2 * found["zeta"])
    else:
        zeta = sum(parts, sympy.Integer(0))
        lost = 4 * pi * energy * zeta
        viscous = unit((sympy.Integer(1), sympy.Integer(1), 0))
        found = {"zeta": zeta, "Q": 1 / (2 * zeta), "decrement": lost / (A * sympy.diff(energy, A))}
        found |= {"energy_loss": lost, "c_eq": zeta / viscous}
    half = _half_life(losses, found["zeta"], found["energy_loss"], springs, units, energy)
    return {name: found[name] for name in NAMES[:-1]} | {"half_life": half}


def _tidy(e: Expr) -> Expr:
    """A product with each base once."""
    return sympy.powsimp(sympy.expand_power_base(e))


def _potential(springs: list[Term], cs: list[Expr], k: Expr, x: Expr) -> Expr:
    """V(x) for x >= 0; x in rad where the pendulum stands in it."""
    powers = [t for t in springs if not t.family]
    linear = k * (1 - sympy.cos(x)) if len(powers) < len(springs) else k * x**2 / 2
    return linear + sum((c * x ** (t.position + 1) / (t.position + 1) for c, t in zip(cs, powers)), sympy.Integer(0))


def _in_well(springs: list[Term], cs: list[Expr], units: tuple[Expr, Expr]) -> Callable[[Loss], Expr]:
    """A loss -> its zeta."""
    m, k = units
    omega = sympy.sqrt(k / m)
    named = bool(springs and springs[0].family)
    # Neither well of ``straightening``: the integral is shown as it stands.
    if len(springs) > 1 or (springs and not named and springs[0].position != 3):
        return lambda loss: _waiting(loss, springs, cs, units)

    def linear(loss: Loss) -> Expr:
        b, alpha, place = loss
        return mean(place, alpha + 1) * b * omega**alpha / k * A ** (alpha + place - 1)

    def pendulum(loss: Loss) -> Expr:
        b, alpha, place = loss
        if place:
            return _waiting(loss, springs, cs, units)
        sine = sympy.sin(A / 2)
        return linear((b, alpha, 0)).subs(A, 2 * sine) * sympy.hyper((_HALF, _HALF), ((alpha + 3) / 2,), sine**2)

    def duffing(loss: Loss) -> Expr:
        b, alpha, place = loss
        gamma = cs[0] * A**2 / k
        B = 1 + gamma
        wave = sympy.hyper((-alpha / 2, alpha / 2 + 1), ((alpha + place + 3) / 2,), gamma / (2 * B))
        # V(A) = A^2 (1 + gamma/2)/2 is what the linear formula has without the bracket.
        return linear(loss) * B ** (alpha / 2) / (1 + gamma / 2) * wave

    return pendulum if named else duffing if springs else linear


def _waiting(loss: Loss, springs: list[Term], cs: list[Expr], units: tuple[Expr, Expr]) -> Expr:
    """zeta as an integral over a quarter of the orbit."""
    b, alpha, place = loss
    m, k = units
    V = _potential(springs, cs, k, A)
    speed = sympy.sqrt(2 * (V - _potential(springs, cs, k, _x)) / m)
    # Four quarters of the cycle, over 4 pi E.
    return 4 * b * sympy.Integral(_x**place * speed**alpha, (_x, 0, A)) / (4 * pi * V)


def _half_life(
    losses: list[Loss], zeta: Expr, lost: Expr, springs: list[Term], units: tuple[Expr, Expr], energy: Expr
) -> Expr:
    """int da/(-dA/dt) from A/2 to A."""
    m, k = units
    omega = sympy.sqrt(k / m)
    degrees = [alpha + place for _, alpha, place in losses]
    if springs:
        period = _period(springs, units, energy)
        rate = lost / (period * sympy.diff(energy, A))
        return sympy.Integral((1 / rate).subs(A, _a), (_a, A / 2, A))
    if len(losses) == 1:
        # int from A/2 to A of da/(omega zeta(a) a), zeta proportional to a^w; ln 2 is the limit w = 0.
        w = degrees[0] - 1
        if w == 0:
            return _tidy(sympy.log(2) / (omega * zeta))
        return _tidy((2**w - 1) / (w * omega * zeta))
    if len(losses) == 2 and 1 in degrees:
        first = degrees.index(1)
        w = degrees[1 - first] - 1
        # Bernoulli's equation: da/dt = -omega a (viscous + other (a/A)^w), from a = A to A/2.
        viscous, other = (sympy.expand(zeta).coeff(losses[i][0]) * losses[i][0] for i in (first, 1 - first))
        return sympy.log((2**w * viscous + other) / (viscous + other)) / (w * omega * viscous)
    return sympy.Integral((1 / (omega * A * zeta)).subs(A, _a), (_a, A / 2, A))


def _period(springs: list[Term], units: tuple[Expr, Expr], energy: Expr) -> Expr:
    """The period of the motion without loss."""
    m, k = units
    if len(springs) == 1 and springs[0].family:
        theta = sympy.hyper((_HALF, _HALF), (1,), sympy.sin(A / 2) ** 2)
        return 2 * pi * sympy.sqrt(m / k) * theta
    V = energy.subs(A, _x)
    return 4 * sympy.Integral(1 / sympy.sqrt(2 * (energy - V) / m), (_x, 0, A))
