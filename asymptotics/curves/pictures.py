"""Several results in one picture, each under its own name.

>>> from asymptotics.curves.motions import motion
>>> axes = plot(motion({2: "1/10"}), motion({1: "1/10"}), until=20)
>>> [line.get_label() for line in axes.lines][::3]
["x'' + x + 1/10 x'|x'| = 0, x(0) = 1, x'(0) = 0: order 3, turning-point gauge", "x'' + x + 1/10 x' = 0, ..."]
"""

from typing import Any

from asymptotics.errors import InputError
from asymptotics.numbers.policy import Number
from asymptotics.present.drawn import Drawn, plotted
from asymptotics.running.public import public


@public
def plot(*results: Any, ax: Any = None, max_seconds: Number = 60, **style: Any) -> Any:
    """Results with a curve on the same axes, each under its own name.

    Parameters
    ----------
    results
        what ``motion``, ``envelope``, ``reference``, ``solution``, ``turning_points``, ... return
    ax
        Matplotlib axes to draw on; new ones where it is None
    max_seconds
        the time the call may take, in s
    style
        ``until`` (s, or tau) ends the curves in time, ``size`` (inches) is that of new axes; the rest goes to the main
        lines of Matplotlib

    Returns
    -------
    Axes
        the axes of Matplotlib

    Raises
    ------
    InputError
        for no result, one that has no curve, a style that Matplotlib does not know, and where the extra ``plot`` is
        missing

    Examples
    --------
    >>> from asymptotics.curves.motions import motion
    >>> axes = plot(motion({2: "1/10"}), motion({1: "1/10"}), until=20)
    >>> len(axes.lines)                                                  # of each x and both sides of its envelope
    6
    """
    # All are looked at before the first is drawn: half a picture is worse than a refusal.
    for result in results:
        if not isinstance(result, Drawn):
            accepted = "what motion, envelope, reference, solution, turning_points, ... return"
            raise InputError("results", f"a {type(result).__name__} has no curve", accepted)
    if not results:
        raise InputError("results", "there is nothing to draw", "at least one result")
    return plotted(results, ax, style)
