"""LabVIEW measurement files (.lvm) without a column of times: the clock is X0 + n Delta_X of their header.

Such a file says ``X_Columns No``, and the first cell of each row is empty.

>>> head = ["LabVIEW Measurement", "X_Columns\\tNo", "***End_of_Header***", "X0\\t0,5", "Delta_X\\t0,25"]
>>> [line for line in with_clock([*head, "***End_of_Header***", "X_Value\\tx", "\\t1,5", "\\t1,25"])][-3:]
['X_Value\\tx', '0,5\\t1,5', '0,75\\t1,25']
"""

from collections.abc import Iterable, Iterator

FIRST = "LabVIEW Measurement"


def with_clock(lines: Iterable[str]) -> Iterator[str]:
    """The lines, with the times that the header tells in the empty first cell of each row."""
    lines = iter(lines)
    first = next(lines, None)
    if first is None:
        return
    yield first
    if not first.startswith(FIRST):
        yield from lines
        return
    said: dict[str, str] = {}
    count = 0
    for line in lines:
        separator = "," if said.get("Separator") == "Comma" else "\t"
        name, _, rest = line.partition(separator)
        if name.strip():
            # Rows of the header begin with a name; a new X0 begins a new segment, and with it the count of its rows.
            said[name.strip()] = rest.split(separator)[0].strip()
            count = 0 if name.strip() == "X0" else count
            yield line
            continue
        time = _time(said, count) if rest.strip() else None
        if time is None:
            yield line
            continue
        count += 1
        yield f"{time}{separator}{rest}"


def _time(said: dict[str, str], count: int) -> str | None:
    """The time of a row, as its file would write it; None where the header does not tell."""
    if said.get("X_Columns") != "No" or "Delta_X" not in said:
        return None
    try:
        start, step = (float(said.get(name, "0").replace(",", ".")) for name in ("X0", "Delta_X"))
    except ValueError:
        return None
    # Twelve digits: start + n step is rounded in doubles, and its last digits would look like an uneven clock.
    text = f"{start + count * step:.12g}"
    return (
        # If the header does not name the mark, that of its own step.
        text.replace(".", ",") if said.get("Decimal_Separator", "," if "," in said["Delta_X"] else ".") == "," else text
    )
