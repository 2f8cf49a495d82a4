"""Two sets of equations compared by what can be observed, and equations against a user's function.

Coefficients of different gauges differ and are all right; turning amplitudes and times must agree.  A user's function
is compared in the gauge of the equations, at amplitudes that fall: the power of the amplitude (delta) with which the
difference falls is the order at which the two part.

>>> from asymptotics.expansions.equations.build import expand
>>> eq = expand({3: "1/10"}, order=4)
>>> print(eq.compare(expand({3: "1/10"}, order=4, gauge="averaging")))
turning-point order 4 against averaging order 4: agree within the estimated errors
>>> print(eq.compare(lambda A, psi: (-3 / 80 * A**3, 1.0)))            # first order only: the phase differs from A^4 on
function: dA/dtau differs from A^7.0 on, dpsi/dtau differs from A^4.0 on
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import isfinite, log
from typing import Any

from asymptotics.errors import InputError
from asymptotics.expansions.equations.observables import Observables
from asymptotics.present.shown import Page, Shown

_NAMES = ("half_period", "amplitude_ratio", "decrement", "energy_loss")


@dataclass(frozen=True, repr=False)
class EquationsComparison(Shown):
    """``agree``: within the estimated errors (None where that cannot be said); ``differences`` by name; ``text``."""

    agree: bool | None
    differences: dict[str, float]
    text: str

    def __str__(self) -> str:
        return self.text

    def _page(self) -> Page:
        rows = tuple((name, f"{gap:.3g}") for name, gap in self.differences.items())
        return Page(self.text, ("estimates, in doubles",), ("", "difference"), rows)


def compare_rows(mine: Observables, theirs: Observables, mine_name: str, their_name: str) -> EquationsComparison:
    """The observables of two sets of equations at the same turning amplitude."""
    differences, apart = {}, []
    for name in _NAMES:
        a, b = getattr(mine, name), getattr(theirs, name)
        differences[name] = abs(a.value - b.value)
        if differences[name] > a.error + b.error:
            apart.append(name)
    verdict = f"differ in {', '.join(apart)}" if apart else "agree within the estimated errors"
    return EquationsComparison(not apart, differences, f"{mine_name} against {their_name}: {verdict}")


def compare_functions(
    rates: Callable[..., tuple[Any, Any]], other: Callable[..., Any], A: float
) -> EquationsComparison:
    """``rates`` against a user's (A, psi) -> (dA/dtau, dpsi/dtau), at A and A/2."""
    # At A/4 and A/8 the lowest power rules: the quotient of the two gaps is 2 to that power.
    gaps = [_differences(rates, other, A / 2**i) for i in (2, 3)]
    differences = dict(zip(("dA/dtau", "dpsi/dtau"), _differences(rates, other, A)))
    parts = []
    for (name, at), wide, narrow in zip(differences.items(), *gaps):
        # Fifty units of the last place of a rate near 1: rounding, and no difference.
        if at < 1e-14:
            parts.append(f"{name} agrees")
        elif wide and narrow:
            parts.append(f"{name} differs from A^{log(wide / narrow) / log(2):.1f} on")
        else:
            parts.append(f"{name} differs by {at:.1e}")
    # Agreement can be said of a function; that it differs may be its purpose (another order, another gauge).
    agree = True if max(differences.values()) < 1e-14 else None
    return EquationsComparison(agree, differences, f"function: {', '.join(parts)}")


def _differences(rates: Callable[..., tuple[Any, Any]], other: Callable[..., Any], A: float) -> tuple[float, float]:
    try:
        mine, theirs = rates(A, 0.0), other(A, 0.0)
        found = abs(float(mine[0]) - float(theirs[0])), abs(float(mine[1]) - float(theirs[1]))
    # What a user's function of another shape raises; anything else is its own affair and goes through.
    except (TypeError, ValueError, IndexError) as error:
        raise InputError("other", f"the function failed: {error}", "(A, psi) -> (dA/dtau, dpsi/dtau)") from None
    if not all(isfinite(x) for x in found):
        raise InputError("other", "the function gives no finite number", "(A, psi) -> (dA/dtau, dpsi/dtau)")
    return found
