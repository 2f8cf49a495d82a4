"""A share in percent, in digits and never with an exponent; one that means nothing any more is told as below a limit.

>>> [percent(share) for share in (0.031, 0.9963, 1.7, 12.3, 1.2e-5, 0.0)]
['3.1 %', '100 %', '170 %', '1230 %', '0.0012 %', '0 %']
>>> percent(8.9e-14), percent(-2e-9), percent(-0.031)
('below 0.001 %', 'below 0.001 %', '-3.1 %')
>>> at_most(0.031), at_most(8.9e-14)
('at most 3.1 %', 'below 0.001 %')
"""

from decimal import Decimal

_MEANT = 1e-3
"""Percent: no loss is measured so well, and no motion is resolved so finely, that less of it could be told from none.
A choice."""


def percent(share: float) -> str:
    """To two significant digits, whole where that is more; ``share``: of 1."""
    value = 100 * share
    if 0 < abs(value) < _MEANT:
        return f"below {_MEANT:g} %"
    # The g format has an exponent from 99.5 on and below 0.0001; that of a Decimal by f never.
    return f"{value:.0f} %" if value >= 99.5 else f"{Decimal(f'{value:.2g}'):f} %"


def at_most(share: float) -> str:
    """The same as a bound, ``share`` of 1."""
    said = percent(share)
    return said if said.startswith("below") else f"at most {said}"
