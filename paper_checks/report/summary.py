"""How many statements of each paper have which verdict, as the table that the README shows."""

from collections import Counter
from collections.abc import Iterable

from paper_checks.registry import PAPERS, Entry
from paper_checks.verdict import Printed

VERDICTS = tuple(Printed)


def markdown_summary(entries: Iterable[Entry]) -> str:
    """A Markdown table: one row for each paper and one for all, one column for each verdict."""
    counts = Counter((e.statement.paper, e.printed) for e in entries)
    rows = [[key, *(counts[key, v] for v in VERDICTS)] for key in PAPERS]
    rows.append(["all", *(sum(counts[key, v] for key in PAPERS) for v in VERDICTS)])
    lines = [["paper", *VERDICTS, "statements"], ["---"] * (len(VERDICTS) + 2)]
    lines += [[*row, sum(int(n) for n in row[1:])] for row in rows]
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in lines)
