"""The backbone in a picture: the period against the amplitude, of the laws of the verdict and before any law.

A law has a period at the geometric mean of the amplitudes of any half-swing, twice its time, with the band of the 95 %
region; the three periods with intervals are those of the envelope (``backbone``), which knows no law.
"""

from typing import Any

import numpy as np

from asymptotics.decays.identification.fitting.least_squares import Fit
from asymptotics.decays.identification.fitting.profile import quantile
from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.judging.laws import Judged
from asymptotics.decays.identification.telling.envelope import envelope
from asymptotics.decays.identification.telling.law_curves import period_curve
from asymptotics.decays.records.units import SECONDS
from asymptotics.present.drawn import head


def backbone_band(fit: Fit, inflation: float = 1.0) -> tuple[Array, Array, Array]:
    """(amplitude, period in s, half-width of its 95 % band at this amplitude) of a law, as a curve.

    ``inflation``: by how much correlated residuals stretch the intervals of the law, and the band with them.
    """
    amplitude, period, spread = period_curve(fit)
    clock = next((kind for kind in ("passage", "t") if kind in fit.model.kinds), "x")
    return amplitude, period, inflation * quantile(fit, 0.95, clock) * spread


def draw_backbone(axes: Any, laws: list[Judged], unit: str) -> None:
    """T(A) of each law with its band, and that of the envelope with its intervals, in the file's unit of time."""
    fits = [law.fit for law in laws if law.fit is not None]
    seen = fits[0].model.seen
    clock = seen.time_unit or "s"
    for i, (law, fit) in enumerate(zip(laws, fits, strict=True)):
        amplitude, *ends = backbone_band(fit, law.inflation)
        period, band = (each / SECONDS[clock] for each in ends)
        shape = {"linestyle": "-" if i == 0 else "--", "zorder": 3 - 0.1 * i}  # as in the panel of decrements
        axes.plot(amplitude, period, color=f"C{i}", label=str(law.candidate), **shape)
        axes.fill_between(amplitude, period - band, period + band, color=f"C{i}", alpha=0.25, lw=0)
    bare = envelope(seen)
    rows = () if bare is None else bare.backbone
    if rows:
        a, low, middle, high = (np.array([row[k] for row in rows]) for k in ("amplitude", "low", "estimate", "high"))
        reach = (middle - low, high - middle)
        axes.errorbar(a, middle, reach, fmt="o", markersize=3, color="0.4", label="before any law")
    axes.ticklabel_format(axis="y", useOffset=False)
    axes.set(xlabel=f"amplitude ({unit})" if unit else "amplitude", ylabel=f"period ({clock})")
    head(axes, ["backbone: period against amplitude"])
