"""The statements of the three papers with their verdicts: list them, or look one up.

asymptotics papers                           how many statements have which verdict
asymptotics papers smith2012                 all statements of one paper
asymptotics papers smith2012:43              one statement: printed form, verdict, evidence, what is true instead
asymptotics papers 43  |  papers Lambert     by number, or by words in text and formulas
asymptotics papers smith2012:43 --check      run its check again
"""

import argparse
import textwrap
from collections import Counter
from typing import Any

from asymptotics.budget import tick
from asymptotics.cli.answer import Answer, add_common, shortened
from asymptotics.cut_short import keeping
from asymptotics.errors import InputError
from asymptotics.papers.lookup import SHORTFALLS, VERDICTS, find, has_verdict, papers, statements
from asymptotics.papers.statement import PaperStatement


def configure(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("query", nargs="*", metavar="WHAT", help="a paper, an id, a number, or words")
    kinds = ", ".join(f"{name} {said}" for name, said in SHORTFALLS.items())
    parser.add_argument(
        "--verdict", choices=(*VERDICTS, *SHORTFALLS), help=f"only statements with this verdict; {kinds}"
    )
    parser.add_argument("--latex", action="store_true", help="print the formulas alone, as LaTeX")
    parser.add_argument("--check", action="store_true", help="run the checks again")
    add_common(parser)


def takes_time(options: argparse.Namespace) -> bool:
    """Only what is checked: a look-up loads nothing that computes, a clock for it included."""
    return bool(options.check)


def run(options: argparse.Namespace) -> Answer:
    """Run the command."""
    query = " ".join(options.query)
    # The name of a paper lists it; everything else is an id, a number or words, in this order.
    chosen = statements(query or None) if not query or query in papers() else _found(query)
    chosen = tuple(s for s in chosen if has_verdict(s, options.verdict))
    data: dict[str, object] = {"query": query, "entries": [s.to_dict() for s in chosen]}
    if options.check:
        return _checked(chosen, data, options.json)
    if options.latex:
        return Answer(data, "\n".join(s.corrected or s.latex for s in chosen), options.json)
    if not query and options.verdict is None:
        return Answer(data, _summary(chosen), options.json)
    return Answer(data, _in_full(chosen[0]) if len(chosen) == 1 else _listed(chosen), options.json)


def _found(query: str) -> tuple[PaperStatement, ...]:
    """What was asked for; InputError by the name that --help gives the argument."""
    try:
        return find(query)
    except InputError as error:
        raise InputError("WHAT", error.reason, error.accepted) from None


def _summary(chosen: tuple[PaperStatement, ...]) -> str:
    lines = []
    for key, reference in papers().items():
        counts = Counter(s.printed for s in chosen if s.paper == key)
        shown = ", ".join(f"{counts[v]} {v}" for v in VERDICTS if counts[v])
        kinds = Counter(s.shortfall for s in chosen if s.paper == key and s.shortfall)
        partly = ", ".join(f"{kinds[said]} {said}" for said in SHORTFALLS.values() if kinds[said])
        lines += [f"{key}: {reference}", f"  {sum(counts.values())} statements: {shown}", f"  partly: {partly}"]
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
        ("source", s.source),
    ]
    lines = [f"{s.id}: {s.title}"]
    for name, value in rows:
        if value:
            # 118 columns leave room for the marks of a terminal; a formula is never broken inside a word.
            lines += textwrap.wrap(f"{name:12}  {value}", 118, subsequent_indent=" " * 14, break_long_words=False)
    return "\n".join(lines)


def _checked(chosen: tuple[PaperStatement, ...], data: dict[str, object], as_json: bool) -> Answer:
    results: dict[str, Any] = {}
    # Some checks take long: those that are done are told when the time is over.
    with keeping(lambda: (chosen, data, results) if results else None):
        for s in chosen:
            tick(f"the check of {s.id}")
            results[s.id] = s.check()
    return _examined(data, results, as_json)


def cut_short(
    options: argparse.Namespace, done: tuple[tuple[PaperStatement, ...], dict[str, object], dict[str, Any]]
) -> Answer:
    """The checks that were done at the interrupt."""
    chosen, data, results = done
    left = chosen[len(results) :]
    return shortened(_examined(data, results, options.json), len(results), f"{len(left)} checks, {left[0].id} ...")


def _examined(data: dict[str, object], results: dict[str, Any], as_json: bool) -> Answer:
    outcomes = {key: found["outcomes"] for key, found in results.items()}
    failed = [key for key, found in results.items() if not found["agrees"]]
    shown = [
        line
        for key, found in results.items()
        for line in (
            f"{key}: " + ", ".join(f"{name} {outcome}" for name, outcome in found["outcomes"].items()),
            *([f"  near miss: {_told(found['apart'])}"] if found["apart"] else []),
        )
    ]
    last = f"disagrees: {', '.join(failed)}" if failed else "the verdicts are borne out"
    return Answer(
        {
            **data,
            "outcomes": outcomes,
            "apart": {key: found["apart"] for key, found in results.items()},
            "agrees": not failed,
        },
        "\n".join([*shown, last]),
        as_json,
        bool(failed),
    )


def _told(apart: dict[str, Any]) -> str:
    """The two sides that differ, by their values where there are any."""
    left, right = (value or side for value, side in zip(apart["values"], (apart["left"], apart["right"])))
    return f"{left} is not {apart['relation']} {right}" + (f" at {apart['where']}" if apart["where"] else "")
