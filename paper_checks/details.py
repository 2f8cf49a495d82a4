"""One statement in words: as printed, what is true, its check and near miss, its derivation, how long it took."""

import inspect
import textwrap

from paper_checks.registry import Entry, Statement

CHANGED = "what is printed or its forms are not those that were compared: compare them, then --compared"


def in_words(entry: Entry) -> str:
    """The whole entry as text for a terminal."""
    s = entry.statement
    outcomes = ", ".join(f"{name}: {outcome}" for name, outcome in entry.outcomes.items())
    rows = [
        ("in our words" if s.paraphrase else "as printed", s.latex),
        ("verdict", f"{entry.printed} ({s.kind}, {entry.evidence})"),
        ("changed", None if entry.compared else CHANGED),
        ("partly", s.shortfall),
        ("slip", s.slip),
        ("what is true", s.corrected_latex),
        ("conditions", s.conditions),
        ("note", s.note),
        ("methods", "; ".join(s.methods)),
        ("order", s.order and f"{s.order} ({entry.order_by})"),
        ("digits", s.digits),
        ("outcomes", outcomes),
        ("near miss", None if s.near_miss is None else textwrap.shorten(str(s.near_miss), 300)),
        (_linked(entry), s.derivation and _derivation(s)),
        ("seconds", f"{entry.seconds:.2f}"),
    ]
    width = max(len(name) for name, _ in rows)
    lines = [f"{s.id}: {s.title}", *(f"{name:{width}}  {value}" for name, value in rows if value)]
    return "\n".join([*lines, "", *_source(entry)])


def _linked(entry: Entry) -> str:
    if entry.statement.line is None:
        return "derivation"
    return "proved by" if entry.derived else "truth at"


def _derivation(s: Statement) -> str:
    return (f"line {s.line} of " if s.line else "") + f"python -m derivations {s.derivation}"


def _source(entry: Entry) -> list[str]:
    """The code of the check, without the data above it."""
    check = entry.statement.check
    if check is None:
        return ["no check: a definition"]
    source = inspect.getsource(check)
    return ["check:", textwrap.indent(source[source.index("def ") :].rstrip(), "  ")]
