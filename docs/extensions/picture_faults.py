"""What is wrong with a picture, as far as a program sees it: empty axes, ticks that overlap, a legend over the data,
points that the legend does not name, values that no colour of a map stands for.
"""

import numpy as np
from matplotlib.colors import to_hex
from matplotlib.contour import ContourSet

GAP = 2.0  # pixels between two labels


def faults(figure):
    """The faults in words; an empty list for a picture without any."""
    figure.draw_without_rendering()  # lays it out, whatever its canvas
    frame = figure.bbox
    found = []
    for axes in (a for a in figure.axes if a.get_visible()):
        name = axes.get_title() or axes.get_ylabel() or axes.get_xlabel() or "axes"
        if not axes.has_data() and not axes.texts and axes.get_label() != "<colorbar>":
            found.append(f"{name}: empty")
        found += [f"{name}: ticks overlap at {text!r}" for axis in (axes.xaxis, axes.yaxis) for text in crowded(axis)]
        legend = axes.get_legend()
        if legend is not None and covered(axes, legend.get_window_extent()):
            found.append(f"{name}: the legend covers data")
        if legend is not None and (count := nameless(axes, legend)):
            found.append(f"{name}: {count} rows of points that the legend does not name")
        if any(without_colour(part) for part in axes.collections):
            found.append(f"{name}: values beyond the colours stay white")
        box = axes.get_tightbbox()
        if box is not None and _outside(box, frame):
            found.append(f"{name}: cut off by the edge")
    for text in figure.texts + ([figure._suptitle] if figure._suptitle is not None else []):
        if _outside(text.get_window_extent(), frame):
            found.append(f"{text.get_text()!r}: cut off by the edge")
    return found + overlaps(figure)


def _outside(box, frame):
    return box.x0 < frame.x0 - 2 or box.x1 > frame.x1 + 2 or box.y0 < frame.y0 - 2 or box.y1 > frame.y1 + 2


def overlaps(figure):
    """Headings, legends and names of axes that lie over one another, or over the axes of a neighbour."""
    shown = [a for a in figure.axes if a.get_visible() and a.axison]
    words = []
    for axes in shown:
        parts = [axes.title, axes.xaxis.label, axes.yaxis.label, axes.get_legend()]
        kept = [p for p in parts if p is not None and p.get_visible() and (not hasattr(p, "get_text") or p.get_text())]
        words += [(axes, getattr(p, "get_text", lambda: "the legend")(), p.get_window_extent()) for p in kept]
    pairs = [(a, b) for i, a in enumerate(words) for b in words[:i] if _meet(a[2], b[2])]
    found = [f"{a[1]!r} lies over {b[1]!r}" for a, b in pairs]
    return found + [
        f"{text!r} lies over its neighbour"
        for axes, text, box in words
        for other in shown
        if other is not axes and _apart(axes, other) and _meet(box, other.get_window_extent())
    ]


def _apart(one, other):
    """Whether two axes stand beside each other, and not one in the other, as twins and insets do."""
    return not _meet(one.get_window_extent(), other.get_window_extent())


def _meet(a, b):
    return min(a.x1, b.x1) - max(a.x0, b.x0) > 1 and min(a.y1, b.y1) - max(a.y0, b.y0) > 1


def crowded(axis):
    """The labels of ticks that touch their neighbour."""
    low, high = sorted(axis.get_view_interval())
    ticks = [t for t in (*axis.get_major_ticks(), *axis.get_minor_ticks()) if low <= t.get_loc() <= high]
    labels = [t.label1 for t in ticks if t.label1.get_visible() and t.label1.get_text()]
    side = "x" if axis.axis_name == "x" else "y"
    boxes = [(label.get_window_extent(), label.get_text()) for label in labels]
    boxes.sort(key=lambda b: getattr(b[0], f"{side}0"))
    pairs = zip(boxes, boxes[1:])
    return [b[1] for a, b in pairs if getattr(b[0], f"{side}0") < getattr(a[0], f"{side}1") + GAP]


def nameless(axes, legend):
    """How many rows of points have a colour that the legend does not have, beside rows that it names."""
    named = {_colour(handle) for handle in legend.legend_handles if hasattr(handle, "get_color")}
    shown = [line for line in axes.lines if len(line.get_xdata()) > 2 and line.get_marker() not in ("None", "", " ")]
    return sum(line.get_label().startswith("_") and _colour(line) not in named for line in shown)


def _colour(line):
    return to_hex(line.get_color())


def without_colour(part):
    """Whether a filled map has values outside its levels, and no colour for them."""
    if not isinstance(part, ContourSet) or not part.filled:
        return False
    low, high = part.levels[0], part.levels[-1]
    return (part.zmin < low and part.extend not in ("min", "both")) or (
        part.zmax > high and part.extend not in ("max", "both")
    )


def covered(axes, box):
    """Whether a line or a cloud of points passes under the box."""
    for line in axes.lines:
        data = np.column_stack([line.get_xdata(orig=False), line.get_ydata(orig=False)])
        places = line.get_transform().transform(data)
        drawn = _dense(places) if line.get_linestyle() not in ("None", "", " ") else places
        if _any_inside(drawn, box):
            return True
    clouds = [c for c in axes.collections if len(c.get_offsets()) > 1]
    return any(_any_inside(c.get_offset_transform().transform(c.get_offsets()), box) for c in clouds)


def _dense(places, steps=20):
    """Points along the segments, so that a long one does not pass unseen."""
    if len(places) < 2 or len(places) > 2000:
        return places
    share = np.linspace(0, 1, steps)[:, None, None]
    return (places[None, :-1] * (1 - share) + places[None, 1:] * share).reshape(-1, 2)


def _any_inside(places, box):
    places = np.asarray(places, float)
    ok = np.isfinite(places).all(axis=1)
    x, y = places[ok].T
    return bool(((x > box.x0) & (x < box.x1) & (y > box.y0) & (y < box.y1)).any())
