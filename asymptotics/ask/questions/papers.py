"""The statements of the three papers with their verdicts: list, look up, search."""

import textwrap
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated, Any

from asymptotics.ask.answers import Offers, Request
from asymptotics.ask.kinds import FLAG, SECONDS, Kind, choice
from asymptotics.ask.question import question
from asymptotics.errors import InputError, shown
from asymptotics.numbers.policy import Number
from asymptotics.papers.derived import DerivationRecord
from asymptotics.papers.documented import Section
from asymptotics.papers.everything import look_up
from asymptotics.papers.lookup import SHORTFALLS, VERDICTS, cited, find, has_verdict, identifiers, later, statements
from asymptotics.papers.lookup import papers as known_papers
from asymptotics.papers.statement import PaperStatement
from asymptotics.present.in_line import in_line
from asymptotics.running.budget import tick
from asymptotics.running.cut_short import keeping


def _words(value: Any, name: str) -> str:
    parts = [value] if isinstance(value, str) else value
    if not isinstance(parts, list | tuple) or not all(isinstance(part, str) for part in parts):
        raise InputError(name, f"{shown(value)} is no text", "a paper, an id, a number, or words")
    return " ".join(parts)


WHAT = Kind("WHAT", _words, place=True, several=True)


@dataclass(frozen=True)
class Looked:
    """What was found by the words, and the checks that have run: id -> outcomes."""

    query: str
    entries: tuple[PaperStatement, ...]
    outcomes: dict[str, Any] | None = None
    derivations: tuple[DerivationRecord, ...] = ()
    documentation: tuple[Section, ...] = ()

    @property
    def failed(self) -> list[str]:
        """The ids of the checks that disagree."""
        return [key for key, found in (self.outcomes or {}).items() if not found["agrees"]]

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready."""
        named = dict.fromkeys(s.paper for s in self.entries)
        papers = {key: {"reference": known_papers()[key], **identifiers()[key]} for key in named}
        data: dict[str, Any] = {"query": self.query, "papers": papers, "entries": [s.to_dict() for s in self.entries]}
        data["derivations"] = [d.to_dict() for d in self.derivations]
        data["documentation"] = [s.to_dict() for s in self.documentation]
        if self.outcomes is None:
            return data
        part = {name: {key: found[name] for key, found in self.outcomes.items()} for name in ("outcomes", "apart")}
        return {**data, **part, "agrees": not self.failed}

    def checked(self) -> str:
        """The outcome of each check, and whether all verdicts are borne out."""
        lines = []
        for key, found in (self.outcomes or {}).items():
            lines.append(f"{key}: " + ", ".join(f"{name} {outcome}" for name, outcome in found["outcomes"].items()))
            lines += [f"  near miss: {_sides(found['apart'])}"] if found["apart"] else []
        last = f"disagrees: {', '.join(self.failed)}" if self.failed else "the verdicts are borne out"
        return "\n".join([*lines, last])


def _text(found: Looked, request: Request) -> str:
    if found.outcomes is not None:
        return found.checked()
    if not found.query and request["verdict"] is None:
        return _summary(found.entries)
    own = [_in_full(found.entries[0]) if len(found.entries) == 1 else _listed(found.entries)] if found.entries else []
    proved = [f"  {d.name}  {d.title}" for d in found.derivations[:_MOST]]
    read = [f"  {section}" for section in found.documentation[:_MOST]]
    more = [["derivations (asymptotics derive NAME):", *proved]] if proved else []
    more += [["documentation:", *read]] if read else []
    return "\n\n".join([*own, *map("\n".join, more)])


def _latex(found: Looked, _: Request) -> str:
    if found.outcomes is not None:
        return found.checked()
    return "\n".join(s.corrected or s.latex for s in found.entries)


def _missing(found: Looked, _: Request) -> tuple[int, str]:
    left = found.entries[len(found.outcomes or ()) :]
    return len(found.outcomes or ()), f"{len(left)} checks, {left[0].id} ..."


def _summary(chosen: tuple[PaperStatement, ...]) -> str:
    lines = []
    for key in known_papers():
        counts = Counter(s.printed for s in chosen if s.paper == key)
        shown = ", ".join(f"{counts[v]} {v}" for v in VERDICTS if counts[v])
        kinds = Counter(s.shortfall for s in chosen if s.paper == key and s.shortfall)
        partly = ", ".join(f"{kinds[said]} {said}" for said in SHORTFALLS.values() if kinds[said])
        lines += [f"{key}: {cited(key)}", f"  {sum(counts.values())} statements: {shown}", f"  partly: {partly}"]
    return "\n".join(
        [*lines, "", "`asymptotics papers smith2012` lists one paper, `asymptotics papers Lambert` searches."]
    )


def _listed(chosen: tuple[PaperStatement, ...]) -> str:
    width = max((len(s.id) for s in chosen), default=0)
    rows = [f"{s.id:{width}}  {s.printed:13}  {s.title}" for s in chosen]
    return "\n".join([*rows, f"{len(chosen)} statements"])


def _in_full(s: PaperStatement) -> str:
    rows = [
        ("in our words" if s.paraphrase else "as printed", s.latex),
        ("verdict", f"{s.printed} ({s.kind}; {s.evidence}{', ' + s.extent if s.extent else ''})"),
        ("what is true", s.corrected),
        ("conditions", s.conditions),
        ("note", s.note),
        ("methods", "; ".join(s.methods)),
        ("near miss", s.near_miss and f"refuted by the same check: {s.near_miss}"),
        ("order", s.order),
        ("digits", s.digits),
        ("partly", s.shortfall),
        ("slip", s.slip),
        (f"line {s.line} of" if s.line else "derivation", s.derivation and f"asymptotics derive {s.derivation}"),
        ("paper", cited(s.paper)),
        ("later papers", "; ".join(later(s.id))),
        ("source", s.source),
    ]
    lines = [f"{s.id}: {s.title}"]
    for name, value in rows:
        if value:
            # 118 columns leave room for the marks of a terminal; a formula is never broken inside a word.
            lines += textwrap.wrap(f"{name:12}  {value}", 118, subsequent_indent=" " * 14, break_long_words=False)
    return "\n".join(lines)


def _sides(apart: dict[str, Any]) -> str:
    """The two sides that differ, by their values where there are any."""
    left, right = (in_line(value or side) for value, side in zip(apart["values"], (apart["left"], apart["right"])))
    place = f" at {in_line(apart['where'])}" if apart["where"] else ""
    return f"{left} is not {in_line(apart['relation'])} {right}{place}"


_MOST = 6
"""Derivations and pages that are shown under what was found; ``--json`` has all."""
_TEXT = "statements are text; `--json` has them all"
_KINDS = ", ".join(f"{name} {said}" for name, said in SHORTFALLS.items())


@question(
    Offers(
        latex="print the formulas alone, as LaTeX",
        own_latex=True,
        text=_text,
        as_latex=_latex,
        shown=lambda found, _: [*found.entries] if found.outcomes is None and found.query else [None],
        formula=lambda *_: "",
        failed=lambda found, _: bool(found.failed),
        missing=_missing,
        lacks={
            **dict.fromkeys(("csv", "plot", "points"), _TEXT),
            "digits": "each statement says how many digits its check has",
            "gauge": "each statement says itself what it is about",
        },
    ),
    alone=False,
    example="smith2012:43",
    rests="the verdict of each statement, with its evidence: proved, certified, measured",
)
def papers(
    query: Annotated[str | Sequence[str], WHAT] = "",
    *,
    verdict: Annotated[
        str | None, choice(*VERDICTS, *SHORTFALLS, letter="VERDICT").called(suffix=f"; {_KINDS}")
    ] = None,
    check: Annotated[bool, FLAG] = False,
    max_seconds: Annotated[Number, SECONDS] = 60,
) -> Looked:
    """The statements of the three papers with their verdicts: list them, or look one up.

    asymptotics papers                           how many statements have which verdict
    asymptotics papers smith2012                 all statements of one paper
    asymptotics papers smith2012:43              one statement: printed form, verdict, evidence, what is true instead
    asymptotics papers 43  |  papers Lambert     by number, or by words in text and formulas
    asymptotics papers smith2012:43 --check      run its check again

    Parameters
    ----------
    query
        a paper, an id, a number, or words
    verdict
        only statements with this verdict
    check
        run the checks again
    max_seconds
        the time the request may take, in seconds

    Raises
    ------
    InputError
        for words that no statement has, and a verdict that is none
    LimitError
        when the time is over: the checks that were done are told
    """
    text = query if isinstance(query, str) else " ".join(query)
    # The name of a paper lists it; everything else is an id, a number or words, in this order.
    if not text or text in known_papers():
        chosen = tuple(s for s in statements(text or None) if has_verdict(s, verdict))
        return Looked(text, chosen, _outcomes(text, chosen) if check else None)
    if verdict is None and not check and (found := look_up(text)) and text.strip() not in {s.id for s in statements()}:
        return Looked(text, found.statements, None, found.derivations, found.documentation)
    chosen = tuple(s for s in _found(text) if has_verdict(s, verdict))
    return Looked(text, chosen, _outcomes(text, chosen) if check else None)


def _found(query: str) -> tuple[PaperStatement, ...]:
    """What was asked for; InputError by the name of the argument."""
    try:
        return find(query)
    except InputError as error:
        raise InputError("query", error.reason, error.accepted) from None


def _outcomes(query: str, chosen: tuple[PaperStatement, ...]) -> dict[str, Any]:
    results: dict[str, Any] = {}
    # Some checks take long: those that are done are told when the time is over.
    with keeping(lambda: Looked(query, chosen, results) if results else None):
        for s in chosen:
            tick(f"the check of {s.id}")
            results[s.id] = s.check()
    return results
