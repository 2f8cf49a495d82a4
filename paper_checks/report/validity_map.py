"""The picture of where each order is good to 10 %, 1 %, 0.1 %: measured errors, proved bounds, over strength and time.

The bounds are those of ``bounds.turning`` for alpha >= 1 and of ``bounds.turning_sequence`` below; where neither holds
it is grey.
"""

from collections.abc import Callable
from itertools import takewhile
from typing import Any

import numpy as np
from flint import arb

from asymptotics.bounds.turning import turning_bounds
from asymptotics.bounds.turning_sequence import turning_sequence_bounds
from asymptotics.errors import LimitError
from asymptotics.numbers.exact import parse_real
from paper_checks.report.turning_point_errors import TurningPointErrors, turning_point_errors

LEVELS = (1e-3, 1e-2, 1e-1)
EPSILONS = ("1/100", "1/50", "1/30", "1/20", "1/15", "1/12", "1/8", "1/5", "3/10", "9/20", "7/10", "1")
ALPHAS, ORDERS = ("1/2", "3/2", "2", "3"), (1, 3)
TAU_MAX = 40.0

Column = Callable[[str, str, int, Any], Any]


def draw(axes: Any) -> None:
    """One column for each exponent; for each order a row of measured errors and a row of proved bounds of them.

    The larger of the errors of amplitude and phase, with contours at 0.1 %, 1 % and 10 %.
    """
    figure = axes.figure
    axes.remove()
    rows: list[tuple[str, int, Column]] = []
    for order in ORDERS:
        rows += [(f"order {order}, measured", order, measured), (f"order {order}, proved", order, proved)]
    panels = figure.subplots(len(rows), len(ALPHAS), sharex=True, sharey=True, squeeze=False)
    for i, (label, order, column) in enumerate(rows):
        panels[i][0].set_ylabel(f"{label}\n" + r"$\tau = \omega_0 t$")
        for j, alpha in enumerate(ALPHAS):
            image = _panel(panels[i][j], alpha, order, column)
    for panel, alpha in zip(panels[0], ALPHAS):
        panel.set_title(rf"$\alpha = {alpha}$")
    for panel in panels[-1]:
        panel.set_xlabel(r"$\varepsilon$")
    figure.colorbar(image, ax=panels, label=r"$\log_{10}$ of the larger error of amplitude and phase", shrink=0.6)


def _panel(panel: Any, alpha: str, order: int, column: Column) -> Any:
    tau = np.linspace(np.pi, TAU_MAX, 80)
    strengths = [_fraction(epsilon) for epsilon in EPSILONS]
    values = np.array([column(alpha, epsilon, order, tau) for epsilon in EPSILONS]).T
    errors = np.ma.masked_invalid(np.log10(np.clip(values, 1e-6, 1)))
    image = panel.pcolormesh(strengths, tau, errors, cmap="viridis_r", vmin=-6, vmax=0, rasterized=True)
    panel.set_facecolor("#d4d4d4")
    shown = panel.contour(strengths, tau, errors, levels=np.log10(LEVELS), colors="white", linewidths=0.9)
    panel.clabel(shown, fmt={-3.0: "0.1 %", -2.0: "1 %", -1.0: "10 %"}, fontsize=8)
    panel.set_xscale("log")
    panel.set_xlim(strengths[0], strengths[-1])
    panel.grid(False)
    return image


def measured(alpha: str, epsilon: str, order: int, tau: Any) -> Any:
    """The larger of the two errors against the certified turning points, on a grid of times."""
    return _column(turning_point_errors(alpha, epsilon, order, TAU_MAX), tau)


def proved(alpha: str, epsilon: str, order: int, tau: Any) -> Any:
    """The larger of the two bounds at the last turning point before each time; NaN where no theorem holds."""
    exponent, strength = parse_real(alpha, "alpha"), parse_real(epsilon, "epsilon").ball()
    n = np.floor(tau / np.pi).astype(int)
    try:
        found = _bounds(exponent, strength, order, int(n.max()))
    except LimitError:
        return np.full_like(tau, np.nan)
    return np.array([found[k] if k < len(found) else np.nan for k in n])


def _bounds(alpha: Any, epsilon: arb, order: int, last: int) -> list[float]:
    """max(relative amplitude, phase) for n = 0, 1, ..., as far as it is proved."""
    if alpha >= 1:
        found = turning_bounds([alpha], order, [epsilon])
        return [float(found.log_amplitude(n).max(found.phase(n))) for n in range(last + 1)]
    steps = takewhile(lambda step: step.n <= last, turning_sequence_bounds([alpha], order, [epsilon]))
    return [max(float(step.amplitude / step.A), float(step.phase)) for step in steps]


def _column(errors: TurningPointErrors, tau: Any) -> Any:
    """The larger error on a grid of times; 1 (no use) beyond the last turning point of a motion that has ended."""
    if not len(errors.tau):
        return np.ones_like(tau)
    larger = np.nan_to_num(np.maximum(errors.amplitude, errors.phase), nan=1.0)
    beyond = 1.0 if errors.ended else larger[-1]
    return np.interp(tau, errors.tau, larger, right=beyond)


def _fraction(text: str) -> float:
    top, _, bottom = text.partition("/")
    return int(top) / int(bottom or 1)
