"""Does a law leave more than noise?  The noise level is measured without any law.

Turning points of each side, and times, are smooth functions of n, so that what a polynomial in n (its degree by AICc)
leaves over is noise.  A law whose residuals are larger, or are mostly one line of the spectrum, does not fit.

>>> n = np.arange(60)
>>> y = 0.9**n * (-1.0) ** n + 1e-3 * np.random.default_rng(0).standard_normal(60)
>>> 0.0008 < smooth_noise(n, y, alternating=True)[0] < 0.0012
True
"""

from collections.abc import Mapping

import numpy as np
from scipy.special import fdtrc

from asymptotics.decays.identification.fitting.least_squares import Fit
from asymptotics.decays.identification.fitting.model import Model, Noise
from asymptotics.decays.identification.fitting.waveform import WaveformModel
from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.measuring.criteria import aicc, chosen
from asymptotics.present.percent import percent

Levels = Mapping[str, tuple[float, float]]
"""For each kind of data the noise level and its degrees of freedom."""
_LINE, _LONG = 0.55, 24
"""What a wrong law leaves is a slow curve, with more than half of its power in one line of the spectrum; of so many
swings white noise hardly has that."""
_SURELY = 1e-4
"""The chance that a right law is called inadequate: small, for dozens of laws are asked."""
_KNOWN = 1000.0
"""Degrees of freedom of a noise that the user states: as good as known."""


def noise_levels(model: Model, noise: Noise | None) -> Levels:
    """The level of each kind of data: as given, or as a polynomial in n leaves it."""
    if isinstance(model, WaveformModel):
        return {"x": (noise.x, _KNOWN) if noise and noise.x else model.level()}
    found, columns = {}, model.smooth_columns()
    for kind in model.kinds:
        known = getattr(noise, kind) if noise else None
        found[kind] = (known, _KNOWN) if known else smooth_noise(*columns[kind], model.alternating and kind == "x")
    return found


def smooth_noise(n: Array, y: Array, alternating: bool) -> tuple[float, float]:
    """(standard deviation, degrees of freedom) of y about a polynomial in n, or (-1)^n times one and an offset."""
    sign = np.where(n % 2, -1.0, 1.0) if alternating else np.ones(len(n))
    u = 2 * (n - n.min()) / np.ptp(n) - 1
    offset = np.ones((len(n), int(alternating)))
    # Degree 13 at most: a decay needs less, and the half of the data stays for the noise.
    polynomials = (np.polynomial.chebyshev.chebvander(u, d) * sign[:, None] for d in range(1, min(14, len(n) // 2)))
    found = chosen((np.column_stack([columns, offset]) for columns in polynomials), y, aicc)
    if found is None:
        return 0.0, 1.0
    _, rss, parameters = found
    # The scale of the noise is among the parameters, and is no coefficient.
    freedom = float(len(n) - parameters + 1)
    return float(np.sqrt(rss / freedom)), freedom


def adequate(fit: Fit, levels: Levels, left: float = 1.0) -> tuple[bool, str]:
    """Whether the residuals of a law are no larger than the noise, and the comparison in words.

    ``left``: the share of the sum of squares that effects which the data cannot show would leave.
    """
    said, good = [], True
    for kind, group in zip(fit.model.kinds, fit.model.groups):
        own = float(np.sqrt(left * (fit.residuals[group] ** 2).sum() / max(fit.freedoms[kind], 1.0)))
        level, freedom = levels[kind]
        # A level from fewer than five data to spare is worth no verdict.
        if not level or freedom < 5:
            continue
        # What the arithmetic leaves is no misfit of a law.
        level = max(level, fit.model.floor(kind, fit.theta))
        above = _exceeds(own, fit.freedoms[kind], level, freedom)
        squares = fit.residuals[group] ** 2
        # Without its largest square: one swing that was touched, or one wild sample.
        rest = float(np.sqrt(left * (squares.sum() - squares.max()) / max(fit.freedoms[kind] - 1, 1.0)))
        alone = above and not _exceeds(rest, fit.freedoms[kind] - 1, level, freedom)
        good &= not above or alone
        words = f" ({rest:.3g} but for one value)" if alone else " (too large)" if above else ""
        said.append(f"{kind}: residual {own:.3g}, noise {level:.3g}{words}")
    share, frequency, p = strongest_line(fit.residuals[fit.model.groups[0]])
    # At the floor the residuals are those of the arithmetic, which may well be one line.
    beyond = fit.scales["x"] > 1.01 * fit.model.floor("x", fit.theta)
    if left == 1 and beyond and share > _LINE and p < _SURELY and len(fit.model.seen.n) >= _LONG:
        good = False
        said.append(f"{percent(share)} of the residual of x is one line at {_place(fit.model, frequency)}")
    return good, "; ".join(said)


def _place(model: Model, frequency: float) -> str:
    """A frequency in cycles from datum to datum in words: those of samples have times."""
    if not isinstance(model, WaveformModel):
        return f"{frequency:.3g} cycles a half-swing"
    return f"{frequency / float(np.median(np.diff(model.samples.t))):.3g} Hz"


def _exceeds(own: float, freedom: float, level: float, of_level: float) -> bool:
    """Whether residuals are larger than the noise beyond doubt; one value alone refutes no law."""
    p = float(fdtrc(max(freedom, 1.0), of_level, (own / level) ** 2))
    # 1.3: with thousands of samples a tenth more than the noise would be significant, and may be what the smooth curve
    # has taken up. A choice.
    return p < _SURELY and own > 1.3 * level


def strongest_line(r: Array) -> tuple[float, float, float]:
    """(share of the power in the strongest line with its neighbours, its frequency in cycles a datum, p-value).

    p bounds the probability that white noise of this length has so large a share g in one of its m lines alone:
    each has it with probability (1 - g)^(m - 1), so that p = m (1 - g)^(m - 1).
    """
    # Fisher's test of the largest ordinate of a periodogram (1929), by its first term, which bounds the probability.
    power = np.abs(np.fft.rfft(r - r.mean())) ** 2
    k, total = int(np.argmax(power)), float(power.sum())
    if not total > 0:
        return 0.0, 0.0, 1.0
    share = float(power[max(k - 1, 0) : k + 2].sum()) / total
    lines, g = len(power) - 1, float(power[k]) / total
    return share, k / len(r), min(1.0, lines * (1 - g) ** (lines - 1))
