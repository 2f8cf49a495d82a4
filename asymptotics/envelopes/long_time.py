"""How an averaged amplitude ends, as a formula: the extinction for an exponent below 1, else the law at long times.

The smallest exponent rules.  With alpha the smallest, kappa its strength, A(0) = 1 and tau = omega_0 t:

    alpha > 1   A ~ [(alpha-1) kappa tau]^(-1/(alpha-1)): the start and all other laws are forgotten
    alpha = 1   A ~ C exp(-kappa tau), C = (1 + kappa'/kappa)^(-1/(alpha'-1)) beside one other law alpha' (Lancaster
                2020, (22) is alpha' = 2), C = 1 alone
    alpha < 1   A = 0 from tau_e on: of the averaged law; the motion itself creeps or sticks

For alpha > 1, whatever the other laws: d(A^(1-alpha))/dtau = (alpha-1) kappa (1 + o(1)) as A -> 0.

>>> from sympy import Integer, Rational, symbols
>>> k, c, e = symbols("kappa_1 kappa_2 kappa_3", positive=True)
>>> long_time({Integer(2): k, Integer(3): c, Integer(4): e}), long_time({Integer(1): k, Integer(2): c})
(1/(kappa_1*tau), exp(-kappa_1*tau)/(1 + kappa_2/kappa_1))
>>> extinction({Rational(1, 2): k}), extinction({Integer(1): k})
(2/kappa_1, None)
"""

from collections.abc import Mapping

from sympy import Expr, S, exp

from asymptotics.envelopes.explicit import explicit_extinction
from asymptotics.envelopes.hypergeometric import extinction_time, long_time_amplitude
from asymptotics.envelopes.symbolic import held_power, tau
from asymptotics.errors import InputError

Laws = Mapping[Expr, Expr]


def extinction(laws: Laws) -> Expr | None:
    """tau_e for {exponent: kappa}, elementary or by 2F1; None where A never vanishes, and where no formula is known."""
    pairs = sorted(laws.items(), key=lambda law: law[0])
    alpha, kappa = pairs[0] if pairs else (S.One, S.Zero)
    if alpha >= 1:
        return None
    if len(pairs) == 1:
        return 1 / ((1 - alpha) * kappa)
    try:
        return explicit_extinction(laws)
    # No A(tau) in closed form: the time of two laws is known by 2F1 all the same.
    except InputError:
        return extinction_time(pairs[0], pairs[1]) if len(pairs) == 2 else None


def long_time(laws: Laws) -> Expr | None:
    """The leading A(tau) for tau -> infinity; None for an exponent below 1, and where the constant is not known."""
    pairs = sorted(laws.items(), key=lambda law: law[0])
    alpha, kappa = pairs[0] if pairs else (S.Zero, S.Zero)
    if alpha < 1:
        return None
    if len(pairs) == 2:
        return long_time_amplitude(pairs[0], pairs[1], tau)
    if alpha > 1:
        return held_power((alpha - 1) * kappa * tau, -1 / (alpha - 1))
    # Beside a linear loss and two more the constant C is an integral that has no name here.
    return exp(-kappa * tau) if len(pairs) == 1 else None
