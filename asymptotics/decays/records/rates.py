"""The clock of samples without times: a rate that the lines above the numbers say, or --rate.

>>> rate_in(["gain: 3", "Sample rate [Hz]: 250"]), rate_in(["start, sample_rate, duration", "90, 1000, 5"])
(250.0, 1000.0)
>>> rate_in(["dt = 4 ms"]), rate_in(["sampling interval (s);0,02"]), rate_in(["Frequency [Hz]: 151234.5"])
(250.0, 50.0, None)
>>> rate_in(["fs_hz = 100.0"]), rate_in(["video, 240 fps"]), rate_in(["1000 samples per second"])
(100.0, 240.0, 1000.0)
"""

import re
from collections.abc import Sequence

from asymptotics.decays.records.cells import number
from asymptotics.decays.records.units import SECONDS

HERTZ = {"": 1.0, "hz": 1.0, "1/s": 1.0, "khz": 1e3, "mhz": 1e6, "sps": 1.0, "samples/s": 1.0}
_RATE = r"sampl\w*[ _-]*(?:rate|freq\w*)|(?:data|frame)[ _-]*rate|abtastrate|fps|fs"
_STEP = r"sampl\w*[ _-]*(?:interval|period|time)|time[ _-]*step|abtastintervall|delta[ _]?[tx]|dt"
_SAID = re.compile(
    rf"(?:\b|_)(?:(?P<rate>{_RATE})|(?P<step>{_STEP}))(?:\b|(?=_))\s*[\[(_]?(?P<unit>[\w/]*)[\])]?\s*[:=,;\t ]\s*"
    r"(?P<value>[+-]?[\d.,]+(?:[eE][+-]?\d+)?)\s*(?P<after>[\w/]*)",
    re.IGNORECASE,
)
_COUNTED = re.compile(
    r"(?<![\d.,])(?P<value>\d+(?:\.\d+)?)\s*(?:fps|sps|(?:samples|frames)\s*(?:per|/|a)\s*s(?:ec(?:ond)?)?)\b",
    re.IGNORECASE,
)
_NAME = re.compile(rf"\W*(?:(?P<rate>{_RATE})|(?P<step>{_STEP}))\s*(?:[\[(](?P<unit>[\w/]*)[\])])?\W*", re.IGNORECASE)


def rate_in(lines: Sequence[str]) -> float | None:
    """Samples a second, as ``name: value``, as so many a second or as a row of names above a row of values; None where
    nothing says it."""
    for place, line in enumerate(lines):
        if found := _SAID.search(line):
            rate = _rate(found["value"], found["unit"] or found["after"], step=found["step"] is not None)
            if rate is not None:
                return rate
        if (counted := _COUNTED.search(line)) and (rate := _rate(counted["value"], "", step=False)):
            return rate
        for separator in ("\t", ";", ","):
            names, values = line.split(separator), "".join(lines[place + 1 : place + 2]).split(separator)
            for name, value in zip(names, values) if len(names) == len(values) else ():
                if (at := _NAME.fullmatch(name)) and (rate := _rate(value, at["unit"], step=at["step"] is not None)):
                    return rate
    return None


def _rate(text: str, unit: str | None, *, step: bool) -> float | None:
    text = text.strip(" ,;")
    # 1,000 may be one or a thousand: it is asked for.
    value = None if re.fullmatch(r"[1-9]\d{0,2},\d{3}", text) else number(text, ".") or number(text, ",")
    sizes = SECONDS if step else HERTZ
    size = sizes.get((unit or ("s" if step else "")).lower())
    if not value or not value > 0 or size is None:
        return None
    return 1 / (value * size) if step else value * size
