"""What is known of the rates of the open hierarchy: closed forms, and certified digits where the exponents are numbers.

Closed, in the turning-point gauge: the first and second order of any sum of losses x'|x'|^(alpha-1) and springs
c x|x|^(p-1) (``powers``), and p_3, Omega_4 of one such loss (``normal_form.symbolic``), Omega_4 with the integral
I_4(alpha).  Everything else that is a number comes from the certified half-swing.

>>> from sympy import Rational
>>> p, Omega, through = closed_rates((Rational(3, 2),), (), 4)
>>> p[3,].evalf(20), certified_rates([Term(1, "3/2")], 3)[0][3,].evalf(20)
(0.0016147792023822891647, 0.0016147792023822891647)
"""

from collections.abc import Sequence

from sympy import Expr, Float

from asymptotics.expansions.half_swings.symbolic import alpha
from asymptotics.expansions.multiple_scales.powers import Powers
from asymptotics.expansions.normal_form.digits import certified_digits
from asymptotics.expansions.normal_form.symbolic import symbolic_expansion
from asymptotics.gauges import TURNING_POINT
from asymptotics.series import Key
from asymptotics.terms import Term

Rates = dict[Key, Expr]
# Of the numbers that are shown beside the integrals; each is rounded correctly.
DIGITS = 30


def closed_rates(alphas: tuple[Expr, ...], terms: tuple[Term, ...], order: int) -> tuple[Rates, Rates, int]:
    """The coefficients of p and Omega known in closed form through ``order``, and the order through which all are."""
    # ``powers`` knows losses of the velocity alone and springs of the place alone.
    if any(t.sign < 0 or not t.velocity.is_zero for t in terms):
        return {}, {}, 0
    powers = Powers(alphas, terms)
    p, Omega = ({k: c for k, c in row.items() if sum(k) <= order} for row in _second_order(powers))
    alone = len(alphas) == 1 and not terms
    if alone and order > 2:
        found = symbolic_expansion()
        p |= {(k,): c.subs(alpha, alphas[0]) for k, c in found["p"].items() if 2 < k <= order}
        Omega |= {(k,): c.subs(alpha, alphas[0]) for k, c in found["Omega"].items() if 2 < k <= order}
    # A coefficient that is identically 0 is left out, and counts as known through the order that is told.
    rows = ({k: c for k, c in row.items() if c != 0} for row in (p, Omega))
    return (*rows, min(order, 4 if alone else 2))  # type: ignore[return-value]


def _second_order(powers: Powers) -> tuple[Rates, Rates]:
    return powers.p(TURNING_POINT), powers.Omega(TURNING_POINT)


def certified_rates(terms: Sequence[Term], order: int, digits: int = DIGITS) -> tuple[Rates, Rates]:
    """All coefficients through ``order``, correctly rounded and proved to be, as SymPy numbers of that precision."""
    found = certified_digits(terms, order, digits, names=("p", "Omega"))
    rows = ({k: Float(text, digits) for k, text in found[name].items() if text != "0"} for name in ("p", "Omega"))
    p, Omega = rows
    return p, Omega
