"""Are the rows of a file all there, once, and in their order?  Counts of missing, doubled and shuffled keys.

>>> order_of([Fraction(n) for n in (0, 1, 1, 4, 3)], counted=True)
{'missing': 1, 'doubled': 1, 'shuffled': 1}
>>> told_order({'missing': 1, 'doubled': 0, 'shuffled': 2})
'1 row missing, 2 rows out of order'
"""

from collections.abc import Sequence
from fractions import Fraction
from statistics import median

_REGULAR = 0.9
"""The share of equal steps from which times are taken to be regular, so that a gap means missing rows."""


def order_of(keys: Sequence[Fraction], *, counted: bool) -> dict[str, int]:
    """``counted``: whether the keys are numbers that count; of times a row is missing where a regular step is left out.

    ``shuffled``: rows whose key is below that of the row before.
    """
    distinct = sorted(set(keys))
    shuffled = sum(b < a for a, b in zip(keys, keys[1:]))
    step = Fraction(1) if counted else _step(distinct)
    gaps = [b - a for a, b in zip(distinct, distinct[1:])]
    # Half a step more is the rounding of a clock; from there on rows are missing.
    missing = 0 if step is None else sum(round(gap / step) - 1 for gap in gaps if gap > step * 3 / 2)
    return {"missing": missing, "doubled": len(keys) - len(distinct), "shuffled": shuffled}


def _step(distinct: Sequence[Fraction]) -> Fraction | None:
    """The step of regular times, or None."""
    gaps = [b - a for a, b in zip(distinct, distinct[1:])]
    if len(gaps) < 3:
        return None
    # Exact numbers: a step of printed times repeats exactly or nearly so, to a hundredth.
    usual = Fraction(median(gaps))
    equal = sum(abs(gap - usual) * 100 <= usual for gap in gaps)
    return usual if equal >= _REGULAR * len(gaps) else None


def told_order(found: dict[str, int]) -> str:
    """In words; empty where nothing is wrong."""
    words = {"missing": "missing", "doubled": "doubled", "shuffled": "out of order"}
    parts = [f"{n} row{'s' if n > 1 else ''} {words[name]}" for name, n in found.items() if n]
    return ", ".join(parts)
