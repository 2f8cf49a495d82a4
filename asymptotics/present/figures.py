"""Figures whose bytes depend on nothing but their data: no date, fixed ids, one style.

>>> svg = render(lambda axes: axes.plot([0, 1], [0, 1]))
>>> svg[:5], svg == render(lambda axes: axes.plot([0, 1], [0, 1]))
(b'<?xml', True)
"""

import io
from collections.abc import Callable
from typing import Any

from asymptotics.errors import InputError

STYLE: Any = {
    "axes.edgecolor": "#6b7280",
    "axes.grid": True,
    "axes.labelsize": 11,
    "axes.prop_cycle": "cycler('color', ['#1f4e9c', '#c2410c', '#15803d', '#7e22ce'])",
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
    """Draw on one pair of axes and return the picture as SVG or PNG bytes, the same at each call.

    InputError where matplotlib, an extra, is not installed.
    """
    try:
        from matplotlib import rc_context  # noqa: PLC0415 (an extra, and slow to load: only pictures need it)
        from matplotlib.figure import Figure  # noqa: PLC0415 (as above)
    except ImportError as error:
        accepted = "an installation with the extra plot: pip install 'power-law-oscillator[plot]'"
        raise InputError("plot", "a picture needs matplotlib, which is not installed", accepted) from error
    with rc_context(STYLE):
        figure = Figure(figsize=size, layout="constrained")
        draw(figure.subplots())
        buffer = io.BytesIO()
        metadata = {"Date": None, "Creator": None} if kind == "svg" else {"Software": None}
        figure.savefig(buffer, format=kind, dpi=160, metadata=metadata)
    return buffer.getvalue()
