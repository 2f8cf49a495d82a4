"""Which column holds the errors of which other one, as the names say it: by a mark before or behind the other's name.

``dx``, ``u(x)`` and ``x_err`` are errors only where an ``x`` stands beside them; ``dt``, which may be a step of the
clock, only where a ``dx`` does.
A column whose whole name is a mark, such as ``±``, holds the errors of the column before it.

>>> errors_beside(["t", "dt", "x (cm)", "u(x)"]), errors_beside(["n", "A", "±"]), errors_beside(["t", "dt", "x"])
({1: 0, 3: 2}, {2: 1}, {})
>>> errors_beside(["t / s", "\N{GREEK CAPITAL LETTER DELTA}t", "\u03c6 / \u00b0", "\u03c6_err"])
{1: 0, 3: 2}
"""

import re
from collections.abc import Sequence

from asymptotics.decays.records.units import suffix

_WORD = "uncertainty|uncert|unc|error|err|sigma|sd|std|stdev|delta|unsicherheit|fehler"
_SIGN = "[\u03c3\u0394\u03b4\u2206\u00b1]"
_BEFORE = re.compile(
    rf"(?:(?:{_WORD})[ _]*(?:of|in|von)?[ _]*|{_SIGN}[ _]*|[du]_|d)\(?(?P<of>[^()]+)\)?", re.IGNORECASE
)
_BEHIND = re.compile(rf"(?P<of>.+?)(?:[ _]+(?:{_WORD}|pm)|[ _]*\u00b1)", re.IGNORECASE)
_ALONE = re.compile(rf"(?:{_WORD}|\u00b1|\+/-|\+-|\u03c3)(?: \d+)?(?:\.\d+)?", re.IGNORECASE)
_DIFFERENCE = re.compile(r"d|[\u0394\u03b4\u2206]|delta", re.IGNORECASE)
_TIMES = ("t", "time", "tau", "zeit")
_OF_A_LETTER = re.compile(r"u\((?P<of>[^()]+)\).*", re.IGNORECASE)
"""u(x) looks like a quantity u in the unit x."""


def errors_beside(names: Sequence[str]) -> dict[int, int]:
    """The place of each column of errors, and that of the column whose errors they are."""
    labels = [_label(name) for name in names]
    known = {label: place for place, label in reversed(list(enumerate(labels))) if label}
    found: dict[int, int] = {}
    for place, (name, label) in enumerate(zip(names, labels)):
        if place and _ALONE.fullmatch(label) and place - 1 not in found:
            found[place] = place - 1
            continue
        marked = [
            m["of"].strip()
            for m in (_OF_A_LETTER.fullmatch(name), _BEFORE.fullmatch(label), _BEHIND.fullmatch(label))
            if m
        ]
        of = next((known[_label(other)] for other in marked if known.get(_label(other), place) != place), None)
        if of is not None:
            found[place] = of
    steps = [p for p, of in found.items() if labels[of] in _TIMES and _DIFFERENCE.match(labels[p])]
    return {p: of for p, of in found.items() if p not in steps} if len(found) == len(steps) else found


def _label(name: str) -> str:
    """The name without its unit, in small letters."""
    label = re.sub(r"\s*[\[(][^\])]*[\])]\s*\Z", "", name).strip()
    if re.search(r"/\s*d\w", label):  # dx/dt
        return label.lower()
    unit = suffix(name)
    if unit and re.search(r"\S\s*/\s*\S+\Z", label):
        label = label.rpartition("/")[0]
    return label.removesuffix("_" + unit).strip().lower() if unit else label.lower()
