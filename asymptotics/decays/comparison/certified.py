"""Certificates of the certified side of a comparison: turning points and states, as the values stand there.

>>> from asymptotics.decays.comparison.run import compare_file
>>> from asymptotics.law_given import Given
>>> found = compare_file({"n": ["1", "2"], "x": ["-0.41", "0.26"]}, Given(Oscillator({2: 1})), digits=8)
>>> print(*found.certificate().proved, sep="\\n")
x'' + 1 x + 1 sgn(x')|x'|^(2) = 0, x(0) = 1, x'(0) = 0
turning point 1: x = -0.41071969 (known to 1e-13)
turning point 2: x = 0.26356839 (known to 1e-12)
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Protocol

from asymptotics.certificates.certificate import Certificate
from asymptotics.certificates.claims import Claim, state_claim
from asymptotics.certificates.of_results import of_claims
from asymptotics.decays.comparison.digits import significant
from asymptotics.errors import InputError
from asymptotics.law import Oscillator
from asymptotics.running.budget import DEFAULT_SECONDS


class Valued(Protocol):
    """A value beside the certified one."""

    @property
    def key(self) -> str:
        """The number of a turning point, or a time."""

    @property
    def key_name(self) -> str:
        """n, tau or t."""

    @property
    def column(self) -> str:
        """x, v, amplitude, tau or t."""

    @property
    def certified(self) -> str | None:
        """In decimals; None where there is no such value."""


@dataclass(frozen=True)
class MotionBeside:
    """The motion whose values stand in a comparison, in its own units: x in those of its start, t in its time."""

    oscillator: Oscillator

    def certificate(self, rows: Sequence[Valued], *, max_seconds: float = DEFAULT_SECONDS) -> Certificate:
        """Of all rows; what is neither place nor time nor speed of the motion is told in ``left``."""
        places: dict[str, dict[str, str]] = {}
        left: dict[str, None] = {}
        for row in rows:
            if row.certified is None:
                continue
            if (name := self._claimed(row)) is None:
                left[f"{row.column}: of the averaged law, or in other units than x and t"] = None
                continue
            places.setdefault(row.key, {})[name] = row.certified
        if not places:
            raise InputError("certificate", "; ".join(left) or "there is no value", "turning points, x and v at times")
        of_key = self._turned if rows[0].key_name == "n" else _state
        made = of_claims(self.oscillator, [of_key(*each) for each in places.items()], max_seconds=max_seconds)
        return replace(made, left=(*made.left, *left))

    def _claimed(self, row: Valued) -> str | None:
        """What the value is called in a claim."""
        if row.key_name != "n":
            return row.column if row.column in ("x", "v") else None
        # tau is a time of this motion where omega_0 is 1.
        same = self.oscillator.stiffness == self.oscillator.mass
        names = {"x": "x", "amplitude": "size", "t": "t", **({"tau": "t"} if same else {})}
        return names.get(row.column)

    def _turned(self, key: str, found: dict[str, str]) -> Claim:
        n, x = int(key), found.get("x")
        if x is None and "size" in found:
            negative = (n % 2 == 1) == (self.oscillator.x0 > 0)
            x = f"-{found['size']}" if negative and found["size"] != "0" else found["size"]
        digits = max(map(significant, found.values()))
        return {"kind": "turning point", "number": n, "digits": max(1, digits), "x": x, "t": found.get("t")}


def _state(key: str, found: dict[str, str]) -> Claim:
    digits = max(map(significant, found.values()))
    return state_claim(Fraction(key), found.get("x"), found.get("v"), max(1, digits))
