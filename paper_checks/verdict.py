"""What can be said of a statement: its kind, whether the printed form holds, and on which evidence.

Verdicts are never booleans: a check answers CONFIRMED, REFUTED or UNDECIDED, and UNDECIDED is never counted as either.

>>> bool(Outcome.CONFIRMED)
Traceback (most recent call last):
    ...
TypeError: an Outcome is not a boolean: compare it with Outcome.CONFIRMED or Outcome.REFUTED
"""

from enum import StrEnum

from flint import arb


class Kind(StrEnum):
    """What sort of statement it is."""

    DEFINITION = "definition"
    IDENTITY = "identity"
    APPROXIMATION = "approximation"
    NUMBER = "number"
    FIGURE = "figure"
    CLAIM = "claim"


class Printed(StrEnum):
    """How the form printed in the paper fares under its stated premises."""

    HOLDS = "holds"
    MISPRINT = "misprint"
    TRANSCRIPTION = "transcription"
    PARTLY = "partly"
    REFUTED = "refuted"
    OPEN = "open"
    DEFINITION = "definition"


class Evidence(StrEnum):
    """What the verdict rests on, from strongest to none."""

    PROVED = "proved"
    CERTIFIED = "certified"
    MEASURED = "measured"
    NONE = "none"


class Outcome(StrEnum):
    """What one run of a check says."""

    CONFIRMED = "confirmed"
    REFUTED = "refuted"
    UNDECIDED = "undecided"

    def __bool__(self) -> bool:
        raise TypeError("an Outcome is not a boolean: compare it with Outcome.CONFIRMED or Outcome.REFUTED")


def balls_agree(a: arb, b: arb, digits: int) -> Outcome:
    """CONFIRMED if two enclosures of one number meet and are both narrow, REFUTED if disjoint, else UNDECIDED.

    Narrow means a radius below 10^-digits of the magnitude: a huge ball cannot pass by overlapping.

    >>> balls_agree(arb(2).sqrt() ** 2, arb(2), 10), balls_agree(arb(2), arb(3), 10), balls_agree(arb(2, 1), arb(2), 10)
    (<Outcome.CONFIRMED: 'confirmed'>, <Outcome.REFUTED: 'refuted'>, <Outcome.UNDECIDED: 'undecided'>)
    """
    if not (a.is_finite() and b.is_finite()):
        return Outcome.UNDECIDED
    if not a.overlaps(b):
        return Outcome.REFUTED
    scale = arb(10) ** -digits * (abs(a.mid()) + abs(b.mid()))
    return Outcome.CONFIRMED if a.rad() <= scale and b.rad() <= scale else Outcome.UNDECIDED
