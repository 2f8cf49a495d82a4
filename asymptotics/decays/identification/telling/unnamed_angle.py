"""A pendulum in a file that names no unit: the spring of the law is that of sin x = x - x^3/6 + ... in some angle."""

from asymptotics.decays.identification.judging.laws import Judged
from asymptotics.decays.records.units import UNITS
from asymptotics.numbers.quantities import ANGLES

_SHARP, _NEAR = 0.1, 0.05
"""The width of the interval of the spring, as a share of it, above which it is near that of anything; and how near: of
angles to 0.7 rad x^5/120, if it is left out, makes x^3/6 less by 2 %."""


def unnamed_angle(law: Judged, unit: str) -> list[str]:
    """That the spring of the first law is a pendulum's in some unit of angle, where no ``unit`` is known."""
    if unit or law.verdict != "consistent" or law.candidate.springs[:1] != (3,) or not law.springs:
        return []
    c = law.springs[0]
    if c.low is None or c.high is None or not c.high - c.low < _SHARP * abs(c.estimate):
        return []
    found = [angle for angle in ANGLES if abs(-6 * c.estimate / UNITS[angle] ** 2 - 1) < _NEAR]
    said = f"{law.candidate}: its spring is that of a pendulum in {' or '.join(found)}, where sin x is x - x^3/6"
    return [f"{said}: --unit {found[0]} tries the pendulum itself"] if found else []
