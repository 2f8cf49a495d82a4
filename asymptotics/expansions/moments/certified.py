"""M_p = Gamma((p+1)/2)/(sqrt(pi) Gamma(p/2+1)) as a ball, for any real p > -1.

>>> from flint import arb
>>> moment(arb(2)).str(10), (moment(arb(1)) * arb.pi()).str(10)
('[0.5000000000 +/- ...]', '[2.000000000 +/- ...]')
"""

from flint import arb

from asymptotics.errors import InputError


def moment(p: arb) -> arb:
    """An enclosure of M_p at the current precision; InputError if p <= -1, nan if undecided.

    The quotient of Gamma functions is formed from the entire 1/Gamma, so no pole is met for p > -1.
    """
    if p <= -1:
        raise InputError("p", f"{p.str(5)} is not above -1", "p > -1")
    if not p > -1:
        return arb.nan()  # undecided at this precision: an enclosure of everything
    # (p + 1)/2 > 0 keeps away from the poles of Gamma, which stand at 0, -1, -2, ...
    return ((p + 1) / 2).gamma() * (p / 2 + 1).rgamma() / arb.pi().sqrt()


def squaring_ratio(alpha: arb) -> arb:
    """2^(-(alpha+1)/2)/M_(alpha+1), Lelas' damping over the first-order damping, as a ball.

    >>> squaring_ratio(arb(0)).str(10), squaring_ratio(arb(2)).str(10)
    ('[1.110720735 +/- ...]', '[0.8330405509 +/- ...]')
    """
    return arb(2) ** (-(alpha + 1) / 2) / moment(alpha + 1)
