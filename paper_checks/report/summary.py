"""How many statements of each paper have which verdict, as the table that the README shows."""

from collections import Counter
from collections.abc import Iterable

from paper_checks.registry import PAPERS, Entry, Shortfall
from paper_checks.verdict import Printed

NAMES = {Shortfall.CONDITION: "partly: omitted condition", Shortfall.CONSEQUENCE: "partly: does not follow",
         Shortfall.RANGE: "partly: false in a range"}  # fmt: skip
COLUMNS = {verdict: (NAMES if verdict == Printed.PARTLY else {None: str(verdict)}) for verdict in Printed}


def markdown_summary(entries: Iterable[Entry]) -> str:
    """A Markdown table: one row for each paper and one for all, one column for each verdict, three for partly."""
    counts = Counter((e.statement.paper, e.printed, e.statement.shortfall) for e in entries)
    keys = [(verdict, kind) for verdict, kinds in COLUMNS.items() for kind in kinds]
    rows = [[key, *(counts[key, *column] for column in keys)] for key in PAPERS]
    rows.append(["all", *(sum(counts[key, *column] for key in PAPERS) for column in keys)])
    names = [name for kinds in COLUMNS.values() for name in kinds.values()]
    lines = [["paper", *names, "statements"], ["---"] * (len(names) + 2)]
    lines += [[*row, sum(int(n) for n in row[1:])] for row in rows]
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in lines)
