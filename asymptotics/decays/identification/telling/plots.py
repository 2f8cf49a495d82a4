"""Pictures of an identification: the decay, the decrement against amplitude with each law's curve and band, residuals.

``draw_panels`` draws four panels: turning points with the envelope of the best law; the classical plot of decrement
against mean amplitude, with the band of the 95 % region for the laws of the verdict; the residuals of turning points
(and times) against n; the profile of the first strength.  matplotlib is loaded when a picture is asked for.
"""

from textwrap import wrap
from typing import Any

import numpy as np

from asymptotics.decays.identification.fitting.least_squares import Fit
from asymptotics.decays.identification.fitting.profile import profile_curve, quantile
from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.judging.grades import off
from asymptotics.decays.identification.judging.laws import Judged
from asymptotics.errors import InputError
from asymptotics.present.drawn import head

_SHOWN = 3
"""So many curves with their bands can be told apart in one panel."""


def shown_laws(answer: Any) -> list[Judged]:
    """The laws of the verdict that are drawn; InputError for several runs or printed decrements (no sequence)."""
    laws = [found.law for found in answer.laws if found.law.fit is not None and found.law.fit.model.alternating]
    if answer.per_run or not laws:
        raise InputError("plot", "there is no single run of turning points to draw", "one record or turning points")
    # Those of the verdict alone have a held-out error.
    consistent = [law for law in laws if law.verdict == "consistent" and law.evidence.held_out is not None]
    return (consistent or laws)[:_SHOWN]


def draw_panels(answer: Any, axes: Any) -> None:
    """The four panels in the place of ``axes``, the verdict above them."""
    shown, figure, place = shown_laws(answer), axes.figure, axes.get_subplotspec()
    if place is None:
        raise InputError("ax", "these axes are not in a grid that could be divided", "axes of plt.subplots()")
    grid = place.subgridspec(2, 2)
    axes.set_subplotspec(grid[0, 0])
    classical, residuals, profile = (figure.add_subplot(grid[k]) for k in ((0, 1), (1, 0), (1, 1)))
    figure.suptitle("\n".join(wrap(answer.verdict.text, 110)), fontsize=11)
    _decay(axes, shown[0], answer.units.unit)
    draw_decrements(classical, shown, answer.units.unit)
    _residuals(residuals, shown[0])
    _profile(profile, shown[0])


def _fit_of(law: Judged) -> Fit:
    assert law.fit is not None
    return law.fit


def _decay(axes: Any, law: Judged, unit: str) -> None:
    fit = _fit_of(law)
    model, seen = fit.model, fit.model.seen
    size, centre = model.amplitudes(fit.theta)[0], fit.rest
    n = np.arange(seen.last + 1)
    for sign in (1, -1):
        axes.plot(n, centre + sign * size, color="C1", lw=1, label="envelope" if sign > 0 else None)
    axes.plot(seen.n, seen.x, "o", markersize=3, label="turning points")
    axes.set(xlabel="turning point n", ylabel=f"x ({unit})" if unit else "x")
    head(axes, [f"decay and envelope of {law.candidate}"])


def decrement_band(fit: Fit, inflation: float = 1.0) -> tuple[Array, Array, Array]:
    """(mean amplitude, decrement, half-width of its 95 % band) of a law at the measured turning points.

    ``inflation``: by how much correlated residuals stretch the intervals of the law, and the band with them.
    """
    model = fit.model
    size, by_law = model.amplitudes(fit.theta)
    slopes = np.zeros((model.size, len(size) - 1))
    slopes[: model.after] = by_law[:, :-1] - by_law[:, 1:]
    # The delta method: the band is that of a decrement at each place by itself, as many standard errors either way as
    # intervals reach.
    spread = np.sqrt(np.maximum(np.einsum("in,ij,jn->n", slopes, fit.covariance, slopes), 0.0))
    return (size[1:] + size[:-1]) / 2, size[:-1] - size[1:], inflation * quantile(fit, 0.95, "x") * spread


def draw_decrements(axes: Any, laws: list[Judged], unit: str) -> None:
    """What was measured, and the decrement of each law with the band of its 95 % region."""
    fit = _fit_of(laws[0])
    seen = fit.model.seen
    size = np.abs(seen.x - fit.rest)
    next_ = np.diff(seen.n) == 1
    mean, decrement = ((size[1:] + size[:-1]) / 2)[next_], (size[:-1] - size[1:])[next_]
    axes.plot(mean, decrement, "o", markersize=3, color="0.5", label="measured")
    for i, law in enumerate(laws):
        amplitude, value, band = decrement_band(_fit_of(law), law.inflation)
        shape = {"linestyle": "-" if i == 0 else "--", "zorder": 3 - 0.1 * i}  # rivals do not hide the best law
        axes.plot(amplitude, value, color=f"C{i}", label=str(law.candidate), **shape)
        axes.fill_between(amplitude, value - band, value + band, color=f"C{i}", alpha=0.25, lw=0)
    _draw_left(axes, laws[0])
    suffix = f" ({unit})" if unit else ""
    axes.set(xlabel="mean amplitude" + suffix, ylabel="decrement" + suffix)
    head(axes, ["decrement against amplitude"])


def _draw_left(axes: Any, law: Judged) -> None:
    """What the law leaves of the loss: the measured loss, smoothed, where it is not that of the law."""
    left = law.evidence.unexplained
    if left is None or law.verdict == "consistent" or not left.share > 0:
        return
    amplitude, value, _ = decrement_band(_fit_of(law))
    # Amplitudes fall with n, and interp wants them rising.
    drawn = np.interp(left.amplitudes, amplitude[::-1], value[::-1])
    label = f"measured: {law.candidate} is {off(left.share)}"
    axes.fill_between(left.amplitudes, drawn, drawn * (1 + left.ratio), color="C3", alpha=0.4, lw=0, label=label)


def _residuals(axes: Any, law: Judged) -> None:
    fit = _fit_of(law)
    samples = fit.model.seen.samples
    if samples is not None:
        axes.plot(samples.t, fit.weighted, ".", markersize=2, label=f"{len(samples.t)} samples")
        axes.axhline(0, color="0.5", lw=0.6)
        axes.set(xlabel="t (s)", ylabel="residual / standard deviation")
        head(axes, [f"residuals of {law.candidate}"])
        return
    numbers = {"x": fit.model.seen.n, "t": fit.model.seen.n, "passage": fit.model.seen.passage_n}
    for kind, group in zip(fit.model.kinds, fit.model.groups):
        axes.plot(numbers[kind], fit.weighted[group], "o", markersize=3, label=kind)
    axes.axhline(0, color="0.5", lw=0.6)
    axes.set(xlabel="turning point n", ylabel="residual / standard deviation")
    head(axes, [f"residuals of {law.candidate}"])


def _profile(axes: Any, law: Judged) -> None:
    fit = _fit_of(law)
    for i, name in enumerate(law.candidate.alphas):
        values, rise = profile_curve(fit, law.fitted.functions[i], count=13)
        found, level = law.epsilon[i], quantile(fit, 0.95, "x") ** 2
        scale = abs(found.estimate) or 1.0
        axes.plot((values - found.estimate) / scale, rise, color=f"C{i}", label=f"strength of {name}")
        # The ends of the interval as it is printed: off the curve where correlated residuals stretch it.
        ends = [(end - found.estimate) / scale for end in (found.low, found.high) if end is not None]
        label = "95 % interval" if i == 0 else None
        axes.plot(ends, [level] * len(ends), "|", color=f"C{i}", markersize=9, label=label)
        # Where intervals of white residuals end: 3.84, the 95 % of chi-squared, if the noise is known.
        axes.axhline(level, color="0.5", lw=0.6)
    axes.locator_params(axis="x", nbins=4)
    axes.set(xlabel="relative change of the strength", ylabel="rise of chi squared")
    head(axes, [f"profiles of {law.candidate}"])
