"""Pictures of an identification: the decay, the decrement against amplitude with each law's curve and band, residuals.

``draw_panels`` draws four panels: the samples over time with the turning points and the envelope of the best law; the
classical plot of decrement against mean amplitude, with the band of the 95 % region for the laws of the verdict, those
that coincide as one; the residuals; the profile of each strength.  Where there are times, a fifth shows the backbone
(``drawn_backbone``).  matplotlib is loaded when a picture is asked for.
"""

from textwrap import wrap
from typing import Any

import numpy as np
from scipy.interpolate import PchipInterpolator

from asymptotics.decays.identification.fitting.least_squares import Fit
from asymptotics.decays.identification.fitting.profile import profile_curve, quantile
from asymptotics.decays.identification.fitting.waveform import WaveformModel
from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.judging.grades import off
from asymptotics.decays.identification.judging.laws import Judged
from asymptotics.decays.identification.measuring.observations import Indices, Observations
from asymptotics.decays.identification.telling.drawn_backbone import draw_backbone
from asymptotics.decays.identification.telling.law_answer import shown_interval
from asymptotics.decays.identification.telling.law_curves import decrement_curve
from asymptotics.decays.records.units import SECONDS
from asymptotics.errors import InputError
from asymptotics.present.drawn import head

_SHOWN = 3
"""So many curves with their bands can be told apart in one panel."""
_DOTS = 4000
"""Dots that a panel can hold; of more samples one in so many is drawn.  A choice."""
_FINE = 400
"""Places of a curve: between turning points too, where an envelope that falls by half is no straight line."""
_ALIKE = 0.5
"""Curves that lie within this share of their bands of each other are one to the eye, and are drawn as one."""


def drawn_run(answer: Any) -> Any:
    """What is drawn: of several runs the first."""
    return answer.per_run[0] if answer.per_run else answer


def shown_laws(answer: Any) -> list[Judged]:
    """The laws of the verdict that are drawn; InputError for printed decrements (no sequence), and where no law is
    fitted."""
    laws = [found.law for found in answer.laws if found.law.fit is not None and found.law.fit.model.alternating]
    if not laws:
        if len(answer.runs) == 1 and isinstance(answer.runs[0], Observations):
            raise InputError("plot", "no law is fitted: there is no curve", "a record that may tell laws apart")
        raise InputError("plot", "there is no single run of turning points to draw", "one record or turning points")
    chosen = {found.law.candidate for found in answer.of_the_verdict}
    return ([law for law in laws if law.candidate in chosen] or laws)[:_SHOWN]


def draw_panels(answer: Any, axes: Any) -> None:
    """The panels of one run in the place of ``axes``, the verdict above them."""
    one = drawn_run(answer)
    shown, figure, place = shown_laws(one), axes.figure, axes.get_subplotspec()
    if place is None:
        raise InputError("ax", "these axes are not in a grid that could be divided", "axes of plt.subplots()")
    timed = _fit_of(shown[0]).model.seen.has_times
    grid = place.subgridspec(2, 3 if timed else 2)
    axes.set_subplotspec(grid[0, 0])
    wide = (1, slice(1, None))
    classical, residuals, profile = (figure.add_subplot(grid[k]) for k in ((0, 1), (1, 0), wide))
    which = f"drawn: the first of {len(answer.per_run)} runs, {one.runs[0].name}" if one is not answer else ""
    said = [line for text in (answer.verdict.text, answer.quality_in_words, which) for line in wrap(text, 110)]
    figure.suptitle("\n".join(said), fontsize=11)
    _decay(axes, shown[0], one.units.shown)
    draw_decrements(classical, shown, one.units.shown)
    _residuals(residuals, shown[0])
    _profile(profile, shown[0])
    if timed:
        draw_backbone(figure.add_subplot(grid[0, 2]), shown, one.units.shown)


def _fit_of(law: Judged) -> Fit:
    assert law.fit is not None
    return law.fit


def _decay(axes: Any, law: Judged, unit: str) -> None:
    """Samples and turning points with the envelope; over time, where there is any."""
    fit = _fit_of(law)
    model, seen = fit.model, fit.model.seen
    size, centre = model.amplitudes(fit.theta)[0], np.full(seen.last + 1, fit.rest)
    place: Array = np.arange(seen.last + 1.0)
    abscissa = "turning point n"
    if seen.has_times:
        clock = seen.time_unit or "s"
        abscissa, scale = f"t ({clock})", SECONDS[clock]
        place = model.turning_times(fit.theta) / scale
        # An acceleration or a velocity is not the motion that the envelope surrounds.
        if seen.samples is not None and seen.samples.derivative == 0:
            t = seen.samples.t
            axes.plot(t / scale, seen.samples.x, ".", markersize=2, color="0.6", label=f"{len(t)} samples")
            # About a base line that may be inclined, and wander.
            if isinstance(model, WaveformModel):
                centre = np.interp(place * scale, t, model.base_line(fit.theta))
            axes.set_xlim(t[0] / scale, t[-1] / scale)
        elif seen.record is not None:  # the turning points are fitted, and these are where they come from
            step = -(-len(seen.record[0]) // _DOTS)
            t, x = (column[::step] for column in seen.record)
            axes.plot(t / scale, x, ".", markersize=2, color="0.6", label="samples")
    n, measured, _ = measured_sizes(fit)
    side = seen.sign[0] * np.where(n % 2, -1.0, 1.0)
    sides: tuple[int, ...] = (1, -1)
    points = "turning points"
    if seen.spacing is not None:  # amplitudes at times, which have no sides
        clock = seen.time_unit or "s"
        place, abscissa = place * seen.spacing / SECONDS[clock], f"t ({clock})"
        side, sides, points = np.ones(len(n)), (1,), "amplitudes"
    fine = np.linspace(place[0], place[-1], _FINE)
    curve, about = np.exp(PchipInterpolator(place, np.log(size))(fine)), np.interp(fine, place, centre)
    for sign in sides:
        label = "envelope" if sign > 0 else None
        axes.plot(fine, about + sign * curve, color="C1", lw=1, label=label, zorder=2 if len(sides) > 1 else 3)
    axes.plot(place[n], centre[n] + side * measured, "o", markersize=3, color="C0", label=points)
    axes.set(xlabel=abscissa, ylabel=f"x ({unit})" if unit else "x")
    head(axes, [f"decay and envelope of {law.candidate}"])


def decrement_band(fit: Fit, inflation: float = 1.0) -> tuple[Array, Array, Array]:
    """(mean amplitude, decrement, half-width of its 95 % band at this amplitude) of a law, as a curve.

    ``inflation``: by how much correlated residuals stretch the intervals of the law, and the band with them.
    """
    amplitude, value, spread = decrement_curve(fit)
    return amplitude, value, inflation * quantile(fit, 0.95, "x") * spread


def measured_sizes(fit: Fit) -> tuple[Indices, Array, Array]:
    """(n, amplitude, its standard error) of the turning points that were measured."""
    model, seen = fit.model, fit.model.seen
    if isinstance(model, WaveformModel) and model.samples.derivative == 0:
        return model.measured_sizes(fit.theta)
    known = seen.inside
    if seen.samples is not None:
        known[np.flatnonzero(known)[[0, -1]]] = False  # a smooth line knows its ends badly
    # Of errors that stand in a table only the proportions are taken: their size is found with the fit.
    local = len(seen.sigma_x) > 0 and (seen.record is not None or seen.samples is not None)
    error = seen.sigma_x if local else fit.scales["x"] * model.shape[: len(seen.n)]
    return seen.n[known], (seen.sign * (seen.x - fit.rest))[known], error[known]


def measured_decrements(fit: Fit) -> tuple[Array, Array, Array]:
    """(mean amplitude, decrement of a half-swing, its standard error) of neighbours among the measured turning points.

    Peaks of one side are two half-swings apart, and the rows of an envelope some more.
    """
    n, size, error = measured_sizes(fit)
    gaps = np.diff(n)
    # Of a law whose swings are longer than the record no turning point was measured.
    near = gaps == gaps.min(initial=fit.model.seen.last + 1)
    means, falls = (size[1:] + size[:-1]) / 2, (size[:-1] - size[1:]) / gaps
    return means[near], falls[near], (np.hypot(error[1:], error[:-1]) / gaps)[near]


def draw_decrements(axes: Any, laws: list[Judged], unit: str) -> None:
    """What was measured, and the decrement of each law with the band of its 95 % region."""
    mean, decrement, error = measured_decrements(_fit_of(laws[0]))
    axes.errorbar(mean, decrement, error, fmt="o", markersize=3, lw=0.8, color="0.5", label="measured")
    low, high = axes.get_ylim()
    for i, (names, amplitude, value, band) in enumerate(_told_apart(laws)):
        shape = {"linestyle": "-" if i == 0 else "--", "zorder": 3 - 0.1 * i}  # rivals do not hide the best law
        axes.plot(amplitude, value, color=f"C{i}", label=names, **shape)
        axes.fill_between(amplitude, value - band, value + band, color=f"C{i}", alpha=0.25, lw=0)
        low, high = min(low, float(value.min())), max(high, float(value.max()))
    axes.set_ylim(low, high + 0.05 * (high - low))  # a band may be wide where nothing was measured
    _draw_left(axes, laws[0])
    suffix = f" ({unit})" if unit else ""
    axes.set(xlabel="mean amplitude" + suffix, ylabel="decrement" + suffix)
    head(axes, ["decrement against amplitude"])


def _told_apart(laws: list[Judged]) -> list[tuple[str, Array, Array, Array]]:
    """(names, amplitude, decrement, band) of the laws, those that coincide as one with the wider band of them."""
    found: list[tuple[str, Array, Array, Array]] = []
    for law in laws:
        amplitude, value, band = decrement_band(_fit_of(law), law.inflation)
        for i, (names, other, its, wide) in enumerate(found):
            # Amplitudes fall with n, and interp wants them rising.
            here, beside = (np.interp(other, amplitude[::-1], y[::-1]) for y in (value, band))
            if (np.abs(here - its) <= _ALIKE * np.maximum(beside, wide)).all():
                found[i] = f"{names} and {law.candidate} (coincide)", other, its, np.maximum(beside, wide)
                break
        else:
            found.append((str(law.candidate), amplitude, value, band))
    return found


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
        clock = fit.model.seen.time_unit or "s"
        axes.plot(samples.t / SECONDS[clock], fit.weighted, ".", markersize=2, label=f"{len(samples.t)} samples")
        axes.axhline(0, color="0.5", lw=0.6)
        axes.set(xlabel=f"t ({clock})", ylabel="residual / standard deviation")
        head(axes, [f"residuals of {law.candidate}"])
        return
    seen, abscissa = fit.model.seen, "turning point n"
    numbers: dict[str, Any] = {"x": seen.n, "t": seen.n, "passage": seen.passage_n}
    clock = seen.time_unit or "s"
    if seen.has_times:
        abscissa = f"t ({clock})"
        numbers = {"x": seen.t, "t": seen.t, "passage": seen.passage_t}
    elif seen.spacing is not None:
        abscissa, numbers = f"t ({clock})", {"x": seen.n * seen.spacing}
    scale = SECONDS[clock] if abscissa.startswith("t (") else 1.0
    for kind, group in zip(fit.model.kinds, fit.model.groups):
        axes.plot(numbers[kind] / scale, fit.weighted[group], "o", markersize=3, label=kind)
    axes.axhline(0, color="0.5", lw=0.6)
    axes.set(xlabel=abscissa, ylabel="residual / standard deviation")
    head(axes, [f"residuals of {law.candidate}"])


def _profile(axes: Any, law: Judged) -> None:
    fit = _fit_of(law)
    for i, name in enumerate(law.candidate.alphas):
        values, rise = profile_curve(fit, law.fitted.functions[i], count=13)
        found, level = law.epsilon[i], quantile(fit, 0.95, "x") ** 2
        scale = abs(found.estimate) or 1.0
        axes.plot(
            (values - found.estimate) / scale, rise, color=f"C{i}", label=f"epsilon of {name}: {shown_interval(found)}"
        )
        # The ends of the interval as it is printed: off the curve where correlated residuals stretch it.
        ends = [(end - found.estimate) / scale for end in (found.low, found.high) if end is not None]
        label = "95 % interval" if i == 0 else None
        axes.plot(ends, [level] * len(ends), "|", color=f"C{i}", markersize=9, label=label)
        # Where intervals of white residuals end: 3.84, the 95 % of chi-squared, if the noise is known.
        axes.axhline(level, color="0.5", lw=0.6)
    axes.locator_params(axis="x", nbins=4)
    axes.set(xlabel="relative change of the strength", ylabel="rise of chi squared")
    head(axes, [f"profiles of {law.candidate}"])
