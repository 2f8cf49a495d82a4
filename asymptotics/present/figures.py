"""Figures whose bytes depend on nothing but their data: no date, fixed ids, one style.

>>> svg = render(lambda axes: axes.plot([0, 1], [0, 1]))
>>> svg[:5], svg == render(lambda axes: axes.plot([0, 1], [0, 1]))
(b'<?xml', True)
"""

import io
from collections.abc import Callable
from typing import Any

import matplotlib
from cycler import cycler
from matplotlib.figure import Figure

STYLE: Any = {
    "axes.edgecolor": "#6b7280",
    "axes.grid": True,
    "axes.labelsize": 11,
    "axes.prop_cycle": cycler(color=["#1f4e9c", "#c2410c", "#15803d", "#7e22ce"]),
    "axes.spines.right": False,
    "axes.spines.top": False,
    "axes.titlesize": 11,
    "font.size": 10,
    "grid.color": "#e5e7eb",
    "grid.linewidth": 0.6,
    "legend.frameon": False,
    "lines.linewidth": 1.5,
    "mathtext.fontset": "stix",
    "svg.hashsalt": "power-law-oscillator",
}


def render(draw: Callable[[Any], Any], *, size: tuple[float, float] = (6.4, 4.0), kind: str = "svg") -> bytes:
    """Draw on one pair of axes and return the picture as SVG or PNG bytes, the same at each call."""
    with matplotlib.rc_context(STYLE):
        figure = Figure(figsize=size, layout="constrained")
        draw(figure.subplots())
        buffer = io.BytesIO()
        metadata = {"Date": None, "Creator": None} if kind == "svg" else {"Software": None}
        figure.savefig(buffer, format=kind, dpi=160, metadata=metadata)
    return buffer.getvalue()
