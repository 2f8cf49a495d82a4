"""What a certificate says: turning points, states at times and the stop, as they were printed.

>>> from asymptotics.turning.result import TurningPoint
>>> turning_claim(TurningPoint(1, "-0.8702", "3.146"), 4)
{'kind': 'turning point', 'number': 1, 'digits': 4, 'x': '-0.8702', 't': '3.146'}
>>> round(error_allowed([turning_claim(TurningPoint(1, "-0.8702", "3.146"), 4)], 1.0), 2)
-20.29
"""

from collections.abc import Iterable
from decimal import Decimal
from fractions import Fraction
from math import log2
from typing import Any, Protocol

Claim = dict[str, Any]
_SHARE = 7  # bits below a unit of the last digit: where a rounding is closer, the certificate is made again
_LOG2_10 = log2(10)


class Turned(Protocol):
    """A printed turning point without units."""

    @property
    def n(self) -> int:
        """Its number."""

    @property
    def x(self) -> str:
        """Its place."""

    @property
    def time(self) -> str | None:
        """Its time, where it was asked for."""


def turning_claim(point: Turned, digits: int) -> Claim:
    """The place of a turning point, and its time if it was printed (tau, or t in s)."""
    time = point.time
    return {"kind": "turning point", "number": point.n, "digits": digits, "x": point.x, "t": time}


def rest_claim(number: int) -> Claim:
    """That the mass stays at that turning point for ever."""
    return {"kind": "rest", "number": number}


def state_claim(t: Fraction, x: str | None, v: str | None, digits: int) -> Claim:
    """The state at an exact time since the start."""
    return {"kind": "state", "digits": digits, "t": str(t), "x": x, "v": v}


def error_allowed(claims: Iterable[Claim], stiffness: float) -> float:
    """log2 of an error of the motion with which all claims should be shown: a guess that the checker confirms."""
    sizes = [0.0]
    for claim in claims:
        for name in {"turning point": ("x", "t"), "state": ("x", "v")}.get(claim["kind"], ()):
            if claim[name] is None or Decimal(claim[name]) == 0:
                continue
            unit = (Decimal(claim[name]).adjusted() - claim["digits"] + 1) * _LOG2_10
            # A turning point is as early or late as the error over the acceleration.
            place = 0.0 if name != "t" or claim["x"] is None else float(claim["x"])
            late = log2(stiffness * abs(place)) if place else 0.0
            sizes.append(unit + min(0.0, late))
    return min(sizes) - _SHARE


def exact_time(claim: Claim) -> Fraction:
    """The time of a state."""
    return Fraction(claim["t"])


def last_number(claims: Iterable[Claim]) -> int:
    """The number of the last turning point that is claimed, -1 for none."""
    return max((claim["number"] for claim in claims if "number" in claim), default=-1)
