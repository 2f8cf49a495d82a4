"""Lines of instruments that hide their clock, rewritten so that every row begins with its time.

A Rigol oscilloscope numbers its rows and says the first time and the step above them; the serial monitor of a small
computer writes ``11:59:50.020 -> 512``.

>>> list(with_times(["X,CH1,Start,Increment,", "Sequence,Volt,-1.5e+01,2e-02", "0,2.5,,", "1,2.25,,"]))
['# X,CH1,Start,Increment,', 'Time (s),CH1 [Volt]', '-15,2.5', '-14.98,2.25']
>>> list(with_times(["11:59:50.020 -> 512", "11:59:50.040 -> 498,3"]))
['11:59:50.020,512', '11:59:50.040,498,3']
"""

import re
from collections.abc import Iterable, Iterator
from itertools import chain

_RIGOL = re.compile(r"X,(?P<channels>.+),Start,Increment,?\s*")
_SERIAL = re.compile(r"(?P<clock>\d{1,2}:\d\d:\d\d\.\d{3}) -> ?(?P<rest>.*)")
_SEPARATORS = ("\t", ";", ",")


def with_times(lines: Iterable[str]) -> Iterator[str]:
    """The lines, rewritten where the first of them are those of such an instrument; as many as before."""
    lines = iter(lines)
    first = next(lines, None)
    if first is None:
        return
    rigol = _RIGOL.fullmatch(first.lstrip("\ufeff"))
    if rigol is None:
        for line in chain([first], lines):
            found = _SERIAL.fullmatch(line)
            yield _beside(found["clock"], found["rest"]) if found else line
        return
    second = next(lines, "")
    channels = rigol["channels"].split(",")
    clock = _clock(second.split(","), len(channels))
    if clock is None:
        yield from chain([first, second], lines)
        return
    units = second.split(",")[1:]
    yield f"# {first}"
    yield ",".join(["Time (s)", *(f"{name} [{unit}]" for name, unit in zip(channels, units))])
    start, step = clock
    for line in lines:
        cells = line.split(",")
        # The number of the row stands in it: rows that were cut out leave a gap in the times.
        numbered = len(cells) > len(channels) and cells[0].strip().isdecimal()
        # Twelve digits: start + n step is rounded in doubles, and its last digits would look like an uneven clock.
        times = [f"{start + int(cells[0]) * step:.12g}"] if numbered else cells[:1]
        yield ",".join([*times, *cells[1 : len(channels) + 1]])


def _clock(cells: list[str], channels: int) -> tuple[float, float] | None:
    """The first time and the step, behind the units of the channels."""
    try:
        start, step = map(float, cells[channels + 1 : channels + 3])
    except ValueError:
        return None
    return (start, step) if step > 0 else None


def _beside(clock: str, rest: str) -> str:
    separator = next((s for s in _SEPARATORS if s in rest), " " if " " in rest.strip() else ",")
    return f"{clock}{separator}{rest.strip()}"
