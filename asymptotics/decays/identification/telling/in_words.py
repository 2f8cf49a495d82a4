"""A law in words, and what it means at the amplitudes of the record: one line each, of known numbers.

>>> in_words({"amplitudes": [10.0, 40.0], "Q": [212.0, 160.0], "half_life": 31.0, "half_life_unit": "s"}, "deg")
'Q = 212 at 10 deg, 160 at 40 deg; half-life 31 s (first order)'
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from asymptotics.decays.identification.forward.candidates import FREE, loss_in_words
from asymptotics.decays.identification.judging.laws import Judged
from asymptotics.decays.identification.telling.equivalents import measured_ends, ratios, shares
from asymptotics.present.percent import percent


def in_words(found: dict[str, Any] | None, unit: str) -> str:
    """Q at both ends of the record and the half-life; empty where they are not known."""
    if found is None:
        return ""
    told = ", ".join(f"{q:.3g} at {f'{a:.3g} {unit}'.strip()}" for q, a in zip(found["Q"], found["amplitudes"]))
    life = f"; half-life {found['half_life']:.3g} {found['half_life_unit']}" if np.isfinite(found["half_life"]) else ""
    return f"Q = {told}{life} (first order)"


def law_in_words(law: Judged) -> str:
    """``viscous drag and drag in v^2, softening spring``, as ``damping --from`` says it."""
    candidate = law.candidate
    exponent = "v^alpha" if law.alpha is None else f"v^{law.alpha.estimate:.3g}"
    losses = [f"drag in {exponent}" if a == FREE else loss_in_words(a, m) for a, m in candidate.losses]
    said = _listed(losses)
    if candidate.pendulum:
        return f"{said}, pendulum"
    if len(candidate.springs) == 1 and law.springs:
        (power,), (strength,) = candidate.springs, law.springs
        stiffness = "hardening" if strength.estimate > 0 else "softening"
        return f"{said}, {f'spring in x^{power}' if strength.contains(0.0) else f'{stiffness} spring'}"
    return f"{said}, springs in {_listed([f'x^{p}' for p in candidate.springs])}" if candidate.springs else said


def shares_in_words(law: Judged, unit: str) -> list[str]:
    """Of each loss its share at the first and the last amplitude; empty where there is one loss, or one gives."""
    if len(law.candidate.losses) < 2 or ratios(law) is None:
        return []
    ends = measured_ends(law)
    found = [shares(law, a) for a in ends]
    if any(f is None for f in found):
        return []
    first, last = ([percent(s) for s in f] for f in found if f is not None)
    at = [f"{a:.3g} {unit}".strip() for a in ends]
    return [f"{one} of the loss at {at[0]}, {other} at {at[1]}" for one, other in zip(first, last)]


def _listed(words: Sequence[str]) -> str:
    return " and ".join(([", ".join(words[:-1])] if len(words) > 1 else []) + [words[-1]])
