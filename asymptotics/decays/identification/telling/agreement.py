"""What all laws of a verdict say of Q and the half-life: they agree where the data are, whichever of them is true."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import isfinite, pi, sqrt
from typing import Any

from asymptotics.decays.identification.judging.laws import Judged
from asymptotics.decays.identification.telling.equivalents import half_life, measured_ends, omega_of, ratios
from asymptotics.decays.identification.telling.record_units import RecordUnits


@dataclass(frozen=True)
class Agreement:
    """``quality``: (amplitude, least Q, largest Q) of the ``laws`` at three amplitudes; ``half_life`` (in s, or in
    swings without times) from the first: the least and the largest."""

    laws: tuple[str, ...]
    unit: str
    quality: tuple[tuple[float, float, float], ...]
    half_life: tuple[float, float] | None
    half_life_unit: str

    def __str__(self) -> str:
        told = ", ".join(f"{_span(low, high)} at {f'{a:.3g} {self.unit}'.strip()}" for a, low, high in self.quality)
        life = "" if self.half_life is None else f"; half-life {_span(*self.half_life)} {self.half_life_unit}"
        who = "both" if len(self.laws) == 2 else f"all {len(self.laws)}"
        return f"{who} laws say: Q = {told}{life} (first order)"

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready: numbers are strings."""
        rows = [{"amplitude": f"{a:.6g}", "low": f"{low:.6g}", "high": f"{high:.6g}"} for a, low, high in self.quality]
        low, high = self.half_life or (None, None)
        life = None if low is None or high is None else {"low": f"{low:.6g}", "high": f"{high:.6g}"}
        return {"laws": list(self.laws), "quality": rows, "half_life": life, "half_life_unit": self.half_life_unit}


def agreed(laws: Sequence[Judged], units: RecordUnits) -> Agreement | None:
    """Of two laws and more; None where some of them has no Q."""
    known = [ratios(law) for law in laws]
    if len(laws) < 2 or any(k is None for k in known):
        return None
    both = [k for k in known if k is not None]
    first, last = measured_ends(laws[0])
    rows = []
    for amplitude in (first, sqrt(first * last), last):
        zetas = [float(zeta(amplitude)) for zeta, _ in both]
        if not all(isfinite(z) and z > 0 for z in zetas):
            return None
        rows.append((amplitude, 0.5 / max(zetas), 0.5 / min(zetas)))
    omegas = [omega_of(law) or units.omega_0 for law in laws]
    lives = [half_life(rate, first) / (omega or 2 * pi) for (_, rate), omega in zip(both, omegas, strict=True)]
    finite = all(isfinite(life) for life in lives)
    names = tuple(str(law.candidate) for law in laws)
    unit = "s" if all(omegas) else "swings"
    return Agreement(names, units.shown, tuple(rows), (min(lives), max(lives)) if finite else None, unit)


def _span(low: float, high: float) -> str:
    one, other = f"{low:.3g}", f"{high:.3g}"
    return one if one == other else f"{one} to {other}"
