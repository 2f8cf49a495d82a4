"""The picture of where each order is good to 10 %, 1 %, 0.1 %: error maps over strength and time."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from asymptotics.motions.validity import TurningPointErrors, turning_point_errors

LEVELS = (1e-3, 1e-2, 1e-1)
EPSILONS = ("1/20", "1/12", "1/8", "1/5", "3/10", "9/20", "7/10", "1")
TAU_MAX = 40.0


def draw(axes: Any, alphas: Sequence[str] = ("1/2", "3/2", "2", "3"), orders: Sequence[int] = (1, 3)) -> None:
    """One panel for each exponent and order: the larger of the two errors, with contours at 0.1 %, 1 % and 10 %."""
    figure = axes.figure
    axes.remove()
    panels = figure.subplots(len(orders), len(alphas), sharex=True, sharey=True, squeeze=False)
    for i, order in enumerate(orders):
        for j, alpha in enumerate(alphas):
            image = _panel(panels[i][j], alpha, order)
            panels[i][j].set_title(rf"$\alpha = {alpha}$, order {order}")
    for panel in panels[-1]:
        panel.set_xlabel(r"$\varepsilon$")
    for row in panels:
        row[0].set_ylabel(r"$\tau = \omega_0 t$")
    figure.colorbar(image, ax=panels, label=r"$\log_{10}$ of the larger error of amplitude and phase", shrink=0.8)


def _panel(panel: Any, alpha: str, order: int) -> Any:
    tau = np.linspace(np.pi, TAU_MAX, 80)
    columns = [_column(turning_point_errors(alpha, epsilon, order, TAU_MAX), tau) for epsilon in EPSILONS]
    strengths = [_fraction(epsilon) for epsilon in EPSILONS]
    errors = np.log10(np.clip(np.array(columns).T, 1e-6, 1))
    style = {"cmap": "viridis_r", "vmin": -6, "vmax": 0, "shading": "gouraud", "rasterized": True}
    image = panel.pcolormesh(strengths, tau, errors, **style)
    shown = panel.contour(strengths, tau, errors, levels=np.log10(LEVELS), colors="white", linewidths=0.9)
    panel.clabel(shown, fmt={-3.0: "0.1 %", -2.0: "1 %", -1.0: "10 %"}, fontsize=8)
    panel.set_xscale("log")
    panel.set_xlim(strengths[0], strengths[-1])
    panel.grid(False)
    return image


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
