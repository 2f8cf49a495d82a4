"""Columns of uncertainties beside turning points: which belongs to the time and which to the place.

``xerr yerr`` are those of the abscissa and the ordinate, as programs that draw call them; else a name says whose it is.

>>> errors_of(["t", "amplitude", "xerr", "yerr"], {"t": 0, "x": 1})
{'t': 2, 'x': 3}
>>> errors_of(["n", "x (deg)", "uncertainty x (deg)", "t"], {"x": 1, "tau": 3})
{'x': 2}
>>> errors_of(["t", "x", "error of t", "error"], {"t": 0, "x": 1})
{'t': 2, 'x': 3}
>>> errors_of(["n", "t", "dt", "A", "dA"], {"n": 0, "x": 3, "tau": 1})
{'x': 4, 't': 2}
"""

import re
from collections.abc import Mapping, Sequence

from asymptotics.decays.records.columns import quantities
from asymptotics.decays.records.error_names import errors_beside

_TIMES = ("t", "time", "tau", "zeit", "terr")


def errors_of(names: Sequence[str], places: Mapping[str, int]) -> dict[str, int]:
    """The places of the errors of ``t`` and ``x``, as far as the names say them."""
    found = [i for i, q in enumerate(quantities(names)) if i not in places.values() and q == "uncertainty"]
    words = {i: _words(names[i]) for i in found}
    if any("yerr" in words[i] for i in found):
        drawn = {"xerr": "t", "yerr": "x"}
        return {drawn[w]: i for i in found for w in words[i] if w in drawn}
    own = _words(names[places["x"]]) if "x" in places else set()
    owners = {p: "x" if c == "x" else "t" for c, p in places.items() if c in ("x", "t", "tau")}
    beside = errors_beside(names)
    errors = {owners[of]: i for i, of in reversed(beside.items()) if i in found and of in owners}
    for i in found:
        if i in beside:
            continue
        # Of two that may be one, the first: the others are told as not used.
        errors.setdefault("t" if words[i] & set(_TIMES) and not words[i] & own else "x", i)
    return errors


def _words(name: str) -> set[str]:
    label = re.sub(r"[\[(][^\])]*[\])]", "", name).lower()
    return {w for w in re.split(r"[^\w]+|_", label) if w}
