"""The verdict in words: which law, or which laws, or none, or too little to tell; and what would tell."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from asymptotics.decays.identification.fitting.model import Noise
from asymptotics.decays.identification.fitting.waveform import WaveformModel
from asymptotics.decays.identification.forward.quadrature import TooStrongError
from asymptotics.decays.identification.judging.allowance import WEAK, Allowance, allowance_text, allowances
from asymptotics.decays.identification.judging.contradiction import REFUTED
from asymptotics.decays.identification.judging.grades import in_words, off
from asymptotics.decays.identification.judging.judgement import rivals
from asymptotics.decays.identification.judging.laws import LIMIT, Judged
from asymptotics.decays.identification.judging.single_fits import fit_law
from asymptotics.decays.identification.measuring.observations import Observations
from asymptotics.present.shown import Page, Shown

IDENTIFIED, SEVERAL, NONE = "identified", "several laws are consistent", "none fits"
UNTOLD, UNDECIDED = "too short or too noisy", "undecided"
MANY = 3
"""With more consistent laws than this the list tells nothing but that the data are too few.  A choice of words."""
_DIFFERENT = 12.0
"""The chi-squared by which a wrong law must be worse to be refuted, nearly: p = 5e-4 for one parameter, where 10.8
would be REFUTED.  It enters the advice of ``what_would_tell`` alone."""


@dataclass(frozen=True, repr=False)
class Verdict(Shown):
    """``kind`` is one of the five; ``text`` says it in words; ``telling`` says what would tell more.

    ``allowed``: how strong each further term may still be beside the one law of the verdict.
    """

    kind: str
    text: str
    telling: str = ""
    allowed: tuple[Allowance, ...] = ()

    def _page(self) -> Page:
        return Page(self.text, (self.telling, *map(str, self.allowed)))


def verdict_of(
    laws: Sequence[Judged], seen: Observations | None, growing: bool = False, advice: bool = True
) -> Verdict:
    """The verdict for one run; ``advice``: whether it is said which further data would tell more (never for printed
    decrements, which are no observations)."""
    found = undecided(laws) or _verdict_of(laws, seen, growing, advice)
    return replace(found, text=f"the amplitude grows, this is no decay; {found.text}") if growing else found


def undecided(laws: Sequence[Judged]) -> Verdict | None:
    """The verdict where the limit was reached before all laws were judged: none of them is identified."""
    left = sum(law.untried for law in laws)
    if not left:
        return None
    names = "; ".join(named(law) for law in rivals(laws)[0][:6]) or "none"
    text = f"{UNDECIDED}: {LIMIT} was reached before {left} of {len(laws)} laws were judged; consistent so far: {names}"
    return Verdict(UNDECIDED, text, "more time (max_seconds), or fewer candidates (laws)")


def _verdict_of(laws: Sequence[Judged], seen: Observations | None, growing: bool, advice: bool) -> Verdict:
    fitted = [law for law in laws if law.usable]
    if not fitted:
        return Verdict(UNTOLD, f"{UNTOLD} to tell: the data determine no candidate law")
    # A law that is no result, unphysical or far outside the data, heads an answer only where there is no other.
    best = min(fitted, key=lambda law: (bool(law.evidence.outside), bool(law.negative) and not growing, law.criterion))
    chosen, beaten = rivals(laws)
    if not chosen:
        return _nothing_stands(fitted, best)
    names = "; ".join(named(law) for law in chosen[:6])
    imitated = None if growing else imitation(chosen)
    if imitated is not None:
        return imitated
    # No loss at all is consistent too: then the smallest of the laws is no finding.
    if all(e.contains(0.0) for law in chosen for e in law.epsilon):
        return Verdict(UNTOLD, f"{UNTOLD} to tell: the data do not show any loss", "more swings, or less noise")
    if len(chosen) == 1:
        return _one_law(chosen[0], fitted, beaten, laws, seen, advice)
    telling = what_would_tell(chosen[0], chosen[1], seen) if advice and seen is not None else ""
    if len(chosen) > MANY:
        return Verdict(UNTOLD, f"{UNTOLD} to tell {len(chosen)} laws apart: {names}", telling)
    return Verdict(SEVERAL, f"{SEVERAL}: {names}", telling)


def _one_law(
    law: Judged,
    fitted: Sequence[Judged],
    beaten: Sequence[Judged],
    laws: Sequence[Judged],
    seen: Observations | None,
    advice: bool,
) -> Verdict:
    """One law, with what is not excluded beside it; several, if a further term may carry over a fifth of the loss."""
    few = [other for other in laws if other.verdict == "undetermined" and not other.usable and _is_one_more(other, law)]
    if few:
        names = ", ".join(str(other.candidate) for other in few[:6])
        text = f"{UNTOLD} to tell {named(law)} from {names}: {few[0].reason or 'too few data for a term more'}"
        return Verdict(UNTOLD, text, "more swings")
    allowed = allowances(law, laws, None if seen is None else seen.reference)
    said = allowance_text(allowed)
    large = [a for a in allowed if a.share is not None and a.share > WEAK]
    if large and seen is not None:
        most = max(large, key=lambda a: a.share or 0.0)
        larger = next(
            other
            for other in laws
            if set(other.candidate.alphas) == {*law.candidate.alphas, most.term}
            and (other.candidate.springs, other.candidate.pendulum) == (law.candidate.springs, law.candidate.pendulum)
        )
        text = f"{SEVERAL}: {named(law)} is the smallest, but a further term may carry over a fifth of the loss{said}"
        return Verdict(SEVERAL, text, what_would_tell(larger, law, seen) if advice else "", allowed)
    text = f"{IDENTIFIED}: {named(law)}, among the laws tried{_beside(law, fitted, beaten)}{said}"
    return Verdict(IDENTIFIED, text, "", allowed)


def _is_one_more(other: Judged, law: Judged) -> bool:
    """Whether it is the law with one loss more, and the same spring."""
    a, b = other.candidate, law.candidate
    alike = (a.springs, a.pendulum) == (b.springs, b.pendulum)
    return alike and len(a.alphas) == len(b.alphas) + 1 and {*b.alphas} < {*a.alphas}


def imitation(chosen: Sequence[Judged]) -> Verdict | None:
    """The verdict where each law that stands has a loss whose interval lies below 0, which feeds the motion: a law that
    is no candidate may be imitated by such a sum."""
    if not chosen or not all(any(e.high is not None and e.high < 0 for e in law.epsilon) for law in chosen):
        return None
    names = "; ".join(named(law) for law in chosen[:6])
    text = f"{NONE} with strengths >= 0: {names} needs a negative one ({', '.join(chosen[0].negative)})"
    telling = "candidates of another kind: a loss that depends on position such as 1,2: (|x|^2 x'), a free exponent"
    return Verdict(NONE, text, telling)


def _nothing_stands(fitted: Sequence[Judged], best: Judged) -> Verdict:
    """None fits; or, where none is consistent and some are neither that nor refuted, too little to tell."""
    unsettled = [law for law in fitted if law.verdict == "undetermined"]
    if not unsettled:
        return _nothing_fits(fitted, best)
    first = min(unsettled, key=lambda law: law.criterion)
    text = f"{UNTOLD} to tell: no law is consistent, {len(unsettled)} undetermined; of {first.candidate} {first.reason}"
    return Verdict(UNTOLD, text, "more swings, a stretch of one free decay alone, or fewer candidates (laws)")


def _nothing_fits(fitted: Sequence[Judged], best: Judged) -> Verdict:
    near = _nearest(fitted, best)
    if any(law.negative and not law.evidence.misfit and law.evidence.against.p >= REFUTED for law in fitted):
        text = f"{NONE}: the laws with support need a negative loss; the best is {best.candidate}{near}"
        return Verdict(NONE, text, "a loss that depends on position such as 1,2: (|x|^2 x'), or a free exponent")
    why = "model inadequate, or noise that is not independent from swing to swing"
    text = f"{NONE} at the noise level ({why}); the best is {best.candidate}: {best.evidence.residuals}{near}"
    return Verdict(NONE, text, _what_is_missing(best))


def _what_is_missing(best: Judged) -> str:
    """Where to look, and of samples what fits a further line."""
    model = None if best.fit is None else best.fit.model
    if not isinstance(model, WaveformModel):
        return "the residuals against n show what is missing: a term, a second mode, the base"
    more = "" if model.samples.mode else "; a second mode, hum or a rocking base is fitted beside the motion by modes 2"
    return f"the residuals against t show what is missing: a term, a further line, the base{more}"


def _nearest(fitted: Sequence[Judged], best: Judged) -> str:
    """The law of fewest terms that is adequate, or how much of the loss the best one leaves open."""
    adequate = [law for law in fitted if law.grade == "adequate"]
    for law in sorted(adequate, key=lambda law: (law.parameters, law.criterion))[:1]:
        left = law.evidence.unexplained
        if left is not None:
            low, high = left.ends
            where = f"at amplitudes {low:.3g} to {high:.3g}"
            return f"; {named(law)} is {in_words('adequate', left.share)} {where}"
    if best.evidence.unexplained is None:
        return ""
    return f"; the damping of {named(best)} is {off(best.evidence.unexplained.share)}"


def named(law: Judged) -> str:
    """A law, with its exponent if that was found."""
    if law.alpha is not None:
        low, high = (f"{v:.4g}" if v is not None else "?" for v in (law.alpha.low, law.alpha.high))
        return f"{law.candidate} with alpha = {law.alpha.estimate:.4g} [{low}, {high}]"
    return str(law.candidate)


def _beside(law: Judged, fitted: Sequence[Judged], beaten: Sequence[Judged]) -> str:
    best = min((o for o in fitted if o.parameters > law.parameters), key=lambda o: o.criterion, default=law)
    gain = law.criterion - best.criterion
    spoilt = " (unphysical)" if best.negative else ""
    # A difference of 4 is the least that is customarily called considerable (Burnham and Anderson 2002).
    said = f" (with more terms, {best.candidate}{spoilt}, AICc falls by {gain:.2g})" if gain > 4 else ""
    # One with a negative loss is named in its row.
    more = [str(other.candidate) for other in beaten if not other.negative]
    if more:
        said += f" (with more terms {', '.join(more)} cannot be excluded)"
    return said


def what_would_tell(one: Judged, other: Judged, seen: Observations) -> str:
    """How many turning points, or how little noise, would separate two consistent laws if the first is true."""
    if one.fit is None or other.fit is None or seen.samples is not None:
        return ""
    scales = Noise(**one.fit.scales)
    # A few lengths of the record, each a fit: the advice is a size, no number.
    for factor in (1.0, 1.25, 1.6, 2.0, 3.0, 4.0, 6.0):
        last = int(np.ceil(seen.last * factor))
        difference = separation(one, other, seen, last, scales)
        if difference is None:
            return f"to tell {one.candidate} from {other.candidate}: less noise; the motion of the first ends too soon"
        if factor == 1.0:
            # Chi-squared goes with the inverse square of the noise.
            less = float(np.sqrt(max(difference, 1e-12) / _DIFFERENT))
            # White noise of this size would have told them: what correlates the residuals is not less of it.
            if less >= 1:
                return ""
        elif difference >= _DIFFERENT:
            return (
                f"to tell {one.candidate} from {other.candidate}: about {last + 1} turning points, "
                f"or noise {less:.2g} times the present one"
            )
    return f"to tell {one.candidate} from {other.candidate}: noise {less:.2g} times the present one; swings do not help"


def separation(one: Judged, other: Judged, seen: Observations, last: int, noise: Noise) -> float | None:
    """The chi-squared of the best ``other`` for noiseless data of ``one`` up to turning point ``last``."""
    assert one.fit is not None
    assert other.fit is not None
    first = one.fit.model
    n = np.arange(last + 1)
    template = Observations.of(
        n, np.where(n % 2, -1.0, 1.0) * seen.reference * np.sign(seen.x[0]), n.astype(float) if seen.has_times else ()
    )
    try:
        model = type(first)(first.swing, template, first.offset, one.candidate.pendulum)
        theta = one.fit.theta
        data, _ = model.predict(theta)
    except TooStrongError:
        return None
    count = len(n)
    # the scale of strengths is the first amplitude of the data, not of the fit
    exact = Observations.of(n, data[:count], data[count:] if seen.has_times else ())
    fitted = fit_law(other.candidate, exact, Noise(noise.x, noise.t, noise.passage)).fit
    return None if fitted is None else fitted.chi2
