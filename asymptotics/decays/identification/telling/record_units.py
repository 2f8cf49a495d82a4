"""What is known of the oscillator beside its record, and the units in which strengths follow from it."""

from dataclasses import dataclass, replace

from asymptotics.decays.identification.fitting.profile import Interval
from asymptotics.numbers.quantities import ANGLES, LENGTHS


@dataclass(frozen=True)
class RecordUnits:
    """What is known of the oscillator beside the record: mass, stiffness, omega_0 (SI), and the unit of x in SI;
    ``written``: as the file has it, which may be none of those that are known, such as V."""

    unit: str = ""
    size: float = 1.0
    mass: float | None = None
    stiffness: float | None = None
    omega_0: float | None = None
    written: str = ""

    @property
    def shown(self) -> str:
        """The unit of x as it is told: one that is known, or the one that the file writes."""
        return self.unit or self.written

    def physical(self, alpha: float, position: int, epsilon: Interval) -> tuple[str, Interval] | None:
        """(name, interval) of b or b/m in SI: b/m = epsilon omega_0^(2-alpha) (unit of x)^(1-alpha-m)."""
        omega = self.omega_0
        if omega is None or not self.unit:
            return None
        # x'' + omega_0^2 x + (b/m) |x|^m x'|x'|^(alpha - 1) = 0 in SI, scaled to the unit of x and the time omega_0 t.
        factor = omega ** (2 - alpha) * self.size ** (1 - alpha - position)
        name = "b/m"
        if self.mass is not None:
            name, factor = "b", factor * self.mass
        low, high = (None if v is None else v * factor for v in (epsilon.low, epsilon.high))
        return name, Interval(low, epsilon.estimate * factor, high)

    def beside(self, alpha: float, position: int, epsilon: Interval) -> tuple[str, Interval, str] | None:
        """(name, interval, unit) of b or b/m as far as the units are known: where that of x is none, in units of x."""
        known = self if self.unit else replace(self, unit="m")
        found = known.physical(alpha, position, epsilon)
        length = "rad" if self.unit in ANGLES else "m" if self.unit in LENGTHS else _word(self.written)
        return None if found is None else (*found, unit_of_strength(alpha, position, length, self.mass is not None))


def _word(written: str) -> str:
    """A unit of the file as a factor of another one; that of x where there is none."""
    return written if written.isalpha() else f"({written or 'unit of x'})"


def unit_of_strength(alpha: float, position: int, length: str, mass: bool) -> str:
    """The unit of b/m, or of b, in F = b |x|^position v |v|^(alpha - 1).

    >>> [unit_of_strength(a, 0, "m", False) for a in (0, 1, 2, 3, 1.5)]
    ['m/s^2', '1/s', '1/m', 's/m^2', '1/(m^0.5 s^0.5)']
    >>> unit_of_strength(1, 0, "m", True), unit_of_strength(0, 0, "m", True), unit_of_strength(2, 0, "rad", False)
    ('kg/s', 'N', '1/rad')
    """
    powers = {"kg": float(mass), length: 1 - alpha - position, "s": alpha - 2}
    above = [_power(unit, p) for unit, p in powers.items() if p > 0]
    below = [_power(unit, -p) for unit, p in powers.items() if p < 0]
    under = f"({' '.join(below)})" if len(below) > 1 else "".join(below)
    said = " ".join(above or ["1"]) + (f"/{under}" if below else "")
    return said.replace("kg m/s^2", "N")


def _power(unit: str, power: float) -> str:
    return unit if power == 1 else f"{unit}^{power:g}"
