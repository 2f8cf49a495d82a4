"""The verdict in words: which law, or which laws, or none, or too little to tell; and what would tell.

The noise level is measured without any law: turning points of each side, and times, are smooth functions of n, so that
what a polynomial in n (its degree by AICc) leaves over is noise.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy import stats

from asymptotics.identification.coefficients import Array
from asymptotics.identification.comparison import LawFit, fit_law, minimal
from asymptotics.identification.fitting import Fit, Noise
from asymptotics.identification.observations import Observations
from asymptotics.identification.quadrature import TooStrongError

IDENTIFIED, SEVERAL, NONE, UNTOLD = "identified", "several laws are consistent", "none fits", "too short or too noisy"
MANY = 3
_LINE, _LONG = 0.55, 24
"""White residuals have a few per cent of their power in one line and its neighbours."""
_DIFFERENT = 12.0
"""The chi-squared by which a wrong law must be worse: AICc difference 10, and two parameters."""


@dataclass(frozen=True)
class Verdict:
    """``kind`` is one of the four; ``text`` says it in words; ``telling`` says what would tell more."""

    kind: str
    text: str
    telling: str = ""


def smooth_noise(n: Array, y: Array, alternating: bool) -> tuple[float, int]:
    """(standard deviation, degrees of freedom) of y about a polynomial in n, or (-1)^n times one and an offset."""
    sign = np.where(n % 2, -1.0, 1.0) if alternating else np.ones(len(n))
    u = 2 * (n - n.min()) / np.ptp(n) - 1
    best = (np.inf, 0.0, 1)
    for degree in range(1, min(14, len(n) // 2)):
        columns = np.polynomial.chebyshev.chebvander(u, degree) * sign[:, None]
        if alternating:
            columns = np.column_stack([columns, np.ones(len(n))])
        r = y - columns @ np.linalg.lstsq(columns, y, rcond=None)[0]
        k, rss = columns.shape[1] + 1, max(float(r @ r), 1e-300)
        left = len(n) - k
        if left < 2:
            break
        aicc = len(n) * np.log(rss / len(n)) + 2 * k + 2 * k * (k + 1) / (left - 1 + 1e-9)
        if aicc < best[0]:
            best = (aicc, float(np.sqrt(rss / (left + 1))), left + 1)
    return best[1], best[2]


def adequate(fit: Fit, noise: Noise | None) -> tuple[bool, str]:
    """Whether the residuals of the best law are no larger than the noise, and the comparison in words."""
    said, good = [], True
    columns = fit.model.smooth_columns()
    for kind, group in zip(fit.model.kinds, fit.model.groups):
        own = float(np.sqrt((fit.residuals[group] ** 2).sum() / max(fit.freedoms[kind], 1.0)))
        known = getattr(noise, kind) if noise else None
        level, freedom = (known, 1000) if known else smooth_noise(*columns[kind], fit.model.alternating and kind == "x")
        if not level or freedom < 5:
            continue
        p = float(stats.f.sf((own / level) ** 2, max(fit.freedoms[kind], 1.0), freedom))
        above = p < 1e-4 and own > 1.3 * level
        good &= not above
        said.append(f"{kind}: residual {own:.3g}, noise {level:.3g}" + (" (too large)" if above else ""))
    share, frequency = line_share(fit.residuals[fit.model.groups[0]])
    if share > _LINE and len(fit.model.seen.n) >= _LONG:
        good = False
        said.append(f"{share:.0%} of the residual of x is one line at {frequency:.3g} cycles a half-swing")
    return good, "; ".join(said)


def line_share(r: Array) -> tuple[float, float]:
    """(share of the power in the strongest line of the residuals, its frequency in cycles a half-swing)."""
    power = np.abs(np.fft.rfft(r - r.mean())) ** 2
    k = int(np.argmax(power))
    total = float(power.sum())
    return (float(power[max(k - 1, 0) : k + 2].sum()) / total if total > 0 else 0.0), k / len(r)


def verdict_of(laws: Sequence[LawFit], seen: Observations | None, noise: Noise | None) -> Verdict:
    """The verdict for one run; without observations (printed decrements) nothing is said of further turning points."""
    fitted = [f for f in laws if f.fit is not None and np.isfinite(f.criterion)]
    if not fitted:
        return Verdict(UNTOLD, f"{UNTOLD} to tell: the data determine no candidate law")
    best = min(fitted, key=lambda f: f.criterion)
    assert best.fit is not None
    good, said = adequate(best.fit, noise)
    if not good:
        text = f"{NONE} at the noise level (model inadequate); the best is {best.candidate}: {said}"
        return Verdict(NONE, text, "the residuals against n show what is missing: a term, a second mode, the base")
    chosen = minimal(laws)
    names = "; ".join(_named(f) for f in chosen[:6])
    if not chosen:
        text = f"{NONE}: the laws with support need a negative loss; the best is {best.candidate}"
        return Verdict(NONE, text)
    if all(e.contains(0.0) for f in chosen for e in f.epsilon):
        return Verdict(UNTOLD, f"{UNTOLD} to tell: the data do not show any loss", "more swings, or less noise")
    if len(chosen) == 1:
        return Verdict(IDENTIFIED, f"{IDENTIFIED}: {names}, among the laws tried" + _richer(chosen[0], best))
    telling = "" if seen is None else what_would_tell(chosen[0], chosen[1], seen)
    if len(chosen) > MANY:
        return Verdict(UNTOLD, f"{UNTOLD} to tell {len(chosen)} laws apart: {names}", telling)
    return Verdict(SEVERAL, f"{SEVERAL}: {names}", telling)


def _named(law: LawFit) -> str:
    if law.alpha is not None:
        low, high = (f"{v:.4g}" if v is not None else "?" for v in (law.alpha.low, law.alpha.high))
        return f"{law.candidate} with alpha = {law.alpha.estimate:.4g} [{low}, {high}]"
    return str(law.candidate)


def _richer(law: LawFit, best: LawFit) -> str:
    gain = law.criterion - best.criterion
    return f" (with more terms, {best.candidate}, AICc falls by {gain:.2g})" if gain > 4 else ""


def what_would_tell(one: LawFit, other: LawFit, seen: Observations) -> str:
    """How many turning points, or how little noise, would separate two consistent laws if the first is true."""
    if one.fit is None or other.fit is None:
        return ""
    scales = Noise(**one.fit.scales)
    for factor in (1.0, 1.25, 1.6, 2.0, 3.0, 4.0, 6.0):
        last = int(np.ceil(seen.last * factor))
        difference = separation(one, other, seen, last, scales)
        if difference is None:
            return f"to tell {one.candidate} from {other.candidate}: less noise; the motion of the first ends too soon"
        if factor == 1.0:
            less = float(np.sqrt(max(difference, 1e-12) / _DIFFERENT))
        elif difference >= _DIFFERENT:
            return (
                f"to tell {one.candidate} from {other.candidate}: about {last + 1} turning points, "
                f"or noise {less:.2g} times the present one"
            )
    return f"to tell {one.candidate} from {other.candidate}: noise {less:.2g} times the present one; swings do not help"


def separation(one: LawFit, other: LawFit, seen: Observations, last: int, noise: Noise) -> float | None:
    """The chi-squared of the best ``other`` for noiseless data of ``one`` up to turning point ``last``."""
    assert one.fit is not None
    assert other.fit is not None
    first = one.fit.model
    n = np.arange(last + 1)
    template = Observations.of(
        n, np.where(n % 2, -1.0, 1.0) * seen.reference * np.sign(seen.x[0]), n.astype(float) if seen.has_times else ()
    )
    try:
        model = type(first)(first.swing, template, first.offset)
        theta = one.fit.theta
        data, _ = model.predict(theta)
    except TooStrongError:
        return None
    count = len(n)
    # the scale of strengths is the first amplitude of the data, not of the fit
    exact = Observations.of(n, data[:count], data[count:] if seen.has_times else ())
    fitted = fit_law(other.candidate, exact, Noise(noise.x, noise.t, noise.passage)).fit
    return None if fitted is None else fitted.chi2
