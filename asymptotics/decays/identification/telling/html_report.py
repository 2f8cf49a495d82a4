"""One page about an identification, complete in itself: verdict, pictures, laws, what was discarded, provenance.

The page is plain HTML with the pictures inside it: no script, nothing fetched.  Whatever came from a file or a user is
escaped.

>>> table(("law", "verdict"), [("1", "<refuted>")], "caption")
'<table><caption>caption</caption><tr><th>law</th><th>verdict</th></tr><tr><td>1</td><td>&lt;refuted&gt;</td></tr></table>'
"""

import platform
from collections.abc import Iterable, Mapping
from pathlib import Path
from string import Template

import numpy as np
import scipy

from asymptotics import __version__
from asymptotics.decays.identification.fitting.printed import Decrements
from asymptotics.decays.identification.measuring.observations import Observations
from asymptotics.decays.identification.telling.result import Identification
from asymptotics.errors import InputError, shown
from asymptotics.made_by import line as made_by_line
from asymptotics.numbers.policy import Number
from asymptotics.present.counts import many
from asymptotics.present.page import figure, page, table, text
from asymptotics.present.signs import signs
from asymptotics.running.public import public

_TEMPLATE = Path(__file__).with_name("report.html")
_HEAD = ("law", "verdict", "ΔAICc", "held-out error", "strengths [interval]", "why")
_READING = (
    "Intervals are 95 % and hold under the law of their row, with independent noise, or noise as correlated as the "
    "residuals are; certified sets hold every solution. Strengths epsilon refer to x0 = 1 unit of the data. "
    "Refuted: the data contradict the law; consistent: they do not, which is no proof of it; undetermined: neither "
    "could be shown."
)


@public
def html_report(
    answer: Identification, provenance: Mapping[str, str] | None = None, *, max_seconds: Number = 60
) -> str:
    """An identification as one page of HTML that needs no network: verdict, pictures, laws, data, provenance.

    Parameters
    ----------
    answer
        what ``identify`` has returned
    provenance
        further lines of the last section, such as the digests of the files: name -> text
    max_seconds
        the time the call may take, in s

    Returns
    -------
    str
        the page

    Raises
    ------
    InputError
        for what ``identify`` has not returned

    Examples
    --------
    >>> from asymptotics.decays.identification.identify import identified
    >>> found = identified({"n": range(9), "x": [(-0.9) ** n for n in range(9)]}, laws=["1"], bootstrap=False)
    >>> html_report(found)[:15]
    '<!DOCTYPE html>'
    """
    if not isinstance(answer, Identification):
        raise InputError("answer", f"a {type(answer).__name__}", "what identify returns")
    if provenance is not None and not isinstance(provenance, Mapping):
        raise InputError("provenance", f"a {type(provenance).__name__}", "a mapping of names to texts")
    for part in (part for line in (provenance or {}).items() for part in line):
        if not isinstance(part, str):
            raise InputError("provenance", f"{shown(part)} is no text", "a mapping of names to texts")
    names = ", ".join(run.name or "the data" for run in answer.runs)
    lines = {"program": f"power-law-oscillator {__version__}, identify", **(provenance or {})}
    lines["arithmetic"] = f"Python {platform.python_version()}, NumPy {np.__version__}, SciPy {scipy.__version__}"
    lines["made by"] = made_by_line()
    reasons = [(*(cell.replace("  ", "; ") for cell in entry.row()), entry.law.reason) for entry in answer.told_laws]
    fields = {
        "title": text(f"Which damping law? {names}"),
        "verdict": text(answer.verdict.text),
        "telling": "".join(f"<p>{text(line)}</p>" for line in (*answer.lines, answer.verdict.telling) if line),
        "equation": signs(text(answer.best.law.candidate.formula())) if answer.told_laws else "",
        "pictures": "".join(_pictures(answer)),
        "laws": table(_HEAD, reasons, "") if reasons else f"<p>None of {len(answer.laws)} was fitted.</p>",
        "reading": text(_READING),
        "textbook": _textbook(answer),
        "data": table(("run", "data"), [_told(run) for run in answer.runs], ""),
        "notes": "<ul>" + "".join(f"<li>{text(note)}</li>" for note in answer.notes) + "</ul>",
        "provenance": table(("", ""), lines.items(), ""),
    }
    return page(f"Which damping law? {names}", Template(_TEMPLATE.read_text(encoding="utf-8")).substitute(fields))


def _pictures(answer: Identification) -> Iterable[str]:
    for one in answer.per_run or (answer,):
        try:
            drawn = one.picture("svg", size=(10, 7.5), panels=True).decode()
        except InputError as error:
            yield f"<p>No picture: {text(error.reason)}.</p>"
            continue
        name = one.runs[0].name or "the data"
        yield figure(drawn, f"decay, decrement against amplitude, residuals and profiles of {name}")


def _textbook(answer: Identification) -> str:
    rows = [
        (name, ", ".join(found["alphas"]), ", ".join(found["epsilon"]), ", ".join(found["systematic_error"] or ["-"]))
        for name, found in answer.textbook.items()
    ]
    if not rows:
        return ""
    head = ("estimator", "exponents", "strengths", "systematic error")
    return "<h2>Textbook estimators</h2>" + table(head, rows, "")


def _told(run: Observations | Decrements) -> tuple[str, str]:
    name, unit = run.name or "the data", f" {run.shown_unit}" if run.shown_unit else ""
    if isinstance(run, Decrements):
        ends = f"{run.amplitude.max():.4g} to {run.amplitude.min():.4g}{unit}"
        return name, f"{many(len(run.decrement), 'decrement')}, mean amplitudes from {ends}"
    times = "with times" if run.has_times else "without times"
    return (
        name,
        f"{many(len(run.n), 'turning point')} {times}, |x| from {run.sizes[0]:.4g} to {run.sizes[-1]:.4g}{unit}",
    )
