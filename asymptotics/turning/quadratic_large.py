"""The half period for large amplitudes (alpha = 2): an expansion in y = 1 + p = 1 + 2|u_n| with exact coefficients.

From the top of a violent swing the mass falls towards u = -1/2, where quadratic drag balances the spring.  In the
quadrature 2 w^2 = y - t - y e^(-t) (``quadratic_duration``) the term e^(-t) matters only for t = O(1), and

    T ~ sqrt(2) ( sqrt(y) + sum_(k>=0) a_k y^(-k-1/2) ),    a_k = C(2k, k) 4^-k / 2 * K_k,
    K_k = int_0^inf t^k ((1 - e^(-t))^(-k-1/2) - 1) dt = (-d/ds)^k (B(s, 1/2-k) - 1/s) at s = 0.

The first coefficient is a_0 = log 2.  The expansion is formal here: asymptotic, with an error O(y^(-N-1/2)) after N
coefficients that the tests measure, not an enclosure.

>>> large_amplitude_coefficient(0)
log(2)
>>> float(large_amplitude_half_period(2, sympy.Integer(401)))   # the certified quadrature gives 28.36930...
28.3...
"""

import sympy


def large_amplitude_coefficient(k: int) -> sympy.Expr:
    """a_k in closed form: a polynomial in log 2, pi^2, zeta(3), ... with rational coefficients."""
    s = sympy.Symbol("s")
    order = k + 1
    exponent = sum(
        (s**j / sympy.factorial(j) * (_polygamma(j - 1, 0) - _polygamma(j - 1, k + 1)) for j in range(1, order + 1)),
        sympy.Integer(0),
    )  # log of Gamma(1+s) Gamma(1/2-k) / Gamma(1/2-k+s)
    beta = sum((exponent**j / sympy.factorial(j) for j in range(order + 1)), sympy.Integer(0))
    moment = (-1) ** k * sympy.factorial(k) * sympy.expand(beta).coeff(s, order)
    return sympy.expand(sympy.binomial(2 * k, k) / sympy.Integer(4) ** k / 2 * moment)


def _polygamma(m: int, shift: int) -> sympy.Expr:
    """psi^(m) at 1 for shift 0, at 1/2 - k for shift k + 1, without Euler's constant (it cancels)."""
    zeta = (-1) ** (m + 1) * sympy.factorial(m) * sympy.zeta(m + 1) if m else sympy.Integer(0)
    if shift == 0:
        return zeta
    at_half = zeta * (2 ** (m + 1) - 1) if m else -2 * sympy.log(2)
    steps = [sympy.Rational(1 - 2 * j, 2) for j in range(1, shift)]  # psi(x) = psi(x+1) - 1/x
    return at_half - (-1) ** m * sympy.factorial(m) * sum((1 / x ** (m + 1) for x in steps), sympy.Integer(0))


def large_amplitude_half_period(terms: int, y: sympy.Expr) -> sympy.Expr:
    """The expansion with ``terms`` coefficients a_k at y = 1 + 2|u_n|."""
    tail = [large_amplitude_coefficient(k) * y ** (-k - sympy.Rational(1, 2)) for k in range(terms)]
    return sympy.sqrt(2) * (sympy.sqrt(y) + sympy.Add(*tail))
