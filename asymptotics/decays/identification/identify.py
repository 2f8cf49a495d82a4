"""From measured data to a law: which one, with which strengths, and how sure.

>>> n = np.arange(41)
>>> x = (-1.0) ** n / (1 + 0.05 * n) + 1e-4 * np.random.default_rng(3).standard_normal(41)
>>> answer = identified({"n": n, "x": x}, laws=["1", "2", "free"])
>>> answer.law("1").law.verdict
'refuted'
"""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from numbers import Real
from typing import Any

import numpy as np
from threadpoolctl import threadpool_limits

from asymptotics.decays.identification.fitting.correlation import block_length
from asymptotics.decays.identification.fitting.model import Noise
from asymptotics.decays.identification.fitting.printed import Decrements
from asymptotics.decays.identification.fitting.profile import coordinate, wald_interval
from asymptotics.decays.identification.fitting.waveform import WaveformModel
from asymptotics.decays.identification.forward.candidates import (
    Candidate,
    default_candidates,
    read_candidate,
    read_springs,
)
from asymptotics.decays.identification.forward.work import Work
from asymptotics.decays.identification.judging.adequacy import Levels, noise_levels
from asymptotics.decays.identification.judging.amplitudes import relieved, spring_bound, widened
from asymptotics.decays.identification.judging.comparison import fit_laws
from asymptotics.decays.identification.judging.judgement import judged, minimal, relabelled
from asymptotics.decays.identification.judging.laws import LIMIT, Fitted, Judged
from asymptotics.decays.identification.judging.prediction import predicted_error
from asymptotics.decays.identification.judging.single_fits import fit_decrements
from asymptotics.decays.identification.measuring.defects import is_constant, is_growing
from asymptotics.decays.identification.measuring.observations import Observations
from asymptotics.decays.identification.sources import LEAST_POINTS, load
from asymptotics.decays.identification.telling.equivalents import omega_of
from asymptotics.decays.identification.telling.law_answer import LawAnswer
from asymptotics.decays.identification.telling.record_units import RecordUnits
from asymptotics.decays.identification.telling.result import Identification, sorted_laws
from asymptotics.decays.identification.telling.runs import common, verdict_of_runs
from asymptotics.decays.identification.telling.unnamed_angle import unnamed_angle
from asymptotics.decays.identification.telling.verdicts import IDENTIFIED, NONE, SEVERAL, UNDECIDED, Verdict, verdict_of
from asymptotics.decays.identification.textbook import textbook_estimates
from asymptotics.decays.records.sources import How
from asymptotics.decays.records.units import GRAVITY, UNITS
from asymptotics.errors import InputError, shown
from asymptotics.numbers.quantities import ANGLES
from asymptotics.present.counts import many
from asymptotics.running.budget import tick

_OTHER = 0.1
"""A share by which springs, losses and rough values of a mass explain another frequency.  A choice."""
_DERIVATIVES = "velocity", "acceleration"
MAX_RUNS = 50
"""Each run has the work of a verdict, and its share of the time: of ten minutes 12 seconds for each of fifty."""


@contextmanager
def _one_thread() -> Iterator[None]:
    """Matrices of a thousand rows: a second thread waits longer than it computes, and would add in another order."""
    with threadpool_limits(1, user_api="blas"):
        yield


@_one_thread()
# A search may lead out of the doubles, and so do strengths of a record in units of 1e-40: what is no number there is
# refused or has no limit, where it is used, and is no warning for the user.
@np.errstate(all="ignore")
def identified(
    data: Any,
    *,
    kind: str | None = None,
    unit: str = "",
    laws: Sequence[str] | None = None,
    springs: Sequence[str] = (),
    amplitudes: tuple[float, float] | None = None,
    amplitudes_only: bool = False,
    mass: float | None = None,
    stiffness: float | None = None,
    omega_0: float | None = None,
    noise: float | None = None,
    bootstrap: bool = True,
    how: How = How(),  # noqa: B008 (immutable)
    modes: int = 1,
) -> Identification:
    """What ``asymptotics.identify`` answers, of values that were read; ``how`` a file is read; ``modes``: 1 or 2."""
    sources = _sources(data)
    if not 1 <= len(sources) <= MAX_RUNS:
        raise InputError("data", many(len(sources), "run"), f"1 to {MAX_RUNS} runs")
    _candidates(laws, springs, times=True, angles=True)  # a law that cannot be read is refused before the work
    tick("the reading of the data")
    omega = _omega(mass, stiffness, omega_0)
    runs = [_in_range(run, amplitudes) for source in sources for run in load(source, kind, unit, how, omega, modes)]
    units = {run.shown_unit for run in runs}
    if len(units) > 1:
        raise InputError("unit", f"the runs have different units: {', '.join(sorted(units))}", "one unit")
    said = runs[0].omega if omega is None and isinstance(runs[0], Observations) else omega
    known = RecordUnits(runs[0].unit, UNITS.get(runs[0].unit, 1.0), mass, stiffness, said, runs[0].written)
    # One run without times leaves no spring to any: a common law must be tried on all of them.
    times = not amplitudes_only and all(isinstance(r, Observations) and r.has_times for r in runs)
    candidates = _candidates(laws, springs, times, known.unit in ANGLES)
    scale = None if noise is None else Noise(x=noise)
    answers = []
    for place, run in enumerate(runs):
        # What a run leaves of its share falls to those after it.
        work = Work.of_a_verdict(1 / (len(runs) - place))
        answers.append(_one_run(run, candidates, known, amplitudes_only, scale, bootstrap, work))
    found = answers[0] if len(answers) == 1 else _together(answers, known)
    order = _order_by_its_name(found) if kind is None else 0
    if not order:
        return found
    as_place = identified(
        data, kind="record", unit=unit, laws=laws, springs=springs, amplitudes=amplitudes,
        amplitudes_only=amplitudes_only, mass=mass, stiffness=stiffness, omega_0=omega_0, noise=noise,
        bootstrap=bootstrap, how=how, modes=modes,
    )  # fmt: skip
    if as_place.verdict.kind not in (IDENTIFIED, SEVERAL):
        return found
    named, reading = _DERIVATIVES[order - 1], "read as a place, which a law fits"
    told = f"{reading}: as the {named} that its name says none does (--kind {named} overrules)"
    return replace(as_place, notes=(told, *as_place.notes))


def _order_by_its_name(found: Identification) -> int:
    """Which derivative a column without a unit was taken for by its name alone, where no law fits it; else 0."""
    run = found.runs[0]
    if found.per_run or found.verdict.kind != NONE or not isinstance(run, Observations) or run.unit:
        return 0
    return 0 if run.samples is None else run.samples.derivative


def _sources(data: Any) -> list[Any]:
    """Several runs, or one; two arrays of numbers are one, (t, x)."""
    if isinstance(data, tuple) and len(data) == 2 and all(map(_is_column, data)):
        return [{"t": data[0], "x": data[1]}]
    return list(data) if isinstance(data, list | tuple) else [data]


def _is_column(data: Any) -> bool:
    """A list of numbers, or an array or a series of one dimension."""
    if isinstance(data, list | tuple):
        return bool(data) and all(isinstance(value, Real) for value in data)
    return getattr(data, "ndim", None) == 1 and hasattr(data, "dtype")


def _in_range(run: Observations | Decrements, amplitudes: tuple[float, float] | None) -> Observations | Decrements:
    if amplitudes is None:
        return run
    low, high = amplitudes
    size = np.abs(run.x) if isinstance(run, Observations) else run.amplitude
    count = int(((size >= low) & (size <= high)).sum())
    if not 0 <= low < high or count < LEAST_POINTS:
        reason = f"{count} turning points have amplitudes from {low:g} to {high:g}"
        raise InputError("amplitudes", reason, f"a range LOW:HIGH with at least {LEAST_POINTS} of them")
    return run.between(low, high)


def _candidates(laws: Sequence[str] | None, springs: Sequence[str], times: bool, angles: bool) -> list[Candidate]:
    chosen = (
        default_candidates(times, angles) if laws is None else [read_candidate(text) for text in _texts(laws, "laws")]
    )
    if not chosen:
        raise InputError("laws", "no law is named", "at least one law")
    extra = [read_springs(text) for text in _texts(springs, "springs")]
    # A pendulum has its spring, and knows no free exponent and no loss that depends on the place.
    chosen += [
        replace(c, springs=e.springs, pendulum=e.pendulum)
        for e in extra
        for c in chosen
        if not (c.springs or c.pendulum or (e.pendulum and (c.free or any(m for _, m in c.losses))))
    ]
    if any(c.pendulum for c in chosen) and not angles:
        named = "springs" if any(e.pendulum for e in extra) else "laws"
        raise InputError(named, "a pendulum needs angles", f"x in one of: {', '.join(ANGLES)} (--unit)")
    if not times and any(c.springs or c.pendulum for c in chosen):
        named = "springs" if extra else "laws"
        raise InputError(named, "springs need times", "laws without springs, or data with times")
    return list(dict.fromkeys(chosen))


def _one_run(
    run: Observations | Decrements,
    candidates: Sequence[Candidate],
    units: RecordUnits,
    amplitudes_only: bool,
    noise: Noise | None,
    bootstrap: bool,
    work: Work,
) -> Identification:
    if isinstance(run, Decrements):
        return _decrements(run, candidates, units, noise)
    unfit = _tells_no_law(run)
    if unfit is not None:
        return _without_law(run, candidates, units, unfit)
    seen = run.without_times() if amplitudes_only else run
    constant = is_constant(seen.sizes)
    # A constant amplitude may be a little larger at its end.
    growing = is_growing(seen.sizes) and not constant
    notes, fits = [*run.notes], []
    if constant:
        reason = "the amplitude is constant within the noise"
        notes.append(f"{reason}: only laws of one term are compared")
        # One amplitude is one number: only laws of one strength can be compared, and none of them told apart.
        simple = [c for c in candidates if len(c.elements) == 1 and not c.free]
        fits = [Fitted(c, None, reason) for c in candidates if c not in simple]
        candidates = simple
    fits = fit_laws(candidates, seen, noise, work) + fits
    if not seen.has_times:
        unknown = "amplitudes cannot tell a nonlinear spring from position-dependent loss, nor measure either"
        notes.append(unknown + ("" if amplitudes_only else "; intervals and verdicts hold for a linear spring"))
    bound = None
    if amplitudes_only:
        bound, origin = spring_bound(run)
        notes[-1] += f"; {origin}: intervals and verdicts allow for it"
        # Before the verdicts: what an unseen spring would explain refutes no law; after them its intervals are widened.
        fits = [relieved(law, bound) for law in fits]
    # In this order: fits, verdicts and intervals, the verdict in words, the error of prediction, textbook estimators;
    # what the limit of work or time leaves is left out from the end.
    laws = judged(fits, _levels(fits, noise), growing=growing, bootstrap=bootstrap, work=work)
    if bound is not None:
        laws = relabelled([widened(law, bound) for law in laws], growing)
    # The advice fits again; where the limit is reached, the verdict is the same without it.
    plain = verdict_of(laws, seen, growing, advice=False)
    verdict = plain if seen.spacing else work.within(partial(verdict_of, laws, seen, growing), plain)
    notes += [
        *_untried(laws),
        *_lengths(laws),
        *unnamed_angle(sorted_laws(laws)[0], units.shown),
        *_memory(laws),
        *_mode(laws),
        *_another_frequency(laws, units),
    ]
    if growing:
        notes.append("the amplitude grows: strengths may be negative (self-excitation)")
    # Each held-out error is a fit more: for the laws of the verdict only.
    chosen = {law.candidate for law in minimal(laws)[:4]}
    laws = [
        law.with_evidence(held_out=work.within(partial(predicted_error, law.fitted, seen), None))
        if law.candidate in chosen
        else law
        for law in laws
    ]
    odd = [law for law in laws if law.negative and law.verdict == "consistent" and not law.unneeded and not growing]
    notes += [f"{law.candidate}: the estimate of {', '.join(law.negative)} is negative: unphysical" for law in odd[:3]]
    answers = tuple(LawAnswer(law, _measured(units, law)) for law in sorted_laws(laws))
    # An envelope has no swings that a textbook's estimator could count.
    textbook: dict[str, Any] = {} if seen.spacing else work.within(lambda: textbook_estimates(seen), {})
    return Identification(verdict, answers, (run,), textbook, tuple(notes), answers[0].units)


def _tells_no_law(run: Observations) -> tuple[str, Verdict] | None:
    """Why no law of a run is fitted, and the verdict that says so; None where laws may be told apart."""
    if run.without_frequency:
        text = f"{UNDECIDED}: without the frequency of the envelope no law has a strength, and there is no Q"
        asked = "--omega0 W (2 pi f, in rad/s), or a line 'Frequency [Hz]: f' above the numbers"
        return "an envelope of unknown frequency has no strengths", Verdict(UNDECIDED, text, asked)
    few = len(run.n) < LEAST_POINTS and run.samples is None
    reason = run.no_law or (f"{len(run.n)} turning points tell no law from another" if few else "")
    text, telling = f"{UNDECIDED}: {reason}; its Q is that of the envelope", "a longer record of the free decay"
    if few and run.has_times:
        # Peaks are taken for neighbours: nobody has said how many periods lie between them.
        telling += "; amplitudes that are more than a period apart have the strength of each law by --kind damping"
    return (reason, Verdict(UNDECIDED, text, telling)) if reason else None


def _without_law(
    run: Observations, candidates: Sequence[Candidate], units: RecordUnits, unfit: tuple[str, Verdict]
) -> Identification:
    """A run of which no law is fitted: what its envelope tells is told."""
    reason, verdict = unfit
    laws = judged([Fitted(c, None, reason) for c in candidates], {})
    answers = tuple(LawAnswer(law, units) for law in sorted_laws(laws))
    return Identification(verdict, answers, (run,), {}, run.notes, units)


def _untried(laws: Sequence[Judged]) -> list[str]:
    """What the limit of work or time left."""
    left = [str(law.candidate) for law in laws if law.untried]
    said = f"{LIMIT} was reached before {len(left)} of {len(laws)} laws were judged"
    return [f"{said}: {'; '.join(left)}"] if left else []


def _lengths(laws: Sequence[Judged]) -> list[str]:
    """The length of the simple pendulum in the best consistent law with one."""
    best = next((law for law in sorted_laws(laws) if law.candidate.pendulum and law.verdict == "consistent"), None)
    if best is None or best.fit is None:
        return []
    frequency = coordinate(len(best.fit.theta) - 2)
    ends = wald_interval(best.fit, frequency, kind=best.fit.model.kinds[-1]).stretched(best.inflation)
    # omega_0 and the length go in opposite directions.
    long, middle, short = (
        GRAVITY * float(np.exp(-2 * w)) for w in (ends.low, ends.estimate, ends.high) if w is not None
    )
    said = f"length g/omega_0^2 = {middle:.5g} m [{short:.5g}, {long:.5g}] where g = {GRAVITY} m/s^2"
    return [f"{best.candidate}: omega_0 = {np.exp(ends.estimate):.6g} rad/s, {said}"]


def _mode(laws: Sequence[Judged]) -> list[str]:
    """The second mode that was fitted beside the motion of the first law."""
    first = sorted_laws(laws)[0]
    if first.fit is None or not isinstance(first.fit.model, WaveformModel) or not first.fit.model.samples.mode:
        return []
    place = first.fit.model.mode.start
    cosine, sine, omega, rate = first.fit.theta[first.fit.model.mode]
    ends = [wald_interval(first.fit, coordinate(k)) for k in (place + 2, place + 3)]
    told = [f"[{e.low:.5g}, {e.high:.5g}]" for e in ends if e.low is not None and e.high is not None]
    if len(told) < 2:
        return [f"{first.candidate}: the data set no limit to the second mode"]
    size = f"{np.hypot(cosine, sine):.3g} at the first sample"
    return [f"second mode: {omega:.5g} {told[0]} rad/s, {size}, rate of decay {rate:.3g} {told[1]} 1/s"]


def _levels(fits: Sequence[Fitted], noise: Noise | None) -> Levels:
    model = next((law.fit.model for law in fits if law.fit is not None), None)
    return {} if model is None else noise_levels(model, noise)


def _another_frequency(laws: Sequence[Judged], units: RecordUnits) -> list[str]:
    """That the times tell another frequency than the mass and the stiffness, or omega_0, that were given."""
    measured, given = omega_of(sorted_laws(laws)[0]), units.omega_0
    if measured is None or given is None or abs(given / measured - 1) < _OTHER:
        return []
    said = f"the times say omega_0 = {measured:.4g} rad/s, and what was given {given:.4g}"
    return [f"{said}: b and b/m are those of the given one; is it another oscillator, or another unit of time?"]


def _memory(laws: Sequence[Judged]) -> list[str]:
    """What correlated residuals of the consistent laws do to their intervals."""
    standing = [law for law in laws if law.verdict == "consistent" and law.inflation > 1]
    if not standing:
        return []
    longest = max(block_length(law.fit) for law in standing if law.fit is not None)
    most = max(law.inflation for law in standing)
    return [f"correlated residuals: intervals stretched by up to {most:.2g} (blocks of {longest} swings)"]


def _decrements(
    table: Decrements, candidates: Sequence[Candidate], units: RecordUnits, noise: Noise | None
) -> Identification:
    if table.resolution is not None:
        # Rows with a resolution are sets, not samples: no statistics, but balls.
        from asymptotics.decays.identification.telling.certified_answer import certified  # noqa: PLC0415 (the expansions in balls: most of a second)

        return certified(table, candidates, units)
    fits = [fit_decrements(c, table, noise) for c in candidates]
    laws = judged(fits, _levels(fits, noise))
    verdict = verdict_of(laws, None)
    notes = [*table.notes, "decrements cannot tell a nonlinear spring from loss: the intervals hold for linear springs"]
    answers = tuple(LawAnswer(law, units) for law in sorted_laws(laws))
    return Identification(verdict, answers, (table,), {}, tuple(notes), units)


def _together(answers: Sequence[Identification], units: RecordUnits) -> Identification:
    order = [a.law.candidate for a in answers[0].laws]
    per_run = [[answer.law(str(c)).law for c in order] for answer in answers]
    laws = common(per_run)
    first = max((run.reference for a in answers for run in a.runs if isinstance(run, Observations)), default=None)
    verdict = verdict_of_runs([a.verdict for a in answers], laws, first)
    notes = [f"{a.runs[0].name}: {note}" for a in answers for note in a.notes]
    omegas = [a.units.omega_0 for a in answers if a.units.omega_0 is not None]
    # One oscillator: its frequency is the mean of what the runs measured.
    units = replace(units, omega_0=float(np.mean(omegas)) if omegas else None)
    shown = tuple(LawAnswer(law, units) for law in sorted_laws(laws))
    runs = tuple(a.runs[0] for a in answers)
    return Identification(verdict, shown, runs, {}, tuple(notes), units, per_run=tuple(answers))


def _measured(units: RecordUnits, law: Judged) -> RecordUnits:
    """omega_0 from the times of a law, if it is not given: its strengths refer to its own."""
    return units if units.omega_0 is not None or law.evidence.outside else replace(units, omega_0=omega_of(law))


def _omega(mass: float | None, stiffness: float | None, omega_0: float | None) -> float | None:
    if mass is not None and stiffness is not None:
        if omega_0 is not None:
            raise InputError("omega_0", "it stands next to the mass and the stiffness", "either, not both")
        return float(np.sqrt(stiffness / mass))
    return omega_0


def _texts(given: Any, name: str) -> list[str]:
    texts = list(given) if isinstance(given, list | tuple) else [given]
    for text in texts:
        if not isinstance(text, str):
            raise InputError(name, f"{shown(text)} is no text", 'a list of texts such as "1+2"')
    return texts
