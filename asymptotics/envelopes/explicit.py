"""Several laws, first order: the families in which A(tau) is explicit.  dA/dtau = -sum_i kappa_i A^alpha_i, A(0) = 1.

*Riccati*: exponents among 1-mu, 1, 1+mu for one mu > 0.  v = A^mu obeys dv/dtau = -mu (k_- + k_1 v + k_+ v^2), so

    v = [1 - (2 k_- + k_1) T]/[1 + (k_1 + 2 k_+) T],    T = tanh(mu s tau/2)/s,    s = sqrt(k_1^2 - 4 k_- k_+),

where tanh(y s)/s is an even function of s: tan(y |s|)/|s| for k_1^2 < 4 k_- k_+, y for equality.  This one formula is
Lancaster (13) (one strength alone), his (21) (k_1, k_+ at mu = 1), every pair that contains 1, every pair
(alpha, 2-alpha) such as dry friction with air resistance (0,2), and the triple (0,1,2) of all three.

*Lambert* (Corless, Gonnet, Hare, Jeffrey and Knuth, On the Lambert W function, 1996): two exponents for which y - ln y
is linear in tau, with y > 1 and r = kappa'/kappa,

    (alpha, (1+alpha)/2), alpha < 1:   y = 1 + r A^((1-alpha)/2),   y - ln y = y_0 - ln y_0 - (1-alpha) kappa r^2 tau/2,
    (alpha, 2 alpha-1),   alpha > 1:   y = 1 + A^(1-alpha)/r,       y - ln y = y_0 - ln y_0 + (alpha-1) kappa tau/r,

(for (2,3): kappa^2 tau/kappa'); hence y = -W_(-1)(-exp(-(y - ln y))).  The pair (2,3) is of this kind.

>>> from sympy import Integer, symbols
>>> k1, k2 = symbols("kappa_1 kappa_2", positive=True)
>>> explicit_amplitude({Integer(1): k1, Integer(2): k2})                    # Lancaster (21)
ClosedForm(family='bernoulli', expression=1/((1 + kappa_2/kappa_1)*exp(kappa_1*tau) - kappa_2/kappa_1))
>>> explicit_amplitude({Integer(2): k1, Integer(3): k2}).family
'lambert'
>>> explicit_amplitude({Integer(0): k1, Integer(3): k2})
Traceback (most recent call last):
    ...
asymptotics.errors.InputError: argument law: no explicit A(tau) is known for the exponents 0, 3 (accepted: ...)
"""

from collections.abc import Mapping
from dataclasses import dataclass

from sympy import Expr, LambertW, S, atan, exp, latex, log, sqrt, tan, tanh

from asymptotics.envelopes.symbolic import tau
from asymptotics.errors import InputError
from asymptotics.present.shown import Page, Shown

ACCEPTED = "exponents among 1-mu, 1, 1+mu, or a pair (a, (1+a)/2) with a < 1 or (a, 2a-1) with a > 1"


@dataclass(frozen=True, repr=False)
class ClosedForm(Shown):
    """An explicit expression and the family it belongs to."""

    family: str
    expression: Expr

    def __repr__(self) -> str:
        return f"ClosedForm(family={self.family!r}, expression={self.expression})"

    def _page(self) -> Page:
        return Page(f"A/A(0) = {self.expression}", (f"family {self.family}; exact for the averaged law",))

    def _formula(self) -> str:
        return rf"A/A(0) = {latex(self.expression)}"


def explicit_amplitude(laws: Mapping[Expr, Expr]) -> ClosedForm:
    """A(tau) for {exponent: kappa} with positive kappas and number exponents, as an expression in ``tau``.

    With an exponent below 1 it holds up to ``explicit_extinction``, from where on the averaged amplitude is 0.
    Raises InputError for a set of exponents without a known explicit form.
    """
    exponents = _sorted(laws)
    mu = _riccati_distance(exponents)
    if mu is not None:
        return _riccati(laws, mu)
    if len(exponents) == 2:
        low, high = exponents
        if low < 1 and high == (1 + low) / 2:
            return _lambert_below(low, laws[low], laws[high])
        if low > 1 and high == 2 * low - 1:
            return _lambert_above(low, laws[low], laws[high])
    raise InputError("law", f"no explicit A(tau) is known for the exponents {', '.join(map(str, exponents))}", ACCEPTED)


def explicit_extinction(laws: Mapping[Expr, Expr]) -> Expr | None:
    """Where the explicit A(tau) reaches 0: T (2 k_- + k_1) = 1 (Riccati), y = 1 (Lambert); None if no exponent is < 1.

    >>> from sympy import Integer, symbols
    >>> k0, k2 = symbols("kappa_0 kappa_2", positive=True)
    >>> explicit_extinction({Integer(0): k0, Integer(2): k2})
    atan(sqrt(kappa_2)/sqrt(kappa_0))/(sqrt(kappa_0)*sqrt(kappa_2))
    """
    exponents = _sorted(laws)
    if not exponents[0] < 1:
        return None
    mu = _riccati_distance(exponents)
    if mu is not None:
        return _riccati_extinction(mu, *_strengths(laws, mu))
    low, high = exponents[0], exponents[-1]
    if len(exponents) != 2 or high != (1 + low) / 2:
        raise InputError("law", "no explicit A(tau) is known", ACCEPTED)
    ratio = laws[high] / laws[low]
    return 2 * (ratio - log(1 + ratio)) / ((1 - low) * laws[low] * ratio**2)


def riccati_power(mu: Expr, k_minus: Expr, k_1: Expr, k_plus: Expr, v_0: Expr = S.One) -> Expr:
    """v = A^mu in general: the quotient of the module docstring, started from v(0) = v_0.

    Strengths and mu may be symbols of any kind: s may come out imaginary, v does not.
    """
    s = sqrt(k_1**2 - 4 * k_minus * k_plus)
    T = mu * tau / 2 if s == 0 else tanh(mu * s * tau / 2) / s
    return (v_0 - (2 * k_minus + k_1 * v_0) * T) / (1 + (k_1 + 2 * k_plus * v_0) * T)


def _sorted(laws: Mapping[Expr, Expr]) -> list[Expr]:
    if not laws or any(a.is_number is not True or (a.is_nonnegative is not True) for a in laws):
        raise InputError("law", "the exponents must be numbers", "exponents >= 0 with kappas > 0")
    return sorted(laws)


def _riccati_distance(exponents: list[Expr]) -> Expr | None:
    """mu > 0 with all exponents in {1-mu, 1, 1+mu}; 1 if the exponent is 1 alone; None if there is none."""
    distances = {abs(1 - a) for a in exponents if a != 1}
    if len(distances) > 1:
        return None
    return distances.pop() if distances else S.One


def _strengths(laws: Mapping[Expr, Expr], mu: Expr) -> tuple[Expr, Expr, Expr]:
    return laws.get(1 - mu, S.Zero), laws.get(S.One, S.Zero), laws.get(1 + mu, S.Zero)


def _riccati(laws: Mapping[Expr, Expr], mu: Expr) -> ClosedForm:
    k_minus, k_1, k_plus = _strengths(laws, mu)
    # Here s is imaginary, and the tangent is the real form: dry friction with air resistance, (0,2), is of this kind.
    if k_1 == 0 and k_minus != 0 and k_plus != 0:
        root = sqrt(k_plus / k_minus)
        angle = atan(root) - mu * sqrt(k_minus) * sqrt(k_plus) * tau
        return ClosedForm("tangent", (tan(angle) / root) ** (1 / mu))
    if k_1 == 0:
        base = 1 + mu * k_plus * tau if k_minus == 0 else 1 - mu * k_minus * tau
        return ClosedForm("power", base ** ((-1 if k_minus == 0 else 1) / mu))
    if k_minus == 0:
        ratio = k_plus / k_1
        return ClosedForm("bernoulli", ((1 + ratio) * exp(mu * k_1 * tau) - ratio) ** (-1 / mu))
    if k_plus == 0:
        ratio = k_minus / k_1
        return ClosedForm("bernoulli", ((1 + ratio) * exp(-mu * k_1 * tau) - ratio) ** (1 / mu))
    # All three: which sign k_1^2 - 4 k_- k_+ has is a matter of the numbers, and the quotient holds for either.
    return ClosedForm("riccati", riccati_power(mu, k_minus, k_1, k_plus) ** (1 / mu))


def _riccati_extinction(mu: Expr, k_minus: Expr, k_1: Expr, k_plus: Expr) -> Expr:
    if k_1 == 0 and k_plus == 0:
        return 1 / (mu * k_minus)
    if k_1 == 0:
        return atan(sqrt(k_plus) / sqrt(k_minus)) / (mu * sqrt(k_minus) * sqrt(k_plus))
    if k_plus == 0:
        return log(1 + k_1 / k_minus) / (mu * k_1)
    s = sqrt(k_1**2 - 4 * k_minus * k_plus)
    # v = 0 at T = 1/total, an artanh written as a logarithm: total^2 - s^2 = 4 k_- (k_- + k_1 + k_+) > 0.
    total = 2 * k_minus + k_1
    return 2 / (mu * total) if s == 0 else log((total + s) / (total - s)) / (mu * s)


def _lambert_below(low: Expr, kappa: Expr, kappa_prime: Expr) -> ClosedForm:
    ratio = kappa_prime / kappa
    exponent = -1 - ratio + (1 - low) * kappa * ratio**2 * tau / 2
    # y > 1, hence the branch W_(-1), here and below: on it -W >= 1, while the other one has -W <= 1.
    y = -LambertW(-(1 + ratio) * exp(exponent), -1)
    return ClosedForm("lambert", ((y - 1) / ratio) ** (2 / (1 - low)))


def _lambert_above(low: Expr, kappa: Expr, kappa_prime: Expr) -> ClosedForm:
    ratio = kappa_prime / kappa
    start = 1 + 1 / ratio
    y = -LambertW(-start * exp(-start - (low - 1) * kappa * tau / ratio), -1)
    return ClosedForm("lambert", (ratio * (y - 1)) ** (-1 / (low - 1)))
