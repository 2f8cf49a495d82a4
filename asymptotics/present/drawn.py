"""A result that draws itself: one function for notebooks, scripts and ``--plot``, with law, start and order in it.

``_curve(axes, **options)`` draws on Matplotlib axes and returns nothing; ``_heading`` says of what the curve is.  The
legend stands between the heading and the axes, never over the data; a second result on the same axes adds its heading.

>>> class Line(Drawn):
...     def _heading(self):
...         return "a line"
...     def _curve(self, axes, **style):
...         axes.plot([0, 1], [0, 1], label="x", **style)
>>> svg = Line().picture("svg")
>>> b"<title>a line</title>" in svg, Line().picture("png", size=(2, 1), dpi=100)[:4], Line().picture("pdf")[:4]
(True, b'\\x89PNG', b'%PDF')
"""

from collections.abc import Callable, Mapping, Sequence
from textwrap import wrap
from typing import Any

from asymptotics.errors import InputError, shown
from asymptotics.present.figures import DPI, SIZE, new_axes, render, scratch_axes, styled
from asymptotics.present.html import image
from asymptotics.present.shown import Shown
from asymptotics.running.budget import budget

KINDS = (".svg", ".png", ".pdf")
_WIDTH, _COLUMNS, _ROW = 78, 3, 15.0  # characters in a line of the heading; entries and points of a row of the legend
# Inches of a picture in a notebook and of one with axes below; seconds that a cell may wait for one: longer work is
# shown without it, and drawn by plot().
_IN_PAGE, _TWO, _SECONDS = (6.4, 3.6), (6.4, 5.2), 5
_LETTER, _HANDLE, _LINE, _GAPS, _SHORT = 4.6, 44.0, 10.0, 1.1, 8
"""Points of a letter of the legend, of the line before a name with what is about it, and of a further line of a name;
by how much the layout makes axes wider that stand beside others; and letters in a line at least."""
_OURS = ("label", "panels")
"""What is added to a style here, and not by who asks for a picture."""


class Drawn(Shown):
    """A result that has a curve."""

    def _heading(self) -> str:
        """Of what the picture is: law, start, order."""
        return self._page().title

    def _headed(self, style: Mapping[str, Any]) -> str:
        """The same of a picture with these options."""
        return self._heading()

    def _curve(self, axes: Any, **options: Any) -> Any:
        """Draw; what is no option of its own is the style of the main line.  True if it has made its own headings."""
        raise NotImplementedError

    def _size(self, style: Mapping[str, Any]) -> tuple[float, float]:
        """The size of its picture in inches, where none is asked for; what stands below the curve has its room."""
        return _TWO if style.get("errors") or style.get("velocity") else SIZE

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Draw on ``ax`` (new axes by default) and return the axes; ``style`` goes to the main line of Matplotlib.

        Curves in time take ``until`` (s, or tau); new axes a ``size`` in inches.  InputError for a style that
        Matplotlib does not have, where there is nothing to draw, and where Matplotlib, an extra, is not installed.
        """
        return plotted([self], ax, style)

    def picture(self, kind: str = "svg", *, size: Any = None, dpi: Any = DPI, **style: Any) -> bytes:
        """The same as a file: "svg" (with a title), "png" or "pdf"; ``size`` in inches; the same bytes at each call."""
        return pictured([self], kind, size=size, dpi=dpi, **style)

    def _picture(self) -> str:
        try:
            with budget(_SECONDS):
                return image(self.picture("svg", size=_IN_PAGE), self._heading())
        except InputError:  # no Matplotlib, nothing to draw, or too long for a page
            return ""


def plotted(results: Sequence[Any], ax: Any, style: dict[str, Any]) -> Any:
    """Results on ``ax``, or on new axes, which are in the style of all pictures; the axes."""
    if ax is not None:
        draw_on(ax, results, style)
        return ax
    given = dict(style)
    with styled():
        # The size of new axes is that of the first result: the others are drawn into what there is.
        size = given.pop("size", None)
        axes = new_axes(results[0]._size(given) if size is None else size)
        draw_on(axes, results, given)
    return axes


def pictured(results: Sequence[Any], kind: str, *, size: Any = None, dpi: Any = DPI, **style: Any) -> bytes:
    """The file of one result, or of several on the same axes; the headings are its title."""
    size = results[0]._size(style) if size is None else size
    title = "; ".join(result._headed(style) for result in results)
    return render(lambda axes: draw_on(axes, results, style), size=size, kind=kind, dpi=dpi, title=title)


def below(axes: Any) -> Any:
    """Axes under ``axes`` with the same abscissa, in the place that it had; InputError for axes without a grid."""
    place = axes.get_subplotspec()
    if place is None:
        raise InputError("ax", "these axes are not in a grid that could be divided", "axes of plt.subplots()")
    grid = place.subgridspec(2, 1)
    axes.set_subplotspec(grid[0])
    lower = axes.figure.add_subplot(grid[1], sharex=axes)
    axes.tick_params(labelbottom=False)
    lower.set_xlabel(axes.get_xlabel())
    axes.set_xlabel("")
    return lower


def draw_on(axes: Any, results: Sequence[Any], style: dict[str, Any]) -> None:
    """All results on the same axes, each under its own heading; InputError for axes that are none."""
    if not hasattr(axes, "get_legend_handles_labels"):
        raise InputError("ax", f"{shown(axes)} are no axes", "axes of Matplotlib, or None")
    for result in results:
        own = dict(style)
        if len(results) > 1:
            own.setdefault("label", result._headed(style))
        if _drawn(result._curve, axes, own):
            return  # panels, which have headings of their own
    told = axes.get_title().split("\n") if axes.get_title() else []
    new = [] if len(results) > 1 else _lines(results[0]._headed(style))
    head(axes, [*told, *(line for line in new if line not in told)])


def _lines(heading: str) -> list[str]:
    """The heading in lines, none of which ends beside an equals sign.

    >>> _lines("turning points of 3/2 x'' + 30 x + 1/10 x'|x'|^(1/2) = 0, x(0) = 1/5, x'(0) = 0, from rest")[1]
    "x'(0) = 0, from rest"
    """
    whole = heading.replace(" = ", "\N{NO-BREAK SPACE}=\N{NO-BREAK SPACE}")
    return [line.replace("\N{NO-BREAK SPACE}", " ") for line in wrap(whole, _WIDTH, break_on_hyphens=False)]


def _drawn(curve: Callable[..., Any], axes: Any, own: dict[str, Any]) -> Any:
    """What ``curve`` returns; InputError for a style that it or Matplotlib does not have."""
    try:
        # A copy of the style, since a curve takes its own options out of it.
        return curve(axes, **own)
    # What Matplotlib raises for a keyword or a value that its lines do not have; an InputError is ours and says more.
    except (AttributeError, TypeError, ValueError) as error:
        if isinstance(error, InputError) or not _is_of_style(curve, own):
            raise
        reason = " ".join(str(error).split())[:120] or type(error).__name__
        raise InputError("style", reason, "options of this plot, and of a line of Matplotlib") from error


def _is_of_style(curve: Callable[..., Any], own: Mapping[str, Any]) -> bool:
    """Whether the curve can be drawn without the style that was asked for: else the fault is our own."""
    plain_style = {name: value for name, value in own.items() if name in _OURS}
    if len(plain_style) == len(own):
        return False
    try:
        curve(scratch_axes(), **plain_style)
    except InputError:
        return True  # an option of its own is needed, and the fault lies in one of those that are missing now
    except (AttributeError, TypeError, ValueError):
        return False
    return True


def head(axes: Any, lines: list[str]) -> None:
    """Heading, legend below it, axes below that."""
    handles, labels = axes.get_legend_handles_labels()
    columns, labels = _side_by_side(axes, labels)
    # A row is as high as the highest of its names: entries go down the columns one after the other.
    each = -(-len(labels) // columns)
    high = [max(label.count("\n") for label in labels[i::each]) for i in range(each)]
    pad = 6.0 + _ROW * each + _LINE * sum(high)
    axes.set_title("\n".join(lines), loc="center", pad=pad, fontsize=9)
    if labels:
        place = {"loc": "lower center", "bbox_to_anchor": (0.5, 1.0), "borderaxespad": 0.2}
        axes.legend(handles, labels, ncols=columns, fontsize=8, **place)


def _side_by_side(axes: Any, labels: list[str]) -> tuple[int, list[str]]:
    """The columns of the legend, and its names, which are broken where even one column is too narrow for them."""
    longest = max(map(len, labels), default=0)
    # Names of more than forty characters do not stand side by side in a picture of this width.
    most = 1 if longest > 40 else min(_COLUMNS, max(1, len(labels)))
    place = axes.get_subplotspec()
    if place is None or place.get_gridspec().ncols == 1:
        return most, labels
    # Beside other axes there is no room but their own, and half of the gaps that the layout leaves.
    room = 72.0 * axes.figure.get_figwidth() * float(axes.get_position().width) * _GAPS
    columns = next((c for c in range(most, 1, -1) if c * (_HANDLE + _LETTER * longest) <= room), 1)
    letters = max(int((room - _HANDLE) / _LETTER), _SHORT)
    return columns, ["\n".join(wrap(label, letters, break_on_hyphens=False)) for label in labels]
