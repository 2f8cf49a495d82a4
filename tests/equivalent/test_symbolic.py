"""The closed forms of equivalent damping against quadrature in mpmath, and what they must not be."""

import mpmath
import pytest
import sympy

from asymptotics.equivalent.symbolic import ALPHA, MASS, NAMES, STIFFNESS, A, closed_forms, symbolic_exponent
from asymptotics.frames import Frame
from asymptotics.law import Law

LAWS = [
    ({1: 1}, None), ({2: 1}, None), ({0: 1}, None), ({"3/2": 1}, None), ({(1, 2): 1}, None), ({(2, 1): 1}, None),
    ({1: 1, 2: 1}, None), ({0: 1, 1: 1}, None), ({0: 1, 2: 1}, None), ({2: 1}, "pendulum"), ({"3/2": 1}, "pendulum"),
    ({2: 1}, {3: 1}), ({(1, 2): 1}, {3: 1}), ({"1/2": 1}, {3: 1}), ({2: 1}, {2: 1}), ({(1, 1): 1}, "pendulum"),
]  # fmt: skip
M, K, C, PLACE = 1.5, 2.0, 0.7, 0.8

SI = Frame("m", "s")


def numbers(forms, digits=20):
    """The six formulas at numbers: m, k, c, A and strengths 0.1, 0.2."""
    symbols = set().union(*(e.free_symbols for e in forms.values()))
    values = {MASS: M, STIFFNESS: K, A: PLACE}
    for s in symbols - set(values):
        values[s] = C if s.name == "c" else 0.2 if s.name.endswith("2") else 0.1
    return {name: float(e.subs(values).evalf(digits)) for name, e in forms.items()}


def potential(spring):
    if spring == "pendulum":
        return (lambda x: K * (1 - mpmath.cos(x))), (lambda x: K * mpmath.sin(x))
    if spring is None:
        return (lambda x: K * x**2 / 2), (lambda x: K * x)
    (p,) = spring
    return (lambda x: K * x**2 / 2 + C * x ** (p + 1) / (p + 1)), (lambda x: K * x + C * x**p)


def by_quadrature(law, spring, place):
    """(zeta, Q, decrement, energy loss, c_eq) and the rate -dA/dt at an amplitude, from the definitions."""
    V, force = potential(spring)
    losses = [(0.1 if i == 0 else 0.2, t) for i, t in enumerate(law.losses)]

    def over(f):  # int_0^A f(x, v) dx with x = A sin(theta)
        def g(theta):
            x = place * mpmath.sin(theta)
            return f(x, mpmath.sqrt(abs(2 * (V(place) - V(x)) / M))) * place * mpmath.cos(theta)

        return mpmath.quad(g, [0, mpmath.pi / 2], method="gauss-legendre", maxdegree=5)

    lost = 4 * over(lambda x, v: sum(b * x**t.position * v ** float(t.velocity.ball()) for b, t in losses))
    E = V(place)
    period = 4 * over(lambda x, v: 1 / v)
    found = lost / (4 * mpmath.pi * E), 2 * mpmath.pi * E / lost, lost / (place * force(place)), lost
    return *found, lost / (4 * over(lambda x, v: v)), lost / (period * force(place))


@pytest.mark.parametrize(("losses", "spring"), LAWS, ids=str)
def test_the_closed_forms_are_their_definitions(losses, spring):
    law = Law(losses, spring=spring)
    found = numbers(closed_forms(law.terms, SI) | {"half_life": sympy.Integer(1)}, 12)
    *expected, _ = by_quadrature(law, spring, PLACE)
    for name, value in zip(NAMES, expected):
        assert found[name] == pytest.approx(float(value), rel=1e-6), name


@pytest.mark.parametrize(("losses", "spring"), [LAWS[i] for i in (0, 1, 2, 3, 6, 7)], ids=str)
def test_the_half_life_is_the_integral_of_the_rate(losses, spring):
    law = Law(losses, spring=spring)
    found = numbers(closed_forms(law.terms, SI))["half_life"]
    with mpmath.workdps(10):
        rate = lambda a: 1 / by_quadrature(law, spring, a)[-1]  # noqa: E731
        expected = mpmath.quad(rate, [PLACE / 2, PLACE], method="gauss-legendre", maxdegree=2)
    assert found == pytest.approx(float(expected), rel=1e-7)


def test_a_symbol_for_the_exponent_gives_each_law():
    forms = symbolic_exponent(SI)
    for alpha in (0, 3):
        own = numbers(closed_forms(Law({alpha: 1}).terms, SI))
        assert numbers({n: e.subs(ALPHA, alpha) for n, e in forms.items()}) == pytest.approx(own, rel=1e-12)


def test_near_misses_are_seen():
    """Energy in place of its double, and the decrement of a half-swing, are off by two."""
    forms = numbers(closed_forms(Law({2: 1}).terms, SI))
    zeta, quality, decrement, *_ = by_quadrature(Law({2: 1}), None, PLACE)
    assert forms["zeta"] != pytest.approx(float(2 * zeta)) and forms["decrement"] != pytest.approx(float(decrement / 2))
    assert forms["Q"] == pytest.approx(float(quality)) and forms["Q"] != pytest.approx(float(1 / zeta))
