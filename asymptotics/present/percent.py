"""A share in percent, in digits and never with an exponent.

>>> [percent(share) for share in (0.031, 0.9963, 1.7, 12.3, 1e-6, 0.0)]
['3.1 %', '100 %', '170 %', '1230 %', '0.0001 %', '0 %']
"""

from decimal import Decimal


def percent(share: float) -> str:
    """To two significant digits, whole where that is more; ``share``: of 1."""
    value = 100 * share
    # The g format has an exponent from 99.5 on and below 0.0001; that of a Decimal by f never.
    return f"{value:.0f} %" if value >= 99.5 else f"{Decimal(f'{value:.2g}'):f} %"
