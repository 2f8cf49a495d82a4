"""Several laws with an explicit A(tau): substitution into the averaged law, quadrature, extinction, refusals."""

import mpmath
import pytest
import sympy
from mpmath import mp
from sympy import Integer, Rational, diff, simplify, symbols

from asymptotics.envelopes.explicit import explicit_amplitude, explicit_extinction, riccati_power
from asymptotics.envelopes.symbolic import tau
from asymptotics.errors import InputError

SETS = {  # exponents -> family
    (0,): "power",
    (3,): "power",
    (1,): "bernoulli",
    (0, 1): "bernoulli",
    (1, 2): "bernoulli",
    (1, 3): "bernoulli",
    (Rational(1, 2), 1): "bernoulli",
    (1, Rational(5, 2)): "bernoulli",
    (0, 2): "tangent",
    (Rational(1, 2), Rational(3, 2)): "tangent",
    (0, 1, 2): "riccati",
    (Rational(1, 2), 1, Rational(3, 2)): "riccati",
    (2, 3): "lambert",
    (Rational(3, 2), 2): "lambert",
    (3, 5): "lambert",
    (0, Rational(1, 2)): "lambert",
    (Rational(1, 2), Rational(3, 4)): "lambert",
}
STRENGTHS = (Rational(1, 10), Rational(3, 20), Rational(1, 4))


def laws_of(exponents, strengths=STRENGTHS):
    return {sympy.sympify(a): k for a, k in zip(exponents, strengths)}


def quadrature(laws, A):
    pairs = [(mp.mpf(a.p) / a.q, mp.mpf(k.p) / k.q) for a, k in laws.items()]
    return mpmath.quad(lambda a: 1 / sum(k * a**e for e, k in pairs), [A, (A + 1) / 2, 1])


@pytest.mark.parametrize(("exponents", "family"), SETS.items())
def test_explicit_amplitude_inverts_the_quadrature(exponents, family):
    laws = laws_of(exponents)
    closed = explicit_amplitude(laws)
    assert closed.family == family
    value = sympy.lambdify(tau, closed.expression, "mpmath")
    with mp.workdps(30):
        for A in (mp.mpf(9) / 10, mp.mpf(1) / 3, mp.mpf(1) / 50):
            t = quadrature(laws, A)
            assert abs(value(t) - A) < 1e-24
            assert abs(value(t * mp.mpf("1.000001")) - A) > 1e-9  # near miss


@pytest.mark.parametrize("exponents", [e for e in SETS if 0 <= e[0] < 1])
def test_extinction(exponents):
    laws = laws_of(exponents)
    end = explicit_extinction(laws).evalf(30)
    pairs = [(mp.mpf(a.p) / a.q, mp.mpf(k.p) / k.q) for a, k in sorted(laws.items())]
    below = 1 - pairs[0][0]
    with mp.workdps(25):  # a = u^(1/below) takes the algebraic singularity away

        def integrand(u):
            a = u ** (1 / below)
            return 1 / (below * sum(k * a ** (e - pairs[0][0]) for e, k in pairs))

        assert abs(mpmath.quad(integrand, [0, 0.01, 1]) - mp.mpf(str(end))) < 1e-12
    assert abs(sympy.N(explicit_amplitude(laws).expression.subs(tau, end * (1 - sympy.Float("1e-9", 30))))) < 1e-4


@pytest.mark.parametrize("exponents", [(0, 1), (1, 2), (1, 3), (1, Rational(5, 2)), (2,), (0, 2)])
def test_substitution(exponents):
    kappas = symbols("kappa_1:4", positive=True)
    laws = laws_of(exponents, kappas)
    A = explicit_amplitude(laws).expression
    # v = A^mu is a rational function of exp or tan: A^(alpha-1) = v^((alpha-1)/mu) stays an integer power of it
    mu = max(abs(a - 1) for a in laws)
    v = sympy.powdenest(A**mu, force=True)
    assert simplify(diff(v, tau) / mu + sum(k * v ** (1 + (a - 1) / mu) for a, k in laws.items())) == 0
    assert simplify(diff(v, tau) / mu + sum(2 * k * v ** (1 + (a - 1) / mu) for a, k in laws.items())) != 0


def test_riccati_is_the_master_formula():
    mu, a, b, c, v_0 = symbols("mu a b c v_0", positive=True)
    v = riccati_power(mu, a, b, c, v_0)
    assert simplify((diff(v, tau) + mu * (a + b * v + c * v**2)).rewrite(sympy.exp)) == 0
    assert simplify(riccati_power(mu, 0, 0, c) - 1 / (1 + mu * c * tau)) == 0  # Lancaster (13)
    assert simplify((riccati_power(mu, 0, b, 0) - sympy.exp(-mu * b * tau)).rewrite(sympy.exp)) == 0
    assert simplify(riccati_power(mu, 1, 2, 1) - (1 - 2 * mu * tau) / (1 + 2 * mu * tau)) == 0  # equal roots


def test_lancaster_21_and_22():
    c, c_prime, x_0, tau_k = symbols("c c_prime x_0 T", positive=True)  # T = t/(pi k): the paper's time
    lam = x_0 / (c + c_prime * x_0)
    printed = c * lam * sympy.exp(-c * tau_k) / (1 - lam * c_prime * sympy.exp(-c * tau_k))
    assert simplify(diff(printed, tau_k) + c * printed + c_prime * printed**2) == 0
    ours = explicit_amplitude({Integer(1): c, Integer(2): c_prime * x_0}).expression
    assert simplify(x_0 * ours.subs(tau, tau_k) - printed) == 0


def test_refusals():
    for exponents in [(0, 3), (0, Rational(3, 2)), (1, 2, 3), (0, 1, 3)]:
        with pytest.raises(InputError, match="no explicit"):
            explicit_amplitude(laws_of(exponents))
    with pytest.raises(InputError, match="exponents"):
        explicit_amplitude({symbols("a"): Integer(1)})
    with pytest.raises(InputError, match="law"):
        explicit_amplitude({})
    assert explicit_extinction(laws_of((1, 2))) is None
    assert "tan" in explicit_amplitude(laws_of((0, 2)))._repr_latex_()
