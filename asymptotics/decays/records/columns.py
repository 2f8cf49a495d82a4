"""Which column is what: from its name, its unit, or what --columns says; where two could be meant, it is asked.

>>> read = choose(["Time (s)", "Angle (deg)", "Speed (deg/s)"], None, None, "pendulum.csv")
>>> read.places, read.kind
({'t': 0, 'x': 1}, 'record')
>>> read.note
"time: 'Time (s)'; x: 'Angle (deg)'; 1 other column not used: 'Speed (deg/s)'"
>>> choose(["t", "x", "theta"], None, None, "two.csv")
Traceback (most recent call last):
    ...
asymptotics.decays.records.columns.SeveralError: argument FILE: two.csv: x may be any of 'x', 'theta' (accepted: ...
"""

import re
from collections.abc import Sequence
from dataclasses import dataclass

from asymptotics.decays.records.error_names import errors_beside
from asymptotics.decays.records.peaks import numbers_peaks
from asymptotics.decays.records.units import ACCELERATIONS, SECONDS, SPEEDS, UNITS, suffix, without_run
from asymptotics.errors import InputError, shown

KINDS = ("record", "velocity", "acceleration", "envelope", "turning-points", "decrement")
DAMPING_TABLE = "A,zeta or A,Q or A,force (damping)"
"""The kind that is no record, as ``identification.damping_kind`` reads it."""
COLUMNS = {
    "record": ("t", "x"),
    "velocity": ("t", "v"),
    "acceleration": ("t", "a"),
    "envelope": ("t", "x"),
    "turning-points": ("n", "x"),
    "decrement": ("amplitude", "decrement"),
}
OPTIONAL = {
    "record": (),
    "velocity": (),
    "acceleration": (),
    "envelope": (),
    "turning-points": ("tau",),
    "decrement": ("resolution",),
}

_WORDS = {
    "time": "t time zeit tau temps tiempo tempo timestamp stamp zeitstempel uhrzeit datetime x_value clock elapsed "
    "seconds sekunden millis micros",
    "position": "x y z position pos displacement phi theta angle angular winkel auslenkung roll pitch elongation weg "
    "deflection distance \N{GREEK SMALL LETTER THETA} \N{GREEK SMALL LETTER THETA}r \N{GREEK SMALL LETTER PHI}",
    "velocity": "v velocity speed omega gyroscope gyro geschwindigkeit winkelgeschwindigkeit vx vy vz rate "
    "gx gy gz wx wy wz gyr \N{GREEK SMALL LETTER OMEGA}",
    "acceleration": "a acc accel acceleration accelerometer beschleunigung ax ay az",
    "n": "n index cycle cycles",
    "amplitude": "amplitude",
    "decrement": "decrement",
    "resolution": "resolution",
    "force": "force kraft torque drehmoment",
    "computed": "fit fitted residual residuals theory theoretical predicted simulated anpassung residuum",
    "uncertainty": "uncertainty uncertainties error err xerr yerr terr sigma std stddev unsicherheit fehler",
}
_MEANING = {word: quantity for quantity, words in _WORDS.items() for word in words.split()}
_NO_NAME = re.compile(r"column \d+( \[.*\])?")
_AXIS = re.compile(r"[xyz](?: .*)?", re.IGNORECASE)
"""A letter of an axis, which says nothing of what is measured along it."""
_MEASURED = {"x": "position", "v": "velocity", "a": "acceleration"}
_LAST = ("velocity", "acceleration", "time")  # "angular velocity": the word that decides


class SeveralError(InputError):
    """Several columns may be one quantity: ``column`` of the contract, and the places ``found``."""

    def __init__(self, column: str, found: Sequence[int], reason: str, accepted: str) -> None:
        super().__init__("FILE", reason, accepted)
        self.column, self.found = column, tuple(found)


@dataclass(frozen=True)
class Choice:
    """``places``: the place of each column by its name in the contract; ``note``: what was taken and what was left."""

    kind: str
    places: dict[str, int]
    note: str


def quantity(name: str) -> str:
    """What a column holds, by its words first and its unit else; empty if neither says.

    >>> [quantity(n) for n in ("Zeit t / s", "Gyroscope x (rad/s)", "angular velocity", "y (cm)", "Potential 1", "t_s")]
    ['time', 'velocity', 'velocity', 'position', '', 'time']
    >>> [quantity(n) for n in ("Time A [s]", "Pos A", "Channel A", "a", "a_x", "mass_A: t", "t_days")]
    ['time', 'position', '', 'acceleration', 'acceleration', 'time', 'time']
    >>> [quantity(n) for n in ("A (cm)", "a (m/s^2)", "A")]
    ['position', 'acceleration', 'acceleration']
    >>> [quantity(n) for n in ("gx", "gyroZ", "AccX", "millis", "position", "x_fit")]
    ['velocity', 'velocity', 'acceleration', 'time', 'position', 'computed']
    """
    if numbers_peaks(name):
        return "n"
    unit = suffix(name)
    # What stands before a colon is the run or the point that was followed.
    label = re.sub(r"[\[(][^\])]*[\])]\s*\Z", "", without_run(name)).rpartition(": ")[2]
    # Physicists write quantity/unit: what stands behind the slash is no word of the name.
    label = label.rpartition("/")[0] if re.search(r"\S\s*/\s*\S+\Z", label) and unit else label
    label = label.removesuffix("_" + unit) if unit else label
    words = [_without_axis(w) for w in re.split(r"[^\w]+|_|\d+", label.lower()) if w]
    found = [_MEANING[w] for w in words if w in _MEANING and (len(w) > 1 or _is_letter_of(w, words))]
    by_unit = _by_unit(unit)
    # Of a letter alone the unit knows better: A (cm) is no acceleration, x (m/s) no place.
    if label.strip().lower() in ("a", "v", "x", "y", "z") and by_unit in _MEASURED.values():
        return by_unit
    # A name that is one word of the list as a whole, such as x_value, is cut into no others.
    if label.lower().strip() in _MEANING:
        return _MEANING[label.lower().strip()]
    # "uncertainty t (s)" is no time, x_fit no place that was measured.
    for other in ("uncertainty", "computed"):
        if other in found:
            return other
    # Of letters alone the first decides: a_x is an acceleration, x_a none.
    if found and all(len(w) == 1 for w in words):
        return found[0]
    for decisive in _LAST:
        # A unit of length or speed overrules the word time, as in "time average (m)".
        if decisive in found and not (decisive == "time" and by_unit not in ("", "time")):
            return decisive
    return found[0] if found else by_unit


def quantities(names: Sequence[str]) -> list[str]:
    """What the columns of one table hold: some, such as ``dx``, say so only beside another.

    >>> quantities(["t", "dt", "x", "dx"]), quantities(["t", "dx"])
    (['time', 'uncertainty', 'position', 'uncertainty'], ['time', ''])
    """
    errors = errors_beside(names)
    return ["uncertainty" if i in errors else quantity(name) for i, name in enumerate(names)]


def _without_axis(word: str) -> str:
    """gyrox as gyro, accz as acc; another word as it is."""
    return word[:-1] if len(word) > 3 and word[-1] in "xyz" and word[:-1] in _MEANING else word


def _is_letter_of(letter: str, words: Sequence[str]) -> bool:
    """Whether a letter is the symbol of a quantity: behind a word, as in "Pos A" or "channel a", it is a label."""
    beside = [w for w in words if len(w) > 1]
    return not beside or letter == words[0] or (letter not in "avnt" and not any(w in _MEANING for w in beside))


def _by_unit(unit: str) -> str:
    if unit in SECONDS:
        return "time"
    if unit in UNITS:
        return "position"
    return "velocity" if unit in SPEEDS else "acceleration" if unit in ACCELERATIONS else ""


def choose(names: Sequence[str], columns: str | None, kind: str | None, file: str) -> Choice:
    """The columns of a file with these names; InputError, with the option that says it, where they are not clear."""
    given = _given(names, columns) if columns is not None else {}
    found = kind or _kind_of(names, given, file)
    wanted, optional = COLUMNS[found], OPTIONAL[found]
    # What is said stands; the rest is found among the columns that are left.
    places = dict(given)
    for column in (*wanted, *optional):
        if column in places:
            continue
        place = _place_of(column, names, list(places.values()), found, file, column in wanted, told=kind is not None)
        if place is not None:
            places[column] = place
    extra = set(places) - {*wanted, *optional}
    if extra:
        raise InputError("columns", f"{', '.join(sorted(extra))} is no column of the kind {found}", accepted(found))
    places = {column: places[column] for column in (*wanted, *optional) if column in places}
    _require_what_it_says(names, places, found, kind, file, columns)
    return Choice(found, places, _note(names, places))


def accepted(kind: str) -> str:
    """The columns of a kind, as they are told: ``n,x[,tau]``."""
    return ",".join(COLUMNS[kind]) + "".join(f"[,{c}]" for c in OPTIONAL[kind])


def _given(names: Sequence[str], columns: str) -> dict[str, int]:
    """Quantity -> place from ``t=Time (s),x=3``; a number is a place, counted from 1."""
    known = sorted({c for kind in KINDS for c in (*COLUMNS[kind], *OPTIONAL[kind])})
    # A name may hold commas itself: a piece ends only where another quantity and a sign of equality follow.
    pieces = re.split(rf",\s*(?=(?:{'|'.join(known)})\s*=)", columns) if isinstance(columns, str) else []
    found: dict[str, int] = {}
    for piece in pieces:
        key, sign, name = (part.strip() for part in piece.partition("="))
        if not sign or key not in known or key in found:
            raise InputError("columns", f"{shown(piece)} is not clear", f"t=NAME,x=NAME with {', '.join(known)}")
        # The name as it stands, else without its unit, else its place.
        matches = [i for i, n in enumerate(names) if n == name] or [
            i for i, n in enumerate(names) if re.sub(r"\s*[\[(].*", "", n).strip().lower() == name.lower()
        ]
        if not matches and name.isdecimal() and 1 <= int(name) <= len(names):
            matches = [int(name) - 1]
        if len(matches) != 1:
            reason = f"{len(matches) or 'no'} columns have the name {name[:40]!r}"
            raise InputError("columns", reason, f"one of: {', '.join(names)[:200]}; or its place from 1")
        found[key] = matches[0]
    if not found or len(set(found.values())) < len(found):
        raise InputError("columns", f"{shown(columns)} is not clear", "t=NAME,x=NAME, each column once")
    return found


def _kind_of(names: Sequence[str], given: dict[str, int], file: str) -> str:
    meant = quantities(names)
    # x alone, which two kinds have, leaves the kind to the other columns, where they say it.
    if set(given) == {"x"} and "time" in meant and "n" not in meant:
        return "record"
    if given:
        # The first kind to which all that is said belongs: x is that of turning points unless t is said as well.
        for kind in ("decrement", "turning-points", "velocity", "acceleration", "record"):
            if set(given) <= {*COLUMNS[kind], *OPTIONAL[kind]} and COLUMNS[kind][1] in given:
                return kind
    if len(names) > 1:
        # A phone writes the axes of each of its sensors as x, y, z into a file of its own.
        bare = [n for n, q in zip(names, meant) if q == "position"]
        sensor = quantity(re.sub(r"\.\w+\Z", "", file)) if len(bare) > 2 and all(map(_AXIS.fullmatch, bare)) else ""
        if "time" in meant and sensor in ("velocity", "acceleration"):
            return sensor
        if len(bare) > 2 and "seconds_elapsed" in names:
            reason = f"{file}: x, y, z of a phone may be those of any of its sensors"
            raise InputError("FILE", reason, "--kind velocity (a gyroscope), --kind acceleration, --kind record")
        if {"amplitude", "decrement"} <= set(meant):
            return "decrement"
        if "n" in meant:
            return "turning-points"
        if "time" in meant:
            # A column that says nothing may be the position; only where there is none is a velocity the motion itself.
            has_x = bool({"position", "computed", ""} & {*meant})
            derived = [kind for kind in ("velocity", "acceleration") if kind in meant]
            return derived[0] if not has_x and derived else "record"
    live = [name for name in names if name]
    what = f"{len(live)} column" + ("" if len(live) == 1 else "s")
    asked = ", or ".join([*(f"{accepted(kind)} ({kind})" for kind in KINDS), DAMPING_TABLE])
    asked += "; or say with --columns t=1,x=2 or --kind what they are" if len(names) > 1 else ""
    reason = f"{file}, row 1: {what} ({', '.join(live[:5])[:60]}): what is measured is not clear"
    raise InputError("FILE", reason, asked)


_MEANT = {"t": "time", "tau": "time", "x": "position", "v": "velocity", "a": "acceleration"}


def _place_of(
    column: str, names: Sequence[str], used: list[int], kind: str, file: str, needed: bool, *, told: bool
) -> int | None:
    """The only column that can be meant; None if an optional one is not there; InputError where it must be asked.

    ``told``: whether the kind was said, which knows better than a name.
    """
    # A file without names: its columns stand in the order of the contract, if there are no more of them.
    live = [i for i, n in enumerate(names) if n]
    if all(_NO_NAME.fullmatch(names[i]) for i in live):
        order = (*COLUMNS[kind], *OPTIONAL[kind])
        if len(live) <= len(order) and (order.index(column) < len(live) or not needed):
            return live[order.index(column)] if order.index(column) < len(live) else None
    free = [i for i in range(len(names)) if i not in used and names[i]]
    meant, said = _MEANT.get(column, column), quantities(names)
    found = [i for i in free if said[i] == meant]
    # No column says what is wanted: any that does not say something else may be meant, a force where there is no other.
    if not found and column in _MEASURED:
        other = {"time", "n", "uncertainty", "force", *_MEASURED.values()} - {_MEASURED[column]}
        found = [i for i in free if said[i] not in other] or [i for i in free if said[i] == "force"]
    # An axis of a sensor, or where the kind is said any name without a unit.
    if not found and column in _MEASURED:
        bare = [i for i in free if not suffix(names[i]) and said[i] not in ("time", "n", "uncertainty")]
        found = [i for i in bare if _AXIS.fullmatch(names[i]) and column != "x"] or (bare if told else [])
    # One of two columns is taken, so that the other has to be x.
    if column == "x" and not found and len(free) == 1 and len(names) == 2:
        found = free
    if len(found) == 1 or (found and not needed):
        return found[0]
    if not needed:
        return None
    if found:
        listed = ", ".join(repr(names[i][:30]) for i in found[:8])
        example = ",".join(f"{c}={i + 1}" for c, i in zip(COLUMNS[kind], _example(column, names, used, found, kind)))
        raise SeveralError(
            column, found, f"{file}: {column} may be any of {listed}", f"--columns {example} (places from 1)"
        )
    reason = f"{file} has no column {column} among {', '.join(names)[:100]}"
    raise InputError("FILE", reason, f"columns {accepted(kind)}, or --columns to say which is what")


def _example(column: str, names: Sequence[str], used: list[int], found: list[int], kind: str) -> list[int]:
    """Places that answer the question whole: of a time, the first column that may be measured beside it."""
    places = [*used, found[0]]
    if column == COLUMNS[kind][0] and len(COLUMNS[kind]) > 1:
        meant, said = _MEANT.get(COLUMNS[kind][1], ""), quantities(names)
        places += [i for i in range(len(names)) if i not in places and said[i] in (meant, "")][:1]
    return places


def _require_what_it_says(
    names: Sequence[str], places: dict[str, int], found: str, kind: str | None, file: str, columns: str | None
) -> None:
    """A column whose name or unit says another quantity is not taken for x in silence."""
    for column in _MEASURED:
        if column not in places:
            continue
        name = names[places[column]]
        said = {quantity(name), _by_unit(suffix(name))} - {"", "amplitude"}
        # Asked only where nothing was said: --kind and --columns know better than a name.
        wrong = said - {_MEANT[column]}
        # Beside a count of swings A is an amplitude, whose unit is a length's or an angle's.
        if found == "turning-points" and re.match(r"A\b", name):
            wrong -= {"acceleration"} - {_by_unit(suffix(name))}
        if wrong and kind is None and columns is None and wrong & {"velocity", "acceleration", "position", "time"}:
            reason = (
                f"{file}, row 1, column {name}: it seems to hold {_article(sorted(wrong)[0])}, not a {_MEANT[column]}"
            )
            kinds = "--kind velocity, --kind acceleration, --kind record"
            raise InputError("FILE", reason, f"{kinds}, or --columns t=1,x=2 to say what it is")


def _article(word: str) -> str:
    return f"an {word}" if word[0] in "aeiou" else f"a {word}"


def _note(names: Sequence[str], places: dict[str, int]) -> str:
    taken = [f"{'time' if c in ('t', 'tau') else c}: {names[i]!r}" for c, i in places.items()]
    # Of columns of errors it is told later whether they are used.
    errors = [i for i, q in enumerate(quantities(names)) if q == "uncertainty"]
    left = [n for i, n in enumerate(names) if i not in places.values() and i not in errors and n]
    if left:
        many = "1 other column" if len(left) == 1 else f"{len(left)} other columns"
        taken.append(f"{many} not used: " + ", ".join(repr(n) for n in left[:4]) + (", ..." if len(left) > 4 else ""))
    return "; ".join(taken)
