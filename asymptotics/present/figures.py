"""Figures whose bytes depend on nothing but their data: no date, fixed ids, one style.

>>> svg = render(lambda axes: axes.plot([0, 1], [0, 1]))
>>> svg[:5], svg == render(lambda axes: axes.plot([0, 1], [0, 1]))
(b'<?xml', True)
"""

import io
from collections.abc import Callable
from importlib import import_module
from typing import Any

from asymptotics.errors import InputError, shown

COLOURS = ["#1f4e9c", "#c2410c", "#15803d", "#7e22ce", "#0e7490", "#be185d", "#78716c", "#ca8a04"]
# hashsalt makes the ids of an SVG depend on the drawing alone: Matplotlib draws them at random otherwise.
STYLE: Any = {
    "axes.edgecolor": "#6b7280",
    "axes.grid": True,
    "axes.labelsize": 11,
    "axes.prop_cycle": f"cycler('color', {COLOURS})",
    "axes.spines.right": False,
    "axes.spines.top": False,
    "axes.titlesize": 11,
    "font.size": 10,
    "grid.color": "#e5e7eb",
    "grid.linewidth": 0.6,
    "legend.frameon": False,
    "lines.linewidth": 1.5,
    "mathtext.fontset": "dejavusans",
    "svg.hashsalt": "power-law-oscillator",
}


# Inches and dots of a figure in a column of text; all are asked for otherwise by size= and dpi=.
SIZE, DPI = (6.4, 4.0), 160
# Refusals: below, nothing can be read; 40 inches at 1200 dots are 48000 pixels, under the 2^16 a side of the renderer.
MIN_SIZE, MAX_SIZE, MIN_DPI, MAX_DPI = 1.0, 40.0, 30, 1200
_FORMATS = "svg, png or pdf"
_WITHOUT = {  # what would differ from call to call
    "svg": {"Date": None, "Creator": None},
    "png": {"Software": None},
    "pdf": {"CreationDate": None, "Creator": None, "Producer": None},
}


def render(
    draw: Callable[[Any], Any], *, size: Any = SIZE, kind: str = "svg", dpi: Any = DPI, title: str = ""
) -> bytes:
    """Draw on one pair of axes and return the picture as SVG, PNG or PDF bytes, the same at each call.

    ``size`` in inches, ``dpi`` for PNG; ``title`` stands in the file.  InputError for another format, a size or a
    resolution out of range, and where matplotlib, an extra, is not installed.
    """
    return renderings(draw, (kind,), size=size, dpi=dpi, title=title)[0]


def renderings(
    draw: Callable[[Any], Any], kinds: tuple[str, ...], *, size: Any = SIZE, dpi: Any = DPI, title: str = ""
) -> list[bytes]:
    """The picture in each of the formats, drawn once and laid out once: see ``render``.

    The second stands as the first one was laid out, so that it may differ from a picture made alone, by less than a
    pixel.

    >>> [found[:4] for found in renderings(lambda axes: axes.plot([0, 1]), ("png", "pdf"))]
    [b'\x89PNG', b'%PDF']
    """
    for kind in kinds:
        if not isinstance(kind, str) or kind not in _WITHOUT:
            raise InputError("kind", f"{shown(kind)} is no format of a picture", _FORMATS)
    wide, high = _size(size)
    if isinstance(dpi, bool) or not isinstance(dpi, int) or not MIN_DPI <= dpi <= MAX_DPI:
        raise InputError("dpi", f"{shown(dpi)} is no resolution", f"an integer from {MIN_DPI} to {MAX_DPI}")
    with styled():
        # Not by pyplot, which would keep the figure, and open a window where there is one.
        figure = _matplotlib("matplotlib.figure").Figure(figsize=(wide, high), layout="constrained")
        draw(figure.subplots())
        return [_saved(figure, kind, dpi, title) for kind in kinds]


def _saved(figure: Any, kind: str, dpi: int, title: str) -> bytes:
    buffer = io.BytesIO()
    figure.savefig(buffer, format=kind, dpi=dpi, metadata={**_WITHOUT[kind], **({"Title": title} if title else {})})
    figure.set_layout_engine("none")  # a third of the time; all stays where it is
    return buffer.getvalue()


def styled() -> Any:
    """A context in which everything is drawn in the style of all pictures."""
    return _matplotlib("matplotlib").rc_context(STYLE)


def new_axes(size: Any = SIZE) -> Any:
    """Axes of a new figure that notebooks and windows show."""
    return _matplotlib("matplotlib.pyplot").subplots(figsize=_size(size), layout="constrained")[1]


def scratch_axes() -> Any:
    """Axes of a figure that nobody sees."""
    return _matplotlib("matplotlib.figure").Figure().subplots()


def counted(axis: Any) -> None:
    """Ticks at whole numbers only, where the axis chooses its ticks itself.

    >>> axes = import_module("matplotlib.figure").Figure().subplots()
    >>> _ = axes.plot([0, 3], [0, 1])
    >>> counted(axes.xaxis)
    >>> [float(tick) for tick in axes.get_xticks() if 0 <= tick <= 3]
    [0.0, 1.0, 2.0, 3.0]
    """
    locator = axis.get_major_locator()
    # Ticks that somebody has placed (a fixed locator) stay.
    if "integer" in getattr(locator, "default_params", ()):
        locator.set_params(integer=True)


def _matplotlib(name: str) -> Any:
    """A module of matplotlib: an extra, and slow to load, so that only pictures load it."""
    try:
        return import_module(name)
    except ModuleNotFoundError as error:  # any other ImportError is a fault, or want of memory
        accepted = "an installation with the extra plot: pip install '.[plot]' in a clone"
        raise InputError("plot", "a picture needs matplotlib, which is not installed", accepted) from error


def _size(size: Any) -> tuple[float, float]:
    accepted = f"two numbers of inches from {MIN_SIZE:g} to {MAX_SIZE:g}"
    if not isinstance(size, tuple | list) or len(size) != 2:
        raise InputError("size", f"{shown(size)} is no size", accepted)
    try:
        wide, high = (float(side) for side in size)
    except (TypeError, ValueError, OverflowError) as error:
        raise InputError("size", f"{shown(size)} is no size", accepted) from error
    if not all(MIN_SIZE <= side <= MAX_SIZE for side in (wide, high)):
        raise InputError("size", f"{wide:g} by {high:g} is out of range", accepted)
    return wide, high
