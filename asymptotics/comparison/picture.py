"""Digits lost against time: what was written and is not right.

A value written with 16 digits of which 7.4 are right has lost 8.6.  The plot needs the extra plot.
"""

from typing import Any

from asymptotics.comparison.digits import significant
from asymptotics.comparison.reading import as_double
from asymptotics.comparison.run import Comparison
from asymptotics.present.figures import render

_NAMES = {"n": "turning point n", "tau": r"$\tau = \omega_0 t$", "t": "t (s)"}


def lost_digits(found: Comparison) -> dict[str, tuple[list[float], list[float]]]:
    """For each column the keys, and the digits lost there."""
    columns: dict[str, tuple[list[float], list[float]]] = {}
    for row in found.rows:
        if row.certified is not None:
            keys, lost = columns.setdefault(row.column, ([], []))
            keys.append(as_double(row.key) if row.key_name in _NAMES else len(keys))
            lost.append(max(0.0, significant(row.given) - float(row.digits)))
    return columns


def picture_of(found: Comparison, kind: str) -> bytes:
    """The plot as an SVG or PNG file."""

    def draw(axes: Any) -> None:
        for column, (keys, lost) in lost_digits(found).items():
            axes.plot(keys, lost, marker=".", markersize=3, linewidth=0.8, label=column)
        axes.set_xlabel(_NAMES.get(found.rows[0].key_name, "value"))
        axes.set_ylabel("digits lost")
        axes.set_title(f"looks like {found.summary['look']['kind']}")
        axes.legend()

    return render(draw, size=(6.4, 4.0), kind=kind)
