"""A comparison as lines of text: the rows, or the first and the worst of them, and what they say together."""

from asymptotics.decays.comparison.digits import right_in_words
from asymptotics.decays.comparison.order import told_order
from asymptotics.decays.comparison.run import ComparedValue, Comparison
from asymptotics.present.counts import many

# Lines that fill a screen: half from the head of the file, half the worst.
_SHOWN = 40


def comparison_text(found: Comparison, equation: str) -> str:
    """What the command prints; ``equation``: what the values are held against."""
    summary, look = found.summary, found.summary["look"]
    rows = found.rows
    if len(rows) > _SHOWN:
        # Fewest right digits first; in the order of the file when they are shown.
        worst = set(sorted(range(len(rows)), key=lambda i: float(rows[i].digits))[: _SHOWN // 2])
        rows = tuple(row for i, row in enumerate(rows) if i < _SHOWN // 2 or i in worst)
    cells = [("line", found.rows[0].key_name, "column", "given", "certified", "digits"), *map(_cells, rows)]
    widths = [max(map(len, column)) for column in zip(*cells)]
    lines = [equation, "", *("  ".join(c.rjust(w) for c, w in zip(row, widths)) for row in cells)]
    if len(rows) < len(found.rows):
        lines.append(
            f"({many(len(found.rows), 'value')}: the first {_SHOWN // 2} and the worst ones; --csv or --json for all)"
        )
    lines += [
        "",
        f"right digits: worst {summary['worst_digits']} (line {summary['worst_line']}), "
        f"median {summary['median_digits']}, best {summary['best_digits']}; "
        + right_in_words(summary["all_right"], summary["values"]),
        *([order] if (order := told_order(summary.get("order", {}))) else []),
        f"the errors look like {look['kind']}: {look['reason']}",
        *([summary["ended"]] if "ended" in summary else []),
        *summary.get("differs", ()),
        *([f"doubles, right within the errors of the header: {', '.join(d)}"] if (d := summary.get("doubles")) else []),
        *([f"estimates, not counted: lines {_listed(summary['estimates'])}"] if "estimates" in summary else []),
        *(f"{name}: told in SI" for name in summary.get("converted", ())),
        *(f"not compared: {name} ({_why(name)})" for name in summary.get("not_compared", ())),
        f"certified: {str(found.certified).lower()} ({found.method})",
    ]
    return "\n".join(lines)


def _why(name: str) -> str:
    if name in ("amplitude", "phase"):
        return "of a gauge and an order"
    return "of one force of the sum; the table has the sum" if "[" in name else "a bound, a remark or a mark"


def _listed(lines: list[int]) -> str:
    more = f" and {len(lines) - _SHOWN} more" if len(lines) > _SHOWN else ""
    return ", ".join(map(str, lines[:_SHOWN])) + more


def _cells(row: ComparedValue) -> tuple[str, ...]:
    return (str(row.line), row.key, row.column, row.marked, row.certified or "none", row.digits)
