"""Printed decrements with a resolution: of every law a certified set, or the proof that there is none."""

from collections.abc import Sequence

import numpy as np

from asymptotics.decays.identification.certified_sets.free_exponent import exponents_that_fit
from asymptotics.decays.identification.certified_sets.set_valued import MAX_LAWS, StrengthSet, strengths_that_fit
from asymptotics.decays.identification.fitting.printed import Decrements
from asymptotics.decays.identification.forward.candidates import Candidate
from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.judging.allowance import allowance_text, allowances
from asymptotics.decays.identification.judging.contradiction import further_parameters
from asymptotics.decays.identification.judging.judgement import commented, contains, minimal
from asymptotics.decays.identification.judging.laws import Fitted, Intervals, Judged
from asymptotics.decays.identification.telling.law_answer import LawAnswer
from asymptotics.decays.identification.telling.record_units import RecordUnits
from asymptotics.decays.identification.telling.result import Identification
from asymptotics.decays.identification.telling.verdicts import IDENTIFIED, MANY, NONE, SEVERAL, UNTOLD, Verdict, named
from asymptotics.numbers.exact import parse_real
from asymptotics.terms import Term


def certified(table: Decrements, candidates: Sequence[Candidate], units: RecordUnits) -> Identification:
    """Set-valued answers: every law is proved consistent, proved refuted, or undetermined."""
    laws = commented(_sets(candidates, table))
    chosen = minimal(laws)
    names = "; ".join(named(law) for law in chosen)
    open_laws = [str(law.candidate) for law in laws if law.verdict == "undetermined"]
    rivals = [
        str(law.candidate)
        for law in laws
        if law.verdict == "undetermined" and not any(contains(law, other) for other in chosen)
    ]
    # A law that is open and not contained may meet the table too: one law alone is then not what was proved.
    if len(chosen) == 1 and rivals:
        text = f"{SEVERAL} or undecided: {names} meets every printed value (proved); undecided: {'; '.join(rivals)}"
        verdict = Verdict(SEVERAL, text, "fewer candidates, smaller amplitudes, or one more printed digit")
    elif len(chosen) == 1:
        allowed = allowances(chosen[0], laws, table.reference)
        text = f"{IDENTIFIED}: {names} meets every printed value (proved){allowance_text(allowed, 'proved')}"
        verdict = Verdict(IDENTIFIED, text, "", allowed)
    elif chosen:
        kind = SEVERAL if len(chosen) <= MANY else UNTOLD
        verdict = Verdict(kind, f"{kind}: {names} meet every printed value", "one more printed digit, or more rows")
    elif open_laws:
        verdict = Verdict(UNTOLD, f"{UNTOLD} to tell: undetermined for {', '.join(open_laws)}")
    else:
        verdict = Verdict(NONE, f"{NONE}: no candidate law meets every printed value (proved in the searched box)")
    grades = ("consistent", "undetermined", "refuted")
    order = sorted(laws, key=lambda law: (grades.index(law.verdict), law.fitted.terms))
    # Derivation ignored-spring: at the order epsilon c a spring is the loss of exponent alpha + p - 1.
    notes = (*table.notes, "decrements cannot tell a nonlinear spring from loss: the sets hold for linear springs")
    answers = tuple(LawAnswer(law, units, certified=bool(law.epsilon)) for law in order)
    return Identification(verdict, answers, (table,), {}, notes, units)


def _sets(candidates: Sequence[Candidate], table: Decrements) -> list[Judged]:
    """The certified set of each law, smaller laws first: a point that meets every row is one of each larger law."""
    laws: dict[Candidate, Judged] = {}
    points: dict[Candidate, Array] = {}
    for candidate in sorted(candidates, key=lambda c: len(c.losses) + c.free):
        inside = [c for c, law in laws.items() if law.verdict == "consistent" and _holds(candidate, c)]
        known = [_embedded(c, points[c], candidate) for c in inside if c in points]
        # A point of a smaller law, with further strengths 0; a negative one would spare no search.
        found = _set(candidate, table, next((p for p in known if (p >= 0).all()), None))
        intervals = Intervals(found.epsilon, alpha=found.alpha)
        law = Judged(Fitted(candidate, None), intervals, verdict=found.verdict, reason=found.reason)
        # What contains a consistent law is consistent by the same point, also where its own set stayed open.
        laws[candidate] = law.judged_as("consistent", "") if inside and found.verdict != "consistent" else law
        if found.point is not None and not candidate.free:
            points[candidate] = found.point
    return [laws[candidate] for candidate in candidates]


def _holds(candidate: Candidate, smaller: Candidate) -> bool:
    """Whether a law is a special case of the candidate."""
    return further_parameters(smaller, candidate) == 0


def _set(candidate: Candidate, table: Decrements, known: Array | None) -> StrengthSet:
    if candidate.free:
        found = exponents_that_fit(table)
        strengths = () if found.epsilon is None else (found.epsilon,)
        return StrengthSet(found.verdict, strengths, found.reason, found.alpha)
    if len(candidate.losses) > MAX_LAWS:
        return StrengthSet("undetermined", (), f"a certified set needs at most {MAX_LAWS} losses")
    losses = tuple(Term(1, parse_real(a, "laws"), m) for a, m in candidate.losses)
    return strengths_that_fit(losses, table, known)


def _embedded(smaller: Candidate, point: Array, candidate: Candidate) -> Array:
    """The strengths of a law as those of a larger law: its further terms have the strength 0."""
    known = dict(zip(smaller.losses, point))
    return np.array([known.get(term, 0.0) for term in candidate.losses])
