"""Records whose extremes cannot be fitted, or are known too badly: the motion itself is observed.

Few samples a period, uneven sampling, gaps, clipped peaks (masked), and records of a velocity or an acceleration, whose
extremes are no turning points: every sample is kept, and a smooth line through them (``demodulation``) gives the
turning points that start the fit.  An offset or a drift of the sensor is the base line of the fit.
"""

from dataclasses import replace

import numpy as np
from scipy.special import fdtrc

from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.measuring.demodulation import SpectralLine, demodulated, density
from asymptotics.decays.identification.measuring.few_swings import ENOUGH_PERIODS, observations_of_few_swings
from asymptotics.decays.identification.measuring.main_frequency import dominant_period
from asymptotics.decays.identification.measuring.observations import Observations, Samples
from asymptotics.errors import InputError
from asymptotics.present.counts import many

MAX_SAMPLES, ENOUGH = 20_000, 6_000
"""More samples than ``ENOUGH`` are averaged in groups, which loses little of a slow motion and saves the time of
the fit; more than MAX_SAMPLES in any case."""
_A_PERIOD = 24
"""Means that are left in a period: a mean over more of it would need a larger correction for its own width."""
LEAST_SAMPLES = 14
"""Base, drift and a line of degree 2 have 8 coefficients: below this too little is left to measure the noise."""
_PER_PERIOD = 2.2
"""Just above the two samples a period at which a line and its mirror image are the same."""
_HIDDEN, _LOUD = 1.5, 0.5
"""A decay ends where the line is below 1.5 of the noise, and is none where the noise is above half of its largest."""
_CHANCE = 1e-3
"""That the largest of as many lines as there are frequencies is one of noise."""
_TRUE, _GUESSED = 3e-4, 0.05
"""What the line itself may be off, as a share of an extreme: inside the record, and beyond its ends, where it is
continued by polynomials; they only weigh the first look at a law, and the samples decide."""
_RELEASED, _EARLY = 0.1, 0.02
"""A record that begins within this share of a half-swing before a turning point begins there; so far before it its
polynomial is continued, the samples before that are left out.  Choices."""
_WORDS = ("the motion", "the velocity", "the acceleration")


def observations_of_motion(
    t: Array, x: Array, *, unit: str, name: str, notes: tuple[str, ...] = (), derivative: int = 0,
    period: float | None = None,
) -> Observations:  # fmt: skip
    """The samples of a free decay, with the turning points of a smooth line through them; InputError if there is no
    such line."""
    if len(t) > ENOUGH:
        period = period or dominant_period(t, x)
        step = _thinning(t, period)
        if step > 1:
            t, x = _thinned(t, x, 2 * np.pi / period, step)
            notes = (*notes, f"the means of {step} samples each are fitted")
    line, whole, told = demodulated(t, x, period), (t, x), notes
    keep = _free(line, t)
    # Once more on the free decay alone: what is forced or hidden has bent the polynomials.
    if keep.sum() >= LEAST_SAMPLES and not keep.all():
        t, x = t[keep], x[keep]
        notes = (*notes, f"free decay from t = {t[0]:.6g} to {t[-1]:.6g}: the rest is forced, held or hidden by noise")
        line = demodulated(t, x, 2 * np.pi / line.omega)
    _require_samples(line, t, name)
    if _is_no_line(line, t, x):
        # What is left of a wild line may be a piece of a swing: all samples are asked.
        return observations_of_few_swings(*whole, unit=unit, name=name, notes=told, derivative=derivative)
    n, times, values, inside = line.turning_points(derivative)
    late = _begins_late(times, float(t[0]))
    if late:
        n, times, values, inside = n[:-1], times[1:], values[1:], inside[1:]
        kept = t >= times[0] - _EARLY * (times[1] - times[0])
        t, x = t[kept], x[kept]
    per_period = 2 * np.pi / line.omega / float(np.median(np.diff(t)))
    said = f"all {len(t)} samples of {_WORDS[derivative]} fitted ({per_period:.3g} a period); noise {line.noise:.3g}"
    said += f", neighbours correlated by {line.memory:.2f}: allowed for" if line.memory else ""
    samples = Samples(t, x, line.noise, line.freedom, line.memory, derivative)
    # as if each swing were known by its own samples alone: the first look then weighs laws as the samples will
    error = np.full(len(n), line.noise / line.omega**derivative * np.sqrt(4 / max(per_period, _PER_PERIOD)))
    error = np.hypot(error, np.where(inside, _TRUE, _GUESSED) * np.abs(values))
    late = error / np.abs(values) / line.omega
    seen = Observations.of(n, values, times, sigma_x=error, sigma_t=late, unit=unit, name=name, notes=(*notes, said))
    return replace(seen, x=values, samples=samples)


def _begins_late(times: Array, start: float) -> bool:
    """Whether the turning point before the first sample is only feigned: the record begins at the next one, or nearly.

    Before a release there was none, and a strong law need not have had one.
    """
    return len(times) > 4 and times[0] < start and times[1] - start < _RELEASED * (times[2] - times[1])


def _thinning(t: Array, period: float) -> int:
    """How many samples are one mean: as many as leave ``ENOUGH``, and enough of a period; in the end MAX_SAMPLES."""
    per_period = period / float(np.median(np.diff(t)))
    return max(min(len(t) // ENOUGH, int(per_period / _A_PERIOD)), -(-len(t) // MAX_SAMPLES), 1)


def _thinned(t: Array, x: Array, omega: float, step: int) -> tuple[Array, Array]:
    """Means of groups of samples, over |mean of e^(i omega t)| of each: a mean is smaller than the middle of a wave."""
    count = len(t) // step * step
    times, values = t[:count].reshape(-1, step), x[:count].reshape(-1, step)
    middle = times.mean(axis=1)
    # Exactly |sin(w)/w| for even samples; as it stands it holds for uneven ones too.
    smaller = np.abs(np.exp(1j * omega * (times - middle[:, None])).mean(axis=1))
    level = float(np.median(values))
    # A group over a gap may average the wave away: 0.1 keeps its correction finite.
    return middle, level + (values.mean(axis=1) - level) / np.maximum(smaller, 0.1)


def _free(line: SpectralLine, t: Array) -> Array:
    """Which samples belong to the free decay: from the largest swing, if it is early, to where noise hides it."""
    size = line.at(t)[0]
    first = int(np.argmax(size))
    keep = np.ones(len(t), dtype=bool)
    # Five percent above its start: below that the polynomial itself may rise. Late maxima are growth, and stay.
    if 0 < first < len(t) // 2 and size[first] > 1.05 * size[0]:
        keep[:first] = False
    hidden = np.flatnonzero(size[first:] < _HIDDEN * line.noise)
    if len(hidden):
        keep[first + hidden[0] :] = False
    return np.asarray(keep)


def _require_samples(line: SpectralLine, t: Array, name: str) -> None:
    per_period = 2 * np.pi / line.omega * (len(t) - 1) / (t[-1] - t[0])
    if len(t) < LEAST_SAMPLES or per_period < _PER_PERIOD:
        reason = f"{name} has {many(len(t), 'sample')}, {per_period:.3g} a period"
        raise InputError("FILE", reason, f"at least {LEAST_SAMPLES} samples, {_PER_PERIOD} a period, or turning points")


def _is_no_line(line: SpectralLine, t: Array, x: Array) -> bool:
    """Whether a line has too few periods, or is no more than noise makes of so many coefficients."""
    periods = (t[-1] - t[0]) * line.omega / (2 * np.pi)
    if periods < ENOUGH_PERIODS or line.noise > _LOUD * float(line.at(t)[0].max()):
        return True
    # Snedecor's F of the line beside a base and a drift, against what noise that remembers has at its frequency.
    count = len(t) - 2 - line.freedom
    left = float(((x - np.polynomial.Polynomial.fit(t, x, 1)(t)) ** 2).sum())
    loud = density(line.memory, line.omega * float(np.median(np.diff(t))))
    ratio = max(left / line.noise**2 - line.freedom, 0.0) / (count * loud)
    return float(fdtrc(count, line.freedom, ratio)) > _CHANCE / len(t)
