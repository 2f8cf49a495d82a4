"""Laws made of known numbers, for tests of steps: the classes of the library with a small stand-in for the fit."""

from dataclasses import fields
from types import SimpleNamespace

from asymptotics.decays.identification.fitting.profile import Interval
from asymptotics.decays.identification.forward.candidates import read_candidate as read
from asymptotics.decays.identification.judging.laws import Evidence, Fitted, Intervals, Judged

SURE, BELOW = Interval(0.04, 0.05, 0.06), Interval(-3.0, -2.0, -1.5)


def fit(criterion=0.0, **more):
    """What most steps ask of a fit: AICc (infinite where there are no data to spare), and ``more``."""
    return SimpleNamespace(
        **({"aicc": criterion, "scales": {"x": 1.0}, "model": SimpleNamespace(alternating=False)} | more)
    )


def law(text, found=None, *, missed="", left=1.0, **known):
    """A judged law with the fit ``found``, or none for the reason ``missed``; ``known``: what is said of it.

    Unless it is said otherwise each loss is surely positive, and the law is consistent.
    """
    candidate = read(text)
    said = {"epsilon": (SURE,) * len(candidate.losses), "verdict": "consistent"} | known
    intervals, evidence = (
        {f.name: said.pop(f.name) for f in fields(c) if f.name in said} for c in (Intervals, Evidence)
    )
    return Judged(Fitted(candidate, found, missed, left=left), Intervals(**intervals), Evidence(**evidence), **said)
