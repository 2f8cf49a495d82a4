"""How V_(k+2)/V_k grows beside its law, for the table of the report: in floats, heuristic.

>>> from asymptotics.expansions.normal_form.expansion import exact_expansion
>>> [(k, round(ratio, 3)) for k, ratio in growth_ratios(exact_expansion((3,), 31))][-3:]
[(26, 0.883), (28, 0.892), (30, 0.899)]
"""

from typing import Any

from flint import arb

from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.pi_ring import PiNumber
from asymptotics.expansions.normal_form.expansion import Expansion


def growth_ratios(expansion: Expansion) -> list[tuple[int, float]]:
    """(k, V_(k+2)/V_k divided by the predicted -k^2 (|alpha - 1| p_1/2)^2), for even k; tends to 1 like 1 - 3/k."""
    if len(expansion.degrees) != 1:
        raise InputError("law", "large orders are known for one law only", "one law")
    alpha = _float(expansion.degrees[0])
    if alpha in (0.0, 1.0):
        raise InputError("alpha", f"at alpha = {alpha:.0f} the series does not diverge", "alpha > 0 other than 1")
    rate = abs(alpha - 1) * _float(expansion.p[1]) / 2
    U = expansion.turning_point_flow().U
    V = [_float(U[k]) for k in range(U.order + 1)]  # V_k = (alpha - 1) U_(k-1)
    return [(k, V[k + 1] / V[k - 1] / (-((k * rate) ** 2))) for k in range(2, len(V) - 1, 2)]


def _float(c: Any) -> float:
    return float((c.ball() if isinstance(c, PiNumber) else arb(c)).mid())
